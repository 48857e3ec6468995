//! The table: the mesh with rounded vertices, as a Rust file.

use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::Write;
use std::ops::Range;

use fixed::traits::{Fixed, ToFixed};
use septum::Scalar;
use septum::mesh::{MeshError, Node, OwnedTree};
use septum_tools::mesh::Mesh;

use crate::options::Options;
use crate::solid::{Face, caps, open_edges, sort_into_parts};

/// A mesh with rounded vertices, each once.
struct Rounded<S> {
    vertices: Vec<[S; 3]>,
    faces: Vec<Face>,
    /// The greatest change of a coordinate.
    moved: f64,
}

impl<S: Fixed> Rounded<S> {
    fn new(mesh: &Mesh, scale: f64, scalar: &str) -> Result<Self, Box<dyn Error>> {
        let mut places = BTreeMap::new();
        let (mut vertices, mut faces, mut moved) = (Vec::new(), Vec::new(), 0.0_f64);
        for triangle in &mesh.triangles {
            let mut face = [0; 3];
            for (corner, point) in face.iter_mut().zip(triangle) {
                let mut rounded = [S::ZERO; 3];
                for (to, x) in rounded.iter_mut().zip(point.map(|x| x * scale)) {
                    *to = x.checked_to_fixed().ok_or_else(|| {
                        format!("{x:e} is beyond the range of {scalar}: see --scale")
                    })?;
                    moved = moved.max((to.to_num::<f64>() - x).abs());
                }
                let next = vertices.len();
                *corner = *places.entry(rounded).or_insert(next);
                if *corner == next {
                    vertices.push(rounded);
                }
            }
            faces.push(face);
        }
        Ok(Self { vertices, faces, moved })
    }
}

/// The mesh as a Rust file.
pub(crate) fn write<S: Fixed<Bits: std::fmt::Display> + Scalar>(
    mesh: &Mesh,
    options: &Options,
) -> Result<String, Box<dyn Error>> {
    let scalar = format!("{:?}", options.scalar);
    let Rounded { vertices, mut faces, moved } = Rounded::<S>::new(mesh, options.scale, &scalar)?;
    if options.close {
        faces.extend(caps(&faces));
    }
    let open = open_edges(&faces).len();
    let mut parts = if open == 0 { sort_into_parts(&mut faces) } else { Vec::new() };
    let closed = parts.len();
    if options.whole {
        parts.clear();
    }
    let whole = 0..faces.len();
    let trees = if parts.is_empty() { std::slice::from_ref(&whole) } else { &parts };
    let nodes = sort_into_trees(&vertices, &mut faces, trees)?;
    eprintln!(
        "{}: {} vertices, {} faces, {} bytes; rounded by at most {moved:.2e}",
        mesh.name,
        vertices.len(),
        faces.len(),
        vertices.len() * 3 * size_of::<S>()
            + faces.len() * 3 * index_bytes(&vertices, &faces)
            + size_of_val(&nodes[..]),
    );
    match open {
        0 => eprintln!("closed, parts: {closed}"),
        _ => eprintln!("open at {open} edges: it has no inside; --close fills its holes"),
    }
    text(&mesh.name, &scalar, &vertices, &faces, &nodes, &parts)
}

/// Builds a tree over each of these ranges of faces: returns the nodes, and sorts the faces into
/// its order.
fn sort_into_trees<S: Scalar>(
    vertices: &[[S; 3]],
    faces: &mut [Face],
    ranges: &[Range<usize>],
) -> Result<Vec<Node>, MeshError> {
    let mut all = Vec::new();
    for range in ranges {
        let faces = &mut faces[range.clone()];
        let triangles: Vec<_> = faces.iter().map(|face| face.map(|i| i as u32)).collect();
        let built = OwnedTree::new(vertices.iter().copied(), triangles.iter().copied())?;
        let tree = built.as_tree();
        for (face, i) in faces.iter_mut().zip(tree.order()) {
            *face = triangles[i].map(|i| i as usize);
        }
        all.extend_from_slice(tree.nodes());
    }
    Ok(all)
}

/// The size of an index: 16 bits if there are as many vertices and faces at most.
fn index_bytes<S>(vertices: &[[S; 3]], faces: &[Face]) -> usize {
    if vertices.len().max(faces.len()) <= 1 << 16 { 2 } else { 4 }
}

fn text<S: Fixed<Bits: std::fmt::Display>>(
    name: &str,
    scalar: &str,
    vertices: &[[S; 3]],
    faces: &[Face],
    nodes: &[Node],
    parts: &[Range<usize>],
) -> Result<String, Box<dyn Error>> {
    // A file's name may have a line's end, which would end the comment.
    let name = name.escape_debug();
    let mut out = format!("// The {name} in {scalar}, made by `quantise`.\n\n");
    writeln!(out, "use fixed::types::{scalar};\nuse septum::{{Vec3, mesh::Node}};\n")?;
    let bits = format!("i{}", 8 * size_of::<S>());
    writeln!(out, "const fn v(x: {bits}, y: {bits}, z: {bits}) -> Vec3<{scalar}> {{")?;
    writeln!(
        out,
        "    Vec3::new({scalar}::from_bits(x), {scalar}::from_bits(y), {scalar}::from_bits(z))\n}}\n"
    )?;
    writeln!(out, "const fn n(bits: [[u16; 4]; 6]) -> Node {{\n    Node::from_bits(bits)\n}}\n")?;
    writeln!(out, "pub(crate) static VERTICES: [Vec3<{scalar}>; {}] = [", vertices.len())?;
    for row in vertices.chunks(4) {
        let of =
            |[x, y, z]: &[S; 3]| format!("v({}, {}, {}),", x.to_bits(), y.to_bits(), z.to_bits());
        writeln!(out, "    {}", row.iter().map(of).collect::<Vec<_>>().join(" "))?;
    }
    writeln!(
        out,
        "];\n\npub(crate) static FACES: [[u{}; 3]; {}] = [",
        8 * index_bytes(vertices, faces),
        faces.len()
    )?;
    for row in faces.chunks(8) {
        let of = |face: &Face| format!("{face:?},");
        writeln!(out, "    {}", row.iter().map(of).collect::<Vec<_>>().join(" "))?;
    }
    let whose = if parts.is_empty() { "The tree over all faces" } else { "A tree over each part" };
    writeln!(
        out,
        "];\n\n// {whose}, in whose order the faces are.\npub(crate) static NODES: [Node; {}] = [",
        nodes.len()
    )?;
    for node in nodes {
        writeln!(out, "    n({:?}),", node.to_bits())?;
    }
    writeln!(out, "];")?;
    if !parts.is_empty() {
        writeln!(
            out,
            "\n// The faces of each part. Every part is closed: each edge has an even number of \
             faces.\npub(crate) static PARTS: [core::ops::Range<usize>; {}] = {parts:?};",
            parts.len()
        )?;
    }
    Ok(out)
}
