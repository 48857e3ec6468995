use core::cmp::Ordering;

use super::Vec3;
use super::overlaps::overlaps_methods;
use super::{Aabb, ShapeError, finite, finite_at};
use crate::arithmetic::{Each, pick, turn};
use crate::robust::ExactSum;
use crate::scalar::Scalar;

/// An oriented box: a centre, three axes, and a half-extent along each.
///
/// The box is the set of all points c + s·u + t·v + w·n, with c the centre, u, v, n the axes **as
/// given**, and s, t, w each within its half-extent. Axes computed from a rotation are rounded, so
/// they are not exactly orthogonal and not exactly of length one: the numbers describe a
/// parallelepiped that is very nearly a box. Exact verdicts are about that parallelepiped.
///
/// ```
/// use septum::{Obb, ShapeError, Triangle};
///
/// // A unit cube, turned by an eighth about z.
/// let r = 0.5_f32.sqrt();
/// let axes = [[r, r, 0.0], [-r, r, 0.0], [0.0, 0.0, 1.0]];
/// let tool = Obb::new([0.0, 0.0, 0.0], axes, [0.5, 0.5, 0.5])?;
///
/// // Beyond the faces of the unturned cube, but within reach of the turned one's edge.
/// let t = Triangle::new([0.7, -1.0, 0.0], [0.7, 1.0, 0.0], [2.0, 0.0, 0.0])?;
/// assert!(t.overlaps(&tool));
/// # Ok::<(), ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Obb<S> {
    pub(super) center: Vec3<S>,
    pub(super) axes: [Vec3<S>; 3],
    pub(super) half: Vec3<S>,
}

impl<S: Scalar> Obb<S> {
    /// A box around `center` that extends `half_extents` to either side along its `axes`, three
    /// unit vectors at right angles to each other.
    ///
    /// The constructor checks the axes to catch mistakes: each dot product of two axes, and of an
    /// axis with itself, may be off by up to one eighth. Rounding a rotation stays within that,
    /// even in 8 bits, and most mistakes do not. No verdict depends on this check. Floats are
    /// checked in their own arithmetic. Fixed-point types of more than 14 fraction bits are checked
    /// by their upper 14 fraction bits, so dot products within 2⁻¹² of the limit may pass or fail.
    /// With fewer fraction bits the check is exact.
    ///
    /// A fixed-point type without integer bits has no vector of length one. Use
    /// [`from_skewed_axes`](Self::from_skewed_axes) there, for example with axes of half the length
    /// and half-extents of twice the size.
    ///
    /// # Errors
    /// [`ShapeError::NotFinite`], [`ShapeError::NegativeHalfExtent`], [`ShapeError::NoUnitLength`]
    /// if the scalar has no integer bits, and [`ShapeError::NotOrthonormal`] if the axes fail the
    /// check.
    pub fn new(
        center: impl Into<Vec3<S>>,
        axes: [impl Into<Vec3<S>>; 3],
        half_extents: impl Into<Vec3<S>>,
    ) -> Result<Self, ShapeError> {
        let made = Self::checked(center, axes, half_extents)?;
        match S::are_orthonormal(&made.axes_as_arrays()) {
            Some(true) => Ok(made),
            Some(false) => Err(ShapeError::NotOrthonormal),
            None => Err(ShapeError::NoUnitLength),
        }
    }

    /// A parallelepiped around `center`, along any three axes that span space. The `half_extents`
    /// are in units of the length of each axis.
    ///
    /// # Errors
    /// [`ShapeError::NotFinite`], [`ShapeError::NegativeHalfExtent`], and
    /// [`ShapeError::DependentAxes`] if the axes do not span space, which is decided exactly.
    pub fn from_skewed_axes(
        center: impl Into<Vec3<S>>,
        axes: [impl Into<Vec3<S>>; 3],
        half_extents: impl Into<Vec3<S>>,
    ) -> Result<Self, ShapeError> {
        let made = Self::checked(center, axes, half_extents)?;
        match made.hand() {
            Ordering::Equal => Err(ShapeError::DependentAxes),
            Ordering::Less | Ordering::Greater => Ok(made),
        }
    }

    pub(super) fn checked(
        center: impl Into<Vec3<S>>,
        axes: [impl Into<Vec3<S>>; 3],
        half_extents: impl Into<Vec3<S>>,
    ) -> Result<Self, ShapeError> {
        let (center, half) = (finite("center", center)?, finite("half_extents", half_extents)?);
        let [u, v, w] = axes;
        let axis = |i, axis| finite_at("axes", Some(i), axis);
        let axes = [axis(0, u)?, axis(1, v)?, axis(2, w)?];
        if half.x < S::ZERO || half.y < S::ZERO || half.z < S::ZERO {
            return Err(ShapeError::NegativeHalfExtent);
        }
        Ok(Self { center, axes, half })
    }
}

overlaps_methods!(
    Obb,
    "a [`Triangle`](crate::Triangle), an [`Aabb`](crate::Aabb), another oriented box, a \
     [`Segment`](crate::Segment), a [`Ray`](crate::Ray), a [`Sphere`](crate::Sphere) or a \
     [`Capsule`](crate::Capsule)"
);

impl<S: Scalar> Obb<S> {
    /// The bounding box: the smallest axis-aligned box that encloses the oriented box and whose
    /// corners are numbers of the scalar.
    ///
    /// *Numerics*: each corner is rounded outward, to the next number of the scalar. The bounding
    /// box is never smaller than the oriented box, and each face is less than one unit in the last
    /// place outside it.
    ///
    /// *Range*: floats return `None` if a corner lies beyond the greatest number. Fixed point
    /// always returns a box; where the oriented box extends beyond the range of the type, the
    /// bounding box ends at the range. The part cut off contains no point of the type, so shapes
    /// given by their vertices miss nothing.
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: 9 multiplications, in fixed point of twice the width, and for `f32` in `f64`. `f64`
    /// always takes exact sums, which cost about a hundred times as much; `f32` takes them where
    /// `f64` leaves the last place in doubt.
    ///
    /// ```
    /// use septum::{Obb, Vec3};
    ///
    /// let axes = [[0.8, 0.6, 0.0], [-0.6, 0.8, 0.0], [0.0, 0.0, 1.0]];
    /// let tool = Obb::new([10.0_f32, 0.0, 0.0], axes, [2.0, 1.0, 0.5])?;
    /// let (min, max) = tool.aabb().unwrap().min_max().unwrap();
    /// assert!(min.x <= 7.8 && 7.79 < min.x && max.y >= 2.0 && max.z == 0.5);
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[must_use]
    #[doc(alias = "bounding_box")]
    pub fn aabb(&self) -> Option<Aabb<S>> {
        let Self { center: c, axes: [u, v, w], half } = *self;
        let half = half.to_array();
        let (x, y, z) = (
            S::enclosed(c.x, [u.x, v.x, w.x], half)?,
            S::enclosed(c.y, [u.y, v.y, w.y], half)?,
            S::enclosed(c.z, [u.z, v.z, w.z], half)?,
        );
        Some(Aabb::between(Vec3::new(x.0, y.0, z.0), Vec3::new(x.1, y.1, z.1)))
    }

    /// The same box with its axes in another order, of the same hand.
    pub(crate) fn turned(&self) -> Self {
        let Self { center, axes: [u, v, w], half } = *self;
        Self { center, axes: [v, w, u], half: Vec3::new(half.y, half.z, half.x) }
    }

    /// The axes as arrays of coordinates.
    #[inline(always)]
    pub(crate) fn axes_as_arrays(&self) -> [[S; 3]; 3] {
        let [u, v, w] = self.axes;
        [u.to_array(), v.to_array(), w.to_array()]
    }

    /// The centre, the axes and the half-extents.
    #[inline(always)]
    pub(crate) fn numbers(&self) -> [[S; 3]; 5] {
        let [u, v, w] = self.axes_as_arrays();
        [self.center.to_array(), u, v, w, self.half.to_array()]
    }

    /// `Less` if the axes are left-handed, `Greater` if they are right-handed.
    pub(crate) fn hand(&self) -> Ordering {
        hand(&self.axes_as_arrays())
    }

    /// Whether [`new`](Self::new) would accept the axes.
    #[cfg(feature = "serde")]
    pub(crate) fn is_orthonormal(&self) -> bool {
        S::are_orthonormal(&self.axes_as_arrays()) == Some(true)
    }
}

impl<S: Copy> Obb<S> {
    /// The centre.
    #[inline]
    #[must_use]
    pub const fn center(&self) -> Vec3<S> {
        self.center
    }

    /// The three axes, as given.
    #[inline]
    #[must_use]
    pub const fn axes(&self) -> &[Vec3<S>; 3] {
        &self.axes
    }

    /// The half-extent along each axis, in units of its length.
    #[inline]
    #[must_use]
    pub const fn half_extents(&self) -> Vec3<S> {
        self.half
    }
}

/// The exact sign of the triple product u·(v×n). [`robust::side`](crate::robust::side) takes vectors of three
/// numbers in a coordinate, and three times the instructions.
fn hand<S: Scalar>(axes: &[[S; 3]; 3]) -> Ordering {
    let [u, v, n] = axes;
    let mut sum = S::SeptumSum::new();
    for i in 0..3 {
        let (i, j, k) = turn(i);
        let [u, vj, vk] = [pick(u, i), pick(v, j), pick(v, k)].each(|x| x.parts());
        let [nj, nk] = [pick(n, j), pick(n, k)].each(|x| x.parts());
        sum.add(&[u, vj, nk]);
        sum.add(&[u.negated(), vk, nj]);
    }
    sum.sign()
}
