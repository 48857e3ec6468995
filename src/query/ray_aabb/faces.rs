//! The faces through which a ray enters and leaves the box, exactly.

use core::marker::PhantomData;

use super::{Disjoint, PreparedRay};
use crate::arithmetic::{Each, Embeds};
use crate::query::crossing::{Crossing, Entries, crossings};
use crate::query::line_aabb::Entering;
use crate::robust::{Predicate, Profile};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Ray};

/// The axes of the faces through which the ray enters the box, which it meets, and leaves it.
struct Faces<'a, S>(Disjoint<'a, S>);

impl<S: Scalar> Predicate<S> for Faces<'_, S> {
    type Answer = [Option<usize>; 2];
    const PROFILE: Profile = Profile::AREAS;

    fn filter<N: Embeds<S>>(&self) -> Option<[Option<usize>; 2]> {
        let (line, ends, unit) = self.0.line::<N>()?;
        let [from, to] = ends.each(|t| t.map(|t| [t, unit]));
        let enter = Entering(&line, from, PhantomData::<S>).last_entered()?;
        let (back, from) = (line.reversed(), to.map(|[t, unit]| [-t, unit]));
        Some([enter, Entering(&back, from, PhantomData::<S>).last_entered()?])
    }
}

impl<S: Scalar> Ray<S> {
    /// Where and through which faces does the ray enter the axis-aligned box, and leave it? `None`
    /// if it misses the box.
    ///
    /// *Geometry*, *Contact*: as [`t_range`](Self::t_range). [`Crossing::normal`] gives the outward
    /// normal of a face.
    ///
    /// *Numerics*: the values of t are those of [`t_range`](Self::t_range), with its rounding. The
    /// faces are exact: the plane that the ray enters last, and the one that it leaves first. Among
    /// equals it is the plane across the first axis.
    ///
    /// *Range*: as for [`overlaps`](Ray::overlaps). *Panics*: never. *Cost*:
    /// [`t_range`](Self::t_range), and for a hit up to 12 multiplications more.
    ///
    /// ```
    /// use septum::{Aabb, Ray, Vec3};
    ///
    /// let cell = Aabb::from_min_max([1.0, 0.0, 0.0], [3.0, 1.0, 1.0])?;
    /// let ray = Ray::new([0.0, 0.5, 0.5], [2.0, 0.125, 0.0])?;
    /// let [enter, leave] = ray.crossings(&cell).unwrap();
    /// assert_eq!((enter.t, enter.face), (0.5, Some(0))); // the lower side of x
    /// assert_eq!(enter.normal(&cell), Some(Vec3::new(-1.0, 0.0, 0.0)));
    /// assert_eq!((leave.t, leave.face), (1.5, Some(1)));
    ///
    /// let [enter, _] = ray.with_range(1.0, None)?.crossings(&cell).unwrap();
    /// assert_eq!((enter.t, enter.face), (1.0, None)); // it begins inside
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[doc(alias = "normal")]
    #[doc(alias = "raycast")]
    #[must_use]
    pub fn crossings(&self, aabb: &Aabb<S>) -> Option<[Crossing<S>; 2]> {
        let range = self.t_range(aabb)?;
        let [first, last] = S::evaluate(&Faces(Disjoint { ray: self, aabb }));
        let falls = self.direction().to_array().each(|d| d < S::ZERO);
        let side = |i: usize, is_entry: bool| (i as u8, falls[i % 3] == is_entry);
        Some(crossings(range, [first.map(|i| side(i, true)), last.map(|i| side(i, false))]))
    }
}

impl<S: Scalar> PreparedRay<S> {
    /// Where and through which faces does the ray enter the box, and leave it? As
    /// [`Ray::crossings`].
    ///
    /// *Numerics*: the same bits as [`Ray::crossings`]. *Panics*: never. *Cost*: a miss costs what
    /// [`overlaps`](Self::overlaps) does.
    #[must_use]
    pub fn crossings(&self, aabb: &Aabb<S>) -> Option<[Crossing<S>; 2]> {
        if self.overlaps(aabb) { self.ray().crossings(aabb) } else { None }
    }
}
