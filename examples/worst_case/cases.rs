//! Pairs of shapes that meet in every way, from the numbers of a path.

use septum::sweep::Motion;
use septum::{Aabb, Capsule, Obb, Ray, Segment, Sphere, Triangle, Vec3};

use crate::draw::{Draw, Raw};

fn less(a: [i64; 3], b: [i64; 3]) -> [i64; 3] {
    [0, 1, 2].map(|i| a[i].saturating_sub(b[i]))
}

pub(crate) fn triangle_aabb<S: Raw>(draw: &mut Draw) -> Option<(Triangle<S>, Aabb<S>)> {
    let [a, b, c] = [(); 3].map(|()| draw.point());
    let triangle = Triangle::new(draw.vector(a), draw.vector(b), draw.vector(c)).ok()?;
    let (p, q) = (draw.point(), draw.point());
    let [low, high] = [i64::min, i64::max].map(|of| [0, 1, 2].map(|i| of(p[i], q[i])));
    let aabb = if draw.rng.below(2) == 0 {
        Aabb::from_min_max(draw.vector::<S>(low), draw.vector::<S>(high))
    } else {
        // A quarter of the size, so that a near box stays near.
        let (center, half) = (low.map(|x| x >> 1), less(high, low).map(|x| x >> 2));
        Aabb::from_center_half_extents(draw.vector::<S>(center), draw.vector::<S>(half))
    };
    Some((triangle, aabb.ok()?))
}

/// A triangle at the start, and its motion.
type Moving<S> = (Triangle<S>, Motion<S>);

/// The same, with a motion of the triangle.
pub(crate) fn sweep<S: Raw>(draw: &mut Draw) -> Option<(Moving<S>, Aabb<S>)> {
    let (triangle, aabb) = triangle_aabb(draw)?;
    let (from, to) = (draw.point(), draw.point());
    let motion = Motion::new(draw.vector::<S>(from), draw.vector::<S>(to)).ok()?;
    Some(((triangle, motion), aabb))
}

/// Axis-parallel boxes, boxes rotated by the angles of the 3-4-5 triangle, and skewed ones.
pub(crate) fn triangle_obb<S: Raw>(draw: &mut Draw) -> Option<(Triangle<S>, Obb<S>)> {
    let [a, b, c, center, half] = [(); 5].map(|()| draw.point());
    let of_one = |axes: [[i64; 3]; 3]| axes.map(|u| u.map(|x| x * S::one() / 100));
    let axes = match draw.rng.below(4) {
        0 | 1 => of_one([[100, 0, 0], [0, 100, 0], [0, 0, 100]]),
        2 => of_one([[60, 80, 0], [-48, 36, 80], [64, -48, 60]]),
        _ => [(); 3].map(|()| draw.point()),
    };
    let triangle = Triangle::new(draw.vector(a), draw.vector(b), draw.vector(c)).ok()?;
    let half = half.map(|x| x.saturating_abs() >> 1);
    let axes = axes.map(|u| draw.vector::<S>(u));
    let obb = Obb::from_skewed_axes(draw.vector(center), axes, draw.vector(half)).ok()?;
    Some((triangle, obb))
}

fn triangle<S: Raw>(draw: &mut Draw) -> Option<Triangle<S>> {
    let [a, b, c] = [(); 3].map(|()| draw.point());
    Triangle::new(draw.vector(a), draw.vector(b), draw.vector(c)).ok()
}

fn any_point<S: Raw>(draw: &mut Draw) -> Vec3<S> {
    let p = draw.point();
    draw.vector(p)
}

/// A radius is a coordinate without its sign. On a grid it is often the distance.
fn radius<S: Raw>(draw: &mut Draw) -> S {
    let p = draw.point().map(i64::saturating_abs);
    draw.vector::<S>(p).x
}

pub(crate) fn sphere<S: Raw>(draw: &mut Draw) -> Option<(Triangle<S>, Sphere<S>)> {
    let triangle = triangle(draw)?;
    let center = any_point::<S>(draw);
    Some((triangle, Sphere::new(center, radius(draw)).ok()?))
}

pub(crate) fn capsule<S: Raw>(draw: &mut Draw) -> Option<(Triangle<S>, Capsule<S>)> {
    let triangle = triangle(draw)?;
    let ends = [any_point::<S>(draw), any_point(draw)];
    Some((triangle, Capsule::new(ends[0], ends[1], radius(draw)).ok()?))
}

/// A triangle and a sphere that moves.
type Rolling<S> = (Triangle<S>, (Sphere<S>, Motion<S>));

pub(crate) fn sphere_sweep<S: Raw>(draw: &mut Draw) -> Option<Rolling<S>> {
    let (triangle, sphere) = sphere(draw)?;
    let motion = Motion::new(any_point::<S>(draw), any_point(draw)).ok()?;
    Some((triangle, (sphere, motion)))
}

/// Three of four rays go to a point of the triangle: its interior, an edge or a vertex. In half of
/// these the range ends there.
pub(crate) fn ray_triangle<S: Raw>(draw: &mut Draw) -> Option<(Ray<S>, Triangle<S>)> {
    let [a, b, c, o, d] = [(); 5].map(|()| draw.point());
    let triangle = Triangle::new(draw.vector(a), draw.vector(b), draw.vector(c)).ok()?;
    let i = draw.rng.below(5);
    let j = draw.rng.below(5 - i as u32);
    let toward = || {
        let on = [0, 1, 2].map(|k| {
            let (b, c) = (i128::from(b[k]) - i128::from(a[k]), i128::from(c[k]) - i128::from(a[k]));
            (i128::from(a[k]) + (b * i128::from(i) + c * i128::from(j)) / 4) as i64
        });
        less(on, o)
    };
    let d = if draw.rng.below(4) == 0 { d } else { toward() };
    let ray = Ray::new(draw.vector::<S>(o), draw.vector::<S>(d)).ok()?;
    let (least, most) = (S::of(i64::MIN), S::of(i64::MAX));
    let ranged = match (draw.rng.below(4), ray.hit(&triangle)) {
        (0, _) => Ok(ray),
        (1, Some(hit)) => ray.with_range(hit.t, most),
        (2, Some(hit)) => ray.with_range(least, hit.t),
        _ => ray.with_range(least, most),
    };
    Some((ranged.ok()?, triangle))
}

/// A ray of those above, and a box.
pub(crate) fn ray_aabb<S: Raw>(draw: &mut Draw) -> Option<(Ray<S>, Aabb<S>)> {
    Some((ray_triangle(draw)?.0, triangle_aabb(draw)?.1))
}

fn segment<S: Raw>(draw: &mut Draw) -> Option<Segment<S>> {
    let (p, q) = (draw.point(), draw.point());
    let segment = if draw.rng.below(2) == 0 {
        Segment::new(draw.vector::<S>(p), draw.vector::<S>(q))
    } else {
        // Half of the size, so that a near segment stays near.
        let half = |p: [i64; 3]| draw.vector::<S>(p.map(|x| x >> 1));
        Segment::from_center_half_vector(half(p), half(q))
    };
    segment.ok()
}

pub(crate) fn segment_aabb<S: Raw>(draw: &mut Draw) -> Option<(Segment<S>, Aabb<S>)> {
    Some((segment(draw)?, triangle_aabb(draw)?.1))
}

pub(crate) fn segment_obb<S: Raw>(draw: &mut Draw) -> Option<(Segment<S>, Obb<S>)> {
    Some((segment(draw)?, triangle_obb(draw)?.1))
}

/// A ray of those above, and an oriented box.
pub(crate) fn ray_obb<S: Raw>(draw: &mut Draw) -> Option<(Ray<S>, Obb<S>)> {
    Some((ray_triangle(draw)?.0, triangle_obb(draw)?.1))
}
