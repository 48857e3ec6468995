//! An axis-aligned box, split into signed parts for exact sums.

use core::cmp::Ordering;

use crate::arithmetic::{Parts, pick};
use crate::robust::Linear;
use crate::scalar::Scalar;
use crate::shape::AabbForm;

/// The faces of a box, each as the sum of two numbers.
pub(crate) struct ExactAabb {
    min: [[Parts; 2]; 3],
    max: [[Parts; 2]; 3],
}

impl ExactAabb {
    pub(crate) fn new<S: Scalar>(form: &AabbForm<S>) -> Self {
        match form {
            AabbForm::Center { center, half } => {
                let (c, h) = (center.to_array().map(S::parts), half.to_array().map(S::parts));
                Self {
                    min: core::array::from_fn(|i| [c[i], h[i].negated()]),
                    max: core::array::from_fn(|i| [c[i], h[i]]),
                }
            }
            AabbForm::Corners { min, max } => Self {
                min: min.to_array().map(|x| [x.parts(), Parts::ZERO]),
                max: max.to_array().map(|x| [x.parts(), Parts::ZERO]),
            },
        }
    }

    /// The distance from `x` to the face on axis `i` that lies farther along `toward`.
    #[inline(never)]
    pub(crate) fn to_face(&self, x: Parts, i: usize, toward: Ordering) -> Linear {
        let face = if toward == Ordering::Less { &self.min } else { &self.max };
        let [a, b] = *pick(face, i);
        [a, b, x.negated()]
    }
}
