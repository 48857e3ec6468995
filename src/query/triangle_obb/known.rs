//! What is known of a box before a triangle is tested against it, and products of short words.

use crate::arithmetic::{InRaw, ProductSum, Raw, Word, three, turn};
use crate::query::obb_short::size;
use crate::scalar::Scalar;
use crate::shape::{Obb, Vec3};

/// The bits of an axis, without its sign.
pub(super) const AXIS: i32 = 19;

/// The numbers of a box as whole ones.
pub(in crate::query) trait WholeBox {
    type Raw: Raw;

    fn axes(&self) -> [[Self::Raw; 3]; 3];
    fn half(&self) -> [Self::Raw; 3];
    /// A one of the axes is two to this power.
    fn fraction_bits(&self) -> i32;
    /// What the numbers add to the error of the stage.
    #[inline(always)]
    fn error(&self) -> i32 {
        0
    }
}

impl<S: Scalar + InRaw> WholeBox for Obb<S> {
    type Raw = S::Raw;

    #[inline(always)]
    fn axes(&self) -> [[S::Raw; 3]; 3] {
        let [u, v, w] = self.axes();
        [raw(u), raw(v), raw(w)]
    }
    #[inline(always)]
    fn half(&self) -> [S::Raw; 3] {
        raw(&self.half_extents())
    }
    #[inline(always)]
    fn fraction_bits(&self) -> i32 {
        S::FRACTION_BITS
    }
}

/// The numbers that are known before the test. It is a constant of its caller, so the compiler keeps
/// one case, and the code that computes known numbers falls away.
#[derive(Clone, Copy)]
pub(in crate::query) enum Known<'c> {
    /// The test computes w_i when it comes to face i.
    Nothing,
    Size(Size),
    All(&'c Crossed),
}

/// The size of a box.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::query) struct Size {
    /// The bits of the greatest component of the axes.
    longest: i32,
    /// The bits of that and of the greatest half-extent, less the fraction bits.
    pub(in crate::query) reach: i32,
}

/// The axes of a box, crossed.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::query) struct Crossed {
    size: Size,
    normals: [[i32; 3]; 3],
    volume: i32,
}

impl Size {
    #[inline(always)]
    pub(in crate::query) fn of(obb: &impl WholeBox) -> Self {
        let longest = Known::Nothing.longest(obb);
        Self { longest, reach: Known::Nothing.reach(obb, longest - obb.fraction_bits()) }
    }
}

impl Crossed {
    #[inline(always)]
    pub(super) fn of(obb: &impl WholeBox) -> Self {
        let size = Size::of(obb);
        let u = cut_axes(obb, size.longest);
        let normals = three(|i| Known::Nothing.normal(&u, i));
        Self { size, normals, volume: Known::Nothing.volume(&u, &normals[0]) }
    }
}

impl Known<'_> {
    /// The bits of the greatest component of the axes.
    #[inline(always)]
    pub(super) fn longest(self, obb: &impl WholeBox) -> i32 {
        match self {
            Known::Nothing => size(&obb.axes()).bits(),
            Known::Size(size) | Known::All(&Crossed { size, .. }) => size.longest,
        }
    }

    /// The bits of the greatest half-extent and `longer`.
    #[inline(always)]
    pub(super) fn reach(self, obb: &impl WholeBox, longer: i32) -> i32 {
        match self {
            Known::Nothing => size(&[obb.half()]).bits() + longer,
            Known::Size(size) | Known::All(&Crossed { size, .. }) => size.reach,
        }
    }

    /// w_i, from the axes cut.
    #[inline(always)]
    pub(super) fn normal(self, u: &[[i32; 3]; 3], i: usize) -> [i32; 3] {
        let (_, j, l) = turn(i);
        match self {
            Known::All(crossed) => crossed.normals[i],
            _ => cross(&u[j], &u[l]),
        }
    }

    /// |u_0·w_0|, from w_0.
    #[inline(always)]
    pub(super) fn volume(self, u: &[[i32; 3]; 3], w: &[i32; 3]) -> i32 {
        match self {
            Known::All(crossed) => crossed.volume,
            _ => product_over(w, &u[0], 9).abs(),
        }
    }
}

/// The axes, cut to few bits.
#[inline(always)]
pub(super) fn cut_axes(obb: &impl WholeBox, longest: i32) -> [[i32; 3]; 3] {
    Raw::cut(obb.axes(), longest - AXIS)
}

// Products of short words, and the size of vectors.

/// A sum of products.
pub(super) type Sum = <i32 as Word>::Sum;

#[inline(always)]
pub(in crate::query) fn raw<S: InRaw>(v: &Vec3<S>) -> [S::Raw; 3] {
    [v.x.raw(), v.y.raw(), v.z.raw()]
}

/// The cross product over 2^19, rounded down.
#[inline(always)]
pub(super) fn cross(a: &[i32; 3], b: &[i32; 3]) -> [i32; 3] {
    let area = |j: usize, l: usize| Sum::new(a[j], b[l], -a[l], b[j]).scaled_by(9);
    [area(1, 2), area(2, 0), area(0, 1)]
}

/// The product over 2^10, rounded down.
#[inline(always)]
pub(super) fn product(a: &[i32; 3], b: &[i32; 3]) -> i32 {
    product_over(a, b, 0)
}

/// The product over 2^10 and 2^`places`, rounded down.
#[inline(always)]
pub(super) fn product_over(a: &[i32; 3], b: &[i32; 3], places: u32) -> i32 {
    Sum::new(a[0], b[0], a[1], b[1]).with_product(a[2], b[2]).scaled_by(places)
}
