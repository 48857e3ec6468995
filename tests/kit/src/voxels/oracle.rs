//! The voxels that a triangle marks. The oracle clips the triangle, where the crate computes ends
//! of intervals.

use dashu_int::IBig;
use septum::voxel::{Grid, Rule};

use crate::exact::{Parts, least_exponent, whole};
use crate::lattice::Ring;
use crate::oracle::remains;
use crate::{Each, Sample, odd_mantissa, three};

/// A triangle among the planes of a grid.
pub(super) enum Marks {
    /// All below 2^38: see [`Lattice::Narrow`](crate::Lattice::Narrow).
    Narrow(Whole<i128>),
    /// Of any size.
    Wide(Whole<IBig>),
}

/// In integers, relative to the least planes.
pub(super) struct Whole<I> {
    vertices: [[I; 3]; 3],
    planes: [Vec<I>; 3],
}

/// The planes of a grid: the faces of its voxels.
pub(super) fn planes<S: Sample>(grid: &Grid<S>) -> [Vec<S>; 3] {
    three(|axis| {
        let corners = |k: u32| {
            let mut index = [0; 3];
            index[axis] = k;
            let (min, max) = grid.voxel(index).and_then(|v| v.min_max()).expect("a voxel");
            [min, max].each(|corner| corner.to_array()[axis])
        };
        let count = grid.resolution()[axis];
        let greatest = corners(count - 1)[1];
        (0..count).map(|k| corners(k)[0]).chain([greatest]).collect()
    })
}

impl Marks {
    /// The triangle among the planes.
    pub(super) fn new<S: Sample>(vertices: &[[S; 3]; 3], planes: &[Vec<S>; 3]) -> Self {
        let parts = |x: S| -> Parts { odd_mantissa(x).unwrap_or((0, 0)) };
        let vertices = vertices.each(|v| v.each(parts));
        let planes = [0, 1, 2]
            .each(|i: usize| -> Vec<Parts> { planes[i].iter().map(|&x| parts(x)).collect() });
        let unit = least_exponent(vertices.iter().flatten().chain(planes.iter().flatten()));
        let all = Whole::<IBig> {
            vertices: vertices.each(|v| three(|i: usize| from(v[i], planes[i][0], unit))),
            planes: [0, 1, 2]
                .each(|i: usize| planes[i].iter().map(|&x| from(x, planes[i][0], unit)).collect()),
        };
        let narrow = |x: &IBig| i128::try_from(x).ok().filter(|x| x.unsigned_abs() >> 38 == 0);
        let vertices = all.vertices.each_ref().each(|v| v.each_ref().each(narrow));
        let planes: Option<Vec<Vec<i128>>> =
            all.planes.iter().map(|p| p.iter().map(narrow).collect()).collect();
        match (
            planes.and_then(|p| p.try_into().ok()),
            vertices.iter().flatten().all(Option::is_some),
        ) {
            (Some(planes), true) => {
                let vertices = vertices.each(|v| v.each(Option::unwrap_or_default));
                Self::Narrow(Whole { vertices, planes })
            }
            _ => Self::Wide(all),
        }
    }

    /// Whether the voxel is marked.
    pub(super) fn has(&self, voxel: [u32; 3], rule: Rule) -> bool {
        match self {
            Self::Narrow(whole) => whole.has(voxel, rule),
            Self::Wide(whole) => whole.has(voxel, rule),
        }
    }
}

/// x less `start`, in units of 2^unit.
fn from(x: Parts, start: Parts, unit: i32) -> IBig {
    whole(x, unit) - whole(start, unit)
}

impl<I: Ring> Whole<I> {
    fn has(&self, voxel: [u32; 3], rule: Rule) -> bool {
        let plane = |i: usize, k: u32| &self.planes[i][k as usize];
        let above = |i: usize, x: &I| self.vertices.each_ref().each(|v| v[i].minus(x));
        let below = |i: usize, x: &I| self.vertices.each_ref().each(|v| x.minus(&v[i]));
        let least = three(|i: usize| above(i, plane(i, voxel[i])));
        let greatest = three(|i: usize| below(i, plane(i, voxel[i] + 1)));
        let misses = |form: &[I; 3]| form.iter().all(|x| x.sign() < 0);
        if least.iter().chain(&greatest).any(misses) {
            return false;
        }
        match rule {
            Rule::Closed => remains(&[least, greatest].concat(), &[]),
            Rule::HalfOpen => remains(&least, &greatest),
            // Between two planes the middle is half their sum; all numbers are doubled.
            Rule::Thin => (0..3).any(|axis| {
                let across = [(axis + 1) % 3, (axis + 2) % 3];
                let sides = across.each(|i: usize| {
                    let above: [I; 3] = std::array::from_fn(|k| least[i][k].minus(&greatest[i][k]));
                    let below: [I; 3] = std::array::from_fn(|k| greatest[i][k].minus(&least[i][k]));
                    [above, below]
                });
                let [a, b] = sides;
                remains(
                    &[vec![least[axis].clone()], a.into(), b.into()].concat(),
                    &greatest[axis..=axis],
                )
            }),
            _ => unreachable!("a rule without an oracle"),
        }
    }
}
