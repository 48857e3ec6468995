//! STL, text or binary, by `stl_io`.

use std::error::Error;
use std::io::Cursor;

use crate::mesh::Triangles;

pub(crate) fn read(bytes: &[u8]) -> Result<Triangles, Box<dyn Error>> {
    let bytes = unambiguous(bytes)?;
    let invalid = |e| format!("not a valid STL file: {e}");
    let mut reader = Cursor::new(bytes);
    let mut triangles = Vec::new();
    for triangle in stl_io::create_stl_reader(&mut reader).map_err(invalid)? {
        let vertices = triangle.map_err(invalid)?.vertices;
        triangles.push(vertices.map(|v| v.0.map(f64::from)));
    }
    Ok(triangles)
}

/// Whether a file begins as a text: after blanks, in letters of either case.
pub(crate) fn begins_as_text(bytes: &[u8]) -> bool {
    let word = bytes.trim_ascii_start().get(..5);
    word.is_some_and(|word| word.eq_ignore_ascii_case(b"solid"))
}

/// The file in a form that `stl_io` recognizes by its first word.
///
/// Binary files may begin with "solid" too, and are recognized by their length, or by a zero. Text files
/// may have several solids, and solids without a name.
fn unambiguous(bytes: &[u8]) -> Result<Vec<u8>, Box<dyn Error>> {
    const HEADER: usize = 84;
    const TRIANGLE: usize = 50;
    let expected = bytes.first_chunk::<HEADER>().map(|header| {
        let [.., a, b, c, d] = *header;
        HEADER + TRIANGLE * u32::from_le_bytes([a, b, c, d]) as usize
    });
    let is_text = begins_as_text(bytes) && !bytes.iter().take(1024).any(|&b| b == 0);
    if !is_text || expected == Some(bytes.len()) {
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
