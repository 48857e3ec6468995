//! The answers to a fixed stream of questions, hashed: the same bits on every
//! machine, in every build, in every version.
//!
//! `cargo run --release --example determinism` computes the same hashes, and does
//! so on machines where tests cannot run.

#[path = "../examples/determinism/draw.rs"]
mod draw;
#[path = "../examples/determinism/golden.rs"]
mod golden;
#[path = "../examples/determinism/stream.rs"]
mod stream;

#[test]
fn the_hashes_are_what_they_were() {
    for golden in golden::GOLDEN {
        let hash = (golden.compute)();
        assert_eq!(hash, golden.expected, "{}: {hash:#018x}", golden.name);
    }
}
