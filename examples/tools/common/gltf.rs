//! glTF 2.0: the triangles of the scene, with each node in its place.

use std::error::Error;
use std::path::Path;

use ::gltf::accessor::{Accessor, DataType, Dimensions};
use ::gltf::buffer::Source;
use ::gltf::mesh::Mode;
use ::gltf::scene::Node;
use ::gltf::{Document, Gltf, Primitive, Semantic};
use base64::prelude::{BASE64_STANDARD, Engine};

use crate::mesh::Triangles;

type Matrix = [[f64; 4]; 4];

const IDENTITY: Matrix =
    [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

/// Deeper nodes are taken for an attack.
const DEEPEST: usize = 256;

/// More zeros that the file does not hold are taken for one as well.
const MOST_ZEROS: usize = 1 << 24;

/// Reads a .glb, or a .gltf with its buffers inside, or in files beside its path.
pub(crate) fn read(bytes: &[u8], path: Option<&Path>) -> Result<Triangles, Box<dyn Error>> {
    let broken = |e| format!("not a valid glTF file: {e}");
    let Gltf { document, blob } = Gltf::from_slice_without_validation(bytes).map_err(broken)?;
    let json = document.into_json();
    // The library would look for the positions before it checks their index.
    let attributes = || json.meshes.iter().flat_map(|mesh| &mesh.primitives).map(|p| &p.attributes);
    if attributes().flat_map(|all| all.values()).any(|of| of.value() >= json.accessors.len()) {
        return Err("not a valid glTF file: an attribute of a mesh has no accessor".into());
    }
    let file = Document::from_json(json).map_err(broken)?;
    let mut buffers = Vec::new();
    for buffer in file.buffers() {
        let data = match buffer.source() {
            Source::Bin => blob.clone().ok_or("the .glb has no binary part")?,
            Source::Uri(uri) => match (uri.strip_prefix("data:"), path) {
                (Some(data), _) => in_text(data)?,
                (None, Some(path)) => {
                    let place = path.with_file_name(decoded(uri)?);
                    std::fs::read(&place).map_err(|e| format!("{}: {e}", place.display()))?
                }
                (None, None) => return Err(format!("its buffer {uri} is a file beside it").into()),
            },
        };
        if data.len() < buffer.length() {
            return Err("a buffer ends too early".into());
        }
        buffers.push(data);
    }
    let scene = file.default_scene().or_else(|| file.scenes().next());
    let mut walk =
        Walk { buffers, is_reached: vec![false; file.nodes().len()], triangles: Vec::new() };
    for node in scene.iter().flat_map(|scene| scene.nodes()) {
        walk.collect(&node, &IDENTITY, 0)?;
    }
    Ok(walk.triangles)
}

/// The bytes of a data URI, after `data:`.
fn in_text(uri: &str) -> Result<Vec<u8>, Box<dyn Error>> {
    let (_, text) = uri.split_once(";base64,").ok_or("a buffer's data URI is not in base64")?;
    BASE64_STANDARD.decode(text).map_err(|e| format!("a buffer's data URI: {e}").into())
}

/// The name of the file that a URI stands for: `%20` is a blank. A percent sign without two digits
/// is itself, as in names that their writer did not encode.
fn decoded(uri: &str) -> Result<String, Box<dyn Error>> {
    let mut parts = uri.split('%').map(str::as_bytes);
    let mut name = parts.next().unwrap_or_default().to_vec();
    let digit = |c: u8| char::from(c).to_digit(16);
    for part in parts {
        let byte = part.first_chunk().and_then(|&[a, b]| Some(16 * digit(a)? + digit(b)?));
        name.push(byte.map_or(b'%', |byte| byte as u8));
        name.extend(if byte.is_some() { &part[2..] } else { part });
    }
    String::from_utf8(name).map_err(|_| format!("its buffer {uri} is not in UTF-8").into())
}

/// What is needed on the way through the nodes, and the triangles so far.
struct Walk {
    buffers: Vec<Vec<u8>>,
    is_reached: Vec<bool>,
    triangles: Triangles,
}

impl Walk {
    fn collect(
        &mut self,
        node: &Node<'_>,
        parent: &Matrix,
        depth: usize,
    ) -> Result<(), Box<dyn Error>> {
        // Else a few nodes could be reached along more ways than a machine can go.
        if std::mem::replace(&mut self.is_reached[node.index()], true) {
            let node = node.index();
            return Err(format!("its node {node} is reached twice: nodes are no tree").into());
        }
        if depth > DEEPEST {
            return Err("its nodes are nested too deep".into());
        }
        let own = node.transform().matrix().map(|column| column.map(f64::from));
        // By columns: the node's axes and position in the parent's frame.
        let placed = own.map(|c| [0, 1, 2, 3].map(|r| (0..4).map(|k| parent[k][r] * c[k]).sum()));
        let is_mirrored = is_mirror(&placed);
        for primitive in node.mesh().iter().flat_map(|mesh| mesh.primitives()) {
            let points = positions(&primitive, &placed, &self.buffers)?;
            let reader =
                primitive.reader(|buffer| self.buffers.get(buffer.index()).map(Vec::as_slice));
            let indices: Vec<usize> = match primitive.indices() {
                Some(accessor) => {
                    use DataType::{U8, U16, U32};
                    check(&accessor, "indices", &[U8, U16, U32], Dimensions::Scalar)?;
                    let indices = reader.read_indices().ok_or("a mesh has no indices")?;
                    indices.into_u32().map(|i| i as usize).collect()
                }
                None => (0..points.len()).collect(),
            };
            let corners: Vec<[usize; 3]> = match primitive.mode() {
                Mode::Triangles if indices.len() % 3 != 0 => {
                    return Err(format!("a mesh of triangles has {} corners", indices.len()).into());
                }
                Mode::Triangles => indices.chunks_exact(3).map(|t| [t[0], t[1], t[2]]).collect(),
                // Each second one begins with its edge the other way.
                Mode::TriangleStrip => (indices.windows(3).enumerate())
                    .map(|(i, t)| if i % 2 == 0 { [t[0], t[1], t[2]] } else { [t[0], t[2], t[1]] })
                    .collect(),
                Mode::TriangleFan => {
                    indices.windows(2).skip(1).map(|t| [indices[0], t[0], t[1]]).collect()
                }
                // Points and lines have no surface.
                _ => Vec::new(),
            };
            for [a, b, c] in corners {
                let point = |i: usize| points.get(i).copied().ok_or("an index has no vertex");
                let [a, b, c] = [point(a)?, point(b)?, point(c)?];
                self.triangles.push(if is_mirrored { [a, c, b] } else { [a, b, c] });
            }
        }
        node.children().try_for_each(|child| self.collect(&child, &placed, depth + 1))
    }
}

/// Whether a node turns the front of its triangles to the back: the determinant of its axes is
/// negative.
fn is_mirror([x, y, z, _]: &Matrix) -> bool {
    let minor = |i: usize, k: usize| y[i] * z[k] - y[k] * z[i];
    x[0] * minor(1, 2) + x[1] * minor(2, 0) + x[2] * minor(0, 1) < 0.0
}

fn positions(
    primitive: &Primitive<'_>,
    placed: &Matrix,
    buffers: &[Vec<u8>],
) -> Result<Vec<[f64; 3]>, Box<dyn Error>> {
    let reader = primitive.reader(|buffer| buffers.get(buffer.index()).map(Vec::as_slice));
    let place = |p: [f32; 3]| {
        let p = p.map(f64::from);
        [0, 1, 2].map(|r| placed[3][r] + (0..3).map(|k| placed[k][r] * p[k]).sum::<f64>())
    };
    let accessor = primitive.get(&Semantic::Positions).ok_or("a mesh has no positions")?;
    check(&accessor, "positions", &[DataType::F32], Dimensions::Vec3)?;
    let positions = reader.read_positions().ok_or("a mesh has no positions")?;
    Ok(positions.map(place).collect())
}

/// Whether numbers have one of these types and are where they are said to be: the library would read others
/// without a word, or fewer.
fn check(
    accessor: &Accessor<'_>,
    what: &str,
    types: &[DataType],
    dimensions: Dimensions,
) -> Result<(), String> {
    let has_type = types.contains(&accessor.data_type()) && accessor.dimensions() == dimensions;
    if !has_type {
        return Err(format!("the {what} of a mesh have a type that is not theirs"));
    }
    let size = accessor.size();
    // Without a view all numbers are zero, but those given one by one.
    if accessor.view().is_none() && accessor.count() > MOST_ZEROS {
        return Err(format!("the {what} of a mesh are too many zeros"));
    }
    let mut places = Vec::new();
    if let Some(view) = accessor.view() {
        let stride = view.stride().unwrap_or(size);
        places.push((view, accessor.offset(), accessor.count(), stride, size));
    }
    // Some are given one by one, by their indices.
    if let Some(sparse) = accessor.sparse() {
        let (indices, values, count) = (sparse.indices(), sparse.values(), sparse.count());
        let of_index = indices.index_type().size();
        places.push((indices.view(), indices.offset(), count, of_index, of_index));
        places.push((values.view(), values.offset(), count, size, size));
    }
    if places.iter().any(|(view, .., size)| view.stride().is_some_and(|stride| stride < *size)) {
        return Err(format!("the {what} of a mesh lie one in another"));
    }
    let are_within = places.iter().all(|(view, offset, count, stride, size)| {
        let end = || {
            let last = count.checked_sub(1)?.checked_mul(*stride)?;
            let end = last.checked_add(*offset)?.checked_add(*size)?;
            (end <= view.length()).then(|| view.offset().checked_add(view.length()))?
        };
        end().is_some_and(|end| end <= view.buffer().length())
    });
    if places.is_empty() || !are_within {
        return Err(format!("the {what} of a mesh lie beyond their buffer"));
    }
    Ok(())
}
