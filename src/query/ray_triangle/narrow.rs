//! The question in machine words, where registers are narrow: the kernel of `super::crossing`
//! with a way out after each volume, and quotients place by place.

use core::cmp::Ordering;

use super::question::{Crosses, facing};
use super::{Feature, Hit};
use crate::arithmetic::{InWholeWord, InWord, Number, WholeWord, Word};
use crate::arithmetic::{cross_words, dot_words, first_sign};
use crate::scalar::Scalar;
use crate::shape::Vec3;

/// A line and a triangle, relative to the triangle's first vertex.
pub(super) struct Lines<W> {
    /// The direction.
    d: [W; 3],
    /// The edges to the second and the third vertex.
    e: [[W; 3]; 2],
    /// From the first vertex to the origin.
    s: [W; 3],
}

/// Volumes of a crossing that counts: t is t/det, u is u/det, and so on; all but t are zero or
/// above.
pub(super) struct Counted<V> {
    is_front: bool,
    det: V,
    t: V,
    sides: [V; 3],
}

impl<W: Word> Lines<W> {
    /// The sign of the derivative of side `k` with respect to the origin; see
    /// `super::crossing`.
    fn perturbed_side(&self, k: usize) -> Ordering {
        let Self { d, e: [e1, e2], .. } = self;
        match k {
            0 => first_sign(d, &from(e1, e2)),
            1 => first_sign(d, e2),
            _ => first_sign(e1, d),
        }
    }

    /// The same of the numerator of t.
    fn perturbed_t(&self) -> Ordering {
        first_sign(&self.e[0], &self.e[1])
    }
}

impl<S: Scalar> Crosses<'_, S> {
    /// What counts, in words that hold ray and triangle wherever they are.
    #[inline(never)]
    pub(super) fn in_any_words<W: WholeWord>(&self) -> Option<Counted<W::Whole>>
    where
        S: InWholeWord<W>,
    {
        self.counted(&self.lines())
    }

    /// What counts, in words that hold them if they are near to each other.
    #[inline(never)]
    pub(super) fn in_near_words<W: WholeWord>(&self) -> Option<Option<Counted<W::Whole>>>
    where
        S: InWholeWord<W>,
    {
        let lines = self.lines();
        let [x, y, z] = words(&self.triangle.vertices()[0]);
        let length = |x: &[W; 3]| x[0].folded() | x[1].folded() | x[2].folded();
        let Lines { d, e: [e1, e2], s } = &lines;
        (x.is_central()
            && y.is_central()
            && z.is_central()
            && (length(d) | length(e1) | length(e2) | length(s)).has_volumes())
        .then(|| self.counted(&lines))
    }

    /// What `f` makes of what counts, in words that hold ray and triangle.
    #[inline(always)]
    pub(super) fn in_words<W: WholeWord, T>(
        &self,
        f: impl Fn(Option<Counted<W::Whole>>) -> T,
    ) -> Option<T>
    where
        S: InWholeWord<W>,
    {
        if S::ALWAYS_NEAR { Some(f(self.in_any_words())) } else { self.in_near_words().map(f) }
    }

    #[inline(always)]
    fn lines<W: Word>(&self) -> Lines<W>
    where
        S: InWord<W>,
    {
        let [a, b, c] = self.triangle.vertices();
        let a = words(a);
        let (o, d) = (words(&self.ray.origin()), words(&self.ray.direction()));
        Lines { d, e: [from(&words(b), &a), from(&words(c), &a)], s: from(&o, &a) }
    }

    #[inline(always)]
    fn counted<W: WholeWord>(&self, lines: &Lines<W>) -> Option<Counted<W::Whole>>
    where
        S: InWholeWord<W>,
    {
        let Lines { d, e: [e1, e2], s } = lines;
        let zero = W::Whole::ZERO;
        let p = cross_words(d, e2);
        let det = dot_words(&p, e1);
        let is_front = det > zero;
        if det == zero || !self.rules.cull.keeps(facing(is_front)) {
            return None;
        }
        let oriented = |x: W::Whole| if is_front { x } else { -x };
        let (det, u) = (oriented(det), oriented(dot_words(&p, s)));
        if u < zero || u > det {
            return None;
        }
        let q = cross_words(s, e1);
        let v = oriented(dot_words(&q, d));
        let w = det - u - v;
        if v < zero || w < zero {
            return None;
        }
        let t = oriented(dot_words(&q, e2));

        let turned = |sign: Ordering| if is_front { sign } else { sign.reverse() };
        let sides = [w, u, v];
        for (k, &side) in sides.iter().enumerate() {
            let side = if side == zero { Ordering::Equal } else { Ordering::Greater };
            if !self.admits(side, Ordering::Greater, || turned(lines.perturbed_side(k))) {
                return None;
            }
        }
        for (end, inside) in self.ends() {
            let Some(end) = end else { continue };
            let side = if end != S::ZERO {
                S::compare_quotient(t, det, end)
            } else if t == zero {
                Ordering::Equal
            } else if t < zero {
                Ordering::Less
            } else {
                Ordering::Greater
            };
            if !self.admits(side, inside, || turned(lines.perturbed_t())) {
                return None;
            }
        }
        Some(Counted { is_front, det, t, sides })
    }
}

/// The hit, its numbers rounded once.
#[inline(always)]
pub(super) fn rounded<S: Scalar + InWholeWord<W>, W: WholeWord>(
    counted: &Counted<W::Whole>,
) -> Hit<S> {
    let Counted { is_front, det, t, sides: [w, u, v] } = *counted;
    let zero = W::Whole::ZERO;
    Hit {
        t: S::divided(t, det),
        u: S::share(u, det),
        v: S::share(v, det),
        facing: facing(is_front),
        feature: Feature::from_zeros(w == zero, u == zero, v == zero),
    }
}

#[inline(always)]
fn words<S: InWord<W> + Copy, W: Word>(v: &Vec3<S>) -> [W; 3] {
    [v.x.in_word(), v.y.in_word(), v.z.in_word()]
}

/// to − from, wrapped.
#[inline(always)]
fn from<W: Word>(to: &[W; 3], from: &[W; 3]) -> [W; 3] {
    [to[0].minus(from[0]), to[1].minus(from[1]), to[2].minus(from[2])]
}
