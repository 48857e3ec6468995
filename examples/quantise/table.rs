//! The table.

use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::Write;

use fixed::traits::{Fixed, ToFixed};

use crate::mesh::Mesh;
use crate::options::Options;

/// The mesh as a Rust file.
pub(crate) fn write<S: Fixed<Bits: std::fmt::Display>>(
    mesh: &Mesh,
    options: &Options,
) -> Result<String, Box<dyn Error>> {
    let scalar = format!("{:?}", options.scalar);
    let mut places = BTreeMap::new();
    let (mut vertices, mut faces, mut largest_error) = (Vec::new(), Vec::new(), 0.0_f64);
    for triangle in &mesh.triangles {
        let mut face = [0; 3];
        for (corner, point) in face.iter_mut().zip(triangle) {
            let scaled = point.map(|x| x * options.scale);
            let mut rounded = [S::ZERO; 3];
            for (to, x) in rounded.iter_mut().zip(scaled) {
                *to = x
                    .checked_to_fixed()
                    .ok_or_else(|| format!("{x} is beyond the range of {scalar}: see --scale"))?;
                largest_error = largest_error.max((to.to_num::<f64>() - x).abs());
            }
            let next = vertices.len();
            *corner = *places.entry(rounded).or_insert(next);
            if *corner == next {
                vertices.push(rounded);
            }
        }
        faces.push(face);
    }
    if vertices.len() > usize::from(u16::MAX) + 1 {
        return Err(format!("{} vertices: indices have 16 bits", vertices.len()).into());
    }
    eprintln!(
        "{}: {} vertices, {} faces, {} bytes; rounded by at most {largest_error:.2e}",
        mesh.name,
        vertices.len(),
        faces.len(),
        vertices.len() * 3 * size_of::<S>() + faces.len() * 6,
    );

    let mut out = format!("// The {} in {scalar}, made by the example `quantise`.\n\n", mesh.name);
    writeln!(out, "use fixed::types::{scalar};\nuse septum::Vec3;\n")?;
    writeln!(
        out,
        "const fn v(x: {bits}, y: {bits}, z: {bits}) -> Vec3<{scalar}> {{",
        bits = bits::<S>()
    )?;
    writeln!(
        out,
        "    Vec3::new({scalar}::from_bits(x), {scalar}::from_bits(y), {scalar}::from_bits(z))\n}}\n"
    )?;
    writeln!(out, "pub(crate) static VERTICES: [Vec3<{scalar}>; {}] = [", vertices.len())?;
    for row in vertices.chunks(4) {
        let of =
            |[x, y, z]: &[S; 3]| format!("v({}, {}, {}),", x.to_bits(), y.to_bits(), z.to_bits());
        writeln!(out, "    {}", row.iter().map(of).collect::<Vec<_>>().join(" "))?;
    }
    writeln!(out, "];\n\npub(crate) static FACES: [[u16; 3]; {}] = [", faces.len())?;
    for row in faces.chunks(6) {
        let of = |face: &[usize; 3]| format!("{face:?},");
        writeln!(out, "    {}", row.iter().map(of).collect::<Vec<_>>().join(" "))?;
    }
    writeln!(out, "];")?;
    Ok(out)
}

/// The integer that holds the bits.
fn bits<S>() -> String {
    format!("i{}", 8 * size_of::<S>())
}
