//! Triangles and boxes that are apart, or in each other, by the least that whole numbers of their
//! length can be: one unit of volume along the normal, or of area across two edges.

use super::case::{BoxNumbers, Case};
use super::rng::Rng;
use super::sample::Sample;

/// Whole numbers: those of the type are these times a power of two, one for each axis. No verdict
/// depends on that.
#[derive(Clone, Copy, Debug)]
pub struct NearMiss {
    vertices: [[i64; 3]; 3],
    center: [i64; 3],
    half: [i64; 3],
    /// Whether triangle and box meet.
    pub meets: bool,
}

impl NearMiss {
    /// Bits that the numbers of a case may have in the scalar, at most.
    const MOST_BITS: u32 = 26;

    /// Any of them, with a gap of one, of nothing or of less than nothing.
    pub fn any<S: Sample>(rng: &mut Rng) -> Self {
        let most = S::WHOLE_BITS.min(Self::MOST_BITS) - 4;
        loop {
            // Short numbers are exact at an earlier stage than long ones.
            let all = rng.whole(1, most.into());
            let size = rng.triple(|rng| 1 << rng.whole(1, all));
            let gap = rng.whole(-1, 1);
            let found =
                if rng.one_in(2) { Self::face(rng, size, gap) } else { Self::edge(rng, size, gap) };
            if let Some(case) = found {
                return case.reflected(rng).moved(rng, size);
            }
        }
    }

    /// A corner of the box on the triangle's inside, `gap` units of volume from its plane. `None`
    /// where no whole numbers are so near to it.
    fn face(rng: &mut Rng, size: [i64; 3], gap: i64) -> Option<Self> {
        let mut edge = || size.map(|most| rng.whole(-most, most));
        let (e1, e2) = (edge(), edge());
        let n = cross(e1, e2);
        if n.contains(&0) {
            return None;
        }
        // n·s = gap, with s no longer than both edges.
        let (first, x, y) = bezout(n[0], n[1]);
        let (all, p, q) = bezout(first, n[2]);
        if all.abs() != 1 {
            return None;
        }
        let s = [x * p, y * p, q].map(|x| x * all * i128::from(gap));
        let k = (0..3).max_by_key(|&k| n[k].abs())?;
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let [along1, along2] = [e1, e2].map(|e| e.map(i128::from));
        // How much of each edge it has, in units of one divided by the area.
        let (area, sign) = (n[k].abs(), n[k].signum());
        let of1 = sign * (s[i] * along2[j] - s[j] * along2[i]);
        let of2 = sign * (along1[i] * s[j] - along1[j] * s[i]);
        let (whole1, whole2) = (of1.div_euclid(area), of2.div_euclid(area));
        let s = [0, 1, 2].map(|i| (s[i] - whole1 * along1[i] - whole2 * along2[i]) as i64);

        let half = size.map(|most| rng.whole(1, most));
        let a = [0, 1, 2].map(|i| half[i] * n[i].signum() as i64 + s[i]);
        let [b, c] = [minus(a, e1), minus(a, e2)];
        // In the parallelogram of the two edges, and in which half of it.
        let is_near = of1 + of2 - (whole1 + whole2) * area <= area;
        let a = if is_near { a } else { minus(b, e2) };
        Some(Self { vertices: [a, b, c], center: [0; 3], half, meets: gap <= 0 })
    }

    /// An edge across an edge of the box, `gap` units of area from it.
    fn edge(rng: &mut Rng, size: [i64; 3], gap: i64) -> Option<Self> {
        let (i, j, k) = [(0, 1, 2), (1, 2, 0), (2, 0, 1)][rng.below(3)];
        let half = size.map(|most| rng.whole(1, most));
        let (along, down) = (rng.whole(1, size[i]), rng.whole(1, size[j]));
        // down·x + along·y = gap, with 0 ≤ x < along.
        let (all, x, _) = bezout(down.into(), along.into());
        if all != 1 {
            return None;
        }
        let x = (x * i128::from(gap)).rem_euclid(along.into()) as i64;
        let y = (gap - down * x) / along;
        let within = |rng: &mut Rng| rng.whole(-half[k] / 2, half[k] / 2);
        let point = |x: i64, y: i64, z: i64| {
            let mut point = [z; 3];
            (point[i], point[j]) = (x, y);
            point
        };
        let a = point(half[i] + x, half[j] + y, within(rng));
        let b = point(a[i] - along, a[j] + down, within(rng));
        let outward = size.map(|most| rng.whole(1, most));
        let c = [0, 1, 2].map(|i| a[i] + outward[i]);
        Some(Self { vertices: [a, b, c], center: [0; 3], half, meets: gap <= 0 })
    }

    /// Turned over along some axes.
    fn reflected(mut self, rng: &mut Rng) -> Self {
        for i in (0..3).filter(|_| rng.one_in(2)) {
            self.vertices.iter_mut().for_each(|p| p[i] = -p[i]);
        }
        self
    }

    /// Every other one somewhere else.
    fn moved(mut self, rng: &mut Rng, size: [i64; 3]) -> Self {
        if rng.one_in(2) {
            self.center = size.map(|most| rng.whole(-2 * most, 2 * most));
            self.vertices = self.vertices.map(|p| [0, 1, 2].map(|i| p[i] + self.center[i]));
        }
        self
    }

    /// In numbers of the scalar, the box by its centre or its corners, at any magnitudes that it has.
    pub fn case<S: Sample>(&self, rng: &mut Rng, by_center: bool) -> Case<S> {
        let exponents = self.exponents::<S>(rng);
        let scaled = |p: [i64; 3]| {
            [0, 1, 2].map(|i| {
                // In two halves, for either alone is a number.
                let e = exponents[i];
                S::nearest(p[i] as f64 * 2_f64.powi(e / 2) * 2_f64.powi(e - e / 2))
            })
        };
        let corner = |sign: i64| [0, 1, 2].map(|i| self.center[i] + sign * self.half[i]);
        let aabb = if by_center {
            BoxNumbers::Center(scaled(self.center), scaled(self.half))
        } else {
            BoxNumbers::Corners(scaled(corner(-1)), scaled(corner(1)))
        };
        Case { vertices: self.vertices.map(scaled), aabb }
    }

    /// What the axes' numbers are multiplied by: alike, nearly alike, anything, or either end of what
    /// there is.
    fn exponents<S: Sample>(&self, rng: &mut Rng) -> [i32; 3] {
        let corners = [minus(self.center, self.half), minus(self.half, self.center.map(|x| -x))];
        let greatest = |i: usize| {
            let all = self.vertices.iter().chain(&corners).map(|p| p[i].abs());
            all.max().expect("five points")
        };
        let bits = |x: i64| (i64::BITS - x.unsigned_abs().leading_zeros()) as i32;
        let least = S::from_ordinal(1).mantissa_exponent().1;
        let (mantissa, exponent) = S::GREATEST.mantissa_exponent();
        let most = [0, 1, 2].map(|i| bits(mantissa) + exponent - bits(greatest(i)));
        let one = rng.whole(least.into(), most.into_iter().min().expect("three").into()) as i32;
        let kind = rng.below(4);
        most.map(|most| match kind {
            0 => one,
            1 => rng.whole(one.saturating_sub(9).max(least).into(), (one + 9).min(most).into())
                as i32,
            2 => rng.whole(least.into(), most.into()) as i32,
            _ => [least, most][rng.below(2)],
        })
    }
}

/// The greatest common divisor, but for its sign, as a sum of multiples of both.
fn bezout(a: i128, b: i128) -> (i128, i128, i128) {
    if b == 0 {
        return (a, 1, 0);
    }
    let (divisor, x, y) = bezout(b, a % b);
    (divisor, y, x - a / b * y)
}

fn minus(a: [i64; 3], b: [i64; 3]) -> [i64; 3] {
    core::array::from_fn(|i| a[i] - b[i])
}

fn cross(a: [i64; 3], b: [i64; 3]) -> [i128; 3] {
    let [a, b] = [a, b].map(|p| p.map(i128::from));
    [(1, 2), (2, 0), (0, 1)].map(|(j, k)| a[j] * b[k] - a[k] * b[j])
}
