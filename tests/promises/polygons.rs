//! A polygon against an axis-aligned box: exact.

use septum::polygon::Polygon;
use septum::published::green_hatch;
use septum::{Aabb, Segment, ShapeError, Triangle, Vec3};
use septum_kit::polygons::{PlanePolygon, PolygonCase, PolygonSet};
use septum_kit::{Each, Rng, Sample, for_every_scalar, not_finite, three};

/// All sets; counts the overlaps of each.
fn agrees_on_every_set<S: Sample>(count: usize) {
    for set in PolygonSet::all() {
        let cases = set.cases::<S>(0x9017, count);
        let met = cases.iter().filter(|case| case.check()).count();
        println!("{:7} {set:?}: {met} of {count} meet", S::name());
        let fits = !matches!(set, PolygonSet::More(set) if set.misfit::<S>().is_some());
        assert!(!fits || (count / 40..count).contains(&met), "{set:?}: {met} of {count} meet");
    }
}

fn agrees_with_clipping<S: Sample>() {
    agrees_on_every_set::<S>(1_500);
}
for_every_scalar!(agrees_with_clipping);

/// More than two million in each scalar:
/// `cargo test --release --test promises polygons -- --ignored --nocapture`.
#[test]
#[ignore = "takes minutes"]
fn agrees_with_clipping_on_many() {
    use septum_kit::fixed::types::{I4F4, I8F8, I16F16, I32F32};
    const COUNT: usize = 200_000;
    agrees_on_every_set::<f32>(COUNT);
    agrees_on_every_set::<f64>(COUNT);
    agrees_on_every_set::<I4F4>(COUNT);
    agrees_on_every_set::<I8F8>(COUNT);
    agrees_on_every_set::<I16F16>(COUNT);
    agrees_on_every_set::<I32F32>(COUNT);
}

/// A convex planar polygon equals its fan, whichever vertex comes first: compared with clipping it
/// as a whole.
fn a_plane_convex_polygon_is_its_fan<S: Sample>() {
    let mut rng = Rng::new(0xfa2);
    let mut met = 0;
    for n in 0..1_000 {
        let polygon = PlanePolygon::random::<S>(&mut rng);
        let truth = polygon.meets();
        met += usize::from(truth);
        let mut case: PolygonCase<S> = polygon.case(n % 2 == 0);
        for _ in 0..case.vertices.len() {
            assert_eq!(case.answers(), [truth; 4], "{}: {case:?}", S::name());
            case.vertices.rotate_left(1);
        }
        case.vertices.reverse();
        assert_eq!(case.answers(), [truth; 4], "{}: {case:?}", S::name());
    }
    assert!((100..900).contains(&met), "{met}");
}
for_every_scalar!(a_plane_convex_polygon_is_its_fan);

/// With three vertices the answer is the triangle's.
#[test]
fn three_vertices_are_a_triangle() {
    for set in PolygonSet::all() {
        for case in set.cases::<f32>(3, 500) {
            let vertices: Vec<_> = case.vertices.iter().map(|v| Vec3::from(*v)).collect();
            let polygon = Polygon::new(&vertices[..3]).unwrap();
            let triangle = Triangle::new(vertices[0], vertices[1], vertices[2]).unwrap();
            let aabb = case.aabb.shape().unwrap();
            assert_eq!(polygon.overlaps(&aabb), triangle.overlaps(&aabb), "{case:?}");
            assert_eq!(polygon.triangles().collect::<Vec<_>>(), [triangle]);
        }
    }
}

#[test]
fn what_is_no_polygon_is_refused() {
    let v = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].each(Vec3::from);
    for n in 0..3 {
        assert_eq!(Polygon::<f64>::new(&v[..n]), Err(ShapeError::TooFewVertices));
    }
    for n in 3..=4 {
        let polygon = Polygon::new(&v[..n]).unwrap();
        assert_eq!((polygon.vertices(), polygon.triangles().len()), (&v[..n], n - 2));
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for k in 0..12 {
            let mut v = v;
            let v_k = &mut v[k / 3];
            *[&mut v_k.x, &mut v_k.y, &mut v_k.z][k % 3] = bad;
            assert_eq!(Polygon::new(&v), Err(not_finite("vertices", Some(k / 3))), "{v:?}");
        }
    }
}

/// Two polygons that share an edge leave no gap, bent or not.
#[test]
fn polygons_that_share_an_edge_leave_no_gap() {
    let mut rng = Rng::new(0x9a9);
    for _ in 0..2_000 {
        let mut point = || Vec3::from(rng.triple(|rng| rng.real(-1.0, 1.0) as f32));
        let v = [(); 6].map(|()| point());
        // Both contain vertices 0 and 3.
        let one = Polygon::new(&v[..4]).unwrap();
        let other = [v[3], v[4], v[5], v[0]];
        let other = Polygon::new(&other).unwrap();
        let part = rng.real(0.0, 1.0) as f32;
        let on = |a: f32, b: f32| a + part * (b - a);
        let p = [on(v[0].x, v[3].x), on(v[0].y, v[3].y), on(v[0].z, v[3].z)];
        // As large as the rounding of the point.
        let cell = Aabb::from_center_half_extents(p, [f32::EPSILON; 3]).unwrap();
        assert!(one.overlaps(&cell) && other.overlaps(&cell), "{v:?} {p:?}");
    }
}

/// Vertices in eighths, for which `f32` computes every sum and product exactly. The diagonal's
/// division does round, so contact is left out.
#[test]
fn the_published_test_is_right_where_nothing_is_rounded() {
    let mut rng = Rng::new(0x6ee);
    let (mut met, mut met_inside) = (0, 0);
    for n in 0..60_000 {
        let mut point = || rng.triple(|rng| rng.whole(-16, 16) as f32 / 8.0);
        let [a, b, c] = [point(), point(), point()];
        let d = three(|i: usize| a[i] - b[i] + c[i]);
        let vertices = [a, b, c, d].each(Vec3::from);
        let polygon = Polygon::new(&vertices[..3 + n % 2]).unwrap();
        let of_size = |size: f32| {
            Aabb::from_center_half_extents([0.125; 3], [0.5, 0.75, 1.0].each(|h| h * size)).unwrap()
        };
        let truth = polygon.overlaps(&of_size(1.0));
        if polygon.overlaps(&of_size(0.998)) != polygon.overlaps(&of_size(1.002)) {
            continue;
        }
        assert_eq!(green_hatch::overlaps(&polygon, &of_size(1.0)), truth, "{polygon:?}");
        met += usize::from(truth);
        let sides = vertices[..3 + n % 2].iter().zip(vertices[..3 + n % 2].iter().cycle().skip(1));
        let by_sides = |size| {
            let mut sides = sides.clone();
            sides.any(|(&p, &q)| Segment::new(p, q).unwrap().overlaps(&of_size(size)))
        };
        met_inside += usize::from(truth && !by_sides(1.0));
    }
    assert!(met > 10_000 && met_inside > 1_000, "{met} {met_inside}");
}
