//! Questions about grids: the voxels that a triangle marks, its crossings, and walks.

use septum::voxel::{Grid, Rule, Solid};
use septum::{Ray, Segment, Triangle, Vec3};

use super::super::draw::Draw;
use super::answers::Answers;
use super::queries::Query;

const RESOLUTION: [u32; 3] = [4, 3, 2];

/// A small grid, so that small cores answer within a minute.
#[inline(never)]
pub(super) fn grids<S: Draw, A: Answers>(
    origin: Vec3<S>,
    cell: Vec3<S>,
    triangle: &Triangle<S>,
    segments: &[Option<Segment<S>>; 2],
    ray: Option<&Ray<S>>,
    answers: &mut A,
) {
    let grid = Grid::new(origin, cell, RESOLUTION);
    answers.to(Query::GridAccepted).yes(grid.is_ok());
    let Ok(grid) = grid else { return };
    for (rule, query) in [
        (Rule::Closed, Query::GridRowsClosed),
        (Rule::HalfOpen, Query::GridRowsHalfOpen),
        (Rule::Thin, Query::GridRowsThin),
    ] {
        // A bit for each voxel, because the order of rows is not guaranteed.
        let mut marked = [[0_u8; 3]; 2];
        for row in grid.rows(triangle, rule) {
            row.x.for_each(|x| marked[row.z as usize][row.y as usize] |= 1 << x);
        }
        marked.as_flattened().iter().for_each(|&row| answers.to(query).byte(row));
        for segment in segments.iter().flatten() {
            grid.walk_segment(segment, rule)
                .for_each(|voxel| answers.to(Query::GridWalkSegment).byte(number(voxel)));
        }
        for voxel in ray.into_iter().flat_map(|ray| grid.walk_ray(ray, rule)) {
            answers.to(Query::GridWalkRay).byte(number(voxel));
        }
    }
    let (mut words, mut lines) = ([0_u32; 6], [0_u32; 2]);
    if let Ok(mut solid) = Solid::new(&grid, &mut words, &mut lines) {
        solid.cross(triangle);
    }
    let all = words.iter().chain(&lines);
    all.for_each(|&word| answers.to(Query::GridCrossings).byte(word as u8));
}

/// A voxel as one number.
fn number([x, y, z]: [u32; 3]) -> u8 {
    (x + 4 * (y + 3 * z)) as u8
}
