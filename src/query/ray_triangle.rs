//! Ray against triangle, exactly.
//!
//! T. Möller, B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection",
//! *Journal of Graphics Tools* 2(1), 1997; T. Akenine-Möller, E. Haines, N. Hoffman,
//! *Real-Time Rendering*, 16.8. The volumes are theirs. What differs: signs are
//! decided without a division, and exactly; quotients are rounded once.

use core::cmp::Ordering;

use super::crossing::{Crossing, Setting};
use super::{Facing, Feature, Hit, HitRules};
use crate::robust::ExactRay;
use crate::scalar::{ExactSum, Holds, Number, Predicate, Scalar};
use crate::shape::{Ray, Triangle};

/// The question where a ray crosses a triangle.
struct Crosses<'a, S> {
    ray: &'a Ray<S>,
    triangle: &'a Triangle<S>,
    rules: HitRules,
}

/// The question whether it does.
struct Hits<'a, S>(Crosses<'a, S>);

impl<S: Scalar> Predicate<S> for Crosses<'_, S> {
    type Answer = Option<Hit<S>>;

    fn attempt<N: Holds<S>>(&self) -> Option<Option<Hit<S>>> {
        match self.crossing::<N>()? {
            Some(crossing) => numbers::<S, N>(true, crossing),
            None => Some(None),
        }
    }

    #[inline(always)]
    fn quick<N: Holds<S>>(&self) -> Option<Option<Hit<S>>> {
        let (counts, crossing) = self.ahead::<N>()?;
        numbers::<S, N>(counts, crossing)
    }

    fn exact(&self) -> Option<Hit<S>> {
        let exact = self.taken_apart();
        let crossing = exact.crossing::<S>();
        let is_front = self.passes(&exact, &crossing.det, &crossing.sides, &crossing.t)?;
        let quotient = |x| S::quotient(x, &crossing.det);
        let [w, u, v] = &crossing.sides;
        let is_zero = |x: &S::Sum| x.sign() == Ordering::Equal;
        Some(Hit {
            t: quotient(&crossing.t),
            u: quotient(u),
            v: quotient(v),
            facing: facing(is_front),
            feature: Feature::from_zeros(is_zero(w), is_zero(u), is_zero(v)),
        })
    }
}

impl<S: Scalar> Predicate<S> for Hits<'_, S> {
    type Answer = bool;

    fn attempt<N: Holds<S>>(&self) -> Option<bool> {
        self.0.crossing::<N>().map(|crossing| crossing.is_some())
    }

    #[inline(always)]
    fn quick<N: Holds<S>>(&self) -> Option<bool> {
        self.0.ahead::<N>().map(|(counts, _)| counts)
    }

    fn exact(&self) -> bool {
        let exact = self.0.taken_apart();
        let crossing = exact.crossing::<S>();
        self.0.passes(&exact, &crossing.det, &crossing.sides, &crossing.t).is_some()
    }
}

/// The hit, if it counts; `None` where `N` has no good numbers for it.
#[inline(always)]
fn numbers<S: Scalar, N: Holds<S>>(
    counts: bool,
    crossing: Crossing<N::Volume>,
) -> Option<Option<Hit<S>>> {
    let facing = facing(crossing.is_front());
    let Crossing { det, t, sides: [w, u, v], slack } = crossing;
    let is_zero = |x: N::Volume| N::FINAL && x == N::Volume::ZERO;
    let feature = Feature::from_zeros(is_zero(w), is_zero(u), is_zero(v));
    // Even for a miss: to divide is cheaper than to guess wrong whether it is one.
    let ([t, u, v], are_good) = N::quotients([t, u, v], det, [slack.t, slack.side]);
    if counts & !are_good {
        return None;
    }
    let hit = Hit { t, u, v, facing, feature };
    Some(if counts { Some(hit) } else { None })
}

#[inline(always)]
fn facing(is_front: bool) -> Facing {
    if is_front { Facing::Front } else { Facing::Back }
}

impl<S: Scalar> Crosses<'_, S> {
    /// Whether a crossing ahead of the origin counts, and the crossing, where it is
    /// not a contact and the range is the usual one; `None` otherwise, or in doubt.
    #[inline(always)]
    fn ahead<N: Holds<S>>(&self) -> Option<(bool, Crossing<N::Volume>)> {
        if self.ray.t_min() != Some(S::ZERO) || self.ray.t_max().is_some() {
            return None;
        }
        let crossing = self.setting::<N>()?.crossing::<N>()?;
        let keeps = self.rules.cull.keeps(facing(crossing.is_front()));
        Some((crossing.strictly_ahead()? & keeps, crossing))
    }

    /// Ray and triangle in `N`, if it holds them.
    #[inline(always)]
    fn setting<N: Holds<S>>(&self) -> Option<Setting<N::Length>> {
        let [a, b, c] = self.triangle.points();
        let (o, d) = (self.ray.origin().to_array(), self.ray.direction().to_array());
        if !N::fits(&[a, b, c, o, d]) {
            return None;
        }
        let placed = N::place(&[a, b, c, o], &[d]);
        Some(Setting::new(&placed.points, placed.extents[0]))
    }

    /// The crossing, if it counts, contacts and any range included; `None` in doubt.
    #[inline]
    fn crossing<N: Holds<S>>(&self) -> Option<Option<Crossing<N::Volume>>> {
        let setting = self.setting::<N>()?;
        let crossing = if N::is_slim(setting.reach()) {
            let crossing = setting.crossing::<N::Slim>()?;
            crossing.meets(N::FINAL)?.then(|| crossing.widened(N::widened))
        } else {
            let crossing = setting.crossing::<N>()?;
            crossing.meets(N::FINAL)?.then_some(crossing)
        };
        let Some(crossing) = crossing else { return Some(None) };
        Some(self.counts::<N>(&setting, &crossing)?.then_some(crossing))
    }

    /// Whether the crossing of a line that meets the triangle counts; `None` in doubt.
    fn counts<N: Holds<S>>(
        &self,
        setting: &Setting<N::Length>,
        crossing: &Crossing<N::Volume>,
    ) -> Option<bool> {
        let zero = N::Volume::ZERO;
        let is_front = crossing.is_front();
        if !self.rules.cull.keeps(facing(is_front)) {
            return Some(false);
        }
        if N::FINAL && self.rules.once {
            for (k, side) in crossing.sides.iter().enumerate() {
                let nudged = || oriented(setting.nudged_side::<N>(k), is_front);
                if *side == zero && nudged() == Ordering::Less {
                    return Some(false);
                }
            }
        }
        let Crossing { det, t, slack, .. } = *crossing;
        let (det, t) = if is_front { (det, t) } else { (-det, -t) };
        for (end, inside) in self.ends() {
            let Some(end) = end else { continue };
            let side = if end == S::ZERO {
                let is_certain = N::FINAL || t.magnitude() > slack.t;
                is_certain.then(|| t.partial_cmp(&zero)).flatten()
            } else {
                N::compare_quotient(t, det, [slack.t, slack.side], end)
            }?;
            let nudged = || oriented(setting.nudged_t::<N>(), is_front);
            if !self.admits(side, inside, nudged) {
                return Some(false);
            }
        }
        Some(true)
    }

    /// The ends of the range, and on which side of each it lies.
    #[inline(always)]
    fn ends(&self) -> [(Option<S>, Ordering); 2] {
        [(self.ray.t_min(), Ordering::Greater), (self.ray.t_max(), Ordering::Less)]
    }

    fn taken_apart(&self) -> ExactRay {
        let (o, d) = (self.ray.origin().to_array(), self.ray.direction().to_array());
        ExactRay::new(&self.triangle.points(), &o, &d)
    }

    /// Whether a crossing counts, by exact sums, and if so whether the line runs
    /// against the normal.
    fn passes(
        &self,
        exact: &ExactRay,
        det: &S::Sum,
        sides: &[S::Sum; 3],
        t: &S::Sum,
    ) -> Option<bool> {
        let det = det.sign();
        let is_front = det == Ordering::Greater;
        if det == Ordering::Equal || !self.rules.cull.keeps(facing(is_front)) {
            return None;
        }
        for (k, side) in sides.iter().enumerate() {
            let nudged = || oriented(exact.nudged_side::<S>(k), is_front);
            if !self.admits(oriented(side.sign(), is_front), Ordering::Greater, nudged) {
                return None;
            }
        }
        for (end, inside) in self.ends() {
            let Some(end) = end else { continue };
            let side = if end == S::ZERO { t.sign() } else { exact.compare(end) };
            let nudged = || oriented(exact.nudged_t::<S>(), is_front);
            if !self.admits(oriented(side, is_front), inside, nudged) {
                return None;
            }
        }
        Some(is_front)
    }

    /// Whether what lies on this side of an end counts, if only `inside` does.
    #[inline(always)]
    fn admits(&self, side: Ordering, inside: Ordering, nudged: impl Fn() -> Ordering) -> bool {
        match side {
            Ordering::Equal if self.rules.once => nudged() == inside,
            Ordering::Equal => true,
            side => side == inside,
        }
    }
}

/// A sign, for a determinant above nought.
#[inline(always)]
fn oriented(sign: Ordering, is_front: bool) -> Ordering {
    if is_front { sign } else { sign.reverse() }
}

impl<S: Scalar> Ray<S> {
    /// Where the ray crosses a triangle, if it does.
    ///
    /// *Geometry*: one frame and unit for both. A ray that is parallel to the plane
    /// of the triangle, or lies in it, crosses nowhere; so does any ray a triangle
    /// that is a segment or a point. Both sides of the triangle count.
    ///
    /// *Contact*: edges, vertices, and the ends of the ray's range belong to it.
    /// [`Hit::feature`] says which was met.
    ///
    /// *Numerics*: whether there is a hit, its side and its feature are exact for
    /// every valid input, in every scalar, so that a closed mesh has no leak. t, u and
    /// v in fixed point are the nearest numbers of the type (of two, the even one),
    /// or the end of the type where it does not reach; in `f32` they are within 2 ulp,
    /// in `f64` within 2⁻³¹ of themselves, and nearly always within a few ulp. They
    /// are the same bits on every machine.
    ///
    /// *Range*: all finite floats, all fixed-point values. As with
    /// [`Triangle::overlaps`], what the fast stage cannot settle goes to wider
    /// numbers, and at last to exact sums, up to a thousand times slower.
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: 24 multiplications and 3 divisions, hit or miss. In `f32` on a wide
    /// machine 0.83 of the time of Möller–Trumbore with its early exits where half of
    /// the rays hit, 0.59 where a tenth does; ten times as long where the ray goes
    /// through an edge, exactly. Choose it unless you measured that you cannot pay for
    /// it; [`hits`](Self::hits) saves the divisions,
    /// [`hit_each`](Self::hit_each) asks about several triangles in a third of the time.
    ///
    /// *Source*: Möller and Trumbore 1997; the sign test, the error bound and the
    /// exact stages are ours.
    ///
    /// ```
    /// use septum::{Facing, Feature, Ray, Triangle};
    ///
    /// let ray = Ray::new([0.5, 0.5, 3.0], [0.0, 0.0, -2.0])?;
    /// let t = Triangle::new([0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0])?;
    /// let hit = ray.hit(&t).unwrap(); // in the middle of the long edge
    /// assert_eq!((hit.t, hit.u, hit.v), (1.5, 0.5, 0.5));
    /// assert_eq!((hit.feature, hit.facing), (Feature::Edge(1), Facing::Front));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    pub fn hit(&self, triangle: &Triangle<S>) -> Option<Hit<S>> {
        self.hit_with(triangle, HitRules::new())
    }

    /// [`hit`](Self::hit), but for a closed mesh each crossing counts once.
    ///
    /// A ray through an edge or a vertex meets every triangle there. Here it meets
    /// one of them: the one that it would meet had its origin moved by an
    /// infinitesimal amount, the same for every triangle. So through a consistently
    /// oriented closed mesh hits from outside and from inside alternate, and a point
    /// is inside exactly if a ray from it hits an odd number of triangles.
    ///
    /// *Contact*: a ray that touches the mesh without entering it hits two triangles
    /// or none. One that starts on a triangle hits it or does not, as the moved
    /// origin says.
    ///
    /// *Numerics*, *Range*, *Panics*: as [`hit`](Self::hit). *Cost*: the same, and a
    /// few comparisons where the ray goes through an edge, exactly.
    ///
    /// *Source*: symbolic perturbation: H. Edelsbrunner, E. P. Mücke, "Simulation of
    /// Simplicity", *ACM Transactions on Graphics* 9(1), 1990. The origin moves by
    /// (ε, ε², ε³).
    ///
    /// ```
    /// use septum::{Ray, Triangle};
    ///
    /// // Two triangles that share an edge, and a ray through it.
    /// let ray = Ray::new([0.5, 0.5, 1.0], [0.0, 0.0, -1.0])?;
    /// let (a, b, c) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]);
    /// let square = [Triangle::new([0.0; 3], a, b)?, Triangle::new(c, b, a)?];
    /// assert_eq!(square.iter().filter(|t| ray.hit(t).is_some()).count(), 2);
    /// assert_eq!(square.iter().filter(|t| ray.hit_once(t).is_some()).count(), 1);
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    pub fn hit_once(&self, triangle: &Triangle<S>) -> Option<Hit<S>> {
        self.hit_with(triangle, HitRules::new().once())
    }

    /// [`hit`](Self::hit) by the rules given.
    #[inline]
    pub fn hit_with(&self, triangle: &Triangle<S>, rules: HitRules) -> Option<Hit<S>> {
        S::measure(&Crosses { ray: self, triangle, rules })
    }

    /// Whether the ray crosses a triangle: [`hit`](Self::hit) without t, u and v.
    ///
    /// *Numerics*: exact. *Panics*: never. *Cost*: 24 multiplications, no division; 0.71
    /// and 0.50 where [`hit`](Self::hit) takes 0.83 and 0.59. Choose it for shadows and
    /// visibility.
    #[inline]
    pub fn hits(&self, triangle: &Triangle<S>) -> bool {
        self.hits_with(triangle, HitRules::new())
    }

    /// [`hits`](Self::hits) by the rules given.
    #[inline]
    pub fn hits_with(&self, triangle: &Triangle<S>, rules: HitRules) -> bool {
        S::measure(&Hits(Crosses { ray: self, triangle, rules }))
    }
}
