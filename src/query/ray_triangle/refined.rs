//! The crossing in `f64` in two parts: for numbers good to the last place, and signs in
//! doubt.

use super::Feature;
use super::crossing::{Crossing, ErrorBound, Setting, Sizes};
use super::error_bound::{REFINED, REFINED_UNIT};
use super::question::Crosses;
use crate::arithmetic::{Embeds, FAR, Filtered, Number, Split, Two, short_areas, two_difference};
use crate::scalar::Scalar;

/// Volumes, each as it is rounded, and what the rounding took.
pub(super) struct Refined {
    pub(super) det: f64,
    t: f64,
    u: f64,
    v: f64,
    pub(super) low_det: f64,
    pub(super) low_t: f64,
    pub(super) low_u: f64,
    pub(super) low_v: f64,
    /// How far t, u and v, and the determinant may be from the truth.
    t_error: f64,
    side_error: f64,
    pub(super) det_error: f64,
    /// Whether nothing was lost, neither in a determinant nor in a sum of three.
    is_exact: bool,
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
        let unit = if is_exact { 0.0 } else { REFINED_UNIT };
        let error = |area: f64, length: f64| (area * length).error(REFINED) * unit;
        let Two([area, far_area]) = areas;
        let (t_error, side_error) = (error(far_area, edge), error(area, size));
        let det_error = error(area, edge);
        let refined = Self {
            det,
            t,
            u,
            v,
            low_det,
            low_t,
            low_u,
            low_v,
            t_error,
            side_error,
            det_error,
            is_exact,
        };
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

    /// t, u and v, and how far each may be from the truth but for 1.1 roundings.
    #[inline(always)]
    fn quotients(&self) -> [(f64, f64); 3] {
        let inverse = 1.0 / self.det;
        let quotient = |high: f64, low: f64, error: f64| {
            let first = high / self.det;
            let corrected = first + (low - first * self.low_det) * inverse;
            // An infinity less an infinity.
            let quotient = if corrected.is_nan() { first } else { corrected };
            (quotient, (error + first.magnitude() * self.det_error) * inverse.magnitude())
        };
        [
            quotient(self.t, self.low_t, self.t_error),
            quotient(self.u, self.low_u, self.side_error),
            quotient(self.v, self.low_v, self.side_error),
        ]
    }

    /// t, u and v, each within 2 ulp in `f64`, and as the last stages would round it in
    /// `f32`, if the second says so.
    #[inline(always)]
    pub(super) fn numbers<S: Scalar>(&self) -> ([S; 3], bool)
    where
        Filtered<f64>: Embeds<S>,
    {
        let rounded = |x: f64| Filtered::<f64>::quotient_of_lengths(x, 1.0);
        // Seen at compile time.
        let is_f64 = S::FLOAT.is_some_and(|format| {
            let [[roundoff, ..]] = Filtered::<f64>::embed_held(&[[format.roundoff; 3]]);
            roundoff == f64::EPSILON / 2.0
        });
        let is_good = |(x, error): (f64, f64)| {
            if is_f64 {
                return error <= x.magnitude() * (f64::EPSILON / 4.0);
            }
            // 2^-50 for the roundings, and for those of the last stages.
            let doubt = 1.25 * error + x.magnitude() * (4.0 * f64::EPSILON);
            rounded(x - doubt) == rounded(x + doubt)
        };
        let [t, u, v] = self.quotients();
        let are_good = is_good(t) & is_good(u) & is_good(v) & (1.0 / self.det).is_finite();
        ([rounded(t.0), rounded(u.0), rounded(v.0)], are_good)
    }
}

impl<S: Scalar> Crosses<'_, S> {
    /// The crossing in `f64` in two parts.
    #[inline(always)]
    pub(super) fn refined_crossing(&self) -> Option<Refined>
    where
        Filtered<f64>: Embeds<S>,
    {
        let [a, b, c] = self.triangle.points();
        let (o, d) = (self.ray.origin().to_array(), self.ray.direction().to_array());
        let [a, b, c, o, d] = Filtered::<f64>::embed(&[a, b, c, o, d])?;
        let (refined, is_known) = Refined::new(&[a, b, c, o], d);
        is_known.then_some(refined)
    }

    /// What of the triangle is met, if the crossing counts; `None` in doubt.
    #[inline(always)]
    pub(super) fn refined_verdict(&self, refined: &Refined) -> Option<Option<Feature>>
    where
        Filtered<f64>: Embeds<S>,
    {
        let (crossing, is_exact) = refined.crossing();
        if !crossing.meets(is_exact)? {
            return Some(None);
        }
        let setting = self.setting::<Filtered<f64>>()?;
        let counts = self.counts::<Filtered<f64>>(&setting, &crossing, is_exact)?;
        Some(counts.then(|| crossing.feature()))
    }
}
