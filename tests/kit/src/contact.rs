//! Whether a triangle and a box touch or overlap: by drawing both together a little.

use dashu_int::IBig;

use super::case::Case;
use super::flat::Truth;
use super::lattice::{Lattice, Shapes};
use super::sample::Sample;

/// By what each shrinks about its middle: one in 2^this.
const BITS: usize = 128;

/// How the two lie to each other, for numbers of a few bits: their interiors meet if both may
/// shrink a little and still meet.
pub fn truth<S: Sample>(case: &Case<S>) -> Truth {
    let shapes = match Lattice::new(case) {
        Lattice::Narrow(shapes) => shapes.big(),
        Lattice::Wide(shapes) => shapes,
    };
    let shrunk = Lattice::Wide(shrunk(&shapes));
    if !Lattice::Wide(shapes).meets() {
        Truth::Apart
    } else if shrunk.meets() {
        Truth::Overlapping
    } else {
        Truth::Touching
    }
}

/// All in units of a sixth of one in 2^BITS, from the least corner of the box as it is then.
fn shrunk(shapes: &Shapes<IBig>) -> Shapes<IBig> {
    let less = ((IBig::ONE << BITS) - IBig::ONE) * IBig::from(6);
    let x = &shapes.extent;
    let sum = |i: usize| -> IBig { shapes.vertices.iter().map(|v| &v[i]).sum() };
    let vertices = shapes.vertices.each_ref().map(|v| {
        [0, 1, 2].map(|i: usize| sum(i) * IBig::from(2) + &v[i] * &less - &x[i] * IBig::from(3))
    });
    Shapes { vertices, extent: [0, 1, 2].map(|i: usize| &x[i] * &less) }
}
