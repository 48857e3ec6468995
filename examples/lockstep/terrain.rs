//! The ground: hills of triangles on a grid, walls around them and a ceiling, with a tree over all
//! triangles.

use fixed::types::I16F16;
use septum::Vec3;
use septum::contact::{InteriorEdges, interior_edges};
use septum::mesh::{Mesh, Node, Tree};

use crate::number::{Number, ratio};

/// The number of cells along each side of the ground; a cell is one metre.
pub(crate) const SIDE: usize = 10;

const CORNERS: usize = SIDE + 1;
const VERTICES: usize = CORNERS * CORNERS + 8;
const TRIANGLES: usize = 2 * SIDE * SIDE + 10;

/// Heights in sixteenths. The pattern repeats.
const HEIGHTS: [[u8; 5]; 5] =
    [[24, 14, 9, 3, 12], [15, 6, 0, 5, 13], [8, 2, 5, 11, 6], [3, 7, 14, 8, 1], [16, 9, 4, 0, 10]];

/// The height of the walls.
const WALL: usize = 16;

fn points<T: Number>() -> [Vec3<T>; VERTICES] {
    let mut all = [Vec3::splat(T::ZERO); VERTICES];
    for (k, point) in all[..CORNERS * CORNERS].iter_mut().enumerate() {
        let (x, z) = (k / CORNERS, k % CORNERS);
        *point = [ratio(x, 1), T::of(height(x, z)), ratio(z, 1)].into();
    }
    for (k, point) in all[CORNERS * CORNERS..].iter_mut().enumerate() {
        let (side, n) = (ratio(SIDE, 1), k / 2);
        let x = if n == 1 || n == 2 { side } else { T::ZERO };
        let z = if n >= 2 { side } else { T::ZERO };
        *point = [x, if k % 2 == 0 { -T::ONE } else { ratio(WALL, 1) }, z].into();
    }
    all
}

static FACES: [[u16; 3]; TRIANGLES] = {
    let mut all = [[0; 3]; TRIANGLES];
    let mut k = 0;
    while k < SIDE * SIDE {
        let a = (k / SIDE * CORNERS + k % SIDE) as u16;
        let (b, c, d) = (a + 1, a + CORNERS as u16, a + CORNERS as u16 + 1);
        all[2 * k] = [a, b, c];
        all[2 * k + 1] = [d, c, b];
        k += 1;
    }
    let mut n = 0;
    while n < 4 {
        let first = (CORNERS * CORNERS) as u16;
        let (a, b) = (first + 2 * n, first + 2 * ((n + 1) % 4));
        all[2 * SIDE * SIDE + 2 * n as usize] = [a, b, a + 1];
        all[2 * SIDE * SIDE + 2 * n as usize + 1] = [b + 1, a + 1, b];
        n += 1;
    }
    let top = (CORNERS * CORNERS + 1) as u16;
    all[TRIANGLES - 2] = [top, top + 2, top + 4];
    all[TRIANGLES - 1] = [top, top + 4, top + 6];
    all
};

/// The static geometry.
pub(crate) struct Ground<'a, T: Number> {
    pub(crate) tree: Tree<'a, T, u16>,
    /// The interior edges, which must not catch a box.
    pub(crate) interior: [InteriorEdges; TRIANGLES],
}

/// Calls `f` with the ground, which needs memory for its tree. `None` if the ground is invalid.
pub(crate) fn with_ground<T: Number, R>(f: impl FnOnce(&Ground<'_, T>) -> R) -> Option<R> {
    let points = points();
    let mesh = Mesh::new(&points, &FACES).ok()?;
    let mut interior = [InteriorEdges::NONE; TRIANGLES];
    interior_edges(&mesh, &mut [(0, 0); 3 * TRIANGLES], &mut interior).ok()?;
    let mut nodes = [Node::EMPTY; Node::count_for(TRIANGLES)];
    let mut order = [0; TRIANGLES];
    let tree = Tree::build(mesh, &mut nodes, &mut order).ok()?;
    Some(f(&Ground { tree, interior }))
}

fn height(x: usize, z: usize) -> I16F16 {
    I16F16::from_num(HEIGHTS[x % 5][z % 5]) / 16
}

/// The signed height of a point above the ground; `None` beyond the walls.
pub(crate) fn height_above<T: Number>(point: [T; 3]) -> Option<I16F16> {
    let [x, y, z] = point.map(T::rounded);
    let cell = |x: I16F16| x.checked_to_num::<usize>().filter(|&cell| cell < SIDE);
    let ((i, k), (u, v)) = ((cell(x)?, cell(z)?), (x.frac(), z.frac()));
    let (b, c) = (height(i, k + 1), height(i + 1, k));
    let ground = if u + v <= 1 {
        let a = height(i, k);
        a + (c - a) * u + (b - a) * v
    } else {
        let d = height(i + 1, k + 1);
        d + (b - d) * (I16F16::ONE - u) + (c - d) * (I16F16::ONE - v)
    };
    Some(y - ground)
}
