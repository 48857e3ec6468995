//! Hard cases from bug reports and tests of other libraries, with their numbers. The answers are
//! exact, and the oracle checks each. If a published answer differs, the reason is beside it.
//!
//! A segment is also tested as a ray, with t from 0 to 1 along the difference of its ends, rounded
//! in `f64`. Pairs of triangles are in `published_pairs`.

use septum_kit::flat::{Flat, FlatCase, Truth};
use septum_kit::rays::{RayCase, crossing};
use septum_kit::{BoxNumbers, Case, Sample, meets};

/// The answer to a case.
#[derive(Clone, Copy)]
enum Answer {
    /// As published.
    Yes,
    No,
    /// Not as published, with the reason.
    Differs(bool, &'static str),
}
use Answer::{Differs, No, Yes};

impl Answer {
    fn is_yes(self) -> bool {
        match self {
            Yes | Differs(true, _) => true,
            No | Differs(false, _) => false,
        }
    }

    /// Panics if an answer that differs has no reason.
    fn check(self, source: &str) {
        assert!(!matches!(self, Differs(_, why) if why.is_empty()), "{source}");
    }
}

type Point<S> = [S; 3];
type Corners<S> = [Point<S>; 3];
/// A source, a triangle, a box by its least and greatest corner.
type InBox<S> = (&'static str, Corners<S>, [Point<S>; 2], Answer);
/// A source, a triangle, an origin, a direction.
type OfRay<S> = (&'static str, Corners<S>, [Point<S>; 2], Answer);
/// A source, the ends of a segment.
type OfEnds = (&'static str, [Point<f64>; 2], Answer);

fn check_boxes<S: Sample>(table: &[InBox<S>]) {
    for &(source, vertices, [min, max], answer) in table {
        answer.check(source);
        let case = Case { vertices, aabb: BoxNumbers::Corners(min, max) };
        let (triangle, aabb) = case.shapes();
        assert_eq!(meets(&case), answer.is_yes(), "the oracle: {source}");
        assert_eq!(triangle.overlaps(&aabb), answer.is_yes(), "{source}");
        assert_eq!(aabb.overlaps(&triangle), answer.is_yes(), "{source}");
        assert!(triangle.may_overlap(&aabb) || !answer.is_yes(), "{source}");
    }
}

/// The answer of the oracle and of the crate, which must agree.
fn is_hit<S: Sample>(case: &RayCase<S>, source: &str) -> bool {
    let truth = crossing(case).is_some();
    assert_eq!(case.ray().is_hit(&case.triangle()), truth, "{source}: {case:?}");
    truth
}

fn check_rays<S: Sample>(table: &[OfRay<S>]) {
    for &(source, vertices, [origin, direction], answer) in table {
        answer.check(source);
        let case = RayCase::new(origin, direction, vertices);
        assert_eq!(is_hit(&case, source), answer.is_yes(), "{source}");
    }
}

/// From one end to the other.
fn segment([a, b]: [Point<f64>; 2], vertices: Corners<f64>) -> RayCase<f64> {
    let direction = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
    RayCase { t_max: Some(1.0), ..RayCase::new(a, direction, vertices) }
}

// LLNL/axom, `src/axom/primal/tests/primal_intersect.cpp`: its triangles, and the origin of its
// rays. A source "axom" names a test there.
const UNIT: Corners<f64> = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
const FAR: Point<f64> = [5.0; 3];
const WIDE: Corners<f64> = [[10.0, 0.0, 0.0], [-10.0, 0.0, 0.0], [0.0, 100.0, 0.0]];
const FROM_DATA: Corners<f64> =
    [[-31.015, 63.7756, 55.0043], [-29.0086, 59.2982, 58.0078], [-29.2009, 70.1039, 61.3229]];
const TRIANGLE_569: Corners<f64> =
    [[0.0, 5.0, 0.0], [-0.665356, 4.93844, -0.411212], [-0.665356, 4.93844, 0.411212]];
const FLAT: Corners<f64> = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

#[rustfmt::skip]
const BOXES: [InBox<f64>; 25] = [
    ("CGAL/cgal#6808", [[-34.1128, -4.00842, 39.5061], [-36.0938, -3.6615, 36.87], [-34.5781, -3.61804, 39.9716]],
        [[-52.3586, -14.3376, 25.3037], [-38.021, 0.0, 39.6414]], No),
    ("axom triangle_aabb_intersection, unitBB", UNIT, [[0.0; 3], [1.0; 3]], Yes),
    ("axom triangle_aabb_intersection, v0_BB", UNIT, [[1.0 - 0.1, -0.1, -0.1], [1.0 + 0.1, 0.1, 0.1]], Yes),
    ("axom triangle_aabb_intersection, v1_BB", UNIT, [[-0.1, 1.0 - 0.1, -0.1], [0.1, 1.0 + 0.1, 0.1]], Yes),
    ("axom triangle_aabb_intersection, v2_BB", UNIT, [[-0.1, -0.1, 1.0 - 0.1], [0.1, 0.1, 1.0 + 0.1]], Yes),
    ("axom triangle_aabb_intersection, mid_BB", UNIT, [[0.0; 3], [0.9; 3]], Yes),
    ("axom triangle_aabb_intersection, high_BB", UNIT, [[0.5; 3], [1.0; 3]], No),
    ("axom triangle_aabb_intersection, out_BB", UNIT, [[1.0; 3], [2.0; 3]], No),
    ("axom triangle_aabb_intersection, negBB", UNIT, [[-10.0; 3], [-5.0; 3]], No),
    ("axom triangle_aabb_intersection, bbOrigin", WIDE, [[-1.0; 3], [1.0; 3]], Yes),
    ("axom triangle_aabb_intersection, bbOrigin2", WIDE, [[0.0; 3], [0.0; 3]], Yes),
    ("axom triangle_aabb_intersection, bbAbove", WIDE, [[1.0; 3], [2.0; 3]], No),
    ("axom triangle_aabb_intersection, bbBelow", WIDE, [[-2.0; 3], [-1.0; 3]], No),
    ("axom triangle_aabb_intersection, bbPoint_OnTri", WIDE, [[0.0, 1.0, 0.0], [0.0, 1.0, 0.0]], Yes),
    ("axom triangle_aabb_intersection, bbPoint_OutsideTri", WIDE, [[1.0; 3], [1.0; 3]], No),
    ("axom triangle_aabb_intersection_fromData, box0", FROM_DATA, [[-39.2793, 46.3735, 53.3791], [-26.1692, 60.1549, 57.0148]], No),
    ("axom triangle_aabb_intersection_fromData, box1", FROM_DATA, [[-39.2793, 60.1549, 53.3791], [-26.1692, 73.9362, 57.0148]], Yes),
    ("axom triangle_aabb_intersection_fromData, box2", FROM_DATA, [[-39.2793, 46.3735, 57.0148], [-26.1692, 60.1549, 60.6506]], Yes),
    ("axom triangle_aabb_intersection_fromData, box3", FROM_DATA, [[-39.2793, 60.1549, 57.0148], [-26.1692, 73.9362, 60.6506]], Yes),
    ("axom triangle_aabb_intersection_fromData, box4", FROM_DATA, [[-39.2793, 46.3735, 60.6506], [-26.1692, 60.1549, 64.2863]], No),
    ("axom triangle_aabb_intersection_fromData, box5", FROM_DATA, [[-39.2793, 60.1549, 60.6506], [-26.1692, 73.9362, 64.2863]], Yes),
    ("axom triangle_aabb_intersection_fromData2, box0", TRIANGLE_569, [[0.0, 4.375, 0.0], [0.625, 5.0, 0.625]], Yes),
    ("axom triangle_aabb_intersection_fromData2, box1", TRIANGLE_569, [[-1.25, 4.375, -0.625], [-0.625, 5.0, 0.0]], Yes),
    ("axom triangle_aabb_intersection_fromData2, box2", TRIANGLE_569, [[-1.25, 4.375, 0.0], [-0.625, 5.0, 0.625]], Yes),
    ("axom triangle_aabb_intersection_fromData2, box3", TRIANGLE_569, [[0.0, 4.6875, 0.0], [0.3125, 5.0, 0.3125]], Yes),
];

#[rustfmt::skip]
const BOXES_F32: [InBox<f32>; 2] = [
    ("juj/MathGeoLib#51", [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [[-2.0; 3], [2.0; 3]], Yes),
    // A point beside a triangle, as a box without extent.
    ("libgdx/libgdx#6882", [[50.008057, 22.20586, 124.62208], [62.282288, 22.205864, 109.665924], [70.92052, 7.205861, 115.437805]],
        [[-5120.8345, 8946.126, -3270.5813], [-5120.8345, 8946.126, -3270.5813]], No),
];

/// 2·10⁻⁴, the side of a triangle with a small determinant.
const SMALL: f32 = 2e-4;
/// A quad of two triangles, and a ray through its diagonal.
const QUAD_RAY: [Point<f32>; 2] = [[0.0, 0.0, 10.0], [0.30458447, 0.30458447, -0.9024725]];
const DOWN: [Point<f32>; 2] = [[-59.95468, 1000.0, -59.95468], [0.0, -1.0, 0.0]];
const ASIDE: [Point<f32>; 2] = [[10.0, 20.0, 30.0], [0.0, -1.0, 0.0]];

#[rustfmt::skip]
const RAYS_F32: [OfRay<f32>; 9] = [
    ("libgdx/libgdx#3122", [[60.0, -30.0, 1182.0], [60.0, 0.0, 1206.0], [90.0, -30.0, 1174.0]],
        [[60.0, 0.0, 1206.0], [-0.70710677, 0.0, 0.70710677]], Yes),
    ("libgdx/libgdx#3147", [[90.0, -150.0, 1077.0], [90.0, -120.0, 1109.0], [120.0, -150.0, 1076.0]],
        [[90.0, -150.0, 1077.1], [-0.0, 0.99503726, 0.099503726]], Yes),
    ("libgdx/libgdx#4901, a segment", [[100.0, 200.0, 300.0], [400.0, 500.0, 600.0], [400.0, 500.0, 600.0]], ASIDE, No),
    ("libgdx/libgdx#4901, a point", [[0.0; 3]; 3], ASIDE, No),
    ("jbikker/tinybvh#283", [[0.0; 3], [SMALL, 0.0, 0.0], [0.0, SMALL, 0.0]],
        [[SMALL / 3.0, SMALL / 3.0, -1.0], [0.0, 0.0, 1.0]], Yes),
    ("Oblikovati/Oblikovati#2146, first", [[-5.0, -5.0, 0.0], [5.0, -5.0, 0.0], [5.0, 5.0, 0.0]], QUAD_RAY, Yes),
    ("Oblikovati/Oblikovati#2146, second", [[-5.0, -5.0, 0.0], [5.0, 5.0, 0.0], [-5.0, 5.0, 0.0]], QUAD_RAY, Yes),
    ("Selinux24/Skirmish#5, first", [[-58.68813, 9.74461e-7, -58.68813], [-58.68813, 0.0, -61.77698], [-61.77698, 0.0, -61.77698]], DOWN, Yes),
    ("Selinux24/Skirmish#5, second", [[-61.77698, 0.0, -58.68813], [-58.68813, 9.74461e-7, -58.68813], [-61.77698, 0.0, -61.77698]], DOWN, Yes),
];

/// A triangle whose lower edge a horizontal ray crosses.
const LEVEL: Corners<f64> = [
    [-1.3836679458618164, -4.480311870574951, 10.0],
    [3.9273109436035156, 5.897944450378418, 8.0],
    [-1.3836679458618164, -4.480311870574951, 8.0],
];
const ALONG: Point<f64> = [-0.16852837373762, 0.9856968028990217, 0.0];

#[rustfmt::skip]
const RAYS: [OfRay<f64>; 2] = [
    ("gkjohnson/three-mesh-bvh#684, first", LEVEL, [[-0.028221702575683627, -2.5058889150619503, 8.0], ALONG], Yes),
    ("gkjohnson/three-mesh-bvh#684, second", LEVEL, [[-0.028221702575683627, -2.5058889150619503 - 0.001, 8.0], ALONG], Yes),
];

const CENTRE: Point<f64> = [1.0 / 3.0; 3];

/// Rays of axom's `triangle_ray_intersection`, toward a point.
#[rustfmt::skip]
const TOWARDS: [OfRay<f64>; 20] = [
    ("clear miss", UNIT, [FAR, [6.0, 5.0, 5.0]], No),
    ("miss 1", UNIT, [FAR, [0.0, 1.0, 0.6]], No),
    ("miss 2", UNIT, [FAR, [0.0, 0.5, 0.6]], No),
    ("miss 3", UNIT, [FAR, [0.0, 0.85, 0.16]], No),
    ("miss 4", UNIT, [FAR, [0.4, 1.2, 0.0]], No),
    ("miss 5", UNIT, [FAR, [1.0, 0.000001, 0.0]], No),
    ("miss 6", UNIT, [FAR, [0.4, 0.0, 0.7]], No),
    ("edge hit 1", UNIT, [FAR, [1.0, 0.0, 0.0]], Yes),
    ("edge hit 2", UNIT, [FAR, [0.0, 1.0, 0.0]], Yes),
    ("edge hit 3", UNIT, [FAR, [0.0, 0.0, 1.0]], Yes),
    ("edge hit 4", UNIT, [FAR, [0.0, 0.7, 0.3]], Yes),
    ("edge hit 5", UNIT, [FAR, [0.7, 0.3, 0.0]], Yes),
    ("edge hit 6", UNIT, [[0.0; 3], [0.2, 0.0, 0.8]], Yes),
    ("hit 1", UNIT, [FAR, [0.2, 0.0, 0.2]], Yes),
    ("hit 2", UNIT, [FAR, [0.0; 3]], Yes),
    ("hit 3", UNIT, [FAR, [0.1, 0.6, 0.0]], Yes),
    ("coplanar miss", UNIT, [[-0.1, 1.1, 0.0], [-0.1, 0.0, 1.1]], No),
    // Rays in the plane of the triangle miss it in both libraries.
    ("coplanar intersection", FLAT, [[1.0, 0.5, 0.0], [-1.0, 0.5, 0.0]], No),
    ("coplanar interior ray origin", UNIT, [CENTRE, [0.5, 0.0, 0.5]],
        Differs(true, "a third is rounded: the ray is not in the plane, and comes to it on an edge")),
    ("non-coplanar interior ray origin", FLAT, [[0.2, 0.18, 0.0], [0.0, 0.0, 0.5]],
        Differs(true, "a miss by design there; here the origin belongs to the ray")),
];

/// Segments of axom's `triangle_segment_intersection`, each in both directions.
#[rustfmt::skip]
const SEGMENTS: [OfEnds; 18] = [
    ("clear miss", [FAR, [6.0, 5.0, 5.0]], No),
    ("miss 2", [FAR, [0.0, 0.5, 0.6]], No),
    ("miss 3", [FAR, [0.0, 0.85, 0.16]], No),
    ("miss 4", [FAR, [0.4, 1.2, 0.0]], No),
    ("miss 5", [FAR, [1.0, 0.000001, 0.0]], No),
    ("miss 6", [FAR, [0.4, 0.0, 0.7]], No),
    ("miss 7", [FAR, [0.3, 0.4, 0.5]], No),
    ("miss 8", [FAR, [0.4, 0.4, 0.4]], No),
    ("hit 1", [FAR, [0.78, -0.2, -0.2]], Yes),
    ("hit 2", [FAR, [0.4, 0.3, 0.2]], Yes),
    ("hit 3", [FAR, [0.2, 0.2, 0.2]], Yes),
    ("shy of corner", [[1.0, 0.1, 0.1], [1.0; 3]], No),
    ("beyond corner", [[1.0, -0.1, -0.1], [1.0; 3]], Yes),
    ("beyond corner 2", [[1.0, -0.1, -0.1], [1.0, 0.0, 0.0]], Yes),
    ("shy of edge", [[0.0, 0.4, 0.7], [0.0, 1.0, 1.0]], No),
    ("beyond edge", [[0.0, 0.6, 0.3], [0.0, 1.0, 1.0]], Yes),
    ("segment endpoint 1", [[0.0, 1.0, 1.0], CENTRE], Yes),
    ("segment endpoint 2", [CENTRE, FAR], Yes),
];

#[test]
fn triangles_and_boxes() {
    check_boxes(&BOXES);
    check_boxes(&BOXES_F32);
}

#[test]
fn rays_and_triangles() {
    check_rays(&RAYS_F32);
    check_rays(&RAYS);
    for (source, vertices, [origin, to], answer) in TOWARDS {
        answer.check(source);
        let case = RayCase { t_max: None, ..segment([origin, to], vertices) };
        assert_eq!(is_hit(&case, source), answer.is_yes(), "{source}");
    }
}

#[test]
fn segments_and_triangles() {
    for (source, [a, b], answer) in SEGMENTS {
        answer.check(source);
        for ends in [[a, b], [b, a]] {
            assert_eq!(is_hit(&segment(ends, UNIT), source), answer.is_yes(), "{source}: {ends:?}");
            let case = FlatCase { flat: Flat::Ends(ends), triangle: UNIT };
            assert_eq!(case.check() != Truth::Apart, answer.is_yes(), "{source}: {ends:?}");
        }
    }
}
