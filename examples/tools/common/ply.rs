//! PLY, text or binary, by `ply-rs-bw`: its vertices and faces.

use std::error::Error;
use std::io::Cursor;

use ply_rs_bw::parser::Parser;
use ply_rs_bw::ply::{Property, PropertyAccess, PropertyAccessResult};

use crate::mesh::{Triangles, fan};

/// A vertex or a face, whichever properties it has.
struct Element {
    point: [Option<f64>; 3],
    corners: Vec<i64>,
}

impl PropertyAccess for Element {
    fn new() -> Self {
        Self { point: [None; 3], corners: Vec::new() }
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        let axis = ["x", "y", "z"].iter().position(|axis| *axis == name);
        match (axis, number(&property), indices(&property)) {
            (Some(axis), Some(x), _) => self.point[axis] = Some(x),
            (None, _, Some(corners)) if matches!(name, "vertex_indices" | "vertex_index") => {
                self.corners = corners;
            }
            _ => return PropertyAccessResult::Ignored,
        }
        PropertyAccessResult::Set
    }
}

pub(crate) fn read(bytes: &[u8]) -> Result<Triangles, Box<dyn Error>> {
    let file = Parser::<Element>::new().read_ply(&mut Cursor::new(bytes)).map_err(|e| {
        // Further lines repeat the text of the file.
        let text = e.to_string();
        format!("not a valid PLY file: {}", text.lines().next().unwrap_or_default())
    })?;
    let elements = |name: &str| file.payload.get(name).map_or(&[][..], Vec::as_slice);
    let vertices = elements("vertex");
    let mut triangles = Vec::new();
    for face in elements("face") {
        let mut corners = Vec::new();
        for &i in &face.corners {
            let vertex = usize::try_from(i).ok().and_then(|i| vertices.get(i));
            let vertex = vertex.ok_or("a face has a vertex that is not there")?;
            let [Some(x), Some(y), Some(z)] = vertex.point else {
                return Err("its vertices have no x, y and z".into());
            };
            corners.push([x, y, z]);
        }
        fan(&corners, &mut triangles);
    }
    Ok(triangles)
}

fn number(property: &Property) -> Option<f64> {
    Some(match *property {
        Property::Char(x) => x.into(),
        Property::UChar(x) => x.into(),
        Property::Short(x) => x.into(),
        Property::UShort(x) => x.into(),
        Property::Int(x) => x.into(),
        Property::UInt(x) => x.into(),
        Property::Float(x) => x.into(),
        Property::Double(x) => x,
        _ => return None,
    })
}

fn indices(property: &Property) -> Option<Vec<i64>> {
    fn wide<T: Copy + Into<i64>>(list: &[T]) -> Vec<i64> {
        list.iter().map(|&i| i.into()).collect()
    }
    Some(match property {
        Property::ListChar(list) => wide(list),
        Property::ListUChar(list) => wide(list),
        Property::ListShort(list) => wide(list),
        Property::ListUShort(list) => wide(list),
        Property::ListInt(list) => wide(list),
        Property::ListUInt(list) => wide(list),
        _ => return None,
    })
}
