//! The squared distance of a point from a triangle, a segment or a box.
//!
//! It is d·d at a vertex, |e × d|²/e·e on an edge and (n·d)²/n·n in the interior; over a box d is
//! how far the point lies beyond each face. In the unit u·v of squares, which is 2^F units in the
//! last place squared in fixed point, each is a quotient of products of six lengths.

use core::cmp::Ordering;

use super::error_bound::{Errors, PRODUCT, SQUARE};
use super::foot::{Around, feature, feature_of_segment};
use super::kernel::{largest_of, product, squared, to_ends};
use crate::arithmetic::{
    Arithmetic, Embeds, Limbed, Number, REGISTERS_ARE_WIDE, cross, dot, greatest, largest, part,
    pick, three,
};
use crate::query::Feature;
use crate::query::orientation::Vector;
use crate::query::ray_triangle::compare_quotients;
use crate::robust::{Numeric, Predicate};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Segment, ShapeError, Triangle, Vec3, finite};

/// A quotient, and the errors of both numbers.
struct Quotient<N: Arithmetic> {
    num: N::Sextic,
    den: N::Sextic,
    errors: [N::Sextic; 2],
}

impl<N: Arithmetic> Quotient<N> {
    /// d·d/uv.
    #[inline(always)]
    fn of_point(d: &Vector<N>, uv: N::Area) -> Self {
        let num = part(|| N::sextic_of_areas(N::quartic(product::<N>(d, d), uv), uv));
        let den = part(|| N::sextic_of_areas(N::quartic(uv, uv), uv));
        Self { num, den, errors: [num.error(SQUARE) + N::Sextic::UNDERFLOW, N::Sextic::ZERO] }
    }

    /// |e × d|²/(e·e·uv).
    #[inline(always)]
    fn of_line(d: &Vector<N>, e: &Vector<N>, uv: N::Area, errors: &Errors<N>) -> Self {
        let square = squared::<N>(&part(|| cross::<N>(e, d)), errors.minor);
        let num = N::sextic_of_areas(square.value, uv);
        let den = N::sextic_of_areas(N::quartic(product::<N>(e, e), uv), uv);
        if N::CERTAIN {
            return Self { num, den, errors: [N::Sextic::ZERO; 2] };
        }
        let other = N::sextic_of_areas(N::quartic(errors.dot, uv), uv) + den.error(PRODUCT);
        let error = N::sextic_of_areas(square.error, uv) + num.error(PRODUCT);
        Self { num, den, errors: [error, other] }
    }

    /// (n·d)²/(n·n·uv).
    #[inline(always)]
    fn of_plane(d: &Vector<N>, n: &[N::Area; 3], uv: N::Area, errors: &Errors<N>) -> Self {
        let (volume, square) = (part(|| dot::<N>(n, d)), squared::<N>(n, errors.minor));
        let num = N::sextic(volume, volume);
        let den = N::sextic_of_areas(square.value, uv);
        if N::CERTAIN {
            return Self { num, den, errors: [N::Sextic::ZERO; 2] };
        }
        let most = volume.magnitude() + volume.magnitude() + errors.volume;
        let error = N::sextic(errors.volume, most) + num.error(PRODUCT);
        let other = N::sextic_of_areas(square.error, uv) + den.error(PRODUCT);
        Self { num, den, errors: [error, other] }
    }

    /// The quotient for a triangle whose closest part is this feature.
    #[inline(always)]
    fn of_triangle(feature: Feature, around: &Around<N>, uv: N::Area) -> Self {
        let Around { d, e, errors, .. } = around;
        match feature {
            Feature::Vertex(k) => Self::of_point(pick(d, k.into()), uv),
            Feature::Edge(k) => Self::of_line(pick(d, k.into()), pick(e, k.into()), uv, errors),
            Feature::Interior => Self::of_plane(&d[0], &around.normal(), uv, errors),
        }
    }

    fn rounded<S: Scalar>(self) -> Option<S>
    where
        N: Embeds<S>,
    {
        N::coordinate(self.num, self.den, self.errors)
    }
}

/// The question for the squared distance.
struct Apart<'a, S, T> {
    point: [S; 3],
    shape: &'a T,
}

/// Two lengths whose product is the unit of squares, and one more.
fn units<S: Scalar>() -> [S; 3] {
    let [u, v] = S::UNIT_OF_SQUARES;
    [u, v, v]
}

impl<S: Scalar> Predicate<S> for Apart<'_, S, Triangle<S>> {
    type Answer = Option<S>;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<Option<S>> {
        let [a, b, c] = self.shape.points();
        let [a, b, c, p, [u, v, _]] = N::embed(&[a, b, c, self.point, units()])?;
        let around = Around::<N>::new(&p, &[a, b, c])?;
        let feature = feature::<N>(&around)?;
        Some(Some(Quotient::of_triangle(feature, &around, N::area(u, v)).rounded()?))
    }
}

impl<S: Scalar> Predicate<S> for Apart<'_, S, Segment<S>> {
    type Answer = Option<S>;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<Option<S>> {
        let (a, b, is_by_center) = self.shape.numbers();
        let [a, b, p, [u, v, _]] = N::embed(&[a, b, self.point, units()])?;
        // In floats these ends are rounded.
        if is_by_center && !N::CERTAIN {
            return None;
        }
        let (d, e) = to_ends::<N>(&p, [&a, &b], is_by_center);
        let errors = Errors::<N>::of_lengths(largest_of::<N, 3>(&[d[0], d[1], e]))?;
        let uv = N::area(u, v);
        let squared = match feature_of_segment::<N>(&d, &e, &errors)? {
            Feature::Vertex(k) => Quotient::<N>::of_point(&d[usize::from(k == 1)], uv),
            _ => Quotient::of_line(&d[0], &e, uv, &errors),
        };
        Some(Some(squared.rounded()?))
    }
}

impl<S: Scalar> Predicate<S> for Apart<'_, S, Aabb<S>> {
    type Answer = Option<S>;

    #[inline]
    fn filter<N: Embeds<S>>(&self) -> Option<Option<S>> {
        let (p, q, is_by_center) = self.shape.numbers();
        let [p, q, c, [u, v, _]] = N::embed(&[p, q, self.point, units()])?;
        let beyond = |i: usize| {
            if is_by_center {
                (c[i] - p[i]).magnitude() - q[i]
            } else {
                greatest(p[i] - c[i], c[i] - q[i])
            }
        };
        let d = three(|i| greatest(beyond(i), N::Length::ZERO));
        if !N::CERTAIN {
            // In floats faces of a box given by its centre are rounded.
            let size = largest(&d);
            if !is_by_center && size == N::Length::ZERO {
                return Some(Some(S::ZERO));
            }
            if is_by_center || !N::area(size, size).in_range() {
                return None;
            }
        }
        Some(Some(Quotient::<N>::of_point(&d, N::area(u, v)).rounded()?))
    }
}

/// How the distances of a finite point from two triangles compare, given the part of each closest
/// to the point. Products of ten lengths, in exact numbers alone.
#[cold]
#[inline(never)]
pub(crate) fn compare_distances<S: Scalar>(
    point: [S; 3],
    triangles: [(&Triangle<S>, Feature); 2],
) -> Ordering {
    // On a small core one width is enough, as in `in_exact_numbers`.
    let in_window =
        if REGISTERS_ARE_WIDE { compare_in::<S, S::SeptumWindow>(point, triangles) } else { None };
    let order = in_window.or_else(|| compare_in::<S, S::SeptumFull>(point, triangles));
    order.unwrap_or(Ordering::Equal)
}

fn compare_in<S: Scalar, N: Embeds<S, Sextic: Limbed>>(
    point: [S; 3],
    [(t, of_t), (s, of_s)]: [(&Triangle<S>, Feature); 2],
) -> Option<Ordering> {
    let ([a, b, c], [d, e, f]) = (t.points(), s.points());
    let all = [point, a, b, c, d, e, f];
    // Any length but zero will do as a unit, and one of these needs no more digits than they do.
    let unit = *all.as_flattened().iter().find(|&&x| x != S::ZERO)?;
    let [p, a, b, c, d, e, f, [unit, ..]] = N::embed(&[point, a, b, c, d, e, f, [unit; 3]])?;
    let uv = N::area(unit, unit);
    let of = |vertices: [Vector<N>; 3], feature: Feature| {
        let Quotient { num, den, .. } =
            Quotient::of_triangle(feature, &Around::<N>::new(&p, &vertices)?, uv);
        Some([num, den])
    };
    Some(compare_quotients(of([a, b, c], of_t)?, of([d, e, f], of_s)?))
}

impl<S, T> Numeric<S> for Apart<'_, S, T> where Self: Predicate<S> {}

/// The squared distance from a point, if that is finite.
#[inline(always)]
fn distance_squared<'a, S: Scalar, T>(
    shape: &'a T,
    point: impl Into<Vec3<S>>,
) -> Result<S, ShapeError>
where
    Apart<'a, S, T>: Predicate<S, Answer = Option<S>>,
{
    let point = finite("point", point)?.to_array();
    // The last stage always answers.
    Ok(S::evaluate_numeric(&Apart { point, shape }).unwrap_or(S::ZERO))
}

impl<S: Scalar> Triangle<S> {
    /// The square of the distance from a point to the triangle; zero if the point lies in it.
    ///
    /// *Geometry*: a closed set, which may be a segment or a point.
    ///
    /// *Numerics*: one quotient of exact numbers, rounded once: in fixed point to the nearest
    /// number, ties to even, and in floats within 0.51 units in the last place; below the least
    /// normal number within 0.76. It is zero for a distance above zero only if it underflows. To
    /// compare a distance with a number, ask whether a [`Sphere`](crate::Sphere) overlaps, which
    /// rounds nothing.
    ///
    /// *Range*: all finite floats, all fixed-point values. A square beyond the range of the scalar
    /// is infinite in floats and the greatest number in fixed point, such as for distances from 182
    /// on in `I16F16`.
    ///
    /// *Errors*: [`ShapeError::NotFinite`] if a coordinate is NaN or infinite. *Panics*: never.
    ///
    /// *Cost*: 20 to 60 multiplications and a division; in `f64` the quotient takes exact integers.
    ///
    /// ```
    /// use septum::Triangle;
    ///
    /// let t = Triangle::new([0.0_f32, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0])?;
    /// assert_eq!(t.distance_squared([1.0, 2.0, 7.0])?, 49.0);
    /// assert_eq!(t.distance_squared([4.0, 6.0, 1.0])?, 19.0);
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    pub fn distance_squared(&self, point: impl Into<Vec3<S>>) -> Result<S, ShapeError> {
        distance_squared(self, point)
    }
}

impl<S: Scalar> Segment<S> {
    /// The square of the distance from a point to the segment.
    ///
    /// *Numerics*, *Range*, *Errors*, *Panics*: as for [`Triangle::distance_squared`].
    ///
    /// ```
    /// use septum::Segment;
    ///
    /// let s = Segment::new([0.0_f64, 0.0, 0.0], [3.0, 0.0, 0.0])?;
    /// assert_eq!(s.distance_squared([1.0, 2.0, 2.0])?, 8.0);
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    pub fn distance_squared(&self, point: impl Into<Vec3<S>>) -> Result<S, ShapeError> {
        distance_squared(self, point)
    }
}

impl<S: Scalar> Aabb<S> {
    /// The square of the distance from a point to the box; zero if the point lies in it.
    ///
    /// *Numerics*, *Range*, *Errors*, *Panics*: as for [`Triangle::distance_squared`], for the box
    /// in the form in which it was given. *Cost*: 3 multiplications and a division.
    ///
    /// ```
    /// use septum::Aabb;
    ///
    /// let cell = Aabb::from_min_max([0.0_f32; 3], [1.0; 3])?;
    /// assert_eq!(cell.distance_squared([4.0, 5.0, 13.0])?, 169.0); // 3² + 4² + 12²
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    pub fn distance_squared(&self, point: impl Into<Vec3<S>>) -> Result<S, ShapeError> {
        distance_squared(self, point)
    }
}
