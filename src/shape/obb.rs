use core::cmp::Ordering;

use super::{ShapeError, finite};
use crate::linear::{Vec3, turn};
use crate::scalar::{ExactSum, Parts, Scalar};

/// An oriented box: a centre, three axes, and a half-extent along each.
///
/// The box is the set of all c + s·u + t·v + w·n, with c the centre, u, v, n the
/// axes **as given**, and s, t, w each within its half-extent. Axes that came
/// from a rotation are rounded, and so not quite at right angles nor quite of
/// length one: what the numbers describe is a parallelepiped very near to a box.
/// That parallelepiped is what an exact verdict is about.
///
/// ```
/// use septum::{Obb, ShapeError, Triangle};
///
/// // A unit cube, turned by an eighth about z.
/// let r = 0.5_f32.sqrt();
/// let axes = [[r, r, 0.0].into(), [-r, r, 0.0].into(), [0.0, 0.0, 1.0].into()];
/// let tool = Obb::new([0.0, 0.0, 0.0], axes, [0.5, 0.5, 0.5])?;
///
/// // Past the corner of the cube as it was, met by the edge of the turned one.
/// let t = Triangle::new([0.7, -1.0, 0.0], [0.7, 1.0, 0.0], [2.0, 0.0, 0.0])?;
/// assert!(t.overlaps(&tool));
/// # Ok::<(), ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Obb<S> {
    center: Vec3<S>,
    axes: [Vec3<S>; 3],
    half: Vec3<S>,
}

impl<S: Scalar> Obb<S> {
    /// The box around `center` that reaches `half_extents` to either side along
    /// its `axes`, which are unit vectors at right angles to one another.
    ///
    /// Dot products may be off by one eighth: more than any rounding takes a
    /// rotation, even in 8 bits, and less than most mistakes do. The check is
    /// against mistakes; it has no part in a verdict.
    ///
    /// # Errors
    /// [`ShapeError::NotFinite`], [`ShapeError::NegativeHalfExtent`], and
    /// [`ShapeError::NotOrthonormal`] where the axes are no frame.
    pub fn new(
        center: impl Into<Vec3<S>>,
        axes: [Vec3<S>; 3],
        half_extents: impl Into<Vec3<S>>,
    ) -> Result<Self, ShapeError> {
        let made = Self::checked(center, axes, half_extents)?;
        for i in 0..3 {
            for j in i..3 {
                if !near_unit(&axes[i], &axes[j], i == j) {
                    return Err(ShapeError::NotOrthonormal);
                }
            }
        }
        Ok(made)
    }

    /// The same with any three axes that span space: a parallelepiped, whose
    /// `half_extents` are in units of the length of each axis.
    ///
    /// # Errors
    /// [`ShapeError::NotFinite`], [`ShapeError::NegativeHalfExtent`], and
    /// [`ShapeError::DependentAxes`] where the axes do not span space, decided
    /// exactly.
    pub fn from_skewed_axes(
        center: impl Into<Vec3<S>>,
        axes: [Vec3<S>; 3],
        half_extents: impl Into<Vec3<S>>,
    ) -> Result<Self, ShapeError> {
        let made = Self::checked(center, axes, half_extents)?;
        if dependent(&axes) { Err(ShapeError::DependentAxes) } else { Ok(made) }
    }

    fn checked(
        center: impl Into<Vec3<S>>,
        axes: [Vec3<S>; 3],
        half_extents: impl Into<Vec3<S>>,
    ) -> Result<Self, ShapeError> {
        let (center, half) = (finite(center)?, finite(half_extents)?);
        for axis in axes {
            finite(axis)?;
        }
        if half.x < S::ZERO || half.y < S::ZERO || half.z < S::ZERO {
            return Err(ShapeError::NegativeHalfExtent);
        }
        Ok(Self { center, axes, half })
    }
}

impl<S: Copy> Obb<S> {
    /// The centre.
    #[inline]
    pub const fn center(&self) -> Vec3<S> {
        self.center
    }

    /// The three axes, as given.
    #[inline]
    pub const fn axes(&self) -> &[Vec3<S>; 3] {
        &self.axes
    }

    /// The half-extent along each axis, in units of its length.
    #[inline]
    pub const fn half_extents(&self) -> Vec3<S> {
        self.half
    }
}

/// Whether u·v is within one eighth of one (`same`) or of nought, exactly.
fn near_unit<S: Scalar>(u: &Vec3<S>, v: &Vec3<S>, same: bool) -> bool {
    let whole = |magnitude, negative| Parts { negative, magnitude, shift: 0 };
    let target = if same { 8 } else { 0 };
    // 8·u·v − bound, with bound in eighths of one.
    let against = |bound: i64| {
        let mut sum = S::Sum::new();
        for (a, b) in u.to_array().into_iter().zip(v.to_array()) {
            sum.add(&[whole(8, false), a.parts(), b.parts()]);
        }
        sum.add(&[whole(bound.unsigned_abs(), bound > 0), S::ONE, S::ONE]);
        sum.sign()
    };
    against(target - 1) != Ordering::Less && against(target + 1) != Ordering::Greater
}

/// Whether u·(v×n) is nought, exactly.
fn dependent<S: Scalar>(axes: &[Vec3<S>; 3]) -> bool {
    let [u, v, n] = axes.map(|a| a.to_array().map(S::parts));
    let mut sum = S::Sum::new();
    for i in 0..3 {
        let (i, j, k) = turn(i);
        sum.add(&[u[i], v[j], n[k]]);
        sum.add(&[u[i].negated(), v[k], n[j]]);
    }
    sum.sign() == Ordering::Equal
}
