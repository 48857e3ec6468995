//! Points against boxes and triangles.

mod obb;

use super::aabb_aabb::Apart;
use super::orientation::{are_apart, from, in_doubt, sides, size};
use super::relation::{Asked, Relation};
use crate::arithmetic::Embeds;
use crate::robust::Predicate;
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Triangle, Vec3};

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

/// The question for the relation of point and triangle.
struct Lies<'a, S> {
    point: [S; 3],
    triangle: &'a Triangle<S>,
}

impl<S: Scalar> Predicate<S> for Lies<'_, S> {
    type Answer = Relation;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<Relation> {
        let [a, b, c] = self.triangle.points();
        let [a, b, c, point] = N::embed(&[a, b, c, self.point])?;
        let (e, f) = (from::<N>(&b, &a), from::<N>(&c, &a));
        let to_point = [from::<N>(&point, &a)];
        match sides::<N, 1>([&e, &f], &to_point, size::<N, 1>(&to_point))? {
            [0] => in_doubt::<N>(&[point; 3], &[a, b, c], Asked::Overlaps),
            _ => Some(Relation::Disjoint),
        }
    }
}

impl<S: Scalar> Triangle<S> {
    /// Does the triangle contain a point?
    ///
    /// *Geometry*: a closed set, which may be a segment or a point. No triangle contains a point
    /// with a NaN or infinite coordinate.
    ///
    /// *Contact*: a point on an edge is in the triangle.
    ///
    /// *Numerics*: exact for every valid input, in every scalar. Note that a point computed to lie
    /// in a triangle is rounded, and usually lies off its plane.
    ///
    /// *Range*: as for [two triangles](Triangle#impl-Overlaps<Triangle<S>>-for-Triangle<S>). In
    /// floats a point in the plane takes exact integers.
    ///
    /// *Panics*: never. *Cost*: 9 multiplications for a point off the plane.
    ///
    /// ```
    /// use septum::Triangle;
    ///
    /// let t = Triangle::new([0.0_f32, 0.0, 0.0], [4.0, 0.0, 2.0], [0.0, 4.0, 2.0])?;
    /// assert!(t.contains([1.0, 1.0, 1.0]));
    /// assert!(t.contains([2.0, 2.0, 2.0])); // on an edge
    /// assert!(!t.contains([1.0, 1.0, 1.0000001]));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    #[must_use]
    pub fn contains(&self, point: impl Into<Vec3<S>>) -> bool {
        let p = point.into();
        let point = p.to_array();
        p.is_finite()
            && !are_apart(&[point], &self.points())
            && S::evaluate(&Lies { point, triangle: self }) != Relation::Disjoint
    }
}
