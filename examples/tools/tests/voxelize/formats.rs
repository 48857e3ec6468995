//! The formats that the program reads and writes: all hold the same voxels, and the same mesh.

use std::collections::BTreeSet;
use std::fs;
use std::io::Write;
use std::process::Stdio;

use super::desk::{Desk, TRIANGLE, cuboid, figure};

type Voxels = BTreeSet<[usize; 3]>;

/// The voxels of an array, in the order of the file's axes.
fn array(file: &[u8]) -> ([usize; 3], Voxels) {
    assert_eq!(&file[..8], b"\x93NUMPY\x01\x00");
    let start = 10 + usize::from(u16::from_le_bytes([file[8], file[9]]));
    assert_eq!(start % 64, 0);
    let header = std::str::from_utf8(&file[10..start]).unwrap();
    assert!(header.ends_with('\n') && header.contains("'descr': '|b1', 'fortran_order': True"));
    let (_, shape) = header.split_once("'shape': (").unwrap();
    let mut sides = shape.split([',', ')']).map(|n| n.trim().parse().unwrap());
    let size @ [nx, ny, _] = [0; 3].map(|_| sides.next().unwrap());
    let bytes = &file[start..];
    assert_eq!(bytes.len(), size.iter().product::<usize>());
    let at = |i: usize| [i % nx, i / nx % ny, i / nx / ny];
    (size, (0..bytes.len()).filter(|&i| bytes[i] == 1).map(at).collect())
}

/// The voxels of raw bits, the least corner and the edge of a voxel.
fn bits(file: &[u8]) -> ([usize; 3], Voxels, [f64; 3], f64) {
    let start = file.windows(6).position(|w| w == b"\ndata\n").unwrap() + 6;
    let header = std::str::from_utf8(&file[..start]).unwrap();
    let numbers = |name: &str| -> Vec<f64> {
        let line = header.lines().find(|line| line.starts_with(name)).unwrap();
        line.split(' ').skip(1).map(|x| x.parse().unwrap()).collect()
    };
    let size @ [nx, ny, nz] = [0, 1, 2].map(|i| numbers("size")[i] as usize);
    let row = numbers("row_bytes")[0] as usize;
    assert_eq!(file.len() - start, row * ny * nz);
    let mut voxels = Voxels::new();
    for (i, byte) in file[start..].iter().enumerate() {
        for bit in (0..8).filter(|bit| byte >> bit & 1 == 1) {
            let x = 8 * (i % row) + bit;
            assert!(x < nx);
            voxels.insert([x, i / row % ny, i / row / ny]);
        }
    }
    (size, voxels, [0, 1, 2].map(|i| numbers("origin")[i]), numbers("edge")[0])
}

/// Three formats hold the voxels of the model, along the axes of the file: also where z is up.
#[test]
fn written_formats_agree() {
    let desk = Desk::new("written");
    desk.write("mesh.obj", cuboid([0, 0, 0], [70, 5, 3], 0) + &cuboid([1, 2, 0], [9, 9, 9], 8));
    for (up, resolution) in [("y", 70), ("z", 70), ("z", 33)] {
        let arguments = format!("mesh.obj --up {up} -r {resolution}");
        desk.succeed(&format!("{arguments} -o a.npy -o b.bits -o c.obj --vox d.vox"));
        let read = |name: &str| fs::read(desk.0.join(name)).unwrap();
        let (size, voxels) = array(&read("a.npy"));
        let (also, packed, origin, edge) = bits(&read("b.bits"));
        assert!(size == also && voxels == packed, "{arguments}");
        // The model has z up.
        let model: Voxels = desk
            .voxels(&arguments)
            .into_iter()
            .map(|v| v.map(usize::from))
            .map(|[x, y, z]| if up == "y" { [x, z, size[2] - 1 - y] } else { [x, y, z] })
            .collect();
        assert_eq!(voxels, model, "{arguments}");
        assert!(!desk.exists("out"), "no picture was asked for");

        // The cubes are closed, and as large as the voxels: volume by the divergence theorem.
        let cubes = String::from_utf8(read("c.obj")).unwrap();
        let mut corners: Vec<[f64; 3]> = Vec::new();
        let (mut volume, mut edges) = (0.0, BTreeSet::new());
        for line in cubes.lines() {
            let words: Vec<&str> = line.split(' ').collect();
            if words[0] == "v" {
                corners.push([1, 2, 3].map(|i| words[i].parse().unwrap()));
                continue;
            }
            let quad = [1, 2, 3, 4].map(|i| words[i].parse::<usize>().unwrap() - 1);
            for i in 0..4 {
                let (from, to) = (quad[i], quad[(i + 1) % 4]);
                // Where four faces meet at an edge, it is twice there.
                if !edges.remove(&(to, from, 0)) && !edges.remove(&(to, from, 1)) {
                    assert!(edges.insert((from, to, 0)) || edges.insert((from, to, 1)));
                }
            }
            let [a, b, c, _] = quad.map(|i| corners[i]);
            let [u, v] = [[0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i])];
            let normal = [0, 1, 2]
                .map(|i| u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3]);
            volume += (0..3).map(|i| a[i] * normal[i]).sum::<f64>() / 3.0;
        }
        assert!(edges.is_empty(), "{arguments}");
        let expected = voxels.len() as f64 * edge.powi(3);
        assert!((volume / expected - 1.0).abs() < 1e-9, "{volume} {expected}");
        // In the units of the file: the mesh begins where the voxels begin.
        let least =
            corners.iter().fold([f64::INFINITY; 3], |m, c| [0, 1, 2].map(|i| m[i].min(c[i])));
        assert!((0..3).all(|i| (least[i] - origin[i]).abs() < 1e-9 && least[i].abs() < edge));
    }
}

/// The same mesh as PLY in text and in both orders of bytes, in a glTF with its buffer inside, and
/// from standard input.
#[test]
fn read_formats_agree() {
    let desk = Desk::new("read");
    desk.write("t.obj", TRIANGLE);
    let reference = desk.voxels("t.obj -r 8");
    let points = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 3.0, 1.0_f32]];
    let head = |format: &str| {
        format!(
            "ply\nformat {format} 1.0\ncomment none\nelement vertex 3\nproperty float x\nproperty \
             float y\nproperty float z\nproperty uchar red\nelement face 1\nproperty list uchar \
             int vertex_indices\nend_header\n"
        )
    };
    let text = head("ascii") + "0 0 0 255\n4 0 0 255\n0 3 1 255\n3 0 1 2\n";
    let [mut little, mut big] =
        ["binary_little_endian", "binary_big_endian"].map(|f| head(f).into_bytes());
    for point in points {
        for x in point {
            little.extend(x.to_le_bytes());
            big.extend(x.to_be_bytes());
        }
        little.push(255);
        big.push(255);
    }
    little.push(3);
    big.push(3);
    for i in 0..3_i32 {
        little.extend(i.to_le_bytes());
        big.extend(i.to_be_bytes());
    }
    // Base64 of nine floats: 0 0 0 4 0 0 0 3 1.
    let uri = "data:application/octet-stream;base64,\
               AAAAAAAAAAAAAAAAAACAQAAAAAAAAAAAAAAAAAAAQEAAAIA/";
    let gltf = format!(
        r#"{{"asset":{{"version":"2.0"}},"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],
        "buffers":[{{"byteLength":36,"uri":"{uri}"}}],
        "bufferViews":[{{"buffer":0,"byteLength":36}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
        "min":[0,0,0],"max":[4,3,1]}}]}}"#
    );
    let files: [(&str, &[u8]); 5] = [
        ("a.ply", text.as_bytes()),
        ("b.ply", &little),
        ("c.PLY", &big),
        ("d.gltf", gltf.as_bytes()),
        ("e.obj", TRIANGLE.as_bytes()),
    ];
    for (name, content) in files {
        desk.write(name, content);
        assert_eq!(desk.voxels(&format!("{name} -r 8")), reference, "{name}");
        let mut process = desk
            .command("- -r 8 -o in.vox")
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .spawn()
            .unwrap();
        process.stdin.take().unwrap().write_all(content).unwrap();
        assert!(process.wait().unwrap().success(), "{name}");
        desk.succeed(&format!("{name} -r 8 -o file.vox"));
        let [by_input, by_file] =
            ["in.vox", "file.vox"].map(|name| fs::read(desk.0.join(name)).unwrap());
        assert_eq!(by_input, by_file, "{name}");
    }
    for (from, to, says) in [
        (";base64", "", "not in base64"),
        ("AACA", "AA!A", "data URI"),
        ("data:", "beside:", "No such file"),
    ] {
        desk.write("bad.gltf", gltf.replacen(from, to, 1));
        desk.fail("bad.gltf", &["bad.gltf", says]);
    }
}

/// An STL file in text begins with "solid" in letters of either case, after blanks; a binary one may
/// begin so too.
#[test]
fn stl_in_text_or_binary() {
    let desk = Desk::new("stl");
    desk.write("t.obj", TRIANGLE);
    let reference = desk.voxels("t.obj -r 8 --up z");
    let text = "solid s\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 4 0 0\nvertex 0 3 1\n\
                endloop\nendfacet\nendsolid s\n";
    let mut binary = b"solid of a binary file".to_vec();
    binary.resize(80, b' ');
    binary.extend([1, 0, 0, 0]);
    for x in [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 0.0, 3.0, 1.0_f32] {
        binary.extend(x.to_le_bytes());
    }
    binary.extend([0, 0]);
    let capitals = text.to_ascii_uppercase();
    let files = [
        ("text", text.into()),
        ("capitals", capitals.clone().into_bytes()),
        ("one capital", text.replace("solid", "Solid").into_bytes()),
        ("after blanks", format!("\n\t {text}").into_bytes()),
        ("capitals after blanks", format!("\r\n {capitals}").into_bytes()),
        ("binary in capitals", [b"SOLID", &binary[5..]].concat()),
        ("binary after blanks", [b"\n ", &binary[..78], &binary[80..]].concat()),
        ("binary with more at its end", [&binary[..], &[0, 0]].concat()),
        ("binary", binary),
    ];
    for (name, content) in files {
        desk.write("s.stl", &content);
        assert_eq!(desk.voxels("s.stl -r 8"), reference, "{name}");
        // From standard input the format is known by what it begins with.
        let mut process = desk
            .command("- -r 8 --no-picture --up z --vox in.vox")
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .spawn()
            .unwrap();
        process.stdin.take().unwrap().write_all(&content).unwrap();
        assert!(process.wait().unwrap().success(), "{name}");
    }
}

/// Without files to write, a large grid is counted slab by slab.
#[test]
fn large_grids_are_counted() {
    let desk = Desk::new("large");
    desk.write("cross.obj", "v 0 0 0\nv 1 1 1\nv 0 1 0\nv 1 0 1\nf 1 2 2\nf 3 4 4\n");
    let report = desk.succeed("cross.obj -r 4096 --no-picture");
    assert!(report.contains("4096 × 4096 × 4096 voxels"), "{report}");
    // Each diagonal has 4096 voxels, and touches six more at each of their 4095 corners; in the
    // middle the diagonals share a corner, and there all eight voxels.
    assert_eq!(figure(&report, "set"), 2 * (4096 + 6 * 4095) - 8);
    desk.fail("cross.obj -r 4096", &["8.0 GiB", "--no-picture"]);
}
