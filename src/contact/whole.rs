//! The exact numbers of a direction as integers. Every number of the shapes must fit in few bits,
//! as in most scenes. The results equal [`sums`](super::sums) and take a fraction of the time.

use core::cmp::Ordering;

use super::body::{Body, Place};
use super::exact::{Given, Size};
use crate::arithmetic::{Bits, I256, REGISTERS_ARE_WIDE, Soft, pick, three, turn};
use crate::scalar::Scalar;
use crate::shape::AabbForm;

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
}

/// The widths that [`Units`] allows: of a number, and of the reach of a shape beyond another.
///
/// A side is below 2^61 and a coordinate of a cross product below 2^123. Its product with a reach
/// is below 2^249, and a sum of three such products below 2^251.
const WIDTH: i32 = 60;
const REACH: i32 = 126;

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
        if places.width() > WIDTH || axes.width() > WIDTH || halves.width() > WIDTH {
            return None;
        }
        // If all numbers are zero, every power of two is a unit.
        let low = |bits: Bits| if bits.width() > 0 { bits.low } else { 0 };
        let one = i32::from(S::ONE.shift);
        let (of_places, of_reach) = (low(places) + one, low(axes) + low(halves));
        let has_reach = axes.width() > 0 && halves.width() > 0;
        let ends = if has_reach { of_places.min(of_reach) } else { of_places };
        let up = [of_places - ends, if has_reach { of_reach - ends } else { 0 }];
        // Each shape has twice a place, and twice a half-extent or three products; then their sum.
        let widths = [places.width() + 3 + up[0], axes.width() + halves.width() + 4 + up[1]];
        let fits = widths.into_iter().all(|width| width < REACH);
        fits.then(|| Self {
            places: low(places),
            axes: low(axes),
            halves: low(halves),
            ends,
            up: up.map(i32::unsigned_abs),
        })
    }

    fn point<S: Scalar>(point: [S; 3], low: i32) -> [i64; 3] {
        three(|i| point[i].parts().in_units(low))
    }

    /// Edge k of a triangle or axis k of a box, and its unit.
    fn side<S: Scalar>(&self, body: &Body<'_, S>, k: usize) -> ([i64; 3], i32) {
        match body {
            Body::Triangle(t) => {
                let v = t.points();
                let from = Self::point(*pick(&v, k), self.places);
                let to = Self::point(*pick(&v, turn(k).1), self.places);
                (three(|i| to[i] - from[i]), self.places)
            }
            Body::Aabb(_) => {
                let mut axis = [0; 3];
                axis[k % 3] = 1;
                (axis, S::ONE.shift.into())
            }
            Body::Obb(obb) => (Self::point(pick(obb.axes(), k).to_array(), self.axes), self.axes),
        }
    }

    /// Twice the farthest place of a shape along the direction, from its centre or from one of its
    /// vertices.
    fn end<S: Scalar>(
        &self,
        body: &Body<'_, S>,
        vertex: usize,
        along: &[Ordering; 3],
        is_upper: bool,
    ) -> [i128; 3] {
        let Place(p, q) = match body {
            Body::Triangle(t) => {
                let v = *pick(&t.points(), vertex);
                Place(v, v)
            }
            _ => body.origin(),
        };
        let [up, reach_up] = self.up;
        let (p, q) = (Self::point(p, self.places), Self::point(q, self.places));
        let place = |i: usize| {
            let place = i128::from(p[i] + q[i]) << up;
            if is_upper { -place } else { place }
        };
        let mut end = three(place);
        let sign = |k: usize| *pick(along, k) as i64;
        match body {
            Body::Triangle(_) => {}
            Body::Aabb(aabb) => {
                let twice = match aabb.form() {
                    AabbForm::Center { half, .. } => {
                        let half = Self::point(half.to_array(), self.places);
                        three(|k| 2 * half[k])
                    }
                    AabbForm::Corners { .. } => three(|k| q[k] - p[k]),
                };
                for k in 0..3 {
                    end[k] += i128::from(sign(k) * twice[k]) << up;
                }
            }
            Body::Obb(obb) => {
                let half = Self::point(obb.half_extents().to_array(), self.halves);
                for k in 0..3 {
                    let (side, _) = self.side(body, k);
                    let twice = i128::from(2 * sign(k) * half[k]);
                    for i in 0..3 {
                        end[i] += (twice * i128::from(side[i])) << reach_up;
                    }
                }
            }
        }
        end
    }
}

/// A direction in whole numbers.
pub(super) struct Whole<'a, S> {
    units: &'a Units,
    bodies: &'a [Body<'a, S>; 2],
    direction: [i128; 3],
    unit: i32,
}

impl<'a, S: Scalar> Whole<'a, S> {
    pub(super) fn new(
        units: &'a Units,
        bodies: &'a [Body<'a, S>; 2],
        own: [(usize, usize); 2],
    ) -> Self {
        let side = |(shape, k): (usize, usize)| units.side(&bodies[shape % 2], k);
        let ((x, x_unit), (y, y_unit)) = (side(own[0]), side(own[1]));
        let minor = |j: usize, k: usize| {
            i128::from(x[j]) * i128::from(y[k]) - i128::from(x[k]) * i128::from(y[j])
        };
        let direction = [minor(1, 2), minor(2, 0), minor(0, 1)];
        Self { units, bodies, direction, unit: x_unit + y_unit }
    }

    fn dot(&self, x: impl Fn(usize) -> I256) -> I256 {
        x(0) + x(1) + x(2)
    }
}

fn sign_of(x: I256) -> Ordering {
    x.cmp(&I256::from(0))
}

impl<S: Scalar> Given for Whole<'_, S> {
    fn coordinates(&self) -> [Option<(Ordering, Soft)>; 3] {
        three(|i| {
            let x = self.direction[i];
            let size = x.unsigned_abs();
            let size = Soft::of_limbs(&[size as u64, (size >> 64) as u64])?.scaled(self.unit);
            Some((x.cmp(&0), size))
        })
    }

    fn side(&self, shape: usize, k: usize) -> Ordering {
        let (side, _) = self.units.side(&self.bodies[shape % 2], k);
        sign_of(self.dot(|i| I256::product(self.direction[i], side[i])))
    }

    fn overlap(&self, along: &[[Ordering; 3]; 2], vertices: [usize; 2], lower: usize) -> Size {
        let end = |shape: usize| {
            let is_upper = shape != lower;
            self.units.end(&self.bodies[shape], vertices[shape], &along[shape], is_upper)
        };
        let (a, b) = (end(0), end(1));
        let sum = self.dot(|i| I256::of_two(self.direction[i], a[i] + b[i]));
        let (is_negative, limbs) = sum.limbs();
        if is_negative {
            None
        } else {
            Some(Soft::of_limbs(&limbs)?.scaled(self.unit + self.units.ends))
        }
    }
}
