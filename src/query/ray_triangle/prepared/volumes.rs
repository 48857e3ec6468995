//! u, v, t and w of a prepared ray and a prepared triangle, side by side in `f32` for every scalar.
//!
//! With s from the first vertex to the origin, d the direction, edges e1 and e2 and the normal n =
//! e1 × e2:
//!
//! r = s × d, u = r·e2, v = −r·e1, t = s·n, det = −d·n, w = det − u − v.
//!
//! These are the volumes of Möller and Trumbore 1997, with the normal stored in the triangle.
//!
//! # Error bounds
//!
//! E is the greatest component of the edges, and D of the direction. M is the greatest component
//! of all vertices plus the greatest of the origin: no component of s exceeds M. u is the unit
//! roundoff of `f32`. Edges and normal are computed in `f64` and rounded once: e and d err by a
//! relative u, n by u·2E², and the roundings in `f64` are below a thousandth of that. Vertex and
//! origin are rounded too, by at most u·M each, and so is their difference: s errs by 3u·M, however
//! near they are to each other.
//!
//! `volumes.g` proves, with the roundings of the bounds themselves:
//!
//! * u and v err by at most [`SIDE`] roundoffs of M·D·E,
//! * t by at most [`T`] roundoffs of M·E²,
//! * w by at most [`SIDES`] roundoffs of M·D·E.
//!
//! E, D and the greatest component of the vertices must be in the range of `f32` in which products
//! of three lengths are safe ([`Float::RANGE`]), and the origin
//! below its upper end. Otherwise the bounds are infinite, and every pair is in doubt. E, D and M
//! are increased by a relative 2⁻²⁰, to allow for their conversion to `f32`.

use crate::arithmetic::{Each, Filtered, Float, OfFour, Quad, cross, greatest, largest, three};
use crate::scalar::Scalar;

type Four = <f32 as OfFour>::Quad;

/// Roundoffs in u and v.
const SIDE: u16 = 60;

/// Roundoffs in t.
const T: u16 = 42;

/// Roundoffs in w.
const SIDES: u16 = 220;

/// The part of the volumes that depends on the triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct OfTriangle {
    /// One component each of e2, −e1, n and −n.
    rows: [[f32; 4]; 3],
    /// The first vertex, and the vertices' part of M, negated.
    corner: [f32; 4],
    /// The triangle's factor in the bounds of u, v, t and w.
    error: [f32; 4],
}

/// The part of the volumes that depends on the ray.
#[derive(Clone, Copy, Debug)]
pub(super) struct OfRay {
    /// The origin, and its part of M.
    origin: [f32; 4],
    /// (x, y, z), and (y, z, x).
    direction: [f32; 4],
    turned: [f32; 4],
    /// The ray's factor in the bounds of u, v, t and w.
    error: [f32; 4],
}

/// The verdict on the line of a ray, and on its part ahead of the origin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(super) enum Verdict {
    Doubt,
    Miss,
    Front,
    Back,
}

/// The verdict for each set of clearly positive and clearly negative volumes: a table in place of
/// branches that no processor could predict.
const VERDICTS: [Verdict; 256] = {
    let mut verdicts = [Verdict::Doubt; 256];
    let mut signs = 0;
    while signs < 256 {
        verdicts[signs] = match (signs & 15, signs >> 4) {
            (15, _) => Verdict::Front,
            (_, 15) => Verdict::Back,
            (0, _) | (_, 0) => Verdict::Doubt,
            _ => Verdict::Miss,
        };
        signs += 1;
    }
    verdicts
};

impl OfTriangle {
    /// Every pair is in doubt.
    pub(super) const UNKNOWN: Self =
        Self { rows: [[0.0; 4]; 3], corner: [0.0; 4], error: [f32::INFINITY; 4] };

    #[inline(always)]
    pub(super) fn new<S: Scalar>([a, b, c]: [[S; 3]; 3]) -> Self {
        let from_a = |p: [S; 3]| three(|i| p[i].beyond_in_double(a[i]));
        let (e1, e2) = (from_a(b), from_a(c));
        let n = cross::<Filtered<f64>>(&e1, &e2);
        let in_double = |p: [S; 3]| p.each(S::in_double);
        let (edge, reach) = (size(&[e1, e2]), size(&[in_double(a), in_double(b), in_double(c)]));
        if !(is_in_range(edge, true) && is_in_range(reach, true)) {
            return Self::UNKNOWN;
        }
        let roundoffs = |count: u16| f64::from(count) * f64::from(<f32 as Float>::ROUNDOFF) * edge;
        let side = roundoffs(SIDE);
        Self {
            rows: three(|i| four([e2[i], -e1[i], n[i]], -n[i])),
            corner: four(in_double(a), -reach),
            error: four([side, side, roundoffs(T) * edge], roundoffs(SIDES)),
        }
    }
}

impl OfRay {
    /// Every pair is in doubt.
    pub(super) const UNKNOWN: Self =
        Self { origin: [0.0; 4], direction: [0.0; 4], turned: [0.0; 4], error: [f32::INFINITY; 4] };

    /// `is_ahead` says that hits behind the origin do not count.
    #[inline(always)]
    pub(super) fn new<S: Scalar>(origin: [S; 3], direction: [S; 3], is_ahead: bool) -> Self {
        let (o, d) = (origin.each(S::in_double), direction.each(S::in_double));
        let (reach, speed) = (size(&[o]), size(&[d]));
        if !(is_in_range(reach, false) && is_in_range(speed, true)) {
            return Self::UNKNOWN;
        }
        let of_t = if is_ahead { 1.0 } else { f64::INFINITY };
        Self {
            origin: four(o, reach),
            direction: four(d, 0.0),
            turned: four([d[1], d[2], d[0]], 0.0),
            error: four([speed, speed, of_t], speed),
        }
    }

    /// The clear verdict on a triangle, or doubt.
    #[inline(always)]
    pub(super) fn verdict(&self, triangle: &OfTriangle) -> Verdict {
        let (volumes, error) = self.volumes(triangle);
        let (volumes, error) = (Four::new(volumes), Four::new(error));
        let (above, below) = (volumes.exceeds(error), (Four::splat(0.0) - error).exceeds(volumes));
        VERDICTS[usize::from((above | below << 4) as u8)]
    }

    /// u, v, t and w, and their error bounds.
    #[inline(always)]
    fn volumes(&self, triangle: &OfTriangle) -> ([f32; 4], [f32; 4]) {
        let row = <Four as Quad>::new;
        let s = row(self.origin) - row(triangle.corner);
        let r = s * row(self.turned) - s.turned() * row(self.direction);
        let [rz, rx, ry, _] = r.to_array();
        let [sx, sy, sz, size] = s.to_array();
        let [dx, dy, dz, _] = self.direction;
        let [x, y, z] = triangle.rows;
        let x = row([rx, rx, sx, dx]) * row(x);
        let y = row([ry, ry, sy, dy]) * row(y);
        let z = row([rz, rz, sz, dz]) * row(z);
        let [u, v, t, det] = (x + y + z).to_array();
        let error = Four::splat(size) * (row(triangle.error) * row(self.error));
        ([u, v, t, det - u - v], error.to_array())
    }
}

/// The greatest magnitude, increased a little.
#[inline]
fn size(points: &[[f64; 3]]) -> f64 {
    let most = points.iter().fold(0.0, |most, p| greatest(most, largest(p)));
    most * (1.0 + 1.0 / (1 << 20) as f64)
}

/// Whether a number is below the upper end of the range of `f32`, and, with `from`, above its lower
/// end.
#[inline]
fn is_in_range(x: f64, from: bool) -> bool {
    let (least, most) = <f32 as Float>::RANGE;
    (!from || x > f64::from(least)) && x < f64::from(most)
}

/// Three numbers and a fourth in `f32`.
#[inline]
fn four([x, y, z]: [f64; 3], w: f64) -> [f32; 4] {
    [x as f32, y as f32, z as f32, w as f32]
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::format;

    use super::*;
    use crate::query::ray_triangle::kernel::truth::{exact_crossing, exceeds};
    use crate::random::Random;

    #[test]
    fn no_error_exceeds_its_bound() {
        let mut random = Random(5);
        let mut of_some_size = [0; 4];
        for case in 0..20_000_i32 {
            // Close together and far from the origin; small triangles; long directions.
            let [small, far, long] = [case % 5 * 4, case % 7 * 3, case % 3 * 9];
            let mut vector = |size: f64| [(); 3].each(|()| random.number() * size);
            let away = vector(Float::scaled(1, far));
            let near = |p: [f64; 3]| [0, 1, 2].each(|i| p[i] + away[i]);
            let size = Float::scaled(1, -small);
            let points = [near(vector(1.0)), near(vector(size)), near(vector(size))];
            let (o, d) = (near(vector(1.0)), vector(Float::scaled(1, long)));
            let (volumes, errors) = OfRay::new(o, d, true).volumes(&OfTriangle::new(points));
            let exact = {
                let [a, b, c] = points;
                exact_crossing([a, b, c, o], d)
            };
            let [w, u, v] = exact.sides;
            for (k, exact) in [u, v, exact.t, w].into_iter().enumerate() {
                let (found, error) = (f64::from(volumes[k]), f64::from(errors[k]));
                let told = || format!("{k}: {points:?} {o:?} {d:?}");
                assert!(!exceeds(&exact, &[found], error), "{}", told());
                of_some_size[k] += u32::from(exceeds(&exact, &[found], error / 256.0));
            }
        }
        assert!(of_some_size.iter().all(|count| *count > 100), "{of_some_size:?}");
    }

    #[test]
    fn beyond_the_range_all_is_in_doubt() {
        let triangle = |size: f64| OfTriangle::new([[0.0; 3], [size, 0.0, 0.0], [0.0, size, 0.0]]);
        let ray = |length: f64| OfRay::new([0.1, 0.1, 1.0], [0.0, 0.0, -length], true);
        assert_eq!(ray(1.0).verdict(&triangle(1.0)), Verdict::Front);
        for (length, size) in [(1.0, 1e-20), (1.0, 1e20), (1e-20, 1.0), (1e20, 1.0), (1.0, 1e300)] {
            assert_eq!(ray(length).verdict(&triangle(size)), Verdict::Doubt, "{length} {size}");
        }
        // The ray, the triangle, or both far from the origin.
        let far = 2_f64.powi(60);
        let (side, inside) = (1_048_576.0, 262_144.0);
        let at = |x: f64| OfRay::new([x, inside, side], [0.0, 0.0, -side], true);
        let from = |x: f64| OfTriangle::new([[x, 0.0, 0.0], [x + side, 0.0, 0.0], [x, side, 0.0]]);
        assert_eq!(at(inside).verdict(&from(0.0)), Verdict::Front);
        assert_eq!(at(far).verdict(&from(0.0)), Verdict::Doubt);
        assert_eq!(at(inside).verdict(&from(far)), Verdict::Doubt);
        assert_eq!(at(far).verdict(&from(far)), Verdict::Doubt);
    }
}
