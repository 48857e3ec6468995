//! The program `voxelize`, run as a user runs it: its files, its counts, and its errors.

mod desk;
mod formats;
mod refused;

use std::fs;

use desk::{Desk, TRIANGLE, cuboid, figure};

const SCALARS: [&str; 5] = ["f32", "f64", "i8f8", "i16f16", "i32f32"];
const METHODS: [&str; 6] =
    ["rows", "per-voxel", "exact-pairs", "conservative", "published", "rounded"];

#[test]
fn teapot_without_arguments_but_a_resolution() {
    let desk = Desk::new("teapot");
    let report = desk.succeed("--resolution 24");
    assert!(report.contains("teapot, 992 triangles"), "{report}");
    assert!(report.contains("24 × 12 × 15 voxels"), "{report}");
    assert!(figure(&report, "set") > 500);
    let each = desk.succeed("--resolution 24 --method per-voxel --no-picture");
    assert!(figure(&each, "tests") > figure(&each, "set"));
    assert_eq!(figure(&each, "set"), figure(&report, "set"));

    let file = fs::File::open(desk.0.join("out/teapot.png")).unwrap();
    let mut picture = png::Decoder::new(std::io::BufReader::new(file)).read_info().unwrap();
    let mut pixels = vec![0; picture.output_buffer_size().unwrap()];
    let info = picture.next_frame(&mut pixels).unwrap();
    assert_eq!((info.width, info.height), (900, 700));
    // The background in the corner; somewhere the blue of the foot and the red of the lid.
    assert!(pixels[..3].iter().all(|&c| c > 200));
    let any = |what: fn(&[u8]) -> bool| pixels.chunks_exact(3).any(what);
    assert!(any(|c| c[0] < c[2] / 2) && any(|c| c[2] < c[0] / 2));
}

#[test]
fn report_and_model_agree() {
    let desk = Desk::new("agree");
    let report = desk.succeed("-r 30 -o a.png --vox a.vox");
    let model = desk.model("-r 30");
    let set = model.models[0].voxels.len() as u64;
    assert_eq!(figure(&report, "set"), set);
    assert_eq!((model.models[0].size.x, model.models[0].size.z), (30, 15));
}

#[test]
fn scalars_agree_on_the_teapot() {
    let desk = Desk::new("scalars");
    let reference = desk.voxels("-r 32 -s f64");
    for scalar in ["f32", "i16f16", "i32f32"] {
        assert_eq!(desk.voxels(&format!("-r 32 -s {scalar}")), reference, "{scalar}");
    }
    // Conservative: all of these, and few more.
    let conservative = desk.voxels("-r 32 -s f32 -m conservative");
    assert!(reference.iter().all(|v| conservative.binary_search(v).is_ok()));
    assert!(conservative.len() < reference.len() * 101 / 100);
}

/// Every face of both boxes lies between two layers of voxels: closed sets touch both, and rounding
/// would drop one of them.
#[test]
fn faces_on_the_grid_touch_both_sides() {
    let desk = Desk::new("on-grid");
    // For both k = 8 and k = 32, k / 49 * 49 is not k in f64.
    desk.write("boxes.obj", cuboid([0; 3], [49; 3], 0) + &cuboid([8; 3], [32; 3], 8));
    let outer = 49_u64.pow(3) - 47_u64.pow(3);
    let inner = 26_u64.pow(3) - 22_u64.pow(3);
    for scalar in SCALARS {
        let report = desk.succeed(&format!("boxes.obj -r 49 -s {scalar} --no-picture"));
        assert_eq!(figure(&report, "set"), outer + inner, "{scalar}");
    }
}

#[test]
fn every_method_and_scalar_runs() {
    let desk = Desk::new("methods");
    desk.write("box.obj", cuboid([-2, 5, 9], [1, 7, 10], 0));
    for method in METHODS {
        for scalar in SCALARS {
            let report =
                desk.succeed(&format!("box.obj -r 6 -m {method} -s {scalar} --no-picture"));
            assert!(report.contains("6 × 4 × 2 voxels"), "{report}");
            // Two layers have no inside.
            assert_eq!(figure(&report, "set"), 48, "{method} {scalar}");
        }
    }
}

#[test]
fn i8f8_holds_255() {
    let desk = Desk::new("i8f8");
    desk.write("segment.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n");
    assert_eq!(desk.voxels("segment.obj -r 255 -s i8f8").len(), 255);
    desk.fail("segment.obj -r 256 -s i8f8", &["i8f8 can hold at most 255", "i16f16"]);
}

/// One mesh in four files.
#[test]
fn formats_agree() {
    let desk = Desk::new("formats");
    let facet = "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 4 0 0\nvertex 0 3 1\nendloop\nendfacet\n";
    let mut binary = b"solid, says a binary file".to_vec();
    binary.resize(80, b' ');
    binary.extend(1_u32.to_le_bytes());
    for x in [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0, 3.0, 1.0_f32] {
        binary.extend(x.to_le_bytes());
    }
    binary.extend([0, 0]);
    desk.write("a.obj", TRIANGLE);
    desk.write(
        "b.obj",
        "mtllib none.mtl\nv 0 0 0\nv 4 0 0 \\\n\nv 0 3 1\nvt 0 0\nf -3/1 2/9/9 3//7 # late\n",
    );
    desk.write("c.stl", format!("solid\n{facet}endsolid\n"));
    desk.write("d.stl", &binary);
    desk.write("e.stl", format!("solid one\nendsolid one\nsolid two\n{facet}endsolid two\n"));

    // With z up, the axes of the model are those of the file.
    let reference = desk.voxels("a.obj -r 8 --up z");
    assert!(reference.contains(&[0, 0, 0]) && reference.contains(&[7, 0, 0]));
    assert!(reference.contains(&[0, 5, 1]) && !reference.contains(&[0, 0, 1]));
    for file in ["b.obj --up z", "c.stl", "d.stl", "e.stl"] {
        assert_eq!(desk.voxels(&format!("{file} -r 8")), reference, "{file}");
    }
}

#[test]
fn rules_and_the_inside() {
    let desk = Desk::new("rules");
    // Faces between two layers, 14 voxels apart, in a grid of 16 that two points span.
    let span =
        format!("{}v -1 -1 -1\nv 15 15 15\nf 9 9 9\nf 10 10 10\n", cuboid([0; 3], [14; 3], 0));
    desk.write("box.obj", &span);
    let set = |options: &str| {
        figure(&desk.succeed(&format!("box.obj -r 16 --no-picture {options}")), "set")
    };
    let closed = 16_u64.pow(3) - 12_u64.pow(3);
    assert_eq!(set(""), closed);
    let half_open = set("--rule half-open");
    assert!(half_open > 15_u64.pow(3) - 13_u64.pow(3) && half_open < closed / 2 + 100);
    assert!(set("--rule thin") < half_open);
    assert_eq!(set("--solid"), 16_u64.pow(3));
    for threads in 1..4 {
        assert_eq!(set(&format!("--rule thin --threads {threads}")), set("--rule thin"));
    }
    let report = desk.succeed("box.obj -r 16 --no-picture --solid");
    assert!(report.contains("closed along every row"), "{report}");
    let open: String =
        span.lines().filter(|line| *line != "f 2 4 8 6").map(|l| format!("{l}\n")).collect();
    desk.write("open.obj", open);
    let report = desk.succeed("open.obj -r 16 --no-picture --solid");
    assert!(report.contains("the mesh is open: 196 rows"), "{report}");
    desk.fail("box.obj --rule thin --method per-voxel", &["--rule thin", "--method rows"]);
}

/// The faces at the greatest coordinates belong to the voxels after them.
#[test]
fn a_cube_keeps_its_sides_by_every_rule() {
    let desk = Desk::new("upper");
    desk.write("cube.obj", cuboid([0; 3], [30; 3], 0));
    // By the thin rule a face marks no voxel beyond its edges.
    for (rule, expected) in [
        ("closed", 30_u64.pow(3) - 28_u64.pow(3)),
        ("half-open", 31_u64.pow(3) - 29_u64.pow(3)),
        ("thin", 6 * 30_u64.pow(2) - 3 * 30 + 1),
    ] {
        for scalar in SCALARS {
            let report =
                desk.succeed(&format!("cube.obj -r 30 --rule {rule} -s {scalar} --no-picture"));
            assert_eq!(figure(&report, "set"), expected, "{rule} {scalar}");
        }
    }
    desk.fail("cube.obj -r 255 -s i8f8 --rule thin", &["i8f8 can hold at most 254", "i16f16"]);
}

/// Far from the origin `f32` holds no difference of these coordinates.
#[test]
fn vertices_are_read_in_f64() {
    let desk = Desk::new("far");
    desk.write("a.obj", TRIANGLE);
    let far =
        TRIANGLE.replace("v 0 ", "v 4503599627370496 ").replace("v 4 ", "v 4503599627370500 ");
    desk.write("b.obj", far);
    assert_eq!(desk.voxels("a.obj -r 8 -s f64"), desk.voxels("b.obj -r 8 -s f64"));
    desk.write("marked.obj", format!("\u{feff}{TRIANGLE}"));
    assert_eq!(desk.voxels("a.obj -r 8"), desk.voxels("marked.obj -r 8"));
}

#[test]
fn several_meshes_and_gltf() {
    let desk = Desk::new("several");
    desk.write("a.obj", cuboid([0; 3], [4; 3], 0));
    desk.write("b.obj", cuboid([6, 0, 0], [8, 4, 4], 0));
    desk.write("both.obj", cuboid([0; 3], [4; 3], 0) + &cuboid([6, 0, 0], [8, 4, 4], 8));
    let both = desk.voxels("both.obj -r 8");
    assert_eq!(desk.voxels("a.obj b.obj -r 8"), both);
    assert!(desk.succeed("a.obj b.obj -r 8 --no-picture").contains("a-b, 24 triangles"));

    // One triangle, moved and scaled by its node.
    let mut buffer = Vec::new();
    for x in [0.0_f32, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 1.5, 0.5] {
        buffer.extend(x.to_le_bytes());
    }
    desk.write("t.bin", &buffer);
    let gltf = r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
        "nodes":[{"mesh":0,"scale":[2,2,2],"translation":[7,8,9]}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
        "buffers":[{"byteLength":36,"uri":"t.bin"}],
        "bufferViews":[{"buffer":0,"byteLength":36}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
        "min":[0,0,0],"max":[2,1.5,0.5]}]}"#;
    desk.write("t.gltf", gltf);
    desk.write("t.obj", TRIANGLE);
    assert_eq!(desk.voxels("t.gltf -r 8"), desk.voxels("t.obj -r 8"));
    desk.write("cut.gltf", gltf.replace("t.bin", "none.bin"));
    desk.fail("cut.gltf", &["cut.gltf", "none.bin"]);
    desk.write("no.glb", "glTF");
    desk.fail("no.glb", &["no.glb", "not a valid glTF"]);
}

/// Numbers of another type than theirs, or fewer than are said to be there.
#[test]
fn gltf_that_is_wrong_is_refused() {
    let desk = Desk::new("wrong");
    let mut buffer = Vec::new();
    for x in [0.0_f32, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0, 3.0, 1.0] {
        buffer.extend(x.to_le_bytes());
    }
    buffer.extend([0_u32, 1, 2].map(u32::to_le_bytes).as_flattened());
    desk.write("t.bin", &buffer);
    let gltf = r#"{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
        "buffers":[{"byteLength":48,"uri":"t.bin"}],
        "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":12}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
        "min":[0,0,0],"max":[4,3,1]},
        {"bufferView":1,"componentType":5125,"count":3,"type":"SCALAR"}]}"#;
    desk.write("t.gltf", gltf);
    desk.write("t.obj", TRIANGLE);
    assert_eq!(desk.voxels("t.gltf -r 8"), desk.voxels("t.obj -r 8"));
    let (indices, positions) = ("the indices of a mesh", "the positions of a mesh");
    // All positions are zero but three, given one by one.
    let base = r#""bufferView":0,"componentType":5126,"count":3,"#;
    let sparse = r#""componentType":5126,"count":3,"sparse":{"count":3,
        "indices":{"bufferView":1,"componentType":5125},"values":{"bufferView":0}},"#;
    desk.write("sparse.gltf", gltf.replace(base, sparse));
    assert_eq!(desk.voxels("sparse.gltf -r 8"), desk.voxels("t.obj -r 8"));
    let more = sparse.replace(r#"{"count":3"#, r#"{"count":4"#);
    let many = sparse.replace(r#"5126,"count":3"#, r#"5126,"count":68719476736"#);
    for (from, to, says) in [
        (base, &more[..], [positions, "beyond their buffer"]),
        (r#"5125,"count":3"#, r#"5125,"count":4"#, [indices, "beyond their buffer"]),
        (r#"5125,"count":3"#, r#"5125,"count":1000000000000"#, [indices, "beyond their buffer"]),
        (r#"5125,"count":3"#, r#"5125,"count":2"#, ["a mesh of triangles", "2 corners"]),
        (
            r#"36,"byteLength":12"#,
            r#"36,"byteLength":1000000000"#,
            [indices, "beyond their buffer"],
        ),
        (r#""byteLength":48"#, r#""byteLength":10"#, [positions, "beyond their buffer"]),
        ("5125", "5126", [indices, "a type that is not theirs"]),
        ("VEC3", "VEC2", [positions, "a type that is not theirs"]),
        (r#"5126,"count":3"#, r#"5123,"count":3"#, [positions, "a type that is not theirs"]),
        (
            r#""byteLength":36}"#,
            r#""byteLength":36,"byteStride":4}"#,
            [positions, "one in another"],
        ),
        (r#""POSITION":0"#, r#""POSITION":7"#, ["not a valid glTF", "has no accessor"]),
        (base, &many[..], [positions, "too many zeros"]),
    ] {
        desk.write("wrong.gltf", gltf.replace(from, to));
        desk.fail("wrong.gltf", &["wrong.gltf", says[0], says[1]]);
    }
}

/// The colours of wrong voxels, in the right half only.
#[test]
fn two_methods_side_by_side() {
    let desk = Desk::new("compare");
    let report = desk.succeed("-r 40 -m published --compare rows -s i8f8 -o a.png");
    assert!(report.contains("voxels missed (red)"), "{report}");
    let file = fs::File::open(desk.0.join("a.png")).unwrap();
    let picture = png::Decoder::new(std::io::BufReader::new(file)).read_info().unwrap();
    assert_eq!((picture.info().width, picture.info().height), (1800, 700));
    let cut = desk.succeed("-r 24 --solid --cut -o b.png");
    assert!(desk.exists("b.png") && cut.contains("inside"), "{cut}");
}

/// Colours, and a comment that ends as a line that goes on.
#[test]
fn obj_loses_only_what_is_not_used() {
    let desk = Desk::new("unused");
    desk.write("t.obj", "v 0 0 0\nv 4 0 0\nv 0 3 1\nv 4 3 0\nf 1 2 3\nf 2 4 3\n");
    desk.write(
        "more.obj",
        "# from c:\\\nv 0 0 0 1 0 0\nv 4 0 0\nv 0 3 1 1 0 0 0.5 # red\\\nv 4 3 \\\n 0\n# c:\\\nf 1 2 3\nf 2 \\\n4 3\\",
    );
    assert_eq!(desk.voxels("more.obj -r 8"), desk.voxels("t.obj -r 8"));
}

/// x·255/x is more than 255 for this length.
#[test]
fn the_longest_side_has_as_many_voxels_as_asked_for() {
    let desk = Desk::new("longest");
    desk.write("long.obj", "v 0 0 0\nv 92.725 0 0\nv 0 1 1\nf 1 2 3\n");
    for resolution in [255, 127, 100] {
        let report = desk.succeed(&format!("long.obj -r {resolution} -s i8f8 --no-picture"));
        assert!(report.contains(&format!("{resolution} × ")), "{report}");
    }
}

#[test]
fn flat_meshes_have_one_layer() {
    let desk = Desk::new("flat");
    desk.write("flat.obj", "v 0 0 5\nv 4 0 5\nv 0 4 5\nf 1 2 3\n");
    let report = desk.succeed("flat.obj -r 4 --no-picture");
    assert!(report.contains("4 × 4 × 1 voxels"), "{report}");
    assert_eq!(figure(&report, "set"), 13); // the long side touches corners
}

#[test]
fn help_explains_every_option() {
    let help = Desk::new("help").succeed("--help");
    for option in [
        "[MESH]...",
        "--rule",
        "--solid",
        "--threads",
        "--compare",
        "--cut",
        "--resolution",
        "--scalar",
        "--method",
        "--up",
        "--output",
        "--vox",
    ] {
        assert!(help.contains(option), "{option}");
    }
    for value in SCALARS.iter().chain(&METHODS) {
        assert!(help.contains(&format!("- {value}")), "{value}");
    }
}
