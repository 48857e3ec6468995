//! Four triangles side by side, in `f32` for every scalar, to reject triangles that a ray clearly
//! misses.
//!
//! For machines with vectors: the four triangles in a leaf of a tree take one look, where the kernels
//! for one triangle take four, in `f64`.
//!
//! The volumes of [`Setting`](super::kernel::Setting), of vectors that were rounded once on the way
//! in. A vector of numbers has no order, so that it is no [`Number`], and `Setting` cannot have it.
//! `four.g` proves the bounds. They have the form of [`error_bound`](super::error_bound), and
//! include one rounding of each vector, and a little more in `f64`, where the difference was rounded
//! before.

use crate::arithmetic::{Each, Float, Number, OfFour, Quad, cross3, dot3, largest, three};
use crate::scalar::Scalar;
use crate::shape::{Ray, Triangle};

type Four = <f32 as OfFour>::Quad;

/// Roundoffs in w, u and v.
const SIDES: u16 = 190;

/// Roundoffs in the numerator of t.
const T: u16 = 54;

/// The triangles that the ray clearly misses, as bits, the first triangle lowest.
///
/// `f32` suffices for all but near misses. None is missed where the machine has no vectors.
#[inline(always)]
pub(crate) fn clear_misses<S: Scalar>(ray: &Ray<S>, triangles: [Triangle<S>; 4]) -> u32 {
    let [p, q, r, s] = triangles.each(|triangle| triangle.points());
    let (o, d) = (ray.origin().to_array(), ray.direction().to_array());
    let [a, b, c] = three(|v| [p[v], q[v], r[v], s[v]]);
    let [[a0, a1, a2, a3], [b0, b1, b2, b3], [c0, c1, c2, c3]] = [a, b, c];
    let points = [a0, a1, a2, a3, b0, b1, b2, b3, c0, c1, c2, c3, o, d];
    if !Four::IS_VECTOR || !S::have_offsets(&points) {
        return 0;
    }
    let from_a = |p: &[[S; 3]; 4], i: usize| {
        Four::new([
            p[0][i].offset(a0[i]),
            p[1][i].offset(a1[i]),
            p[2][i].offset(a2[i]),
            p[3][i].offset(a3[i]),
        ])
    };
    let edges = [three(|i| from_a(&b, i)), three(|i| from_a(&c, i))];
    let way = three(|i| from_a(&[o; 4], i));
    let direction = three(|i| d[i].offset(S::ZERO));
    misses(edges, way, direction, ray.t_min().is_some_and(|t| t >= S::ZERO))
}

/// The triangles with these edges, and this way from their first vertex to the origin, that the
/// line clearly misses, or, if `is_ahead`, the half-line.
#[inline(always)]
fn misses([e1, e2]: [[Four; 3]; 2], s: [Four; 3], d: [f32; 3], is_ahead: bool) -> u32 {
    let direction = largest(&d);
    let d = three(|i| Four::splat(d[i]));
    let (p, q) = (cross3(&d, &e2), cross3(&s, &e1));
    let (det, u, v, t) = (dot3(&p, &e1), dot3(&p, &s), dot3(&q, &d), dot3(&q, &e2));
    let w = det - u - v;

    let edges = greatest_of(&e1).greatest(greatest_of(&e2));
    let size = edges.greatest(greatest_of(&s));
    let (least, most) = f32::RANGE;
    let in_range = edges.exceeds(Four::splat(least)) & Four::splat(most).exceeds(size);
    if !direction.in_range() {
        return 0;
    }
    let volume = edges * size;
    let sides = volume * Four::splat(direction.error(SIDES));
    let of_t = volume * (edges * Four::splat(1.0_f32.error(T)));

    let zero = Four::splat(0.0);
    let (ahead, behind) =
        if is_ahead { (t.exceeds(of_t), (zero - of_t).exceeds(t)) } else { (0, 0) };
    let above = u.greatest(v).greatest(w).exceeds(sides) | ahead;
    let below = (zero - sides).exceeds(u.least(v).least(w)) | behind;
    above & below & in_range
}

#[inline(always)]
fn greatest_of([x, y, z]: &[Four; 3]) -> Four {
    x.magnitude().greatest(y.magnitude()).greatest(z.magnitude())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;
    use crate::shape::Vec3;

    /// Triangles and rays on a coarse grid, far from the origin or not, where many touch, moved by
    /// units in the last place. Returns how many are missed, and how many of these are found.
    fn check<S: Scalar>(number: fn(f64) -> S, [size, far, unit]: [f64; 3]) -> [u32; 2] {
        let mut random = Random(size.to_bits() ^ far.to_bits());
        let mut counts = [0; 2];
        for _ in 0..4_000 {
            let mut integer = |most: i64| (random.bits() % (2 * most as u64 + 1)) as i64 - most;
            let mut point = |far: f64| {
                let x =
                    [(); 3].each(|()| far + integer(4) as f64 * size + integer(1) as f64 * unit);
                Vec3::from(x.each(number))
            };
            let triangles = [(); 4].each(|()| Triangle::unchecked([(); 3].each(|()| point(far))));
            let Ok(ray) = Ray::new(point(far), point(0.0)) else { continue };
            let ranges = [[Some(S::ZERO), None], [None, None], [Some(number(-1.0)), None]];
            for [from, to] in ranges {
                let ray = ray.with_range(from, to).unwrap();
                let missed = clear_misses(&ray, triangles);
                for (k, triangle) in triangles.iter().enumerate() {
                    let (is_missed, is_hit) = (missed >> k & 1 == 1, ray.is_hit(triangle));
                    assert!(!(is_missed && is_hit), "{ray:?} {triangle:?}");
                    counts[0] += u32::from(!is_hit);
                    counts[1] += u32::from(is_missed);
                }
            }
        }
        counts
    }

    /// Whether most misses are found, where there are vectors.
    fn finds_most([missed, found]: [u32; 2]) -> bool {
        found > missed / 2 || !Four::IS_VECTOR
    }

    #[test]
    fn no_hit_is_missed() {
        for [size, far] in [[1.0, 0.0], [1.0, 1000.0], [1e-3, 3.0], [1e5, 0.0]] {
            let unit = if far > size { far } else { size };
            assert!(finds_most(check(|x| x as f32, [size, far, unit / 8_388_608.0])));
            assert!(finds_most(check(|x| x, [size, far, unit * f64::EPSILON])));
        }
        // Beyond the range of `f32`, and at its ends.
        for size in [1e-300, 1e-44, 1e-20, 1e-10, 1e10, 1e14, 1e38, 1e300] {
            check(|x| x as f32, [size, 0.0, size / 8_388_608.0]);
            check(|x| x, [size, 0.0, size * f64::EPSILON]);
        }
    }

    #[cfg(feature = "fixed")]
    #[test]
    fn no_hit_is_missed_in_fixed_point() {
        use fixed::types::{I8F8, I16F16, I32F32};
        let unit = |bits: i32| 2_f64.powi(-bits);
        assert!(finds_most(check(I8F8::from_num::<f64>, [8.0, 30.0, unit(8)])));
        for [size, far] in [[1.0, 0.0], [10.0, 200.0], [0.01, 3.0]] {
            assert!(finds_most(check(I16F16::from_num::<f64>, [size, far, unit(16)])));
            assert!(finds_most(check(I32F32::from_num::<f64>, [size, far, unit(32)])));
        }
        // Beyond the coordinates whose differences are known.
        check(I16F16::from_num::<f64>, [7_000.0, 0.0, unit(16)]);
        check(I32F32::from_num::<f64>, [5e8, 0.0, unit(32)]);
    }
}
