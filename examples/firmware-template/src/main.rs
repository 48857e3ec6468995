//! A tool, 6 mm wide, comes down on a zone that it must keep out of. Every answer is exact.
#![no_std]
#![no_main]

mod zone;

use cortex_m as _;
use fixed::types::I16F16;
use semihosting::println;
use septum::mesh::{Mesh, MeshError, Node, Tree};
use septum::{Aabb, ShapeError};
use zone::{CORNERS, FACES};

const COUNT: usize = FACES.len();

#[cortex_m_rt::entry]
fn main() -> ! {
    let (mut nodes, mut order) = ([Node::EMPTY; Node::count_for(COUNT)], [0; COUNT]);
    let is_done = match zone(&mut nodes, &mut order) {
        Ok(zone) => come_down(&zone).map_err(|error| println!("the tool: {error}")).is_ok(),
        Err(error) => {
            println!("the zone: {error}");
            false
        }
    };
    semihosting::process::exit(i32::from(!is_done))
}

/// The zone, with a tree over it, so that a query tests few of its triangles.
fn zone<'a>(
    nodes: &'a mut [Node],
    order: &'a mut [u16],
) -> Result<Tree<'a, I16F16, u16>, MeshError> {
    let mesh = Mesh::new(&CORNERS, &FACES)?;
    // Only a closed mesh has an inside.
    mesh.check_closed(&mut [[0; 2]; 3 * COUNT])?;
    Tree::build(mesh, nodes, order)
}

fn come_down(zone: &Tree<'_, I16F16, u16>) -> Result<(), ShapeError> {
    for height in (0..=30).rev().step_by(5) {
        let middle = [I16F16::ZERO, I16F16::ZERO, I16F16::from_num(height)];
        let tool = Aabb::from_center_half_extents(middle, [I16F16::from_num(3); 3])?;
        match zone.overlapping(&tool).next() {
            Some(face) => println!("at {height} mm: touches face {face}"),
            None if zone.contains(middle) => println!("at {height} mm: wholly inside"),
            None => println!("at {height} mm: outside"),
        }
    }
    Ok(())
}
