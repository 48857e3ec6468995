//! Two shapes as integers in units of the scalar's least number, and the exact numbers of a direction from
//! them: on small cores, where [`whole`](super::whole) would take a copy for each length of integers.

use core::cmp::Ordering;
use core::mem::size_of;

use super::body::Body;
use super::directions::Direction;
use super::exact::{Given, Size};
use crate::arithmetic::{Number, Parts, REGISTERS_ARE_WIDE, Soft, of_four, pick, three, turn};
use crate::scalar::Scalar;
use crate::shape::{AabbForm, Vec3};

/// Whether all numbers of a scalar are integers of a few words, on a core that computes floats by
/// functions. Such a contact has its direction without floats and without long sums.
pub(super) const fn is_whole<S: Scalar>() -> bool {
    !REGISTERS_ARE_WIDE && size_of::<S>() <= size_of::<u32>() && S::FLOAT.is_none()
}

/// Two shapes in units of the least number of a scalar that [`is_whole`].
pub(super) struct FixedPair {
    pub(super) are_triangles: [bool; 2],
    /// The edges of a triangle, or the axes of a box: at most 2^32.
    pub(super) sides: [[[i64; 3]; 3]; 2],
    /// Twice the vertices, or twice the centre of a box and zeros, from the second shape's first: at
    /// most 2^33.
    pub(super) ends: [[[i64; 3]; 3]; 2],
    /// Twice the half-extents of a box: below 2^32.
    pub(super) halves: [[i64; 3]; 2],
    /// How far an end is shifted up to the unit of axes times half-extents.
    pub(super) up: u32,
}

impl FixedPair {
    #[inline(never)]
    pub(super) fn new<S: Scalar>(bodies: &[Body<'_, S>; 2]) -> Self {
        let one = number(S::ONE);
        let mut new = Self {
            are_triangles: [bodies[0].is_triangle(), bodies[1].is_triangle()],
            sides: [[[0; 3]; 3]; 2],
            ends: [[[0; 3]; 3]; 2],
            halves: [[0; 3]; 2],
            up: one.trailing_zeros(),
        };
        let mut origin = [0; 3];
        for (n, body) in bodies.iter().enumerate() {
            let (sides, ends) = (&mut new.sides[n], &mut new.ends[n]);
            let halves = &mut new.halves[n];
            match body {
                Body::Triangle(t) => {
                    let v = t.vertices().map(|p| numbers(&p));
                    for k in 0..3 {
                        let (from, to) = (pick(&v, k), pick(&v, turn(k).1));
                        sides[k] = three(|i| to[i] - from[i]);
                        ends[k] = three(|i| 2 * from[i]);
                    }
                }
                Body::Aabb(aabb) => {
                    let (AabbForm::Center { center: p, half: q }
                    | AabbForm::Corners { min: p, max: q }) = aabb.form();
                    let (p, q) = (numbers(p), numbers(q));
                    let is_center = matches!(aabb.form(), AabbForm::Center { .. });
                    for i in 0..3 {
                        sides[i][i] = one;
                        (ends[0][i], halves[i]) = if is_center {
                            (2 * p[i], 2 * q[i])
                        } else {
                            (p[i] + q[i], q[i] - p[i])
                        };
                    }
                }
                Body::Obb(obb) => {
                    let (center, half) = (numbers(&obb.center()), numbers(&obb.half_extents()));
                    (ends[0], *halves) = (center.map(|x| 2 * x), half.map(|x| 2 * x));
                    for (side, axis) in sides.iter_mut().zip(obb.axes()) {
                        *side = numbers(axis);
                    }
                }
            }
            origin = ends[0];
        }
        for (ends, is_triangle) in new.ends.iter_mut().zip(new.are_triangles) {
            for end in ends.iter_mut().take(if is_triangle { 3 } else { 1 }) {
                *end = three(|i| end[i] - origin[i]);
            }
        }
        new
    }

    pub(super) fn along(&self, direction: Direction) -> Along<'_> {
        let own = direction.sides(self.are_triangles);
        let [x, y] = own.map(|(shape, k)| pick(&self.sides[shape % 2], k));
        let direction = three(|i| {
            let (_, j, k) = turn(i);
            wide(*pick(x, j), *pick(y, k)) - wide(*pick(x, k), *pick(y, j))
        });
        Along { shapes: self, direction }
    }
}

/// A number of a scalar that [`is_whole`], or one.
fn number(x: Parts) -> i64 {
    let size = (x.magnitude << x.shift) as i64;
    if x.negative { -size } else { size }
}

#[inline(never)]
fn numbers<S: Scalar>(v: &Vec3<S>) -> [i64; 3] {
    let mut all = [0; 3];
    for (to, x) in all.iter_mut().zip(v.to_array()) {
        *to = number(x.parts());
    }
    all
}

/// The product, by one word each if that suffices.
#[inline(never)]
pub(super) fn wide(x: i64, y: i64) -> i128 {
    let (a, b) = (x as i32, y as i32);
    if i64::from(a) == x && i64::from(b) == y {
        return (i64::from(a) * i64::from(b)).into();
    }
    of_four(x, y)
}

/// Whether 62 bits and a sign hold the number.
fn is_short(x: i128) -> bool {
    x >> 62 == x >> 127
}

/// A direction in exact numbers.
pub(super) struct Along<'a> {
    shapes: &'a FixedPair,
    /// Below 2^66.
    pub(super) direction: [i128; 3],
}

impl Along<'_> {
    /// The leading bits, rounded down; `None` if the direction is zero.
    pub(super) fn cut(&self, places: i32) -> Option<[i32; 3]> {
        let all = self.direction.iter().fold(0, |all, x| all | x ^ x >> 127);
        let short = self.direction.map(|x| if is_short(all) { x } else { x >> 32 } as i64);
        let size = short.iter().fold(0, |all, x| all | x ^ x >> 63);
        let down = 64 - size.leading_zeros() as i32 - places;
        let is_zero = self.direction == [0; 3];
        (!is_zero).then(|| short.map(|x| if down > 0 { x >> down } else { x << -down } as i32))
    }

    /// The product with a vector with coordinates below 2^68: a multiple of 2^32, and the rest.
    #[inline(never)]
    fn dot(&self, v: &[i128; 3]) -> (i128, u32) {
        let (mut upper, mut lower) = (0, 0);
        for (&a, &b) in self.direction.iter().zip(v) {
            // Three products are below 2^126.
            if is_short(a) && is_short(b) {
                lower += wide(a as i64, b as i64);
            } else {
                let [[a1, a0], [b1, b0]] = [a, b].map(|x| [(x >> 32) as i64, i64::from(x as u32)]);
                upper += (wide(a1, b1) << 32) + wide(a1, b0) + wide(a0, b1);
                lower += wide(a0, b0);
            }
        }
        (upper + (lower >> 32), lower as u32)
    }
}

impl Given for Along<'_> {
    fn coordinates(&self) -> [Option<(Ordering, Soft)>; 3] {
        let mut all = [None; 3];
        for (to, x) in all.iter_mut().zip(self.direction) {
            *to = x.sign_and_size();
        }
        all
    }

    fn side(&self, shape: usize, k: usize) -> Ordering {
        let side = pick(&self.shapes.sides[shape % 2], k);
        self.dot(&three(|i| side[i].into())).cmp(&(0, 0))
    }

    fn overlap(&self, along: &[[Ordering; 3]; 2], vertices: [usize; 2], lower: usize) -> Size {
        let shapes = self.shapes;
        let mut reach = [0; 3];
        for n in 0..2 {
            let mut add = |v: &[i64; 3], by: i64| {
                for (sum, &x) in reach.iter_mut().zip(v).filter(|(_, x)| **x != 0) {
                    *sum += wide(x, by);
                }
            };
            let one = 1 << shapes.up;
            let vertex = if shapes.are_triangles[n] { vertices[n] } else { 0 };
            add(pick(&shapes.ends[n], vertex), if n == lower { one } else { -one });
            for ((v, &half), along) in shapes.sides[n].iter().zip(&shapes.halves[n]).zip(along[n]) {
                match along {
                    Ordering::Less => add(v, -half),
                    Ordering::Equal => {}
                    Ordering::Greater => add(v, half),
                }
            }
        }
        let (upper, lower) = self.dot(&reach);
        if upper < 0 {
            return None;
        }
        let limbs =
            [(upper << 32) as u64 | u64::from(lower), (upper >> 32) as u64, (upper >> 96) as u64];
        Soft::of_limbs(&limbs)
    }
}
