//! OBJ, by `tobj`: its vertices and faces.

use std::error::Error;
use std::io::Cursor;
use std::path::Path;

use crate::mesh::Triangles;

/// Polygons become fans of triangles. Lines and points become degenerate triangles.
pub(crate) fn read(bytes: &[u8]) -> Result<Triangles, Box<dyn Error>> {
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
                |corner: usize, i: usize| mesh.positions[3 * face[corner] as usize + i];
            let point = |corner| [0, 1, 2].map(|i| coordinate(corner, i));
            triangles.push([0, 1, 2].map(point));
        }
    }
    Ok(triangles)
}

/// The vertex and face lines of an OBJ file. Faces lose their texture and normal indices, so that
/// an error in unused data does not refuse the file.
fn geometry_of_obj(bytes: &[u8]) -> String {
    // Some editors begin a file with a mark of its order of bytes.
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
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
