//! The exact numbers of a direction as integers: in 60 bits, as in most scenes, or in 250 bits, as
//! for poses with residues of quarter turns. The results equal [`sums`](super::sums) and take a fraction of
//! the time. Small cores have [`fixed_pair`](super::fixed_pair).

use core::cmp::Ordering;

use super::body::Body;
use super::exact::{Given, Size};
use super::integers::{Integers, Long, Short};
use crate::arithmetic::{Bits, Number, REGISTERS_ARE_WIDE, Soft, compare, pick, three, turn};
use crate::scalar::Scalar;
use crate::shape::{AabbForm, Vec3};

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
    /// The unit of the axes of axis-aligned boxes.
    ones: i32,
    /// How far the two kinds of terms are shifted up to that unit.
    up: [u32; 2],
    /// Whether [`Short`] holds everything. If not, [`Long`] does.
    pub(super) are_short: bool,
}

/// What `with` makes of all places of two shapes, of their axes and of their half-extents.
fn gathered<S: Scalar, T: Copy>(
    bodies: &[Body<'_, S>; 2],
    none: T,
    with: impl Fn(T, S) -> T,
) -> [T; 3] {
    let [mut places, mut axes, mut halves] = [none; 3];
    let add = |all: &mut T, point: Vec3<S>| *all = point.to_array().into_iter().fold(*all, &with);
    for body in bodies {
        match body {
            Body::Triangle(t) => t.vertices().iter().for_each(|p| add(&mut places, *p)),
            Body::Aabb(aabb) => {
                let (AabbForm::Center { center: p, half: q }
                | AabbForm::Corners { min: p, max: q }) = aabb.form();
                add(&mut places, *p);
                add(&mut places, *q);
            }
            Body::Obb(obb) => {
                add(&mut places, obb.center());
                obb.axes().iter().for_each(|u| add(&mut axes, *u));
                add(&mut halves, obb.half_extents());
            }
        }
    }
    [places, axes, halves]
}

impl Units {
    /// The units, if the numbers are short enough, and the machine multiplies long words.
    pub(super) fn new<S: Scalar>(bodies: &[Body<'_, S>; 2]) -> Option<Self> {
        if !REGISTERS_ARE_WIDE {
            return None;
        }
        let [places, axes, halves] =
            gathered(bodies, Bits::NONE, |bits, x: S| bits.with(x.parts()));
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
            ones: one,
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
        let point = |p: [S; 3]| in_units::<N, S>(&p, self.places);
        let raised = |x: [N::Length; 3]| {
            let mut all = [N::Area::ZERO; 3];
            for (to, x) in all.iter_mut().zip(x) {
                *to = N::raised(N::widened(x), self.up[0]);
            }
            all
        };
        let twice = |p: [N::Length; 3]| three(|i| p[i] + p[i]);
        let (mut sides, mut reach) = ([[N::Length::ZERO; 3]; 3], [[N::Area::ZERO; 3]; 3]);
        match body {
            Body::Triangle(t) => {
                let v = t.points().map(point);
                for (k, side) in sides.iter_mut().enumerate() {
                    let (from, to) = (pick(&v, k), pick(&v, turn(k).1));
                    *side = three(|i| to[i] - from[i]);
                }
                Shape { sides, unit: self.places, ends: v.map(|v| raised(twice(v))), reach }
            }
            Body::Aabb(aabb) => {
                let unit = self.ones;
                let (AabbForm::Center { center: p, half: q }
                | AabbForm::Corners { min: p, max: q }) = aabb.form();
                let (p, q) = (point(p.to_array()), point(q.to_array()));
                let (end, half) = match aabb.form() {
                    AabbForm::Center { .. } => (twice(p), twice(q)),
                    AabbForm::Corners { .. } => (three(|i| p[i] + q[i]), three(|i| q[i] - p[i])),
                };
                let (end, half) = (raised(end), raised(half));
                for k in 0..3 {
                    sides[k][k] = N::length(S::ONE, unit);
                    reach[k][k] = half[k];
                }
                Shape { sides, unit, ends: [end; 3], reach }
            }
            Body::Obb(obb) => {
                let half = twice(in_units::<N, S>(&obb.half_extents().to_array(), self.halves));
                for (k, (side, reach)) in sides.iter_mut().zip(&mut reach).enumerate() {
                    *side = in_units::<N, S>(&obb.axes()[k].to_array(), self.axes);
                    for (reach, side) in reach.iter_mut().zip(side) {
                        *reach = N::raised(N::area(half[k], *side), self.up[1]);
                    }
                }
                let end = raised(twice(point(obb.center().to_array())));
                Shape { sides, unit: self.axes, ends: [end; 3], reach }
            }
        }
    }
}

/// Three numbers in units of 2^`low`.
fn in_units<N: Integers, S: Scalar>(x: &[S; 3], low: i32) -> [N::Length; 3] {
    three(|i| N::length(x[i].parts(), low))
}

/// A shape in integers.
pub(super) struct Shape<N: Integers> {
    /// The edges of a triangle, or the axes of a box.
    pub(super) sides: [[N::Length; 3]; 3],
    /// The unit of `sides`.
    unit: i32,
    /// Twice the vertices, or twice the centre of a box.
    pub(super) ends: [[N::Area; 3]; 3],
    /// The axes times twice the half-extents.
    pub(super) reach: [[N::Area; 3]; 3],
}

/// Two shapes in integers.
pub(super) struct Shapes<N: Integers> {
    pub(super) shapes: [Shape<N>; 2],
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
