//! Polygon against axis-aligned box: the triangles of the fan, and tests that avoid most triangles.
//!
//! D. Green, D. Hatch, "Fast Polygon-Cube Intersection Testing", *Graphics Gems V*, 1995, test
//! outcodes, then edges, then a diagonal of the box against the polygon. Here the outcodes of the
//! faces and the plane are tested for all vertices first, in floats, with x, y and z of a vertex side
//! by side (`survey`). The triangles follow, each
//! exactly, beginning with the triangle onto which the centre of the box projects.
//!
//! There is no `Relate` for this pair. A flat box may lie along a diagonal that two triangles of
//! the fan share, and a bent fan has no clear interior.

use super::Overlaps;
use crate::arithmetic::{Arithmetic, Filtered, FirstFloat, Float, Number, OfFour, Quad, THREE};
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Polygon, Vec3};

impl<S: Scalar> Overlaps<Aabb<S>> for Polygon<'_, S> {
    /// Do a polygon and an axis-aligned box have a point in common?
    ///
    /// *Geometry*: closed sets in one frame and unit. The polygon is the fan of its
    /// [`triangles`](Polygon::triangles), which equals the polygon if it is convex and planar. Its
    /// vertices may coincide or lie on one line. The box may be flat or a point.
    ///
    /// *Contact*: touching is overlap.
    ///
    /// *Numerics*: exact for every valid input, in every scalar. A polygon of three vertices gets
    /// the answer of the triangle.
    ///
    /// *Range*: as for [triangle and box](crate::Triangle#impl-Overlaps<Aabb<S>>-for-Triangle<S>).
    ///
    /// *Panics*: never.
    ///
    /// *Cost*: on machines with vectors, 6 comparisons a vertex find a vertex in the box or a
    /// separating face; 9 multiplications and 3 a vertex test the plane; 3 a vertex choose the
    /// triangle to test first. If the polygon meets the box, usually no further triangle is tested.
    /// Without vectors, and for polygons that only a slanted axis separates, every triangle is
    /// tested.
    ///
    /// *Source*: outcodes are by Voorhies 1992; Green and Hatch 1995 test them first. The fan and
    /// its order are ours. The method as published is
    /// [`green_hatch`](crate::published::green_hatch::overlaps).
    ///
    /// ```
    /// use septum::polygon::Polygon;
    /// use septum::{Aabb, Vec3};
    ///
    /// let roof = [[0.0, 0.0, 2.0], [4.0, 0.0, 2.0], [4.0, 2.0, 4.0], [0.0, 2.0, 4.0]];
    /// let roof = roof.map(Vec3::from);
    /// let cell = Aabb::from_min_max([1.0, 1.0, 1.0], [2.0, 2.0, 3.0])?;
    /// assert!(Polygon::new(&roof)?.overlaps(&cell)); // along an edge of the cell
    ///
    /// let higher = roof.map(|v| Vec3::new(v.x, v.y, v.z + 4.0 * f64::EPSILON));
    /// assert!(!Polygon::new(&higher)?.overlaps(&cell));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    fn overlaps(&self, aabb: &Aabb<S>) -> bool {
        let mut first = 1;
        // A triangle has a faster test of its own.
        if S::IN_QUADS && self.vertices().len() > 3 {
            match survey(self.vertices(), aabb) {
                Survey::Meets => return true,
                Survey::Apart => return false,
                Survey::AskFirst(k) => first = k,
            }
        }
        let mut in_turn = self.triangles().skip(first - 1).chain(self.triangles().take(first - 1));
        in_turn.any(|triangle| triangle.overlaps(aabb))
    }
}

// The error of the computed distance between the plane of three vertices of a polygon and a corner
// of the box, seen from any vertex of the polygon, in units of u·R³.
//
// R is the greatest sum, over the axes, of the half-extent of the box and the extent of the
// polygon. If no face separates, every vertex is within R of the centre of the box, and no edge is
// longer than the extent. The steps and their operands are those of `triangle_aabb::error_bound`.
// `error_bound.g` proves [`PLANE`].

/// Roundoffs in the distance.
const PLANE: u16 = 64;

/// The bound for shapes of this size; `None` if the size is out of range.
#[inline(always)]
fn error_bound<N: Arithmetic>(size: N::Length) -> Option<N::Volume> {
    size.in_range().then(|| N::volume(N::area(size, size), size).error(PLANE))
}

type First<S> = <S as FirstFloat>::SeptumFirst;
type Row<S> = <First<S> as OfFour>::Quad;

/// The result of the first look.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Survey {
    /// A vertex lies in the box.
    Meets,
    /// A face of the box separates, or the plane of the polygon.
    Apart,
    /// No certain answer. If any triangle meets the box, it is probably the triangle of vertices 0,
    /// k and k + 1.
    AskFirst(usize),
}

/// Looks at all vertices; there are four or more.
#[inline(never)]
fn survey<S: Scalar>(vertices: &[Vec3<S>], aabb: &Aabb<S>) -> Survey {
    // Rounding is monotonic: the sign of a rounded difference is right, unless it is zero.
    match aabb.form() {
        AabbForm::Center { center, half } => {
            let (center, half) = (row::<S>(center), row::<S>(half));
            Codes {
                of_box: [center, half],
                is_inside: |v: Row<S>| half.exceeds((v - center).magnitude()) & THREE == THREE,
                is_beyond: |low: Row<S>, high: Row<S>| {
                    ((low - center).exceeds(half) | (center - high).exceeds(half)) & THREE != 0
                },
                from_center: |v| v - center,
                half,
            }
            .survey(vertices)
        }
        AabbForm::Corners { min, max } => {
            let (min, max) = (row::<S>(min), row::<S>(max));
            Codes {
                of_box: [min, max],
                is_inside: |v: Row<S>| (v.exceeds(max) | min.exceeds(v)) & THREE == 0,
                is_beyond: |low: Row<S>, high: Row<S>| {
                    (low.exceeds(max) | min.exceeds(high)) & THREE != 0
                },
                from_center: |v: Row<S>| ((v - min) + (v - max)).halved(),
                half: (max - min).halved(),
            }
            .survey(vertices)
        }
    }
}

/// The tests of a box in one of its forms.
struct Codes<Q, I, B, F> {
    /// The two vectors that the box is given by.
    of_box: [Q; 2],
    /// Whether a point is certainly in the box.
    is_inside: I,
    /// Whether everything between two corners is certainly beyond a face.
    is_beyond: B,
    /// Moves a point to the box's frame.
    from_center: F,
    half: Q,
}

impl<Q, I, B, F> Codes<Q, I, B, F>
where
    Q: Quad<Lane: Float>,
    I: Fn(Q) -> bool,
    B: Fn(Q, Q) -> bool,
    F: Fn(Q) -> Q,
{
    #[inline(always)]
    fn survey<S: Scalar<SeptumFirst = Q::Lane>>(&self, vertices: &[Vec3<S>]) -> Survey
    where
        First<S>: OfFour<Quad = Q>,
    {
        let first = row::<S>(&vertices[0]);
        let (mut low, mut high, mut is_any_inside) = (first, first, false);
        for v in vertices {
            let v = row::<S>(v);
            (low, high) = (low.least(v), high.greatest(v));
            is_any_inside |= (self.is_inside)(v);
        }
        let most = low.magnitude().greatest(high.magnitude());
        let most = most.greatest(self.of_box[0].magnitude()).greatest(self.of_box[1].magnitude());
        let are_held =
            S::FIRST_LIMIT.is_none_or(|limit| Q::splat(limit).exceeds(most) & THREE == THREE);
        if !are_held {
            return Survey::AskFirst(1);
        }
        if is_any_inside {
            return Survey::Meets;
        }
        if (self.is_beyond)(low, high) {
            return Survey::Apart;
        }
        self.by_plane::<S>(vertices, (self.half + (high - low)).most())
    }

    /// Whether the plane of three vertices separates. If not, finds the triangle of the fan nearest
    /// to the centre of the box.
    #[inline(always)]
    fn by_plane<S: Scalar<SeptumFirst = Q::Lane>>(
        &self,
        vertices: &[Vec3<S>],
        size: First<S>,
    ) -> Survey
    where
        First<S>: OfFour<Quad = Q>,
    {
        let Some(bound) = error_bound::<Filtered<First<S>>>(size) else {
            return Survey::AskFirst(1);
        };
        let (zero, count) = (First::<S>::ZERO, vertices.len());
        let at = |k: usize| row::<S>(&vertices[k]);
        // Three vertices far from each other, because the first three may lie on one line.
        let (a, b, c) = (at(0), at(count / 3), at(2 * count / 3));
        let n = cross(b - a, c - b);
        let radius = n.magnitude().dot(self.half);
        let a_from_center = (self.from_center)(a);
        let distance = n.dot(a_from_center);
        if distance.magnitude() - radius > bound {
            let n = if distance > zero { n } else { Q::splat(zero) - n };
            let is_beyond = |v| n.dot((self.from_center)(row::<S>(v))) - radius > bound;
            if vertices.iter().all(is_beyond) {
                return Survey::Apart;
            }
        }

        // Seen along n, the line from vertex 0 to vertex k + 1 passes the centre on its right: n·(e
        // × o) = e·(o × n), with o the vector to the centre. No verdict depends on this.
        let across = cross(n, a_from_center);
        let start = across.dot(a);
        let passes = |&k: &usize| across.dot(at(k + 1)) <= start;
        Survey::AskFirst((1..count - 2).find(passes).unwrap_or(count - 2))
    }
}

#[inline(always)]
fn row<S: FirstFloat<SeptumFirst: OfFour>>(v: &Vec3<S>) -> Row<S> {
    Quad::of_three([v.x.first(), v.y.first(), v.z.first()])
}

#[inline(always)]
fn cross<Q: Quad>(a: Q, b: Q) -> Q {
    (a * b.turned() - a.turned() * b).turned()
}

#[cfg(test)]
mod tests {
    use super::{Survey, survey};
    use crate::arithmetic::Each;
    use crate::shape::{Aabb, Polygon, Vec3};

    /// No answer changes if a survey decides less than it could, or names the wrong triangle. These
    /// counts do.
    #[test]
    fn most_hexagons_take_one_triangle_at_most() {
        const CORNERS: [[f32; 2]; 6] = [[2., 1.], [1., 2.], [0., 2.], [0., 1.], [1., 0.], [2., 0.]];
        let mut state = 1_u32;
        let mut number = || {
            // G. Marsaglia, "Xorshift RNGs", 2003.
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            (state >> 8) as f32 / (1 << 24) as f32 - 0.5
        };
        let cube = Aabb::from_center_half_extents([0.0; 3], [0.25; 3]).unwrap();
        let [mut by_vertex, mut apart, mut first, mut other, mut none] = [0; 5];
        for _ in 0..10_000 {
            let [o, u, v] = [(); 3].each(|()| [(); 3].each(|()| number()));
            let at = |[a, b]: [f32; 2]| {
                Vec3::from(
                    [0, 1, 2].each(|i: usize| 2.0 * o[i] + (a - 1.0) * u[i] + (b - 1.0) * v[i]),
                )
            };
            let vertices = CORNERS.map(at);
            let polygon = Polygon::new(&vertices).unwrap();
            match survey(&vertices, &cube) {
                Survey::Meets => by_vertex += 1,
                Survey::Apart => apart += 1,
                Survey::AskFirst(k) if polygon.triangles().nth(k - 1).unwrap().overlaps(&cube) => {
                    first += 1;
                }
                Survey::AskFirst(_) if polygon.overlaps(&cube) => other += 1,
                Survey::AskFirst(_) => none += 1,
            }
        }
        assert_eq!([by_vertex, apart, first, other, none], [815, 8093, 590, 27, 475]);
    }
}
