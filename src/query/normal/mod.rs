//! Unit normals. They need a square root, which nothing else here does, and the caller chooses the
//! root. `unit_normal` for fixed point is here; the functions for `libm` and
//! `micromath` are in `interop`.

#[cfg(feature = "libm")]
mod direction;

use crate::arithmetic::{Embeds, Number, cross, three};
use crate::query::{Facing, Hit};
use crate::robust::{Predicate, Profile};
#[cfg(feature = "fixed")]
use crate::scalar::FixedPoint;
use crate::scalar::Scalar;
use crate::shape::{Triangle, Vec3};
#[cfg(feature = "libm")]
pub(crate) use direction::direction;

#[cfg(feature = "fixed")]
impl<S: FixedPoint> Triangle<S> {
    /// The unit normal (b − a) × (c − a) / |(b − a) × (c − a)| in fixed point, by an integer root;
    /// `None` if the triangle is degenerate.
    ///
    /// *When to choose it*: in fixed point, always. It needs no float, no division and no feature
    /// except `fixed`, and its bits are the same on every machine. Narrow types are faster.
    ///
    /// *Geometry*: seen from the side that the normal points to, the vertices go counterclockwise.
    /// [`Hit::oriented`] turns it to the side that a ray comes from.
    ///
    /// *Numerics*: each component is the representable number nearest to the true one, for slivers
    /// too; a tie cannot occur. The length is therefore off by rounding alone, at most by 0.87
    /// units in the last place.
    ///
    /// *Range*: all of the type. In a type that cannot hold 1, a component of 1 becomes `MAX`, as
    /// in I1F15; −1 is representable there.
    ///
    /// *Panics*: never. *Cost*: nine multiplications, no division, and about four additions for
    /// each fraction bit of each component. The width is the narrowest of 64, 128, 192 and 384 bits
    /// that suffices.
    ///
    /// *Source*: the digit-by-digit square root, here of a quotient that is never divided out.
    ///
    /// ```
    /// use fixed::types::I16F16;
    /// use septum::{Triangle, Vec3};
    ///
    /// let fx = |p: [f64; 3]| p.map(I16F16::from_num);
    /// let ramp = Triangle::new(fx([0.0; 3]), fx([4.0, 0.0, 3.0]), fx([0.0, 1.0, 0.0]))?;
    /// let normal = Vec3::from(fx([-0.6, 0.0, 0.8]));
    /// assert_eq!(ramp.unit_normal(), Some(normal));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[must_use]
    pub fn unit_normal(&self) -> Option<Vec3<S>> {
        let [a, b, c] = self.vertices();
        let x = S::area([a.y, b.y], [a.z, c.z], [a.z, b.z], [a.y, c.y]);
        let y = S::area([a.z, b.z], [a.x, c.x], [a.x, b.x], [a.z, c.z]);
        let z = S::area([a.x, b.x], [a.y, c.y], [a.y, b.y], [a.x, c.x]);
        let none = S::Component::default();
        if x.magnitude == none && y.magnitude == none && z.magnitude == none {
            return None;
        }
        Some(S::unit([x, y, z]).into())
    }
}

impl<S: Scalar> Hit<S> {
    /// The normal on the side that the ray came from: unchanged for a hit from the front, negated
    /// for a hit from the back.
    ///
    /// *When to choose it*: for shading, contact and bouncing, where a normal must face the ray. It
    /// takes any normal of the triangle that was hit, of unit length or not, on the side from which
    /// the vertices go counterclockwise.
    ///
    /// *Numerics*: exact, with one exception. `MIN` of a fixed-point type, which is −1 in a type
    /// with one integer bit, becomes `MAX`. *Panics*: never.
    ///
    /// ```
    /// use septum::{Facing, Feature, Hit, Vec3};
    ///
    /// let (facing, feature) = (Facing::Back, Feature::Interior);
    /// let hit = Hit { t: 2.0, u: 0.25, v: 0.25, facing, feature };
    /// assert_eq!(hit.oriented([0.0, 0.6, -0.8]), Vec3::new(0.0, -0.6, 0.8));
    /// ```
    #[inline]
    #[must_use]
    pub fn oriented(&self, normal: impl Into<Vec3<S>>) -> Vec3<S> {
        let normal = normal.into();
        match self.facing {
            Facing::Front => normal,
            Facing::Back => Vec3::new(opposite(normal.x), opposite(normal.y), opposite(normal.z)),
        }
    }
}

/// The number with its sign reversed, or the end of the type.
#[inline(always)]
fn opposite<S: Scalar>(x: S) -> S {
    let minus = S::ZERO.plain_sub(x);
    if x < S::ZERO && minus < S::ZERO {
        // It wrapped around. A division by zero gives the scalar's end.
        S::plain_one().plain_div(S::ZERO)
    } else {
        minus
    }
}

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
