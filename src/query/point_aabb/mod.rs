//! Point against axis-aligned box.

use super::aabb_aabb::Apart;
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Vec3};

impl<S: Scalar> Aabb<S> {
    /// Does the box contain a point?
    ///
    /// *Geometry*: a closed box, in the form in which it was given. No box contains a point with a
    /// NaN or infinite coordinate.
    ///
    /// *Contact*: a point on a face is in the box.
    ///
    /// *Numerics*: exact for every valid input, in every scalar.
    ///
    /// *Range*: all finite floats, all fixed-point values, in the same stages as for two boxes.
    ///
    /// *Panics*: never. *Cost*: 6 comparisons for a box given by its corners; for a box given by
    /// its centre, as for two boxes.
    ///
    /// ```
    /// use septum::Aabb;
    ///
    /// let cell = Aabb::from_center_half_extents([0.5_f32; 3], [0.5; 3])?;
    /// assert!(cell.contains([1.0, 0.0, 0.5]));
    /// assert!(!cell.contains([1.0000001, 0.0, 0.5]));
    /// assert!(!cell.contains([f32::NAN, 0.5, 0.5]));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    #[must_use]
    pub fn contains(&self, point: impl Into<Vec3<S>>) -> bool {
        let p = point.into();
        match self.form() {
            // Comparisons with a NaN are false.
            AabbForm::Corners { min, max } => {
                let holds = |min: S, p: S, max: S| (min <= p) & (p <= max);
                holds(min.x, p.x, max.x) & holds(min.y, p.y, max.y) & holds(min.z, p.z, max.z)
            }
            form @ AabbForm::Center { .. } => {
                // A point is a box of no extent.
                p.is_finite()
                    && !S::evaluate(&Apart::new(form, &AabbForm::Corners { min: p, max: p }))
            }
        }
    }
}
