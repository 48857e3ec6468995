//! Capsule against triangle.
//!
//! The normal n of the triangle serves both ends of the segment:
//! - If both lie farther than the radius from the plane and on one side, so does the segment. If they
//!   lie on different sides, and the line through them passes all edges on one side, they meet.
//! - If both lie inside of an edge, by n·(e × d) > 0, no point between the ends of that edge is nearest
//!   to the segment, and the edge is not asked.

use super::{Between, all_beyond};
#[cfg(feature = "fixed")]
use crate::arithmetic::Int16;
use crate::arithmetic::{Arithmetic, Embeds, Number, greatest, pick, three, two};
use crate::query::orientation::{Vector, from};
use crate::query::segment_triangle::Passes;
use crate::query::sphere::{Ball, Beyond, Errors, Reach, around, largest_of, minors, volume};
use crate::robust::{Predicate, Uncertain, certain_sign};
use crate::scalar::Scalar;
#[cfg(feature = "fixed")]
use crate::shape::Near;
use crate::shape::{Capsule, Overlaps, Triangle};

impl<N: Arithmetic> Between<N> {
    /// A segment along `e` and edge `k` of a triangle, with vectors from the vertices to both ends.
    #[inline(always)]
    fn to_edge(to: [&[Vector<N>; 3]; 2], edges: &[Vector<N>; 3], e: &Vector<N>, k: usize) -> Self {
        // The ends by name: an index into `to` may keep a check where this is not inlined.
        let [a, b] = to;
        let ends = |to: &[Vector<N>; 3]| two(|end| three(|i| -pick(to, (k + end) % 3)[i]));
        Self { ends: [ends(a), ends(b)], along: [*e, *pick(edges, k)] }
    }
}

/// Whether the ends of a segment along `e` lie farther from a triangle than the radius, and the
/// segment from its edges; with vectors from the vertices to both ends. `Some(false)` also if the
/// segment certainly passes through the triangle. The vectors err as `Reach::excludes` says.
#[inline(always)]
pub(in crate::query) fn triangle_lies_beyond<N: Arithmetic>(
    reach: &Reach<N>,
    to: [&[Vector<N>; 3]; 2],
    edges: &[Vector<N>; 3],
    e: &Vector<N>,
    slack: N::Length,
) -> Option<bool> {
    if N::LARGE {
        // Each part computes a normal of its own: a common one would make the stack deeper.
        return all_beyond((0..5).map(|k| match k {
            0 => excludes_triangle(reach, to[0], edges, slack),
            1 => excludes_triangle(reach, to[1], edges, slack),
            _ => Between::to_edge(to, edges, e, k - 2).is_beyond(reach, slack),
        }));
    }
    let of_ends = greatest(largest_of::<N, 3>(to[0]), largest_of::<N, 3>(to[1]));
    let of_edges = greatest(largest_of::<N, 3>(edges), largest_of::<N, 1>(&[*e]));
    let size = greatest(greatest(of_ends, of_edges), slack);
    if N::is_narrow(greatest(size, reach.radius)) {
        are_beyond::<N::Narrow>(&reach.narrow(), to, edges, e, [size, slack])
    } else {
        are_beyond(reach, to, edges, e, [size, slack])
    }
}

#[inline(never)]
fn excludes_triangle<N: Arithmetic>(
    reach: &Reach<N>,
    vectors: &[Vector<N>; 3],
    edges: &[Vector<N>; 3],
    slack: N::Length,
) -> Option<bool> {
    reach.excludes_face(vectors, edges, slack)
}

#[inline(always)]
fn are_beyond<N: Arithmetic>(
    reach: &Reach<N>,
    to: [&[Vector<N>; 3]; 2],
    edges: &[Vector<N>; 3],
    e: &Vector<N>,
    [size, slack]: [N::Length; 2],
) -> Option<bool> {
    let errors = Errors::<N>::new(size, reach.radius)?;
    let n = minors::<N>(&edges[0], &edges[1]);
    let by_plane = match by_plane(reach, &n, to, edges, e, &errors) {
        Ok(by_plane) => by_plane,
        Err(answer) => return Some(answer),
    };
    let sizes = [size, slack];
    let (at_start, start_inside) = excludes_near(reach, &n, by_plane[0], to[0], edges, sizes);
    if at_start == Some(false) {
        return at_start;
    }
    let (at_end, end_inside) = excludes_near(reach, &n, by_plane[1], to[1], edges, sizes);
    if at_end == Some(false) {
        return at_end;
    }
    let of_edges = all_beyond((0..3).map(|k| {
        if (start_inside & end_inside) >> k & 1 == 1 {
            return Some(true);
        }
        excludes_edge(reach, to, edges, e, k, sizes)
    }));
    let of_ends = Uncertain::of(at_start).and(Uncertain::of(at_end));
    of_ends.and(Uncertain::of(of_edges)).verdict()
}

/// Whether the plane alone keeps each end beyond; `Err` if the plane answers for the whole segment.
#[inline(always)]
fn by_plane<N: Arithmetic>(
    reach: &Reach<N>,
    n: &[N::Area; 3],
    to: [&[Vector<N>; 3]; 2],
    edges: &[Vector<N>; 3],
    e: &Vector<N>,
    errors: &Errors<N>,
) -> Result<[Uncertain; 2], bool> {
    let heights = [volume::<N>(n, &to[0][0]), volume::<N>(n, &to[1][0])];
    let by_plane = reach.excludes_planes(n, heights, errors);
    if by_plane[0].certain && by_plane[1].certain {
        // Both signs are certain: a square exceeds its error only if the height exceeds its own.
        if heights[0].is_positive() == heights[1].is_positive() {
            return Err(true);
        }
        // On which side the line passes each edge.
        let sides = three(|k| {
            let n = minors::<N>(e, &edges[k]);
            certain_sign(volume::<N>(&n, &to[0][k]), errors.volume)
        });
        if sides == [1; 3] || sides == [-1; 3] {
            return Err(false);
        }
    }
    Ok(by_plane)
}

/// Whether a triangle lies beyond, given what its plane says; and a bit for each edge that the point
/// is certainly inside of, if that was asked. Out of line, because both ends ask it.
#[inline(never)]
fn excludes_near<N: Arithmetic>(
    reach: &Reach<N>,
    n: &[N::Area; 3],
    by_plane: Uncertain,
    vectors: &[Vector<N>; 3],
    edges: &[Vector<N>; 3],
    [size, slack]: [N::Length; 2],
) -> (Option<bool>, u8) {
    if by_plane.certain || slack == N::Length::ZERO && reach.is_beyond(vectors) {
        return (Some(true), 0);
    }
    match Errors::<N>::new(size, reach.radius) {
        Some(errors) => reach.excludes_point_near(n, by_plane, vectors, edges, slack, &errors),
        None => (None, 0),
    }
}

/// Whether edge `k` lies beyond from the segment. Out of line, because three edges ask it.
#[inline(never)]
fn excludes_edge<N: Arithmetic>(
    reach: &Reach<N>,
    to: [&[Vector<N>; 3]; 2],
    edges: &[Vector<N>; 3],
    e: &Vector<N>,
    k: usize,
    sizes: [N::Length; 2],
) -> Option<bool> {
    Between::to_edge(to, edges, e, k).is_beyond_by(reach, sizes)
}

impl<S: Scalar> Predicate<S> for Beyond<'_, Capsule<S>, Triangle<S>> {
    type Answer = bool;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<bool> {
        let ([a, b], [p, q, r]) = (self.ends(), self.shape.points());
        let [a, b, p, q, r, [radius, ..]] = N::embed(&[a, b, p, q, r, [self.round.radius(); 3]])?;
        let reach = Reach::<N>::new(radius, self.ball);
        // Vectors to the ends of the segment.
        let [to_a, edges] = around::<N>(&a, &[p, q, r]);
        let [to_b, _] = around::<N>(&b, &[p, q, r]);
        let [[u, v, w], [x, y, z]] = [to_a, to_b];
        if reach.is_beyond(&[u, v, w, x, y, z]) {
            return Some(true);
        }
        let e = from::<N>(&b, &a);
        triangle_lies_beyond(&reach, [&to_a, &to_b], &edges, &e, N::Length::ZERO)
    }
}

/// The question whether a capsule's segment passes through a triangle, if it is beyond all else.
#[inline(always)]
fn passes<'a, S: Scalar>(capsule: &Capsule<S>, triangle: &'a Triangle<S>) -> Passes<'a, S> {
    let (a, b) = capsule.ends();
    Passes { ends: [a.to_array(), b.to_array()], triangle }
}

/// Whether the triangle meets the capsule, or its points nearer than the radius.
#[inline(always)]
pub(super) fn meets_triangle<S: Scalar>(
    capsule: &Capsule<S>,
    triangle: &Triangle<S>,
    ball: Ball,
) -> bool {
    // Not by `meet`, which takes more flash on a Cortex-M0.
    !S::evaluate_numeric(&Beyond { round: capsule, shape: triangle, ball })
        || S::evaluate(&passes(capsule, triangle))
}

impl<S: Scalar> Overlaps<Triangle<S>> for Capsule<S> {
    /// Do a capsule and a triangle have a point in common?
    ///
    /// *Geometry*: closed sets in one frame and unit. The radius may be zero, the ends of the
    /// capsule may coincide, the triangle may be a segment or a point.
    ///
    /// *Contact*: touching is overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar. A squared distance is compared with
    /// the square of the radius, in products of up to six lengths.
    ///
    /// *Range*: all finite floats, all fixed-point values; 64-bit fixed point beyond 2⁶⁰ units in
    /// the last place takes wider integers. In floats, distances within rounding of the radius take
    /// exact integers.
    ///
    /// *Panics*: never. *Cost*: 12 comparisons if a coordinate separates, 18 multiplications if the
    /// plane does. Otherwise two
    /// [spheres](crate::Sphere#impl-Overlaps<Triangle<S>>-for-Sphere<S>) at the ends, a
    /// [segment](Capsule#impl-Overlaps<Segment<S>>-for-Capsule<S>) for each edge that an end lies
    /// outside of, and a
    /// [segment and a triangle](crate::Segment#impl-Overlaps<Triangle<S>>-for-Segment<S>), until one
    /// answers.
    ///
    /// ```
    /// use septum::{Capsule, Triangle};
    ///
    /// let t = Triangle::new([0.0_f32, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0])?;
    /// let across_edge = Capsule::new([2.0, -3.0, 3.0], [2.0, -4.0, 5.0], 4.2426405)?;
    /// assert!(!across_edge.overlaps(&t)); // the radius is just below √18
    /// let across_edge = Capsule::new([2.0, -3.0, 3.0], [2.0, -4.0, 5.0], 4.242641)?;
    /// assert!(across_edge.overlaps(&t));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[inline]
    fn overlaps(&self, triangle: &Triangle<S>) -> bool {
        meets_triangle(self, triangle, Ball::Closed)
    }
}

#[cfg(feature = "fixed")]
impl<S: Scalar> Overlaps<Near<Capsule<S>>> for Near<Triangle<S>>
where
    Int16: Embeds<S>,
{
    /// Do a triangle and a capsule near the origin have a point in common?
    ///
    /// *Numerics*: exact, in integers of up to 128 bits. *Panics*: never.
    #[inline]
    fn overlaps(&self, capsule: &Near<Capsule<S>>) -> bool {
        let (capsule, shape) = (capsule.get(), self.get());
        Beyond { round: capsule, shape, ball: Ball::Closed }.filter::<Int16>() != Some(true)
            || passes(capsule, shape).filter::<Int16>() == Some(true)
    }
}
