//! The shapes that have contacts as one type, in floats and in exact numbers.

use crate::arithmetic::{
    self, Double, Each, Filtered, Parts, exponent, is_software, is_zero, minus3, part, pick, three,
    turn,
};
use crate::robust::{Linear, Vector, add_determinant, along_axis, differences, singles};
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Obb, Triangle, Vec3};

pub(super) type Vec64 = [f64; 3];

/// A triangle or a box.
#[derive(Clone, Copy, Debug)]
pub enum Flat<'a, S> {
    Triangle(&'a Triangle<S>),
    Aabb(&'a Aabb<S>),
}

/// The points within a radius of a segment, which may be a point.
#[derive(Clone, Copy, Debug)]
pub struct Round<S> {
    pub(super) ends: [Vec3<S>; 2],
    pub(super) radius: S,
}

/// A shape with its given numbers.
#[derive(Clone, Copy, Debug)]
pub enum Body<'a, S> {
    Triangle(&'a Triangle<S>),
    Aabb(&'a Aabb<S>),
    Obb(&'a Obb<S>),
}

/// A place half way between two points; the points are equal if the place is a number of the
/// scalar.
#[derive(Clone, Copy)]
pub(super) struct Place<S>(pub(super) [S; 3], pub(super) [S; 3]);

/// A shape in floats relative to an origin: its centre or vertices, its axes or edges, and its
/// half-extents or zero.
#[derive(Clone, Copy)]
pub(super) struct Rough<F = f64> {
    pub(super) is_triangle: bool,
    /// The vertices, or the centre three times.
    pub(super) at: [[F; 3]; 3],
    pub(super) sides: [[F; 3]; 3],
    pub(super) half: [F; 3],
}

impl Rough {
    /// The shape in `f32`; numbers beyond its range become infinite.
    #[inline(always)]
    pub(super) fn short(&self) -> Rough<f32> {
        let short = |v: &Vec64| three(|i| v[i] as f32);
        Rough {
            is_triangle: self.is_triangle,
            at: three(|k| short(&self.at[k])),
            sides: three(|k| short(&self.sides[k])),
            half: short(&self.half),
        }
    }
}

impl<S: Scalar> Body<'_, S> {
    pub(super) fn is_triangle(&self) -> bool {
        matches!(self, Self::Triangle(_))
    }

    /// The centre of a box, or the first vertex of a triangle.
    #[inline]
    pub(super) fn origin(&self) -> Place<S> {
        match self {
            Self::Triangle(t) => {
                let [a, _, _] = t.points();
                Place(a, a)
            }
            Self::Aabb(aabb) => match aabb.form() {
                AabbForm::Center { center, .. } => Place(center.to_array(), center.to_array()),
                AabbForm::Corners { min, max } => Place(min.to_array(), max.to_array()),
            },
            Self::Obb(obb) => Place(obb.center().to_array(), obb.center().to_array()),
        }
    }

    /// The shape in floats, relative to the origin of a shape. Each number is rounded once or twice. Lengths are multiplied by a power
    /// of two.
    #[cfg_attr(target_arch = "s390x", inline(never))] // QEMU before 8.0 multiplies two f32 widened for it wrongly on s390x (MDEBR).
    pub(super) fn rough(&self, origin: &Self, scale: f64) -> Rough {
        let origin = origin.origin();
        let less = |x: S, other: S| difference_in_double(x, other, scale);
        let from = |x: &Place<S>| mean(x, &origin, scale);
        let in_double = |x: [S; 3], scale: f64| {
            part(|| {
                let all = x.each(S::in_double);
                let is_done = is_software::<f64>() && is_one(scale);
                if is_done { all } else { all.each(|x| scaled::<S>(x, scale)) }
            })
        };
        let lengths = |x: [S; 3]| in_double(x, scale);
        let aligned = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let (sides, half) = match self {
            Self::Triangle(t) => {
                let v = t.points();
                let edge = |k: usize| {
                    let (from, to) = (pick(&v, k), pick(&v, turn(k).1));
                    three(|i| less(to[i], from[i]))
                };
                let sides = [edge(0), edge(1), edge(2)];
                let at = three(|k| from(&Place(v[k], v[k])));
                return Rough { is_triangle: true, at, sides, half: [0.0; 3] };
            }
            Self::Aabb(aabb) => match aabb.form() {
                AabbForm::Center { half, .. } => (aligned, lengths(half.to_array())),
                AabbForm::Corners { min, max } => {
                    let (p, q) = (min.to_array(), max.to_array());
                    (aligned, three(|i| less(q[i], p[i]) * 0.5))
                }
            },
            Self::Obb(obb) => (
                obb.axes().each(|axis| in_double(axis.to_array(), 1.0)),
                lengths(obb.half_extents().to_array()),
            ),
        };
        let center = from(&self.origin());
        Rough { is_triangle: false, at: [center; 3], sides, half }
    }

    /// Edge k of a triangle, or axis k of a box.
    pub(super) fn side(&self, k: usize) -> Vector {
        match self {
            Self::Triangle(t) => {
                let v = t.points();
                let (from, to) = (pick(&v, k), pick(&v, turn(k).1));
                differences(to, from)
            }
            Self::Aabb(_) => along_axis(k % 3, S::ONE),
            Self::Obb(obb) => singles(pick(obb.axes(), k).to_array()),
        }
    }

    /// Whether the side has no rounding in `f64`, if `f64` holds the scalar.
    pub(super) fn is_side_exact(&self, k: usize) -> bool {
        match self {
            // Differences of integers of so few bits.
            Self::Triangle(_) if S::FLOAT.is_none() && S::IS_IN_DOUBLE => true,
            Self::Triangle(t) => {
                let v = t.points().each(|p| three(|i| p[i].in_double()));
                Double::way(pick(&v, turn(k).1), pick(&v, k)).iter().all(|x| x.low == 0.0)
            }
            _ => true,
        }
    }

    /// Twice the half-extent along axis k, as the sum of two numbers; zero for a triangle.
    pub(super) fn extent(&self, k: usize) -> [Parts; 2] {
        let k = k % 3;
        match self {
            Self::Triangle(_) => [Parts::ZERO; 2],
            Self::Aabb(aabb) => match aabb.form() {
                AabbForm::Center { half, .. } => [half.to_array()[k].parts(); 2],
                AabbForm::Corners { min, max } => {
                    [max.to_array()[k].parts(), min.to_array()[k].parts().negated()]
                }
            },
            Self::Obb(obb) => [obb.half_extents().to_array()[k].parts(); 2],
        }
    }

    /// Adds (x × y)·p to the sum or subtracts it, with p twice the centre or twice vertex k.
    pub(super) fn add_place(
        &self,
        sum: &mut S::SeptumSum,
        [x, y]: [&Vector; 2],
        k: usize,
        minus: bool,
    ) {
        let Place(p, q) = match self {
            Self::Triangle(t) => {
                let v = *pick(&t.points(), k);
                Place(v, v)
            }
            _ => self.origin(),
        };
        let both: Vector = three(|i| -> Linear { [p[i].parts(), q[i].parts(), Parts::ZERO] });
        let one = if minus { S::ONE.negated() } else { S::ONE };
        add_determinant(sum, [x, y, &both], Some(one));
    }
}

/// The shapes in floats, relative to the origin of the second.
#[inline(always)]
pub(super) fn in_floats<S: Scalar>(bodies: &[Body<'_, S>; 2]) -> [Rough; 2] {
    [bodies[0].rough(&bodies[1], 1.0), bodies[1].rough(&bodies[1], 1.0)]
}

/// x·scale, which fixed point has no need of.
pub(super) fn scaled<S: Scalar>(x: f64, scale: f64) -> f64 {
    if S::FLOAT.is_none() { x } else { x * scale }
}

/// Whether a float is one, by its bits.
#[inline(always)]
fn is_one(x: f64) -> bool {
    x.to_bits() == 1.0_f64.to_bits()
}

/// (x − other)·scale. A power of two below one keeps the difference within the range of `f64`.
pub(super) fn difference_in_double<S: Scalar>(x: S, other: S, scale: f64) -> f64 {
    part(|| {
        if S::FLOAT.is_none() || is_one(scale) {
            x.beyond_in_double(other)
        } else {
            x.in_double() * scale - other.in_double() * scale
        }
    })
}

/// The mean of two coordinates each, less that of the origin, times a power of two.
#[cfg_attr(target_pointer_width = "64", inline(always))]
#[cfg_attr(not(target_pointer_width = "64"), inline(never))]
fn mean<S: Scalar>(x: &Place<S>, origin: &Place<S>, scale: f64) -> Vec64 {
    // Fixed point halves a sum of two equal numbers without a rounding.
    let are_one = is_software::<f64>() && S::FLOAT.is_none() && x.0 == x.1 && origin.0 == origin.1;
    let mut all = [0.0; 3];
    for (i, to) in all.iter_mut().enumerate() {
        *to = difference_in_double(*pick(&x.0, i), *pick(&origin.0, i), scale);
        if !are_one {
            let second = difference_in_double(*pick(&x.1, i), *pick(&origin.1, i), scale);
            *to = (*to + second) * 0.5;
        }
    }
    all
}

/// x or −x. In bits, because a processor does not foresee signs.
#[inline]
pub(super) fn flipped(x: f64, is_negative: bool) -> f64 {
    f64::from_bits(x.to_bits() ^ u64::from(is_negative) << 63)
}

pub(super) fn cross(x: &Vec64, y: &Vec64) -> Vec64 {
    if is_software::<f64>() {
        return three(|i| {
            let (_, j, k) = turn(i);
            sum_by_functions(&[*pick(x, j), -*pick(x, k)], &[*pick(y, k), *pick(y, j)])
        });
    }
    arithmetic::cross::<Filtered<f64>>(x, y)
}

#[inline]
pub(super) fn dot(x: &Vec64, y: &Vec64) -> f64 {
    if is_software::<f64>() {
        sum_by_functions(x, y)
    } else {
        arithmetic::dot::<Filtered<f64>>(x, y)
    }
}

/// a − b.
#[inline]
pub(super) fn minus(a: &Vec64, b: &Vec64) -> Vec64 {
    if is_software::<f64>() { three_by_functions(a, None, b) } else { minus3(a, b) }
}

/// a + t·b.
#[inline]
pub(super) fn along(a: &Vec64, t: f64, b: &Vec64) -> Vec64 {
    if is_software::<f64>() {
        return three_by_functions(a, Some(t), b);
    }
    [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]]
}

/// a + t·b, or a − b, where each operation is a function.
#[inline(never)]
fn three_by_functions(a: &Vec64, t: Option<f64>, b: &Vec64) -> Vec64 {
    let mut all = *a;
    let is_finite = t.is_none_or(|t| exponent(t) < 2047);
    for (to, &b) in all.iter_mut().zip(b) {
        // Nothing is added, as often along an axis. A zero may have another sign.
        if is_finite && is_zero(b) && !is_zero(*to) {
            continue;
        }
        *to = match t {
            Some(t) => *to + t * b,
            None => *to - b,
        };
    }
    all
}

/// The sum of products, where each operation is a function. A product with zero, which an axis and a direction
/// often have, adds nothing to a sum that is not zero.
#[inline(never)]
fn sum_by_functions(x: &[f64], y: &[f64]) -> f64 {
    let is_nothing = |x: f64, y: f64| is_zero(x) && exponent(y) < 2047;
    let mut sum = 0.0;
    for is_whole in [false, true] {
        let terms = x.iter().zip(y);
        let mut some = terms
            .filter(|&(&x, &y)| is_whole || !(is_nothing(x, y) || is_nothing(y, x)))
            .map(|(x, y)| x * y);
        let first = some.next().unwrap_or(0.0);
        sum = some.fold(first, |sum, product| sum + product);
        // A zero may have another sign.
        if !is_zero(sum) {
            break;
        }
    }
    sum
}
