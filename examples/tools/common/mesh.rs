//! A mesh as it is read from files.

use std::error::Error;
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

use clap::ValueEnum;

use crate::{gltf, obj, ply, stl};

/// The bundled mesh, embedded so that the program runs from any directory.
const TEAPOT: &[u8] = include_bytes!("../../assets/teapot.obj");

/// The axis of a mesh that points up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Up {
    /// As most OBJ files have it
    Y,
    /// As most STL files have it
    Z,
}

/// Triangles as read, every coordinate finite, y up.
pub struct Mesh {
    /// Of the files, without their extensions.
    pub name: String,
    pub triangles: Triangles,
    /// The axis that pointed up in the file.
    pub up: Up,
}

impl Mesh {
    /// Reads the meshes, or the bundled one, and turns them so that y is up.
    pub fn load(paths: &[PathBuf], up: Option<Up>) -> Result<Self, Box<dyn Error>> {
        let Some((first, others)) = paths.split_first() else {
            let triangles = obj::read(TEAPOT).and_then(checked)?;
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
            Kind::Obj => obj::read(&bytes),
            Kind::Stl => stl::read(&bytes),
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

/// Triangles by their vertices.
pub type Triangles = Vec<[[f64; 3]; 3]>;

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
        } else if stl::begins_as_text(bytes) || !is_text() {
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
