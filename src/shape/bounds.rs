//! Bounding boxes.

use super::aabb::{Form, joined};
use super::polygon::Polygon;
use super::segment::Form as SegmentForm;
use super::{Aabb, Capsule, Segment, Sphere, Triangle, Vec3};
use crate::arithmetic::{Each, three};
use crate::scalar::Scalar;

impl<S: Scalar> Aabb<S> {
    /// The least and the greatest corner.
    ///
    /// *Numerics*: the corners of a box given by its centre are rounded outward, to the next number
    /// of the scalar. Corners that were given are returned as they are.
    ///
    /// *Range*: floats return `None` if a corner lies beyond the greatest number. Fixed point clamps
    /// the corners to its range.
    #[inline]
    #[must_use]
    pub fn min_max(&self) -> Option<(Vec3<S>, Vec3<S>)> {
        match self.form {
            Form::Corners { min, max } => Some((min, max)),
            Form::Center { center, half } => {
                let [min, max] = around(center, half)?.each(Vec3::from);
                Some((min, max))
            }
        }
    }

    /// The smallest box that contains both boxes and whose corners are numbers of the scalar.
    ///
    /// *Numerics* and *Range*: as for [`min_max`](Self::min_max).
    ///
    /// ```
    /// use septum::{Aabb, Vec3};
    ///
    /// let a = Aabb::from_center_half_extents([0.0_f32; 3], [1.0; 3])?;
    /// let b = Aabb::from_min_max([2.0, 0.0, 0.0], [3.0, 0.5, 0.5])?;
    /// let both = a.union(&b).unwrap().min_max().unwrap();
    /// assert_eq!(both, (Vec3::splat(-1.0), Vec3::new(3.0, 1.0, 1.0)));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[doc(alias = "merge")]
    #[must_use]
    pub fn union(&self, other: &Self) -> Option<Self> {
        let ((a, b), (c, d)) = (self.min_max()?, other.min_max()?);
        Some(between(joined([a, b].each(Vec3::to_array), [c, d].each(Vec3::to_array))))
    }
}

impl<S: Scalar> Triangle<S> {
    /// The bounding box: the smallest axis-aligned box that contains the triangle. Exact.
    #[doc(alias = "bounding box")]
    #[must_use]
    pub fn aabb(&self) -> Aabb<S> {
        between(self.corners())
    }

    /// The corners of the bounding box.
    #[inline(always)]
    pub(crate) fn corners(&self) -> [[S; 3]; 2] {
        let [a, b, c] = self.points();
        joined(joined([a, a], [b, b]), [c, c])
    }
}

impl<S: Scalar> Segment<S> {
    /// The bounding box: the smallest axis-aligned box that contains the segment and whose corners
    /// are numbers of the scalar.
    ///
    /// *Numerics* and *Range*: as for [`Aabb::min_max`], with the centre and the half-vector in
    /// place of centre and half-extents. The box of a segment given by its ends is exact.
    #[doc(alias = "bounding box")]
    #[must_use]
    pub fn aabb(&self) -> Option<Aabb<S>> {
        self.corners().map(between)
    }

    /// The corners of the bounding box.
    pub(crate) fn corners(&self) -> Option<[[S; 3]; 2]> {
        match *self.form() {
            SegmentForm::Ends(a, b) => {
                let [a, b] = [a, b].each(Vec3::to_array);
                Some(joined([a, a], [b, b]))
            }
            SegmentForm::Center { center, half } => around(center, half),
        }
    }
}

impl<S: Scalar> Sphere<S> {
    /// The bounding box: the smallest axis-aligned box that contains the sphere and whose corners are
    /// numbers of the scalar.
    ///
    /// *Numerics* and *Range*: as for [`Aabb::min_max`], with the radius in place of the
    /// half-extents.
    #[doc(alias = "bounding box")]
    #[must_use]
    pub fn aabb(&self) -> Option<Aabb<S>> {
        self.corners().map(between)
    }

    /// The corners of the bounding box.
    pub(crate) fn corners(&self) -> Option<[[S; 3]; 2]> {
        around(self.center, Vec3::splat(self.radius))
    }
}

impl<S: Scalar> Capsule<S> {
    /// The bounding box: the smallest axis-aligned box that contains the capsule and whose corners
    /// are numbers of the scalar.
    ///
    /// *Numerics* and *Range*: as for [`Sphere::aabb`].
    #[doc(alias = "bounding box")]
    #[must_use]
    pub fn aabb(&self) -> Option<Aabb<S>> {
        self.corners().map(between)
    }

    /// The corners of the bounding box.
    pub(crate) fn corners(&self) -> Option<[[S; 3]; 2]> {
        let radii = Vec3::splat(self.radius);
        Some(joined(around(self.a, radii)?, around(self.b, radii)?))
    }
}

impl<S: Scalar> Polygon<'_, S> {
    /// The bounding box: the smallest axis-aligned box that contains the polygon. Exact.
    #[doc(alias = "bounding box")]
    #[must_use]
    pub fn aabb(&self) -> Aabb<S> {
        // The constructor made sure of finite vertices; `unwrap_or_else` links no panic.
        let points = Aabb::from_points(self.vertices.iter().copied());
        points.unwrap_or_else(|_| Aabb::about_origin(Vec3::splat(S::ZERO)))
    }
}

#[inline(always)]
fn between<S: Scalar>([min, max]: [[S; 3]; 2]) -> Aabb<S> {
    Aabb::between(min.into(), max.into())
}

/// The corners of a box given by its centre, rounded outward; `None` if a float overflows.
fn around<S: Scalar>(center: Vec3<S>, half: Vec3<S>) -> Option<[[S; 3]; 2]> {
    let (c, h) = (center.to_array(), half.to_array());
    let ends = three(|i| c[i].reach(h[i]));
    let are_finite = ends.as_flattened().iter().all(|x| x.is_finite());
    are_finite.then(|| [ends.each(|[low, _]| low), ends.each(|[_, high]| high)])
}
