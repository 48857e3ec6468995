//! Meshes from OBJ files.

use std::error::Error;
use std::io::Cursor;
use std::path::Path;

use crate::geometry::Point;

/// The corners of triangles.
pub type Triangles = Vec<[Point; 3]>;

/// The Utah teapot.
pub fn teapot() -> Triangles {
    let file = include_bytes!("../../examples/assets/teapot.obj");
    parse(file).expect("the teapot is a mesh")
}

/// The triangles of a file, and the file's name.
///
/// # Errors
/// A text that names the file, if it cannot be read, is not an OBJ file, or has no triangles.
pub fn open(path: &Path) -> Result<(String, Triangles), String> {
    let named = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
    let file = std::fs::read(path).map_err(|error| named(&error))?;
    let triangles = parse(&file).map_err(|error| named(&error))?;
    let name = path.file_stem().unwrap_or(path.as_os_str());
    Ok((name.to_string_lossy().into_owned(), triangles))
}

/// The triangles of the text of a file.
fn parse(text: &[u8]) -> Result<Triangles, Box<dyn Error>> {
    let options = tobj::LoadOptions { triangulate: true, ..Default::default() };
    let no_materials = |_: &Path| Err(tobj::LoadError::GenericFailure);
    // Without materials, textures and normals.
    let geometry: String = String::from_utf8_lossy(text)
        .lines()
        .map(|line| line.split_whitespace().collect::<Vec<_>>())
        .filter(|words| matches!(words.first(), Some(&("v" | "f"))))
        .map(|words| {
            let firsts = words.iter().map(|word| word.split('/').next().unwrap_or_default());
            firsts.collect::<Vec<_>>().join(" ") + "\n"
        })
        .collect();
    let (models, _) = tobj::load_obj_buf(&mut Cursor::new(geometry), &options, no_materials)?;
    let mut triangles = Vec::new();
    for tobj::Model { mesh, .. } in &models {
        let point = |i: u32| std::array::from_fn(|k| f64::from(mesh.positions[3 * i as usize + k]));
        let corners = mesh.indices.as_chunks::<3>().0;
        triangles.extend(corners.iter().map(|corners| corners.map(point)));
    }
    if triangles.is_empty() {
        return Err("no triangles".into());
    }
    if !triangles.as_flattened().as_flattened().iter().all(|x| x.is_finite()) {
        return Err("a coordinate is not finite".into());
    }
    Ok(triangles)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polygons_are_triangles_of_their_corners() {
        let square =
            b"v 0 0 0\nv\t1 0 0\nv 1 1 0\n v 0 1 0\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1 -1/1\n";
        let corners = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let expected = [[0, 1, 2], [0, 2, 3]].map(|triangle| triangle.map(|i: usize| corners[i]));
        assert_eq!(parse(square).expect("a mesh"), expected);
    }

    #[test]
    fn what_is_no_mesh_is_an_error() {
        let all: [&[u8]; 10] = [
            b"",
            b"\xff\xfe\x00",
            b"v 0 0 0\n",
            b"v 0 0 0\nf 1 2 3\n",
            b"v 0 0 0\nf 0 0 0\n",
            b"v 0 0 0\nf -9 1 1\n",
            b"v 0 0 0\nf\n",
            b"v 0 0\nf 1 1 1\n",
            b"v nan 0 0\nf 1 1 1\n",
            b"v 1e99 0 0\nf 1 1 1\n",
        ];
        for text in all {
            let text = (String::from_utf8_lossy(text), parse(text));
            assert!(text.1.is_err(), "{text:?}");
        }
    }

    #[test]
    fn an_error_names_the_file() {
        let error = open(Path::new("no/such.obj")).expect_err("there is none");
        assert!(error.starts_with("no/such.obj: "), "{error}");
    }
}
