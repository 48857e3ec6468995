//! Triangle and axis-aligned box in lanes: the kernel in floats without branches, for many pairs at
//! once.
//!
//! All axes are measured from the first vertex, which takes the fewest steps for each box. On an
//! edge axis the first vertex either belongs to the edge, or is opposite to it and projects one
//! component of the normal away. The middle of the triangle's interval is half that component away,
//! on one of two sides. The bounds of `triangle_aabb` hold for either.

use crate::arithmetic::{
    Each, Filtered, FirstFloat, Float, InFloat, cross, dot, greatest, minus3, three,
    three_in_float, two_difference,
};
use crate::query::{bound_of_size, range};

/// The three points of a triangle.
type Points<S> = [[S; 3]; 3];

/// The values of a triangle that are the same for every box.
#[derive(Clone, Copy, Debug)]
pub(super) struct TriangleAxes<F> {
    /// The first vertex.
    origin: [F; 3],
    /// The least and the greatest coordinates of the vertices.
    low: [F; 3],
    high: [F; 3],
    /// The edges, each from a vertex to the next.
    edges: Points<F>,
    normal: [F; 3],
    /// Half the normal: on the axis of an edge, the distance from the first vertex's projection to
    /// the middle of the triangle's interval.
    middle: [F; 3],
    /// For each edge and coordinate axis, half the length of the triangle's interval.
    radii: Points<F>,
    /// Added to the box's radius on the normal.
    spare: F,
    /// Whether no coordinate was rounded when it became a float.
    are_held: bool,
}

/// The gaps between triangle and box: the greatest of the nine on edge axes, and the gap on the
/// normal; and their error bounds.
struct Gaps<F> {
    edges: F,
    plane: F,
    edges_error: F,
    plane_error: F,
}

impl<F: Float> Gaps<F> {
    /// Whether an axis separates, and whether that is certain. `face` says that a face separates,
    /// `no_face` that none does, and `is_known` that the error bounds are valid.
    #[inline(always)]
    fn verdict(&self, face: bool, no_face: bool, is_known: bool) -> (bool, bool) {
        let apart = (self.edges > self.edges_error) | (self.plane > self.plane_error);
        let none =
            self.edges.is_not_above(self.edges_error) & self.plane.is_not_above(self.plane_error);
        // The test of a face has no products, so its certainty does not depend on the size.
        (face | apart, face | is_known & (apart | none & no_face))
    }
}

impl<F: Float> TriangleAxes<F> {
    #[inline(always)]
    pub(super) fn new<S: InFloat<F>>([a, b, c]: Points<S>) -> Self {
        let points = &[three_in_float(a), three_in_float(b), three_in_float(c)];
        let [a, b, c] = points;
        let edges = [minus3(b, a), minus3(c, b), minus3(a, c)];
        let normal = cross::<Filtered<F>>(&edges[0], &edges[1]);
        let (x, y, z) = (range(points, 0), range(points, 1), range(points, 2));
        let (low, high) = ([x.0, y.0, z.0], [x.1, y.1, z.1]);
        // An axis parallel to a face normal, or zero, separates only if that face does, and so does
        // the normal of a triangle parallel to a coordinate plane. Their gaps are zero or nearly,
        // so a large radius moves them below zero beyond any error.
        let beyond_error = F::RANGE.1 * F::RANGE.1;
        let is_zero = |x: F| x == F::ZERO;
        let middle = [normal[0].half(), normal[1].half(), normal[2].half()];
        let mut radii = [[F::ZERO; 3]; 3];
        for k in 0..3 {
            for i in 0..3 {
                let (j, l) = ((i + 1) % 3, (i + 2) % 3);
                let is_none = is_zero(edges[k][j]) & is_zero(edges[k][l]);
                radii[k][i] = if is_none { beyond_error } else { middle[i].magnitude() };
            }
        }
        let is_flat = (low[0] == high[0]) | (low[1] == high[1]) | (low[2] == high[2]);
        let spare = if is_flat { beyond_error * F::RANGE.1 } else { F::ZERO };
        Self {
            origin: *a,
            low,
            high,
            edges,
            normal,
            middle,
            radii,
            spare,
            are_held: are_held::<S, F>(points),
        }
    }

    /// The greatest gap on the edge axes, with the first vertex at `v` in the frame of the box.
    #[inline(always)]
    fn edges(&self, v: &[F; 3], radius: impl Fn(usize, usize) -> F) -> F {
        let mut most = None;
        for k in 0..3 {
            for i in 0..3 {
                let (e, j, l) = (&self.edges[k], (i + 1) % 3, (i + 2) % 3);
                let (p, middle) = (e[j] * v[l] - e[l] * v[j], self.middle[i]);
                // The second edge does not contain the first vertex.
                let far = if k == 1 { p - middle } else { p + middle };
                let gap = far.magnitude() - radius(k, i);
                most = Some(most.map_or(gap, |most| greatest(most, gap)));
            }
        }
        most.unwrap_or(F::ZERO)
    }

    #[inline(always)]
    fn edge_radius(&self, half: &[F; 3], k: usize, i: usize) -> F {
        let (e, j, l) = (&self.edges[k], (i + 1) % 3, (i + 2) % 3);
        self.radii[k][i] + (e[l].magnitude() * half[j] + e[j].magnitude() * half[l])
    }

    #[inline(always)]
    fn plane_radius(&self, half: &[F; 3]) -> F {
        self.spare + dot::<Filtered<F>>(&self.normal.each(F::magnitude), half)
    }

    /// The error bounds of the gaps, and whether they are valid.
    #[inline(always)]
    fn errors(&self, half: &[F; 3]) -> ([F; 2], bool) {
        let span = |i: usize| half[i] + (self.high[i] - self.low[i]);
        let size = greatest(greatest(span(0), span(1)), span(2));
        let bound = bound_of_size::<Filtered<F>>(size);
        ([bound.edge, bound.plane], size.in_range())
    }

    #[inline(always)]
    fn gaps(&self, v: &[F; 3], half: &[F; 3], [edges_error, plane_error]: [F; 2]) -> Gaps<F> {
        Gaps {
            edges: self.edges(v, |k, i| self.edge_radius(half, k, i)),
            plane: dot::<Filtered<F>>(&self.normal, v).magnitude() - self.plane_radius(half),
            edges_error,
            plane_error,
        }
    }

    /// Whether an axis separates the triangle from the box with these corners, and whether that is
    /// certain.
    #[inline(always)]
    pub(super) fn apart_by_corners<S>(&self, min: [S; 3], max: [S; 3]) -> (bool, bool)
    where
        S: InFloat<F>,
    {
        let (min, max) = (three_in_float(min), three_in_float(max));
        let gap = |i: usize| greatest(self.low[i] - max[i], min[i] - self.high[i]);
        let face = greatest(greatest(gap(0), gap(1)), gap(2)) > F::ZERO;
        // Not v − (min + max)/2: rounding the sum errs by the distance from the origin, rounding
        // the differences only by the distance from the box.
        let v = three(|i| ((self.origin[i] - min[i]) + (self.origin[i] - max[i])).half());
        let half = three(|i| (max[i] - min[i]).half());
        let (errors, is_known) = self.errors(&half);
        let (is_apart, is_certain) = self.gaps(&v, &half, errors).verdict(face, !face, is_known);
        (is_apart, is_certain & self.are_held & are_held::<S, F>(&[min, max]))
    }

    /// The same for a box with this centre and these half-extents.
    #[inline(always)]
    pub(super) fn apart_by_center<S>(&self, center: [S; 3], half: [S; 3]) -> (bool, bool)
    where
        S: InFloat<F>,
    {
        let (center, half) = (three_in_float(center), three_in_float(half));
        // A computed gap of zero may be rounded. The sign of any other is right, because rounding
        // is monotonic.
        let gap = |i: usize| greatest(self.low[i] - center[i], center[i] - self.high[i]) - half[i];
        let gap = greatest(greatest(gap(0), gap(1)), gap(2));
        let (face, no_face) = (gap > F::ZERO, gap < F::ZERO);
        let (errors, is_known) = self.errors(&half);
        let gaps = self.gaps(&minus3(&self.origin, &center), &half, errors);
        let (is_apart, is_certain) = gaps.verdict(face, no_face, is_known);
        (is_apart, is_certain & self.are_held & are_held::<S, F>(&[center, half]))
    }
}

/// Whether all coordinates became floats without rounding.
#[inline(always)]
fn are_held<S: InFloat<F>, F: Float>(points: &[[F; 3]]) -> bool {
    let Some(limit) = S::LIMIT else { return true };
    let mut are_held = true;
    for p in points {
        let most = greatest(greatest(p[0].magnitude(), p[1].magnitude()), p[2].magnitude());
        are_held &= most < limit;
    }
    are_held
}

/// Whether lanes are in the first float of the scalar, which holds these points, and not in the second.
#[inline(always)]
pub(super) fn is_for_first<S: FirstFloat>(points: &[[S; 3]]) -> bool {
    size_of::<S::SeptumFirst>() == size_of::<S::SeptumSecond>()
        || points.iter().all(|p| are_held::<S, S::SeptumFirst>(&[three_in_float(*p)]))
}

/// A triangle against boxes of one size, by their centres.
#[derive(Clone, Copy, Debug)]
pub(super) struct OfOneSize<F> {
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
    pub(super) fn new<S: InFloat<F>>(points: [[S; 3]; 3], half: [S; 3]) -> Option<Self> {
        let (axes, half) = (TriangleAxes::new(points), three_in_float(half));
        let (errors, is_known) = axes.errors(&half);
        if !is_known | !axes.are_held | !are_held::<S, F>(&[half]) {
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
    pub(super) fn apart<S: InFloat<F>>(&self, center: [S; 3]) -> (bool, bool) {
        let center = three_in_float(center);
        let [low, high] = &self.reach;
        let gap = |i: usize| greatest(low[i] - center[i], center[i] - high[i]);
        let gap = greatest(greatest(gap(0), gap(1)), gap(2));
        let v = minus3(&self.axes.origin, &center);
        let gaps = Gaps {
            edges: self.axes.edges(&v, |k, i| self.radii[k][i]),
            plane: dot::<Filtered<F>>(&self.axes.normal, &v).magnitude() - self.plane_radius,
            edges_error: self.errors[0],
            plane_error: self.errors[1],
        };
        let (face, no_face) = (gap > self.reach_error, gap.is_not_above(self.reach_error));
        let (is_apart, is_certain) = gaps.verdict(face, no_face, true);
        (is_apart, is_certain & are_held::<S, F>(&[center]))
    }
}
