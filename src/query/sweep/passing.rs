//! A triangle that moves past a box, in any number system, and when they first meet.

use super::exact::ExactCourse;
use super::kernel::Course;
use super::latest::Instant;
use super::time::{Meets, When};
use super::{FirstContact, Motion, rows, short, words};
use crate::arithmetic::{
    Arithmetic, Each, Embeds, Float, InFloat, InRaw, Number, REGISTERS_ARE_WIDE, Word, cuts_floats,
    is_software,
};
use crate::query::relation::{Relate, Relation};
use crate::query::triangle_aabb::frame::{BoxForm, Frame};
use crate::query::triangle_aabb::touches_face;
use crate::robust::{Predicate, Profile, WordKernel, in_cut_floats, in_exact_numbers};
use crate::scalar::{FixedBackend, Scalar};
use crate::shape::{Aabb, AabbForm, Triangle, Vec3};

/// A triangle that moves past a box.
pub struct Passing<'a, S> {
    pub(super) triangle: &'a Triangle<S>,
    pub(super) aabb: &'a Aabb<S>,
    /// Borrowed in place. A fresh copy would not have reached memory when it is loaded as a vector,
    /// and the load would wait.
    pub(super) motion: &'a Motion<S>,
    /// Whether the triangle moves backwards, because the box is what moves.
    pub(super) is_reversed: bool,
}

impl<'a, S: Scalar> Passing<'a, S> {
    #[inline(always)]
    pub(super) fn new(triangle: &'a Triangle<S>, aabb: &'a Aabb<S>, motion: &'a Motion<S>) -> Self {
        Self { triangle, aabb, motion, is_reversed: false }
    }

    /// The box moves, so in its frame the triangle goes back.
    #[inline(always)]
    pub(super) fn reversed(
        triangle: &'a Triangle<S>,
        aabb: &'a Aabb<S>,
        motion: &'a Motion<S>,
    ) -> Self {
        Self { triangle, aabb, motion, is_reversed: true }
    }

    /// Where the triangle's motion begins and ends.
    #[inline(always)]
    pub(super) fn ends(&self) -> [Vec3<S>; 2] {
        let (from, to) = (self.motion.from(), self.motion.to());
        if self.is_reversed { [to, from] } else { [from, to] }
    }

    #[inline(always)]
    pub(super) fn given<N: Embeds<S>>(&self) -> Option<Given<N>> {
        let [a, b, c] = self.triangle.points();
        let [from, to] = self.ends();
        let (p, q, is_by_center) = self.aabb.numbers();
        let all = [a, b, c, p, q, from.to_array(), to.to_array()];
        let [a, b, c, p, q, from, to] = N::embed(&all)?;
        Some(Given { triangle: [a, b, c], p, q, is_by_center, way: [from, to] })
    }

    #[inline(always)]
    pub(super) fn course<N: Embeds<S>>(&self) -> Option<Course<N>> {
        Some(self.given::<N>()?.course())
    }

    pub(super) fn exactly(&self) -> ExactCourse {
        ExactCourse::new(self.triangle, self.aabb, self.ends())
    }
}

/// The coordinates of the shapes and the motion in a number system.
pub(super) struct Given<N: Arithmetic> {
    pub(super) triangle: [[N::Length; 3]; 3],
    pub(super) p: [N::Length; 3],
    pub(super) q: [N::Length; 3],
    /// Whether p and q are centre and half-extents; otherwise they are corners.
    pub(super) is_by_center: bool,
    pub(super) way: [[N::Length; 3]; 2],
}

impl<N: Arithmetic> Given<N> {
    #[inline(always)]
    pub(super) fn course(self) -> Course<N> {
        let Self { triangle, p, q, is_by_center, way: [from, to] } = self;
        let form = if is_by_center {
            BoxForm::Center(p, q)
        } else {
            BoxForm::Corners(p, q, [N::Length::ZERO; 3])
        };
        let d = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
        Course { frame: Frame::new(&triangle, &form), d }
    }
}

/// Does the triangle miss the box?
pub(super) struct Misses<'a, S>(pub(super) Passing<'a, S>);

impl<S: Scalar> Misses<'_, S> {
    /// The answer. Floats that functions compute begin with cut numbers.
    #[inline(always)]
    fn answer(&self) -> bool {
        in_cut_floats::<S, _>(|| short::misses(&self.0)).unwrap_or_else(|| S::evaluate(self))
    }
}

impl<S: Scalar> Predicate<S> for Misses<'_, S> {
    type Answer = bool;

    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        self.0.course::<N>()?.misses()
    }

    const PROFILE: Profile = Profile::QUADS;

    #[inline(always)]
    fn in_quads<F: Float>(&self) -> Option<bool>
    where
        S: InFloat<F>,
    {
        rows::misses::<S, F>(&self.0)
    }

    #[inline(always)]
    fn in_words(&self, _: bool) -> Option<bool>
    where
        S: FixedBackend,
    {
        if words::are_short::<S>() { S::in_machine_words(self) } else { None }
    }

    fn exact(&self) -> bool {
        if REGISTERS_ARE_WIDE {
            return in_exact_numbers(self);
        }
        self.0.exactly().misses::<S>()
    }
}

impl<S: Scalar + InRaw> WordKernel<S> for Misses<'_, S> {
    #[inline(always)]
    fn narrow<W: Word>(&self) -> Option<bool> {
        if S::is_always_near::<W>() {
            Some(self.0.misses_in_any_words::<W>())
        } else {
            self.0.misses_in_near_words::<W>()
        }
    }
}

impl<S: Scalar> Passing<'_, S> {
    #[inline]
    pub(super) fn meet(self) -> bool {
        !Misses(self).answer()
    }

    /// Whether the shapes have a point in common at the start. A body that rests on a surface is in doubt
    /// on any way along it or into it, and without the motion that takes much less to decide.
    #[inline(never)]
    fn touches_at_start(&self) -> bool {
        self.triangle.overlaps(self.aabb)
    }

    /// What is known of the time of shapes that meet, where functions compute `f64`: without `f64` whether they
    /// touch at the start; and the axis that closes last, if no function computes the scalar.
    #[inline(always)]
    fn instant(&self) -> Instant {
        if S::FLOAT.is_none() || !cuts_floats::<f64>() {
            return Instant::Unknown;
        }
        if self.touches_at_start() {
            return Instant::AtStart;
        }
        let instant = if is_software::<S>() { None } else { S::evaluate_bounded(&When(self)) };
        instant.unwrap_or_default()
    }

    pub(super) fn first_contact(self) -> Option<FirstContact<S>> {
        let instant = if S::IN_QUADS { S::in_quads(&When(&self)) } else { None };
        match instant {
            Some(Instant::Misses) => None,
            Some(Instant::AtStart) => Some(FirstContact::default()),
            Some(Instant::Meets(None) | Instant::Unknown) if self.touches_at_start() => {
                Some(FirstContact::default())
            }
            Some(Instant::Meets(last)) => Some(S::evaluate_numeric(&Meets { passing: self, last })),
            Some(Instant::Unknown) | None => {
                let misses = Misses(self);
                let is_miss = if S::IN_QUADS { S::without_quads(&misses) } else { misses.answer() };
                let passing = misses.0;
                if is_miss {
                    return None;
                }
                let last = match passing.instant() {
                    Instant::AtStart => return Some(FirstContact::default()),
                    Instant::Meets(last) => last,
                    _ => None,
                };
                Some(S::evaluate_numeric(&Meets { passing, last }))
            }
        }
    }
}

// How near the triangle comes to the box.
//
// The triangle sweeps a convex set, and the relative interior of that set is all that the relative
// interior of the triangle sweeps strictly between start and end. The relation of the swept set
// and the box is therefore the nearest relation strictly between start and end. At the ends the
// relation may be nearer only if triangle, box and motion do not span space together: the shapes
// of a box with volume have interior points in common at all times close to such an end, too.

/// How near does the triangle come to the box strictly between start and end, or at the end?
pub(super) struct Nearest<'a, 'b, S> {
    pub(super) passing: &'b Passing<'a, S>,
    pub(super) is_at_end: bool,
}

impl<S: Scalar> Predicate<S> for Nearest<'_, '_, S> {
    type Answer = Relation;

    fn filter<N: Embeds<S>>(&self) -> Option<Relation> {
        if !self.is_at_end {
            return self.passing.course::<N>()?.relation();
        }
        // Short integers have no room for a triangle that has moved.
        if !N::LARGE {
            return None;
        }
        let mut given = self.passing.given::<N>()?;
        let [from, to] = given.way;
        for vertex in &mut given.triangle {
            for i in 0..3 {
                vertex[i] = vertex[i] + to[i] - from[i];
            }
        }
        given.way = [from; 2];
        given.course().relation()
    }
}

impl<S: Scalar> Passing<'_, S> {
    /// Whether a face of the box touches the triangle all the way, as of a body that slides on a level
    /// floor.
    fn stays_in_touch(&self) -> bool {
        let [from, to] = self.ends().each(Vec3::to_array);
        (0..3).any(|i| from[i] == to[i] && touches_face(self.triangle, self.aabb, i))
    }

    /// The nearest relation on the way.
    pub(super) fn relation(self) -> Relation {
        let question = Misses(self);
        let passing = &question.0;
        let is_miss = if S::IN_QUADS { S::in_quads(&question) } else { Some(question.answer()) };
        if is_miss.is_none() && passing.stays_in_touch() && passing.touches_at_start() {
            return Relation::Touching;
        }
        if is_miss.unwrap_or_else(|| S::without_quads(&question)) {
            return Relation::Disjoint;
        }
        let between = S::evaluate(&Nearest { passing, is_at_end: false });
        if between != Relation::Touching || has_volume(passing.aabb) {
            return between;
        }
        let at_start = passing.triangle.relation(passing.aabb);
        // Only the last stages answer this question.
        let at_end = Nearest { passing, is_at_end: true }.exact();
        between.max(at_start).max(at_end)
    }
}

pub(super) fn has_volume<S: Scalar>(aabb: &Aabb<S>) -> bool {
    let (low, high) = match *aabb.form() {
        AabbForm::Center { half, .. } => ([S::ZERO; 3], half.to_array()),
        AabbForm::Corners { min, max } => (min.to_array(), max.to_array()),
    };
    low.iter().zip(&high).all(|(low, high)| low < high)
}
