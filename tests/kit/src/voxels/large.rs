//! The largest grids: what rows say of them, and that they say it soon. No clock is asked: a call
//! whose work grows with the grid would not come back.

use septum::Triangle;
use septum::voxel::{Grid, Rule};

use super::Tally;
use crate::{Each, Rng, Sample, three};

const RULES: [Rule; 3] = [Rule::Closed, Rule::HalfOpen, Rule::Thin];

/// The grid with the most voxels that the scalar has between zero and half of its greatest number,
/// or 2^30, and the length of its side.
fn largest<S: Sample>() -> (Grid<S>, f64) {
    let cells = (0..=30).rev().flat_map(|bits| {
        let cell = (-16..=0).rev().map(|e| 2_f64.powi(e));
        cell.map(move |cell| (bits, cell))
    });
    cells
        .filter_map(|(bits, cell)| {
            let side = cell * 2_f64.powi(bits);
            let is_held = S::nearest(cell).approximate() == cell
                && S::nearest(side + cell).approximate() == side + cell;
            let grid = Grid::new([S::ZERO; 3], [S::nearest(cell); 3], [1 << bits; 3]).ok()?;
            is_held.then_some((grid, side))
        })
        .next()
        .expect("a grid")
}

/// The rows of (−m, m/2, 0), (m/2, −m, m), (−m, −m, m) in a grid of side m, which this triangle
/// passes by, whichever axis comes first and in every direction. By every rule none.
pub(super) fn rows_under_nothing<S: Sample>() -> usize {
    let (grid, m) = largest::<S>();
    let mut rows = 0;
    for turn in 0..3 {
        for mirrored in 0..8 {
            let place = |p: [f64; 3]| {
                three(|i| {
                    let x = p[(i + turn) % 3];
                    S::nearest(if mirrored >> i & 1 == 1 { m - x } else { x })
                })
            };
            let [a, b, c] = [[-m, m / 2.0, 0.0], [m / 2.0, -m, m], [-m, -m, m]].each(place);
            // Mirrored, it is beyond some scalars, and cut off there it is another triangle.
            let triangle = Triangle::new(a, b, c).expect("finite vertices");
            if [a, b, c].as_flattened().iter().any(|x| x.approximate().abs() > 1.5 * m) {
                continue;
            }
            for rule in RULES {
                rows += grid.rows(&triangle, rule).count();
            }
        }
    }
    rows
}

/// The first rows of triangles in and about the largest grid: each beside the pair, and by no
/// rule a row that the triangle does not come to. Many pass by the grid closely, or come into it
/// at a corner.
pub(super) fn first_rows<S: Sample>(seed: u64, cases: u64) -> Tally {
    let rng = &mut Rng::new(seed);
    let (grid, side) = largest::<S>();
    let [last, ..] = grid.resolution().each(|n| n - 1);
    let mut found = Tally::default();
    while found.cases < cases {
        let near = rng.one_in(2);
        let mut vertices = [(); 3].each(|()| {
            let low = if S::nearest(-side).approximate() == -side { -1.0 } else { 0.0 };
            rng.triple(|rng| S::nearest(side * rng.real(low, 1.8)))
        });
        if near {
            // Beside an edge of the grid.
            let i = rng.below(3);
            for v in &mut vertices {
                let [j, k] = [(i + 1) % 3, (i + 2) % 3];
                let x = v[j].approximate();
                v[k] = S::nearest(side - (x - side) * rng.real(0.999, 1.001));
            }
        }
        let [a, b, c] = vertices;
        let triangle = Triangle::new(a, b, c).expect("finite vertices");
        for rule in RULES {
            for row in grid.rows(&triangle, rule).take(20) {
                let meets = |x: u32| {
                    let voxel = grid.voxel([x, row.y, row.z]).expect("a voxel");
                    triangle.overlaps(&voxel)
                };
                let (first, end) = (row.x.start, row.x.end);
                let mut is_right = first < end && meets(first) && meets(end - 1);
                if rule == Rule::Closed {
                    is_right &= (first == 0 || !meets(first - 1)) && (end > last || !meets(end));
                }
                if !is_right {
                    eprintln!(
                        "{rule:?} {row:?} {triangle:?} {:?}",
                        [
                            meets(first),
                            meets(end - 1),
                            first > 0 && meets(first - 1),
                            end <= last && meets(end)
                        ]
                    );
                }
                found.count(is_right);
            }
        }
        let is_met = grid.rows(&triangle, Rule::Closed).next().is_some();
        found.count(is_met == meets_all(&grid, &triangle));
    }
    found
}

/// Whether a triangle meets the box of a grid.
fn meets_all<S: Sample>(grid: &Grid<S>, triangle: &Triangle<S>) -> bool {
    let [last, ..] = grid.resolution().each(|n| n - 1);
    let ends = [[0; 3], [last; 3]].each(|k| grid.voxel(k).and_then(|v| v.min_max()));
    let [Some((least, _)), Some((_, greatest))] = ends else { return false };
    triangle.overlaps(&septum::Aabb::from_min_max(least, greatest).expect("a box"))
}
