//! A fixed stream of questions, and a hash of all their answers.
//!
//! Nothing here may depend on the machine: numbers are made from bits, floats
//! with no more than exact scaling, and no library is asked.

use septum::{Aabb, Axis, Cull, Feature, Hit, Obb, Plane, Ray, Scalar, Segment, Side, Triangle};
use septum::{Aabbs, Facing, Hits, NormalTriangles, Ranges, Rays, SlabRays, Triangles, Vec3};

use super::draw::{Draw, Rng};

/// FNV-1a, 64 bits (Fowler, Noll, Vo).
struct Hash(u64);

impl Hash {
    fn byte(&mut self, byte: u8) {
        self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    }

    fn yes(&mut self, answer: bool) {
        self.byte(answer.into());
    }

    fn number<S: Draw>(&mut self, x: S) {
        x.bits().to_le_bytes().into_iter().for_each(|byte| self.byte(byte));
    }

    fn range<S: Draw>(&mut self, range: Option<(S, S)>) {
        self.yes(range.is_some());
        if let Some((from, to)) = range {
            self.number(from);
            self.number(to);
        }
    }

    fn axis(&mut self, axis: Option<Axis>) {
        self.byte(match axis {
            None => 0,
            Some(Axis::Face(i)) => 1 + i,
            Some(Axis::Normal) => 4,
            Some(Axis::Edge { axis, edge }) => 5 + 3 * axis + edge,
        });
    }

    fn hit<S: Draw>(&mut self, hit: Option<Hit<S>>) {
        let Some(hit) = hit else { return self.byte(0) };
        self.byte(match hit.facing {
            Facing::Front => 1,
            Facing::Back => 2,
        });
        self.byte(match hit.feature {
            Feature::Interior => 0,
            Feature::Edge(k) => 1 + k,
            Feature::Vertex(k) => 4 + k,
        });
        self.number(hit.t);
        self.number(hit.u);
        self.number(hit.v);
    }
}

/// The answers of four lanes.
impl Hash {
    fn hits<S: Draw>(&mut self, hits: &Hits<S, 4>) {
        (0..4).for_each(|k| self.hit(hits.get(k)));
    }

    fn ranges<S: Draw>(&mut self, ranges: &Ranges<S, 4>) {
        (0..4).for_each(|k| self.range(ranges.get(k)));
    }
}

/// How many cases there are for a scalar.
pub(crate) const CASES: u32 = 1000;

/// The hash of all answers about `cases` cases in this scalar.
pub(crate) fn hash<S: Draw>(cases: u32) -> u64 {
    let mut rng = Rng::new(0x5e97_0a11);
    let mut hash = Hash(0xcbf2_9ce4_8422_2325);
    for _ in 0..cases {
        case::<S>(&mut rng, &mut hash);
    }
    hash.0
}

/// One triangle against a box of each kind, the boxes against a plane, a segment
/// and a ray.
#[inline(never)]
fn case<S: Draw>(rng: &mut Rng, hash: &mut Hash) {
    let kind = rng.below(6) as u8;
    let point = |rng: &mut Rng| Vec3::from([(); 3].map(|()| S::draw(rng, kind)));
    let [a, b, c, p, q, d, n, o] = [(); 8].map(|()| point(rng));
    let triangle = Triangle::new(a, b, if rng.below(8) == 0 { a } else { c });
    let half = Vec3::new(q.x.size(), q.y.size(), q.z.size());
    let corners = Aabb::from_min_max(least(p, q), greatest(p, q));
    // What is drawn is finite, and there are no negative half-extents.
    let (Ok(triangle), Ok(centered), Ok(corners)) =
        (triangle, Aabb::from_center_half_extents(p, half), corners)
    else {
        return hash.byte(0xff);
    };
    for aabb in [&centered, &corners] {
        boxes(&triangle, aabb, hash);
        if let Ok(plane) = Plane::from_point_normal(o, n) {
            sides(&plane, aabb, hash);
        }
        if let Ok(plane) = Plane::from_equation(n, o.x) {
            sides(&plane, aabb, hash);
        }
        for segment in [Segment::new(o, d), Segment::from_center_half_vector(o, d)] {
            let Ok(segment) = segment else { continue };
            hash.yes(segment.overlaps(aabb));
            hash.yes(segment.may_overlap(aabb));
        }
    }
    let axes = if rng.below(2) == 0 { [d, n, o] } else { [d, p, n] };
    if let Ok(obb) = Obb::from_skewed_axes(p, axes, half) {
        hash.yes(triangle.overlaps(&obb));
        hash.yes(triangle.may_overlap(&obb));
        hash.yes(triangle.overlaps_by_transform(&obb));
    }
    // At the triangle, or anywhere.
    let direction = if rng.below(3) == 0 { d } else { towards(o, &triangle) };
    if let Ok(ray) = Ray::new(o, direction) {
        crossings(&ray, &triangle, [&centered, &corners], hash);
        lanes(&ray, &triangle, [&centered, &corners], hash);
    }
}

#[inline(never)]
fn boxes<S: Draw>(triangle: &Triangle<S>, aabb: &Aabb<S>, hash: &mut Hash) {
    hash.yes(triangle.overlaps(aabb));
    hash.yes(triangle.may_overlap(aabb));
    hash.yes(triangle.overlaps_rounded(aabb));
    hash.yes(triangle.overlaps_as_published(aabb));
    hash.axis(triangle.separating_axis(aabb));
    for axis in Axis::ALL {
        hash.yes(triangle.is_separated_by(aabb, axis));
    }
}

#[inline(never)]
fn sides<S: Draw>(plane: &Plane<S>, aabb: &Aabb<S>, hash: &mut Hash) {
    hash.yes(plane.overlaps(aabb));
    hash.byte(match plane.side_of(aabb) {
        Side::Front => 0,
        Side::Back => 1,
        Side::Both => 2,
    });
}

#[inline(never)]
fn crossings<S: Draw>(ray: &Ray<S>, triangle: &Triangle<S>, aabbs: [&Aabb<S>; 2], hash: &mut Hash) {
    hash.hit(ray.hit(triangle));
    hash.hit(ray.hit_once(triangle));
    hash.yes(ray.hits(triangle));
    hash.hit(ray.hit_moller_trumbore(triangle, Cull::Nothing));
    hash.hit(ray.hit_volumes(triangle, Cull::Nothing));
    hash.hit(ray.hit_stored_normal(&triangle.with_normal(), Cull::Back));
    hash.hit(ray.hit_projected(&triangle.projected(), Cull::Front));
    hash.hit(ray.sheared().hit(triangle, Cull::Nothing));
    let (slabs, slopes) = (ray.for_slabs(), ray.for_slopes());
    for aabb in aabbs {
        hash.yes(ray.overlaps(aabb));
        hash.yes(ray.may_overlap(aabb));
        hash.range(ray.t_range(aabb));
        hash.range(slabs.t_range_rounded(aabb));
        hash.yes(slabs.may_overlap(aabb));
        hash.yes(slopes.overlaps_rounded(aabb));
    }
}

/// Four at once: the triangle and itself with its vertices moved on, the ray and itself
/// with its ends exchanged. These are the loops that become vector instructions.
#[inline(never)]
fn lanes<S: Draw>(ray: &Ray<S>, triangle: &Triangle<S>, aabbs: [&Aabb<S>; 2], hash: &mut Hash) {
    let [a, b, c] = *triangle.vertices();
    let turned = [[a, b, c], [b, c, a], [c, a, b], [b, a, c]];
    let Ok(back) = Ray::new(ray.direction(), ray.origin()) else { return hash.byte(0xfe) };
    let rays = [ray, &back, &back, ray].map(Clone::clone);
    let triangles = turned.map(|[a, b, c]| Triangle::new(a, b, c).unwrap_or(*triangle));
    let (by_normal, by_slabs) = (triangles.map(|t| t.with_normal()), rays.map(|r| r.for_slabs()));
    let triangles = Triangles::new(&triangles);
    hash.hits(&ray.hit_each(&triangles));
    hash.hits(&ray.hit_each_moller_trumbore(&triangles, Cull::Nothing));
    hash.hits(&ray.hit_each_volumes(&triangles, Cull::Back));
    hash.hits(&ray.hit_each_stored_normal(&NormalTriangles::new(&by_normal), Cull::Nothing));
    hash.hits(&ray.sheared().hit_each(&triangles, Cull::Nothing));
    hash.hits(&Rays::new(&rays).hit_volumes(triangle, Cull::Front));
    let slabs = SlabRays::new(&by_slabs);
    for aabb in aabbs {
        hash.ranges(&slabs.t_range_rounded(aabb));
    }
    let [p, q] = aabbs;
    if let Some(aabbs) = Aabbs::new(&[*p, *q, *q, *p]) {
        hash.ranges(&ray.for_slabs().t_range_each_rounded(&aabbs));
    }
}

/// From a point to the middle of the triangle, or not far from it.
fn towards<S: Draw>(p: Vec3<S>, triangle: &Triangle<S>) -> Vec3<S> {
    let [a, b, c] = *triangle.vertices();
    let to = |p: S, a: S, b: S, c: S| a.middle(b).middle(c).minus(p);
    Vec3::new(to(p.x, a.x, b.x, c.x), to(p.y, a.y, b.y, c.y), to(p.z, a.z, b.z, c.z))
}

fn least<S: Scalar>(p: Vec3<S>, q: Vec3<S>) -> Vec3<S> {
    let low = |p: S, q: S| if q < p { q } else { p };
    Vec3::new(low(p.x, q.x), low(p.y, q.y), low(p.z, q.z))
}

fn greatest<S: Scalar>(p: Vec3<S>, q: Vec3<S>) -> Vec3<S> {
    let high = |p: S, q: S| if q < p { p } else { q };
    Vec3::new(high(p.x, q.x), high(p.y, q.y), high(p.z, q.z))
}
