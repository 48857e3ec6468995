//! The crossing in `f64` in two parts, for signs in doubt.
//!
//! How far it is from the truth, with D, E and R as in `super::error_bound`: a component x of a
//! vector of size s, one of these, is cut at a grid: x = h + l, with h a multiple of g, |h| ≤ (1 +
//! 2^25)·g, and |l| ≤ η·s, η = 2^-25, but for a trifle of 2^-28 (`super::split`). l takes the
//! error of the difference along. A component of an area is (h h − h h) + (h l + l x − h l − l x).
//! The first bracket comes to less than 2^52 times its unit, so it is exact. It is cut again: at 26
//! bits, and the rest is at most η times its size. The three products of its higher part with h
//! come to less than 3·2^51 + 2^30 units together, so their sum, H, is exact as well. What errs is
//! L, the rest. In units of u·η·D·E·R, u the unit roundoff:
//!
//! * l: 1. h·l + l·x: 2 for l, 1 for x, 2 products, 2 for the sum, of at most 2 η: 7. The
//!   difference of two, of at most 4 η: 18. With what was cut off, 5 η: m, 23.
//! * m·x: 23, 5 for x, 5 for the product. h·l, with h ≤ 2: 2 and 2. Their sum, of at most
//!   7 η: 44. Three of them: 132, and their sums, of at most 14 η and 21 η: 167.
//! * H + L is X and what its rounding took, without loss if |H| ≥ |L|. If not, X − H may be
//!   rounded, and 21 is lost: 188. [`REFINED`] = 192. So w errs by at most 3·188 and some
//!   roundings of u·u, of 3·192.
//!
//! `refined.g` proves what L may err.
//!
//! Nothing is lost where all l are zero. What was cut off an area is less than 2^25 + 3
//! units, L a sum of three products of that with h, and like H less than 2^53 units. X is
//! zero only if H + L is. det is a multiple of g³, taking g of the edges twice, u and v of
//! no less, for R ≥ E. The roundings that are added for w come to less than
//! 2^6·u·D·E·R ≤ 2^28·R/E units: while R ≤ 2^20·E their sum is exact too.
//!
//! D, E and R are in range: units of volumes are multiples of 2^-1038, which `f64` holds,
//! and what underflows besides is below 2^-40 of the bound.

use super::Feature;
use super::counted::Crosses;
use super::crossing::{Crossing, ErrorBound, Setting, Sizes};
use super::split::{CUT, FAR, Split, Two, short_areas};
use crate::arithmetic::{Embeds, Filtered, Number, two_difference};
use crate::scalar::Scalar;

/// Roundoffs, times [`CUT`], in the volumes in two parts.
const REFINED: u16 = 192;

/// Volumes, each as it is rounded, and what the rounding took.
pub(super) struct Refined {
    det: f64,
    t: f64,
    u: f64,
    v: f64,
    pub(super) low_det: f64,
    low_t: f64,
    pub(super) low_u: f64,
    pub(super) low_v: f64,
    /// How far t, and the others may be from the truth.
    t_error: f64,
    side_error: f64,
    /// Whether nothing was lost, neither in a determinant nor in a sum of three.
    is_exact: bool,
}

/// A crossing that counts.
pub(super) struct Met {
    pub(super) feature: Feature,
    pub(super) det: f64,
    /// t, u and v, if one of them is zero.
    pub(super) quotients: Option<[f64; 3]>,
}

impl Refined {
    /// Two volumes at a time: why the parts are what they are, the module tells.
    /// And whether it is known how far they are from the truth.
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

    /// What signs are taken from, and whether it is exact.
    #[inline(always)]
    pub(super) fn crossing(&self) -> (Crossing<f64>, bool) {
        let Self { det, t, u, v, .. } = *self;
        let [rest, first] = two_difference(det, u);
        let [rest, second] = two_difference(rest, v);
        let w = rest + (first + second + (self.low_det - self.low_u - self.low_v));
        let error_bound =
            ErrorBound { side: self.side_error, sides: 3.0 * self.side_error, t: self.t_error };
        (Crossing { det, t, sides: [w, u, v], error_bound }, self.is_exact)
    }

    /// t, u and v where nothing was lost, but for 1.1 roundings.
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
    /// What is met, if the crossing counts; `None` in doubt.
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
