//! A box and an oriented box: an oracle that clips the surface of one box by the other, in that
//! box's own coordinates and in integers.

mod sets;

pub use sets::BoxSet;

use dashu_int::IBig;
use septum::relation::{Relate, Relation};
use septum::{Aabb, Obb, ShapeError, Vec3};

use crate::exact::{Parts, least_exponent, whole};
use crate::flat::Truth;
use crate::lattice::{Lattice, Ring, Shapes};
use crate::sample::Sample;
use crate::{Each, case::BoxNumbers, three};

pub type Point<S> = [S; 3];

/// Centre, axes and half-extents.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObbNumbers<S> {
    pub center: Point<S>,
    pub axes: [Point<S>; 3],
    pub half: Point<S>,
}

impl<S: Copy> ObbNumbers<S> {
    pub(crate) fn map<T>(self, f: impl Fn(S) -> T + Copy) -> ObbNumbers<T> {
        ObbNumbers {
            center: self.center.each(f),
            axes: self.axes.each(|u| u.each(f)),
            half: self.half.each(f),
        }
    }
}

impl<S: Sample> ObbNumbers<S> {
    /// The box, if the axes span space.
    pub fn shape(&self) -> Result<Obb<S>, ShapeError> {
        Obb::from_skewed_axes(self.center, self.axes.each(Vec3::from), self.half)
    }
}

/// A box of either kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AnyBox<S> {
    Aabb(BoxNumbers<S>),
    Obb(ObbNumbers<S>),
}

/// A box and an oriented box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxCase<S> {
    pub first: AnyBox<S>,
    pub second: ObbNumbers<S>,
}

/// The shapes made from these numbers.
enum Shape<S> {
    Aabb(Aabb<S>),
    Obb(Obb<S>),
}

/// A box in integers: centre, axes and half-extents. Positions are multiplied by one.
struct Whole {
    center: [IBig; 3],
    axes: [[IBig; 3]; 3],
    half: [IBig; 3],
}

impl Whole {
    /// The box in units of 2^`unit`, with `one` as the number of units in one; both times `scale`.
    fn new(any: AnyBox<Parts>, unit: i32, scale: &IBig) -> Self {
        let number = |x: Parts| whole(x, unit);
        let one = IBig::ONE << (-unit) as usize;
        // All numbers are doubled, because the centre between two corners need not be an integer.
        let times = |x: IBig, n: u8| x * IBig::from(n) * scale;
        let along = || {
            let zero = || IBig::ZERO;
            let one = || one.clone();
            [[one(), zero(), zero()], [zero(), one(), zero()], [zero(), zero(), one()]]
        };
        let scaled = |p: [Parts; 3], n: u8| p.each(|x| times(number(x), n));
        let (center, axes, half) = match any {
            AnyBox::Obb(b) => {
                (scaled(b.center, 2), b.axes.each(|u| u.each(number)), scaled(b.half, 2))
            }
            AnyBox::Aabb(BoxNumbers::Center(c, h)) => (scaled(c, 2), along(), scaled(h, 2)),
            AnyBox::Aabb(BoxNumbers::Corners(p, q)) => {
                let (p, q) = (scaled(p, 1), scaled(q, 1));
                let sum = three(|i: usize| &p[i] + &q[i]);
                (sum, along(), IBig::difference(&q, &p))
            }
        };
        Self { center: center.each(|x| x * &one), axes, half }
    }

    /// w_i·x + h_i·|det| for the normals w_i of the faces, and twice h_i·|det|: x is inside if each
    /// value is between zero and that.
    fn coordinates(&self) -> (impl Fn(&[IBig; 3]) -> [IBig; 3] + '_, [IBig; 3]) {
        let [u, v, n] = &self.axes;
        let w = [IBig::cross(v, n), IBig::cross(n, u), IBig::cross(u, v)];
        let det = IBig::dot(u, &w[0]);
        let size = &det * IBig::from(Ring::sign(&det));
        let reach = three(|i: usize| &self.half[i] * &size);
        let extent = reach.clone().each(|r| r * IBig::from(2));
        let of = move |x: &[IBig; 3]| {
            let from = IBig::difference(x, &self.center);
            three(|i: usize| IBig::dot(&w[i], &from) + &reach[i])
        };
        (of, extent)
    }

    fn corner(&self, k: usize) -> [IBig; 3] {
        let mut corner = self.center.clone();
        for j in 0..3 {
            for i in 0..3 {
                let step = &self.half[j] * &self.axes[j][i];
                if k >> j & 1 == 1 { corner[i] += step } else { corner[i] -= step }
            }
        }
        corner
    }

    /// Whether the two boxes have a point in common: a triangle of one's surface meets the other
    /// box, or one box is inside the other.
    fn meets(&self, other: &Self) -> bool {
        let (of, extent) = other.coordinates();
        let center = of(&self.center);
        if (0..3).all(|i| center[i] >= IBig::ZERO && center[i] <= extent[i]) {
            return true;
        }
        let (of, extent) = self.coordinates();
        let corners: Vec<[IBig; 3]> = (0..8).map(|k| of(&other.corner(k))).collect();
        let face = |axis: usize, upper: usize| {
            let (j, l) = ((axis + 1) % 3, (axis + 2) % 3);
            let at = |a: usize, b: usize| upper << axis | a << j | b << l;
            [[at(0, 0), at(1, 0), at(0, 1)], [at(1, 1), at(1, 0), at(0, 1)]]
        };
        (0..3).flat_map(|axis| [face(axis, 0), face(axis, 1)]).flatten().any(|triangle| {
            let vertices = triangle.each(|k| corners[k].clone());
            Lattice::Wide(Shapes { vertices, extent: extent.clone() }).meets()
        })
    }

    /// The box, shrunk about its centre by a factor of 1 − 2^−`bits`.
    fn shrunk(&self, bits: usize) -> Self {
        let whole = IBig::ONE << bits;
        let less = &whole - IBig::ONE;
        Self {
            center: self.center.clone().each(|x| x * &whole),
            axes: self.axes.clone(),
            half: self.half.clone().each(|x| x * &less),
        }
    }
}

impl<S: Sample> BoxCase<S> {
    fn whole(&self) -> [Whole; 2] {
        let parts = S::mantissa_exponent;
        let first = match self.first {
            AnyBox::Aabb(aabb) => AnyBox::Aabb(aabb.map(parts)),
            AnyBox::Obb(obb) => AnyBox::Obb(obb.map(parts)),
        };
        let second = self.second.map(parts);
        let mut rows = vec![second.center, second.half];
        rows.extend(second.axes);
        match first {
            AnyBox::Aabb(BoxNumbers::Center(p, q) | BoxNumbers::Corners(p, q)) => {
                rows.extend([p, q]);
            }
            AnyBox::Obb(obb) => {
                rows.extend([obb.center, obb.half]);
                rows.extend(obb.axes);
            }
        }
        let unit = least_exponent(rows.as_flattened()).min(0);
        [first, AnyBox::Obb(second)].each(|any| Whole::new(any, unit, &IBig::ONE))
    }

    /// Whether the two have a point in common.
    pub fn meets(&self) -> bool {
        let [first, second] = self.whole();
        first.meets(&second)
    }

    /// The relation, for numbers of a few bits. The interiors meet if both boxes still meet after
    /// shrinking a little: the least nonzero value of degree 8 is greater than the change by
    /// shrinking.
    pub fn truth(&self) -> Truth {
        let [first, second] = self.whole();
        if !first.meets(&second) {
            Truth::Apart
        } else if first.shrunk(128).meets(&second.shrunk(128)) {
            Truth::Overlapping
        } else {
            Truth::Touching
        }
    }

    /// The shapes, if the numbers are valid.
    fn shapes(&self) -> Option<(Shape<S>, Obb<S>)> {
        let first = match self.first {
            AnyBox::Aabb(aabb) => Shape::Aabb(aabb.shape().ok()?),
            AnyBox::Obb(obb) => Shape::Obb(obb.shape().ok()?),
        };
        Some((first, self.second.shape().ok()?))
    }

    /// The crate's answers in either order, and the answer of `may_overlap`; `None` if the numbers
    /// are invalid.
    pub fn answers(&self) -> Option<([bool; 2], bool)> {
        let (first, second) = self.shapes()?;
        Some(match first {
            Shape::Aabb(first) => {
                ([first.overlaps(&second), second.overlaps(&first)], first.may_overlap(&second))
            }
            Shape::Obb(first) => {
                ([first.overlaps(&second), second.overlaps(&first)], first.may_overlap(&second))
            }
        })
    }

    /// The relation according to the crate, in either order.
    pub fn relations(&self) -> Option<[Relation; 2]> {
        let (first, second) = self.shapes()?;
        Some(match first {
            Shape::Aabb(first) => [first.relation(&second), second.relation(&first)],
            Shape::Obb(first) => [first.relation(&second), second.relation(&first)],
        })
    }

    /// Checks the answers against the oracle, and returns its answer.
    ///
    /// # Panics
    /// If an answer is wrong.
    pub fn check(&self) -> Option<bool> {
        let (answers, may) = self.answers()?;
        let meets = self.meets();
        assert_eq!(answers, [meets; 2], "{self:?}");
        assert!(may || !meets, "may_overlap: {self:?}");
        let [relation, other] = self.relations()?;
        assert!(relation == other && (relation != Relation::Disjoint) == meets, "{self:?}");
        Some(meets)
    }
}
