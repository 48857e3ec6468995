//! The question in machine words, for narrow registers: the kernel of `super::kernel` with an early
//! exit after each volume, and quotients place by place.

use core::cmp::Ordering;

use super::crosses::Crosses;
use super::kernel::{Crossing, Setting};
use super::{Facing, Hit};
use crate::arithmetic::{
    InRaw, Number, WholeVolume, WholeWord, Word, compare, cross_words, dot_words, first_sign,
};
use crate::query::triangle_aabb::words::{minus, words};
use crate::scalar::Scalar;

/// A crossing that counts, with all volumes except t nonnegative.
pub(super) struct Counted<V> {
    pub(super) is_front: bool,
    pub(super) volumes: Crossing<V>,
}

impl<S: Scalar + InRaw> Crosses<'_, S> {
    /// The crossing, if it counts, in words wide enough for shapes anywhere.
    #[inline(never)]
    pub(super) fn in_any_words<W: WholeWord>(&self) -> Option<Counted<W::Whole>> {
        self.counted_in_words(&self.in_word_vectors::<W>())
    }

    /// The crossing, if it counts, in words wide enough for shapes near each other; `None` if they
    /// are not.
    #[inline(never)]
    fn in_near_words<W: WholeWord>(&self) -> Option<Option<Counted<W::Whole>>> {
        let setting = self.in_word_vectors::<W>();
        let [x, y, z]: [W; 3] = words(&self.triangle.vertices()[0]);
        let length = |x: &[W; 3]| x[0].folded() | x[1].folded() | x[2].folded();
        let Setting { d, e: [e1, e2], s } = &setting;
        (x.is_central()
            && y.is_central()
            && z.is_central()
            && (length(d) | length(e1) | length(e2) | length(s)).has_volumes())
        .then(|| self.counted_in_words(&setting))
    }

    /// Applies `f` to the crossing that counts, in words wide enough for ray and triangle.
    #[inline(always)]
    pub(super) fn in_words<W: WholeWord, T>(
        &self,
        f: impl Fn(Option<Counted<W::Whole>>) -> T,
    ) -> Option<T> {
        if S::is_always_near::<W>() {
            Some(f(self.in_any_words::<W>()))
        } else {
            self.in_near_words::<W>().map(f)
        }
    }

    #[inline(always)]
    fn in_word_vectors<W: Word>(&self) -> Setting<W> {
        let [a, b, c] = self.triangle.vertices();
        let (a, b, c) = (words(a), words(b), words(c));
        let (o, d) = (words(&self.ray.origin()), words(&self.ray.direction()));
        Setting { d, e: [minus(&b, &a), minus(&c, &a)], s: minus(&o, &a) }
    }

    #[inline(always)]
    fn counted_in_words<W: WholeWord>(&self, setting: &Setting<W>) -> Option<Counted<W::Whole>> {
        let zero = W::Whole::ZERO;
        self.counted(
            setting,
            (cross_words::<W>, dot_words::<W>),
            |t, det, end| match end == S::ZERO {
                true => compare(t, zero),
                false => S::compare_quotient(t, det, end),
            },
            |k| perturbed(setting, k),
        )
    }
}

impl<S: Scalar> Crosses<'_, S> {
    /// The crossing, if it counts, from the cross product of lengths and the product of areas with
    /// lengths. `compare_quotient` compares t with an end of the range, and `perturbed` is that of the
    /// setting.
    #[inline(always)]
    pub(super) fn counted<L: Copy, A, V: Number>(
        &self,
        setting: &Setting<L>,
        (cross, dot): (impl Fn(&[L; 3], &[L; 3]) -> [A; 3], impl Fn(&[A; 3], &[L; 3]) -> V),
        compare_quotient: impl Fn(V, V, S) -> Ordering,
        perturbed: impl Fn(usize) -> Ordering,
    ) -> Option<Counted<V>> {
        let Setting { d, e: [e1, e2], s } = setting;
        let zero = V::ZERO;
        let p = cross(d, e2);
        let det = dot(&p, e1);
        let is_front = det > zero;
        if det == zero || !self.keeps(is_front) {
            return None;
        }
        let oriented = |x: V| if is_front { x } else { -x };
        let (det, u) = (oriented(det), oriented(dot(&p, s)));
        if u < zero || u > det {
            return None;
        }
        let q = cross(s, e1);
        let v = oriented(dot(&q, d));
        let w = det - u - v;
        if v < zero || w < zero {
            return None;
        }
        let volumes = Crossing { det, t: oriented(dot(&q, e2)), sides: [w, u, v] };
        let compare_with = |end: S| Some(compare_quotient(volumes.t, det, end));
        self.admits(is_front, volumes.zeros(), compare_with, perturbed)?
            .then_some(Counted { is_front, volumes })
    }
}

/// [`Setting::perturbed`] in words, out of line as [`Setting::perturbed_in`] is.
#[inline(never)]
fn perturbed<W: Word>(setting: &Setting<W>, k: usize) -> Ordering {
    setting.perturbed(k, minus, first_sign)
}

/// The hit, with each number rounded once.
#[inline(always)]
pub(super) fn rounded<S: Scalar + InRaw, V: WholeVolume>(
    Counted { is_front, volumes }: &Counted<V>,
) -> Hit<S> {
    let Crossing { det, t, sides: [_, u, v] } = *volumes;
    Hit {
        t: S::divided(t, det),
        u: S::share(u, det),
        v: S::share(v, det),
        facing: Facing::of(*is_front),
        feature: volumes.feature(),
    }
}

#[cfg(all(test, feature = "fixed"))]
mod tests {
    use crate::arithmetic::Each;
    use fixed::types::{I0F32, I4F4, I8F8, I16F16};

    use super::super::Feature;
    use super::*;
    use crate::query::{Cull, HitRules};
    use crate::random::Random;
    use crate::robust::{Predicate, WordKernel};
    use crate::shape::{Ray, Triangle};

    /// Words agree with exact sums, for numbers of these bits. The number of hits is checked too.
    fn check<S: Scalar + InRaw, W: WholeWord>(bits: u32, length_bits: u32, of: impl Fn(i64) -> S) {
        let rng = &mut Random(u64::from(bits));
        let (mut hits, mut on_edges) = (0, 0);
        for case in 0..6_000 {
            let kind = case % 3;
            let mut point = || [(); 3].each(|()| rng.of_bits(kind, bits));
            let [a, b, c, o, aside] = [point(), point(), point(), point(), point()];
            // Toward a point of the triangle.
            let (i, j) = (rng.below(5), rng.below(5));
            let (i, j) = (i.min(4 - j), j);
            let end = (1 << length_bits) - 1;
            let toward = [0, 1, 2]
                .each(|k| a[k] + ((b[k] - a[k]) * i + (c[k] - a[k]) * j) / 4 - o[k])
                .each(|x| x.clamp(-end - 1, end));
            let d = if case % 7 == 0 { aside } else { toward };
            let vector = |x: [i64; 3]| x.each(&of);
            let triangle = Triangle::new(vector(a), vector(b), vector(c)).unwrap();
            let Ok(ray) = Ray::new(vector(o), vector(d)) else { continue };
            let cull = [Cull::Nothing, Cull::Nothing, Cull::Back, Cull::Front];
            let rules = HitRules::new().culling(cull[rng.below(4) as usize]);
            let rules = if rng.below(2) == 0 { rules } else { rules.once() };
            let line = ray.with_range(None, None).unwrap();
            let at = Crosses { ray: &line, triangle: &triangle, rules }.exact().map(|hit| hit.t);
            let (least, most) = (of(i64::MIN), of(i64::MAX));
            let ray = match (rng.below(5), at) {
                (0, Some(t)) => ray.with_range(t, most).unwrap(),
                (1, Some(t)) => ray.with_range(least, t).unwrap(),
                (2, _) => ray.with_range(least, most).unwrap(),
                (3, _) => line,
                _ => ray,
            };
            let question = Crosses { ray: &ray, triangle: &triangle, rules };
            let expected = question.exact();
            assert_eq!(question.narrow_volumes::<W>(), Some(expected), "{ray:?} {triangle:?}");
            hits += u32::from(expected.is_some());
            on_edges += u32::from(expected.is_some_and(|hit| hit.feature != Feature::Interior));
        }
        assert!(hits > 600 && on_edges > 150, "{hits} hits, {on_edges} on edges");
    }

    #[test]
    fn words_agree_with_exact_sums() {
        check::<I4F4, i16>(7, 7, |x| I4F4::from_bits(x.clamp(-128, 127) as i8));
        check::<I8F8, i32>(15, 15, |x| I8F8::from_bits(x.clamp(-32768, 32767) as i16));
        let bits = |x: i64| x.clamp(i32::MIN.into(), i32::MAX.into()) as i32;
        check::<I16F16, i32>(18, 19, |x| I16F16::from_bits(bits(x)));
        check::<I16F16, i64>(31, 31, |x| I16F16::from_bits(bits(x)));
        check::<I0F32, i64>(31, 31, |x| I0F32::from_bits(bits(x)));
    }

    /// There is no answer for shapes that a word cannot hold.
    #[test]
    fn words_leave_what_is_far() {
        let ray = |o: i32, d: i32| {
            Ray::new([o, 0, 9].each(I16F16::from_bits), [0, d, 1].each(I16F16::from_bits)).unwrap()
        };
        let [a, b, c] = [[0, 0, 0], [9, 0, 0], [0, 9, 0]].each(|p| p.each(I16F16::from_bits));
        let triangle = Triangle::new(a, b, c).unwrap();
        let answers = |o, d| {
            let rules = HitRules::new();
            Crosses { ray: &ray(o, d), triangle: &triangle, rules }
                .narrow_volumes::<i32>()
                .is_some()
        };
        let most = (1 << 19) - 1;
        assert!(answers(most, most) && answers(-most - 1, -most - 1));
        assert!(!answers(most + 1, 0) && !answers(0, most + 1) && !answers(0, -most - 2));
        // A difference that wraps to a short one.
        assert!(!answers(i32::MIN, 0));
        let far = [i32::MAX, 0, 0].each(I16F16::from_bits);
        let rules = HitRules::new();
        let triangle = Triangle::new(far, b, c).unwrap();
        let ray = ray(i32::MIN, 1);
        assert!(
            Crosses { ray: &ray, triangle: &triangle, rules }.narrow_volumes::<i32>().is_none()
        );
    }
}
