//! Ray against axis-aligned box where one ray meets many boxes. Slabs by reciprocals decide if the
//! two values of t are clearly apart; otherwise the exact test does.

use super::error_bound;
use crate::arithmetic::{Each, Number, Quad, Span, Spans, greatest, least};
use crate::robust::{Stage, note};
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Ray, Vec3};

/// A ray prepared for many axis-aligned boxes: exact, and nearly as fast as slabs that round.
///
/// Choose it to traverse a tree, or wherever a ray meets more than a few boxes. The answers
/// equal [`Ray::overlaps`] and [`Ray::t_range`].
///
/// *Numerics*: exact. The slabs follow [`SlabRay`](crate::published::slabs::SlabRay), with an
/// error bound, in fixed point by `f64`. If the ray passes within a few roundings of an edge of the
/// box, the bound leaves a doubt, and the exact test of the ray itself decides.
///
/// *Range*: all of the scalar. Components of the direction should be zero or between 2⁻⁴⁰ and 2⁴⁰
/// (`f32`) or 2⁻⁴⁰⁰ and 2⁴⁰⁰ (`f64`). With other components every box takes the exact test, and
/// preparing gains nothing. The same holds for fixed point on cores with 32-bit registers, where
/// exact integers are faster than floats.
///
/// ```
/// use septum::prepared::PreparedRay;
/// use septum::{Aabb, Ray};
///
/// let ray = Ray::new([-1.0, 0.0, 0.5], [1.0, 1.0, 0.0])?;
/// let prepared = PreparedRay::new(&ray);
/// let corner = Aabb::from_min_max([0.0; 3], [1.0; 3])?;
/// assert!(prepared.overlaps(&corner)); // touches the edge x = 0, y = 1
///
/// let off = Aabb::from_min_max([0.0, 0.0, 0.0], [1.0, 1.0_f64.next_down(), 1.0])?;
/// assert!(!prepared.overlaps(&off)); // one unit in the last place farther off
/// assert_eq!(prepared.t_range(&corner), Some((1.0, 1.0)));
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PreparedRay<S: Scalar> {
    ray: Ray<S>,
    /// The fourth lane is not used.
    origin: [S::SeptumAnchor; 4],
    /// The scale over the direction; zero where the direction is zero. The fourth lane is not used.
    reciprocal: [S::SeptumSpan; 4],
    /// The range of t, times the scale.
    from: S::SeptumSpan,
    to: S::SeptumSpan,
    course: Course,
}

/// What answers for a prepared ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Course {
    /// Slabs, if no component of the direction is zero and t is not below zero.
    Plain,
    /// Slabs, in all other cases with reciprocals.
    Slabs,
    /// The ray itself.
    Exact,
}

/// The parts of a ray's range that each slab of a box leaves.
struct Slabs<F> {
    near: [F; 3],
    far: [F; 3],
    /// For a box by its centre: the size to which the errors are relative.
    size: F,
    /// Whether the ray may run within a face.
    touches: bool,
}

impl<S: Scalar> PreparedRay<S> {
    /// Prepares the ray for many boxes.
    ///
    /// *Panics*: never. *Cost*: three divisions.
    #[inline]
    #[must_use]
    pub fn new(ray: &Ray<S>) -> Self {
        let zero = S::SeptumSpan::ZERO;
        let mut this = Self {
            ray: *ray,
            origin: four(ray.origin()).each(S::anchor),
            reciprocal: [zero; 4],
            from: -S::SeptumSpan::GREATEST,
            to: S::SeptumSpan::GREATEST,
            course: Course::Exact,
        };
        if !S::IS_FAST {
            return this;
        }
        let mut course = Course::Plain;
        for (r, d) in this.reciprocal.iter_mut().zip(ray.direction().to_array()) {
            if d == S::ZERO {
                course = Course::Slabs;
                continue;
            }
            let (d, (small, large)) = (d.span(), S::SeptumSpan::INVERTIBLE);
            if d.magnitude() < small || d.magnitude() > large {
                return this;
            }
            *r = S::SeptumSpan::SCALE / d;
        }
        let scaled = |t: Option<S>, open: S::SeptumSpan| t.map_or(Some(open), S::scaled);
        let (Some(from), Some(to)) = (scaled(ray.t_min(), this.from), scaled(ray.t_max(), this.to))
        else {
            return this;
        };
        (this.from, this.to) = (from + zero, to);
        if from < zero {
            course = Course::Slabs;
        }
        this.course = course;
        this
    }

    /// The ray.
    #[inline]
    #[must_use]
    pub const fn ray(&self) -> &Ray<S> {
        &self.ray
    }

    /// Does the ray, within its range of t, have a point in common with the box? As
    /// [`Ray::overlaps`].
    ///
    /// *Contact*: touching counts as overlap. *Numerics*: exact. *Panics*: never.
    ///
    /// *Cost*: by corners 6 differences, 6 multiplications and 14 comparisons; by centre 3
    /// differences, 7 multiplications, 11 sums and 10 comparisons. In doubt, the cost of
    /// [`Ray::overlaps`] is added.
    ///
    /// *Source*: slabs after Kay and Kajiya 1986; the bound is ours.
    #[inline]
    #[must_use]
    pub fn overlaps(&self, aabb: &Aabb<S>) -> bool {
        // A constant condition, so that such a scalar links no floats.
        if !S::IS_FAST {
            return self.ray.overlaps(aabb);
        }
        if self.course != Course::Plain {
            return self.overlaps_in_general(aabb);
        }
        // Each form has its own path to the end, because the compiler shuffles where paths merge.
        match aabb.form() {
            AabbForm::Corners { min, max } => {
                let (enter, leave) = self.between_corners(*min, *max);
                let apart = error_bound::CORNERS;
                let verdicts = (enter.is_below(leave, apart), leave.is_below(enter, apart));
                self.verdict(verdicts, aabb)
            }
            AabbForm::Center { center, half } => {
                let (enter, leave, size) = self.around_center(*center, *half);
                let error = size.error(error_bound::CENTER);
                self.verdict((enter + error < leave, leave < enter - error), aabb)
            }
        }
    }

    /// Where does the ray enter the box, and where does it leave it? `None` if it misses the box.
    /// As [`Ray::t_range`].
    ///
    /// *Numerics*: the same bits as [`Ray::t_range`]. *Panics*: never.
    ///
    /// *Cost*: as for [`overlaps`](Self::overlaps), and for a box that the ray meets also
    /// [`Ray::t_range`].
    #[inline]
    #[must_use]
    pub fn t_range(&self, aabb: &Aabb<S>) -> Option<(S, S)> {
        if self.overlaps(aabb) { self.ray.t_range(aabb) } else { None }
    }

    /// The verdict, if the first look is certain of one of the two.
    #[inline(always)]
    fn verdict(&self, (overlaps, misses): (bool, bool), aabb: &Aabb<S>) -> bool {
        if overlaps == misses { self.overlaps_in_general(aabb) } else { overlaps }
    }

    /// The interval of t if no component of the direction is zero and t is not below zero.
    ///
    /// The fourth lane is the number that follows the vector in memory, so that both are one load.
    #[inline(always)]
    fn between_corners(&self, min: Vec3<S>, max: Vec3<S>) -> (S::SeptumSpan, S::SeptumSpan) {
        let (a, b) = (self.reaches([min.x, min.y, min.z, max.x]), self.reaches(four(max)));
        let [x, y, z] = a.least(b).three();
        let enter = greatest(greatest(x, y), greatest(z, self.from));
        let [x, y, z] = a.greatest(b).three();
        let leave = least(least(x, y), least(z, self.to));
        // −0 and zero have different bits.
        (enter, leave + S::SeptumSpan::ZERO)
    }

    /// The interval of t for a box by its centre, and the size of its errors.
    #[inline(always)]
    fn around_center(
        &self,
        center: Vec3<S>,
        half: Vec3<S>,
    ) -> (S::SeptumSpan, S::SeptumSpan, S::SeptumSpan) {
        let to_center = self.reaches([center.x, center.y, center.z, half.x]);
        let reciprocal = <Spans<S> as Quad>::new(self.reciprocal);
        let to_face = <Spans<S> as Quad>::new(four(half).each(S::span)) * reciprocal.magnitude();
        let [x, y, z] = (to_center - to_face).three();
        let enter = greatest(greatest(x, y), greatest(z, self.from));
        let [x, y, z] = (to_center + to_face).three();
        let leave = least(least(x, y), least(z, self.to));
        (enter, leave, (to_center.magnitude() + to_face).most())
    }

    /// The values of t at these coordinates, one on each axis.
    #[inline(always)]
    fn reaches(&self, p: [S; 4]) -> Spans<S> {
        S::all_beyond(p, self.origin) * Quad::new(self.reciprocal)
    }

    /// For any direction and range. It also takes a second look at a doubt, because a ray enters
    /// and leaves a flat box at the same t.
    #[inline(never)]
    fn overlaps_in_general(&self, aabb: &Aabb<S>) -> bool {
        if self.course == Course::Exact {
            return self.ray.overlaps(aabb);
        }
        let Some(Slabs { near, far, size, touches }) = self.slabs(aabb) else { return false };
        let is_below = |a: S::SeptumSpan, b: S::SeptumSpan| {
            let error = match aabb.form() {
                AabbForm::Corners { .. } => a.magnitude().error(error_bound::CORNERS),
                AabbForm::Center { .. } => size.error(error_bound::CENTER),
            };
            a + error < b
        };
        let [x, y, z] = far;
        let leave = least(least(x, y), z);
        if is_below(leave, greatest(greatest(near[0], near[1]), near[2])) {
            return false;
        }
        // Each interval of t with each other one, but none with itself: see `line_aabb::Slabs`.
        let overlaps = is_below(self.from, leave)
            & is_below(near[0], least(y, z))
            & is_below(near[1], least(z, x))
            & is_below(near[2], least(x, y));
        (overlaps & !touches) || self.overlaps_in_doubt(aabb)
    }

    #[cold]
    #[inline(never)]
    fn overlaps_in_doubt(&self, aabb: &Aabb<S>) -> bool {
        note(Stage::Look);
        self.ray.overlaps(aabb)
    }

    /// The slabs of a box; `None` if the ray runs parallel to a slab outside it.
    #[inline(always)]
    fn slabs(&self, aabb: &Aabb<S>) -> Option<Slabs<S::SeptumSpan>> {
        let zero = S::SeptumSpan::ZERO;
        let (mut near, mut far) = ([self.from; 3], [self.to; 3]);
        let (mut size, mut touches) = (zero, false);
        for i in 0..3 {
            let (o, r) = (self.origin[i], self.reciprocal[i]);
            match aabb.form() {
                AabbForm::Corners { min, max } => {
                    let (min, max) = (min.to_array()[i].beyond(o), max.to_array()[i].beyond(o));
                    // The ray runs parallel to the slab. Rounding keeps the sign.
                    if r == zero {
                        if min > zero || max < zero {
                            return None;
                        }
                        continue;
                    }
                    let (a, b) = (min * r, max * r);
                    near[i] = greatest(least(a, b), self.from);
                    far[i] = least(greatest(a, b), self.to);
                }
                AabbForm::Center { center, half } => {
                    let (p, h) = (center.to_array()[i].beyond(o), half.to_array()[i].span());
                    // Rounding keeps the order of two numbers, but may make them equal.
                    if r == zero {
                        if p.magnitude() > h {
                            return None;
                        }
                        touches |= p.magnitude() == h;
                        continue;
                    }
                    let (to_center, to_face) = (p * r, h * r.magnitude());
                    near[i] = greatest(to_center - to_face, self.from);
                    far[i] = least(to_center + to_face, self.to);
                    size = greatest(size, to_center.magnitude() + to_face);
                }
            }
        }
        Some(Slabs { near, far, size, touches })
    }
}

/// Three coordinates, and a fourth that is not used.
#[inline(always)]
fn four<S: Copy>(p: Vec3<S>) -> [S; 4] {
    [p.x, p.y, p.z, p.z]
}
