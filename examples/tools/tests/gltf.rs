//! glTF files: which way their triangles face, the names of their buffers, and their nodes.

use std::fs;
use std::path::Path;

use super::{directory, printed, run};

/// A ladder in the plane z = 0, six vertices along x.
const LADDER: [[f32; 3]; 6] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [1.0, 2.0, 0.0],
    [0.0, 3.0, 0.0],
    [1.0, 4.0, 0.0],
];

/// Writes a file whose mesh 0 has the ladder's vertices, and a buffer beside it.
fn write(directory: &Path, mode: u32, nodes: &str, buffer: &str) {
    let bytes: Vec<u8> = LADDER.as_flattened().iter().flat_map(|x| x.to_le_bytes()).collect();
    fs::write(directory.join("my mesh.bin"), bytes).unwrap();
    let text = format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{nodes}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"mode":{mode}}}]}}],
        "buffers":[{{"byteLength":72,"uri":"{buffer}"}}],
        "bufferViews":[{{"buffer":0,"byteLength":72}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":6,"type":"VEC3",
        "min":[0,0,0],"max":[1,4,0]}}]}}"#
    );
    fs::write(directory.join("ladder.gltf"), text).unwrap();
}

/// Twice the areas of the triangles in a table of `quantise`, as they are seen from +z: negative from
/// the back.
fn areas(table: &str) -> Vec<i64> {
    let body = |name: &str| -> Vec<i64> {
        let (_, rest) = table.split_once(&format!("static {name}: ")).unwrap();
        let (_, rest) = rest.split_once("= [").unwrap();
        let is_part = |c: char| c.is_ascii_digit() || c == '-';
        let words = rest.split_once("];").unwrap().0.split(|c| !is_part(c));
        words.filter_map(|word| word.parse().ok()).collect()
    };
    let (vertices, faces) = (body("VERTICES"), body("FACES"));
    let area = |face: &[i64]| {
        let [a, b, c] = [0, 1, 2].map(|i| &vertices[3 * face[i] as usize..][..2]);
        ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) >> 32
    };
    faces.chunks(3).map(area).collect()
}

/// Triangle i of a strip is v_i, v_(i+1+i%2), v_(i+2-i%2); and under a node whose global transform has
/// a negative determinant the front is clockwise.
#[test]
fn triangles_keep_their_front() {
    let directory = directory("gltf-front");
    let (strip, list) = (5, 4);
    let below =
        |parent: &str, child: &str| format!(r#"{{{parent},"children":[1]}},{{"mesh":0,{child}}}"#);
    let cases = [
        (strip, r#"{"mesh":0}"#.into(), vec![1, 2, 2, 2]),
        (list, r#"{"mesh":0}"#.into(), vec![-2, 1]),
        (strip, r#"{"mesh":0,"scale":[-1,1,1]}"#.into(), vec![1, 2, 2, 2]),
        (list, r#"{"mesh":0,"scale":[-1,1,1]}"#.into(), vec![-2, 1]),
        // A node in a node: turned about z and mirrored, in either order, and mirrored twice.
        (strip, below(r#""scale":[1,-2,1]"#, r#""rotation":[0,0,1,0]"#), vec![2, 4, 4, 4]),
        (strip, below(r#""rotation":[0,0,1,0]"#, r#""scale":[1,-2,1]"#), vec![2, 4, 4, 4]),
        (strip, below(r#""scale":[1,-1,1]"#, r#""scale":[-1,1,1]"#), vec![1, 2, 2, 2]),
        // In z the flat ladder stays, but is seen from its back.
        (strip, r#"{"mesh":0,"scale":[1,1,-1]}"#.into(), vec![-2, -2, -2, -1]),
    ];
    for (mode, nodes, expected) in cases {
        write(&directory, mode, &nodes, "my mesh.bin");
        let [table, _] = printed("quantise", &["ladder.gltf"], &directory);
        let mut found = areas(&table);
        found.sort_unstable();
        assert_eq!(found, expected, "{mode} {nodes}");
    }
}

/// The name of a buffer is a URI.
#[test]
fn names_of_buffers_are_decoded() {
    let directory = directory("gltf-uri");
    for uri in ["my mesh.bin", "my%20mesh.bin", "%6D%79%20mesh%2ebin"] {
        write(&directory, 5, r#"{"mesh":0}"#, uri);
        printed("quantise", &["ladder.gltf"], &directory);
    }
    // What is no code stays.
    fs::copy(directory.join("my mesh.bin"), directory.join("50%+1é%.bin")).unwrap();
    write(&directory, 5, r#"{"mesh":0}"#, "50%+1%c3%A9%.bin");
    printed("quantise", &["ladder.gltf"], &directory);
    write(&directory, 5, r#"{"mesh":0}"#, "%FF.bin");
    let output = run("quantise", &["ladder.gltf"], &directory);
    assert!(String::from_utf8(output.stderr).unwrap().contains("%FF.bin is not in UTF-8"));
}

/// Nodes that have two parents, or one twice, are no tree: there are 2^24 ways to the last of these.
#[test]
fn nodes_are_a_tree() {
    let directory = directory("gltf-tree");
    let doubled: Vec<String> =
        (1..=24).map(|i| format!(r#"{{"children":[{i},{i}]}}"#)).chain(["{}".into()]).collect();
    for (nodes, twice) in [
        (doubled.join(","), "node 24"),
        (r#"{"mesh":0,"children":[1]},{"children":[0]}"#.into(), "node 0"),
        (r#"{"mesh":0,"children":[1,2]},{"children":[2]},{}"#.into(), "node 2"),
    ] {
        write(&directory, 5, &nodes, "my mesh.bin");
        let output = run("quantise", &["ladder.gltf"], &directory);
        let errors = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{errors}");
        assert!(errors.contains(&format!("{twice} is reached twice")), "{errors}");
    }
}
