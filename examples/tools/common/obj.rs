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

/// The vertex and face lines of an OBJ file. Vertices lose their colours, and faces their texture and
/// normal indices, so that an error in unused data does not refuse the file.
fn geometry_of_obj(bytes: &[u8]) -> String {
    // Some editors begin a file with a mark of its order of bytes.
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let text = String::from_utf8_lossy(bytes);
    let mut geometry = String::with_capacity(text.len());
    let mut begun = String::new();
    // A last line that is to go on ends with the file.
    for part in text.lines().chain([""]) {
        // A comment ends with its line, also with one that is to go on.
        let (part, goes_on) = match part.split_once('#') {
            Some((part, _)) => (part, false),
            None => part.strip_suffix('\\').map_or((part, false), |part| (part, true)),
        };
        begun.push_str(part);
        if goes_on {
            begun.push(' ');
            continue;
        }
        let line = std::mem::take(&mut begun);
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => {
                let words: Vec<&str> = words.collect();
                // A fourth number is a weight; more are a colour.
                let count = if words.len() > 4 { 3 } else { words.len() };
                geometry.push_str("v ");
                geometry.push_str(&words[..count].join(" "));
            }
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
