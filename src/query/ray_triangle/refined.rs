//! The crossing in `f64` in two parts, for signs in doubt.
//!
//! D, E and R are as in `super::error_bound`. A component x of a vector of size s (D, E or R) is
//! cut at a grid: x = h + l, with h a multiple of g, |h| ≤ (1 + 2^25)·g, and |l| ≤ η·s, η = 2^-25,
//! up to a relative 2^-28 (`super::split`). l also takes the rounding error of the difference. A
//! component of an area is (h h − h h) + (h l + l x − h l − l x). The first bracket is less than
//! 2^52 times its unit, so it is exact. It is cut again, at 26 bits, and the rest is at most η
//! times its size. The three products of its higher part with h sum to less than 3·2^51 + 2^30
//! units, so their sum H is exact as well. Only the rest, L, errs. `refined.g` proves its error.
//!
//! H + L is the number X plus its rounding error, without loss if |H| ≥ |L|. Otherwise X − H may be
//! rounded too. In all a volume errs by at most [`REFINED`]·u·η·D·E·R, with u the unit roundoff,
//! and w by at most 3·[`REFINED`].
//!
//! If all l are zero, nothing is lost. The part cut off an area is less than 2^25 + 3 units; L is a
//! sum of three products of that with h, and like H less than 2^53 units. X is zero only if H + L
//! is. det is a multiple of g³, with g of the edges twice, and u and v have no smaller unit,
//! because R ≥ E. The rounding errors added for w sum to less than 2^6·u·D·E·R ≤ 2^28·R/E units:
//! while R ≤ 2^20·E their sum is exact too.
//!
//! D, E and R are in range, so units of volumes are multiples of 2^-1038, which `f64` can
//! represent, and other underflow is below 2^-40 of the bound.

use super::Feature;
use super::counted::Crosses;
use super::crossing::{Crossing, Setting, Sizes, VolumeErrors};
use super::split::{CUT, FAR, Split, Two, short_areas};
use crate::arithmetic::{Embeds, Filtered, Number, two_difference};
use crate::scalar::Scalar;

/// Roundoffs, times [`CUT`], in the volumes in two parts.
const REFINED: u16 = 192;

/// Volumes, each as a rounded number and its rounding error.
pub(super) struct Refined {
    det: f64,
    t: f64,
    u: f64,
    v: f64,
    pub(super) low_det: f64,
    low_t: f64,
    pub(super) low_u: f64,
    pub(super) low_v: f64,
    /// The error bounds of t, and of the remaining volumes.
    t_error: f64,
    side_error: f64,
    /// Whether nothing was lost, in a determinant or in a sum of three.
    is_exact: bool,
}

/// A crossing that counts.
pub(super) struct Met {
    pub(super) feature: Feature,
    pub(super) det: f64,
    /// t, u and v, if any is zero.
    pub(super) quotients: Option<[f64; 3]>,
}

impl Refined {
    /// Computes two volumes at a time; the module's documentation explains the parts. Also returns
    /// whether the error bounds are valid.
    #[inline(always)]
    pub(super) fn new(points: &[[f64; 3]; 4], d: [f64; 3]) -> (Self, bool) {
        let Sizes { direction, edges: edge, size } = Setting::new(points, d).sizes();
        let is_known = direction.in_range() & edge.in_range() & size.in_range();
        let [a, b, c, o] = points;
        let way = |i: usize| two_difference(Two([d[i], o[i]]), Two([0.0, a[i]]));
        let side = |i: usize| two_difference(Two([c[i], b[i]]), Two([a[i], a[i]]));
        let split = |parts, far: [f64; 2]| Split::new(parts, Two(far) * Two([FAR; 2]));
        let ways = split([way(0), way(1), way(2)], [direction, size]);
        let edges = split([side(0), side(1), side(2)], [edge, edge]);
        let areas = Two([direction, size]) * Two([edge; 2]);
        let products = short_areas(ways.cross(&edges), areas * Two([FAR; 2]));
        let [Two([t, det]), Two([low_t, low_det])] = edges.dot(&products);
        let [Two([v, u]), Two([low_v, low_u])] = ways.dot(&products);
        let is_exact = (ways.lost() + edges.lost() == 0.0) & (size <= 1_048_576.0 * edge);
        let unit = if is_exact { 0.0 } else { CUT };
        let error = |area: f64, length: f64| (area * length).error(REFINED) * unit;
        let Two([area, far_area]) = areas;
        let (t_error, side_error) = (error(far_area, edge), error(area, size));
        let refined =
            Self { det, t, u, v, low_det, low_t, low_u, low_v, t_error, side_error, is_exact };
        (refined, is_known)
    }

    /// The crossing for the test of signs, and whether it is exact.
    #[inline(always)]
    pub(super) fn crossing(&self) -> (Crossing<f64>, bool) {
        let Self { det, t, u, v, .. } = *self;
        let [rest, first] = two_difference(det, u);
        let [rest, second] = two_difference(rest, v);
        let w = rest + (first + second + (self.low_det - self.low_u - self.low_v));
        let error_bound =
            VolumeErrors { side: self.side_error, sides: 3.0 * self.side_error, t: self.t_error };
        (Crossing { det, t, sides: [w, u, v], error_bound }, self.is_exact)
    }

    /// t, u and v within 1.1 roundings, if nothing was lost.
    #[inline(always)]
    fn quotients(&self) -> [f64; 3] {
        let inverse = 1.0 / self.det;
        let quotient = |high: f64, low: f64| {
            let first = high / self.det;
            first + (low - first * self.low_det) * inverse
        };
        [quotient(self.t, self.low_t), quotient(self.u, self.low_u), quotient(self.v, self.low_v)]
    }
}

impl<S: Scalar> Crosses<'_, S> {
    /// The hit, if the crossing counts; `None` in doubt.
    #[inline(always)]
    pub(super) fn refined_crossing(
        &self,
        points: &[[f64; 3]; 4],
        d: [f64; 3],
    ) -> Option<Option<Met>>
    where
        Filtered<f64>: Embeds<S>,
    {
        let (refined, is_known) = Refined::new(points, d);
        if !is_known {
            return None;
        }
        let (crossing, is_exact) = refined.crossing();
        if !crossing.meets(is_exact)? {
            return Some(None);
        }
        let counts = self.counts::<Filtered<f64>>(&Setting::new(points, d), &crossing, is_exact)?;
        let Crossing { det, t, sides: [_, u, v], .. } = crossing;
        let is_contact = is_exact & [t, u, v].contains(&0.0);
        let quotients = || is_contact.then(|| refined.quotients());
        Some(counts.then(|| Met { feature: crossing.feature(), det, quotients: quotients() }))
    }
}
