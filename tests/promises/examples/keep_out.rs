//! The example `keep_out`: it tells outside, contact and inside apart, and its mesh
//! is closed, for otherwise there would be no inside.

#[path = "../../../examples/keep_out/check.rs"]
mod check;
#[rustfmt::skip]
#[path = "../../../examples/keep_out/teapot.rs"]
pub(crate) mod teapot;
#[path = "../../../examples/keep_out/tool.rs"]
pub(crate) mod tool;

use std::cell::Cell;
use std::collections::BTreeMap;

use check::Place;
use fixed::types::I16F16;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use septum::{Obb, Vec3};
use teapot::{FACES, PARTS, VERTICES};

type Point = [f64; 3];

fn point(v: Vec3<I16F16>) -> Point {
    v.to_array().map(I16F16::to_num)
}

fn minus(a: Point, b: Point) -> Point {
    [0, 1, 2].map(|i| a[i] - b[i])
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// How often a part of the mesh winds around a point: the sum of the solid angles of
/// its faces, in units of the sphere. A. Van Oosterom, J. Strackee, 1983. It asks no
/// ray, and so shares nothing with the check.
fn winding_number(part: usize, p: Point) -> f64 {
    let solid_angle = |face: &[u16; 3]| {
        let [a, b, c] = face.map(|i| minus(point(VERTICES[usize::from(i)]), p));
        let [x, y, z] = [a, b, c].map(|v| dot(v, v).sqrt());
        let denominator = x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y;
        2.0 * dot(a, cross(b, c)).atan2(denominator)
    };
    let whole: f64 = FACES[PARTS[part].clone()].iter().map(solid_angle).sum();
    whole / (4.0 * std::f64::consts::PI)
}

/// An upright tool.
fn tool_at(center: [I16F16; 3], half: [I16F16; 3]) -> Obb<I16F16> {
    let (zero, one) = (I16F16::ZERO, I16F16::ONE);
    let axes = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
    Obb::new(center, axes.map(Vec3::from), half).unwrap()
}

fn place(tool: &Obb<I16F16>) -> Place {
    thread_local!(static ZONE: check::Zone = check::Zone::new().unwrap());
    ZONE.with(|zone| zone.place(tool))
}

/// The parts that have all of the tool inside, by winding numbers. `None` where a
/// number is not nearly whole: the centre is then as good as on a face.
fn parts_around(tool: &Obb<I16F16>) -> Option<Vec<usize>> {
    let mut around = Vec::new();
    for part in 0..PARTS.len() {
        let turns = winding_number(part, point(tool.center()));
        if (turns - turns.round()).abs() > 1e-6 {
            return None;
        }
        if turns.round() as i64 % 2 != 0 {
            around.push(part);
        }
    }
    Some(around)
}

#[test]
fn the_mesh_in_flash_is_closed() {
    let mut next = 0;
    for part in &PARTS {
        assert_eq!(part.start, next, "the parts follow one another");
        next = part.end;
        let mut faces_of = BTreeMap::new();
        for &[a, b, c] in &FACES[part.clone()] {
            assert!(a != b && b != c && c != a);
            for (from, to) in [(a, b), (b, c), (c, a)] {
                *faces_of.entry((from.min(to), from.max(to))).or_insert(0) +=
                    if from < to { 1 } else { -1 };
            }
        }
        // Once in either direction: closed, and oriented alike.
        assert!(faces_of.values().all(|&sum| sum == 0), "{part:?}");
    }
    assert_eq!(next, FACES.len(), "each face is in a part");
    assert_eq!(PARTS.len(), 4, "body, handle, spout and lid");
}

/// The path that the example takes.
#[test]
fn the_path_leads_from_outside_through_contact_to_inside() {
    let mut stages = Vec::new();
    for step in 0..tool::STEPS {
        let tool = tool::at(step).unwrap();
        let place = place(&tool);
        match &place {
            Place::Touches(faces) => assert!(faces.total() > 0),
            Place::Inside(part) => assert_eq!(parts_around(&tool).unwrap(), [*part]),
            Place::Outside => assert!(parts_around(&tool).unwrap().is_empty()),
        }
        let stage = std::mem::discriminant(&place);
        if stages.last() != Some(&stage) {
            stages.push(stage);
        }
    }
    let touched = std::iter::once(0).collect();
    let expected = [Place::Outside, Place::Touches(touched), Place::Inside(0)];
    assert_eq!(stages, expected.map(|place| std::mem::discriminant(&place)));
}

/// The tool alone in the body, the handle, the spout and the lid, and beside them.
#[test]
fn each_part_has_an_inside() {
    let at = |x: f64, y: f64, z: f64, half: f64| {
        place(&tool_at([x, y, z].map(I16F16::from_num), [I16F16::from_num(half); 3]))
    };
    // The middle of the body, and the hole of the handle beside it.
    assert_eq!(at(0.0, 0.0, 0.0, 2.0), Place::Inside(0));
    assert_eq!(at(-13.0, 0.0, 0.0, 0.25), Place::Outside);
    assert_eq!(at(0.0, 30.0, 0.0, 2.0), Place::Outside);
    assert_eq!(at(0.0, -30.0, 0.0, 2.0), Place::Outside);
    // Nearly as wide as the body is.
    assert!(matches!(at(-1.0, 0.0, 0.0, 30.0), Place::Touches(_)), "all around the mesh");
    let mut seen = [false; 4];
    for part in 0..4 {
        for face in FACES[PARTS[part].clone()].iter().step_by(3) {
            // From a corner towards the middle of the part's box, a little.
            let p = point(VERTICES[usize::from(face[0])]);
            for way in [0.02, 0.1, 0.3] {
                let q = minus(p, minus(p, middle(part)).map(|x| way * x));
                if at(q[0], q[1], q[2], 1.0 / 64.0) == Place::Inside(part) {
                    seen[part] = true;
                }
            }
        }
    }
    assert_eq!(seen, [true; 4]);
}

/// The middle of a part's bounding box.
fn middle(part: usize) -> Point {
    let points = || {
        let vertices = FACES[PARTS[part].clone()].iter().flatten();
        vertices.map(|&i| point(VERTICES[usize::from(i)]))
    };
    [0, 1, 2].map(|i| {
        let least = points().map(|p| p[i]).fold(f64::INFINITY, f64::min);
        let greatest = points().map(|p| p[i]).fold(f64::NEG_INFINITY, f64::max);
        (least + greatest) / 2.0
    })
}

/// A tool near the mesh. Often it stands below a vertex, where the ray meets
/// several faces at once.
fn any_tool() -> impl Strategy<Value = Obb<I16F16>> {
    let along =
        |least: i32, greatest: i32| (least << 16..greatest << 16).prop_map(I16F16::from_bits);
    let below = (0..VERTICES.len(), along(-9, 9)).prop_map(|(i, y)| {
        let v = VERTICES[i];
        [v.x, y, v.z]
    });
    let free = [along(-17, 17), along(-9, 9), along(-11, 11)];
    let half = (1..1_i32 << 15).prop_map(I16F16::from_bits);
    (prop_oneof![below, free], half).prop_map(|(center, half)| tool_at(center, [half; 3]))
}

#[test]
fn inside_is_what_the_winding_number_says() {
    let config = Config { cases: 4000, failure_persistence: None, ..Config::default() };
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let (outside, inside) = (Cell::new(0), Cell::new([0; 4]));
    let outcome = TestRunner::new_with_rng(config, rng).run(&any_tool(), |tool| {
        let Some(around) = parts_around(&tool) else { return Ok(()) };
        match place(&tool) {
            Place::Touches(faces) => prop_assert!(faces.total() > 0),
            Place::Outside => {
                prop_assert!(around.is_empty(), "inside {around:?}");
                outside.set(outside.get() + 1);
            }
            Place::Inside(part) => {
                prop_assert_eq!(around.first(), Some(&part));
                let mut counts = inside.get();
                counts[part] += 1;
                inside.set(counts);
            }
        }
        Ok(())
    });
    outcome.unwrap();
    let [body, handle, spout, lid] = inside.get();
    let seen = format!("outside {}, inside {:?}", outside.get(), inside.get());
    assert!(outside.get() > 500 && body > 500, "{seen}");
    assert!(handle > 0 && spout > 0 && lid > 0, "{seen}");
}
