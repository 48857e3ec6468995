//! The triangle of a mesh closest to a point.
//!
//! Each box on the way down has a lower bound of its distance, and each triangle a lower and an upper
//! bound. Triangles whose bounds overlap are compared exactly.

use core::cmp::Ordering;
use core::ops::ControlFlow;

use super::approach::{Approach, Bounds, InFloats, InIntegers};
use super::ray::{is_same, met};
use super::walk::descend;
use super::{Index, Tree};
use crate::query::{Closest, compare_distances};
use crate::scalar::Scalar;
use crate::shape::{Sphere, Triangle, Vec3};

impl<S: Scalar, I: Index> Tree<'_, S, I> {
    /// The triangle closest to a point, with its closest point and the vertex or edge on which that
    /// lies; `None` for a mesh without triangles, and for a point with a NaN or infinite coordinate.
    ///
    /// *Contact*: of several triangles at the same distance, as at a shared edge, the lowest index
    /// wins.
    ///
    /// *Numerics*: the triangle is exact: distances compare as real numbers, in products of up to
    /// ten lengths. The closest point has the bits of [`Triangle::closest_point`].
    /// [`Triangle::distance_squared`] of the triangle is the distance from the mesh. *Panics*: never.
    ///
    /// *Cost*: 36 multiplications for four boxes together, and 50 with up to two divisions for each
    /// triangle whose bounding box is nearer than the closest so far; in fixed point on 32-bit cores
    /// three for each box, and [`Triangle::closest_point`] for each such triangle. The stack is that of
    /// [`first_hit`](Self::first_hit).
    ///
    /// ```
    /// use septum::mesh::{Mesh, Node, Tree};
    /// use septum::{Feature, Vec3};
    ///
    /// // Two sheets, one above the other.
    /// let corners = [
    ///     [0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0],
    ///     [0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [0.0, 4.0, 1.0],
    /// ].map(Vec3::from);
    /// let mesh = Mesh::new(&corners, &[[0_u16, 1, 2], [3, 4, 5]])?;
    /// let (mut nodes, mut order) = ([Node::EMPTY], [0; 2]);
    /// let tree = Tree::build(mesh, &mut nodes, &mut order)?;
    ///
    /// let (i, closest) = tree.closest_point([1.0, -2.0, 0.75]).unwrap();
    /// assert_eq!((i, closest.feature), (1, Feature::Edge(0)));
    /// assert_eq!(closest.point, Vec3::new(1.0, 0.0, 1.0));
    /// assert_eq!(tree.closest_point([1.0, 1.0, 0.5]).unwrap().0, 0); // as far from both
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "project_point")]
    #[doc(alias = "distance")]
    #[must_use]
    pub fn closest_point(&self, point: impl Into<Vec3<S>>) -> Option<(usize, Closest<S>)> {
        let point: Vec3<S> = point.into();
        point.is_finite().then(|| self.closest_to(point, None))?
    }

    /// [`closest_point`](Self::closest_point), if it lies within a distance; `None` as well for a
    /// distance that is negative, NaN or infinite.
    ///
    /// *Contact*: a triangle at that distance is within it. *Numerics*: exact, as whether a
    /// [`Sphere`] overlaps. *Panics*: never. *Cost*: as [`closest_point`](Self::closest_point),
    /// without boxes beyond the distance.
    #[must_use]
    pub fn closest_point_within(
        &self,
        point: impl Into<Vec3<S>>,
        distance: S,
    ) -> Option<(usize, Closest<S>)> {
        let sphere = Sphere::new(point, distance).ok()?;
        let (i, closest) = self.closest_to(sphere.center(), Some(distance))?;
        sphere.overlaps(&self.mesh.known(i)).then_some((i, closest))
    }

    /// The square of the distance from a point to the closed mesh, negative for a point inside; zero
    /// on a triangle, and `None` as for [`closest_point`](Self::closest_point).
    ///
    /// *Geometry*: what is inside [`contains`](Self::contains) says.
    ///
    /// *Numerics*: the triangle and the sign are exact; the square is
    /// [`Triangle::distance_squared`], rounded once. Zero off all triangles is a square below the
    /// least number. *Panics*: never. *Cost*: that of both questions.
    ///
    /// ```
    /// use septum::mesh::{Mesh, Node, Tree};
    /// use septum::Vec3;
    ///
    /// let corners = [[0.0; 3], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0], [0.0, 0.0, 8.0]].map(Vec3::from);
    /// let mesh = Mesh::new(&corners, &[[0_u16, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])?;
    /// let (mut nodes, mut order) = ([Node::EMPTY; 1], [0; 4]);
    /// let tree = Tree::build(mesh, &mut nodes, &mut order)?;
    ///
    /// assert_eq!(tree.signed_distance_squared([1.0, 1.0, 0.5]), Some(-0.25));
    /// assert_eq!(tree.signed_distance_squared([1.0, 1.0, -2.0]), Some(4.0));
    /// assert_eq!(tree.signed_distance_squared([1.0, 1.0, 0.0]), Some(0.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "sdf")]
    #[must_use]
    pub fn signed_distance_squared(&self, point: impl Into<Vec3<S>>) -> Option<S> {
        let point: Vec3<S> = point.into();
        let (i, _) = self.closest_point(point)?;
        let squared = self.mesh.known(i).distance_squared(point).ok()?;
        Some(if self.contains(point) { S::of_ordinal(-squared.ordinal()) } else { squared })
    }

    fn closest_to(&self, point: Vec3<S>, within: Option<S>) -> Option<(usize, Closest<S>)> {
        let p = point.to_array();
        let i = if S::IS_FAST {
            self.find(p, InFloats::new(&self.grid, p, within))
        } else {
            self.find(p, InIntegers::new(&self.grid, p, within))
        }?;
        Some((i, self.mesh.known(i).closest_point(point).ok()?))
    }

    /// The index of the triangle closest to a point.
    fn find<A: Approach<S>>(&self, p: [S; 3], mut approach: A) -> Option<usize> {
        let mut best: Option<(usize, Bounds<A::Square>)> = None;
        let _ = descend(self.nodes, &self.layout, &mut approach, |approach, leaf| {
            for i in leaf.map(|place| self.index(place)) {
                let triangle = self.mesh.known(i);
                let Some(bounds) = approach.bounds(&triangle) else { continue };
                let new = match best {
                    None => (i, bounds),
                    Some((k, of_best)) => match bounds.compare(&of_best) {
                        Some(Ordering::Greater) => continue,
                        Some(_) => (i, bounds),
                        None if is_closer(p, (i, &triangle), (k, &self.mesh.known(k))) => {
                            (i, bounds.up_to(&of_best))
                        }
                        None => (k, of_best.up_to(&bounds)),
                    },
                };
                approach.limit(&new.1);
                best = Some(new);
            }
            ControlFlow::Continue(())
        });
        Some(best?.0)
    }
}

/// Whether a triangle is closer to a point than another, or as close with the lower index.
#[cold]
#[inline(never)]
fn is_closer<S: Scalar>(
    p: [S; 3],
    (i, t): (usize, &Triangle<S>),
    (k, s): (usize, &Triangle<S>),
) -> bool {
    let (of_t, of_s) = (t.closest_feature(p), s.closest_feature(p));
    // A shortcut to the answer that the exact comparison would give.
    if is_same(&met(t, of_t), &met(s, of_s)) {
        return i < k;
    }
    compare_distances(p, [(t, of_t), (s, of_s)]).then(i.cmp(&k)).is_lt()
}
