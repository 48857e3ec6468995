use crate::arithmetic::{pick, three};
use crate::scalar::Scalar;
use crate::shape::{ShapeError, Vec3, finite};

/// A translation from one place to another.
///
/// A motion is given by two places of one point, for example a body's centre in the last frame and
/// in this one. Every other point p goes to p + (`to` − `from`). That sum is not rounded and need
/// not be a number of the scalar. At time t, from zero to one, the point is at p + t·(`to` −
/// `from`).
///
/// A motion does not turn bodies.
///
/// ```
/// use septum::sweep::Motion;
///
/// let fall = Motion::new([0.0, 0.0, 9.0], [0.0, 0.0, -9.0])?;
/// assert_eq!(fall.reversed().to().z, 9.0);
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Motion<S> {
    from: Vec3<S>,
    to: Vec3<S>,
}

impl<S: Scalar> Motion<S> {
    /// The motion from one place to another; no motion if the places are equal.
    ///
    /// # Errors
    /// [`ShapeError::NotFinite`] where a coordinate is NaN or infinite.
    #[inline]
    pub fn new(from: impl Into<Vec3<S>>, to: impl Into<Vec3<S>>) -> Result<Self, ShapeError> {
        Ok(Self { from: finite("from", from)?, to: finite("to", to)? })
    }

    /// The place at time `t`, from zero to one, rounded to the scalar: fixed point toward `from`;
    /// floats compute `from + (to − from)·t` in `f64`. A time below zero is `from`, and one above
    /// one is `to`.
    ///
    /// A body at the rounded place of its first contact may overlap the obstacle:
    /// [`Sweep::last_free`](super::Sweep::last_free) finds a place where it does not.
    #[must_use]
    pub fn at(&self, t: S) -> Vec3<S> {
        let (from, to) = (self.from.to_array(), self.to.to_array());
        three(|i| S::at_time(from[i], to[i], t)).into()
    }

    /// The number of steps from `from` to `to`, for [`place`](Self::place): how far apart the two
    /// are in numbers of the scalar, on the axis on which that is most. Zero without motion.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.longest().1
    }

    /// The place after `k` steps; `to` after the last.
    ///
    /// A step leads to the next number of the scalar on the axis that passes most numbers, the
    /// first such axis if there are several. The coordinates on the other two axes are rounded as
    /// in [`at`](Self::at).
    ///
    /// ```
    /// use septum::sweep::Motion;
    ///
    /// let fall = Motion::new([0.0, 0.0, 1.0], [0.0, 0.0, 0.5])?;
    /// assert_eq!(fall.place(1).z, 1.0 - f64::EPSILON / 2.0);
    /// assert_eq!(fall.place(fall.steps()), fall.to());
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[must_use]
    pub fn place(&self, k: u64) -> Vec3<S> {
        let (axis, steps) = self.longest();
        if k >= steps {
            return self.to;
        }
        if k == 0 {
            return self.from;
        }
        let (from, to) = (self.from.to_array(), self.to.to_array());
        let (a, b) = (*pick(&from, axis), *pick(&to, axis));
        // Modulo 2^64: the sum fits.
        let n = a.ordinal();
        let n = if b < a { n.wrapping_sub(k as i64) } else { n.wrapping_add(k as i64) };
        let x = S::of_ordinal(n);
        three(|i| if i == axis { x } else { S::between(from[i], to[i], [a, x, b]) }).into()
    }

    /// The axis on which the ends are most numbers apart, and how many.
    fn longest(&self) -> (usize, u64) {
        let (from, to) = (self.from.to_array(), self.to.to_array());
        let [x, y, z] = three(|i| from[i].ordinal().abs_diff(to[i].ordinal()));
        if x >= y && x >= z {
            (0, x)
        } else if y >= z {
            (1, y)
        } else {
            (2, z)
        }
    }

    /// The motion up to a place.
    pub(crate) fn until(&self, k: u64) -> Self {
        Self { from: self.from, to: self.place(k) }
    }

    /// The last free place, as [`Sweep::last_free`](super::Sweep::last_free) returns it.
    pub(super) fn last_free(&self, is_free: impl Fn(&Self) -> bool) -> Option<Vec3<S>> {
        if is_free(self) {
            return Some(self.to);
        }
        Some(self.place(self.last_free_step(self.steps(), is_free)?))
    }

    /// A step before `blocked` such that the way to its place is free and the way to the next is
    /// not; `None` if no way is. The way to the place after `blocked` steps is not free.
    pub(crate) fn last_free_step(
        &self,
        blocked: u64,
        is_free: impl Fn(&Self) -> bool,
    ) -> Option<u64> {
        let (mut low, mut high) = (0, blocked);
        if blocked == 0 || !is_free(&self.until(0)) {
            return None;
        }
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            if is_free(&self.until(middle)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        Some(low)
    }
}

impl<S: Copy> Motion<S> {
    /// Where the motion begins.
    #[inline]
    #[must_use]
    pub const fn from(&self) -> Vec3<S> {
        self.from
    }

    /// Where the motion ends.
    #[inline]
    #[must_use]
    pub const fn to(&self) -> Vec3<S> {
        self.to
    }

    /// The motion back. Seen from the moving body, everything else moves like this.
    #[inline]
    #[must_use]
    pub const fn reversed(&self) -> Self {
        Self { from: self.to, to: self.from }
    }
}
