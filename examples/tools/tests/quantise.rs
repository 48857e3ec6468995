//! The program `quantise`: it detects whether a mesh is closed, and closes it.

#[path = "../quantise/solid.rs"]
mod solid;

use std::fs;

use solid::{Face, caps, open_edges, sort_into_parts};

use super::{directory, printed};

/// The faces of a cuboid with corners 0 to 7, counterclockwise seen from outside.
const CUBOID: [Face; 12] = [
    [0, 2, 1],
    [1, 2, 3],
    [4, 5, 6],
    [5, 7, 6],
    [0, 1, 4],
    [1, 5, 4],
    [2, 6, 3],
    [3, 6, 7],
    [0, 4, 2],
    [2, 4, 6],
    [1, 3, 5],
    [3, 7, 5],
];

/// Whether each edge occurs once in each direction.
fn is_oriented(faces: &[Face]) -> bool {
    let edges = || faces.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    edges().all(|[a, b]| {
        let count = |wanted: [usize; 2]| edges().filter(|&edge| edge == wanted).count();
        count([a, b]) == 1 && count([b, a]) == 1
    })
}

#[test]
fn the_table_in_flash_is_what_quantise_makes() {
    let [table, report] = printed("quantise", &["--close"], &directory("table"));
    assert_eq!(table, include_str!("../../assets/teapot.rs"));
    assert!(report.contains("1044 faces") && report.contains("closed, parts: 4"), "{report}");
    let clamps = concat!(env!("CARGO_MANIFEST_DIR"), "/../keep_out/clamps.obj");
    let [table, report] = printed("quantise", &[clamps, "--whole"], &directory("whole"));
    assert_eq!(table, include_str!("../../keep_out/clamps.rs"));
    assert!(report.contains("1308 faces") && report.contains("closed, parts: 24"), "{report}");
}

/// Without `--close` the teapot is open. Then there is no table of parts, which a test for inside
/// could use by mistake.
#[test]
fn an_open_mesh_has_no_parts() {
    let [table, report] = printed("quantise", &[], &directory("open"));
    assert!(report.contains("open at 64 edges") && report.contains("--close"), "{report}");
    assert!(table.contains("FACES: [[u16; 3]; 992]") && !table.contains("PARTS"));
}

/// Each subset of the faces of a cuboid is closed again, with the same orientation.
#[test]
fn holes_of_every_shape_are_closed() {
    assert!(open_edges(&CUBOID).is_empty() && caps(&CUBOID).is_empty());
    for kept in 1..1 << CUBOID.len() {
        let mut faces: Vec<Face> =
            (0..CUBOID.len()).filter(|i| kept >> i & 1 == 1).map(|i| CUBOID[i]).collect();
        let holes = open_edges(&faces).len();
        let caps = caps(&faces);
        assert_eq!(caps.is_empty(), holes == 0, "{kept:b}");
        faces.extend(caps);
        assert!(open_edges(&faces).is_empty(), "{kept:b}");
    }
    // A hole of one face gets that face back; a hole of four edges gets two faces.
    for hole in 0..CUBOID.len() {
        let mut faces = CUBOID.to_vec();
        faces.remove(hole);
        assert_eq!(open_edges(&faces).len(), 3);
        faces.extend(caps(&faces));
        assert!(faces.len() == CUBOID.len() && is_oriented(&faces), "{hole}");
    }
    let mut faces = CUBOID[2..].to_vec();
    assert_eq!(open_edges(&faces).len(), 4);
    faces.extend(caps(&faces));
    assert!(faces.len() == CUBOID.len() && is_oriented(&faces));
}

#[test]
fn parts_share_no_edge() {
    // Two cuboids that share a vertex, with interleaved faces, and a separate face.
    let second = CUBOID.map(|face| face.map(|i| i + 7));
    let mut faces: Vec<Face> = CUBOID.into_iter().zip(second).flat_map(<[_; 2]>::from).collect();
    faces.push([20, 21, 22]);
    assert_eq!(sort_into_parts(&mut faces), [0..12, 12..24, 24..25]);
    assert_eq!(faces[..12], CUBOID);
    assert_eq!(faces[12..24], second);
}

/// Rounding may merge vertices. A face that then repeats a vertex bounds nothing.
#[test]
fn degenerate_faces_leave_a_mesh_closed() {
    let merged = |i: usize| if i == 7 { 3 } else { i };
    let faces = CUBOID.map(|face| face.map(merged));
    assert!(open_edges(&faces).is_empty());
    assert!(faces.iter().any(|&[a, b, c]| a == b || b == c || c == a));
}

/// The whole process, from a file with a hole to a table.
#[test]
fn a_box_without_a_lid() {
    let directory = directory("box");
    let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n";
    let face = |[a, b, c]: Face| format!("f {} {} {}\n", a + 1, b + 1, c + 1);
    let faces: String = CUBOID[2..].iter().map(|&f| face(f)).collect();
    fs::write(directory.join("box.obj"), format!("{corners}{faces}")).unwrap();
    let [table, report] = printed("quantise", &["box.obj"], &directory);
    assert!(report.contains("open at 4 edges") && !table.contains("PARTS"), "{report}");
    let [table, report] = printed("quantise", &["box.obj", "--close"], &directory);
    assert!(report.contains("12 faces") && report.contains("parts: 1"), "{report}");
    assert!(table.contains("PARTS: [core::ops::Range<usize>; 1] = [0..12];"), "{table}");
}

/// The name of a file stays in the comment that names it, whatever it has in it.
#[test]
fn a_name_stays_in_its_comment() {
    let directory = directory("name");
    let name = "a\nstatic B: u8 = 0; \u{202e}\r'é.obj";
    fs::write(directory.join(name), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let [table, _] = printed("quantise", &[name], &directory);
    let says = r"// The a\nstatic B: u8 = 0; \u{202e}\r\'é in I16F16, made by `quantise`.";
    assert_eq!(table.lines().next(), Some(says));
    assert!(!table.contains("\nstatic B"));
}

/// A field with nearly as many faces as 16 bits can tell apart, and one with more.
#[test]
fn indices_are_as_wide_as_they_must() {
    let directory = directory("wide");
    for (rows, bits) in [(2, 16), (129, 16), (130, 32)] {
        let vertices: String =
            (0..rows * 256).map(|i| format!("v {} {} 0\n", i % 256, i / 256)).collect();
        let quads = (0..(rows - 1) * 256).filter(|i| i % 256 != 255);
        let faces: String =
            quads.map(|i| format!("f {} {} {} {}\n", i + 1, i + 2, i + 258, i + 257)).collect();
        fs::write(directory.join("field.obj"), format!("{vertices}{faces}")).unwrap();
        let [table, report] = printed("quantise", &["field.obj"], &directory);
        let count = 510 * (rows - 1);
        assert!(table.contains(&format!("FACES: [[u{bits}; 3]; {count}]")), "{report}");
    }
}
