//! Triangles and boxes whose gap or overlap is the least possible for integers of their length: one
//! unit of volume along the normal, or of area across two edges.

use super::case::{BoxNumbers, Case};
use super::lattice::Ring;
use super::rng::Rng;
use super::sample::Sample;
use crate::{Each, three};

type Point = [i128; 3];

/// Integers; the numbers of the type are these times a power of two for each axis, which changes no
/// verdict.
#[derive(Clone, Copy, Debug)]
pub struct NearMiss {
    vertices: [Point; 3],
    center: Point,
    half: Point,
    /// Whether triangle and box meet.
    pub meets: bool,
}

impl NearMiss {
    /// The most bits that the numbers of a case may have in the scalar.
    const MOST_BITS: u32 = 26;

    /// Any kind of case, with a gap of 1, 0 or −1.
    pub fn any<S: Sample>(rng: &mut Rng) -> Self {
        let most = S::WHOLE_BITS.min(Self::MOST_BITS) - 4;
        loop {
            // Short numbers are exact at an earlier stage than long ones.
            let all = rng.whole(1, most.into());
            let size = rng.triple(|rng| 1 << rng.whole(1, all));
            let gap = whole(rng, -1, 1);
            let found =
                if rng.one_in(2) { Self::face(rng, size, gap) } else { Self::edge(rng, size, gap) };
            if let Some(case) = found {
                return case.reflected(rng).moved(rng, size);
            }
        }
    }

    /// A corner of the box near the triangle's interior, `gap` units of volume from its plane.
    /// `None` if no integers are that near.
    fn face(rng: &mut Rng, size: Point, gap: i128) -> Option<Self> {
        let mut edge = || size.each(|most| whole(rng, -most, most));
        let (e1, e2) = (edge(), edge());
        let n = Ring::cross(&e1, &e2);
        if n.contains(&0) {
            return None;
        }
        // n·s = gap, with s no longer than both edges together.
        let (first, x, y) = bezout(n[0], n[1]);
        let (all, p, q) = bezout(first, n[2]);
        if all.abs() != 1 {
            return None;
        }
        let s = [x * p, y * p, q].each(|x| x * all * gap);
        let k = (0..3).max_by_key(|&k| n[k].abs())?;
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        // The coordinates of s along both edges, times the area.
        let (area, sign) = (n[k].abs(), n[k].signum());
        let of1 = sign * (s[i] * e2[j] - s[j] * e2[i]);
        let of2 = sign * (e1[i] * s[j] - e1[j] * s[i]);
        let (whole1, whole2) = (of1.div_euclid(area), of2.div_euclid(area));
        let s = three(|i| s[i] - whole1 * e1[i] - whole2 * e2[i]);

        let half = size.each(|most| whole(rng, 1, most));
        let a = three(|i| half[i] * n[i].signum() + s[i]);
        let [b, c] = [Ring::difference(&a, &e1), Ring::difference(&a, &e2)];
        // Whether s is in the triangle's half of the parallelogram of both edges.
        let is_near = of1 + of2 - (whole1 + whole2) * area <= area;
        let a = if is_near { a } else { Ring::difference(&b, &e2) };
        Some(Self { vertices: [a, b, c], center: [0; 3], half, meets: gap <= 0 })
    }

    /// An edge across an edge of the box, `gap` units of area from it.
    fn edge(rng: &mut Rng, size: Point, gap: i128) -> Option<Self> {
        let (i, j, k) = [(0, 1, 2), (1, 2, 0), (2, 0, 1)][rng.below(3)];
        let half = size.each(|most| whole(rng, 1, most));
        let (along, down) = (whole(rng, 1, size[i]), whole(rng, 1, size[j]));
        // down·x + along·y = gap, with 0 ≤ x < along.
        let (all, x, _) = bezout(down, along);
        if all != 1 {
            return None;
        }
        let x = (x * gap).rem_euclid(along);
        let y = (gap - down * x) / along;
        let within = |rng: &mut Rng| whole(rng, -half[k] / 2, half[k] / 2);
        let point = |x, y, z| {
            let mut point = [z; 3];
            (point[i], point[j]) = (x, y);
            point
        };
        let a = point(half[i] + x, half[j] + y, within(rng));
        let b = point(a[i] - along, a[j] + down, within(rng));
        let outward = size.each(|most| whole(rng, 1, most));
        let c = three(|i| a[i] + outward[i]);
        Some(Self { vertices: [a, b, c], center: [0; 3], half, meets: gap <= 0 })
    }

    /// Reflected along some axes.
    fn reflected(mut self, rng: &mut Rng) -> Self {
        for i in (0..3).filter(|_| rng.one_in(2)) {
            self.vertices.iter_mut().for_each(|p| p[i] = -p[i]);
        }
        self
    }

    /// Every second case is moved to another place.
    fn moved(mut self, rng: &mut Rng, size: Point) -> Self {
        if rng.one_in(2) {
            self.center = size.each(|most| whole(rng, -2 * most, 2 * most));
            self.vertices = self.vertices.each(|p| three(|i| p[i] + self.center[i]));
        }
        self
    }

    /// The case in the scalar, with the box by its centre or its corners, at any magnitude of the
    /// scalar.
    pub fn case<S: Sample>(&self, rng: &mut Rng, by_center: bool) -> Case<S> {
        let exponents = self.exponents::<S>(rng);
        let scaled = |p: Point| {
            three(|i| {
                // As two factors, because the power alone may be out of range.
                let e = exponents[i];
                S::nearest(p[i] as f64 * 2_f64.powi(e / 2) * 2_f64.powi(e - e / 2))
            })
        };
        let aabb = if by_center {
            BoxNumbers::Center(scaled(self.center), scaled(self.half))
        } else {
            BoxNumbers::Corners(scaled(self.corner(-1)), scaled(self.corner(1)))
        };
        Case { vertices: self.vertices.each(scaled), aabb }
    }

    /// The least corner of the box (sign −1), or the greatest (1).
    fn corner(&self, sign: i128) -> Point {
        three(|i| self.center[i] + sign * self.half[i])
    }

    /// The exponents of the axes: equal, nearly equal, arbitrary, or at either end of the range.
    fn exponents<S: Sample>(&self, rng: &mut Rng) -> [i32; 3] {
        let corners = [-1, 1].each(|sign| self.corner(sign));
        let greatest = |i: usize| {
            let all = self.vertices.iter().chain(&corners).map(|p| p[i].abs());
            all.max().expect("five points")
        };
        let bits = |x: i128| (i128::BITS - x.leading_zeros()) as i32;
        let least = S::from_ordinal(1).mantissa_exponent().1;
        let (mantissa, exponent) = S::GREATEST.mantissa_exponent();
        let most = three(|i| bits(mantissa.into()) + exponent - bits(greatest(i)));
        let one = rng.whole(least.into(), most.into_iter().min().expect("three").into()) as i32;
        let kind = rng.below(4);
        most.each(|most| match kind {
            0 => one,
            1 => rng.whole(one.saturating_sub(9).max(least).into(), (one + 9).min(most).into())
                as i32,
            2 => rng.whole(least.into(), most.into()) as i32,
            _ => [least, most][rng.below(2)],
        })
    }
}

/// The greatest common divisor, up to its sign, as a sum of multiples of both.
fn bezout(a: i128, b: i128) -> (i128, i128, i128) {
    if b == 0 {
        return (a, 1, 0);
    }
    let (divisor, x, y) = bezout(b, a % b);
    (divisor, y, x - a / b * y)
}

/// A number from `low` to `high`, both included and at most 64 bits long.
fn whole(rng: &mut Rng, low: i128, high: i128) -> i128 {
    rng.whole(low as i64, high as i64).into()
}
