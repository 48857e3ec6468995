//! Random triangles in random grids: rows against the test of each pair.

use septum::Triangle;
use septum::voxel::{Bits, Grid, Rule};

use super::oracle::{Marks, planes};
use crate::{Each, Rng, Sample, VERTEX_ORDERS, three};

/// Compares the rows and the bits of random triangles in random grids with
/// [`Triangle::overlaps`](septum::Overlaps::overlaps) on each voxel. Vertices are anywhere in the
/// grid or near it, within a few voxels of it, or on its planes; triangles may be segments and
/// points, with edges parallel to axes or nearly so. Panics if they differ, in any order of the
/// vertices. Returns the number of voxels met.
pub fn rows_agree_with_pairs<S: Sample>(seed: u64, grids: u32, most: i64) -> u64 {
    let rng = &mut Rng::new(seed);
    let mut met = 0;
    for _ in 0..grids {
        let Some(grid) = grid::<S>(rng, most) else { continue };
        for _ in 0..6 {
            let vertices = triangle(rng, &grid);
            met += check(&grid, vertices);
            let block = block(rng, &grid);
            let vertices = triangle(rng, &block);
            met += check(&grid, vertices);
        }
    }
    met
}

/// Compares the rows of such triangles under every rule with the oracle on each voxel. Panics if
/// they differ; returns the number of voxels marked.
pub fn marks_agree_with_oracle<S: Sample>(seed: u64, grids: u32, most: i64) -> u64 {
    let rng = &mut Rng::new(seed);
    let mut marked = 0;
    for _ in 0..grids {
        let Some(grid) = grid::<S>(rng, most) else { continue };
        let planes = planes(&grid);
        let [nx, ny, nz] = grid.resolution();
        for _ in 0..6 {
            let vertices = triangle(rng, &grid);
            let marks = Marks::new(&vertices, &planes);
            let [a, b, c] = vertices;
            let triangle = Triangle::new(a, b, c).expect("finite vertices");
            for rule in [Rule::Closed, Rule::HalfOpen, Rule::Thin] {
                let mut words = vec![0_u64; grid.words::<u64>()];
                let mut bits = Bits::new(&grid, &mut words).expect("enough words");
                bits.fill(&triangle, rule);
                for voxel in (0..nx * ny * nz).map(|n| [n % nx, n / nx % ny, n / nx / ny]) {
                    let is_right = bits.contains(voxel) == marks.has(voxel, rule);
                    assert!(is_right, "{rule:?} {voxel:?}: {triangle:?} in {grid:?}");
                }
                marked += bits.count();
            }
        }
    }
    marked
}

/// A grid of up to `most` voxels a side, sometimes a part of one.
pub(super) fn grid<S: Sample>(rng: &mut Rng, most: i64) -> Option<Grid<S>> {
    let size = rng.triple(|rng| rng.whole(1, most) as f64).each(|n| n as u32);
    let (origin, cell) = match rng.whole(0, 3) {
        0 => ([-3.0; 3], [1.0; 3]),
        1 => ([-2.0; 3], [0.5, 0.25, 1.0]),
        2 => (rng.triple(|rng| rng.real(-4.0, -2.0)), rng.triple(|rng| rng.real(0.1, 0.9))),
        _ => (rng.triple(|rng| rng.real(3.0, 4.0)), rng.triple(|rng| rng.real(0.05, 0.3))),
    };
    let whole = Grid::new(origin.each(S::nearest), cell.each(S::nearest), size).ok()?;
    if rng.one_in(2) {
        return Some(whole);
    }
    let mut range = |n: u32| {
        let [a, b] = [(); 2].each(|()| rng.whole(0, i64::from(n)) as u32);
        if a == b { 0..n } else { a.min(b)..a.max(b) }
    };
    whole.part(size.each(&mut range))
}

/// A few voxels of a grid.
fn block<S: Sample>(rng: &mut Rng, grid: &Grid<S>) -> Grid<S> {
    let range = grid.resolution().each(|n| {
        let first = rng.whole(0, i64::from(n) - 1) as u32;
        first..n.min(first + rng.whole(1, 4) as u32)
    });
    grid.part(range).expect("a part")
}

/// Vertices in and about a grid, on its planes or not.
pub(super) fn triangle<S: Sample>(rng: &mut Rng, grid: &Grid<S>) -> [[S; 3]; 3] {
    let last = grid.resolution().each(|n| n - 1);
    let (least, _) = grid.voxel([0; 3]).and_then(|v| v.min_max()).expect("a voxel");
    let (_, greatest) = grid.voxel(last).and_then(|v| v.min_max()).expect("a voxel");
    let (least, greatest) = (least.to_array(), greatest.to_array());
    let anywhere = |rng: &mut Rng| {
        three(|i: usize| {
            let (a, b) = (least[i].approximate(), greatest[i].approximate());
            S::nearest(a + rng.real(-0.3, 1.3) * (b - a))
        })
    };
    let corner = |rng: &mut Rng| {
        let index = last.each(|last| rng.whole(0, i64::from(last)) as u32);
        let (min, max) = grid.voxel(index).and_then(|v| v.min_max()).expect("a voxel");
        if rng.one_in(2) { min.to_array() } else { max.to_array() }
    };
    let on_planes = rng.whole(0, 3) as usize;
    let mut v = three(|k| if k < on_planes { corner(rng) } else { anywhere(rng) });
    match rng.whole(0, 11) {
        0 => v[1] = v[0],
        1 => v = [v[0]; 3],
        2 => v[2] = three(|i: usize| v[0][i].between(v[1][i])),
        3 => {
            v[2] = three(|i: usize| v[0][i].between(v[1][i]));
            v[2][0] = v[2][0].moved(1);
        }
        4 => v[1][0] = v[0][0],
        5 => (v[1][1], v[2][1]) = (v[0][1], v[0][1]),
        6 => (v[1][2], v[1][0]) = (v[0][2], v[0][0]),
        7 => v[1] = [v[0][0].moved(1), v[1][1], v[0][2].moved(-1)],
        _ => {}
    }
    v
}

fn check<S: Sample>(grid: &Grid<S>, vertices: [[S; 3]; 3]) -> u64 {
    let [nx, ny, nz] = grid.resolution();
    let at = |[x, y, z]: [u32; 3]| (x + nx * (y + ny * z)) as usize;
    let marked = |rule: Rule, order: [usize; 3]| {
        let [a, b, c] = order.each(|k| vertices[k]);
        let triangle = Triangle::new(a, b, c).expect("finite vertices");
        let mut marked = vec![false; (nx * ny * nz) as usize];
        for row in grid.rows(&triangle, rule) {
            for x in row.x {
                let voxel = &mut marked[at([x, row.y, row.z])];
                assert!(!*voxel, "twice: {triangle:?} in {grid:?}");
                *voxel = true;
            }
        }
        (triangle, marked)
    };
    let (triangle, closed) = marked(Rule::Closed, [0, 1, 2]);
    let mut met = 0;
    for z in 0..nz {
        for y in 0..ny {
            for x in 0..nx {
                let voxel = grid.voxel([x, y, z]).expect("a voxel");
                let expected = triangle.overlaps(&voxel);
                met += u64::from(expected);
                let is_right = closed[at([x, y, z])] == expected;
                assert!(is_right, "{:?}: {triangle:?} in {grid:?}", [x, y, z]);
            }
        }
    }
    for order in VERTEX_ORDERS {
        assert!(marked(Rule::Closed, order).1 == closed, "{order:?}: {triangle:?} in {grid:?}");
        let [a, b, c] = order.each(|k| vertices[k]);
        let mut words = vec![0_u32; grid.words::<u32>()];
        let mut bits = Bits::new(grid, &mut words).expect("enough words");
        bits.fill(&Triangle::new(a, b, c).expect("finite vertices"), Rule::Closed);
        let count = closed.iter().filter(|&&is_met| is_met).count();
        let voxels = (0..nx * ny * nz).map(|n| [n % nx, n / nx % ny, n / nx / ny]);
        let are_right = bits.count() == count as u64
            && voxels.into_iter().all(|voxel| bits.contains(voxel) == closed[at(voxel)]);
        assert!(are_right, "{order:?}: {triangle:?} in {grid:?}");
    }
    met
}
