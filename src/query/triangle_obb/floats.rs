//! The first stage of floats on cores that compute them by functions: their numbers cut to words of 29 bits, and then
//! the stage of fixed point, which is `short`.
//!
//! Lengths have one power of two for a unit and axes another, each number rounded toward zero. A vertex
//! relative to the centre is off by less than two units, and a component of an axis by less than one. The
//! greatest component is at least 2^28 in size, so that at least 9 bits of axes are cut; of lengths it is 13.

use super::Disjoint;
use super::known::{Known, WholeBox};
use super::short::{OF_FLOATS, are_disjoint};
use crate::arithmetic::{cut_to_words, fraction_bits, greatest, three};
use crate::robust::in_cut_floats;
use crate::scalar::Scalar;

/// The bits that are cut of a length.
const SPARE: i32 = 13;

/// A box in words.
struct InWords {
    axes: [[i32; 3]; 3],
    half: [i32; 3],
    fraction_bits: i32,
}

impl WholeBox for InWords {
    type Raw = i32;

    #[inline(always)]
    fn axes(&self) -> [[i32; 3]; 3] {
        self.axes
    }
    #[inline(always)]
    fn half(&self) -> [i32; 3] {
        self.half
    }
    #[inline(always)]
    fn fraction_bits(&self) -> i32 {
        self.fraction_bits
    }
    #[inline(always)]
    fn error(&self) -> i32 {
        OF_FLOATS
    }
}

impl<S: Scalar, R> Disjoint<'_, S, R> {
    /// The answer from cut numbers, if they are certain of it, for floats that functions compute.
    #[inline(always)]
    pub(super) fn in_cut_floats(&self) -> Option<bool> {
        in_cut_floats::<S, _>(|| self.of_cut_floats())
    }

    #[inline(never)]
    pub(in crate::query) fn of_cut_floats(&self) -> Option<bool> {
        let ([a, b, c], [center, u, v, w, half]) = (self.triangle.points(), self.obb.numbers());
        let ([a, b, c, center, half], _) = cut_to_words(&[a, b, c, center, half])?;
        let (axes, unit) = cut_to_words(&[u, v, w])?;
        let fraction_bits = fraction_bits::<S>(unit);
        let obb = InWords { axes, half, fraction_bits };
        let from = |p: [i32; 3]| three(|i| p[i] - center[i]);
        // Half-extents absorb the scale of the axes.
        let longer = greatest(Known::Nothing.longest(&obb) - fraction_bits, 0);
        are_disjoint(&obb, || Known::Nothing, longer + SPARE, || ([from(a), from(b), from(c)], 0))
    }
}

#[cfg(test)]
mod tests {
    use super::Disjoint;
    use crate::arithmetic::{Each, three};
    use crate::random::Random;
    use crate::scalar::Scalar;
    use crate::shape::{Obb, Triangle};

    /// How many answers there are, of as many questions, and each of them is right. Boxes are skewed, of any
    /// proportions, with axes of any length, near the origin or far from it. Half of the triangles nearly touch a
    /// corner.
    fn answers<S: Scalar>(of: impl Fn(f64) -> S, questions: i32) -> i32 {
        let (mut random, mut answers) = (Random(0xf10a7), 0);
        for n in 0..questions {
            let mut number = || f64::from(random.bits() as i32) * 2_f64.powi(-31);
            let far = [0.0, 0.0, 100.0, 4000.0][n as usize % 4];
            let (scale, flat) = (2_f64.powi(n / 4 % 9 - 4), 2_f64.powi(-(n / 8 % 8)));
            let center = three(|_| far + number());
            let mut axes = [(); 3].each(|()| three(|_| scale * number()));
            if n % 3 > 0 {
                axes = three(|k| three(|i| if i == k { scale } else { 0.2 * axes[k][i] }));
            }
            let half = [number().abs(), number().abs(), flat * number().abs()];
            let corner = three(|i| center[i] + (0..3).map(|k| half[k] * axes[k][i]).sum::<f64>());
            let mut at = [(); 3].each(|()| three(|_| center[0] + 2.0 * scale * number()));
            if n / 4 % 2 == 0 {
                // Around the corner, or around a point little beyond it.
                let off = scale * 2_f64.powi(-(n / 16 % 30));
                let to = three(|i| corner[i] + off * number());
                let [u, v] = [(); 2].each(|()| three(|_| scale * number()));
                at = [
                    three(|i| to[i] + u[i]),
                    three(|i| to[i] + v[i]),
                    three(|i| to[i] - 0.5 * (u[i] + v[i])),
                ];
            }
            let point = |p: [f64; 3]| p.each(&of);
            let [a, b, c] = at.each(point);
            let triangle = Triangle::new(a, b, c).unwrap();
            let Ok(obb) = Obb::from_skewed_axes(point(center), axes.each(point), point(half))
            else {
                continue;
            };
            let question = Disjoint::new(&triangle, &obb);
            if let Some(found) = question.of_cut_floats() {
                assert_eq!(found, !triangle.overlaps(&obb), "{triangle:?} {obb:?}");
                answers += 1;
            }
        }
        answers
    }

    #[test]
    fn an_answer_is_right_and_mostly_there_is_one() {
        let (single, double) = (answers(|x| x as f32, 60_000), answers(|x| x, 60_000));
        assert!(single > 25_000 && double > 25_000, "{single} {double}");
    }
}
