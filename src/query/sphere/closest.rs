//! The point of a triangle, a segment or a box closest to a point.
//!
//! First the part on which it lies, by signs of products of two and four lengths: a vertex if both its
//! edges lead away from the point, an edge with the point outside and between its ends, or the
//! interior. Each coordinate is then one quotient: a + e·(d·e)/(e·e) on an edge, and p −
//! n·(n·d)/(n·n) in the interior.

use super::error_bound::Errors;
use super::foot::{Around, feature, feature_of_segment, in_double, on_edge, on_face};
use super::kernel::largest_of;
use crate::arithmetic::{Embeds, Filtered, Number, REGISTERS_ARE_WIDE, dot, part, pick, three};
use crate::query::Feature;
use crate::query::orientation::{Vector, from};
use crate::robust::{Clue, Numeric, Predicate};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Segment, ShapeError, Triangle, Vec3, finite};

/// The point of a shape closest to another point: see [`Triangle::closest_point`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Closest<S> {
    /// The point.
    pub point: Vec3<S>,
    /// The part of the shape on which it lies, before the point is rounded.
    pub feature: Feature,
}

/// The question for the closest point.
struct Nearest<'a, S, T> {
    point: [S; 3],
    shape: &'a T,
}

impl<S: Scalar> Predicate<S> for Nearest<'_, S, Triangle<S>> {
    type Answer = Option<(Feature, [S; 3])>;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<Self::Answer> {
        let vertices = self.shape.points();
        let [a, b, c] = vertices;
        let [a, b, c, p, [one, ..]] = N::embed(&[a, b, c, self.point, [S::UNIT_LENGTH; 3]])?;
        let starts = [a, b, c];
        let around = Around::<N>::new(&p, &starts)?;
        let feature = feature::<N>(&around)?;
        let Around { d, e, errors, .. } = &around;
        let point = match feature {
            Feature::Vertex(k) => *pick(&vertices, k.into()),
            Feature::Edge(k) => {
                let of = |v| pick(v, k.into());
                on_edge::<S, N>([of(&starts), of(d), of(e)], one, errors)?
            }
            Feature::Interior => {
                let n = around.normal();
                on_face::<S, N>(&p, &n, part(|| dot::<N>(&n, &d[0])), one, errors)?
            }
        };
        Some(Some((feature, point)))
    }
}

impl<S: Scalar> Predicate<S> for Nearest<'_, S, Segment<S>> {
    type Answer = Option<(Feature, [S; 3])>;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<Self::Answer> {
        let (start, end, is_by_center) = self.shape.numbers();
        let all = [start, end, self.point, [S::UNIT_LENGTH; 3]];
        let [a, b, p, [one, ..]] = N::embed(&all)?;
        // In floats these ends are rounded.
        if is_by_center && !N::CERTAIN {
            return None;
        }
        let [a, b] =
            if is_by_center { [from::<N>(&a, &b), three(|i| a[i] + b[i])] } else { [a, b] };
        let (d, e) = ([from::<N>(&p, &a), from::<N>(&p, &b)], from::<N>(&b, &a));
        let errors = Errors::<N>::of_lengths(largest_of::<N, 3>(&[d[0], d[1], e]))?;
        let feature = feature_of_segment::<N>(&d, &e, &errors)?;
        let at_end = |end: &Vector<N>, given: [S; 3]| {
            if is_by_center {
                // On a line of length zero through the end.
                let along = [one; 3];
                on_edge::<S, N>([end, &[N::Length::ZERO; 3], &along], one, &errors)
            } else {
                Some(given)
            }
        };
        let point = match feature {
            Feature::Vertex(0) => at_end(&a, start)?,
            Feature::Vertex(_) => at_end(&b, end)?,
            _ => on_edge::<S, N>([&a, &d[0], &e], one, &errors)?,
        };
        Some(Some((feature, point)))
    }
}

impl<S: Scalar> Numeric<S> for Nearest<'_, S, Triangle<S>> {
    #[inline(always)]
    fn fast_path(&self) -> Result<Self::Answer, Clue>
    where
        Filtered<f64>: Embeds<S>,
    {
        // With narrow registers one copy of the kernel suffices.
        let answer = if REGISTERS_ARE_WIDE {
            in_double(&self.shape.points(), self.point).map(Some)
        } else {
            self.filter::<Filtered<f64>>()
        };
        answer.ok_or(Clue::Doubt)
    }
}

impl<S: Scalar> Numeric<S> for Nearest<'_, S, Segment<S>> {}

/// The question for the part of a triangle closest to a point.
struct Part<'a, S>(&'a Triangle<S>, [S; 3]);

impl<S: Scalar> Predicate<S> for Part<'_, S> {
    type Answer = Option<Feature>;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<Self::Answer> {
        let [a, b, c] = self.0.points();
        let [a, b, c, p] = N::embed(&[a, b, c, self.1])?;
        Some(Some(feature::<N>(&Around::new(&p, &[a, b, c])?)?))
    }
}

impl<S: Scalar> Numeric<S> for Part<'_, S> {}

/// The answer about a point, if that is finite.
#[inline(always)]
fn closest<'a, S: Scalar, T>(
    shape: &'a T,
    point: impl Into<Vec3<S>>,
) -> Result<Closest<S>, ShapeError>
where
    Nearest<'a, S, T>: Numeric<S, Answer = Option<(Feature, [S; 3])>>,
{
    let point = finite("point", point)?.to_array();
    let found = S::evaluate_numeric(&Nearest { point, shape });
    // The last stage always answers.
    let (feature, point) = found.unwrap_or((Feature::Interior, point));
    Ok(Closest { point: point.into(), feature })
}

impl<S: Scalar> Triangle<S> {
    /// The part of the triangle closest to a finite point.
    pub(crate) fn closest_feature(&self, point: [S; 3]) -> Feature {
        // The last stage always answers.
        S::evaluate_numeric(&Part(self, point)).unwrap_or(Feature::Interior)
    }

    /// The point of the triangle closest to a point, and the vertex or edge on which it lies.
    ///
    /// *Geometry*: a closed set, which may be a segment or a point. A point on several edges of a
    /// triangle that is a segment is given to the first, and a point at vertices that coincide to any of them.
    ///
    /// *Numerics*: the feature is exact. Each coordinate is one quotient of exact numbers: in fixed
    /// point the nearest number, ties to even, and in floats within 0.51 units in the last place;
    /// below the least normal number within 0.76. At a vertex the point is that vertex. A distance
    /// computed from the rounded point is rounded too: to compare it with a number, ask whether a
    /// [`Sphere`](crate::Sphere) overlaps.
    ///
    /// *Range*: all finite floats, all fixed-point values.
    ///
    /// *Errors*: [`ShapeError::NotFinite`] if a coordinate is NaN or infinite. *Panics*: never.
    ///
    /// *Cost*: 11 to 23 multiplications at a vertex; else up to 60, and a division. In `f64` these
    /// points take exact integers.
    ///
    /// *Source*: C. Ericson, *Real-Time Collision Detection*, 2005, section 5.1.5; the exact stages
    /// and the rounding are ours.
    ///
    /// ```
    /// use septum::{Feature, Triangle, Vec3};
    ///
    /// let t = Triangle::new([0.0_f32, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0])?;
    /// let closest = t.closest_point([1.0, 2.0, 7.0])?;
    /// assert_eq!((closest.point, closest.feature), (Vec3::new(1.0, 2.0, 0.0), Feature::Interior));
    /// let closest = t.closest_point([4.0, 6.0, 1.0])?;
    /// assert_eq!((closest.point, closest.feature), (Vec3::new(1.0, 3.0, 0.0), Feature::Edge(1)));
    /// assert_eq!(t.closest_point([-1.0, -2.0, 3.0])?.feature, Feature::Vertex(0));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    pub fn closest_point(&self, point: impl Into<Vec3<S>>) -> Result<Closest<S>, ShapeError> {
        closest(self, point)
    }
}

impl<S: Scalar> Segment<S> {
    /// The point of the segment closest to a point: on [`Feature::Edge`] 0, or at
    /// [`Feature::Vertex`] 0 or 1.
    ///
    /// *Numerics*, *Range*, *Errors*, *Panics*: as for [`Triangle::closest_point`]. An end of a
    /// segment given by its centre is rounded likewise; beyond the range of the scalar a coordinate
    /// is clamped in fixed point, and infinite in floats.
    ///
    /// ```
    /// use septum::{Feature, Segment, Vec3};
    ///
    /// let s = Segment::new([0.0_f64, 0.0, 0.0], [3.0, 0.0, 0.0])?;
    /// let closest = s.closest_point([1.0, 2.0, 2.0])?;
    /// assert_eq!((closest.point, closest.feature), (Vec3::new(1.0, 0.0, 0.0), Feature::Edge(0)));
    /// assert_eq!(s.closest_point([3.0, 1.0, 0.0])?.feature, Feature::Vertex(1));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    pub fn closest_point(&self, point: impl Into<Vec3<S>>) -> Result<Closest<S>, ShapeError> {
        closest(self, point)
    }
}

impl<S: Scalar> Aabb<S> {
    /// The point of the box closest to a point; the point itself if it lies in the box.
    ///
    /// *Numerics*: exact for a box given by its corners, and in fixed point. In floats a coordinate
    /// on a face of a box given by its centre is rounded outward, by less than a unit in the last
    /// place.
    ///
    /// *Errors*: [`ShapeError::NotFinite`] if a coordinate is NaN or infinite. *Panics*: never.
    ///
    /// *Cost*: 6 comparisons.
    ///
    /// ```
    /// use septum::{Aabb, Vec3};
    ///
    /// let cell = Aabb::from_min_max([0.0_f32; 3], [1.0; 3])?;
    /// assert_eq!(cell.closest_point([2.0, 0.5, -1.0])?, Vec3::new(1.0, 0.5, 0.0));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    pub fn closest_point(&self, point: impl Into<Vec3<S>>) -> Result<Vec3<S>, ShapeError> {
        let point = finite("point", point)?.to_array();
        let (p, q, is_by_center) = self.numbers();
        Ok(Vec3::from(three(|i| {
            let [low, high] = if is_by_center { p[i].reach(q[i]) } else { [p[i], q[i]] };
            if point[i] < low {
                low
            } else if point[i] > high {
                high
            } else {
                point[i]
            }
        })))
    }
}

#[cfg(test)]
mod tests {
    use super::{Feature, Nearest, Numeric, Scalar, Triangle};
    use crate::arithmetic::Each;
    use crate::arithmetic::{Embeds, Filtered};
    use crate::random::Random;
    use crate::robust::in_exact_numbers;

    /// How many of 3,000 points near a triangle the first stage leaves in doubt; where it is certain,
    /// exact numbers give the same bits. Also asks about nearly degenerate triangles, and does not
    /// count their doubts.
    fn doubts<S: Scalar>(of: fn(i32) -> S) -> u32
    where
        Filtered<f64>: Embeds<S>,
    {
        let (mut random, mut doubts) = (Random(0xc105), 0);
        let mut seen = [0; 7];
        for case in 0..6_000 {
            let is_flat = case % 2 == 1;
            let mut point = |shift: u32| [(); 3].each(|()| (random.bits() as i32) >> shift);
            let [a, b, mut c, p] = [12, 12, 12, 11].each(&mut point);
            if is_flat {
                c = [0, 1, 2].each(|i| (a[i] + b[i]) / 2 + (c[i] & 3));
            }
            let [a, b, c, point] = [a, b, c, p].each(|p| p.each(of));
            let triangle = Triangle::new(a, b, c).unwrap();
            let question = Nearest { point, shape: &triangle };
            let exact: Option<(Feature, _)> = in_exact_numbers(&question);
            match question.fast_path() {
                Ok(answer) => assert_eq!(answer, exact, "{triangle:?} {point:?}"),
                Err(_) => doubts += u32::from(!is_flat),
            }
            seen[match exact.unwrap().0 {
                Feature::Vertex(k) => usize::from(k),
                Feature::Edge(k) => 3 + usize::from(k),
                Feature::Interior => 6,
            }] += 1;
        }
        assert!(seen.iter().all(|&count| count > 100), "{seen:?}");
        doubts
    }

    #[test]
    fn the_first_stage_is_exact_and_seldom_in_doubt() {
        assert_eq!(doubts::<f32>(|x| x as f32 / 4096.0), 1);
        #[cfg(feature = "fixed")]
        assert_eq!(doubts::<fixed::types::I16F16>(fixed::types::I16F16::from_bits), 0);
    }
}
