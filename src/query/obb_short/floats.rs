//! The same stage for floats, on cores that compute them by functions: numbers cut to words of 29 bits.
//!
//! Lengths have one power of two for a unit and the axes of each box another, each number rounded toward zero.
//! So a length is off by less than one unit, the difference of two by less than two, and a component of an axis
//! by less than 2^-28 of the greatest. Of lengths at least [`SPARE`] bits are cut, beside those by which axes are
//! longer than one. That makes 2^-12 of a difference. Of a half-vector, which then has 19 bits, an axis makes
//! 2^-9, where its greatest component is a power of two below zero, and a half-extent 2^-13; of the end of a ray, the
//! direction and t make 2^-9 each. `obb_short.g` proves the sums.

use super::{
    LENGTH, Scaled, between, bits, is_apart, is_ray_apart, middle_and_half, products,
    relation_of_boxes, unit_of,
};
use crate::arithmetic::{Each, Raw, cut_to_words, fraction_bits, greatest, three};
use crate::query::relation::Relation;
use crate::scalar::Scalar;
use crate::shape::{Aabb, Obb, Ray, Segment};

/// The bits that are cut of a length.
const SPARE: i32 = 13;

/// The half-vectors of a box, given its half-extents in words, and the bits by which axes are longer than one.
#[inline(never)]
fn spans<S: Scalar>(axes: &[[S; 3]; 3], half: [i32; 3]) -> Option<(Scaled<3>, i32)> {
    let (axes, unit) = cut_to_words(axes)?;
    let fraction = fraction_bits::<S>(unit);
    let axes = Scaled::new(axes.each(in_raw), -fraction);
    let longer = greatest(axes.end, 0);
    Some((products(in_raw(half), axes.numbers, fraction), longer))
}

fn in_raw(v: [i32; 3]) -> [i64; 3] {
    v.each(i64::from)
}

/// How two oriented boxes lie to each other; `None` in doubt.
#[inline(never)]
pub(in crate::query) fn boxes<S: Scalar>(first: &Obb<S>, second: &Obb<S>) -> Option<Relation> {
    let ([a, u0, u1, u2, h], [b, v0, v1, v2, k]) = (first.numbers(), second.numbers());
    let ([a, h, b, k], _) = cut_to_words(&[a, h, b, k])?;
    let way = Scaled::new([three(|i| i64::from(b[i] - a[i]))], 0);
    let (first, longer) = spans(&[u0, u1, u2], h)?;
    let (second, other) = spans(&[v0, v1, v2], k)?;
    relation_of_boxes(way, first, second, greatest(longer, other) + SPARE)
}

/// How an axis-aligned box and an oriented one lie to each other; `None` in doubt.
#[inline(never)]
pub(in crate::query) fn aabb_and_obb<S: Scalar>(aabb: &Aabb<S>, obb: &Obb<S>) -> Option<Relation> {
    let ((p, q, is_by_center), [c, u, v, w, half]) = (aabb.numbers(), obb.numbers());
    let ([p, q, c, half], _) = cut_to_words(&[p, q, c, half])?;
    let [p, q, c] = [p, q, c].each(in_raw);
    let (way, first, halved) = if is_by_center {
        (three(|i| c[i] - p[i]), q, 0)
    } else {
        (three(|i| 2 * c[i] - p[i] - q[i]), three(|i| q[i] - p[i]), 1)
    };
    let mut along = [[0; 3]; 3];
    for i in 0..3 {
        along[i][i] = first[i];
    }
    let (second, longer) = spans(&[u, v, w], half)?;
    let (way, first) = (Scaled::new([way], -halved), Scaled::new(along, -halved));
    relation_of_boxes(way, first, second, longer + SPARE)
}

/// Whether a segment and an oriented box are disjoint; `None` in doubt.
#[inline(never)]
pub(in crate::query) fn segment<S: Scalar>(segment: &Segment<S>, obb: &Obb<S>) -> Option<bool> {
    let ((a, b, is_by_center), [c, u, v, w, half]) = (segment.numbers(), obb.numbers());
    let ([a, b, c, half], _) = cut_to_words(&[a, b, c, half])?;
    let from = |p: [i32; 3]| Scaled::new([three(|i| i64::from(p[i] - c[i]))], 0);
    let (first, second) =
        (from(a), if is_by_center { Scaled::new([in_raw(b)], 0) } else { from(b) });
    let (spans, longer) = spans(&[u, v, w], half)?;
    let unit = unit_of([first.end, second.end, spans.end], longer + SPARE);
    let ([p], [q], [u, v, w]) = (first.cut(unit), second.cut(unit), spans.cut(unit));
    let (way, half) = if is_by_center { (p, q) } else { middle_and_half(&p, &q) };
    is_apart(&way, &[u, v, w, half])
}

/// Whether a ray and an oriented box are disjoint; `None` in doubt.
#[inline(never)]
pub(in crate::query) fn ray<S: Scalar>(ray: &Ray<S>, obb: &Obb<S>) -> Option<bool> {
    let (p, d) = (ray.origin().to_array(), ray.direction().to_array());
    let [c, u, v, w, half] = obb.numbers();
    let ([p, c, half], of_lengths) = cut_to_words(&[p, c, half])?;
    let ([d], of_way) = cut_to_words(&[d])?;
    let way = Scaled::new([three(|i| i64::from(p[i] - c[i]))], 0);
    let (spans, longer) = spans(&[u, v, w], half)?;
    let reach = greatest(way.end, spans.end + 2) + 1;
    let unit = greatest(reach + 2 - LENGTH, longer + SPARE);
    let t = |t: Option<S>| match t {
        Some(t) if t != S::ZERO => {
            let ([[t, ..]], of_t) = cut_to_words(&[[t; 3]])?;
            Some(Some((i64::from(t), fraction_bits::<S>(of_t + of_way - of_lengths))))
        }
        Some(_) => Some(Some((0, 0))),
        None => Some(None),
    };
    let ends = [t(ray.t_min())?, t(ray.t_max())?];
    let d = [in_raw(d)];
    let [beyond] = Raw::cut(d, bits(&d) + 1 - LENGTH);
    let Some(ends) = between(ends, || d, reach, unit, beyond) else { return Some(true) };
    let [way] = way.cut(unit);
    is_ray_apart(&way, ends, spans.cut(unit))
}

#[cfg(test)]
mod tests {
    use core::fmt::Debug;

    use super::{aabb_and_obb, boxes, ray, segment};
    use crate::arithmetic::{Each, three};
    use crate::query::relation::Relate;
    use crate::random::Random;
    use crate::scalar::Scalar;
    use crate::shape::{Aabb, Obb, Ray, Segment};

    type Point = [f64; 3];

    /// Two boxes.
    struct Scene {
        centers: [Point; 2],
        axes: [[Point; 3]; 2],
        half: [Point; 2],
    }

    impl Scene {
        /// Boxes that are skewed or nearly alike, with axes and half-extents of any length, near the origin or far from
        /// it, even where cut numbers have few bits of their size. Half of them nearly touch.
        fn new(random: &mut Random, n: i32) -> Self {
            let mut number = || f64::from(random.bits() as i32) * 2_f64.powi(-31);
            let far = [0.0, 0.0, 100.0, 4000.0][n as usize % 4];
            let size = if n / 2 % 4 == 0 { 2_f64.powi(-(n / 8 % 16)) } else { 1.0 };
            let scales = [4, 64].each(|by: i32| 2_f64.powi(n / by % 9 - 4));
            let axes = scales.each(|by| {
                let all = [(); 3].each(|()| three(|_| by * number()));
                let diagonal = if n % 2 == 0 { by } else { -by };
                let one = |i: usize, k: usize| if i == k { diagonal } else { 0.2 * all[k][i] };
                if n % 3 == 0 { all } else { three(|k| three(|i| one(i, k))) }
            });
            let half = scales.each(|by| three(|_| size * number().abs() / by));
            let first = three(|_| far + size * number());
            let mut scene = Self { centers: [first; 2], axes, half };
            scene.centers[1] = if n / 4 % 2 == 0 {
                // Corner to corner, nearly.
                let off = size * 2_f64.powi(-(n / 16 % 30));
                scene.centers[1] = scene.corner(0, 1.0).each(|x| x + off * number());
                scene.corner(1, 1.0)
            } else {
                three(|_| far + 2.0 * size * number())
            };
            scene
        }

        /// A corner of box b, or the opposite one.
        fn corner(&self, b: usize, sign: f64) -> Point {
            let (axes, half) = (&self.axes[b], &self.half[b]);
            three(|i| self.centers[b][i] + sign * (0..3).map(|k| half[k] * axes[k][i]).sum::<f64>())
        }
    }

    /// Counts an answer, which is the expected one.
    fn check<A: PartialEq + Debug>(count: &mut i32, found: Option<A>, expected: A, n: i32) {
        if let Some(found) = found {
            assert_eq!(found, expected, "{n}");
            *count += 1;
        }
    }

    /// How many answers there are of boxes, of boxes of which one is axis-aligned, of segments, and of rays.
    fn answers<S: Scalar>(of: impl Fn(f64) -> S, questions: i32) -> [i32; 4] {
        let (mut random, mut answers) = (Random(0xf10b), [0; 4]);
        let point = |p: Point| p.each(&of);
        for n in 0..questions {
            let scene = Scene::new(&mut random, n);
            let obb = |b: usize| {
                let (axes, half) = (scene.axes[b].each(point), point(scene.half[b]));
                Obb::from_skewed_axes(point(scene.centers[b]), axes, half)
            };
            let (Ok(one), Ok(other)) = (obb(0), obb(1)) else { continue };
            check(&mut answers[0], boxes(&one, &other), one.relation(&other), n);

            let (center, half) = (scene.centers[0], scene.half[0]);
            let aabb = if n / 2 % 2 == 0 {
                Aabb::from_center_half_extents(point(center), point(half))
            } else {
                let end = |sign: f64| point(three(|i| center[i] + sign * half[i]));
                Aabb::from_min_max(end(-1.0), end(1.0))
            };
            let aabb = aabb.unwrap();
            check(&mut answers[1], aabb_and_obb(&aabb, &other), aabb.relation(&other), n);

            let [from, to] = [-1.0, 1.0].each(|sign: f64| scene.corner(0, sign));
            let line = if n / 2 % 2 == 0 {
                Segment::new(point(from), point(to))
            } else {
                Segment::from_center_half_vector(point(center), point(scene.axes[0][0]))
            };
            let line = line.unwrap();
            check(&mut answers[2], segment(&line, &other), !line.overlaps(&other), n);

            // From the centre to a corner in a length of t far from one, with ends near the box and without.
            let length = 2_f64.powi(n / 4 % 40 - 20);
            let way = three(|i| length * (to[i] - center[i]));
            let ends = [[0.0, 1.0], [-1.5, 1.5], [0.25, 1.0]][n as usize % 3];
            let [t_min, t_max] = ends.each(|t| Some(of(t / length)));
            let [t_min, t_max] = [[t_min, t_max], [None, t_max], [t_min, None]][n as usize / 3 % 3];
            let line = Ray::new(point(center), point(way)).unwrap();
            let line = line.with_range(t_min, t_max).unwrap();
            check(&mut answers[3], ray(&line, &other), !line.overlaps(&other), n);
        }
        answers
    }

    #[test]
    fn an_answer_is_right_and_mostly_there_is_one() {
        for found in [answers(|x| x as f32, 15_000), answers(|x| x, 15_000)] {
            let least = [7_000, 12_000, 9_500, 9_000];
            assert!(found.iter().zip(&least).all(|(found, least)| found > least), "{found:?}");
        }
    }
}
