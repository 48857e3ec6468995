//! Whether a triangle and a box touch or overlap: by drawing both together a little.

use dashu_int::IBig;
use dashu_int::ops::BitTest;

use super::case::Case;
use super::flat::Truth;
use super::lattice::{Lattice, Shapes};
use super::sample::Sample;

/// How the two lie to each other.
pub fn truth<S: Sample>(case: &Case<S>) -> Truth {
    match Lattice::new(case) {
        Lattice::Narrow(shapes) => truth_of(shapes.big()),
        Lattice::Wide(shapes) => truth_of(shapes),
    }
}

/// The same of a triangle and a box in whole numbers: their interiors meet if both may shrink a
/// little and still meet. Whether they meet is a matter of signs of whole numbers of degree 3,
/// which shrinking by one in 2^bits changes by less than one half.
pub(crate) fn truth_of(shapes: Shapes<IBig>) -> Truth {
    let longest = shapes.all().map(BitTest::bit_len).max().unwrap_or(0);
    let shrunk = Lattice::Wide(shrunk(&shapes, 3 * longest + 32));
    if !Lattice::Wide(shapes).meets() {
        Truth::Apart
    } else if shrunk.meets() {
        Truth::Overlapping
    } else {
        Truth::Touching
    }
}

/// Each drawn together about its middle by one in 2^`bits`. All in units of a sixth of that, from
/// the least corner of the box as it is then.
fn shrunk(shapes: &Shapes<IBig>, bits: usize) -> Shapes<IBig> {
    let less = ((IBig::ONE << bits) - IBig::ONE) * IBig::from(6);
    let x = &shapes.extent;
    let sum = |i: usize| -> IBig { shapes.vertices.iter().map(|v| &v[i]).sum() };
    let vertices = shapes.vertices.each_ref().map(|v| {
        [0, 1, 2].map(|i: usize| sum(i) * IBig::from(2) + &v[i] * &less - &x[i] * IBig::from(3))
    });
    Shapes { vertices, extent: [0, 1, 2].map(|i: usize| &x[i] * &less) }
}
