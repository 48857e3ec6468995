//! The exact numbers of a direction as integers: in 60 bits, as in most scenes, or in 250 bits, as
//! for poses with residues of quarter turns. The results equal [`sums`](super::sums) and take a
//! fraction of the time.

use core::cmp::Ordering;

use super::body::Body;
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
        if up == 0 { x } else { x.shifted_up(up as usize) }
    }
    fn volume(x: BigInt<8>, y: BigInt<4>) -> BigInt<12> {
        x.times(&y)
    }
    #[inline(never)]
    fn fourth(x: BigInt<8>, y: BigInt<8>) -> BigInt<16> {
        x.times(&y)
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

    /// Both shapes in integers.
    #[inline(never)]
    pub(super) fn shapes<N: Integers, S: Scalar>(&self, bodies: &[Body<'_, S>; 2]) -> Shapes<N> {
        let [first, second] = bodies;
        Shapes { shapes: [self.shape(first), self.shape(second)], ends: self.ends }
    }

    fn shape<N: Integers, S: Scalar>(&self, body: &Body<'_, S>) -> Shape<N> {
        let in_units = |x: [S; 3], low: i32| three(|i| N::length(x[i].parts(), low));
        let point = |p: [S; 3]| in_units(p, self.places);
        let twice = |p: [N::Length; 3]| three(|i| p[i] + p[i]);
        let raised = |x: N::Length| N::raised(N::widened(x), self.up[0]);
        let zero = [[N::Area::ZERO; 3]; 3];
        match body {
            Body::Triangle(t) => {
                let v = t.points().map(point);
                let edge = |k: usize| {
                    let (from, to) = (pick(&v, k), pick(&v, turn(k).1));
                    three(|i| to[i] - from[i])
                };
                let ends = three(|k| twice(v[k]).map(raised));
                Shape { sides: three(edge), unit: self.places, ends, reach: zero }
            }
            Body::Aabb(aabb) => {
                let unit = i32::from(S::ONE.shift);
                let (mut sides, mut reach) = ([[N::Length::ZERO; 3]; 3], zero);
                let (end, half) = match aabb.form() {
                    AabbForm::Center { center, half } => {
                        (twice(point(center.to_array())), twice(point(half.to_array())))
                    }
                    AabbForm::Corners { min, max } => {
                        let (p, q) = (point(min.to_array()), point(max.to_array()));
                        (three(|i| p[i] + q[i]), three(|i| q[i] - p[i]))
                    }
                };
                for k in 0..3 {
                    sides[k][k] = N::length(S::ONE, unit);
                    reach[k][k] = raised(half[k]);
                }
                Shape { sides, unit, ends: [end.map(raised); 3], reach }
            }
            Body::Obb(obb) => {
                let sides = three(|k| in_units(obb.axes()[k].to_array(), self.axes));
                let half = twice(in_units(obb.half_extents().to_array(), self.halves));
                let reach =
                    three(|k| three(|i| N::raised(N::area(half[k], sides[k][i]), self.up[1])));
                let end = twice(point(obb.center().to_array())).map(raised);
                Shape { sides, unit: self.axes, ends: [end; 3], reach }
            }
        }
    }
}

/// A shape in integers.
struct Shape<N: Integers> {
    /// The edges of a triangle, or the axes of a box.
    sides: [[N::Length; 3]; 3],
    /// The unit of `sides`.
    unit: i32,
    /// Twice the vertices, or twice the centre of a box.
    ends: [[N::Area; 3]; 3],
    /// The axes times twice the half-extents.
    reach: [[N::Area; 3]; 3],
}

/// Two shapes in integers.
pub(super) struct Shapes<N: Integers> {
    shapes: [Shape<N>; 2],
    /// The unit of ends.
    ends: i32,
}

impl<N: Integers> Shape<N> {
    /// Adds twice the farthest place of the shape along the direction, or subtracts the nearest.
    fn add_end(
        &self,
        sum: &mut [N::Area; 3],
        vertex: usize,
        along: &[Ordering; 3],
        is_upper: bool,
    ) {
        let mut add = |x: &[N::Area; 3], is_negative: bool| {
            for (sum, &x) in sum.iter_mut().zip(x) {
                *sum = if is_negative { *sum - x } else { *sum + x };
            }
        };
        add(pick(&self.ends, vertex), is_upper);
        for (reach, along) in self.reach.iter().zip(along).filter(|(_, along)| along.is_ne()) {
            add(reach, along.is_lt());
        }
    }
}

/// A direction in integers.
pub(super) struct Whole<'a, N: Integers> {
    shapes: &'a Shapes<N>,
    direction: [N::Area; 3],
    unit: i32,
}

impl<'a, N: Integers> Whole<'a, N> {
    pub(super) fn new(shapes: &'a Shapes<N>, own: [(usize, usize); 2]) -> Self {
        let side = |(shape, k): (usize, usize)| {
            let shape = &shapes.shapes[shape % 2];
            (pick(&shape.sides, k), shape.unit)
        };
        let ((x, x_unit), (y, y_unit)) = (side(own[0]), side(own[1]));
        let direction = three(|i| {
            let (_, j, k) = turn(i);
            let area = |j: usize, k: usize| N::area(*pick(x, j), *pick(y, k));
            area(j, k) - area(k, j)
        });
        Self { shapes, direction, unit: x_unit + y_unit }
    }
}

impl<N: Integers> Given for Whole<'_, N> {
    fn coordinates(&self) -> [Option<(Ordering, Soft)>; 3] {
        three(|i| {
            let (sign, size) = self.direction[i].sign_and_size()?;
            Some((sign, size.scaled(self.unit)))
        })
    }

    fn side(&self, shape: usize, k: usize) -> Ordering {
        let side = pick(&self.shapes.shapes[shape % 2].sides, k);
        let [x, y, z] = three(|i| N::volume(self.direction[i], side[i]));
        compare(x + y + z, N::Volume::ZERO)
    }

    fn overlap(&self, along: &[[Ordering; 3]; 2], vertices: [usize; 2], lower: usize) -> Size {
        let mut reach = [N::Area::ZERO; 3];
        for (k, shape) in self.shapes.shapes.iter().enumerate() {
            shape.add_end(&mut reach, vertices[k], &along[k], k != lower);
        }
        let [x, y, z] = three(|i| N::fourth(self.direction[i], reach[i]));
        let (sign, size) = (x + y + z).sign_and_size()?;
        sign.is_gt().then(|| size.scaled(self.unit + self.shapes.ends))
    }
}
