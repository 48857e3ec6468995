//! One triangle against axis-aligned boxes of one size: values that do not depend on the box's
//! place are computed once.

use super::clear::{Gaps, TriangleAxes, are_held, first, minus};
use crate::arithmetic::{Filtered, FirstFloat, Float, dot, greatest, two_difference};

/// A triangle against boxes of one size, by their centres.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OfOneSize<F> {
    axes: TriangleAxes<F>,
    radii: [[F; 3]; 3],
    plane_radius: F,
    errors: [F; 2],
    /// The planes between which the centre lies if no face separates, and their error.
    reach: [[F; 3]; 2],
    reach_error: F,
}

impl<F: Float> OfOneSize<F> {
    /// `None` if the error bounds of floats do not apply.
    #[inline(always)]
    pub(crate) fn new<S: FirstFloat<SeptumFirst = F>>(
        points: [[S; 3]; 3],
        half: [S; 3],
    ) -> Option<Self> {
        let (axes, half) = (TriangleAxes::new(points), first(half));
        let (errors, is_known) = axes.errors(&half);
        if !is_known | !axes.are_held | !are_held::<S>(&[half]) {
            return None;
        }
        let mut radii = axes.radii;
        let (mut reach, mut reach_error) = ([half; 2], F::ZERO);
        for i in 0..3 {
            for k in 0..3 {
                radii[k][i] = axes.edge_radius(&half, k, i);
            }
            let [low, low_lost] = two_difference(axes.low[i], half[i]);
            let [high, high_lost] = two_difference(axes.high[i], -half[i]);
            (reach[0][i], reach[1][i]) = (low, high);
            let lost = greatest(low_lost.magnitude(), high_lost.magnitude());
            reach_error = greatest(reach_error, lost);
        }
        let plane_radius = axes.plane_radius(&half);
        // Doubled, to allow for the rounding of the number that is compared with it.
        let reach_error = reach_error + reach_error;
        Some(Self { axes, radii, plane_radius, errors, reach, reach_error })
    }

    /// Whether an axis separates the triangle from the box with this centre, and whether that is
    /// certain.
    #[inline(always)]
    pub(crate) fn apart<S: FirstFloat<SeptumFirst = F>>(&self, center: [S; 3]) -> (bool, bool) {
        let center = first(center);
        let [low, high] = &self.reach;
        let gap = |i: usize| greatest(low[i] - center[i], center[i] - high[i]);
        let gap = greatest(greatest(gap(0), gap(1)), gap(2));
        let v = minus(&self.axes.origin, &center);
        let gaps = Gaps {
            edges: self.axes.edges(&v, |k, i| self.radii[k][i]),
            plane: dot::<Filtered<F>>(&self.axes.normal, &v).magnitude() - self.plane_radius,
            edges_error: self.errors[0],
            plane_error: self.errors[1],
        };
        let (face, no_face) = (gap > self.reach_error, gap.is_not_above(self.reach_error));
        let (is_apart, is_certain) = gaps.verdict(face, no_face, true);
        (is_apart, is_certain & are_held::<S>(&[center]))
    }
}
