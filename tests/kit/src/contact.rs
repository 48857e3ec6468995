//! Whether a triangle and a box touch or overlap: an oracle that shrinks both a little.

use crate::{Each, three};
use dashu_int::IBig;
use dashu_int::ops::BitTest;

use super::case::Case;
use super::flat::Truth;
use super::lattice::{Lattice, Shapes};
use super::sample::Sample;

/// The relation of the two shapes.
pub fn truth<S: Sample>(case: &Case<S>) -> Truth {
    match Lattice::new(case) {
        Lattice::Narrow(shapes) => truth_of(shapes.big()),
        Lattice::Wide(shapes) => truth_of(shapes),
    }
}

/// The relation of a triangle and a box in integers: their interiors meet if both still meet after
/// shrinking a little. The verdict depends on signs of integers of degree 3, which a relative
/// change of 2^−bits changes by less than one half.
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

/// Both shapes, shrunk about their centres by a factor of 1 − 2^−`bits`, in units of a sixth of
/// 2^−`bits`, from the least corner of the shrunk box.
fn shrunk(shapes: &Shapes<IBig>, bits: usize) -> Shapes<IBig> {
    let less = ((IBig::ONE << bits) - IBig::ONE) * IBig::from(6);
    let x = &shapes.extent;
    let sum = |i: usize| -> IBig { shapes.vertices.iter().map(|v| &v[i]).sum() };
    let vertices = shapes
        .vertices
        .each_ref()
        .each(|v| three(|i: usize| sum(i) * IBig::from(2) + &v[i] * &less - &x[i] * IBig::from(3)));
    Shapes { vertices, extent: three(|i: usize| &x[i] * &less) }
}
