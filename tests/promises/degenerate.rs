//! Triangles that are segments or points, boxes that are flat or points; and bugs reported by users
//! of other libraries, with a test for each.

use septum::published;
use septum::{Aabb, Scalar, Triangle};
use septum_kit::{Each, Rng, Sample, Set, for_every_scalar, is_collinear, meets, three};

type Point<S> = [S; 3];

fn triangle<S: Scalar>(a: Point<S>, b: Point<S>, c: Point<S>) -> Triangle<S> {
    Triangle::new(a, b, c).expect("finite vertices")
}

fn span<S: Scalar>(min: Point<S>, max: Point<S>) -> Aabb<S> {
    Aabb::from_min_max(min, max).expect("min below max")
}

/// Integers in the scalar.
fn at<S: Sample>(v: [i8; 3]) -> Point<S> {
    v.each(|x| S::nearest(x.into()))
}

fn is_degenerate_is_exact<S: Sample>() {
    let mut both = [0, 0];
    for set in Set::ALL {
        for case in set.cases::<S>(91, 3_000) {
            let expected = is_collinear(&case);
            assert_eq!(case.triangle().is_degenerate(), expected, "{set:?}: {case:?}");
            both[usize::from(expected)] += 1;
        }
    }
    assert!(both[0] > 3_000 && both[1] > 3_000, "{both:?}");
}

/// A triangle with two equal vertices is the segment between them, in any order; a triangle with
/// three equal vertices is the point.
fn a_segment_is_a_segment<S: Sample>() {
    for set in [Set::Random, Set::Grid, Set::Touch, Set::Huge] {
        for mut case in set.cases::<S>(92, 3_000) {
            let [a, b, _] = case.vertices;
            let aabb = case.aabb();
            case.vertices = [a, b, b];
            let expected = meets(&case);
            for [p, q, r] in [[a, b, b], [b, a, b], [b, b, a], [a, a, b], [a, b, a], [b, a, a]] {
                assert_eq!(triangle(p, q, r).overlaps(&aabb), expected, "{set:?}: {case:?}");
            }
            case.vertices = [a; 3];
            assert_eq!(triangle(a, a, a).overlaps(&aabb), meets(&case), "{set:?}: {case:?}");
        }
    }
}

/// A box that is a point meets exactly the triangles that contain the point.
fn a_box_may_be_a_point<S: Sample>() {
    let mut rng = Rng::new(93);
    for _ in 0..3_000 {
        let mut point = || rng.triple(|rng| rng.whole(-4, 4) as i8);
        let [a, b, c, p] = [point(), point(), point(), point()].each(at::<S>);
        let t = triangle(a, b, c);
        let zero = [S::ZERO; 3];
        let as_point = Aabb::from_center_half_extents(p, zero).expect("a box");
        assert_eq!(t.overlaps(&as_point), t.overlaps(&span(p, p)));
        for v in [a, b, c] {
            assert!(t.overlaps(&span(v, v)) && triangle(v, v, v).overlaps(&span(v, v)));
        }
    }
}

/// cuda_voxelizer #7: faces that lie on the grid vanish.
fn faces_on_the_grid<S: Sample>() {
    // A square of two triangles in z = 1, with cells below and above.
    let [a, b, c, d] = [[0, 0, 1], [2, 0, 1], [2, 2, 1], [0, 2, 1]].each(at::<S>);
    let halves = [triangle(a, b, c), triangle(a, c, d)];
    for x in 0..2 {
        for y in 0..2 {
            for z in 0..2 {
                let cell = span(at::<S>([x, y, z]), at::<S>([x + 1, y + 1, z + 1]));
                assert!(halves.iter().any(|t| t.overlaps(&cell)), "{cell:?}");
            }
            let beyond = span(at::<S>([x, y, 2]), at::<S>([x + 1, y + 1, 3]));
            assert!(!halves.iter().any(|t| t.overlaps(&beyond)), "{beyond:?}");
        }
    }
}

/// MathGeoLib #51: one triangle contained in a box was reported outside.
fn a_triangle_inside_a_box<S: Sample>() {
    let t = triangle(at::<S>([1, 0, 0]), at::<S>([0, 2, 0]), at::<S>([0, 0, 3]));
    assert!(t.overlaps(&span(at::<S>([-4; 3]), at::<S>([4; 3]))));
    assert!(t.overlaps(&Aabb::from_center_half_extents(at::<S>([0; 3]), at::<S>([4; 3])).unwrap()));
    assert!(t.overlaps(&span(at::<S>([0; 3]), at::<S>([1, 2, 3])))); // fits it exactly
}

/// The box pierces the middle of a triangle with distant vertices.
fn a_box_inside_a_big_triangle<S: Sample>() {
    let t = triangle(at::<S>([-7, -7, 0]), at::<S>([7, -7, 0]), at::<S>([0, 7, 0]));
    assert!(t.overlaps(&span(at::<S>([0, -1, -1]), at::<S>([1, 0, 1]))));
    assert!(t.overlaps(&span(at::<S>([0, -1, 0]), at::<S>([1, 0, 0])))); // flat, in its plane
    assert!(!t.overlaps(&span(at::<S>([0, -1, 1]), at::<S>([1, 0, 2]))));
}

/// CGAL #6808: an exact kernel without the three axes of the box. Here the plane and all planes
/// through edges cut the box, and the triangle is beside it.
fn beside_the_box_in_its_plane<S: Sample>() {
    let aabb = span(at::<S>([-1; 3]), at::<S>([1; 3]));
    for i in 0..3 {
        let turn = |v: [i8; 3]| at::<S>([v[i], v[(i + 1) % 3], v[(i + 2) % 3]]);
        let t = triangle(turn([2, 0, 0]), turn([6, 0, 0]), turn([4, 1, 0]));
        assert!(!t.overlaps(&aabb), "{t:?}");
        let t = triangle(turn([1, 0, 0]), turn([6, 0, 0]), turn([4, 1, 0]));
        assert!(t.overlaps(&aabb), "{t:?}");
    }
}

/// voxelize-rs: a wrong sign in a test on the second axis. Only cross products with that axis
/// separate these shapes, on either side.
fn the_signs_of_each_edge_axis<S: Sample>() {
    let aabb = span(at::<S>([-1; 3]), at::<S>([1; 3]));
    for i in 0..3 {
        for mirror in 0..8 {
            let place = |v: [i8; 3]| {
                let v = [v[i], v[(i + 1) % 3], v[(i + 2) % 3]];
                at::<S>(three(|k| if mirror >> k & 1 == 0 { v[k] } else { -v[k] }))
            };
            // An edge beside an edge of the cube, at a distance of one, and through it.
            let past = triangle(place([3, 0, 0]), place([0, 3, 0]), place([4, 4, 1]));
            assert!(!past.overlaps(&aabb), "{past:?}");
            let across = triangle(place([2, 0, 0]), place([0, 2, 0]), place([4, 4, 1]));
            assert!(across.overlaps(&aabb), "{across:?}");
        }
    }
}

/// tinybvh #168: meshes on an integer grid are hit on edges and vertices. Every cell that contains
/// a vertex or an edge's midpoint is met: eight for a vertex.
fn cells_about_a_grid_vertex<S: Sample>() {
    let t = triangle(at::<S>([0; 3]), at::<S>([3, 1, 2]), at::<S>([1, 3, 2]));
    for octant in 0..8_u8 {
        let to = |k: u8| if octant >> k & 1 == 0 { 0 } else { -1 };
        let min = [to(0), to(1), to(2)];
        let cell = span(at::<S>(min), at::<S>(min.each(|x| x + 1)));
        assert!(t.overlaps(&cell), "{cell:?}");
    }
}

for_every_scalar!(
    is_degenerate_is_exact,
    a_segment_is_a_segment,
    a_box_may_be_a_point,
    faces_on_the_grid,
    a_triangle_inside_a_box,
    a_box_inside_a_big_triangle,
    beside_the_box_in_its_plane,
    the_signs_of_each_edge_axis,
    cells_about_a_grid_vertex,
);

/// Absolute epsilons: in small scenes everything overlaps (parry), valid triangles are dropped
/// (cesium-unreal #1465), tolerances scale with edge² (tinybvh #283).
#[test]
fn no_scale_is_too_small() {
    for power in [0, -14, -40, -100, -400, -1000] {
        let unit = 2_f64.powi(power);
        let p = |v: [f64; 3]| v.each(|x| x * unit);
        let cell = span(p([-1.0; 3]), p([1.0; 3]));
        let near = triangle(p([3.5, 0.0, 0.0]), p([0.0, 3.5, 0.0]), p([0.0, 0.0, 3.5]));
        let touching = triangle(p([3.0, 0.0, 0.0]), p([0.0, 3.0, 0.0]), p([0.0, 0.0, 3.0]));
        assert!(!near.overlaps(&cell) && touching.overlaps(&cell), "2^{power}");
        assert!(!near.is_degenerate() && !touching.is_degenerate(), "2^{power}");
    }
}

/// rapier #21: NaN from a vertical triangle against a cuboid.
#[test]
fn upright_triangles() {
    let cell = span([0.0_f32; 3], [1.0; 3]);
    let upright = |x: f32| triangle([x, 0.2, -5.0], [x, 0.2, 5.0], [x, 0.8, 5.0]);
    assert!(upright(0.5).overlaps(&cell) && upright(1.0).overlaps(&cell));
    assert!(!upright(1.5).overlaps(&cell));
}

/// bvh #149 and others: −0.0 was accepted as a direction. It is zero, also as a half-extent.
#[test]
fn minus_zero_is_zero() {
    for case in Set::Grid.cases::<f32>(94, 20_000) {
        let mut minus = case;
        for (i, x) in case.numbers().into_iter().enumerate().filter(|(_, x)| *x == 0.0) {
            minus = minus.with_number(i, -x).expect("the same number");
        }
        let [(t, b), (u, c)] = [case.shapes(), minus.shapes()];
        assert_eq!(t.overlaps(&b), u.overlaps(&c), "{case:?}");
        assert_eq!(t.separating_axis(&b), u.separating_axis(&c), "{case:?}");
    }
}

/// Slivers. The published test must be wrong on some of them, or the set would show nothing.
#[test]
fn slivers_are_not_lost() {
    let mut lost = 0;
    for case in Set::Slivers.cases::<f32>(95, 50_000) {
        let (triangle, aabb) = case.shapes();
        assert!(triangle.overlaps(&aabb) >= meets(&case), "{case:?}");
        lost += u32::from(meets(&case) && !published::akenine_moller::overlaps(&triangle, &aabb));
    }
    assert!(lost > 500, "{lost}");
}
