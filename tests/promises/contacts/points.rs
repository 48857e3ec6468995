//! The points of a contact lie on both shapes, on the parts named, and span what touches.

use std::env;

use septum::contact::{Contact, Features, InteriorEdges, Part, Point, contact, contact_in_mesh};
use septum::{Aabb, Obb, Triangle};
use septum_kit::boxes::{AnyBox, ObbNumbers};
use septum_kit::contacts::{ContactCase, ContactSet, PointErrors, Solid};
use septum_kit::fixed::types::I32F32;
use septum_kit::{BoxNumbers, Each, Rng, Sample, for_every_scalar, with_every_scalar};

/// The kinds of a pair: triangle, box and oriented box, each with each.
const PAIRS: [&str; 6] =
    ["triangle triangle", "triangle aabb", "aabb aabb", "triangle obb", "aabb obb", "obb obb"];

fn pair<S>(case: &ContactCase<S>) -> usize {
    let kind = |solid: &Solid<S>| match solid {
        Solid::Triangle(_) => 0,
        Solid::Box(AnyBox::Aabb(_)) => 1,
        Solid::Box(AnyBox::Obb(_)) => 2,
    };
    let (a, b) = (kind(&case.first), kind(&case.second));
    let (least, most) = (a.min(b), a.max(b));
    least + most * (most + 1) / 2
}

/// Checks the points of a contact, and of the same triangle in a mesh where they are held.
fn check<S: Sample>(
    case: &ContactCase<S>,
    edges: InteriorEdges,
    mut seen: impl FnMut(usize, PointErrors),
) {
    let in_mesh = case.contact_in_mesh(edges).flatten().filter(|found| found.is_held);
    for found in case.contact().flatten().into_iter().chain(in_mesh) {
        match case.check_points(&found) {
            Some(Ok(errors)) => seen(pair(case), errors),
            Some(Err(what)) => panic!("{what}: {case:?} {found:?}"),
            None => {}
        }
    }
}

/// The greatest errors of each pair, in parts of those allowed, and how many contacts there were.
fn of_set<S: Sample>(set: ContactSet, seed: u64, cases: usize) -> [(usize, PointErrors); 6] {
    let (mut rng, mut all) = (Rng::new(seed), [(0, PointErrors::default()); 6]);
    for _ in 0..cases {
        let case = set.case::<S>(&mut rng);
        let edges = InteriorEdges::new(rng.triple(|rng| rng.one_in(2)));
        check(&case, edges, |pair, errors| {
            all[pair] = (all[pair].0 + 1, all[pair].1.or(errors));
        });
    }
    all
}

fn points_lie_on_both_shapes<S: Sample>() {
    for set in ContactSet::ALL {
        let count: usize = of_set::<S>(set, 0x9017, 250).iter().map(|(count, _)| count).sum();
        assert!(count > 0, "{} {set:?}", S::name());
    }
}
for_every_scalar!(points_lie_on_both_shapes);

/// `CASES=1000000 cargo test --release --test promises points_of_many -- --ignored --nocapture`:
/// so many cases of each set and scalar, and the greatest errors in parts of those stated.
#[test]
#[ignore = "as long as you like"]
fn points_of_many() {
    fn many<S: Sample>() {
        let cases = env::var("CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(10_000);
        for set in ContactSet::ALL {
            for (name, (count, e)) in PAIRS.into_iter().zip(of_set::<S>(set, 78, cases)) {
                let (name, set) = (format!("{} {name}", S::name()), format!("{set:?}"));
                let [part, pair, span] = [e.part, e.pair, e.span];
                println!("{name:24} {set:22} {count:8} {part:.4} {pair:.4} {span:.4}");
            }
        }
    }
    with_every_scalar!(many);
}

fn aabb<S: Sample>(min: [f64; 3], max: [f64; 3]) -> Solid<S> {
    Solid::Box(AnyBox::Aabb(BoxNumbers::Corners(min.each(S::nearest), max.each(S::nearest))))
}

/// The contact of two shapes, whose points are checked.
fn checked<S: Sample>(first: Solid<S>, second: Solid<S>) -> Contact<S> {
    let case = ContactCase { first, second };
    check(&case, InteriorEdges::NONE, |_, _| {});
    case.contact().flatten().expect("a contact")
}

/// A box without thickness is as long as one with it.
fn flat_boxes_end<S: Sample>() {
    for y in [0.0, 0.0625] {
        let found = checked::<S>(
            aabb([-1.0, -y, -1.0], [1.0, y, 1.0]),
            aabb([0.75, -4.0, -7.0], [4.0, 4.0, 7.0]),
        );
        let z = |p: &Point<S>| p.on_second.z;
        let ends = [-1.0, 1.0].each(S::nearest);
        assert!(found.points().iter().all(|p| ends[0] <= z(p) && z(p) <= ends[1]), "{found:?}");
        assert!(ends.iter().all(|&end| found.points().iter().any(|p| z(p) == end)), "{found:?}");
    }
}
for_every_scalar!(flat_boxes_end);

/// Shapes as long as the range of 64-bit fixed point.
#[test]
fn half_the_range_away() {
    let far = 2e9;
    let t = [[-far, -far, 1.9e9], [far, -far, 1.9e9], [-far, far, 1.9e9]];
    let t = Solid::Triangle(t.each(|p| p.each(I32F32::from_num)));
    let found = checked::<I32F32>(aabb([-far; 3], [far; 3]), t);
    let xs = found.points().iter().map(|p| p.on_first.x);
    assert_eq!(xs.max(), Some(I32F32::from_num(far)));
}

/// The lowest face of the box lies beyond the triangle; a lower point of another face lies over it.
#[test]
fn a_point_held_to_a_face_lies_on_it() {
    let t = Triangle::new([0.0_f64, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]).unwrap();
    let axes = [[1.0, 0.0, 0.0], [0.0, 0.6, 0.8], [0.0, -0.8, 0.6]];
    let (center, half) = ([1.5, -1.95, 0.4], [0.5, 1.0, 2.0]);
    let other = Obb::new(center, axes, half).unwrap();
    let found = contact_in_mesh(&t, InteriorEdges::new([true, false, false]), &other).unwrap();
    assert!(found.is_held);
    for point in found.points() {
        let [x, y, z] = point.on_first.to_array();
        assert!(x >= 0.0 && y >= -1e-12 && x + y <= 4.0 && z.abs() < 1e-12, "{point:?}");
    }
    assert!(found.points().iter().any(|p| p.depth > 0.1), "{found:?}");
    let first = Solid::Triangle(t.vertices().each(|v| v.to_array()));
    let second = Solid::Box(AnyBox::Obb(ObbNumbers { center, axes, half }));
    let edges = InteriorEdges::new([true, false, false]);
    let mut count = 0;
    check(&ContactCase { first, second }, edges, |_, _| count += 1);
    assert_eq!(count, 2);
}

/// Two boxes that overlap by 1.6e-17, where their numbers are about one.
#[test]
fn a_depth_below_rounding_keeps_the_points() {
    let at = |bits: [u64; 3]| bits.each(f64::from_bits);
    let first = BoxNumbers::Corners(
        at([0xbf84_0779_05a9_f3cf, 0xbfd8_da75_d7ff_61be, 0x3f74_d2ae_ef5b_0bae]),
        at([0x3ff6_487e_171b_bf7c, 0x3fcd_578c_6671_4c1d, 0x4004_53cd_a11a_8a3e]),
    );
    let second = BoxNumbers::Center(
        at([0xbfec_61bb_1e85_8b0d, 0x3fc8_b2c2_07e3_44b1, 0xbfd6_9307_fb97_0e05]),
        at([0x3fec_119d_3a6e_e33e, 0x3fa2_9329_7a38_1db0, 0x3fd6_e652_b754_7a34]),
    );
    let [first, second] = [first, second].each(|b| Solid::Box(AnyBox::Aabb(b)));
    let found = checked(first, second);
    assert!(found.points().iter().all(|p| p.on_first.x > -0.01 && p.depth >= 0.0), "{found:?}");
}

/// The face of a skewed box that has its lowest corner need not be the one that faces down most.
fn skewed_boxes_meet_where_they_are<S: Sample>() {
    let at = |p: [f64; 3]| p.each(S::nearest);
    let axes = [[0.5, 0.0, 0.5], [0.25, 0.25, 0.0], [0.25, 0.5, 0.5]].each(at);
    let obb = ObbNumbers { center: at([0.0, 1.5, 2.75]), axes, half: at([3.75, 0.5, 3.0]) };
    let other = aabb([-1.5, -3.0, -3.0], [-1.25, 0.75, 2.25]);
    let found = checked(Solid::Box(AnyBox::Obb(obb)), other);
    assert!(found.points().iter().all(|p| p.on_second.x <= S::nearest(-1.25)), "{found:?}");
}
for_every_scalar!(skewed_boxes_meet_where_they_are);

/// A triangle that is a line, met on its second edge.
#[test]
fn the_edge_of_a_line_that_is_met_is_named() {
    let line = Solid::Triangle([[0.0_f32, 0.0, 0.0], [2.0, 2.0, 0.0], [8.0, 8.0, 0.0]]);
    let found = checked(line, aabb([4.0, -9.0, -1.0], [9.0, 4.25, 1.0]));
    for point in found.points() {
        assert!(point.on_first.x >= 4.0 && point.parts[0] != Part::Edge(0), "{found:?}");
    }
}

fn parts(found: &Contact<f32>) -> Vec<[Part; 2]> {
    let mut all: Vec<[Part; 2]> = found.points().iter().map(|p: &Point<f32>| p.parts).collect();
    all.sort();
    all
}

/// A box that tilts, slides and sinks a little from frame to frame keeps its parts.
#[test]
fn parts_are_the_same_from_frame_to_frame() {
    let floor = Triangle::new([-8.0_f32, -8.0, 0.0], [8.0, -8.0, 0.0], [0.0, 9.0, 0.0]).unwrap();
    let frame = |n: u8| {
        let tilt = 1e-4 * f32::from(n);
        let axes = [[1.0, 0.0, tilt], [0.0, 1.0, -tilt / 2.0], [-tilt, tilt / 2.0, 1.0]];
        let center = [0.01 * f32::from(n), 0.0, 0.99 - 0.001 * f32::from(n)];
        Obb::new(center, axes, [1.0; 3]).unwrap()
    };
    let first = parts(&contact(&floor, &frame(0)).unwrap());
    let expected = [0, 1, 2, 3].each(|k| [Part::Face(0), Part::Vertex(k)]);
    assert_eq!(first, expected);
    for n in 1..10 {
        let found = contact(&floor, &frame(n)).unwrap();
        assert_eq!(
            (found.translation.features, parts(&found)),
            (Features::First(0), first.clone())
        );
    }
}

/// One rectangle across another: eight corners, each from two edges.
#[test]
fn a_square_on_a_square_has_eight_points() {
    let below = Aabb::from_min_max([-1.0, -1.0, -2.0], [1.0, 1.0, 0.0]).unwrap();
    let r = 0.5_f32.sqrt();
    let axes = [[r, r, 0.0], [-r, r, 0.0], [0.0, 0.0, 1.0]];
    let above = Obb::new([0.0, 0.0, 0.96875], axes, [1.0, 1.0, 1.0]).unwrap();
    let found = contact(&above, &below).unwrap();
    assert_eq!(found.translation.depth, 0.03125);
    assert_eq!(found.translation.normal.to_array(), [0.0, 0.0, 1.0]);
    assert_eq!(found.points().len(), 8);
    let all = parts(&found);
    assert!(all.iter().all(|p| matches!(p, [Part::Edge(_), Part::Edge(_)])));
    assert!(all.windows(2).all(|two| two[0] != two[1]));
    // A small rectangle on a large one: the corners of the small one.
    let small = Aabb::from_min_max([-0.25, -0.25, -0.5], [0.25, 0.25, 0.5]).unwrap();
    let small = contact(&small, &below).unwrap();
    assert_eq!(parts(&small), [0, 1, 2, 3].each(|k| [Part::Vertex(k), Part::Face(5)]));
}

/// The size of the first shape is no number, and yet it is too great for the floats of its points.
#[test]
fn shapes_as_large_as_the_range_have_points() {
    let (most, next, least) = (f64::MAX, f64::MAX.next_down(), f64::from_bits(1));
    let vertices = [[1.0, -least, -most], [least, most, least], [-least, -next, most]];
    let half = [1.0_f64.next_down(), 0.0, 0.0];
    let line = AnyBox::Aabb(BoxNumbers::Center([0.0, next, -least], half));
    checked(Solid::Triangle(vertices), Solid::Box(line));
}

/// A corner of the triangle lies over a steep face, nearer than rounding to an edge beyond it.
#[test]
fn a_corner_beyond_an_edge_meets_the_steep_face() {
    let at = |p: [f64; 3]| p.each(I32F32::from_num);
    let a = [0.0000000065, -0.0000000005, -0.0017672337];
    let b = [0.000043045, -0.0000000002, -0.0240150706];
    let c = [-0.0000375984, -14549.0974768132, -0.0000000014];
    let least = [-6.2370450194, -88_613_751.155_912_38, -0.0000037912];
    let second = aabb(least, [0.000000681, 0.0025057397, 207_461_850.879_551_1]);
    let case = ContactCase { first: Solid::Triangle([a, b, c].each(at)), second };
    let mut count = 0;
    check(&case, InteriorEdges::new([true; 3]), |_, _| count += 1);
    assert_eq!(count, 2);
}

/// No two faces touch in floats, and the depth of the deepest corners is rounded below zero.
#[test]
fn no_depth_is_below_zero() {
    let (most, next, least) = (f64::MAX, f64::MAX.next_down(), f64::from_bits(1));
    let (below, above) = (1.0_f64.next_down(), 1.0_f64.next_up());
    let first = Solid::Triangle([
        [above, least, below],
        [-least, 0.0, -most],
        [-least, -least, next.next_down()],
    ]);
    let axes = [[2.0 * least, -most, above], [2.0 * least, above, next], [0.0, -least, below]];
    let center = [2.0 * least, -2.0 * least, 2.0 * least];
    let half = [least, 2.0 * least, 0.0];
    checked(first, Solid::Box(AnyBox::Obb(ObbNumbers { center, axes, half })));
}
