//! The exact numbers of a direction as integers: in 60 bits, as in most scenes, or in 250 bits, as
//! for poses with residues of quarter turns. The results equal [`sums`](super::sums) and take a
//! fraction of the time.

use core::cmp::Ordering;

use super::body::{Body, Place};
use super::exact::{Given, Size};
use crate::arithmetic::{
    BigInt, Bits, I256, Number, Parts, REGISTERS_ARE_WIDE, Soft, compare, pick, three, turn,
};
use crate::scalar::Scalar;
use crate::shape::AabbForm;

/// Integers for the numbers of shapes, their products, and products of these.
pub(super) trait Integers {
    /// The numbers of the shapes.
    type Length: Number;
    /// Products of two lengths.
    type Area: Number;
    /// Products of an area and a length.
    type Volume: Number;
    /// Products of two areas.
    type Fourth: Number;

    /// The most bits of a length.
    const WIDTH: i32;
    /// The most bits of twice the reach of a shape beyond another.
    const REACH: i32;

    /// The number in units of 2^`low`.
    fn length(x: Parts, low: i32) -> Self::Length;
    fn widened(x: Self::Length) -> Self::Area;
    fn area(x: Self::Length, y: Self::Length) -> Self::Area;
    /// x·2^up.
    fn raised(x: Self::Area, up: u32) -> Self::Area;
    fn volume(x: Self::Area, y: Self::Length) -> Self::Volume;
    fn fourth(x: Self::Area, y: Self::Area) -> Self::Fourth;
    fn of_area(x: Self::Area) -> Option<(Ordering, Soft)>;
    fn of_fourth(x: Self::Fourth) -> Option<(Ordering, Soft)>;
}

/// Sign and size of a number that is not zero.
fn soft<const L: usize>((is_negative, limbs): (bool, [u64; L])) -> Option<(Ordering, Soft)> {
    let sign = if is_negative { Ordering::Less } else { Ordering::Greater };
    Some((sign, Soft::of_limbs(&limbs)?))
}

/// Lengths in one word.
///
/// A side is below 2^61 and a coordinate of a cross product below 2^123. Its product with a reach
/// is below 2^249, and a sum of three such products below 2^251.
pub(super) struct Short;

impl Integers for Short {
    type Length = i64;
    type Area = i128;
    type Volume = I256;
    type Fourth = I256;

    const WIDTH: i32 = 60;
    const REACH: i32 = 126;

    fn length(x: Parts, low: i32) -> i64 {
        x.in_units(low)
    }
    fn widened(x: i64) -> i128 {
        x.into()
    }
    fn area(x: i64, y: i64) -> i128 {
        i128::from(x) * i128::from(y)
    }
    fn raised(x: i128, up: u32) -> i128 {
        x << up
    }
    fn volume(x: i128, y: i64) -> I256 {
        I256::product(x, y)
    }
    fn fourth(x: i128, y: i128) -> I256 {
        I256::of_two(x, y)
    }
    fn of_area(x: i128) -> Option<(Ordering, Soft)> {
        let size = x.unsigned_abs();
        soft((x < 0, [size as u64, (size >> 64) as u64]))
    }
    fn of_fourth(x: I256) -> Option<(Ordering, Soft)> {
        soft(x.limbs())
    }
}

/// Lengths in four words.
///
/// A side is below 2^251 and a coordinate of a cross product below 2^503. Its product with a reach
/// is below 2^1011, and a sum of three such products below 2^1013.
pub(super) struct Long;

impl Integers for Long {
    type Length = BigInt<4>;
    type Area = BigInt<8>;
    type Volume = BigInt<12>;
    type Fourth = BigInt<16>;

    const WIDTH: i32 = 250;
    const REACH: i32 = 508;

    fn length(x: Parts, low: i32) -> BigInt<4> {
        let mut length = BigInt::ZERO;
        if x.magnitude != 0 {
            let up = (i32::from(x.shift) - low) as usize;
            // Trailing zeros may lie below the unit.
            let down = x.magnitude.trailing_zeros();
            let words = core::iter::once(x.magnitude >> down);
            length.accumulate(words, up.wrapping_add(down as usize), x.negative);
        }
        length
    }
    fn widened(x: BigInt<4>) -> BigInt<8> {
        x.resized()
    }
    #[inline(never)]
    fn area(x: BigInt<4>, y: BigInt<4>) -> BigInt<8> {
        if x == BigInt::ZERO || y == BigInt::ZERO { BigInt::ZERO } else { x.times(&y) }
    }
    fn raised(x: BigInt<8>, up: u32) -> BigInt<8> {
        let mut raised = BigInt::ZERO;
        raised.add_multiple(&x, 1, up as usize, false);
        raised
    }
    fn volume(x: BigInt<8>, y: BigInt<4>) -> BigInt<12> {
        x.times(&y)
    }
    #[inline(never)]
    fn fourth(x: BigInt<8>, y: BigInt<8>) -> BigInt<16> {
        x.times(&y)
    }
    fn of_area(x: BigInt<8>) -> Option<(Ordering, Soft)> {
        soft(x.sign_magnitude())
    }
    fn of_fourth(x: BigInt<16>) -> Option<(Ordering, Soft)> {
        soft(x.sign_magnitude())
    }
}

/// Powers of two that divide the numbers of two shapes, in units of the least number.
pub(super) struct Units {
    /// The unit of points, and of half-extents of axis-aligned boxes.
    places: i32,
    /// The unit of the axes of oriented boxes.
    axes: i32,
    /// The unit of their half-extents.
    halves: i32,
    /// The unit of positions along a direction: of places, and of axes times half-extents.
    ends: i32,
    /// How far the two kinds of terms are shifted up to that unit.
    up: [u32; 2],
    /// Whether [`Short`] holds everything. If not, [`Long`] does.
    pub(super) are_short: bool,
}

impl Units {
    /// The units, if the numbers are short enough, and the machine multiplies long words.
    pub(super) fn new<S: Scalar>(bodies: &[Body<'_, S>; 2]) -> Option<Self> {
        if !REGISTERS_ARE_WIDE {
            return None;
        }
        let [mut places, mut axes, mut halves] = [Bits::NONE; 3];
        let with = |bits: &mut Bits, point: [S; 3]| {
            *bits = point.into_iter().fold(*bits, |bits, x| bits.with(x.parts()));
        };
        for body in bodies {
            match body {
                Body::Triangle(t) => t.points().into_iter().for_each(|p| with(&mut places, p)),
                Body::Aabb(aabb) => {
                    let (AabbForm::Center { center: p, half: q }
                    | AabbForm::Corners { min: p, max: q }) = aabb.form();
                    with(&mut places, p.to_array());
                    with(&mut places, q.to_array());
                }
                Body::Obb(obb) => {
                    with(&mut places, obb.center().to_array());
                    obb.axes().iter().for_each(|u| with(&mut axes, u.to_array()));
                    with(&mut halves, obb.half_extents().to_array());
                }
            }
        }
        // If all numbers are zero, every power of two is a unit.
        let low = |bits: Bits| if bits.width() > 0 { bits.low } else { 0 };
        let one = i32::from(S::ONE.shift);
        let (of_places, of_reach) = (low(places) + one, low(axes) + low(halves));
        let has_reach = axes.width() > 0 && halves.width() > 0;
        let ends = if has_reach { of_places.min(of_reach) } else { of_places };
        let up = [of_places - ends, if has_reach { of_reach - ends } else { 0 }];
        // Each shape has twice a place, and twice a half-extent or three products; then their sum.
        let reach = (places.width() + 3 + up[0]).max(axes.width() + halves.width() + 4 + up[1]);
        let width = places.width().max(axes.width()).max(halves.width());
        let are_short = width <= Short::WIDTH && reach < Short::REACH;
        let fits = are_short || width <= Long::WIDTH && reach < Long::REACH;
        fits.then(|| Self {
            places: low(places),
            axes: low(axes),
            halves: low(halves),
            ends,
            up: up.map(i32::unsigned_abs),
            are_short,
        })
    }

    fn point<N: Integers, S: Scalar>(point: [S; 3], low: i32) -> [N::Length; 3] {
        three(|i| N::length(point[i].parts(), low))
    }

    /// Edge k of a triangle or axis k of a box, and its unit.
    fn side<N: Integers, S: Scalar>(&self, body: &Body<'_, S>, k: usize) -> ([N::Length; 3], i32) {
        match body {
            Body::Triangle(t) => {
                let v = t.points();
                let from = Self::point::<N, S>(*pick(&v, k), self.places);
                let to = Self::point::<N, S>(*pick(&v, turn(k).1), self.places);
                (three(|i| to[i] - from[i]), self.places)
            }
            Body::Aabb(_) => {
                let mut axis = [N::Length::ZERO; 3];
                axis[k % 3] = N::length(S::ONE, S::ONE.shift.into());
                (axis, S::ONE.shift.into())
            }
            Body::Obb(obb) => {
                (Self::point::<N, S>(pick(obb.axes(), k).to_array(), self.axes), self.axes)
            }
        }
    }

    /// Twice the farthest place of a shape along the direction, from its centre or from one of its
    /// vertices.
    fn end<N: Integers, S: Scalar>(
        &self,
        body: &Body<'_, S>,
        vertex: usize,
        along: &[Ordering; 3],
        is_upper: bool,
    ) -> [N::Area; 3] {
        let Place(p, q) = match body {
            Body::Triangle(t) => {
                let v = *pick(&t.points(), vertex);
                Place(v, v)
            }
            _ => body.origin(),
        };
        let [up, reach_up] = self.up;
        let point = |p: [S; 3]| Self::point::<N, S>(p, self.places);
        let (p, q) = (point(p), point(q));
        let mut end = three(|i| {
            let place = N::raised(N::widened(p[i] + q[i]), up);
            if is_upper { -place } else { place }
        });
        let add = |end: &mut N::Area, k: usize, x: N::Area| {
            *end = if pick(along, k).is_lt() { *end - x } else { *end + x };
        };
        match body {
            Body::Triangle(_) => {}
            Body::Aabb(aabb) => {
                let twice = match aabb.form() {
                    AabbForm::Center { half, .. } => {
                        let half = point(half.to_array());
                        three(|k| half[k] + half[k])
                    }
                    AabbForm::Corners { .. } => three(|k| q[k] - p[k]),
                };
                for k in 0..3 {
                    if along[k].is_ne() {
                        add(&mut end[k], k, N::raised(N::widened(twice[k]), up));
                    }
                }
            }
            Body::Obb(obb) => {
                let half = Self::point::<N, S>(obb.half_extents().to_array(), self.halves);
                for k in (0..3).filter(|&k| along[k].is_ne()) {
                    let (side, _) = self.side::<N, S>(body, k);
                    for i in 0..3 {
                        add(
                            &mut end[i],
                            k,
                            N::raised(N::area(half[k] + half[k], side[i]), reach_up),
                        );
                    }
                }
            }
        }
        end
    }
}

/// A direction in whole numbers.
pub(super) struct Whole<'a, S, N: Integers> {
    units: &'a Units,
    bodies: &'a [Body<'a, S>; 2],
    direction: [N::Area; 3],
    unit: i32,
}

impl<'a, S: Scalar, N: Integers> Whole<'a, S, N> {
    pub(super) fn new(
        units: &'a Units,
        bodies: &'a [Body<'a, S>; 2],
        own: [(usize, usize); 2],
    ) -> Self {
        let side = |(shape, k): (usize, usize)| units.side::<N, S>(&bodies[shape % 2], k);
        let ((x, x_unit), (y, y_unit)) = (side(own[0]), side(own[1]));
        let direction = three(|i| {
            let (_, j, k) = turn(i);
            let area = |j: usize, k: usize| N::area(*pick(&x, j), *pick(&y, k));
            area(j, k) - area(k, j)
        });
        Self { units, bodies, direction, unit: x_unit + y_unit }
    }
}

impl<S: Scalar, N: Integers> Given for Whole<'_, S, N> {
    fn coordinates(&self) -> [Option<(Ordering, Soft)>; 3] {
        three(|i| {
            let (sign, size) = N::of_area(self.direction[i])?;
            Some((sign, size.scaled(self.unit)))
        })
    }

    fn side(&self, shape: usize, k: usize) -> Ordering {
        let (side, _) = self.units.side::<N, S>(&self.bodies[shape % 2], k);
        let [x, y, z] = three(|i| N::volume(self.direction[i], side[i]));
        compare(x + y + z, N::Volume::ZERO)
    }

    fn overlap(&self, along: &[[Ordering; 3]; 2], vertices: [usize; 2], lower: usize) -> Size {
        let end = |shape: usize| {
            let (body, along) = (&self.bodies[shape], &along[shape]);
            self.units.end::<N, S>(body, vertices[shape], along, shape != lower)
        };
        let (a, b) = (end(0), end(1));
        let [x, y, z] = three(|i| N::fourth(self.direction[i], a[i] + b[i]));
        let (sign, size) = N::of_fourth(x + y + z)?;
        sign.is_gt().then(|| size.scaled(self.unit + self.units.ends))
    }
}
