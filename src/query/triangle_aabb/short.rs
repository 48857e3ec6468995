//! The first stage of floats on cores that compute them by functions: coordinates cut to a few bits, in words.
//!
//! A triangle whose vertices and a box whose faces were moved by less than g in all still miss each other if the
//! moved triangle misses the moved box grown by g, and meet if it meets the moved box shrunk by g. Both are exact
//! questions in words (`one_sided`), which take a tenth of the instructions of the kernel in floats. Shapes between
//! the two go to that kernel. It stays the answer of `may_overlap`, which is the same on every machine.
//!
//! # The error
//!
//! The greatest coordinate is below 2^29 units, and each is rounded toward zero. A corner of a box that is given by
//! its centre is a sum of two such numbers. Relative to the least corner, a vertex is off by less than three units,
//! and the greatest corner by less than two: together less than [`ERROR`], as `short.g` proves. Then all
//! numbers are rounded down to multiples of 2^`down`, which moves a vertex and the greatest corner by less than
//! one of these each. On a grid nothing is lost, and the answer is exact.

use crate::arithmetic::{Word, cut_to_words, fraction_bits, greatest, is_whole, three};
use crate::query::one_sided::{self, Projection, are_disjoint, are_disjoint_within};
use crate::query::relation::Relation;
use crate::scalar::Scalar;
use crate::shape::{Aabb, Triangle};

/// Units.
const ERROR: i32 = 5;

/// Whether the shapes are disjoint; `None` in doubt.
#[inline(never)]
pub(super) fn disjoint<S: Scalar>(triangle: &Triangle<S>, aabb: &Aabb<S>) -> Option<bool> {
    answer(triangle, aabb, |disjoint| disjoint, are_disjoint)
}

/// How the shapes lie to each other; `None` in doubt. A triangle that meets the shrunk box meets the inside of the
/// true one.
#[inline(never)]
pub(super) fn relation<S: Scalar>(triangle: &Triangle<S>, aabb: &Aabb<S>) -> Option<Relation> {
    let of = |disjoint| if disjoint { Relation::Disjoint } else { Relation::Overlapping };
    answer(triangle, aabb, of, one_sided::relation)
}

/// What `of` makes of the answer to whether the shapes are disjoint by far, or `of_whole` of shapes of which nothing
/// is lost.
#[inline(always)]
fn answer<S: Scalar, T>(
    triangle: &Triangle<S>,
    aabb: &Aabb<S>,
    of: impl Fn(bool) -> T,
    of_whole: impl FnOnce(&[Projection<i32>; 3]) -> T,
) -> Option<T> {
    let ([a, b, c], (p, q, by_center)) = (triangle.points(), aabb.numbers());
    let all = [a, b, c, p, q];
    let (words, unit) = cut_to_words(&all)?;
    let [a, b, c, p, q] = words;
    let mut shapes = three(|i| {
        let (min, size) = if by_center { (p[i] - q[i], q[i] + q[i]) } else { (p[i], q[i] - p[i]) };
        Projection::new(min, size, [a[i], b[i], c[i]])
    });
    // One bit less than the range, for what the box grows by.
    let down = Projection::longest(&shapes).bits() + 1 - <i32 as Word>::RANGE as i32;
    let down = greatest(down, 0);
    let by = (ERROR >> down) + 2;
    for shape in &mut shapes {
        *shape = shape.over(down as u32).grown(by);
    }
    if Projection::are_apart(&shapes) {
        return Some(of(true));
    }
    change(&mut shapes, -2 * by);
    let found = are_disjoint_within(&mut shapes, by).map(of);
    found.or_else(|| {
        let unit = down - fraction_bits::<S>(unit);
        // The shapes are the grown ones.
        change(&mut shapes, -by);
        all.as_flattened().iter().all(|&x| is_whole(x, unit)).then(|| of_whole(&shapes))
    })
}

/// Grows the box.
#[inline(never)]
fn change(shapes: &mut [Projection<i32>; 3], by: i32) {
    for shape in shapes {
        *shape = shape.grown(by);
    }
}

#[cfg(test)]
mod tests {
    use super::{disjoint, relation};
    use crate::arithmetic::{Each, three};
    use crate::query::relation::Relate;
    use crate::random::Random;
    use crate::scalar::Scalar;
    use crate::shape::{Aabb, Triangle};

    /// How many answers there are, of as many questions, and each of them is right. Coordinates take `bits` bits, and
    /// half of all triangles nearly touch the box.
    fn answers<S: Scalar>(of: impl Fn(f64) -> S, bits: u32, questions: u32) -> u32 {
        let mut random = Random(0x5047 + u64::from(bits));
        let mut answers = 0;
        for n in 0..questions {
            let (far, tiny) = ([0.0, 100.0][n as usize % 2], 2_f64.powi(-(n as i32 / 4 % 30)));
            let mut number = || random.short(bits);
            let [center, half] = [three(|_| far + number()), three(|_| number().abs())];
            let at = if n / 2 % 2 == 0 {
                // Across a corner of the box, or a little beyond.
                let corner = three(|i| center[i] + half[i] + tiny * number());
                random.triangle_across(corner, bits)
            } else {
                [(); 3].each(|()| three(|_| far + 2.0 * number()))
            };
            let point = |p: [f64; 3]| p.each(&of);
            let [a, b, c] = at.each(point);
            let triangle = Triangle::new(a, b, c).unwrap();
            let (min, max) = (three(|i| center[i] - half[i]), three(|i| center[i] + half[i]));
            for aabb in [
                Aabb::from_center_half_extents(point(center), point(half)),
                Aabb::from_min_max(point(min), point(max)),
            ] {
                let aabb = aabb.unwrap();
                if let Some(found) = disjoint(&triangle, &aabb) {
                    assert_eq!(found, !triangle.overlaps(&aabb), "{triangle:?} {aabb:?}");
                    answers += 1;
                }
                if let Some(found) = relation(&triangle, &aabb) {
                    assert_eq!(found, triangle.relation(&aabb), "{triangle:?} {aabb:?}");
                }
            }
        }
        answers
    }

    #[test]
    fn an_answer_is_right_and_mostly_there_is_one() {
        for bits in [4, 12, 24, 30, 60] {
            let single = answers(|x| x as f32, bits, 20_000);
            let double = answers(|x| x, bits, 20_000);
            assert!(single > 36_000 && double > 35_000, "{bits} {single} {double}");
        }
    }
}
