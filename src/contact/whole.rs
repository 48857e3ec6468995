//! The exact numbers of a direction as integers: in 60 bits, as in most scenes, or in 250 bits, as
//! for poses with residues of quarter turns; on small cores, in words. The results equal
//! the [sums](super::exact::Sums) and take a fraction of the time.

use core::cmp::Ordering;

use super::body::Body;
use super::exact::{Given, Size};
use super::integers::{Integers, Long, Short, Words, has_words, is_short, is_whole};
use crate::arithmetic::{Bits, Each, Number, REGISTERS_ARE_WIDE, Soft, pick, three, turn};
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
    /// How far places, axes times half-extents, and half-extents of axis-aligned boxes are shifted up to
    /// that unit.
    up: [u32; 3],
    /// Whether [`Short`] holds everything. If not, [`Long`] does.
    pub(super) are_short: bool,
    /// Whether [`Words`] hold axes and their half-extents.
    are_words: bool,
}

/// What `with` makes of all places of two shapes, of their axes and of their half-extents.
pub(super) fn gathered<S: Scalar, T: Copy>(
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
    /// The units of a scalar that [`is_whole`](super::integers::is_whole), in [`Words`].
    pub(super) fn of_words<S: Scalar>() -> Self {
        let up = [S::ONE.shift.into(), 0, 0];
        Self {
            places: 0,
            axes: 0,
            halves: 0,
            ends: 0,
            ones: 0,
            up,
            are_short: true,
            are_words: true,
        }
    }

    /// The units, if the numbers are short enough; on small cores, for a scalar that [`has_words`], in [`Words`].
    #[cfg_attr(not(target_pointer_width = "64"), inline(never))]
    pub(super) fn new<S: Scalar>(bodies: &[Body<'_, S>; 2]) -> Option<Self> {
        if !REGISTERS_ARE_WIDE && !has_words::<S>() {
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
        let up = [of_places - ends, if has_reach { of_reach - ends } else { 0 }, of_places - ends];
        // Each shape has twice a place, and twice a half-extent or three products; then their sum.
        let reach = (places.width() + 3 + up[0]).max(axes.width() + halves.width() + 4 + up[1]);
        let width = places.width().max(axes.width()).max(halves.width());
        let are_short = width <= Short::WIDTH && reach < Short::REACH;
        let fits = are_short || width <= Long::WIDTH && reach < Long::REACH;
        let are_words = are_short && axes.width().max(halves.width()) < 32;
        fits.then(|| Self {
            places: low(places),
            axes: low(axes),
            halves: low(halves),
            ends,
            ones: one,
            up: up.each(i32::unsigned_abs),
            are_short,
            are_words,
        })
    }

    /// Both shapes in integers.
    pub(super) fn pair<N: Integers, S: Scalar>(&self, bodies: &[Body<'_, S>; 2]) -> Pair<N> {
        let mut new = Pair::NONE;
        self.fill(bodies, &mut new);
        new
    }

    /// In place, without a copy on the stack.
    #[inline(never)]
    pub(super) fn fill<N: Integers, S: Scalar>(
        &self,
        bodies: &[Body<'_, S>; 2],
        new: &mut Pair<N>,
    ) {
        new.are_triangles = [bodies[0].is_triangle(), bodies[1].is_triangle()];
        (new.up, new.unit) = (self.up[0], self.ends);
        let mut origin = [N::Length::ZERO; 3];
        for (n, body) in bodies.iter().enumerate() {
            let (sides, ends) = (&mut new.sides[n], &mut new.ends[n]);
            let (halves, unit, up) = (&mut new.halves[n], &mut new.units[n], &mut new.ups[n]);
            match body {
                Body::Triangle(t) => {
                    let v = t.vertices().each(|p| numbers::<N, S>(&p, self.places));
                    for k in 0..3 {
                        let (from, to) = (pick(&v, k), pick(&v, turn(k).1));
                        sides[k] = three(|i| to[i] - from[i]);
                        ends[k] = three(|i| from[i] + from[i]);
                    }
                    *unit = self.places;
                }
                Body::Aabb(aabb) => {
                    let (AabbForm::Center { center: p, half: q }
                    | AabbForm::Corners { min: p, max: q }) = aabb.form();
                    let (p, q) = (numbers::<N, S>(p, self.places), numbers::<N, S>(q, self.places));
                    let is_center = matches!(aabb.form(), AabbForm::Center { .. });
                    let one = N::length(S::ONE, self.ones);
                    for i in 0..3 {
                        sides[i][i] = one;
                        (ends[0][i], halves[i]) = if is_center {
                            (p[i] + p[i], q[i] + q[i])
                        } else {
                            (p[i] + q[i], q[i] - p[i])
                        };
                    }
                    (*unit, *up) = (self.ones, self.up[2]);
                }
                Body::Obb(obb) => {
                    let center = numbers::<N, S>(&obb.center(), self.places);
                    let half = numbers::<N, S>(&obb.half_extents(), self.halves);
                    (ends[0], *halves) = (center.each(|x| x + x), half.each(|x| x + x));
                    for (side, axis) in sides.iter_mut().zip(obb.axes()) {
                        *side = numbers::<N, S>(axis, self.axes);
                    }
                    (*unit, *up) = (self.axes, self.up[1]);
                }
            }
            origin = ends[0];
        }
        for (ends, is_triangle) in new.ends.iter_mut().zip(new.are_triangles) {
            for end in ends.iter_mut().take(if is_triangle { 3 } else { 1 }) {
                *end = three(|i| end[i] - origin[i]);
            }
        }
    }
}

#[inline(never)]
fn numbers<N: Integers, S: Scalar>(v: &Vec3<S>, low: i32) -> [N::Length; 3] {
    // Known to the compiler.
    let low = if has_words::<S>() && is_whole::<S>() { 0 } else { low };
    let mut all = [N::Length::ZERO; 3];
    for (to, x) in all.iter_mut().zip(v.to_array()) {
        *to = N::length(x.parts(), low);
    }
    all
}

/// Fills in two shapes of a scalar that [`has_words`], if words hold them.
pub(super) fn in_words<S: Scalar>(bodies: &[Body<'_, S>; 2], pair: &mut Pair<Words>) -> bool {
    let units = if is_whole::<S>() { Some(Units::of_words::<S>()) } else { Units::new(bodies) };
    let Some(units) = units.filter(|units| units.are_words) else { return false };
    units.fill(bodies, pair);
    is_whole::<S>() || pair.is_held()
}

/// Two shapes in integers.
pub(super) struct Pair<N: Integers> {
    pub(super) are_triangles: [bool; 2],
    /// The edges of a triangle, or the axes of a box: in words at most 2^32.
    pub(super) sides: [[[N::Length; 3]; 3]; 2],
    /// The units of `sides`.
    units: [i32; 2],
    /// Twice the vertices, or twice the centre of a box and zeros, from the second shape's first: in
    /// words at most 2^33.
    pub(super) ends: [[[N::Length; 3]; 3]; 2],
    /// Twice the half-extents of a box: in words below 2^32.
    pub(super) halves: [[N::Length; 3]; 2],
    /// How far ends are shifted up to the unit of positions along a direction.
    pub(super) up: u32,
    /// How far axes times half-extents are.
    pub(super) ups: [u32; 2],
    /// This unit.
    unit: i32,
}

impl<N: Integers> Pair<N> {
    pub(super) const NONE: Self = Self {
        are_triangles: [false; 2],
        sides: [[[N::Length::ZERO; 3]; 3]; 2],
        units: [0; 2],
        ends: [[[N::Length::ZERO; 3]; 3]; 2],
        halves: [[N::Length::ZERO; 3]; 2],
        up: 0,
        ups: [0; 2],
        unit: 0,
    };

    pub(super) fn along(&self, numbers: [u8; 2]) -> Along<'_, N> {
        let own = numbers.each(|n| if n < 3 { (0, n.into()) } else { (1, usize::from(n) - 3) });
        let [x, y] = own.each(|(shape, k): (usize, usize)| pick(&self.sides[shape % 2], k));
        let direction = three(|i| {
            let (_, j, k) = turn(i);
            N::area(*pick(x, j), *pick(y, k)) - N::area(*pick(x, k), *pick(y, j))
        });
        let [x, y] = own.each(|(shape, _)| self.units[shape % 2]);
        Along { pair: self, direction, unit: x + y }
    }
}

impl Pair<Words> {
    /// Whether [`Words`] hold all numbers, of units that `are_words`.
    pub(super) fn is_held(&self) -> bool {
        let bits = |v: &[[i64; 3]]| {
            let size = v.as_flattened().iter().fold(0, |all, &x| all | x.unsigned_abs());
            64 - size.leading_zeros()
        };
        self.up < 63
            && (0..2).all(|n| {
                let [sides, ends] = [&self.sides[n], &self.ends[n]].each(|v| bits(v));
                let halves = bits(&[self.halves[n]]);
                let reach = if halves == 0 { 0 } else { sides + halves + self.ups[n] };
                sides <= 32 && ends <= 33 && halves <= 32 && reach <= 86 && ends + self.up <= 87
            })
    }
}

/// A direction in integers.
pub(super) struct Along<'a, N: Integers> {
    pair: &'a Pair<N>,
    /// In words below 2^66.
    direction: [N::Area; 3],
    unit: i32,
}

impl Along<'_, Words> {
    /// The leading bits, rounded down; `None` if the direction is zero.
    pub(super) fn cut(&self, places: i32) -> Option<[i32; 3]> {
        let all = self.direction.iter().fold(0, |all, x| all | x ^ x >> 127);
        let short = self.direction.each(|x| if is_short(all) { x } else { x >> 32 } as i64);
        let size = short.iter().fold(0, |all, x| all | x ^ x >> 63);
        let down = 64 - size.leading_zeros() as i32 - places;
        let is_zero = self.direction == [0; 3];
        (!is_zero).then(|| short.each(|x| if down > 0 { x >> down } else { x << -down } as i32))
    }
}

impl<N: Integers> Given for Along<'_, N> {
    fn coordinates(&self) -> [Option<(Ordering, Soft)>; 3] {
        let mut all = [None; 3];
        for (to, x) in all.iter_mut().zip(self.direction) {
            *to = x.sign_and_size().map(|(sign, size)| (sign, size.scaled(self.unit)));
        }
        all
    }

    fn side(&self, shape: usize, k: usize) -> Ordering {
        N::side(&self.direction, pick(&self.pair.sides[shape % 2], k))
    }

    fn overlap(&self, along: &[[Ordering; 3]; 2], vertices: [usize; 2], lower: usize) -> Size {
        let pair = self.pair;
        let mut reach = [N::Area::ZERO; 3];
        for n in 0..2 {
            let vertex = if pair.are_triangles[n] { vertices[n] } else { 0 };
            let ends = reach.iter_mut().zip(pick(&pair.ends[n], vertex));
            for (sum, &x) in ends.filter(|(_, x)| !x.is_zero()) {
                *sum = *sum + N::placed(if n == lower { x } else { -x }, pair.up);
            }
            for ((v, &half), along) in pair.sides[n].iter().zip(&pair.halves[n]).zip(along[n]) {
                if along.is_eq() || half.is_zero() {
                    continue;
                }
                let half = if along.is_lt() { -half } else { half };
                for (sum, &x) in reach.iter_mut().zip(v).filter(|(_, x)| !x.is_zero()) {
                    *sum = *sum + N::raised(N::area(x, half), pair.ups[n]);
                }
            }
        }
        N::size(&self.direction, &reach).map(|size| size.scaled(self.unit + pair.unit))
    }
}
