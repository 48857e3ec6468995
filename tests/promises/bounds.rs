//! Bounding boxes: they enclose, and the next smaller box of the scalar does not.

use core::cmp::Ordering;

use septum::mesh::Mesh;
use septum::polygon::Polygon;
use septum::voxel::{Grid, GridError};
use septum::{Aabb, Segment, ShapeError, Triangle, Vec3};
use septum_kit::aabbs::AabbSet;
use septum_kit::{Each, Rng, Sample, compare_sums, for_every_scalar, three};

/// Checks that `low` is the greatest number not above c − h, and `high` the least not below c + h.
/// Fixed point ends at its range.
fn is_tight<S: Sample>([low, high]: [S; 2], c: S, h: S) {
    let negative = |x: S| {
        let (m, e) = x.mantissa_exponent();
        (-m, e)
    };
    let parts = S::mantissa_exponent;
    let is_above = |x: S| compare_sums(&[parts(x)], &[parts(c), negative(h)]) == Ordering::Greater;
    let is_below = |x: S| compare_sums(&[parts(x)], &[parts(c), parts(h)]) == Ordering::Less;
    let what = format!("{c:?} ± {h:?}: {low:?} to {high:?}");
    assert!(!is_above(low) || low == S::LEAST, "{what}");
    assert!(is_above(low.moved(1)) || h == S::ZERO && low == c, "{what}");
    assert!(!is_below(high) || high == S::GREATEST, "{what}");
    assert!(is_below(high.moved(-1)) || h == S::ZERO && high == c, "{what}");
}

fn corners_of_a_centre_are_tight<S: Sample>() {
    let (mut rng, mut seen) = (Rng::new(0xb0), [0; 2]);
    for set in AabbSet::ALL {
        for _ in 0..1_500 {
            let c: S = set.number(&mut rng);
            let h: S = set.number(&mut rng);
            let size = if h < S::ZERO { S::ZERO.minus(h) } else { h };
            let segment = Segment::from_center_half_vector([c; 3], [h; 3]).unwrap();
            // Fixed point has no magnitude of its least number.
            let Ok(aabb) = Aabb::from_center_half_extents([c; 3], [size; 3]) else { continue };
            let found = aabb.min_max();
            assert_eq!(segment.aabb().and_then(|aabb| aabb.min_max()), found);
            seen[usize::from(found.is_some())] += 1;
            if let Some((min, max)) = found {
                is_tight([min.x, max.z], c, size);
                assert_eq!(Aabb::from_points([min, max]).unwrap().union(&aabb), aabb.union(&aabb));
            } else {
                let [c, h] = [c, size].each(S::mantissa_exponent);
                let greatest = S::GREATEST.mantissa_exponent();
                let over = compare_sums(&[(c.0.abs(), c.1), h], &[greatest]);
                assert_eq!(over, Ordering::Greater, "{aabb:?}");
            }
        }
    }
    assert!(seen[1] > 7_000, "{seen:?}");
}

fn vertices_span_the_box<S: Sample>() {
    let mut rng = Rng::new(0xb1);
    for _ in 0..500 {
        let vertices: Vec<Vec3<S>> =
            (0..6).map(|_| Vec3::from(rng.triple(|rng| AabbSet::ALL[0].number(rng)))).collect();
        let ends = |points: &[Vec3<S>]| {
            let (mut min, mut max) = ([S::GREATEST; 3], [S::LEAST; 3]);
            for p in points.iter().map(|p| p.to_array()) {
                min = three(|i| if p[i] < min[i] { p[i] } else { min[i] });
                max = three(|i| if p[i] > max[i] { p[i] } else { max[i] });
            }
            Aabb::from_min_max(min, max).unwrap()
        };
        let [a, b, c] = [vertices[0], vertices[1], vertices[2]];
        assert_eq!(Triangle::new(a, b, c).unwrap().aabb(), ends(&vertices[..3]));
        assert_eq!(Segment::new(a, b).unwrap().aabb(), Some(ends(&vertices[..2])));
        assert_eq!(Polygon::new(&vertices).unwrap().aabb(), ends(&vertices));
        assert_eq!(Aabb::from_points(vertices.iter().copied()).unwrap(), ends(&vertices));
        // The last vertex belongs to no triangle.
        let mesh = Mesh::new(&vertices, &[[0_u16, 1, 2], [2, 3, 4]]).unwrap();
        assert_eq!(mesh.aabb(), Some(ends(&vertices[..5])));
        let both = ends(&vertices[..2]).union(&ends(&vertices[2..]));
        assert_eq!(both, Some(ends(&vertices)));
    }
    assert_eq!(Mesh::<S, u16>::new(&[], &[]).unwrap().aabb(), None);
    assert_eq!(Aabb::<S>::from_points([[S::ZERO; 3]; 0]), Err(ShapeError::NoPoints));
}

/// The grid holds the box with whole layers of margin, and its longest side has as many voxels as
/// asked for.
fn grids_hold_their_box<S: Sample>() {
    let (mut rng, mut count, mut one_more) = (Rng::new(0xb2), 0, 0);
    for _ in 0..4_000 {
        let scale = 2_f64.powf(rng.real(-9.0, 9.0));
        let p: [S; 3] = rng.triple(|rng| S::nearest(rng.real(-scale, scale)));
        let q: [S; 3] = rng.triple(|rng| S::nearest(rng.real(-scale, scale)));
        let aabb = Aabb::from_points([p, q]).unwrap();
        let (resolution, margin) = (rng.whole(1, 100) as u32, rng.whole(0, 3) as u32);
        let grid = match Grid::around(&aabb, resolution, margin) {
            Ok(grid) => grid,
            Err(error) => {
                let is_short =
                    error == GridError::OutOfRange || error == GridError::CellNotPositive;
                assert!(is_short, "{aabb:?} {resolution}: {error:?}");
                continue;
            }
        };
        count += 1;
        let [first, last] = [[margin; 3], grid.resolution().each(|n| n - 1 - margin)]
            .each(|voxel| grid.voxel(voxel).unwrap().min_max().unwrap());
        let (min, max) = aabb.min_max().unwrap();
        let holds = |a: S, b: S, c: S, d: S| a <= b && c <= d;
        assert!(holds(first.0.x, min.x, max.x, last.1.x), "{aabb:?} {grid:?}");
        assert!(holds(first.0.y, min.y, max.y, last.1.y), "{aabb:?} {grid:?}");
        assert!(holds(first.0.z, min.z, max.z, last.1.z), "{aabb:?} {grid:?}");
        let longest = grid.resolution().each(|n| n - 2 * margin).into_iter().max().unwrap();
        one_more += usize::from(longest == resolution + 1);
        // Fixed point rounds the cell up, so that fewer cells may suffice.
        let is_float = S::LEAST.mantissa_exponent().1 > 0;
        assert!(longest <= resolution + 1, "{aabb:?} {resolution} {grid:?}");
        assert!(!is_float || longest >= resolution, "{aabb:?} {resolution} {grid:?}");
    }
    assert!(count > 1_000, "{count}");
    let is_float = S::LEAST.mantissa_exponent().1 > 0;
    assert!(one_more > 0 || !is_float);
}
for_every_scalar!(corners_of_a_centre_are_tight, vertices_span_the_box, grids_hold_their_box);

#[test]
fn bad_grids_around() {
    let aabb = |side: f32| Aabb::from_min_max([0.0; 3], [side, 0.0, 0.0]).unwrap();
    assert_eq!(Grid::around(&aabb(1.0), 0, 1), Err(GridError::NoVoxels));
    assert_eq!(Grid::around(&aabb(0.0), 9, 1), Err(GridError::CellNotPositive));
    // The distance from the origin, two voxels before the box, is no number.
    assert_eq!(Grid::around(&aabb(f32::MAX), 100, 2), Err(GridError::OutOfRange));
    let wide = Aabb::from_min_max([f32::MIN; 3], [f32::MAX; 3]).unwrap();
    assert_eq!(Grid::around(&wide, 9, 0), Err(GridError::OutOfRange));
    let far = Aabb::from_center_half_extents([f32::MAX; 3], [f32::MAX; 3]).unwrap();
    assert_eq!(Grid::around(&far, 9, 0), Err(GridError::OutOfRange));
    assert_eq!(Grid::around(&aabb(1.0), u32::MAX, 1), Err(GridError::TooManyVoxels));
    assert_eq!(Grid::around(&aabb(1.0), 8, 0).unwrap().resolution(), [8, 1, 1]);
}
