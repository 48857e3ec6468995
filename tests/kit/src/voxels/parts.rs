//! Parts of a grid: every answer about a part is the answer about the whole, restricted to it.

use septum::voxel::{Bits, Grid, Rule, Solid};
use septum::{Ray, Segment, Triangle};

use super::random::{grid, triangle};
use super::walk::line_ends;
use super::{LineKind, Tally};
use crate::{Each, Rng, Sample, three};

const RULES: [Rule; 3] = [Rule::Closed, Rule::HalfOpen, Rule::Thin];

/// The most voxels along a side: up to 1,000 parts of a grid, and all ways to cut it.
const MOST: i64 = 4;

type Voxel = [u32; 3];

/// Every part of a grid, the whole among them.
fn parts<S: Sample>(grid: &Grid<S>) -> Vec<Grid<S>> {
    let [x, y, z] = grid.resolution().each(|n| {
        (0..n).flat_map(move |from| (from + 1..=n).map(move |to| from..to)).collect::<Vec<_>>()
    });
    let mut parts = Vec::new();
    for x in &x {
        for y in &y {
            for z in &z {
                parts.push(grid.part([x.clone(), y.clone(), z.clone()]).expect("a part"));
            }
        }
    }
    parts
}

/// The voxels of the whole that are in a part, by their numbers there.
fn restricted<S: Sample>(voxels: &[Voxel], grid: &Grid<S>, part: &Grid<S>) -> Vec<Voxel> {
    let (from, size) = (three(|i| part.offset()[i] - grid.offset()[i]), part.resolution());
    let inside = |voxel: &Voxel| (0..3).all(|i| (from[i]..from[i] + size[i]).contains(&voxel[i]));
    let moved = |voxel: &Voxel| three(|i| voxel[i] - from[i]);
    voxels.iter().filter(|voxel| inside(voxel)).map(moved).collect()
}

/// Walks along lines of a kind through every part of small grids, by every rule: each beside the
/// walk in the whole grid, in the same order, and each along the line backwards. At least this
/// many walks.
pub(super) fn walks_in_parts<S: Sample>(kind: LineKind, seed: u64, cases: u64) -> Tally {
    let rng = &mut Rng::new(seed);
    let mut found = Tally::default();
    while found.cases < cases {
        let is_half = matches!(kind, LineKind::HalfIntegerSegments | LineKind::HalfIntegerRays);
        let grid = if is_half { unit_cells(rng) } else { grid::<S>(rng, MOST) };
        let Some(grid) = grid else { continue };
        let parts = parts(&grid);
        for _ in 0..4 {
            let (a, b) = if is_half { half_integers(rng, &grid) } else { line_ends(rng, &grid) };
            let walk = |part: &Grid<S>, rule, is_back: bool| -> Option<Vec<Voxel>> {
                Some(match kind {
                    LineKind::HalfIntegerSegments | LineKind::RandomSegments => {
                        let (from, to) = if is_back { (b, a) } else { (a, b) };
                        part.walk_segment(&Segment::new(from, to).ok()?, rule).collect()
                    }
                    LineKind::HalfIntegerRays | LineKind::RandomRays => {
                        let way = if is_back { negated(b)? } else { b };
                        // Backwards from all of the line, ahead from its origin.
                        let start = if is_back || b[0] < a[0] { None } else { Some(S::ZERO) };
                        let ray = Ray::new(a, way).ok()?.with_range(start, None).ok()?;
                        part.walk_ray(&ray, rule).collect()
                    }
                })
            };
            for rule in RULES {
                for is_back in [false, true] {
                    let Some(whole) = walk(&grid, rule, is_back) else { continue };
                    for part in &parts {
                        let of_part = walk(part, rule, is_back).expect("a line");
                        found.count(of_part == restricted(&whole, &grid, part));
                    }
                }
                // The same line the other way: of a ray only where it is all of the line.
                let is_whole = kind.is_segments() || b[0] < a[0];
                if let (true, Some(mut back)) = (is_whole, walk(&grid, rule, true)) {
                    let mut ahead = walk(&grid, rule, false).expect("a line");
                    back.reverse();
                    if rule == Rule::Closed {
                        ahead.sort_unstable();
                        back.sort_unstable();
                    }
                    found.count(ahead == back);
                }
            }
        }
    }
    found
}

fn negated<S: Sample>(way: [S; 3]) -> Option<[S; 3]> {
    let back = way.each(|x| S::nearest(-x.approximate()));
    (0..3).all(|i| back[i].approximate() == -way[i].approximate()).then_some(back)
}

/// Cells of size one.
fn unit_cells<S: Sample>(rng: &mut Rng) -> Option<Grid<S>> {
    let origin = rng.triple(|rng| S::nearest(rng.whole(-4, 0) as f64));
    let size = rng.triple(|rng| rng.whole(1, MOST) as u32);
    Grid::new(origin, [S::nearest(1.0); 3], size).ok()
}

/// Halves of whole numbers about a grid of cells of size one.
fn half_integers<S: Sample>(rng: &mut Rng, grid: &Grid<S>) -> ([S; 3], [S; 3]) {
    let (origin, size) = (grid.origin().to_array(), grid.resolution());
    let mut point = || {
        three(|i: usize| {
            let halves = rng.whole(-3, 2 * i64::from(size[i]) + 3);
            S::nearest(origin[i].approximate() + halves as f64 / 2.0)
        })
    };
    (point(), point())
}

/// The rows and the inside of random triangles and tetrahedra in every part of small grids, by
/// every rule. At least this many questions.
pub(super) fn marks_in_parts<S: Sample>(seed: u64, cases: u64) -> Tally {
    let rng = &mut Rng::new(seed);
    let mut found = Tally::default();
    while found.cases < cases {
        let Some(grid) = grid::<S>(rng, MOST) else { continue };
        let parts = parts(&grid);
        let [a, b, c] = triangle(rng, &grid);
        let [d, ..] = triangle(rng, &grid);
        let triangle = |[a, b, c]: [[S; 3]; 3]| Triangle::new(a, b, c).expect("finite vertices");
        for rule in RULES {
            let rows = |part: &Grid<S>| sorted(part, |bits| bits.fill(&triangle([a, b, c]), rule));
            let whole = rows(&grid);
            for part in &parts {
                let by_rows = part.rows(&triangle([a, b, c]), rule).flat_map(|row| {
                    let (y, z) = (row.y, row.z);
                    row.x.map(move |x| [x, y, z])
                });
                let mut by_rows: Vec<_> = by_rows.collect();
                by_rows.sort_unstable();
                // By the thin rule a voxel may come up to three times.
                by_rows.dedup();
                let expected = restricted(&whole, &grid, part);
                found.count(rows(part) == expected && by_rows == expected);
            }
        }
        let inside = |part: &Grid<S>| {
            let mut words = vec![0_u32; part.words::<u32>()];
            let mut lines = vec![0_u32; part.line_words::<u32>()];
            let mut solid = Solid::new(part, &mut words, &mut lines).expect("enough words");
            for face in [[a, b, c], [a, b, d], [b, c, d], [c, a, d]] {
                solid.cross(&triangle(face));
            }
            solid.finish();
            voxels(part).filter(|&voxel| solid.bits().contains(voxel)).collect::<Vec<_>>()
        };
        let mut whole = inside(&grid);
        whole.sort_unstable();
        for part in &parts {
            let mut of_part = inside(part);
            of_part.sort_unstable();
            found.count(of_part == restricted(&whole, &grid, part));
        }
    }
    found
}

/// The voxels that are set, in rising order.
fn sorted<S: Sample>(grid: &Grid<S>, fill: impl Fn(&mut Bits<'_, S, u32>)) -> Vec<Voxel> {
    let mut words = vec![0_u32; grid.words::<u32>()];
    let mut bits = Bits::new(grid, &mut words).expect("enough words");
    fill(&mut bits);
    let mut set: Vec<_> = voxels(grid).filter(|&voxel| bits.contains(voxel)).collect();
    set.sort_unstable();
    set
}

fn voxels<S: Sample>(grid: &Grid<S>) -> impl Iterator<Item = Voxel> + use<S> {
    let [nx, ny, nz] = grid.resolution();
    (0..nx * ny * nz).map(move |n| [n % nx, n / nx % ny, n / nx / ny])
}
