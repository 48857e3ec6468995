//! Shapes from random bits, the same on every board.

use fixed::types::{I4F4, I8F8, I16F16, I32F32};
use septum::{Aabb, Capsule, Obb, Ray, Scalar, Segment, ShapeError, Sphere, Triangle, Vec3};

/// A point in units of 2⁻¹⁶.
pub(crate) type Point = [i32; 3];

pub(crate) const HALF: i32 = 1 << 15;

/// A scalar that has these numbers, perhaps with fewer fraction bits.
pub(crate) trait Coordinate: Scalar {
    const NAME: &'static str;

    /// So many units of 2⁻¹⁶, rounded down.
    fn of(units: i32) -> Self;

    /// The same units scaled by 2¹³, for scalars of 32 bits: the scene is then as wide
    /// as the range of the scalar.
    fn of_whole_range(units: i32) -> Option<Self> {
        let _ = units;
        None
    }
}

impl Coordinate for f32 {
    const NAME: &'static str = "f32";
    fn of(units: i32) -> Self {
        units as f32 / 65536.0
    }
}

impl Coordinate for f64 {
    const NAME: &'static str = "f64";
    fn of(units: i32) -> Self {
        f64::from(units) / 65536.0
    }
}

impl Coordinate for I4F4 {
    const NAME: &'static str = "I4F4";
    fn of(units: i32) -> Self {
        Self::from_bits((units >> 12) as i8)
    }
}

impl Coordinate for I8F8 {
    const NAME: &'static str = "I8F8";
    fn of(units: i32) -> Self {
        Self::from_bits((units >> 8) as i16)
    }
}

impl Coordinate for I16F16 {
    const NAME: &'static str = "I16F16";
    fn of(units: i32) -> Self {
        Self::from_bits(units)
    }
    fn of_whole_range(units: i32) -> Option<Self> {
        Some(Self::from_bits(units << 13))
    }
}

impl Coordinate for I32F32 {
    const NAME: &'static str = "I32F32";
    fn of(units: i32) -> Self {
        Self::from_bits(i64::from(units) << 16)
    }
}

/// Xorshift, 32 bits (G. Marsaglia, "Xorshift RNGs", 2003).
pub(crate) struct Rng(u32);

impl Rng {
    pub(crate) fn new() -> Self {
        Self(12345)
    }

    fn bits(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }

    /// In [−2, 2)³.
    pub(crate) fn point(&mut self) -> Point {
        [(); 3].map(|()| (self.bits() >> 14) as i32 - (1 << 17))
    }

    /// One of the 729 points of the grid {−4, …, 4}³.
    fn grid_point(&mut self) -> Point {
        [(); 3].map(|()| ((u64::from(self.bits()) * 9) >> 32) as i32 - 4).map(|x| x << 16)
    }

    /// An integer below n.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        ((u64::from(self.bits()) * n as u64) >> 32) as usize
    }

    /// An integer from 0 to 255.
    fn byte(&mut self) -> i32 {
        (self.bits() >> 24) as i32
    }
}

/// Makes a pair of shapes; `None` if the scalar has no such pair.
pub(crate) type Draw<A, B> = fn(&mut Rng) -> Option<(A, B)>;

/// A point in a scalar.
pub(crate) fn vector<S: Coordinate>(p: Point) -> Vec3<S> {
    Vec3::from(p.map(S::of))
}

fn triangle<S: Coordinate>(p: [Point; 3]) -> Result<Triangle<S>, ShapeError> {
    Triangle::new(vector(p[0]), vector(p[1]), vector(p[2]))
}

/// The first pair on which the shapes meet, or the first on which they do not.
pub(crate) fn first<A, B>(
    rng: &mut Rng,
    draw: Draw<A, B>,
    wanted: bool,
    meet: fn(&A, &B) -> bool,
) -> Option<(A, B)> {
    loop {
        let (a, b) = draw(rng)?;
        if meet(&a, &b) == wanted {
            return Some((a, b));
        }
    }
}

pub(crate) fn voorhies<S: Coordinate>(rng: &mut Rng) -> Option<(Triangle<S>, Aabb<S>)> {
    let triangle = triangle([(); 3].map(|()| rng.point())).ok()?;
    Some((triangle, Aabb::from_center_half_extents(vector([0; 3]), vector([HALF; 3])).ok()?))
}

pub(crate) fn full<S: Coordinate>(rng: &mut Rng) -> Option<(Triangle<S>, Aabb<S>)> {
    first(rng, voorhies, true, |triangle, aabb| triangle.overlaps(aabb))
}

/// A triangle with two of its corners cut off, and the unit cube.
pub(crate) fn pentagons<S: Coordinate>(rng: &mut Rng) -> Option<([Vec3<S>; 5], Aabb<S>)> {
    let [a, b, c] = [(); 3].map(|()| rng.point());
    let middle = |p: Point, q: Point| [0, 1, 2].map(|i: usize| (p[i] + q[i]) / 2);
    let third = |p: Point, q: Point| [0, 1, 2].map(|i: usize| p[i] + (q[i] - p[i]) / 3);
    let corners = [a, middle(a, b), third(b, c), third(c, b), middle(c, a)];
    let aabb = Aabb::from_center_half_extents(vector([0; 3]), vector([HALF; 3])).ok()?;
    Some((corners.map(vector), aabb))
}

pub(crate) fn grid<S: Coordinate>(rng: &mut Rng) -> Option<(Triangle<S>, Aabb<S>)> {
    let triangle = triangle([(); 3].map(|()| rng.grid_point())).ok()?;
    let (center, half) = (vector(rng.grid_point()), vector([2 * HALF; 3]));
    Some((triangle, Aabb::from_center_half_extents(center, half).ok()?))
}

pub(crate) fn whole_range<S: Coordinate>(rng: &mut Rng) -> Option<(Triangle<S>, Aabb<S>)> {
    let vector = |p: Point| {
        let [x, y, z] = p.map(S::of_whole_range);
        Some(Vec3::new(x?, y?, z?))
    };
    let aabb = Aabb::from_center_half_extents(vector([0; 3])?, vector([HALF; 3])?).ok()?;
    loop {
        let [a, b, c] = [(); 3].map(|()| vector(rng.point()));
        let triangle = Triangle::new(a?, b?, c?).ok()?;
        if triangle.overlaps(&aabb) {
            return Some((triangle, aabb));
        }
    }
}

/// A triangle and a cube rotated about two axes, by the angles of the 3-4-5 triangle.
pub(crate) fn turned_voorhies<S: Coordinate>(rng: &mut Rng) -> Option<(Triangle<S>, Obb<S>)> {
    let triangle = triangle([(); 3].map(|()| rng.point())).ok()?;
    let (axes, half) = turned_axes(rng)?;
    Some((triangle, Obb::from_skewed_axes(vector([0; 3]), axes, half).ok()?))
}

/// The axes and the half-extents of this cube.
pub(crate) fn turned_axes<S: Coordinate>(_: &mut Rng) -> Option<([Vec3<S>; 3], Vec3<S>)> {
    let axes = [[60, 80, 0], [-48, 36, 80], [64, -48, 60]].map(|a| a.map(|x| x * 65536 / 100));
    Some((axes.map(vector), vector([HALF; 3])))
}

pub(crate) fn turned_full<S: Coordinate>(rng: &mut Rng) -> Option<(Triangle<S>, Obb<S>)> {
    first(rng, turned_voorhies, true, |triangle, obb| triangle.overlaps(obb))
}

/// Two triangles in a cube.
pub(crate) fn triangles<S: Coordinate>(rng: &mut Rng) -> Option<(Triangle<S>, Triangle<S>)> {
    let mut one = || triangle([(); 3].map(|()| rng.point())).ok();
    Some((one()?, one()?))
}

pub(crate) fn meeting_triangles<S: Coordinate>(
    rng: &mut Rng,
) -> Option<(Triangle<S>, Triangle<S>)> {
    first(rng, triangles, true, |one, other| one.overlaps(other))
}

/// A triangle in a cube, and the ball in the unit cube.
pub(crate) fn sphere<S: Coordinate>(rng: &mut Rng) -> Option<(Triangle<S>, Sphere<S>)> {
    let triangle = triangle([(); 3].map(|()| rng.point())).ok()?;
    Some((triangle, Sphere::new(vector([0; 3]), S::of(HALF)).ok()?))
}

pub(crate) fn meeting_sphere<S: Coordinate>(rng: &mut Rng) -> Option<(Triangle<S>, Sphere<S>)> {
    first(rng, sphere, true, |triangle, sphere| sphere.overlaps(triangle))
}

/// A capsule as long as it is thick.
pub(crate) fn capsule<S: Coordinate>(rng: &mut Rng) -> Option<(Triangle<S>, Capsule<S>)> {
    let triangle = triangle([(); 3].map(|()| rng.point())).ok()?;
    let end = rng.point();
    let ends = [vector(end), vector(end.map(|x| -x / 2))];
    Some((triangle, Capsule::new(ends[0], ends[1], S::of(HALF)).ok()?))
}

pub(crate) fn meeting_capsule<S: Coordinate>(rng: &mut Rng) -> Option<(Triangle<S>, Capsule<S>)> {
    first(rng, capsule, true, |triangle, capsule| capsule.overlaps(triangle))
}

/// An axis-parallel box, as an oriented box, and a box rotated about two axes.
pub(crate) fn obbs<S: Coordinate>(rng: &mut Rng) -> Option<(Obb<S>, Obb<S>)> {
    let along = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|a| a.map(|x| x << 16));
    let turned = [[60, 80, 0], [-48, 36, 80], [64, -48, 60]].map(|a| a.map(|x| x * 65536 / 100));
    let one = |center: Point, axes: [Point; 3]| {
        Obb::from_skewed_axes(vector(center), axes.map(vector), vector([HALF; 3])).ok()
    };
    Some((one([0; 3], along)?, one(rng.point(), turned)?))
}

pub(crate) fn meeting_obbs<S: Coordinate>(rng: &mut Rng) -> Option<(Obb<S>, Obb<S>)> {
    first(rng, obbs, true, |one, other| one.overlaps(other))
}

/// A ray that enters the sphere.
pub(crate) fn sphere_hit<S: Coordinate>(rng: &mut Rng) -> Option<(Ray<S>, Sphere<S>)> {
    let rays = |rng: &mut Rng| Some((ray(rng.point(), rng.point())?, sphere(rng)?.1));
    first(rng, rays, true, |ray, sphere| sphere.overlaps(ray))
}

/// A ray that enters the capsule.
pub(crate) fn capsule_hit<S: Coordinate>(rng: &mut Rng) -> Option<(Ray<S>, Capsule<S>)> {
    let rays = |rng: &mut Rng| Some((ray(rng.point(), rng.point())?, capsule(rng)?.1));
    first(rng, rays, true, |ray, capsule| capsule.overlaps(ray))
}

/// A ray from one point towards another.
fn ray<S: Coordinate>(from: Point, to: Point) -> Option<Ray<S>> {
    let direction = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
    Ray::new(vector(from), vector(direction)).ok()
}

/// A ray towards some point of a triangle, as near as rounding allows.
fn at_triangle<S: Coordinate>(rng: &mut Rng) -> Option<(Ray<S>, Triangle<S>)> {
    let p = [(); 3].map(|()| rng.point());
    let (u, v) = (rng.byte(), rng.byte());
    let (u, v) = if u + v > 256 { (256 - u, 256 - v) } else { (u, v) };
    let blend = |i: usize| ((256 - u - v) * p[0][i] + u * p[1][i] + v * p[2][i]) >> 8;
    Some((ray(rng.point(), [blend(0), blend(1), blend(2)])?, triangle(p).ok()?))
}

fn anywhere_at_triangle<S: Coordinate>(rng: &mut Rng) -> Option<(Ray<S>, Triangle<S>)> {
    let p = [(); 3].map(|()| rng.point());
    Some((ray(rng.point(), rng.point())?, triangle(p).ok()?))
}

pub(crate) fn hit<S: Coordinate>(rng: &mut Rng) -> Option<(Ray<S>, Triangle<S>)> {
    first(rng, at_triangle, true, |ray, triangle| ray.is_hit(triangle))
}

pub(crate) fn miss<S: Coordinate>(rng: &mut Rng) -> Option<(Ray<S>, Triangle<S>)> {
    first(rng, anywhere_at_triangle, false, |ray, triangle| ray.is_hit(triangle))
}

/// A ray between two points, and a box of half-extents up to 0.75 in [−2, 2]³.
fn ray_and_box<S: Coordinate>(rng: &mut Rng) -> Option<(Ray<S>, Aabb<S>)> {
    let half = [(); 3].map(|()| 192 * rng.byte());
    let mut center = rng.point();
    for (c, h) in center.iter_mut().zip(half) {
        *c -= (*c >> 8) * (h >> 9);
    }
    let aabb = Aabb::from_center_half_extents(vector(center), vector(half)).ok()?;
    Some((ray(rng.point(), rng.point())?, aabb))
}

pub(crate) fn box_hit<S: Coordinate>(rng: &mut Rng) -> Option<(Ray<S>, Aabb<S>)> {
    first(rng, ray_and_box, true, |ray, aabb| ray.overlaps(aabb))
}

pub(crate) fn box_miss<S: Coordinate>(rng: &mut Rng) -> Option<(Ray<S>, Aabb<S>)> {
    first(rng, ray_and_box, false, |ray, aabb| ray.overlaps(aabb))
}

fn segment<S: Coordinate>(rng: &mut Rng) -> Option<Segment<S>> {
    Segment::new(vector::<S>(rng.point()), vector::<S>(rng.point())).ok()
}

fn segment_and_box<S: Coordinate>(rng: &mut Rng) -> Option<(Segment<S>, Aabb<S>)> {
    Some((segment(rng)?, ray_and_box(rng)?.1))
}

pub(crate) fn box_met<S: Coordinate>(rng: &mut Rng) -> Option<(Segment<S>, Aabb<S>)> {
    first(rng, segment_and_box, true, |segment, aabb| segment.overlaps(aabb))
}

pub(crate) fn box_missed<S: Coordinate>(rng: &mut Rng) -> Option<(Segment<S>, Aabb<S>)> {
    first(rng, segment_and_box, false, |segment, aabb| segment.overlaps(aabb))
}

/// The rotated cube.
fn turned_box<S: Coordinate>(rng: &mut Rng) -> Option<Obb<S>> {
    let (axes, half) = turned_axes(rng)?;
    Obb::from_skewed_axes(vector([0; 3]), axes, half).ok()
}

fn ray_and_obb<S: Coordinate>(rng: &mut Rng) -> Option<(Ray<S>, Obb<S>)> {
    Some((ray(rng.point(), rng.point())?, turned_box(rng)?))
}

pub(crate) fn obb_hit<S: Coordinate>(rng: &mut Rng) -> Option<(Ray<S>, Obb<S>)> {
    first(rng, ray_and_obb, true, |ray, obb| ray.overlaps(obb))
}

pub(crate) fn obb_miss<S: Coordinate>(rng: &mut Rng) -> Option<(Ray<S>, Obb<S>)> {
    first(rng, ray_and_obb, false, |ray, obb| ray.overlaps(obb))
}

fn segment_and_obb<S: Coordinate>(rng: &mut Rng) -> Option<(Segment<S>, Obb<S>)> {
    Some((segment(rng)?, turned_box(rng)?))
}

pub(crate) fn obb_met<S: Coordinate>(rng: &mut Rng) -> Option<(Segment<S>, Obb<S>)> {
    first(rng, segment_and_obb, true, |segment, obb| segment.overlaps(obb))
}

pub(crate) fn obb_missed<S: Coordinate>(rng: &mut Rng) -> Option<(Segment<S>, Obb<S>)> {
    first(rng, segment_and_obb, false, |segment, obb| segment.overlaps(obb))
}
