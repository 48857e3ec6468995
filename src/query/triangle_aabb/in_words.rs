//! The question in machine words, where registers are narrow.

use super::Disjoint;
use crate::axis;
use crate::linear::{Vec3, pick};
use crate::scalar::{InWord, Scalar, Word, out_of_line_if_wide};
use crate::shape::AabbForm;

impl<S: Scalar> Disjoint<'_, S> {
    /// The answer in words that hold the shapes wherever they are.
    #[inline(never)]
    pub(super) fn in_any_words<W: Word>(&self) -> bool
    where
        S: InWord<W>,
    {
        axis::one_sided(&[self.shadow(0), self.shadow(1), self.shadow(2)])
    }

    /// The answer in words that hold the shapes if they are near to each other.
    #[inline(never)]
    pub(super) fn in_near_words<W: Word>(&self) -> Option<bool>
    where
        S: InWord<W>,
    {
        let shadows = [self.shadow(0), self.shadow(1), self.shadow(2)];
        let is_near = |s: &axis::Shadow<W>| {
            let [a, b, c] = s.t;
            W::are_near(s.min, [a, b, c, s.max].into_iter())
        };
        shadows.iter().all(is_near).then(|| axis::one_sided(&shadows))
    }

    /// The shapes on coordinate axis `i`. A box that wraps here is not near.
    #[inline(always)]
    fn shadow<W: Word>(&self, i: usize) -> axis::Shadow<W>
    where
        S: InWord<W>,
    {
        out_of_line_if_wide!(W, {
            let word = |v: &Vec3<S>| pick(&v.to_array(), i).in_word();
            let [a, b, c] = self.triangle.vertices();
            let (min, max) = match self.aabb.form() {
                AabbForm::Center { center, half } => {
                    let (center, half) = (word(center), word(half));
                    (center.minus(half), center.plus(half))
                }
                AabbForm::Corners { min, max } => (word(min), word(max)),
            };
            axis::Shadow { t: [word(a), word(b), word(c)], min, max }
        })
    }
}
