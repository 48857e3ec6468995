//! Ray against axis-aligned boxes by slabs, prepared for many boxes.
//!
//! T. Kay, J. Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986. The reciprocals are prepared as
//! by A. Williams, S. Barrus, R. Morley, P. Shirley, "An Efficient and Robust Ray-Box Intersection
//! Algorithm", *Journal of Graphics Tools* 10(1), 2005. Those authors leave components of zero to
//! infinities. Here they are found in advance, so 0·∞ cannot occur, and zeros of both signs are
//! alike.
//!
//! # Never missing
//!
//! T. Ize, "Robust BVH Ray Traversal", *JCGT* 2(2), 2013, pads the reciprocals for the far planes.
//! Here both ends are padded after they are found, because t may be negative. A computed t has
//! three roundings: a difference, a reciprocal, a product. Two planes decide: that with the
//! greatest t of entry, n, and that with the least t of exit, f. Rounding keeps order, and
//! `slabs.g` proves that the errors of n and f and of the padded sum are within 8 roundoffs of
//! |n| + |f|, plus the least normal number against underflow. An overflow makes n or f infinite,
//! and then the comparison says "may overlap".
//!
//! The reciprocal has its relative error only if it is a normal number. A component of the
//! direction near the limits for that therefore excludes no box.
//!
//! For a box given by its centre, p = c − o is rounded, and the half-extent h is grown by half the
//! padding, relative to |p| + h. `slabs.g` proves that then neither face lies within the true box.

use crate::arithmetic::{greatest, least};
use crate::scalar::{FloatFormat, Scalar};
use crate::shape::{Aabb, AabbForm, Ray, Vec3};

/// A ray prepared for many boxes: the reciprocals of its direction, and which of its components are
/// zero.
///
/// Choose it where one ray meets many boxes and the last bit does not matter:
/// [`overlaps_rounded`](Self::overlaps_rounded). In the traversal of a tree no box may be lost.
/// There a [`PreparedRay`](crate::prepared::PreparedRay) is exact, in fixed point too, and takes
/// about as long as [`overlaps_rounded`](Self::overlaps_rounded).
/// [`may_overlap`](Self::may_overlap) loses no box either and takes half of that.
///
/// `docs/speed.md` in the repository has the figures, also for eight boxes at once by
/// [`Aabbs`](crate::lanes::Aabbs).
///
/// ```
/// use septum::published::slabs::SlabRay;
/// use septum::{Aabb, Ray};
///
/// let ray = SlabRay::new(&Ray::new([-1.0_f32, 0.0, 0.5], [1.0, 0.0, -0.0])?);
/// let flat = Aabb::from_min_max([0.0; 3], [1.0, 0.0, 1.0])?;
/// assert!(ray.overlaps_rounded(&flat) && ray.may_overlap(&flat));
/// assert_eq!(ray.t_range_rounded(&flat), Some((1.0, 2.0)));
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SlabRay<S> {
    ray: Ray<S>,
    pub(crate) origin: [S; 3],
    pub(crate) reciprocal: [S; 3],
    /// The range of t; an open end is the end of the scalar.
    pub(crate) from: S,
    pub(crate) to: S,
    /// Components without a reciprocal, because they are zero or nearly, and components whose
    /// reciprocal is not reliable.
    flat: [bool; 3],
    loose: [bool; 3],
    pub(crate) is_plain: bool,
    is_tight: bool,
}

/// The differences between the ray's origin and the two faces, on each axis.
pub(crate) type Faces<S> = ([S; 3], [S; 3]);

impl<S: Scalar> SlabRay<S> {
    /// Prepares the ray for many boxes.
    ///
    /// *Panics*: never. *Cost*: three divisions.
    #[inline]
    #[must_use]
    pub fn new(ray: &Ray<S>) -> Self {
        let (one, end) = (S::plain_one(), |x: S| x.plain_div(S::ZERO));
        let (mut reciprocal, mut flat, mut loose) = ([S::ZERO; 3], [false; 3], [false; 3]);
        for (i, d) in ray.direction().to_array().into_iter().enumerate() {
            if let Some(padding) = S::FLOAT {
                let (small, large) = padding.invertible;
                loose[i] = d != S::ZERO && !(d.plain_abs() > small && d.plain_abs() < large);
            }
            let r = one.plain_div(d);
            flat[i] = d == S::ZERO || !r.is_finite();
            reciprocal[i] = if flat[i] { S::ZERO } else { r };
        }
        Self {
            ray: *ray,
            origin: ray.origin().to_array(),
            reciprocal,
            from: ray.t_min().unwrap_or(end(S::ZERO.plain_sub(one))),
            to: ray.t_max().unwrap_or(end(one)),
            flat,
            loose,
            is_plain: flat == [false; 3],
            is_tight: flat == [false; 3] && loose == [false; 3],
        }
    }

    /// Does the ray overlap the box? In the scalar's own arithmetic: fast, and occasionally wrong.
    ///
    /// *Contact*: touching counts as overlap, as far as rounding allows.
    ///
    /// *Numerics*: for a box given by its corners every t is within 2 units in the last place, so
    /// the verdict can be wrong only if the ray touches the box that closely. Zero components of
    /// the direction add no error: a ray that starts in a face's plane is answered correctly, and
    /// so are flat boxes. In fixed point a reciprocal has few bits, and products wrap around.
    ///
    /// *Panics*: never. *Cost*: 6 differences, 6 multiplications, 13 comparisons.
    ///
    /// *Source*: Kay and Kajiya 1986; Williams et al. 2005.
    #[inline]
    #[must_use]
    pub fn overlaps_rounded(&self, aabb: &Aabb<S>) -> bool {
        let (enter, leave) = self.interval_in(aabb, None);
        enter <= leave
    }

    /// Where does the ray enter the box, and where does it leave it? In the scalar's own
    /// arithmetic.
    ///
    /// *Numerics*: see [`overlaps_rounded`](Self::overlaps_rounded); the exact query is
    /// [`Ray::t_range`]. If neither the ray's range nor the box bounds t at an end, that end is the
    /// end of the scalar.
    ///
    /// *Panics*: never. *Cost*: as of [`overlaps_rounded`](Self::overlaps_rounded).
    #[inline]
    #[must_use]
    pub fn t_range_rounded(&self, aabb: &Aabb<S>) -> Option<(S, S)> {
        let (enter, leave) = self.interval_in(aabb, None);
        (enter <= leave).then_some((enter, leave))
    }

    /// May the ray overlap the box? Never `false` if it does.
    ///
    /// *Numerics*: `false` is certain. Floats answer `true` if the two values of t come within 8
    /// roundings of each other. A component of the direction below 2⁻¹⁰⁰ or above 2¹⁰⁰ (`f32`;
    /// 2⁻¹⁰⁰⁰ and 2¹⁰⁰⁰ in `f64`) excludes no box. In fixed point this is [`Ray::overlaps`], which
    /// is exact.
    ///
    /// *Panics*: never. *Cost*: as of [`overlaps_rounded`](Self::overlaps_rounded), plus 2
    /// multiplications.
    ///
    /// *Source*: after Ize 2013; the padding is ours.
    #[inline]
    #[must_use]
    pub fn may_overlap(&self, aabb: &Aabb<S>) -> bool {
        let Some(padding) = S::FLOAT else {
            return self.ray.overlaps(aabb);
        };
        let (enter, leave) = self.interval_in(aabb, Some(&padding));
        let sizes = enter.plain_abs().plain_add(leave.plain_abs());
        let margin = sizes.plain_mul(ratio(&padding)).plain_add(padding.least_normal);
        // An infinite t gives NaN, which must not lose the box.
        #[allow(clippy::neg_cmp_op_on_partial_ord)]
        !(enter > leave.plain_add(margin))
    }

    /// The faces of a box by its corners.
    #[inline(always)]
    fn of_corners(&self, min: Vec3<S>, max: Vec3<S>) -> Faces<S> {
        let (min, max, o) = (min.to_array(), max.to_array(), &self.origin);
        let mut to = ([S::ZERO; 3], [S::ZERO; 3]);
        for i in 0..3 {
            to.0[i] = min[i].plain_sub(o[i]);
            to.1[i] = max[i].plain_sub(o[i]);
        }
        to
    }

    /// The faces of a box by its centre, padded outwards if a ratio is given.
    #[inline(always)]
    fn of_center(&self, center: Vec3<S>, half: Vec3<S>, ratio: Option<S>) -> Faces<S> {
        let (center, half, o) = (center.to_array(), half.to_array(), &self.origin);
        let mut to = ([S::ZERO; 3], [S::ZERO; 3]);
        for i in 0..3 {
            let (p, mut half) = (center[i].plain_sub(o[i]), half[i]);
            if let Some(ratio) = ratio {
                let margin = p.plain_abs().plain_add(half).plain_mul(ratio.plain_half());
                half = half.plain_add(margin);
            }
            to.0[i] = p.plain_sub(half);
            to.1[i] = p.plain_add(half);
        }
        to
    }

    /// The interval of t in a box. Each form has its own path to the end, because the compiler
    /// shuffles where paths merge. Unusual rays are out of line.
    #[inline(always)]
    fn interval_in(&self, aabb: &Aabb<S>, padding: Option<&FloatFormat<S>>) -> (S, S) {
        let is_usual = if padding.is_some() { self.is_tight } else { self.is_plain };
        if !is_usual {
            return self.unusual_interval(aabb, padding);
        }
        match *aabb.form() {
            AabbForm::Corners { min, max } => self.plain_interval(&self.of_corners(min, max)),
            AabbForm::Center { center, half } => {
                self.plain_interval(&self.of_center(center, half, padding.map(ratio)))
            }
        }
    }

    #[inline(never)]
    fn unusual_interval(&self, aabb: &Aabb<S>, padding: Option<&FloatFormat<S>>) -> (S, S) {
        let faces = match *aabb.form() {
            AabbForm::Corners { min, max } => self.of_corners(min, max),
            AabbForm::Center { center, half } => self.of_center(center, half, padding.map(ratio)),
        };
        let ignored = if padding.is_some() { &self.loose } else { &[false; 3] };
        self.interval_within(&faces, ignored)
    }

    /// From the greatest t of entry to the least t of exit. The interval is empty if the ray runs
    /// parallel to a slab outside it.
    #[inline(always)]
    pub(crate) fn interval(&self, faces: &Faces<S>) -> (S, S) {
        if self.is_plain {
            self.plain_interval(faces)
        } else {
            self.interval_within(faces, &[false; 3])
        }
    }

    #[inline(always)]
    pub(crate) fn plain_interval(&self, faces: &Faces<S>) -> (S, S) {
        plain_interval(self.reciprocal, [self.from, self.to], faces)
    }

    /// The interval of t if the ray runs parallel to some slabs; some others are ignored.
    fn interval_within(&self, (low, high): &Faces<S>, ignored: &[bool; 3]) -> (S, S) {
        let (mut enter, mut leave, mut outside) = (self.from, self.to, false);
        for i in 0..3 {
            if ignored[i] {
                continue;
            }
            if self.flat[i] {
                outside |= (low[i] > S::ZERO) | (high[i] < S::ZERO);
                continue;
            }
            let r = self.reciprocal[i];
            let (a, b) = (low[i].plain_mul(r), high[i].plain_mul(r));
            enter = greatest(least(a, b), enter);
            leave = least(greatest(a, b), leave);
        }
        let one = S::plain_one();
        if outside { (one, S::ZERO.plain_sub(one)) } else { (enter, leave) }
    }
}

/// Roundoffs in the padding of two values of t; a half-extent takes half as many. `slabs.g` proves
/// both.
const PADDING: u16 = 8;

/// The padding, relative to the padded number.
#[inline(always)]
fn ratio<S: Scalar>(format: &FloatFormat<S>) -> S {
    const { assert!(PADDING == 8) }
    let twice = |x: S| x.plain_add(x);
    twice(twice(twice(format.roundoff)))
}

/// The interval of t in a box, if no component of the direction is zero.
#[inline(always)]
pub(crate) fn plain_interval<S: Scalar>(
    reciprocal: [S; 3],
    [from, to]: [S; 2],
    (low, high): &Faces<S>,
) -> (S, S) {
    let (mut near, mut far) = ([S::ZERO; 3], [S::ZERO; 3]);
    for i in 0..3 {
        let r = reciprocal[i];
        let (a, b) = (low[i].plain_mul(r), high[i].plain_mul(r));
        near[i] = least(a, b);
        far[i] = greatest(a, b);
    }
    let enter = greatest(greatest(near[0], near[1]), greatest(near[2], from));
    let leave = least(least(far[0], far[1]), least(far[2], to));
    (enter, leave)
}
