//! Reading meshes: OBJ by `tobj`, STL by `stl_io`, glTF by `gltf`, PLY by `ply-rs-bw`.

use std::error::Error;
use std::fs;
use std::io::{Cursor, Read};
use std::path::{Path, PathBuf};

use crate::options::Up;
use crate::{gltf, ply};

/// The bundled mesh, embedded so that the program runs from any directory.
const TEAPOT: &[u8] = include_bytes!("../../assets/teapot.obj");

/// Triangles as read, every coordinate finite, y up.
pub(crate) struct Mesh {
    pub(crate) name: String,
    pub(crate) triangles: Vec<[[f64; 3]; 3]>,
    /// The axis that pointed up in the file.
    pub(crate) up: Up,
}

impl Mesh {
    /// Reads the meshes, or the bundled one, and turns them so that y is up.
    pub(crate) fn load(paths: &[PathBuf], up: Option<Up>) -> Result<Self, Box<dyn Error>> {
        let Some((first, others)) = paths.split_first() else {
            let triangles = read_obj(TEAPOT).and_then(checked)?;
            return Ok(Self { name: "teapot".into(), triangles, up: Up::Y }.turned(up));
        };
        let mut mesh = Self::read(first, up)?;
        for path in others {
            let other = Self::read(path, up)?;
            mesh.name = format!("{}-{}", mesh.name, other.name);
            mesh.triangles.extend(other.triangles);
        }
        Ok(mesh)
    }

    fn read(path: &Path, up: Option<Up>) -> Result<Self, Box<dyn Error>> {
        let is_input = path == Path::new("-");
        let (shown, name) = if is_input {
            ("standard input".into(), "input".into())
        } else {
            let name = path.file_stem().map_or("mesh".into(), |s| s.to_string_lossy());
            (path.display().to_string(), name.into_owned())
        };
        let in_file = |e: Box<dyn Error>| format!("{shown}: {e}");
        // The extension is known before the file is read.
        let kind = if is_input { None } else { Some(Kind::of(path).map_err(in_file)?) };
        let bytes = if is_input {
            let mut bytes = Vec::new();
            std::io::stdin().read_to_end(&mut bytes).map(|_| bytes)
        } else {
            fs::read(path)
        };
        let bytes = bytes.map_err(|e| in_file(e.into()))?;
        let kind = kind.unwrap_or_else(|| Kind::guessed(&bytes));
        let triangles = match kind {
            Kind::Obj => read_obj(&bytes),
            Kind::Stl => read_stl(&bytes),
            Kind::Ply => ply::read(&bytes),
            Kind::Gltf => gltf::read(&bytes, (!is_input).then_some(path)),
        };
        let triangles = triangles.and_then(checked).map_err(in_file)?;
        // STL is the format of CAD and of printers.
        let up = up.unwrap_or(if kind == Kind::Stl { Up::Z } else { Up::Y });
        Ok(Self { name, triangles, up }.turned(Some(up)))
    }

    fn turned(mut self, up: Option<Up>) -> Self {
        self.up = up.unwrap_or(self.up);
        if self.up == Up::Z {
            for [_, y, z] in self.triangles.as_flattened_mut() {
                (*y, *z) = (*z, -*y);
            }
        }
        self
    }
}

pub(crate) type Triangles = Vec<[[f64; 3]; 3]>;

/// The formats of meshes.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Obj,
    Stl,
    Ply,
    Gltf,
}

impl Kind {
    fn of(path: &Path) -> Result<Self, Box<dyn Error>> {
        let extension =
            path.extension().map_or(String::new(), |e| e.to_string_lossy().to_lowercase());
        Ok(match extension.as_str() {
            "obj" => Self::Obj,
            "stl" => Self::Stl,
            "ply" => Self::Ply,
            "glb" | "gltf" => Self::Gltf,
            _ => return Err("a mesh is an .obj, an .stl, a .ply, a .glb or a .gltf file".into()),
        })
    }

    /// The format of standard input, by its first bytes.
    fn guessed(bytes: &[u8]) -> Self {
        let text = bytes.trim_ascii_start();
        let is_text = || !bytes.iter().take(1024).any(|&b| b == 0);
        if text.starts_with(b"ply") {
            Self::Ply
        } else if text.starts_with(b"glTF") || text.starts_with(b"{") {
            Self::Gltf
        } else if text.starts_with(b"solid") || !is_text() {
            Self::Stl
        } else {
            Self::Obj
        }
    }
}

/// Cuts a polygon into triangles that share its first corner. A segment or a point is one triangle.
pub(crate) fn fan(corners: &[[f64; 3]], triangles: &mut Triangles) {
    match *corners {
        [] => {}
        [a] => triangles.push([a; 3]),
        [a, b] => triangles.push([a, b, b]),
        [a, ref others @ ..] => {
            triangles.extend(others.windows(2).map(|pair| [a, pair[0], pair[1]]))
        }
    }
}

fn checked(triangles: Triangles) -> Result<Triangles, Box<dyn Error>> {
    if triangles.is_empty() {
        return Err("no triangles: the mesh has no faces".into());
    }
    for (i, p) in triangles.iter().flatten().enumerate() {
        if !p.iter().all(|x| x.is_finite()) {
            let [x, y, z] = p;
            return Err(format!(
                "triangle {} has a coordinate that is NaN or infinite: ({x}, {y}, {z})",
                i / 3 + 1
            )
            .into());
        }
    }
    Ok(triangles)
}

/// Polygons become fans of triangles. Lines and points become degenerate triangles.
fn read_obj(bytes: &[u8]) -> Result<Triangles, Box<dyn Error>> {
    let options = tobj::LoadOptions { triangulate: true, ..Default::default() };
    let no_materials = |_: &Path| Err(tobj::LoadError::GenericFailure);
    let geometry = geometry_of_obj(bytes);
    let (models, _) = tobj::load_obj_buf(&mut Cursor::new(geometry), &options, no_materials)
        .map_err(|e| format!("not a valid OBJ file: {e}"))?;

    let mut triangles = Vec::new();
    for tobj::Model { mesh, .. } in &models {
        for face in mesh.indices.chunks_exact(3) {
            // The loader has checked the indices.
            let coordinate =
                |corner: usize, i: usize| f64::from(mesh.positions[3 * face[corner] as usize + i]);
            let point = |corner| [0, 1, 2].map(|i| coordinate(corner, i));
            triangles.push([0, 1, 2].map(point));
        }
    }
    Ok(triangles)
}

/// The vertex and face lines of an OBJ file. Faces lose their texture and normal indices, so that
/// an error in unused data does not refuse the file.
fn geometry_of_obj(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes).replace("\\\r\n", " ").replace("\\\n", " ");
    let mut geometry = String::with_capacity(text.len());
    for line in text.lines() {
        let line = line.split('#').next().unwrap_or_default();
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => geometry.push_str(line.trim_start()),
            Some("f") => {
                geometry.push('f');
                for word in words {
                    geometry.push(' ');
                    geometry.push_str(word.split('/').next().unwrap_or_default());
                }
            }
            _ => continue,
        }
        geometry.push('\n');
    }
    geometry
}

fn read_stl(bytes: &[u8]) -> Result<Triangles, Box<dyn Error>> {
    let bytes = unambiguous_stl(bytes)?;
    let invalid = |e| format!("not a valid STL file: {e}");
    let mut reader = Cursor::new(bytes);
    let mut triangles = Vec::new();
    for triangle in stl_io::create_stl_reader(&mut reader).map_err(invalid)? {
        let vertices = triangle.map_err(invalid)?.vertices;
        triangles.push(vertices.map(|v| v.0.map(f64::from)));
    }
    Ok(triangles)
}

/// The file in a form that `stl_io` recognizes by its first word.
///
/// Binary files may begin with "solid" too, and are recognized by their length. Text files may have
/// several solids, and solids without a name.
fn unambiguous_stl(bytes: &[u8]) -> Result<Vec<u8>, Box<dyn Error>> {
    const HEADER: usize = 84;
    const TRIANGLE: usize = 50;
    let expected = bytes.first_chunk::<HEADER>().map(|header| {
        let [.., a, b, c, d] = *header;
        HEADER + TRIANGLE * u32::from_le_bytes([a, b, c, d]) as usize
    });
    if !bytes.starts_with(b"solid") || expected == Some(bytes.len()) {
        return match expected {
            Some(length) if length <= bytes.len() => {
                Ok([&[0; 80], bytes.get(80..).unwrap_or_default()].concat())
            }
            Some(_) => Err("the STL file ends before its last triangle".into()),
            None => Err("not a valid STL file: too short".into()),
        };
    }
    let text = String::from_utf8_lossy(bytes).to_ascii_lowercase();
    let is_facet = |l: &&str| !l.starts_with("solid") && !l.starts_with("endsolid");
    let facets = text.lines().map(str::trim).filter(is_facet);
    let mut whole: String =
        ["solid mesh"].into_iter().chain(facets).flat_map(|l| [l, "\n"]).collect();
    if text
        .lines()
        .map(str::trim)
        .rfind(|l| !l.is_empty())
        .is_some_and(|l| l.starts_with("endsolid"))
    {
        whole.push_str("endsolid\n");
    }
    Ok(whole.into_bytes())
}
