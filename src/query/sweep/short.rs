//! The first stage of floats on cores that compute them by functions: coordinates cut to a few bits, in words. It
//! takes a tenth of the instructions of the kernel in floats.
//!
//! As without motion (`triangle_aabb::short`), a triangle that passes the box grown by g misses the true one, and
//! one that meets the box shrunk by g meets it, if nothing is off by more than g in all at any time. Motions between
//! the two go to that kernel.
//!
//! # The error
//!
//! The greatest coordinate is below 2^28 units, and each is off by less than one: it is rounded toward zero to half a
//! unit, and then down. A corner of a box that is given by its centre is a sum of two such numbers, and so is the
//! motion. Relative to the least corner, a vertex is off by less than five units at any time, and the greatest
//! corner by less than two: together less than [`ERROR`], as `short.g` proves. Then all numbers are rounded
//! down to multiples of 2^`down`, which moves a vertex by less than two of these, and the greatest corner by less than
//! one. On a grid nothing is lost, and the answer is exact.

use super::Passing;
use super::words::Swept;
use crate::arithmetic::{Each, Word, cut_to_words, fraction_bits, greatest, is_whole, three};
use crate::query::one_sided::Projection;
use crate::scalar::Scalar;

/// Units.
const ERROR: i32 = 7;

/// Whether the triangle misses the box; `None` in doubt.
#[inline(never)]
pub(super) fn misses<S: Scalar>(passing: &Passing<'_, S>) -> Option<bool> {
    let ([a, b, c], (p, q, by_center)) = (passing.triangle.points(), passing.aabb.numbers());
    let [from, to] = passing.ends().each(|p| p.to_array());
    let all = [a, b, c, p, q, from, to];
    let (words, unit) = cut_to_words(&all)?;
    let are_whole = |down: i32| {
        let unit = down - fraction_bits::<S>(unit);
        all.as_flattened().iter().all(|&x| is_whole(x, unit))
    };
    in_words(words, by_center, &are_whole)
}

/// The same, given the numbers cut, and whether nothing is lost of any if so many bits are.
#[inline(never)]
fn in_words(
    words: [[i32; 3]; 7],
    by_center: bool,
    are_whole: &dyn Fn(i32) -> bool,
) -> Option<bool> {
    // A bit less, for the sums.
    let [a, b, c, p, q, from, to] = words.map(|v| v.each(|x| x >> 1));
    let start = three(|i| {
        let (min, size) = if by_center { (p[i] - q[i], q[i] + q[i]) } else { (p[i], q[i] - p[i]) };
        Projection::new(min, size, [a[i], b[i], c[i]])
    });
    let d = three(|i| to[i] - from[i]);
    // One bit less than the range, for what the box grows by.
    let down = Swept::new(start, d).longest().bits() + 1 - <i32 as Word>::RANGE as i32;
    let down = greatest(down, 0) as u32;
    let by = (ERROR >> down) + 3;
    let at = |by: i32| Swept::new(three(|i| start[i].over(down).grown(by)), d.each(|x| x >> down));
    if at(by).is_beyond_face() {
        return Some(true);
    }
    for by in [-by, by, 0] {
        if by == 0 && !are_whole(down as i32 + 1) {
            break;
        }
        let changed = at(by);
        // A box thinner than the error has no inside left.
        let misses = !changed.has_inside() || changed.misses();
        if by == 0 || misses == (by > 0) {
            return Some(misses);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::misses;
    use crate::arithmetic::{Each, three};
    use crate::query::sweep::passing::Misses;
    use crate::query::sweep::{Motion, Passing};
    use crate::random::Random;
    use crate::robust::Predicate;
    use crate::scalar::Scalar;
    use crate::shape::{Aabb, Triangle};

    /// How many answers there are, of as many questions, and each of them is right. Half of all triangles nearly
    /// touch the box on their way.
    fn answers<S: Scalar>(of: impl Fn(f64) -> S, bits: u32, questions: u32) -> [u32; 2] {
        let (mut random, mut answers) = (Random(0x5eed + u64::from(bits)), [0; 2]);
        for n in 0..questions {
            let (far, tiny) = ([0.0, 100.0][n as usize % 2], 2_f64.powi(-(n as i32 / 4 % 30)));
            let mut number = || random.short(bits);
            let [center, half] = [three(|_| far + number()), three(|_| number().abs())];
            let (way, from) = (three(|_| 4.0 * number()), three(|_| far * number()));
            let at = if n / 2 % 2 == 0 {
                // Across a corner of the box, or a little beyond, at a time of the motion.
                let t = number().abs();
                let corner = three(|i| center[i] + half[i] + tiny * number() - t * way[i]);
                random.triangle_across(corner, bits)
            } else {
                [(); 3].each(|()| three(|_| far + 2.0 * number()))
            };
            let point = |p: [f64; 3]| p.each(&of);
            let [a, b, c] = at.each(point);
            let triangle = Triangle::new(a, b, c).unwrap();
            let (min, max) = (three(|i| center[i] - half[i]), three(|i| center[i] + half[i]));
            let to = three(|i| from[i] + way[i]);
            let motion = Motion::new(point(from), point(to)).unwrap();
            for aabb in [
                Aabb::from_center_half_extents(point(center), point(half)),
                Aabb::from_min_max(point(min), point(max)),
            ] {
                let aabb = aabb.unwrap();
                let passing = Passing::new(&triangle, &aabb, &motion);
                if let Some(found) = misses(&passing) {
                    let expected = Misses(passing).exact();
                    assert_eq!(found, expected, "{triangle:?} {motion:?} {aabb:?}");
                    answers[usize::from(found)] += 1;
                }
            }
        }
        answers
    }

    #[test]
    fn an_answer_is_right_and_mostly_there_is_one() {
        for bits in [4, 12, 24, 30, 60] {
            let (single, double) =
                (answers(|x| x as f32, bits, 3_000), answers(|x| x, bits, 3_000));
            for [met, missed] in [single, double] {
                assert!(met > 3_500 && missed > 1_500, "{bits} {single:?} {double:?}");
                assert!(bits == 4 || met + missed > 5_990, "{bits} {single:?} {double:?}");
            }
        }
    }
}
