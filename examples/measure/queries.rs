//! The queries, and their lines of output.

use core::hint::black_box;

use fixed::types::I16F16;
use heapless::Vec;
use septum::contact::{contact, least_translation};
use septum::near::Near;
use septum::polygon::Polygon;
use septum::published;
use septum::published::akenine_moller::{self, Order};
use septum::published::slabs::SlabRay;
use septum::published::slopes::SlopeRay;
use septum::relation::{Relate, Relation};
use septum::sweep::Sweep;
use septum::{Aabb, Capsule, Cull, Obb, Ray, Segment, Sphere, Triangle, Vec3};

use crate::CORE;
use crate::firmware::say;
use crate::meter::{Ask, Meter, Taken};
use crate::moving::{self, Moving};
use crate::workload::{self, Coordinate, Draw, Rng};

/// The number of pairs of shapes in a path, and in a batch.
const CASES: usize = 256;
const BATCH: usize = 32;
/// No further cases run after this many instructions. Such long queries vary little.
const ENOUGH: u64 = 10_000_000;

/// Measures all queries in a scalar.
pub(crate) fn all<S: Coordinate>(meter: &Meter) {
    triangle_aabb::<S>(meter);
    triangle_obb::<S>(meter);
    polygon_aabb::<S>(meter);
    pairs::<S>(meter);
    spheres::<S>(meter);
    relations::<S>(meter);
    lines_obb::<S>(meter);
    sweeps::<S>(meter);
    contacts::<S>(meter);
    ray_triangle::<S>(meter);
    ray_aabb::<S>(meter);
}

/// A query: its name, its mode, and a function that runs it.
type Query<A, B> = (&'static str, &'static str, Ask<A, B>);

fn triangle_aabb<S: Coordinate>(meter: &Meter) {
    const NAME: &str = "triangle/box";
    let queries: [Query<Triangle<S>, Aabb<S>>; 4] = [
        (NAME, "exact", |t, b| t.overlaps(b)),
        (NAME, "conservative", |t, b| t.may_overlap(b)),
        (NAME, "rounded", |t, b| published::shared_normal::overlaps(t, b)),
        (NAME, "as published", |t, b| published::akenine_moller::overlaps(t, b)),
    ];
    lines::<S, _, _>(meter, "full", workload::full, &queries);
    lines::<S, _, _>(meter, "voorhies", workload::voorhies, &queries);
    lines::<S, _, _>(meter, "grid", workload::grid, &queries);
    lines::<S, _, _>(meter, "whole range", workload::whole_range, &queries);
}

/// The test as published with its groups of axes in every order, by the paper's numbers: 1, the
/// faces; 2, the normal; 3, the cross products.
pub(crate) fn orders<S: Coordinate>(meter: &Meter) {
    const NAME: &str = "order of axes";
    use akenine_moller::overlaps_in;
    let queries: [Query<Triangle<S>, Aabb<S>>; 6] = [
        (NAME, "3-1-2", |t, b| overlaps_in(t, b, Order::EdgesFacesNormal)),
        (NAME, "3-2-1", |t, b| overlaps_in(t, b, Order::EdgesNormalFaces)),
        (NAME, "1-3-2", |t, b| overlaps_in(t, b, Order::FacesEdgesNormal)),
        (NAME, "1-2-3", |t, b| overlaps_in(t, b, Order::FacesNormalEdges)),
        (NAME, "2-3-1", |t, b| overlaps_in(t, b, Order::NormalEdgesFaces)),
        (NAME, "2-1-3", |t, b| overlaps_in(t, b, Order::NormalFacesEdges)),
    ];
    lines::<S, _, _>(meter, "voorhies", workload::voorhies, &queries);
    lines::<S, _, _>(meter, "grid", workload::grid, &queries);
}

fn triangle_obb<S: Coordinate>(meter: &Meter) {
    const NAME: &str = "triangle/oriented box";
    let queries: [Query<Triangle<S>, Obb<S>>; 3] = [
        (NAME, "exact", |t, b| t.overlaps(b)),
        (NAME, "conservative", |t, b| t.may_overlap(b)),
        (NAME, "as published", |t, b| published::akenine_moller::overlaps_obb(t, b)),
    ];
    lines::<S, _, _>(meter, "full", workload::turned_full, &queries);
    lines::<S, _, _>(meter, "voorhies", workload::turned_voorhies, &queries);

    let queries: [Query<[Vec3<S>; 3], Vec3<S>>; 4] = [
        ("oriented box", "new", |u, half| black_box(Obb::new(*half, *u, *half)).is_ok()),
        ("oriented box", "from skewed axes", |u, half| {
            black_box(Obb::from_skewed_axes(*half, *u, *half)).is_ok()
        }),
        ("oriented box", "from a quaternion", |[u, ..], half| {
            black_box(Obb::from_quaternion(*half, [u.x, u.y, u.z, S::ZERO], *half)).is_ok()
        }),
        ("oriented box", "from turns", |[u, ..], half| {
            black_box(Obb::from_turns(*half, *u, *half)).is_ok()
        }),
    ];
    lines::<S, _, _>(meter, "made", workload::turned_axes, &queries);
}

fn polygon_aabb<S: Coordinate>(meter: &Meter) {
    const NAME: &str = "polygon/box";
    let queries: [Query<[Vec3<S>; 5], Aabb<S>>; 2] = [
        (NAME, "exact", |p, b| Polygon::new(p).is_ok_and(|p| p.overlaps(b))),
        (NAME, "as published", |p, b| {
            Polygon::new(p).is_ok_and(|p| published::green_hatch::overlaps(&p, b))
        }),
    ];
    lines::<S, _, _>(meter, "pentagons", workload::pentagons, &queries);
}

/// Two triangles, and two oriented boxes.
fn pairs<S: Coordinate>(meter: &Meter) {
    let triangles: [Query<Triangle<S>, Triangle<S>>; 2] = [
        ("triangle/triangle", "exact", |t, u| t.overlaps(u)),
        ("triangle/triangle", "conservative", |t, u| t.may_overlap(u)),
    ];
    lines::<S, _, _>(meter, "full", workload::meeting_triangles, &triangles);
    lines::<S, _, _>(meter, "random", workload::triangles, &triangles);
    let obbs: [Query<Obb<S>, Obb<S>>; 2] = [
        ("oriented box/oriented box", "exact", |b, c| b.overlaps(c)),
        ("oriented box/oriented box", "conservative", |b, c| b.may_overlap(c)),
    ];
    lines::<S, _, _>(meter, "full", workload::meeting_obbs, &obbs);
    lines::<S, _, _>(meter, "random", workload::obbs, &obbs);
}

fn spheres<S: Coordinate>(meter: &Meter) {
    let queries: [Query<Triangle<S>, Sphere<S>>; 1] =
        [("sphere/triangle", "exact", |t, b| b.overlaps(t))];
    lines::<S, _, _>(meter, "full", workload::meeting_sphere, &queries);
    lines::<S, _, _>(meter, "random", workload::sphere, &queries);
}

/// Longer queries about distances.
pub(crate) fn distances<S: Coordinate>(meter: &Meter) {
    let queries: [Query<Triangle<S>, Capsule<S>>; 1] =
        [("capsule/triangle", "exact", |t, b| b.overlaps(t))];
    lines::<S, _, _>(meter, "full", workload::meeting_capsule, &queries);
    lines::<S, _, _>(meter, "random", workload::capsule, &queries);
    let queries: [Query<Triangle<S>, Sphere<S>>; 1] =
        [("triangle closest point", "exact", |t, b| {
            black_box(t.closest_point(b.center())).is_ok()
        })];
    lines::<S, _, _>(meter, "random", workload::sphere, &queries);
    let queries: [Query<Triangle<S>, Sphere<S>>; 1] =
        [("sphere/triangle contact", "points", |t, b| contact(b, t).is_some())];
    lines::<S, _, _>(meter, "full", workload::meeting_sphere, &queries);
    let queries: [Query<Triangle<S>, Capsule<S>>; 1] =
        [("capsule/triangle contact", "points", |t, b| contact(b, t).is_some())];
    lines::<S, _, _>(meter, "full", workload::meeting_capsule, &queries);
    type Past<S> = Query<Moving<S, Sphere<S>>, Triangle<S>>;
    let queries: [Past<S>; 2] = [
        ("sphere/triangle sweep", "whether", |m, t| m.shape.meets_along(&m.motion, t)),
        ("sphere/triangle sweep", "when", |m, t| m.shape.first_contact(&m.motion, t).is_some()),
    ];
    lines::<S, _, _>(meter, "hit", moving::ball_hits, &queries);
    lines::<S, _, _>(meter, "miss", moving::ball_misses, &queries);
    let queries: [Query<Ray<S>, Sphere<S>>; 1] =
        [("ray/sphere", "t_range", |r, b| r.t_range_sphere(b).is_some())];
    lines::<S, _, _>(meter, "hit", workload::sphere_hit, &queries);
    let queries: [Query<Ray<S>, Capsule<S>>; 1] =
        [("ray/capsule", "t_range", |r, b| r.t_range_capsule(b).is_some())];
    lines::<S, _, _>(meter, "hit", workload::capsule_hit, &queries);
}

/// The pairs of a workload as shapes near the origin.
macro_rules! near {
    ($draw:expr) => {
        |rng| {
            let (one, other) = $draw(rng)?;
            Some((one.near().ok()?, other.near().ok()?))
        }
    };
}

/// Rays and segments near the origin, against boxes.
pub(crate) fn near(meter: &Meter) {
    type S = I16F16;
    type Close<A, B> = Query<Near<A>, Near<B>>;
    let rays: [Close<Ray<S>, Aabb<S>>; 1] = [("ray/box", "near", |r, b| r.overlaps(b))];
    lines::<S, _, _>(meter, "hit", near!(workload::box_hit), &rays);
    lines::<S, _, _>(meter, "miss", near!(workload::box_miss), &rays);
    let segments: [Close<Segment<S>, Aabb<S>>; 2] = [
        ("segment/box", "near", |s, b| s.overlaps(b)),
        ("segment/box", "exact", |s, b| s.get().overlaps(b.get())),
    ];
    lines::<S, _, _>(meter, "hit", near!(workload::box_met), &segments);
    lines::<S, _, _>(meter, "miss", near!(workload::box_missed), &segments);
    let segments: [Close<Segment<S>, Obb<S>>; 1] =
        [("segment/oriented box", "near", |s, b| s.overlaps(b))];
    lines::<S, _, _>(meter, "hit", near!(workload::obb_met), &segments);
    lines::<S, _, _>(meter, "miss", near!(workload::obb_missed), &segments);
}

/// Whether shapes are disjoint, touch or overlap.
fn relations<S: Coordinate>(meter: &Meter) {
    let aabb: [Query<Triangle<S>, Aabb<S>>; 1] =
        [("triangle/box relation", "exact", |t, b| t.relation(b) != Relation::Disjoint)];
    lines::<S, _, _>(meter, "full", workload::full, &aabb);
    lines::<S, _, _>(meter, "grid", workload::grid, &aabb);
    let obb: [Query<Triangle<S>, Obb<S>>; 1] =
        [("triangle/oriented box relation", "exact", |t, b| t.relation(b) != Relation::Disjoint)];
    lines::<S, _, _>(meter, "full", workload::turned_full, &obb);
    lines::<S, _, _>(meter, "voorhies", workload::turned_voorhies, &obb);
}

/// Rays and segments against oriented boxes.
fn lines_obb<S: Coordinate>(meter: &Meter) {
    let rays: [Query<Ray<S>, Obb<S>>; 2] = [
        ("ray/oriented box", "exact", |r, b| r.overlaps(b)),
        ("ray/oriented box", "conservative", |r, b| r.may_overlap(b)),
    ];
    lines::<S, _, _>(meter, "hit", workload::obb_hit, &rays);
    lines::<S, _, _>(meter, "miss", workload::obb_miss, &rays);
    let segments: [Query<Segment<S>, Obb<S>>; 2] = [
        ("segment/oriented box", "exact", |s, b| s.overlaps(b)),
        ("segment/oriented box", "conservative", |s, b| s.may_overlap(b)),
    ];
    lines::<S, _, _>(meter, "hit", workload::obb_met, &segments);
    lines::<S, _, _>(meter, "miss", workload::obb_missed, &segments);
}

/// Shapes that move past a box.
fn sweeps<S: Coordinate>(meter: &Meter) {
    type Past<S, Shape> = Query<Moving<S, Shape>, Aabb<S>>;
    let triangles: [Past<S, Triangle<S>>; 2] = [
        ("triangle/box sweep", "whether", |m, b| m.shape.meets_along(&m.motion, b)),
        ("triangle/box sweep", "when", |m, b| {
            black_box(m.shape.first_contact(&m.motion, b)).is_some()
        }),
    ];
    lines::<S, _, _>(meter, "hit", moving::triangle_hits, &triangles);
    lines::<S, _, _>(meter, "miss", moving::triangle_misses, &triangles);
    let boxes: [Past<S, Aabb<S>>; 2] = [
        ("box/box sweep", "whether", |m, b| m.shape.meets_along(&m.motion, b)),
        ("box/box sweep", "when", |m, b| black_box(m.shape.first_contact(&m.motion, b)).is_some()),
    ];
    lines::<S, _, _>(meter, "hit", moving::cube_hits, &boxes);
    lines::<S, _, _>(meter, "miss", moving::cube_misses, &boxes);
}

/// The minimum translation, and the contact points.
fn contacts<S: Coordinate>(meter: &Meter) {
    let aabb: [Query<Triangle<S>, Aabb<S>>; 2] = [
        ("triangle/box contact", "translation", |t, b| {
            black_box(least_translation(t, b)).is_some()
        }),
        ("triangle/box contact", "points too", |t, b| black_box(contact(t, b)).is_some()),
    ];
    lines::<S, _, _>(meter, "full", workload::full, &aabb);
    lines::<S, _, _>(meter, "grid", workload::grid, &aabb);
    let obbs: [Query<Obb<S>, Obb<S>>; 2] = [
        ("oriented box/oriented box contact", "translation", |b, c| {
            black_box(least_translation(b, c)).is_some()
        }),
        ("oriented box/oriented box contact", "points too", |b, c| {
            black_box(contact(b, c)).is_some()
        }),
    ];
    lines::<S, _, _>(meter, "full", workload::meeting_obbs, &obbs);
    lines::<S, _, _>(meter, "random", workload::obbs, &obbs);
}

fn ray_triangle<S: Coordinate>(meter: &Meter) {
    // `black_box` uses the whole hit, not only whether there is one.
    let queries: [Query<Ray<S>, Triangle<S>>; 4] = [
        ("ray/triangle hits", "exact", |r, t| r.is_hit(t)),
        ("ray/triangle hit", "exact", |r, t| black_box(r.hit(t)).is_some()),
        ("ray/triangle hit once", "exact", |r, t| black_box(r.hit_once(t)).is_some()),
        ("ray/triangle hit", "as published", |r, t| {
            black_box(published::moller_trumbore::hit(r, t, Cull::Nothing)).is_some()
        }),
    ];
    lines::<S, _, _>(meter, "hit", workload::hit, &queries);
    lines::<S, _, _>(meter, "miss", workload::miss, &queries);
}

fn ray_aabb<S: Coordinate>(meter: &Meter) {
    const NAME: &str = "ray/box";
    let queries: [Query<Ray<S>, Aabb<S>>; 3] = [
        (NAME, "exact", |r, b| r.overlaps(b)),
        (NAME, "conservative", |r, b| r.may_overlap(b)),
        (NAME, "as published", |r, b| published::separating_axes::ray_overlaps(r, b)),
    ];
    lines::<S, _, _>(meter, "hit", workload::box_hit, &queries);
    lines::<S, _, _>(meter, "miss", workload::box_miss, &queries);

    // Rays prepared for a method.
    let slabs: [Query<SlabRay<S>, Aabb<S>>; 1] = [(NAME, "slabs", |r, b| r.overlaps_rounded(b))];
    lines::<S, _, _>(meter, "hit", |r| prepared(r, true, SlabRay::new), &slabs);
    lines::<S, _, _>(meter, "miss", |r| prepared(r, false, SlabRay::new), &slabs);
    let slopes: [Query<SlopeRay<S>, Aabb<S>>; 1] = [(NAME, "slopes", |r, b| r.overlaps_rounded(b))];
    lines::<S, _, _>(meter, "hit", |r| prepared(r, true, SlopeRay::new), &slopes);
    lines::<S, _, _>(meter, "miss", |r| prepared(r, false, SlopeRay::new), &slopes);
}

fn prepared<S: Coordinate, R>(
    rng: &mut Rng,
    hit: bool,
    prepare: fn(&Ray<S>) -> R,
) -> Option<(R, Aabb<S>)> {
    let (ray, aabb) = if hit { workload::box_hit(rng) } else { workload::box_miss(rng) }?;
    Some((prepare(&ray), aabb))
}

/// Measures the queries on one path, and prints a line for each.
fn lines<S: Coordinate, A, B>(
    meter: &Meter,
    path: &str,
    draw: Draw<A, B>,
    queries: &[Query<A, B>],
) {
    let mut rng = Rng::new();
    let mut taken = [Taken::default(); 6];
    for _ in 0..CASES / BATCH {
        let mut pairs = Vec::<_, BATCH>::new();
        while let (false, Some(pair)) = (pairs.is_full(), draw(&mut rng)) {
            // There is room: the loop has just checked.
            let _ = pairs.push(pair);
        }
        if pairs.is_empty() {
            return;
        }
        for (&(_, _, ask), taken) in queries.iter().zip(&mut taken) {
            meter.add(taken, &pairs, ask);
        }
        if taken.iter().any(|taken| taken.total() > ENOUGH) {
            break;
        }
    }
    for (&(query, mode, _), taken) in queries.iter().zip(&taken) {
        let (instructions, stack) = (taken.instructions(), taken.stack() as u32);
        say!("{},{},{},{},{},{},{}", CORE, query, S::NAME, mode, path, instructions, stack);
    }
}
