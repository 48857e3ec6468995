//! Moving shapes near the origin, in the word kernel only.

use fixed::FixedI32;
use fixed::types::extra::LeEqU32;

use self::sealed::Past;
use super::passing::{Nearest, Passing, has_volume};
use super::{FirstContact, Motion};
use crate::arithmetic::{Each, Embeds, InRaw, IntNear, three};
use crate::query::relation::{Relate, Relation};
use crate::robust::only_stage;
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Near, ShapeError, Triangle, Vec3};

/// A moving shape that is [near](crate::near) the origin from start to end.
///
/// `moving` of a near triangle or a near axis-aligned box makes one. The motion may be given by places
/// anywhere: only `to` − `from` counts. The obstacle is near as well.
///
/// ```
/// use fixed::types::I16F16;
/// use septum::sweep::Motion;
/// use septum::{Aabb, Axis, ShapeError, Triangle};
///
/// // A unit in the last place is a micrometre: a floor of 12 cm, and a box of 2 cm that falls.
/// let at = |x: i32, y: i32, z: i32| [x, y, z].map(|mm| I16F16::from_bits(1000 * mm));
/// let floor = Triangle::new(at(-60, -60, 0), at(60, -60, 0), at(0, 60, 0))?.near()?;
/// let body = Aabb::from_center_half_extents(at(0, 0, 90), at(10, 10, 10))?.near()?;
/// let fall = Motion::new(at(0, 0, 90), at(0, 0, -70))?;
/// let falling = body.moving(fall)?;
/// assert!(falling.meets(&floor));
/// let first = falling.first_contact(&floor).unwrap();
/// assert_eq!((first.t, first.axis), (I16F16::from_num(0.5), Some(Axis::Face(2))));
/// let stop = falling.last_free(&floor).unwrap();
/// assert_eq!(stop, at(0, 0, 10).into()); // it stands on the floor
///
/// let too_far = body.moving(Motion::new(at(0, 0, 90), at(0, 0, -170))?);
/// assert_eq!(too_far, Err(ShapeError::NotNear));
/// # Ok::<(), ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Moving<T, S> {
    shape: Near<T>,
    motion: Motion<S>,
}

impl<T: Copy, S: Copy> Moving<T, S> {
    /// The shape on a part of its way, all of whose places are near.
    pub(crate) const fn along(&self, part: &Motion<S>) -> Self {
        Self { shape: self.shape, motion: *part }
    }
}

impl<T, S: Copy> Moving<T, S> {
    /// The shape at the start.
    #[must_use]
    pub const fn shape(&self) -> &Near<T> {
        &self.shape
    }

    /// The motion.
    #[must_use]
    pub const fn motion(&self) -> &Motion<S> {
        &self.motion
    }
}

/// Whether a point is near when it has moved. At start and end words then hold all differences (see
/// `Word`).
fn is_near<Frac: LeEqU32>(p: &Vec3<FixedI32<Frac>>, motion: &Motion<FixedI32<Frac>>) -> bool {
    let (p, from, to) = (p.to_array(), motion.from().to_array(), motion.to().to_array());
    let end = three(|i| {
        let [p, from, to] = [p[i], from[i], to[i]].each(|x| i64::from(x.to_bits()));
        i32::try_from(p + (to - from)).map(FixedI32::<Frac>::from_bits)
    });
    matches!(end, [Ok(x), Ok(y), Ok(z)] if Near::is_in_range(&Vec3::new(x, y, z)))
}

impl<Frac: LeEqU32> Near<Triangle<FixedI32<Frac>>> {
    /// The triangle with a motion, for sweeps in 32-bit words alone: see [`Moving`].
    ///
    /// # Errors
    /// [`ShapeError::NotNear`] if a vertex is below −2¹⁷ units in the last place, or 2¹⁷ or more, on some
    /// axis at the end of the motion.
    pub fn moving(
        self,
        motion: Motion<FixedI32<Frac>>,
    ) -> Result<Moving<Triangle<FixedI32<Frac>>, FixedI32<Frac>>, ShapeError> {
        let is_near = self.get().vertices().iter().all(|p| is_near(p, &motion));
        if is_near { Ok(Moving { shape: self, motion }) } else { Err(ShapeError::NotNear) }
    }
}

impl<Frac: LeEqU32> Near<Aabb<FixedI32<Frac>>> {
    /// The box with a motion, for sweeps in 32-bit words alone: see [`Moving`].
    ///
    /// # Errors
    /// [`ShapeError::NotNear`] if a corner is below −2¹⁷ units in the last place, or 2¹⁷ or more, on some
    /// axis at the end of the motion.
    pub fn moving(
        self,
        motion: Motion<FixedI32<Frac>>,
    ) -> Result<Moving<Aabb<FixedI32<Frac>>, FixedI32<Frac>>, ShapeError> {
        // Near the origin no difference and no sum wraps.
        let (low, high) = match *self.get().form() {
            AabbForm::Center { center, half } => {
                let (c, h) = (center.to_array(), half.to_array());
                (three(|i| c[i] - h[i]).into(), three(|i| c[i] + h[i]).into())
            }
            AabbForm::Corners { min, max } => (min, max),
        };
        let is_near = is_near(&low, &motion) && is_near(&high, &motion);
        if is_near { Ok(Moving { shape: self, motion }) } else { Err(ShapeError::NotNear) }
    }
}

impl<S: Scalar + InRaw<Raw = i32>> Passing<'_, S> {
    fn meet_in_words(&self) -> bool {
        !self.misses_in_any_words::<i32>()
    }

    /// As [`relation`](Self::relation). Doubled, vertices are below 2^19 in the frame of the box, the way
    /// and edges below 2^18, and volumes below 2^60.
    fn relation_near(&self) -> Relation
    where
        IntNear: Embeds<S>,
    {
        if !self.meet_in_words() {
            return Relation::Disjoint;
        }
        let nearest = Nearest { passing: self, is_at_end: false };
        let between = only_stage::<_, IntNear, _>(&nearest);
        if between != Relation::Touching || has_volume(self.aabb) {
            return between;
        }
        let relation = |triangle| Near::unchecked(triangle).relation(&Near::unchecked(*self.aabb));
        // The words hold differences from the box, which are those of the shapes at the end. No sum wraps.
        let [from, to] = self.ends().each(|p| p.to_array());
        let moved = |p: [S; 3]| three(|i| p[i].plain_add(to[i].plain_sub(from[i]))).into();
        let at_end = Triangle::unchecked(self.triangle.points().each(moved));
        between.max(relation(*self.triangle)).max(relation(at_end))
    }
}

mod sealed {
    use super::{Motion, Passing};

    /// A shape that moves past another.
    pub trait Past<Other, S> {
        fn past<'a>(&'a self, other: &'a Other, way: &'a Motion<S>) -> Passing<'a, S>;
    }
}

impl<S: Scalar> Past<Aabb<S>, S> for Triangle<S> {
    fn past<'a>(&'a self, aabb: &'a Aabb<S>, way: &'a Motion<S>) -> Passing<'a, S> {
        Passing::new(self, aabb, way)
    }
}

impl<S: Scalar> Past<Triangle<S>, S> for Aabb<S> {
    fn past<'a>(&'a self, triangle: &'a Triangle<S>, way: &'a Motion<S>) -> Passing<'a, S> {
        Passing::reversed(triangle, self, way)
    }
}

/// A triangle past a box, or a box past a triangle.
impl<T, S: Scalar + InRaw<Raw = i32>> Moving<T, S> {
    fn past<'a, Other>(&'a self, other: &'a Near<Other>, way: &'a Motion<S>) -> Passing<'a, S>
    where
        T: Past<Other, S>,
    {
        self.shape.get().past(other.get(), way)
    }

    /// [`Sweep::meets_along`](super::Sweep::meets_along), in 32-bit words alone.
    #[doc(alias = "meets_along")]
    #[must_use]
    pub fn meets<Other>(&self, other: &Near<Other>) -> bool
    where
        T: Past<Other, S>,
    {
        self.past(other, &self.motion).meet_in_words()
    }

    /// [`Sweep::first_contact`](super::Sweep::first_contact), in 32-bit words and quotients of 64-bit sums.
    #[must_use]
    pub fn first_contact<Other>(&self, other: &Near<Other>) -> Option<FirstContact<S>>
    where
        T: Past<Other, S>,
    {
        let passing = self.past(other, &self.motion);
        passing.meet_in_words().then(|| passing.contact_in_any_words::<i32>())
    }

    /// [`Sweep::relation_along`](super::Sweep::relation_along), in 32-bit words and, for shapes that meet,
    /// integers of 64 bits.
    #[must_use]
    pub fn relation_along<Other>(&self, other: &Near<Other>) -> Relation
    where
        T: Past<Other, S>,
        IntNear: Embeds<S>,
    {
        self.past(other, &self.motion).relation_near()
    }

    /// [`Sweep::last_free`](super::Sweep::last_free), by [`relation_along`](Self::relation_along) and
    /// divisions of 64 bits for the places on the way.
    #[doc(alias = "shape cast")]
    #[must_use]
    pub fn last_free<Other>(&self, other: &Near<Other>) -> Option<Vec3<S>>
    where
        T: Past<Other, S>,
        IntNear: Embeds<S>,
    {
        // All places of the way are between its ends, and near.
        let relation = |way: &Motion<S>| self.past(other, way).relation_near();
        self.motion.last_free(|way| relation(way) != Relation::Overlapping)
    }
}

#[cfg(test)]
mod tests {
    use crate::arithmetic::Each;
    use fixed::types::I16F16;

    use crate::sweep::{Motion, Sweep};
    use crate::{Aabb, ShapeError, Triangle};

    const MOST: i32 = (1 << 17) - 1;

    fn at(x: i32, y: i32, z: i32) -> [I16F16; 3] {
        [x, y, z].each(I16F16::from_bits)
    }

    #[test]
    fn what_ends_far_is_refused() {
        let triangle =
            Triangle::new(at(0, 0, 0), at(3, 0, 0), at(0, 3, 0)).unwrap().near().unwrap();
        let corners = Aabb::from_min_max(at(0, 0, 0), at(3, 3, 0)).unwrap().near().unwrap();
        let about = Aabb::from_center_half_extents(at(1, 1, 0), at(2, 2, 0)).unwrap();
        let about = about.near().unwrap();
        let is_known = |from, to| {
            let motion = Motion::new(from, to).unwrap();
            let (of_corners, of_center) = (corners.moving(motion), about.moving(motion));
            let all = [triangle.moving(motion).is_ok(), of_corners.is_ok(), of_center.is_ok()];
            assert!(all == [all[0]; 3] && all[0] == (of_center != Err(ShapeError::NotNear)));
            all[0]
        };
        let zero = at(0, 0, 0);
        assert!(is_known(zero, at(MOST - 3, -MOST, 0)) && is_known(at(0, 0, MOST), zero));
        // Only the difference counts, also where a word of 32 bits does not hold it.
        assert!(is_known(at(i32::MAX, 0, 0), at(i32::MAX - MOST, 0, 0)));
        for x in [MOST - 2, -MOST - 2, i32::MAX, i32::MIN] {
            assert!(!is_known(zero, at(x, 0, 0)) && !is_known(zero, at(0, x, 0)), "{x}");
        }
        assert!(!is_known(zero, at(0, 0, MOST + 1)) && !is_known(at(0, 0, MOST + 2), zero));
        assert!(!is_known(at(i32::MAX, 0, 0), at(i32::MIN, 0, 0)));
        assert!(!is_known(at(i32::MIN, 0, 0), at(i32::MAX, 0, 0)));
    }

    /// Shapes that reach the limit, and shapes on a grid, which often touch.
    #[test]
    fn answers_are_those_of_shapes_anywhere() {
        let mut random = crate::random::Random(5);
        let mut below = |n: i32| (random.bits() % n as u64) as i32;
        let (mut seen, mut relations, mut stops) = ([0; 3], [0; 3], 0);
        for case in 0..40_000 {
            let mut number = || match case % 3 {
                0 => below(2 * MOST) - MOST,
                1 => [-MOST - 1, MOST, 0, 1, -1][below(5) as usize],
                _ => (below(5) - 2) * (MOST >> 3),
            };
            let mut point = || at(number(), number(), number());
            let triangle = Triangle::new(point(), point(), point()).unwrap();
            let (p, q) = (point(), point());
            let of = |f: fn(I16F16, I16F16) -> I16F16| [0, 1, 2].each(|i| f(p[i], q[i]));
            let aabb = Aabb::from_min_max(of(Ord::min), of(Ord::max)).unwrap();
            let motion = Motion::new(point(), point()).unwrap();
            let (near, close) = (triangle.near().unwrap(), aabb.near().unwrap());
            if let Ok(moving) = near.moving(motion) {
                let expected = triangle.first_contact(&motion, &aabb);
                assert_eq!(moving.first_contact(&close), expected, "{triangle:?} {motion:?}");
                assert_eq!(moving.meets(&close), expected.is_some());
                let relation = triangle.relation_along(&motion, &aabb);
                assert_eq!(moving.relation_along(&close), relation, "{triangle:?} {motion:?}");
                assert_eq!(moving.last_free(&close), triangle.last_free(&motion, &aabb));
                relations[relation as usize] += 1;
                seen[usize::from(expected.is_some_and(|first| first.axis.is_some()))] += 1;
            }
            if let Ok(moving) = close.moving(motion) {
                let expected = aabb.first_contact(&motion, &triangle);
                assert_eq!(moving.first_contact(&near), expected, "{aabb:?} {motion:?}");
                assert_eq!(moving.meets(&near), expected.is_some());
                let relation = aabb.relation_along(&motion, &triangle);
                assert_eq!(moving.relation_along(&near), relation, "{aabb:?} {motion:?}");
                let stop = aabb.last_free(&motion, &triangle);
                assert_eq!(moving.last_free(&near), stop);
                stops += u32::from(stop.is_some_and(|stop| stop != motion.to()));
                relations[relation as usize] += 1;
                seen[2] += usize::from(expected.is_some());
            }
        }
        assert!(seen.iter().chain(&relations).all(|&n| n > 1_000), "{seen:?} {relations:?}");
        assert!(stops > 300, "{stops}");
    }
}
