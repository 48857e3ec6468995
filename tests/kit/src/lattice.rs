//! A case in integers: every coordinate as a multiple of one power of two, relative to the box's
//! least corner.

use crate::{Each, three};
use dashu_int::IBig;

use super::case::{BoxNumbers, Case};
use super::exact::Parts;
use super::sample::Sample;

/// Integers that are added and multiplied without overflow.
pub trait Ring: Clone {
    fn from_bit(bit: bool) -> Self;
    fn plus(&self, other: &Self) -> Self;
    fn minus(&self, other: &Self) -> Self;
    fn times(&self, other: &Self) -> Self;
    /// −1, 0 or 1.
    fn sign(&self) -> i32;
    fn big(&self) -> IBig;

    fn dot(a: &[Self; 3], b: &[Self; 3]) -> Self {
        a[0].times(&b[0]).plus(&a[1].times(&b[1])).plus(&a[2].times(&b[2]))
    }
    fn cross(a: &[Self; 3], b: &[Self; 3]) -> [Self; 3] {
        [(1, 2), (2, 0), (0, 1)].each(|(j, k)| a[j].times(&b[k]).minus(&a[k].times(&b[j])))
    }
    fn difference(a: &[Self; 3], b: &[Self; 3]) -> [Self; 3] {
        core::array::from_fn(|i| a[i].minus(&b[i]))
    }
}

/// For magnitudes below 2^125, which the callers guarantee.
impl Ring for i128 {
    fn from_bit(bit: bool) -> Self {
        bit.into()
    }
    fn plus(&self, other: &Self) -> Self {
        self + other
    }
    fn minus(&self, other: &Self) -> Self {
        self - other
    }
    fn times(&self, other: &Self) -> Self {
        self * other
    }
    fn sign(&self) -> i32 {
        self.signum() as i32
    }
    fn big(&self) -> IBig {
        (*self).into()
    }
}

impl Ring for IBig {
    fn from_bit(bit: bool) -> Self {
        u8::from(bit).into()
    }
    fn plus(&self, other: &Self) -> Self {
        self + other
    }
    fn minus(&self, other: &Self) -> Self {
        self - other
    }
    fn times(&self, other: &Self) -> Self {
        self * other
    }
    fn sign(&self) -> i32 {
        match self.cmp(&IBig::ZERO) {
            core::cmp::Ordering::Less => -1,
            core::cmp::Ordering::Equal => 0,
            core::cmp::Ordering::Greater => 1,
        }
    }
    fn big(&self) -> IBig {
        self.clone()
    }
}

/// The two shapes, relative to the box's least corner.
pub struct Shapes<I> {
    pub vertices: [[I; 3]; 3],
    pub extent: [I; 3],
}

/// The two shapes in the narrowest integers that suffice.
pub enum Lattice {
    /// All below 2^40. Then differences are below 2^41, differences of products of two differences
    /// below 2^83, and a sum of three products of those with a difference below 3·2^124 < 2^126.
    Narrow(Shapes<i128>),
    /// Of any size.
    Wide(Shapes<IBig>),
}

/// Bits of [`Lattice::Narrow`].
const NARROW: u32 = 40;

impl Lattice {
    /// The case, exactly.
    pub fn new<S: Sample>(case: &Case<S>) -> Self {
        let is_by_center = matches!(case.aabb, BoxNumbers::Center(..));
        Self::of_parts(&case.numbers().map(odd_mantissa), is_by_center)
    }

    /// Numbers in the order of [`Case::numbers`].
    fn of_parts(numbers: &[Option<Parts>; 15], is_by_center: bool) -> Self {
        let parts = || numbers.iter().flatten();
        let unit = parts().map(|&(_, e)| e).min().unwrap_or(0);
        let bits = |&(m, e): &Parts| (e - unit) as u32 + 64 - m.unsigned_abs().leading_zeros();
        // Sums and differences of three below 2^124 stay below 2^126.
        if parts().map(bits).max().unwrap_or(0) <= 124 {
            let whole = |part: Option<Parts>| part.map_or(0, |(m, e)| i128::from(m) << (e - unit));
            let shapes = from_least_corner(&numbers.map(whole), is_by_center);
            if shapes.all().all(|x| x.unsigned_abs() >> NARROW == 0) {
                return Self::Narrow(shapes);
            }
            return Self::Wide(shapes.big());
        }
        let whole = |part: Option<Parts>| {
            part.map_or(IBig::ZERO, |(m, e)| IBig::from(m) << (e - unit) as usize)
        };
        Self::Wide(from_least_corner(&numbers.map(whole), is_by_center))
    }

    /// The same in integers of any size.
    pub fn widened(self) -> Self {
        match self {
            Self::Narrow(shapes) => Self::Wide(shapes.big()),
            wide @ Self::Wide(_) => wide,
        }
    }
}

/// The value as an odd number times a power of two; zero has no such form.
pub fn odd_mantissa<S: Sample>(x: S) -> Option<Parts> {
    let (mantissa, exponent) = x.mantissa_exponent();
    let zeros = mantissa.trailing_zeros();
    (mantissa != 0).then(|| (mantissa >> zeros, exponent + zeros as i32))
}

/// Integers in the order of [`Case::numbers`], and the form of the box.
fn from_least_corner<I: Ring>(numbers: &[I; 15], is_by_center: bool) -> Shapes<I> {
    let row = |r: usize| -> [I; 3] { core::array::from_fn(|i| numbers[3 * r + i].clone()) };
    let sum = |a: &[I; 3], b: &[I; 3]| core::array::from_fn(|i| a[i].plus(&b[i]));
    let (p, q) = (row(3), row(4));
    let (least, extent) = if is_by_center {
        (I::difference(&p, &q), sum(&q, &q))
    } else {
        (p.clone(), I::difference(&q, &p))
    };
    Shapes { vertices: three(|r| I::difference(&row(r), &least)), extent }
}

impl<I: Ring> Shapes<I> {
    pub(crate) fn all(&self) -> impl Iterator<Item = &I> {
        self.vertices.iter().flatten().chain(&self.extent)
    }

    /// The same in integers of any size.
    pub fn big(&self) -> Shapes<IBig> {
        let row = |v: &[I; 3]| core::array::from_fn(|i| v[i].big());
        Shapes {
            vertices: core::array::from_fn(|i| row(&self.vertices[i])),
            extent: row(&self.extent),
        }
    }

    /// Edge k, from vertex k to the next.
    pub fn edge(&self, k: usize) -> [I; 3] {
        I::difference(&self.vertices[(k + 1) % 3], &self.vertices[k])
    }
}
