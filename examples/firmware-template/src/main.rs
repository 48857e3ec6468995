//! A tool, 6 mm wide, comes down on a zone that it must keep out of. Every answer is exact.
#![no_std]
#![no_main]

mod log;
#[rustfmt::skip]
mod zone;

use cortex_m as _;
use fixed::types::I16F16;
use log::say;
use septum::mesh::{Mesh, MeshError, Tree};
use septum::{Aabb, ShapeError};
use zone::{FACES, NODES, VERTICES};

/// Half the width of the tool.
const HALF: I16F16 = I16F16::from_bits(3 << 16);

#[cortex_m_rt::entry]
fn main() -> ! {
    match zone() {
        Ok(zone) => {
            for height in [30, 25, 20, 15, 10, 5, 0] {
                if look(&zone, height).is_err() {
                    say!("at {} mm: no tool", height);
                }
            }
        }
        Err(_) => say!("the zone: its tables are damaged"),
    }
    log::end()
}

/// The zone, and the tree over it, as they lie in flash. Nothing is built: each box is looked at once.
fn zone() -> Result<Tree<'static, I16F16, u16>, MeshError> {
    Tree::new(Mesh::new(&VERTICES, &FACES)?, &NODES)
}

/// Says where the tool is, so many millimetres high.
fn look(zone: &Tree<'_, I16F16, u16>, height: i16) -> Result<(), ShapeError> {
    let middle = [I16F16::ZERO, I16F16::ZERO, I16F16::from_bits(i32::from(height) << 16)];
    let tool = Aabb::from_center_half_extents(middle, [HALF; 3])?;
    match zone.overlapping(&tool).next() {
        Some(face) => say!("at {} mm: touches face {}", height, face),
        None if zone.contains(middle) => say!("at {} mm: wholly inside", height),
        None => say!("at {} mm: outside", height),
    }
    Ok(())
}

/// Never linked: see README.md.
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
