//! Impossible requests: one line reports the error.

use std::fs;

use super::desk::{Desk, TRIANGLE};

#[test]
fn bad_meshes() {
    let desk = Desk::new("bad-meshes");
    desk.fail("missing.obj", &["missing.obj", "No such file"]);
    desk.write("mesh.xyz", "ply");
    desk.fail("mesh.xyz", &["mesh.xyz", "an .obj, an .stl, a .ply"]);
    desk.write("points.ply", PLY_POINTS);
    desk.fail("points.ply", &["points.ply", "no triangles", "no faces"]);
    for (from, to) in
        [("ply", "ply3"), ("x\n", "x\nproperty list\n"), ("vertex 1", "vertex 99999999999")]
    {
        desk.write("bad.ply", PLY_POINTS.replacen(from, to, 1));
        desk.fail("bad.ply", &["bad.ply", "not a valid PLY"]);
    }
    for face in ["3 0 1 2", "3 0 0 -1"] {
        desk.write("face.ply", ply_with_face(face));
        desk.fail("face.ply", &["face.ply", "a vertex that is not there"]);
    }
    desk.write("flat.ply", ply_with_face("3 0 1 1").replace("float z", "float w"));
    desk.fail("flat.ply", &["flat.ply", "no x, y and z"]);
    desk.write("large.obj", TRIANGLE.replace('4', "1e308"));
    desk.fail("large.obj", &["too large"]);
    desk.write("empty.obj", "# nothing\nv 1 2 3\n");
    desk.fail("empty.obj", &["empty.obj", "no triangles"]);
    desk.write("empty.stl", [0; 84]);
    desk.fail("empty.stl", &["empty.stl", "no triangles"]);
    desk.write("nothing.stl", "");
    desk.fail("nothing.stl", &["nothing.stl", "too short"]);
    for x in ["nan", "inf", "-inf", "1e309"] {
        desk.write("number.obj", TRIANGLE.replace('4', x));
        desk.fail("number.obj", &["number.obj", "triangle 1", "NaN or infinite"]);
    }
    desk.write("words.obj", TRIANGLE.replace('4', "four"));
    desk.fail("words.obj", &["words.obj", "not a valid OBJ", "position"]);
    for face in ["f 1 2 4", "f 0 1 2", "f 1 2 -4", "f 1 2 99999999999999999999"] {
        desk.write("index.obj", TRIANGLE.replace("f 1 2 3", face));
        desk.fail("index.obj", &["index.obj", "not a valid OBJ", "face"]);
    }
    desk.write("point.obj", "v 1 2 3\nf 1 1 1\n");
    desk.fail("point.obj", &["single point"]);

    let mut cut = [0; 84 + 50];
    cut[80] = 2;
    desk.write("cut.stl", cut);
    desk.fail("cut.stl", &["cut.stl", "ends before its last triangle"]);
    let mut nan = [0; 84 + 50];
    nan[80] = 1;
    nan[84 + 12..84 + 16].copy_from_slice(&f32::NAN.to_le_bytes());
    desk.write("nan.stl", nan);
    desk.fail("nan.stl", &["nan.stl", "NaN or infinite"]);
    desk.write("text.stl", "solid s\nfacet normal 0 0 0\nouter loop\nvertex 0 nan 0\n");
    desk.fail("text.stl", &["text.stl", "not a valid STL"]);
    assert!(!desk.exists("out"), "no picture of what could not be read");
}

const PLY_POINTS: &str =
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n";

fn ply_with_face(face: &str) -> String {
    format!(
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n\
         property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
         1 2 3\n2 3 4\n{face}\n"
    )
}

#[test]
fn bad_options() {
    let desk = Desk::new("bad-options");
    desk.write("mesh.obj", TRIANGLE);
    desk.fail("mesh.obj --resolution 0", &["resolution 0"]);
    desk.fail("mesh.obj -r 65536 -s i16f16", &["i16f16 can hold at most 65535", "i32f32", "f64"]);
    desk.fail("mesh.obj -r 65537", &["at most 65536"]);
    desk.fail("mesh.obj -r 20000", &["20000 × 15000 × 5000", "GiB", "lower --resolution"]);
    desk.fail("mesh.obj -r 257 --vox a.vox", &["256 voxels a side", "257 × 193 × 65"]);
    desk.fail("mesh.obj -o mesh.obj", &["mesh.obj: is the mesh itself"]);
    for name in [".", "picture", "a.jpg", "a.png.gz", ".png", "-"] {
        desk.fail(&format!("mesh.obj -o {name}"), &[name, ".png, .vox, .npy, .bits or .obj"]);
    }
    desk.fail("mesh.obj -o none.png/", &["cannot be written"]);
    desk.fail("mesh.obj --vox a.obj", &["a.obj", "--vox writes a .vox file"]);
    desk.fail("mesh.obj -o a.npy --cut", &["--cut", "only a picture"]);
    desk.fail("mesh.obj -o a.npy --compare rounded", &["--compare", "only a picture"]);
    desk.fail("mesh.obj -o mesh.obj/a.png", &["mesh.obj/a.png: cannot be written"]);
    desk.fail("mesh.obj -r 4 -o a.vox --vox ./a.vox", &["./a.vox", "written twice"]);
    assert_eq!(fs::read_to_string(desk.0.join("mesh.obj")).unwrap(), TRIANGLE);

    // Usage errors are clap's, with its exit code.
    for arguments in ["-r -5", "-r many", "-s f16", "-m wrong", "--vox", "--rule wide"] {
        let output = desk.run(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments}");
        assert!(output.stderr.starts_with(b"error: "), "{arguments}");
    }
}
