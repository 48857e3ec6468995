use crate::scalar::{Number, Numbers, greatest, least};

/// How a box was given, in a number system's own lengths.
#[derive(Clone, Copy, Debug)]
pub(crate) enum BoxForm<L> {
    /// Centre and half-extents.
    Center([L; 3], [L; 3]),
    /// Least and greatest corner, and by how much to grow the box on each side;
    /// in floats, which always have a centre's form of their own, by nought.
    Corners([L; 3], [L; 3], [L; 3]),
}

/// A triangle in the frame of a box: see [`Numbers`] on the frame.
pub(crate) struct Frame<N: Numbers> {
    /// The vertices.
    pub(crate) v: [[N::Length; 3]; 3],
    /// The edges, each from a vertex to the next; not doubled.
    pub(crate) e: [[N::Length; 3]; 3],
    /// The half-extents.
    pub(crate) h: [N::Length; 3],
    /// The gap between box and triangle along each coordinate axis, below nought
    /// where they overlap; floats only.
    pub(super) gaps: [N::Length; 3],
    /// Whether a gap of nought is one indeed, and not a rounded one. The sign of
    /// any other is right: a difference of two numbers rounds to nought only if
    /// it is nought, and rounding keeps order.
    pub(super) gaps_are_exact: bool,
    /// The triangle's extent along each coordinate axis and the half-extent of the
    /// box, together; floats only.
    spans: [N::Length; 3],
}

impl<N: Numbers> Frame<N> {
    #[inline(always)]
    pub(crate) fn new(t: &[[N::Length; 3]; 3], form: &BoxForm<N::Length>) -> Self {
        let zero = N::Length::ZERO;
        let (mut h, mut gaps, mut spans) = ([zero; 3], [zero; 3], [zero; 3]);
        let v = match form {
            BoxForm::Center(c, half) => {
                let from = |p: [N::Length; 3]| {
                    [
                        N::from_center(p[0], c[0]),
                        N::from_center(p[1], c[1]),
                        N::from_center(p[2], c[2]),
                    ]
                };
                let v = [from(t[0]), from(t[1]), from(t[2])];
                for i in 0..3 {
                    let (low, high) = range(&v, i);
                    h[i] = N::half_extent(half[i]);
                    if !N::FINAL {
                        gaps[i] = greatest(low, -high) - h[i];
                        spans[i] = h[i] + (high - low);
                    }
                }
                v
            }
            BoxForm::Corners(min, max, grown) => {
                let from = |p: [N::Length; 3]| {
                    [
                        N::from_corners(p[0], min[0], max[0]),
                        N::from_corners(p[1], min[1], max[1]),
                        N::from_corners(p[2], min[2], max[2]),
                    ]
                };
                let v = [from(t[0]), from(t[1]), from(t[2])];
                for i in 0..3 {
                    let (low, high) = range(t, i);
                    h[i] = N::half_between(min[i], max[i]);
                    if N::FINAL {
                        h[i] = h[i] + N::half_extent(grown[i]);
                    } else {
                        gaps[i] = greatest(low - max[i], min[i] - high);
                        spans[i] = h[i] + (high - low);
                    }
                }
                v
            }
        };
        let difference =
            |a: [N::Length; 3], b: [N::Length; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
        Self {
            v,
            e: [difference(t[1], t[0]), difference(t[2], t[1]), difference(t[0], t[2])],
            h,
            gaps,
            gaps_are_exact: matches!(form, BoxForm::Corners(..)),
            spans,
        }
    }
}

impl<N: Numbers> Frame<N> {
    /// No coordinate in the frame exceeds this, if there is no gap; nor does an
    /// edge, nor a half-extent.
    #[inline(always)]
    pub(crate) fn reach(&self) -> N::Length {
        if N::FINAL {
            return self.largest();
        }
        let [x, y, z] = self.spans;
        greatest(greatest(x, y), z)
    }

    /// The same, gap or no gap.
    pub(crate) fn reach_across_gap(&self) -> N::Length {
        if N::FINAL {
            return self.largest();
        }
        let [x, y, z] = self.gaps;
        self.reach() + greatest(greatest(greatest(x, y), z), N::Length::ZERO)
    }

    /// The greatest coordinate or half-extent. A sum of the two might not fit.
    #[inline(always)]
    fn largest(&self) -> N::Length {
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
pub(super) fn range<L: Number>(t: &[[L; 3]; 3], i: usize) -> (L, L) {
    (least(least(t[0][i], t[1][i]), t[2][i]), greatest(greatest(t[0][i], t[1][i]), t[2][i]))
}
