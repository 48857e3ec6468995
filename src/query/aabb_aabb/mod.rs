//! Axis-aligned box against axis-aligned box.

mod kernel;

use crate::arithmetic::{Each, Embeds, Number, compare, greatest};
use crate::query::relation::{Nearness, Reading, Relate, Relation, of_gaps};
use crate::robust::{Predicate, Profile};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Overlaps};
pub(super) use kernel::{Apart, GAP};

impl<S: Scalar> Overlaps<Aabb<S>> for Aabb<S> {
    /// Do two axis-aligned boxes have a point in common?
    ///
    /// *Geometry*: closed sets in one frame and unit, each in the form in which it was given. The
    /// corners of a box given by its centre may lie between two numbers of the scalar. Either box
    /// may be flat, or a point.
    ///
    /// *Contact*: touching is overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar.
    ///
    /// *Range*: all finite floats, all fixed-point values. Exact sums decide floats given by a
    /// centre if rounding leaves contact in doubt, and 64-bit fixed point beyond 2⁶⁰ units in the
    /// last place.
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: 6 comparisons for two boxes given by their corners. Otherwise 12 additions and 9
    /// comparisons, and in floats 3 additions and 3 multiplications for the error bound.
    ///
    /// *Source*: the three face normals of Gottschalk, Lin and Manocha 1996; the
    /// exact stages are ours.
    ///
    /// ```
    /// use septum::Aabb;
    ///
    /// let cell = Aabb::from_min_max([0.0_f32; 3], [1.0; 3])?;
    /// let ball = Aabb::from_center_half_extents([1.5, 0.5, 0.5], [0.5, 9.0, 0.0])?;
    /// assert!(cell.overlaps(&ball)); // they touch where x = 1
    /// let ball = Aabb::from_center_half_extents([1.5, 0.5, 0.5], [0.49999997, 9.0, 0.0])?;
    /// assert!(!cell.overlaps(&ball)); // one unit in the last place apart
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, other: &Aabb<S>) -> bool {
        match (self.given_corners(), other.given_corners()) {
            (Some((a, b)), Some((c, d))) => {
                let meet = |a: S, b: S, c: S, d: S| (a <= d) & (c <= b);
                meet(a.x, b.x, c.x, d.x) & meet(a.y, b.y, c.y, d.y) & meet(a.z, b.z, c.z, d.z)
            }
            _ => !S::evaluate(&Apart::new(self.form(), other.form())),
        }
    }
}

/// The question for the relation of two boxes.
struct Lie<S>(Apart<S>);

impl<S: Scalar> Predicate<S> for Lie<S> {
    type Answer = Relation;
    const PROFILE: Profile = Profile::AREAS;

    fn filter<N: Embeds<S>>(&self) -> Option<Relation> {
        let Apart { a, b } = &self.0;
        let all = [a.low, a.high, a.grown, b.low, b.high, b.grown];
        let [a_low, a_high, a_grown, b_low, b_high, b_grown] = N::embed(&all)?;
        let mut found = Nearness::NONE;
        for i in 0..3 {
            let (before, after) = (a_low[i] - b_high[i], b_low[i] - a_high[i]);
            let (d, r) = (greatest(before, after), a_grown[i] + b_grown[i]);
            let extent = r + r - (before + after);
            found.add(d - r, extent, (d.magnitude() + r).error(GAP));
        }
        found.answer(N::CERTAIN)
    }

    fn exact(&self) -> Relation {
        (0..3).fold(Relation::Overlapping, |so_far, i| so_far.min(of_gaps(self.0.gaps(i))))
    }
}

impl<S: Scalar> Relate<Aabb<S>> for Aabb<S> {
    fn relation(&self, other: &Aabb<S>) -> Relation {
        let (Some((a, b)), Some((c, d))) = (self.given_corners(), other.given_corners()) else {
            return S::evaluate(&Lie(Apart::new(self.form(), other.form())));
        };
        let [a, b, c, d] = [a, b, c, d].each(|p| p.to_array());
        (0..3).fold(Relation::Overlapping, |so_far, i| {
            so_far.min(of_gaps([compare(a[i], d[i]), compare(c[i], b[i])]))
        })
    }
}
