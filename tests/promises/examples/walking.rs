//! The capsule of `lockstep` walks stairs and the teapot: no riser blocks it, it falls through
//! nothing, and its places have the hashes that all machines have.

mod program {
    pub(crate) type Line = (heapless::String<120>, bool);
}
use super::teapot;

#[path = "../../../examples/lockstep/walker.rs"]
mod walker;
#[path = "../../../examples/lockstep/walks.rs"]
mod walks;

#[test]
fn a_capsule_walks_stairs_and_the_teapot() {
    for k in 0..2 {
        let (text, is_right) = walks::line(k);
        assert!(is_right, "{text}");
    }
}
