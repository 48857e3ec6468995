//! The numbers of a translation along a coordinate axis, as of a box on a floor, or of two boxes with the
//! coordinate axes. Their depth is mostly a number that the scalar holds, and bounds on it always leave a
//! doubt. But it is a sum of few numbers, mostly without a rounding in `f64`.

use core::cmp::Ordering;

use super::body::{Body, flipped};
use super::directions::Direction;
use super::filter::Filter;
use super::lanes::Measure;
use super::measures::{Directed, Lengths, Way};
use super::whole::gathered;
use crate::arithmetic::{
    Double, Each, Number, Soft, compare, exp2, greatest, least, pick, three, turn, two,
};
use crate::scalar::Scalar;
use crate::shape::{AabbForm, Vec3};

/// a + b, if that is no rounding.
fn sum(a: f64, b: f64) -> Option<f64> {
    exact(Double::difference(a, -b))
}

/// The number, if one word holds it.
fn exact(x: Double) -> Option<f64> {
    (x.low == 0.0).then_some(x.high)
}

/// Where a shape ends on a coordinate axis, above or below, if no sum is rounded.
fn end<S: Scalar>(body: &Body<'_, S>, axis: usize, is_above: bool) -> Option<f64> {
    let on = |p: &Vec3<S>| pick(&p.to_array(), axis).in_double();
    let (center, reach) = match body {
        Body::Triangle(t) => {
            let [a, b, c] = t.vertices().each(|p| on(&p));
            let of = if is_above { greatest } else { least };
            return Some(of(a, of(b, c)));
        }
        Body::Aabb(aabb) => match aabb.form() {
            AabbForm::Corners { min, max } => return Some(on(if is_above { max } else { min })),
            AabbForm::Center { center, half } => (on(center), on(half)),
        },
        Body::Obb(obb) => {
            let mut reach = 0.0;
            for (side, half) in obb.axes().iter().zip(obb.half_extents().to_array()) {
                reach = sum(reach, product(on(side).abs(), half.in_double())?)?;
            }
            (on(&obb.center()), reach)
        }
    };
    sum(center, if is_above { reach } else { -reach })
}

/// a·b, if that is no rounding, and a rounding would not underflow.
fn product(a: f64, b: f64) -> Option<f64> {
    let product = Double::of_product(a, b);
    exact(product).filter(|x| x.abs().is_product() || a == 0.0 || b == 0.0)
}

/// The binary digits of a float.
fn digits(x: f64) -> u32 {
    f64::MANTISSA_DIGITS - (x.to_bits() | 1 << (f64::MANTISSA_DIGITS - 1)).trailing_zeros()
}

/// x₀·y₁ − x₁·y₀: its sign, its size, and how many binary digits that has at most; `None` if the exact number is
/// longer, or zero.
fn minor<S: Scalar>(x: [f64; 2], y: [f64; 2]) -> Option<(Ordering, Soft, u32)> {
    if S::FLOAT.is_none() {
        // A product of two axes of such a type would not fit.
        if S::UNIT < exp2(-62) {
            return None;
        }
        let whole = |x: f64| i128::from((x * (1.0 / S::UNIT)) as i64);
        let minor = whole(x[0]) * whole(y[1]) - whole(x[1]) * whole(y[0]);
        let (sign, size) = minor.sign_and_size()?;
        let digits = 128 - minor.unsigned_abs().leading_zeros() - minor.trailing_zeros();
        return Some((sign, size, digits));
    }
    let minor = Double::difference(product(x[0], y[1])?, product(x[1], y[0])?);
    let size = minor.in_soft().filter(|_| minor.high.abs().is_product())?;
    let digits = if minor.low == 0.0 { digits(minor.high) } else { 64 };
    Some((compare(minor.high, 0.0), size, digits))
}

/// Whether `f64` has all numbers of the shapes, and their differences.
fn are_in_double<S: Scalar>(bodies: &[Body<'_, S>; 2]) -> bool {
    const LIMIT: f64 = exp2(52);
    let is_short = |all, x: S| all & (x.units().abs() < LIMIT);
    S::IS_IN_DOUBLE || gathered(bodies, true, is_short) == [true; 3]
}

/// The way along a coordinate axis and its numbers, if no float has a rounding. They equal those from exact
/// numbers, which divide by the length of the direction, and are exact if 64 digits hold the overlap.
pub(super) fn on_axis<S: Scalar>(
    filter: &Filter<'_>,
    bodies: &[Body<'_, S>; 2],
    (direction, numbers): (Direction, [u8; 2]),
    axis: usize,
    is_along: bool,
) -> Option<Directed<S>> {
    let (_, j, k) = turn(axis);
    let [x, y] = filter.ruler.sides(numbers).each(|v| [*pick(v, j), *pick(v, k)]);
    let (sign, length, digits_of_length) = minor::<S>(x, y)?;
    let is_exact = |n: u8| bodies[usize::from(n >= 3)].is_side_exact((n % 3).into());
    if !(is_exact(numbers[0]) && is_exact(numbers[1]) && are_in_double(bodies)) {
        return None;
    }
    // The first shape goes up from the second one's upper end, or down from its lower end.
    let is_up = is_along == sign.is_gt();
    let [above, below] = if is_up { [1, 0] } else { [0, 1] };
    let depth =
        Double::difference(end(&bodies[above], axis, true)?, end(&bodies[below], axis, false)?);
    let one = depth.in_soft().filter(|_| depth.high.is_product())?;
    let one = one.scaled(2 * i32::from(S::ONE.shift));
    let is_short = depth.low == 0.0 && digits(depth.high) + digits_of_length <= 64;
    let length = if is_short { Soft::ONE } else { length };
    let overlap = if is_short { one } else { one.times(length) };
    let lengths = Lengths {
        overlap,
        length,
        square: length.times(length),
        depth: if is_short { one } else { overlap.over(length) },
        coordinates: three(|i| (i == axis).then_some((sign, length))),
    };
    let along = two(|n| {
        let sides = &filter.ruler.shapes[n].sides;
        three(|i| compare(flipped(*pick(pick(sides, i), axis), sign.is_lt()), 0.0))
    });
    let unit = three(|i| if i == axis { flipped(1.0, !is_up) } else { 0.0 });
    let way = Way { direction, is_along, along, is_held: false };
    Some(Directed { unit, depth: f64::INFINITY, measures: lengths.measures(is_along), way })
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::super::body::in_floats;
    use super::super::directions::sides_of_all;
    use super::super::tests::{Draw, check};
    use super::super::wanted::Wanted;
    use super::super::{Shape, body::Rough};
    use super::*;
    use crate::arithmetic::REGISTERS_ARE_WIDE;
    use crate::shape::{Aabb, Obb, Triangle};

    /// Whether floats know a contact along a coordinate axis; all ways to it agree.
    fn is_known<S: Scalar>(first: &impl Shape<S>, second: &impl Shape<S>) -> bool {
        check(first, second);
        let bodies = [first.body(), second.body()];
        let rough: [Rough; 2] = in_floats(&bodies);
        let filter = Filter::new::<S>(&rough);
        let wanted = Wanted::new(&bodies, &filter).ok();
        wanted.as_ref().and_then(Wanted::single).zip(wanted.as_ref()).is_some_and(
            |((n, is_along), wanted)| {
                let numbers = sides_of_all(filter.ruler.are_triangles)[n];
                let direction = (wanted.direction(n), numbers);
                let axis = filter.axes.axis(numbers);
                axis.is_some_and(|axis| {
                    on_axis::<S>(&filter, &bodies, direction, axis, is_along).is_some()
                })
            },
        )
    }

    /// How many contacts of boxes with a flat triangle and with each other are known, of 100. `of` makes
    /// coordinates of numbers from −1 to 1, in steps of 2^-bits.
    fn known<S: Scalar>(bits: u32, of: fn(f64) -> S) -> usize {
        let (mut draw, mut known) = (Draw(5 + u64::from(bits)), 0);
        for n in 0..40 {
            let [mut a, mut b, mut c, p, q] = [(); 5].map(|()| draw.point(bits, of));
            let half = [(); 2].each(|()| draw.half(bits, of));
            (b[n % 3], c[n % 3]) = (a[n % 3], a[n % 3]);
            // Parallel to it up to a residue.
            if n % 8 == 7 {
                a[n % 3] = of(0.0);
            }
            let floor = Triangle::new(a, b, c).unwrap();
            let [low, high] = [false, true]
                .each(|is_above| three(|i| if (p[i] > q[i]) == is_above { p[i] } else { q[i] }));
            let (aabb, corners) = (
                Aabb::from_center_half_extents(p, half[0]).unwrap(),
                Aabb::from_min_max(low, high).unwrap(),
            );
            let axes = [[0.8, -0.6, 0.0], [0.6, 0.8, 0.0], [0.0, 0.0, 1.0]];
            let axes = three(|k| three(|i| of(axes[k][i] * 0.75)));
            let turned = Obb::from_skewed_axes(q, axes, half[1]).unwrap();
            known += usize::from(is_known(&floor, &aabb)) + usize::from(is_known(&aabb, &corners));
            known += usize::from(is_known(&corners, &floor));
            known += usize::from(is_known(&floor, &turned)) + usize::from(is_known(&turned, &aabb));
        }
        known
    }

    #[test]
    fn contacts_along_an_axis_have_the_bits_of_exact_numbers() {
        let few = |x: f64| x as f32;
        let mut all = std::vec![
            known(2, few),
            known(12, few),
            known(30, few),
            known(8, |x| x),
            known(30, |x| x / 3.0),
        ];
        #[cfg(feature = "fixed")]
        {
            use fixed::types::{I0F64, I8F8, I16F16, I32F32};
            all.extend([
                known(12, I8F8::from_num::<f64>),
                known(30, I16F16::from_num::<f64>),
                known(30, |x| I16F16::from_num(x * 32767.0)),
                known(30, I32F32::from_num::<f64>),
            ]);
            assert_eq!(known(30, |x| I32F32::from_num(x * 2e9)), 0);
            assert_eq!(known(30, |x| I0F64::from_bits((x * 1e9) as i64)), 0);
        }
        assert_eq!(known(30, |x| x * 1e-320), 0);
        assert!(!REGISTERS_ARE_WIDE || all.iter().all(|&known| known > 20), "{all:?}");
    }
}
