//! One ray against eight boxes at once.

use septum::lanes::{Aabbs, Ranges};
use septum::published::slabs::SlabRay;
use septum::{Aabb, Ray, Scalar};

use crate::candidate::{Candidate, Course, Promise};
use crate::pairs::Answer;

const N: usize = 8;

#[inline(never)]
fn slabs_t_range<S: Scalar>(r: &SlabRay<S>, b: &Aabbs<S, N>) -> Ranges<S, N> {
    b.t_range_rounded(r)
}

/// The methods for many boxes at once, in one scalar.
pub fn lanes<S: Scalar>(by_corners: &Course<Ray<S>, Aabb<S>>) -> Vec<Candidate> {
    let block = |boxes: &[Aabb<S>; N]| Aabbs::new(boxes).expect("made of corners");
    let slabs = by_corners.prepared("corners, 8 at once", |p| p.blocks().map(SlabRay::new, block));
    vec![slabs.candidate("slabs, rounded t_range", Promise::Nothing, slabs_t_range)]
}

impl<S: Scalar> Answer for Ranges<S, N> {
    fn count(&self) -> usize {
        self.mask.iter().map(|m| usize::from(*m)).sum()
    }

    fn tell(&self, verdicts: &mut Vec<bool>) {
        verdicts.extend(self.mask);
    }
}
