//! The crossing in `f64` in two parts, for signs in doubt.

use super::Feature;
use super::crossing::{Crossing, ErrorBound, Setting, Sizes};
use super::error_bound::{CUT, REFINED};
use super::question::Crosses;
use crate::arithmetic::{Embeds, FAR, Filtered, Number, Split, Two, short_areas, two_difference};
use crate::scalar::Scalar;

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
    /// Two volumes at a time: why the parts are what they are, `super::error_bound` tells.
    /// And whether it is known how far they are from the truth.
    #[inline(always)]
    pub(super) fn new(points: &[[f64; 3]; 4], d: [f64; 3]) -> (Self, bool) {
        let Sizes { direction, edges: edge, size } = Setting::new(points, d).sizes();
        let is_known = direction.in_range() & edge.in_range() & size.in_range();
        let [a, b, c, o] = points;
        let way = |i: usize| two_difference(Two([d[i], o[i]]), Two([0.0, a[i]]));
        let side = |i: usize| two_difference(Two([c[i], b[i]]), Two([a[i], a[i]]));
        let split = |[x, y, z]: [[Two; 2]; 3], far: [f64; 2]| {
            Split::new([x[0], y[0], z[0]], [x[1], y[1], z[1]], Two(far) * Two([FAR; 2]))
        };
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
