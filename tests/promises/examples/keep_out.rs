//! The example `keep_out`: it parses G-code or reports the error, distinguishes outside, contact
//! and inside, and misses nothing between two poses.

#[path = "../../../examples/keep_out/check.rs"]
mod check;
#[rustfmt::skip]
#[path = "../../../examples/keep_out/clamps.rs"]
mod clamps;
#[path = "../../../examples/keep_out/gcode.rs"]
mod gcode;
#[path = "../../../examples/keep_out/tool.rs"]
mod tool;

use std::collections::BTreeMap;
use std::fs;

use check::{Place, Zone};
use clamps::{FACES, VERTICES};
use fixed::types::I16F16;
use gcode::{Move, Position, Program};
use proptest::prelude::*;
use septum::{Obb, Triangle, Vec3};
use septum_kit::{Each, Rng, three};

use super::{directory, printed, run};

type Point = [f64; 3];

fn point(v: Vec3<I16F16>) -> Point {
    v.to_array().each(I16F16::to_num)
}

fn minus(a: Point, b: Point) -> Point {
    three(|i| a[i] - b[i])
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The winding number of the clamps about a point: the sum of the solid angles of their faces,
/// divided by the sphere's (A. Van Oosterom, J. Strackee, 1983). It is independent of the method of
/// the check.
fn winding_number(p: Point) -> f64 {
    let solid_angle = |face: &[u16; 3]| {
        let [a, b, c] = face.each(|i| minus(point(VERTICES[usize::from(i)]), p));
        let [x, y, z] = [a, b, c].each(|v| dot(v, v).sqrt());
        let denominator = x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y;
        2.0 * dot(a, cross(b, c)).atan2(denominator)
    };
    FACES.iter().map(solid_angle).sum::<f64>() / (4.0 * std::f64::consts::PI)
}

fn position(tip: Point, tilt: [f64; 2]) -> Position {
    Position { tip: tip.each(I16F16::from_num), tilt: tilt.each(I16F16::from_num) }
}

#[test]
fn the_clamps_in_flash_are_closed() {
    let mut faces_of = BTreeMap::new();
    for &[a, b, c] in &FACES {
        assert!(a != b && b != c && c != a);
        for (from, to) in [(a, b), (b, c), (c, a)] {
            *faces_of.entry((from.min(to), from.max(to))).or_insert(0) +=
                if from < to { 1 } else { -1 };
        }
    }
    // Equally often in either direction: closed, and consistently oriented.
    assert!(faces_of.values().all(|&sum| sum == 0));
    // Inside a jaw, and inside a stud that stands in its nut and in its clamp.
    assert_eq!(winding_number([1.0, 60.0, 30.0]).round(), 1.0);
    assert_eq!(winding_number([74.0, 0.5, 35.0]).round(), 2.0);
}

/// Compares each verdict with a test of all faces, one by one, and the winding number.
#[test]
fn the_place_is_that_of_all_faces() {
    let zone = Zone::new().unwrap();
    let rng = &mut Rng::new(0x6c0de);
    let triangle = |face: &[u16; 3]| {
        let [a, b, c] = face.each(|i| VERTICES[usize::from(i)]);
        Triangle::new(a, b, c).unwrap()
    };
    let mut seen = [0; 3];
    for round in 0..400 {
        let [x, y] = [rng.real(-90.0, 90.0), rng.real(-80.0, 80.0)];
        let (x, y) = if round % 4 == 0 { (x / 2.0, 58.0) } else { (x, y) };
        let z = if round % 4 == 0 { rng.real(3.0, 70.0) } else { rng.real(5.0, 90.0) };
        let tilt = [rng.real(-30.0, 30.0), rng.real(-30.0, 30.0)];
        let tilt = if round % 4 == 0 { [0.0; 2] } else { tilt };
        let obb = tool::obb(position([x, y, z], tilt)).unwrap();
        let touches = |face: usize| triangle(&FACES[face]).overlaps(&obb);
        match zone.place(&obb) {
            Place::Touches(face) => {
                assert!(touches(face));
                seen[0] += 1;
            }
            place => {
                assert!(!(0..FACES.len()).any(touches), "{obb:?}");
                let turns = winding_number(point(obb.center()));
                assert!((turns - turns.round()).abs() < 1e-6, "{obb:?}");
                assert_eq!(place == Place::Inside, turns.round() > 0.0, "{obb:?}");
                seen[if place == Place::Inside { 1 } else { 2 }] += 1;
            }
        }
    }
    assert!(seen.iter().all(|&n| n > 15), "{seen:?}");
}

fn moves(text: &str) -> Vec<Move> {
    Program::new(text, tool::HOME).map(Result::unwrap).collect()
}

/// At each point of a move, every corner of the tool is within the box of the nearer pose.
#[test]
fn nothing_passes_between_two_poses() {
    let program = "G0 X3.7 Y-12.3 Z50\nG1 X4.3 Y9.9 A13.5 B-7.25\nG1 Z49.4 A-20 B30\nG1 X-30 B-30\n\
                   Y0.3 A0.25\n";
    let (mut asked, corner) = (0, |sign: bool, at: f64| if sign { at } else { -at });
    for line in moves(program) {
        let poses: Vec<Position> = tool::poses(line).collect();
        assert_eq!((poses[0], poses[poses.len() - 1]), (line.from, line.to));
        for pair in poses.windows(2) {
            for (way, nearer) in [(0.25, 0), (0.5, 0), (0.5, 1), (0.75, 1)] {
                let nearer = tool::obb(pair[nearer]).unwrap();
                let between = |a: I16F16, b: I16F16| {
                    a.to_num::<f64>() * (1.0 - way) + b.to_num::<f64>() * way
                };
                let tip = three(|i| between(pair[0].tip[i], pair[1].tip[i]));
                let [(sa, ca), (sb, cb)] = [0, 1]
                    .each(|i| between(pair[0].tilt[i], pair[1].tilt[i]).to_radians().sin_cos());
                for k in 0..8 {
                    // The tool without clearance, 6 mm by 40.
                    let (x, y) = (corner(k & 1 == 0, 3.0), corner(k & 2 == 0, 3.0));
                    let z = if k & 4 == 0 { 0.0 } else { 40.0 };
                    let (y, z) = (ca * y - sa * z, sa * y + ca * z);
                    let turned = [cb * x + sb * z, y, cb * z - sb * x];
                    let p = three(|i| I16F16::from_num(tip[i] + turned[i]));
                    assert!(nearer.contains(p), "{line:?} {pair:?}");
                    asked += 1;
                }
            }
        }
    }
    assert!(asked > 1_000, "{asked}");
}

/// The tip is at the middle of the tool's lower end for every tilt.
#[test]
fn the_tool_stands_on_its_tip() {
    let at = |p: Point, a: f64, b: f64| tool::obb(position(p, [a, b])).unwrap();
    let upright = at([1.0, 2.0, 3.0], 0.0, 0.0);
    assert_eq!(upright.center(), Vec3::new(1, 2, 23).to_array().each(I16F16::from_num).into());
    let lying = at([0.0; 3], -90.0, 0.0);
    assert_eq!(lying.center(), [0, 20, 0].each(I16F16::from_num).into());
    let end = Position { tip: [I16F16::MAX; 3], tilt: [I16F16::ZERO; 2] };
    assert_eq!(tool::obb(end), None);
}

#[test]
fn words_in_any_form() {
    let moves = moves("%\n(a comment) g0x1.5Y -2 (and another)\n\nN3 F900 S1\n");
    assert_eq!(moves.len(), 1);
    assert_eq!((moves[0].line, moves[0].from), (2, tool::HOME));
    assert_eq!(moves[0].to, position([1.5, -2.0, 120.0], [0.0; 2]));
    // Axes that are not named keep their value, and nothing is read after the end.
    let moves = self::moves("G1 Z+.25 A45 ; deep\nM30\nrubbish\n");
    assert_eq!(moves[0].to, position([0.0, 0.0, 0.25], [45.0, 0.0]));
    assert_eq!(moves.len(), 1);
}

#[test]
fn rubbish_is_told_with_its_line() {
    for (text, line, at, what) in [
        ("G0 X1\nG2 X3", 2, 'G', "not understood"),
        ("G1 X1\n\n\nQ7", 4, 'Q', "no word of a move"),
        ("G1 X", 1, 'X', "number is missing"),
        ("G1 X-.", 1, 'X', "number is missing"),
        ("G1 X1.2.3", 1, 'X', "no number"),
        ("G1 Y40000", 1, 'Y', "beyond"),
        ("G1 X1 Z2 X1", 1, 'X', "twice"),
        ("G1 X1 (no end", 1, '(', "does not end"),
        ("G91 X1", 1, 'G', "not understood"),
        ("G0.5 X1", 1, 'G', "not understood"),
        ("5", 1, '5', "begins with a letter"),
        ("G1 \u{e9}1", 1, '\u{e9}', "begins with a letter"),
    ] {
        let fault = Program::new(text, tool::HOME).find_map(Result::err).expect(text);
        assert_eq!((fault.line, fault.at), (line, at), "{text}");
        assert!(fault.what.contains(what), "{text}: {}", fault.what);
        // The error is the last item.
        assert!(Program::new(text, tool::HOME).last().unwrap().is_err(), "{text}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..Default::default() })]
    #[test]
    fn no_text_is_a_panic(text in "[GXYZABMF0-9 .;()%+\\-\né]{0,40}") {
        for line in Program::new(&text, tool::HOME).flatten() {
            for pose in tool::poses(line).step_by(997) {
                let _ = tool::obb(pose);
            }
        }
    }
}

/// The bundled programs: one touches a clamp and recovers, one ends inside.
#[test]
fn the_log_names_line_and_pose() {
    let [log, _] = printed("keep_out", &[], &directory("log"));
    let lines: Vec<&str> = log.lines().collect();
    let starts = [
        "clamps: 1308 triangles",
        "facing.nc: line 13, pose 23: touches face ",
        "facing.nc: line 15, pose 4: outside again, ",
        "facing.nc: line 17, pose 101: touches face ",
        "facing.nc: line 17, pose 128: outside again, ",
        "facing.nc: 13 moves, 838 poses; it ends outside",
        "plunge.nc: line 4, pose 18: touches face ",
        "plunge.nc: line 4, pose 63: inside a clamp, tip [10000, 55000, 17000]",
        "plunge.nc: 2 moves, 129 poses; it ends inside a clamp",
    ];
    assert_eq!(lines.len(), starts.len(), "{log}");
    for (line, start) in lines.iter().zip(starts) {
        assert!(line.starts_with(start), "{line}");
    }
}

/// A script learns by the exit code whether there is a collision.
#[test]
fn files_of_ones_own() {
    let directory = directory("program");
    fs::write(directory.join("own.nc"), "G0 X70\nG0 Z60\nG1 Y0 Z10\n").unwrap();
    fs::write(directory.join("free.nc"), "G0 X1\n").unwrap();
    fs::write(directory.join("rubbish.nc"), "G0 X70\nG1 X80 Y\n").unwrap();
    for (files, code, told) in [
        (&["own.nc"][..], 1, "own.nc: line 3, pose "),
        (&["own.nc"], 1, "touches face"),
        (&["free.nc"], 0, "it ends outside"),
        (&["free.nc", "own.nc", "free.nc"], 1, "it ends in contact"),
        (&["rubbish.nc"], 2, "rubbish.nc: line 2: Y: a number is missing"),
        (&["own.nc", "none.nc"], 2, "none.nc: "),
        (&["free.nc", "--fast"], 2, "--fast: there is no such option"),
        (&["--help"], 0, "Exits with 0 if"),
    ] {
        let output = run("keep_out", files, &directory);
        let log = [output.stdout, output.stderr].each(|s| String::from_utf8(s).unwrap()).concat();
        assert_eq!(output.status.code(), Some(code), "{files:?}: {log}");
        assert!(log.contains(told), "{files:?}: {log}");
    }
}

/// A tool may be any box; the check makes no assumption about its size.
#[test]
fn tools_of_other_sizes() {
    let zone = Zone::new().unwrap();
    let place = |center: [f64; 3], half: f64| {
        let [center, half] = [center, [half; 3]].each(|p| p.each(I16F16::from_num));
        zone.place(&Obb::from_turns(center, [I16F16::ZERO; 3], half).unwrap())
    };
    assert!(matches!(place([0.0; 3], 200.0), Place::Touches(_)));
    // Inside a stud, where it stands in its nut: inside both.
    assert_eq!(place([74.0, 0.5, 35.5], 0.25), Place::Inside);
    assert_eq!(place([74.0, 0.5, 50.5], 0.25), Place::Outside);
}
