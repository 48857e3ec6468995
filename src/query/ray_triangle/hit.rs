//! The hit of a ray on a triangle, and the rules for counting hits.

use crate::arithmetic::Each;
use crate::scalar::Scalar;
use crate::shape::{Ray, Vec3};

/// A hit of a ray on a triangle.
///
/// The hit point is `origin + t·direction` on the ray and w·a + u·b + v·c on the triangle, with w =
/// 1 − u − v.
///
/// In floats, t, u and v may be −0.0, which equals 0.0: they are quotients, and the divisor is
/// negative if the [back](Facing::Back) is hit. So compare numbers, not bits. If the hit lies
/// farther along the ray than the greatest number, a float t is infinite, and a fixed-point t is
/// the greatest number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Hit<S> {
    /// The distance along the ray, in units of its direction.
    pub t: S,
    /// The barycentric coordinate of the second vertex.
    pub u: S,
    /// The barycentric coordinate of the third vertex.
    pub v: S,
    /// The side of the triangle that was hit.
    pub facing: Facing,
    /// The part of the triangle that was hit.
    pub feature: Feature,
}

/// The side of a triangle that a ray comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Facing {
    /// The side from which the vertices appear counterclockwise: the ray runs against the normal (b
    /// − a) × (c − a). On a closed mesh with outward normals, the ray enters.
    Front,
    /// The other side; on such a mesh, the ray leaves.
    Back,
}

impl Facing {
    #[inline(always)]
    pub(super) fn of(is_front: bool) -> Self {
        if is_front { Self::Front } else { Self::Back }
    }
}

/// The part of a triangle that a ray goes through.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Feature {
    /// The interior.
    Interior,
    /// Edge k, from vertex k to the next, without its ends.
    Edge(u8),
    /// Vertex k.
    Vertex(u8),
}

/// The hits that do not count: culling by the side of the triangle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Cull {
    /// All hits count.
    #[default]
    Nothing,
    /// Hits on the back do not count.
    Back,
    /// Hits on the front do not count.
    Front,
}

impl Cull {
    /// Does a hit on this side count?
    #[inline]
    #[must_use]
    pub fn keeps(self, facing: Facing) -> bool {
        match self {
            Self::Nothing => true,
            Self::Back => facing == Facing::Front,
            Self::Front => facing == Facing::Back,
        }
    }
}

/// The rules for counting hits. By default every hit counts, contacts included.
///
/// ```
/// use septum::{Cull, HitRules, Ray, Triangle};
///
/// let ray = Ray::new([0.25, 0.25, 1.0], [0.0, 0.0, -1.0])?;
/// let t = Triangle::new([0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0])?;
/// let rules = HitRules::new().culling(Cull::Front).once();
/// assert!(ray.hit_with(&t, rules).is_none());
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HitRules {
    pub(super) cull: Cull,
    pub(super) once: bool,
}

impl HitRules {
    /// All hits count, contacts included.
    #[must_use]
    pub const fn new() -> Self {
        Self { cull: Cull::Nothing, once: false }
    }

    /// The same rules, with hits on one side culled.
    #[must_use]
    pub const fn culling(self, cull: Cull) -> Self {
        Self { cull, ..self }
    }

    /// The same rules, except that a hit on an edge or a vertex counts for only one of the
    /// triangles there: see [`Ray::hit_once`].
    #[must_use]
    pub const fn once(self) -> Self {
        Self { once: true, ..self }
    }
}

impl Feature {
    /// The feature at a point, from the barycentric coordinates of the first, second and third
    /// vertex that are zero.
    #[inline]
    pub(crate) fn from_zeros(w: bool, u: bool, v: bool) -> Self {
        match (w, u, v) {
            (false, false, true) => Self::Edge(0),
            (true, false, false) => Self::Edge(1),
            (false, true, false) => Self::Edge(2),
            (_, true, true) => Self::Vertex(0),
            (true, _, true) => Self::Vertex(1),
            (true, true, _) => Self::Vertex(2),
            (false, false, false) => Self::Interior,
        }
    }
}

/// A possible hit, for many pairs at once. The other fields are valid only if `hit` is true.
#[derive(Clone, Copy)]
pub(crate) struct Candidate<S> {
    pub hit: bool,
    pub t: S,
    pub u: S,
    pub v: S,
    pub marks: u8,
}

impl<S: Scalar> Candidate<S> {
    /// `zeros` says which of w, u and v are zero.
    #[inline(always)]
    pub(crate) fn new(hit: bool, [t, u, v]: [S; 3], front: bool, zeros: [bool; 3]) -> Self {
        let [w_is_zero, u_is_zero, v_is_zero] = zeros.each(u8::from);
        let marks = u8::from(front) | w_is_zero << 1 | u_is_zero << 2 | v_is_zero << 3;
        Self { hit, t, u, v, marks }
    }

    #[inline(always)]
    pub(crate) fn none() -> Self {
        Self { hit: false, t: S::ZERO, u: S::ZERO, v: S::ZERO, marks: 0 }
    }

    #[inline(always)]
    pub(crate) fn from_hit(hit: Hit<S>) -> Self {
        let zeros = match hit.feature {
            Feature::Interior => [false; 3],
            Feature::Edge(k) => [k == 1, k == 2, k == 0],
            Feature::Vertex(k) => [k != 0, k != 1, k != 2],
        };
        Self::new(true, [hit.t, hit.u, hit.v], hit.facing == Facing::Front, zeros)
    }

    #[inline(always)]
    pub(crate) fn into_hit(self) -> Option<Hit<S>> {
        let Self { hit, t, u, v, marks } = self;
        let is = |bit: u8| marks & bit != 0;
        let facing = if is(1) { Facing::Front } else { Facing::Back };
        let feature = Feature::from_zeros(is(2), is(4), is(8));
        if hit { Some(Hit { t, u, v, facing, feature }) } else { None }
    }
}

impl<S: Scalar> Hit<S> {
    /// The barycentric coordinate of the first vertex, 1 − u − v, rounded.
    ///
    /// *Panics*: never.
    #[inline]
    #[must_use]
    pub fn w(&self) -> S {
        S::rest_of_one(self.u, self.v)
    }

    /// The hit point, rounded: one multiplication and one addition for each coordinate. In fixed
    /// point it wraps if it is out of range.
    ///
    /// *Panics*: never.
    #[inline]
    #[must_use]
    pub fn point(&self, ray: &Ray<S>) -> Vec3<S> {
        let (o, d) = (ray.origin(), ray.direction());
        let at = |o: S, d: S| o.plain_add(d.plain_mul(self.t));
        Vec3::new(at(o.x, d.x), at(o.y, d.y), at(o.z, d.z))
    }
}
