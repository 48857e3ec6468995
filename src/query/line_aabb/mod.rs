//! A line in the three slabs of an axis-aligned box, for rays and segments.

use core::marker::PhantomData;

use super::crossing::Entries;
use crate::arithmetic::{Arithmetic, Each, Embeds, Number, compare, greatest, least, once, pick};
use crate::query::relation::{Nearness, Reading, Relation, of_gaps};
use crate::robust::Uncertain;

/// Roundoffs in a comparison of two products, per sum of their sizes.
///
/// Each product is of a length, which carries up to two roundings, and a magnitude, which carries
/// one. `roundoffs.g` proves the bound, with second orders and underflow.
const ROUNDOFFS: u16 = 6;

/// A line o + t·d in the three slabs of a box. Axes on which the line falls are mirrored, so that
/// it rises on all.
///
/// On axis i the line is in the slab for m_i·t from near_i to far_i, with m = |d|. Intervals have a
/// point in common exactly if every two of them have one (Helly's theorem on a line). So the line
/// meets the box exactly if there are no i ≠ j with near_i/m_i > far_j/m_j: six comparisons of
/// products. If m_j is zero, they decide whether the line runs within slab j; if m_i is zero too,
/// the comparison is of zeros. In pairs they are the separating axes x_k × d of *Real-Time
/// Rendering* 16.7.
pub(super) struct Slabs<N: Arithmetic> {
    /// From the line's origin to the face that it meets first.
    pub(super) near: [N::Length; 3],
    /// From the origin to the face that it meets last.
    pub(super) far: [N::Length; 3],
    /// The magnitudes of the direction.
    pub(super) m: [N::Length; 3],
    /// A bound of the rounded sums, if near and far are sums of three numbers. Differences of two
    /// numbers err relative to themselves, and their sign is right.
    pub(super) spread: Option<[N::Length; 3]>,
}

impl<N: Arithmetic> Slabs<N> {
    /// The line from `o` along `d`, and the box from `min` to `max`.
    #[inline(always)]
    pub(super) fn in_corners(
        o: &[N::Length; 3],
        d: &[N::Length; 3],
        min: &[N::Length; 3],
        max: &[N::Length; 3],
    ) -> Self {
        let zero = [N::Length::ZERO; 3];
        let (mut near, mut far, mut m) = (zero, zero, zero);
        for i in 0..3 {
            let (low, high) = (min[i] - o[i], max[i] - o[i]);
            let falls = d[i] < N::Length::ZERO;
            near[i] = if falls { -high } else { low };
            far[i] = if falls { -low } else { high };
            m[i] = d[i].magnitude();
        }
        Self { near, far, m, spread: None }
    }

    /// The line from `o` along `d`, and the box around `center`.
    #[inline(always)]
    pub(super) fn in_center(
        o: &[N::Length; 3],
        d: &[N::Length; 3],
        center: &[N::Length; 3],
        half: &[N::Length; 3],
    ) -> Self {
        let zero = [N::Length::ZERO; 3];
        let (mut near, mut far, mut m, mut spread) = (zero, zero, zero, zero);
        for i in 0..3 {
            let to_center = center[i] - o[i];
            let falls = d[i] < N::Length::ZERO;
            let along = if falls { -to_center } else { to_center };
            near[i] = along - half[i];
            far[i] = along + half[i];
            spread[i] = along.magnitude() + half[i];
            m[i] = d[i].magnitude();
        }
        Self { near, far, m, spread: Some(spread) }
    }

    /// The line from the origin, and intervals from `low` − `grown` to `high` + `grown`. `axis`
    /// returns `low`, `high`, `grown` and the direction on an axis, each rounded at most once.
    #[inline(always)]
    pub(super) fn of_intervals(
        axis: impl Fn(usize) -> (N::Length, N::Length, N::Length, N::Length),
    ) -> Self {
        let zero = [N::Length::ZERO; 3];
        let (mut near, mut far, mut m, mut spread) = (zero, zero, zero, zero);
        let mut is_grown = false;
        for i in 0..3 {
            let (low, high, grown, d) = axis(i);
            is_grown |= grown != N::Length::ZERO;
            let falls = d < N::Length::ZERO;
            near[i] = if falls { -high } else { low } - grown;
            far[i] = if falls { -low } else { high } + grown;
            spread[i] = greatest(low.magnitude(), high.magnitude()) + grown;
            m[i] = d.magnitude();
        }
        Self { near, far, m, spread: is_grown.then_some(spread) }
    }

    /// Whether the whole line misses the box, unless its direction is zero.
    #[inline(always)]
    pub(super) fn line_misses(&self) -> Uncertain {
        // Exact zeros matter only in doubt.
        let so_far = self.pairs_miss(false);
        if so_far.certain == so_far.possible { so_far } else { self.pairs_miss(true) }
    }

    #[inline(always)]
    fn pairs_miss(&self, heeds_zeros: bool) -> Uncertain {
        let mut so_far = Uncertain::NONE;
        for i in 0..3 {
            so_far = so_far.or(self.pair_misses(i, (i + 1) % 3, heeds_zeros));
            so_far = so_far.or(self.pair_misses((i + 1) % 3, i, heeds_zeros));
        }
        so_far
    }

    /// Whether the line leaves slab j before it enters slab i.
    #[inline(always)]
    fn pair_misses(&self, i: usize, j: usize, heeds_zeros: bool) -> Uncertain {
        let spread = self.spread.as_ref();
        let of = |face: &[N::Length; 3], i: usize| {
            [*pick(face, i), *pick(&self.m, i), *pick(spread.unwrap_or(face), i)]
        };
        later::<N>(of(&self.near, i), of(&self.far, j), spread.is_none(), heeds_zeros)
    }

    /// The same line, run through backwards.
    #[inline(always)]
    pub(super) fn reversed(&self) -> Self {
        let Self { near, far, m, spread } = *self;
        Self { near: far.each(|x| -x), far: near.each(|x| -x), m, spread }
    }

    /// Whether all of the box lies before the origin on some axis: t < 0.
    #[inline(always)]
    pub(super) fn lies_before(&self) -> Uncertain {
        let [x, y, z] = self.far;
        self.side(-least(least(x, y), z))
    }

    /// Whether all of the box lies beyond the origin on some axis: t > 0.
    #[inline(always)]
    pub(super) fn lies_beyond(&self) -> Uncertain {
        let [x, y, z] = self.near;
        self.side(greatest(greatest(x, y), z))
    }

    /// Rounding keeps order, so only the sign of zero is in doubt.
    #[inline(always)]
    fn side(&self, gap: N::Length) -> Uncertain {
        let certain = gap > N::Length::ZERO;
        let touch = !N::CERTAIN & self.spread.is_some() & (gap == N::Length::ZERO);
        Uncertain { certain, possible: certain | touch }
    }

    /// Whether t·m_i exceeds `face` of slab i, or, unless `is_lower`, is exceeded by it.
    #[inline(always)]
    fn compared<S>(
        &self,
        i: usize,
        [t, unit]: [N::Length; 2],
        face: N::Length,
        is_lower: bool,
    ) -> Uncertain
    where
        N: Embeds<S>,
    {
        // In the frame integers are doubled, as `times_one` is.
        let (m, zero) = (once::<N, _>(*pick(&self.m, i)), N::Length::ZERO);
        let (at, face_area) = (N::area(t, m), N::times_one(face, unit));
        let (own, is_zero) = match &self.spread {
            Some(spread) => (*pick(spread, i), false),
            None => (face.magnitude(), (m == zero) & (face == zero)),
        };
        let size = at.magnitude() + N::times_one(own, unit);
        let (a, b) = if is_lower { (at, face_area) } else { (face_area, at) };
        above::<N>(a, b, is_zero, size)
    }

    /// Whether on some axis all of the box lies at t < `from` or at t > `to`, with the unit of length.
    #[inline(always)]
    pub(super) fn lies_outside<S>(
        &self,
        from: Option<N::Length>,
        to: Option<N::Length>,
        unit: N::Length,
    ) -> Uncertain
    where
        N: Embeds<S>,
    {
        let mut so_far = Uncertain::NONE;
        for i in 0..3 {
            if let Some(from) = from {
                so_far = so_far.or(self.compared(i, [from, unit], self.far[i], true));
            }
            if let Some(to) = to {
                so_far = so_far.or(self.compared(i, [to, unit], self.near[i], false));
            }
        }
        so_far
    }

    /// How near the motion from the origin by `d` comes to the box, or, for two boxes, how near
    /// they come to each other. The axes are the three faces and their cross products with `d`.
    pub(super) fn relation(&self) -> Option<Relation> {
        let (Self { near, far, m, spread }, zero) = (self, N::Length::ZERO);
        let size = |i: usize| match spread {
            Some(spread) => spread[i],
            None => greatest(near[i].magnitude(), far[i].magnitude()),
        };
        let mut found = Nearness::NONE;
        for i in 0..3 {
            if N::CERTAIN {
                // Without differences, which might not fit.
                let is_touch = (near[i] == m[i]) | (far[i] == zero);
                let is_point = (near[i] == far[i]) & (m[i] == zero);
                found.add_known((near[i] > m[i]) | (far[i] < zero), is_touch & !is_point);
            } else {
                let gap = greatest(near[i] - m[i], -far[i]);
                found.add(gap, far[i] - near[i] + m[i], (size(i) + m[i]).error(ROUNDOFFS));
            }
            let j = (i + 1) % 3;
            let before = N::minor([near[i], m[j]], [far[j], m[i]]);
            let after = N::minor([near[j], m[i]], [far[i], m[j]]);
            let size = N::area(size(i), m[j]) + N::area(size(j), m[i]);
            let error = size.error(ROUNDOFFS) + N::Area::UNDERFLOW;
            found.add(greatest(before, after), -(before + after), error);
        }
        let between = found.answer(N::CERTAIN)?;
        if !N::CERTAIN || between != Relation::Touching {
            return Some(between);
        }
        // At the start or the end flat boxes may overlap that only touch in between: see
        // `sweep::passing`.
        let at = |t: &[N::Length; 3]| {
            (0..3).fold(Relation::Overlapping, |so_far, i| {
                so_far.min(of_gaps([compare(near[i], t[i]), compare(t[i], far[i])]))
            })
        };
        Some(between.max(at(&[zero; 3])).max(at(m)))
    }

    /// Whether on some axis all of the box lies at t < −1 or at t > 1.
    #[inline(always)]
    pub(super) fn lies_beyond_one(&self) -> Uncertain {
        let mut so_far = Uncertain::NONE;
        for i in 0..3 {
            let gap = greatest(self.near[i], -self.far[i]) - self.m[i];
            let own = greatest(self.near[i].magnitude(), self.far[i].magnitude());
            let own = self.spread.as_ref().map_or(own, |spread| spread[i]);
            let error = (own + self.m[i]).error(ROUNDOFFS);
            so_far = so_far.or(Uncertain::above(gap, error));
        }
        so_far
    }
}

/// Whether p/m > q/n: a face p with the direction's magnitude m, and the bound of its rounded sum.
/// If they are exact, the bounds are the faces themselves.
#[inline(always)]
fn later<N: Arithmetic>(
    [p, m, of_p]: [N::Length; 3],
    [q, n, of_q]: [N::Length; 3],
    are_exact: bool,
    heeds_zeros: bool,
) -> Uncertain {
    if N::LARGE {
        return Uncertain::known(N::minor([p, n], [q, m]) > N::Area::ZERO);
    }
    let (a, b) = (N::area(p, n), N::area(q, m));
    let size =
        if are_exact { a.magnitude() + b.magnitude() } else { N::area(of_p, n) + N::area(of_q, m) };
    let zero = N::Length::ZERO;
    let is_zero = heeds_zeros
        & ((n == zero) | (are_exact & (p == zero)))
        & ((m == zero) | (are_exact & (q == zero)));
    above::<N>(a, b, is_zero, size)
}

/// A line through slabs from a least t, if it has one, with the unit of length.
pub(super) struct Entering<'a, N: Arithmetic, S>(
    pub(super) &'a Slabs<N>,
    pub(super) Option<[N::Length; 2]>,
    pub(super) PhantomData<S>,
);

impl<S, N: Embeds<S>> Entries for Entering<'_, N, S> {
    #[inline(always)]
    fn crosses(&self, i: usize) -> Option<bool> {
        Some(*pick(&self.0.m, i) != N::Length::ZERO)
    }

    #[inline(always)]
    fn is_later(&self, i: usize, j: usize) -> Option<bool> {
        let Slabs { near, m, spread, .. } = self.0;
        let of =
            |i: usize| [*pick(near, i), *pick(m, i), *pick(spread.as_ref().unwrap_or(near), i)];
        later::<N>(of(i), of(j), spread.is_none(), true).verdict()
    }

    #[inline(always)]
    fn is_past(&self, i: usize) -> Option<bool> {
        let Self(line, Some(from), _) = *self else { return Some(false) };
        let near = *pick(&line.near, i);
        // If the range begins at zero, a sign suffices.
        let is_past = if from[0] == N::Length::ZERO {
            line.side(-near)
        } else {
            line.compared(i, from, near, true)
        };
        is_past.verdict()
    }
}

/// Whether a > b, where their sizes together bound the error. It is certain if both are known to be
/// zero.
#[inline(always)]
fn above<N: Arithmetic>(a: N::Area, b: N::Area, is_zero: bool, size: N::Area) -> Uncertain {
    if N::CERTAIN {
        return Uncertain::known(a > b);
    }
    let found = Uncertain::above(a - b, size.error(ROUNDOFFS) + N::Area::UNDERFLOW);
    Uncertain { possible: found.possible & !is_zero, ..found }
}
