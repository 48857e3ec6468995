//! Set (i): both sides of a flip of the exact verdict.

use super::case::Case;
use super::oracle::meets;
use super::rng::Rng;
use super::sample::Sample;

/// Moves one coordinate of one vertex until the verdict flips, then bisects to two adjacent values
/// with different verdicts. `None` if it never flips.
pub fn flip<S: Sample>(rng: &mut Rng, base: Case<S>) -> Option<[Case<S>; 2]> {
    let number = rng.below(9);
    let other = S::nearest(rng.real(-3.0, 3.0));
    let at = |x: S| base.with_number(number, x).expect("a vertex may be anywhere");
    let (mut here, mut there) = (base.numbers()[number], other);
    let verdict = meets(&at(here));
    if meets(&at(there)) == verdict {
        return None;
    }
    while here.ordinal().abs_diff(there.ordinal()) > 1 {
        let middle = here.between(there);
        if meets(&at(middle)) == verdict {
            here = middle;
        } else {
            there = middle;
        }
    }
    Some([at(here), at(there)])
}
