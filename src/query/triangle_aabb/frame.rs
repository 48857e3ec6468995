use crate::arithmetic::{Arithmetic, Each, Number, greatest, least, minus3, of_two, once, three};

/// The form in which a box is given, in lengths of a number system.
#[derive(Clone, Copy, Debug)]
pub(in crate::query) enum BoxForm<L> {
    /// Centre and half-extents.
    Center([L; 3], [L; 3]),
    /// Least and greatest corner, and how far to grow the box on each side. In floats that is zero,
    /// because they treat a box by its centre separately.
    Corners([L; 3], [L; 3], [L; 3]),
}

/// A triangle in the frame of a box: see [`Arithmetic`].
pub(in crate::query) struct Frame<N: Arithmetic> {
    /// The vertices.
    pub(in crate::query) v: [[N::Length; 3]; 3],
    /// The edges, each from a vertex to the next; not doubled.
    pub(in crate::query) e: [[N::Length; 3]; 3],
    /// The half-extents.
    pub(in crate::query) h: [N::Length; 3],
    /// The gap between box and triangle along each coordinate axis, below zero
    /// where they overlap; floats only.
    pub(in crate::query) gaps: [N::Length; 3],
    /// Whether a gap of zero is certain and not rounded. The sign of any other gap is right: a
    /// difference of two numbers rounds to zero only if it is zero, and rounding keeps order.
    pub(in crate::query) gaps_are_exact: bool,
    /// The sum of the triangle's extent along each coordinate axis and the box's half-extent;
    /// floats only.
    spans: [N::Length; 3],
}

impl<N: Arithmetic> Frame<N> {
    #[inline(always)]
    pub(in crate::query) fn new(t: &[[N::Length; 3]; 3], form: &BoxForm<N::Length>) -> Self {
        let zero = N::Length::ZERO;
        let (mut h, mut gaps, mut spans) = ([zero; 3], [zero; 3], [zero; 3]);
        let v = match form {
            BoxForm::Center(c, half) => {
                let v = t.each(|p| three(|i| once::<N, _>(p[i] - c[i])));
                for i in 0..3 {
                    let (low, high) = range(&v, i);
                    h[i] = once::<N, _>(half[i]);
                    if !N::CERTAIN {
                        gaps[i] = greatest(low, -high) - h[i];
                        spans[i] = h[i] + (high - low);
                    }
                }
                v
            }
            BoxForm::Corners(min, max, grown) => {
                // Not v − (min + max)/2: rounding the sum errs by the distance from the origin,
                // rounding the differences only by the distance from the box.
                let from = |p: [N::Length; 3], i: usize| (p[i] - min[i]) + (p[i] - max[i]);
                let v = t.each(|p| three(|i| of_two::<N, _>(from(p, i))));
                for i in 0..3 {
                    let (low, high) = range(t, i);
                    h[i] = of_two::<N, _>(max[i] - min[i]);
                    if N::CERTAIN {
                        h[i] = h[i] + once::<N, _>(grown[i]);
                    } else {
                        gaps[i] = greatest(low - max[i], min[i] - high);
                        spans[i] = h[i] + (high - low);
                    }
                }
                v
            }
        };
        let e = [minus3(&t[1], &t[0]), minus3(&t[2], &t[1]), minus3(&t[0], &t[2])];
        let gaps_are_exact = matches!(form, BoxForm::Corners(..));
        Self { v, e, h, gaps, gaps_are_exact, spans }
    }

    /// An upper bound of every coordinate in the frame if there is no gap, and of every edge and
    /// half-extent.
    #[inline(always)]
    pub(in crate::query) fn size(&self) -> N::Length {
        if N::CERTAIN {
            return self.largest();
        }
        let [x, y, z] = self.spans;
        greatest(greatest(x, y), z)
    }

    /// The bound for a triangle that moves, if no face separates all the way. No gap is then longer than the
    /// motion. An infinite one has a span of NaN, which the greatest may miss.
    #[inline(always)]
    pub(in crate::query) fn size_along(&self, d: &[N::Length; 3]) -> N::Length {
        let along = |i: usize| greatest(self.spans[i] + d[i].magnitude(), self.gaps[i]);
        greatest(greatest(along(0), along(1)), along(2))
    }

    /// The bound with or without a gap.
    pub(in crate::query) fn size_across_gap(&self) -> N::Length {
        if N::CERTAIN {
            return self.largest();
        }
        let [x, y, z] = self.gaps;
        self.size() + greatest(greatest(greatest(x, y), z), N::Length::ZERO)
    }

    /// The greatest coordinate or half-extent. Their sum might not fit.
    #[inline(always)]
    fn largest(&self) -> N::Length {
        // No kernel asks how large such numbers are.
        if N::LARGE {
            return N::Length::ZERO;
        }
        let [a, b, c] = &self.v;
        let mut largest = N::Length::ZERO;
        for i in 0..3 {
            for x in [a[i], b[i], c[i], self.h[i]] {
                largest = greatest(largest, x.magnitude());
            }
        }
        largest
    }
}

/// Least and greatest coordinate `i` of three points.
#[inline(always)]
pub(crate) fn range<L: Number>(t: &[[L; 3]; 3], i: usize) -> (L, L) {
    (least(least(t[0][i], t[1][i]), t[2][i]), greatest(greatest(t[0][i], t[1][i]), t[2][i]))
}
