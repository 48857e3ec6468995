//! Ray against axis-aligned boxes by slabs, prepared for many boxes.
//!
//! T. Kay, J. Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986; with reciprocals
//! prepared as by A. Williams, S. Barrus, R. Morley, P. Shirley, "An Efficient and
//! Robust Ray-Box Intersection Algorithm", *Journal of Graphics Tools* 10(1), 2005.
//! Components of zero are told apart beforehand, where those authors rely on
//! infinities: 0·∞ cannot occur, and zeros of either sign are alike.
//!
//! # Never missing
//!
//! T. Ize, "Robust BVH Ray Traversal", *JCGT* 2(2), 2013, pads the reciprocals for
//! the far planes. Here the two ends are padded, once they are found, for t may be
//! negative too. A computed t is t·(1 + δ)³ with |δ| ≤ u, the unit roundoff: a
//! difference, a reciprocal, a product. Those of the planes that matter are the
//! greatest t of entry, n, and the least of exit, f; rounding keeps order, so n ≤ f
//! becomes n̂ − f̂ ≤ 3u·(|n| + |f|), to first order. The padding has 8u, for that,
//! for the rounding of the padded sum, and for second orders. An underflow costs at
//! most half the least number, and the least normal number is added for two. An
//! overflow makes n or f infinite, and then the comparison says "may overlap".
//!
//! A reciprocal has that relative error if it is a normal number: a component of the
//! direction that is too large or too small for that with a wide margin constrains
//! nothing.
//!
//! A box given by its centre: with p = c − o rounded, the half-extent h is grown by
//! 4u·(|p| + h), against u·|p| for p, and u·(|p| + h) each for the grown h and for
//! p ± h. So neither difference lies within the truth.

use crate::arithmetic::{greatest, least};
use crate::scalar::{FloatFormat, Scalar};
use crate::shape::{Aabb, AabbForm, Ray, Vec3};

/// A ray prepared for many boxes: the reciprocals of its direction, and which
/// components of it are zero.
///
/// Choose it where one ray meets many boxes and the last bit does not matter:
/// [`overlaps_rounded`](Self::overlaps_rounded). In the traversal of a tree, where no box may
/// be lost, a [`PreparedRay`](crate::prepared::PreparedRay) is exact at about the price of
/// [`overlaps_rounded`](Self::overlaps_rounded), in fixed point too;
/// [`may_overlap`](Self::may_overlap), which loses none either, takes half of that.
///
/// `docs/speed.md` in the repository has the figures, those of eight boxes at once, by
/// [`Aabbs`](crate::lanes::Aabbs), among them.
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
    /// Components without a reciprocal, which are zero or nearly, and those whose
    /// reciprocal is not to be relied on.
    flat: [bool; 3],
    loose: [bool; 3],
    pub(crate) is_plain: bool,
    is_tight: bool,
}

/// What is between the ray's origin and the two faces on each axis.
pub(crate) type Faces<S> = ([S; 3], [S; 3]);

impl<S: Scalar> SlabRay<S> {
    /// The ray prepared for many boxes.
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

    /// Whether the ray meets the box, in the scalar's own arithmetic: fast, and now
    /// and then wrong.
    ///
    /// *Contact*: touching is overlap, as far as rounding lets it.
    ///
    /// *Numerics*: every t is within 2 units in the last place for a box given by
    /// its corners, so that a box is lost or found only where it is touched that
    /// closely. With a direction of which components are zero there is no other
    /// error: origins on the planes of slabs and flat boxes are answered rightly. In
    /// fixed point a reciprocal has few bits and products wrap.
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

    /// Where the ray enters the box and where it leaves it, in the scalar's own
    /// arithmetic.
    ///
    /// *Numerics*: see [`overlaps_rounded`](Self::overlaps_rounded); the exact
    /// question is [`Ray::t_range`]. Where the ray is open and a box does not bound
    /// it, as in a slab of zero times zero, the end is the end of the scalar.
    ///
    /// *Panics*: never. *Cost*: that of [`overlaps_rounded`](Self::overlaps_rounded).
    #[inline]
    #[must_use]
    pub fn t_range_rounded(&self, aabb: &Aabb<S>) -> Option<(S, S)> {
        let (enter, leave) = self.interval_in(aabb, None);
        (enter <= leave).then_some((enter, leave))
    }

    /// Whether the ray may meet the box: never `false` if it does.
    ///
    /// *Numerics*: `false` is certain. Floats answer `true` where the two values of t
    /// come within 8 roundings of each other; a component of the direction below
    /// 2⁻¹⁰⁰ or above 2¹⁰⁰ (`f32`; 2⁻¹⁰⁰⁰ and 2¹⁰⁰⁰ in `f64`) excludes no box. In fixed
    /// point this is [`Ray::overlaps`]: exact.
    ///
    /// *Panics*: never. *Cost*: that of [`overlaps_rounded`](Self::overlaps_rounded)
    /// and 2 multiplications.
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
        // A NaN, of infinities, must not lose the box.
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

    /// The faces of a box by its centre; no nearer than the truth, where there is a
    /// ratio to grow it by.
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

    /// The interval of t in a box: each form to its end apart, for where they mix the
    /// compiler shuffles, and with the unusual out of line.
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

    /// From the greatest t of entry to the least of exit; where a slab that the ray
    /// runs along is missed, an empty interval.
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

    /// The same with some slabs that the ray runs along, and some ignored.
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

/// Roundoffs in the padding of two values of t; half of them in that of a half-extent. Proved
/// in `slabs.g`.
const PADDING: u16 = 8;

/// The padding, relative to what is padded.
#[inline(always)]
fn ratio<S: Scalar>(format: &FloatFormat<S>) -> S {
    const { assert!(PADDING == 8) }
    let twice = |x: S| x.plain_add(x);
    twice(twice(twice(format.roundoff)))
}

/// The interval of t in a box, where no component of the direction is zero.
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
