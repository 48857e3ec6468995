//! Moving shapes near the origin, in the word kernel only.

use fixed::FixedI32;
use fixed::types::extra::LeEqU32;

use super::passing::Passing;
use super::{FirstContact, Motion};
use crate::arithmetic::{Each, InWholeWord, three};
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
    /// [`ShapeError::NotNear`] if a vertex is 2¹⁷ units in the last place or more from zero on some
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
    /// [`ShapeError::NotNear`] if a corner is 2¹⁷ units in the last place or more from zero on some
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

impl<S: Scalar + InWholeWord<i32>> Passing<'_, S> {
    fn meet_in_words(&self) -> bool {
        !self.misses_in_any_words::<i32>()
    }

    fn first_contact_in_words(&self) -> Option<FirstContact<S>> {
        self.meet_in_words().then(|| self.contact_in_any_words::<i32>())
    }
}

impl<S: Scalar + InWholeWord<i32>> Moving<Triangle<S>, S> {
    fn past<'a>(&'a self, aabb: &'a Near<Aabb<S>>) -> Passing<'a, S> {
        Passing::new(self.shape.get(), aabb.get(), &self.motion)
    }

    /// [`Sweep::meets_along`](super::Sweep::meets_along), in 32-bit words alone.
    #[doc(alias = "meets_along")]
    #[must_use]
    pub fn meets(&self, aabb: &Near<Aabb<S>>) -> bool {
        self.past(aabb).meet_in_words()
    }

    /// [`Sweep::first_contact`](super::Sweep::first_contact), in 32-bit words and quotients of 64-bit sums.
    #[must_use]
    pub fn first_contact(&self, aabb: &Near<Aabb<S>>) -> Option<FirstContact<S>> {
        self.past(aabb).first_contact_in_words()
    }
}

impl<S: Scalar + InWholeWord<i32>> Moving<Aabb<S>, S> {
    fn past<'a>(&'a self, triangle: &'a Near<Triangle<S>>) -> Passing<'a, S> {
        Passing::reversed(triangle.get(), self.shape.get(), &self.motion)
    }

    /// [`Sweep::meets_along`](super::Sweep::meets_along), in 32-bit words alone.
    #[doc(alias = "meets_along")]
    #[must_use]
    pub fn meets(&self, triangle: &Near<Triangle<S>>) -> bool {
        self.past(triangle).meet_in_words()
    }

    /// [`Sweep::first_contact`](super::Sweep::first_contact), in 32-bit words and quotients of 64-bit sums.
    #[must_use]
    pub fn first_contact(&self, triangle: &Near<Triangle<S>>) -> Option<FirstContact<S>> {
        self.past(triangle).first_contact_in_words()
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
        let mut seen = [0; 3];
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
                seen[usize::from(expected.is_some_and(|first| first.axis.is_some()))] += 1;
            }
            if let Ok(moving) = close.moving(motion) {
                let expected = aabb.first_contact(&motion, &triangle);
                assert_eq!(moving.first_contact(&near), expected, "{aabb:?} {motion:?}");
                assert_eq!(moving.meets(&near), expected.is_some());
                seen[2] += usize::from(expected.is_some());
            }
        }
        assert!(seen.iter().all(|&n| n > 1_000), "{seen:?}");
    }
}
