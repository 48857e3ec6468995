//! The same stage for floats, on cores that compute them by functions: numbers cut to words of 29 bits.
//!
//! Lengths have one power of two for a unit and the axes of each box another, each number rounded toward zero.
//! So a length is off by less than one unit, the difference of two by less than two, and a component of an axis
//! by less than 2^-28 of the greatest. Of lengths at least [`SPARE`] bits are cut, beside those by which axes are
//! longer than one. That makes 2^-12 of a difference. Of a half-vector, which then has 19 bits, an axis makes
//! 2^-10 and a half-extent 2^-13; of the end of a ray, the direction and t make 2^-9 each. `obb_short.g` proves the
//! sums.

use super::{
    LENGTH, Scaled, between, bits, is_ray_apart, middle_and_half, products, relation,
    relation_of_boxes, unit_of,
};
use crate::arithmetic::{Each, Float, Raw, cut_to_words, greatest, three};
use crate::query::relation::Relation;
use crate::scalar::Scalar;
use crate::shape::{Aabb, Obb, Ray, Segment};

/// The bits that are cut of a length.
const SPARE: i32 = 13;

/// The half-vectors of a box, given its half-extents in words, and the bits by which axes are longer than one.
#[inline(never)]
fn spans<S: Scalar>(axes: &[[S; 3]; 3], half: [i32; 3]) -> Option<(Scaled<3>, i32)> {
    let (axes, unit) = cut_to_words(axes)?;
    let fraction = S::SeptumFirst::from(1).exponent() - unit;
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
    relation(&way, &[u, v, w, half]).map(|found| found == Relation::Disjoint)
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
    let one = S::SeptumFirst::from(1).exponent();
    let t = |t: Option<S>| match t {
        Some(t) if t != S::ZERO => {
            let ([[t, ..]], of_t) = cut_to_words(&[[t; 3]])?;
            Some(Some((i64::from(t), one + of_lengths - of_t - of_way)))
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
    use super::{aabb_and_obb, boxes, ray, segment};
    use crate::arithmetic::{Each, three};
    use crate::query::relation::{Relate, Relation};
    use crate::random::Random;
    use crate::scalar::Scalar;
    use crate::shape::{Aabb, Obb, Ray, Segment};

    /// How many answers there are to each of four questions, and each of them is right. Boxes are skewed or nearly
    /// alike, with axes and half-extents of any length, near the origin or far from it, even where
    /// cut numbers have few bits of their size, and half of them nearly touch.
    fn answers<S: Scalar>(of: impl Fn(f64) -> S, questions: i32) -> [i32; 4] {
        let (mut random, mut answers) = (Random(0xf10b), [0; 4]);
        for n in 0..questions {
            let mut number = || f64::from(random.bits() as i32) * 2_f64.powi(-31);
            let far = [0.0, 0.0, 100.0, 4000.0][n as usize % 4];
            let size = if n / 2 % 4 == 0 { 2_f64.powi(-(n / 8 % 16)) } else { 1.0 };
            let scales = [4, 64].each(|by: i32| 2_f64.powi(n / by % 9 - 4));
            let mut vectors = |by: f64| {
                let all = [(); 3].each(|()| three(|_| by * number()));
                let one = |i: usize, k: usize| if i == k { by } else { 0.2 * all[k][i] };
                if n % 3 == 0 { all } else { three(|k| three(|i| one(i, k))) }
            };
            let axes = scales.each(&mut vectors);
            let half = scales.each(|by| three(|_| size * number().abs() / by));
            let first = three(|_| far + size * number());
            let corner = |center: [f64; 3], b: usize, sign: f64| -> [f64; 3] {
                three(|i| {
                    center[i] + sign * (0..3).map(|k| half[b][k] * axes[b][k][i]).sum::<f64>()
                })
            };
            // Anywhere, or corner to corner, nearly.
            let off = 2_f64.powi(-(n / 16 % 30));
            let mut second = three(|_| far + 2.0 * size * number());
            if n / 4 % 2 == 0 {
                let at = corner(first, 0, 1.0).each(|x| x + size * off * number());
                second = corner(at, 1, 1.0);
            }
            let point = |p: [f64; 3]| p.each(&of);
            let obb = |center, b: usize| {
                Obb::from_skewed_axes(point(center), axes[b].each(point), point(half[b]))
            };
            let (Ok(one), Ok(other)) = (obb(first, 0), obb(second, 1)) else { continue };
            let (low, high) = (three(|i| first[i] - half[0][i]), three(|i| first[i] + half[0][i]));
            let aabbs = [
                Aabb::from_center_half_extents(point(first), point(half[0])),
                Aabb::from_min_max(point(low), point(high)),
            ];
            let [p, q] = [-1.0, 1.0].each(|sign: f64| point(corner(first, 0, sign)));
            let segments = [
                Segment::new(p, q),
                Segment::from_center_half_vector(point(first), point(axes[0][0])),
            ];
            let mut check = |k: usize, found: Option<Relation>, expected: Relation| {
                if let Some(found) = found {
                    assert_eq!(found, expected, "{one:?} {other:?}");
                    answers[k] += 1;
                }
            };
            check(0, boxes(&one, &other), one.relation(&other));
            let aabb = aabbs[n as usize / 2 % 2].as_ref().unwrap();
            check(1, aabb_and_obb(aabb, &other), aabb.relation(&other));
            let line = segments[n as usize / 2 % 2].as_ref().unwrap();
            if let Some(found) = segment(line, &other) {
                assert_eq!(found, !line.overlaps(&other), "{line:?} {other:?}");
                answers[2] += 1;
            }
            // Of no end, of ends near the box, and of ends where the way is long.
            let length = 2_f64.powi(n / 4 % 40 - 20);
            let way = three(|i| length * (corner(first, 0, 1.0)[i] - first[i]));
            let ends = [[0.0, 1.0], [-1.5, 1.5], [0.25, 1.0]][n as usize % 3]
                .each(|t| Some(of(t / length)));
            let [from, to] = [ends, [None, ends[1]], [ends[0], None]][n as usize / 3 % 3];
            let line = Ray::new(point(first), point(way)).and_then(|ray| ray.with_range(from, to));
            let line = line.unwrap();
            if let Some(found) = ray(&line, &other) {
                assert_eq!(found, !line.overlaps(&other), "{line:?} {other:?}");
                answers[3] += 1;
            }
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
