//! Whether a triangle has a normal at all.

use crate::arithmetic::{Embeds, Number, cross, three};
use crate::robust::{Predicate, Profile};
use crate::scalar::Scalar;
use crate::shape::Triangle;

impl<S: Scalar> Triangle<S> {
    /// Do the three vertices lie on one line, or in one point?
    ///
    /// *Numerics*: exact for every input. The thinnest sliver is not degenerate.
    ///
    /// *Range*: all finite floats and all fixed-point values.
    ///
    /// *Contact*: no query requires this check. To every query a degenerate triangle is a segment
    /// or a point, and its answer is exact too.
    ///
    /// *Panics*: never. *Cost*: six products of integers; meant for checking a mesh, not for an
    /// inner loop.
    ///
    /// ```
    /// use septum::Triangle;
    ///
    /// // In f32 the cross product of these edges rounds to zero.
    /// let (b, c) = ([1.000122, 1.0, 0.0], [2.000122, 1.999878, 0.0]);
    /// let sliver = Triangle::new([0.0_f32; 3], b, c)?;
    /// assert!(!sliver.is_degenerate());
    /// let segment = Triangle::new([0.0_f32; 3], [1.0, 1.0, 1.0], [3.0, 3.0, 3.0])?;
    /// assert!(segment.is_degenerate());
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[must_use]
    pub fn is_degenerate(&self) -> bool {
        S::evaluate(&IsDegenerate(self.points()))
    }
}

/// The question whether three points lie on one line.
struct IsDegenerate<S>([[S; 3]; 3]);

impl<S: Scalar> Predicate<S> for IsDegenerate<S> {
    type Answer = bool;
    const PROFILE: Profile = Profile::AREAS;

    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        if !N::CERTAIN {
            return None;
        }
        let [a, b, c] = N::embed(&self.0)?;
        let (e, f) = (three(|i| b[i] - a[i]), three(|i| c[i] - a[i]));
        Some(cross::<N>(&e, &f).iter().all(|&x| x == N::Area::ZERO))
    }
}
