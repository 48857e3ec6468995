//! Solids by crossings along rows, and walks along lines, compared with oracles of other methods.

use septum::voxel::{Grid, Rule, Solid, TooFewWords};
use septum::{Aabb, Ray, Segment, Triangle};
use septum_kit::Rng;
use septum_kit::voxels::{InScalar, LineKind, VoxelScene};

#[test]
fn centres_inside_are_those_of_the_oracle() {
    for scene in VoxelScene::solids(8) {
        for scalar in [InScalar::F32, InScalar::F64, InScalar::I16F16] {
            let found = scalar.check_solid(&scene);
            let what = format!("{scalar:?}, {}: {found:?}", scene.name);
            assert!(found.wrong == 0 && found.open == 0 && found.inside > 40, "{what}");
        }
    }
}

/// One triangle in each part, and a part for `finish`.
#[test]
fn a_solid_in_parts_is_that_of_the_whole() {
    let grid = Grid::new([0.0; 3], [1.0; 3], [8; 3]).unwrap();
    let of = |scene: &VoxelScene, part: usize| {
        let (mut words, mut lines) = ([!0_u32; 64], [!0_u32; 8]);
        Solid::new(&grid, &mut words, &mut lines).unwrap();
        for triangles in scene.triangles.chunks(part) {
            let mut solid = Solid::resume(&grid, &mut words, &mut lines).unwrap();
            for &[a, b, c] in triangles {
                solid.cross(&Triangle::new(a, b, c).unwrap());
            }
        }
        let mut solid = Solid::resume(&grid, &mut words, &mut lines).unwrap();
        solid.finish();
        let inside = solid.bits().count();
        (words, inside)
    };
    for scene in VoxelScene::solids(8) {
        let (whole, inside) = of(&scene, usize::MAX);
        assert!(inside > 0, "{}", scene.name);
        assert_eq!(of(&scene, 1).0, whole, "{}", scene.name);
    }
}

/// A cube without a triangle of the face at x = 5: the lines through that triangle are open.
#[test]
fn open_rows_are_named() {
    let scenes = VoxelScene::solids(8);
    let cube = &scenes[4].triangles;
    let grid = Grid::new([0.0; 3], [1.0; 3], [8; 3]).unwrap();
    let (mut words, mut lines) = ([0_u64; 64], [0_u64; 8]);
    for left_out in 0..12 {
        let mut solid = Solid::new(&grid, &mut words, &mut lines).unwrap();
        for (k, [a, b, c]) in cube.iter().enumerate() {
            if k != left_out {
                solid.cross(&Triangle::new(*a, *b, *c).unwrap());
            }
        }
        solid.finish();
        let open: Vec<_> = solid.open_rows().collect();
        let [a, b, c] = cube[left_out];
        if a[0] != b[0] || b[0] != c[0] {
            assert!(open.is_empty(), "along x");
            continue;
        }
        // Between −3 and 5.5, half of the square is before its diagonal.
        assert!(open.len() >= 10 && open.len() < 25, "{left_out}: {open:?}");
        for y in 0..8 {
            for z in 0..8 {
                let inside = (0..8).filter(|&x| solid.bits().contains([x, y, z])).count();
                let closed = y < 5 && z < 5 && !open.contains(&[y, z]);
                assert_eq!(inside, if closed { 5 } else { 0 }, "{left_out}: {y}, {z}");
            }
        }
    }
    let short = |words: usize, lines: usize| {
        let (mut words, mut lines) = (vec![0_u32; words], vec![0_u32; lines]);
        Solid::new(&grid, &mut words, &mut lines).err()
    };
    assert_eq!(short(63, 8), Some(TooFewWords { needed: 64 }));
    assert_eq!(short(64, 7), Some(TooFewWords { needed: 8 }));
    assert_eq!(short(64, 8), None);
}

#[test]
fn walks_are_those_of_the_oracle() {
    for scalar in InScalar::ALL {
        let met = scalar.walks_are_right(1, 60);
        assert!(met > 5_000, "{scalar:?}: {met}");
    }
}

/// Every part of small grids, and the walk backwards: so all ways to cut a grid in parts.
#[test]
fn walks_in_parts_are_those_of_the_whole() {
    walk_in_parts(20_000);
}

/// `cargo test --release --test promises -- --ignored --nocapture a_million_walks_in_parts`
#[test]
#[ignore = "a million for each scalar and kind of line"]
fn a_million_walks_in_parts() {
    walk_in_parts(1_000_000);
}

fn walk_in_parts(cases: u64) {
    for scalar in InScalar::ALL {
        for kind in LineKind::ALL {
            let found = scalar.walks_in_parts(kind, 1, cases);
            println!("{scalar:?}, {kind:?}: {found:?}");
            assert!(found.wrong == 0 && found.cases >= cases, "{scalar:?} {kind:?}: {found:?}");
        }
    }
}

/// What parts of walks were wrong by, before a thin walk was that of a grid without end.
#[test]
fn thin_walks_through_corners() {
    let thin = |grid: &Grid<f64>, segment: &Segment<f64>| -> Vec<[u32; 3]> {
        grid.walk_segment(segment, Rule::Thin).collect()
    };
    let grid = Grid::new([0.0; 3], [1.0; 3], [2, 2, 1]).unwrap();
    let (a, b) = ([0.5, 0.5, 0.5], [1.5, 1.5, 0.5]);
    let segments = [Segment::new(a, b).unwrap(), Segment::new(b, a).unwrap()];
    let right = grid.part([1..2, 0..2, 0..1]).unwrap();
    assert_eq!(thin(&right, &segments[0]), [[0, 0, 0], [0, 1, 0]]);
    assert_eq!(thin(&right, &segments[1]), [[0, 1, 0], [0, 0, 0]]);
    // Only a corner, in which no point is by the half-open rule.
    let lower = grid.part([1..2, 0..1, 0..1]).unwrap();
    assert_eq!(thin(&lower, &segments[0]), [[0, 0, 0]]);
    assert_eq!(lower.walk_segment(&segments[0], Rule::HalfOpen).next(), None);

    // Through corners of the grid on its way in and on its way out.
    let grid = Grid::new([0.0; 3], [1.0; 3], [1, 3, 3]).unwrap();
    let down = Ray::new([0.5, 2.0, 3.0], [0.0, -1.0, -1.0]).unwrap();
    let voxels = [[0, 2, 2], [0, 1, 2], [0, 1, 1], [0, 0, 1], [0, 0, 0]];
    assert!(grid.walk_ray(&down, Rule::Thin).eq(voxels));
    let up = Ray::new([0.5, -1.0, 0.0], [0.0, 1.0, 1.0]).unwrap();
    assert!(grid.walk_ray(&up, Rule::Thin).eq(voxels.into_iter().rev()));
}

/// A walk beside the greatest faces of a grid, where half-open voxels have no point.
#[test]
fn walks_that_meet_nothing_end() {
    let grid = Grid::new([0.0; 3], [1.0; 3], [1 << 30, 8, 8]).unwrap();
    let beside = Segment::new([-1.0, 8.0, 4.5], [2e9, 8.0, 4.5]).unwrap();
    for rule in [Rule::HalfOpen, Rule::Thin] {
        assert_eq!(grid.walk_segment(&beside, rule).next(), None);
    }
    assert_eq!(grid.walk_segment(&beside, Rule::Closed).next(), Some([0, 7, 4]));
}

#[test]
fn long_walks_end() {
    let grid = Grid::new([-1e30_f32; 3], [2e30; 3], [1; 3]).unwrap();
    let line = Ray::new([f32::MAX, 1e-45, -1.0], [-f32::MAX, 0.0, 1e-45]).unwrap();
    assert!(grid.walk_ray(&line, Rule::Thin).eq([[0; 3]]));
    let away = Ray::new([f32::MAX, 1e-45, -1.0], [f32::MAX, 0.0, 1e-45]).unwrap();
    assert_eq!(grid.walk_ray(&away, Rule::Closed).next(), None);

    // From corner to corner: every closed voxel around each corner on the way.
    let grid = Grid::new([0.0; 3], [0.25; 3], [300; 3]).unwrap();
    let diagonal = Segment::new([0.0; 3], [75.0; 3]).unwrap();
    assert_eq!(grid.walk_segment(&diagonal, Rule::HalfOpen).count(), 300);
    assert_eq!(grid.walk_segment(&diagonal, Rule::Thin).count(), 3 * 299 + 1);
    assert_eq!(grid.walk_segment(&diagonal, Rule::Closed).count(), 7 * 299 + 1);
    let along = Segment::new([9.0, 9.0, -5.0], [9.0, 9.0, 99.0]).unwrap();
    assert_eq!(grid.walk_segment(&along, Rule::Closed).count(), 4 * 300);
    assert_eq!(grid.walk_segment(&along, Rule::HalfOpen).count(), 300);
}

/// Lines and cells so long and so short that no float holds a line in cells: by each voxel alone.
#[test]
fn walks_of_lines_beyond_floats_in_cells() {
    let (mut rng, mut met) = (Rng::new(0x10e6), 0);
    for _ in 0..6_000 {
        let power = |exponent: i32| 2_f64.powi(exponent / 2) * 2_f64.powi(exponent - exponent / 2);
        let cell = power([-960, -1, 960][rng.below(3)]);
        let long = power([-1070, -1000, 0, 1000, 1021][rng.below(5)]);
        let grid = Grid::new([0.0; 3], [cell; 3], [4, 4, 2]).unwrap();
        let anchor = rng.triple(|rng| rng.whole(-2, 18) as f64 * 0.25 * cell);
        let way = rng.triple(|rng| rng.whole(-7, 7) as f64 * long);
        let Ok(ray) = Ray::new(anchor, way) else { continue };
        let [segment, back] =
            [[anchor, way], [way, anchor]].map(|[p, q]| Segment::new(p, q).unwrap());
        let of_each = |meets: &dyn Fn(&Aabb<f64>) -> bool| {
            let voxels = (0..32).map(|n| [n % 4, n / 4 % 4, n / 16]);
            voxels.filter(|&v| meets(&grid.voxel(v).unwrap())).collect::<Vec<_>>()
        };
        let sorted = |walk: &mut dyn Iterator<Item = [u32; 3]>| {
            let mut all: Vec<_> = walk.collect();
            all.sort_unstable_by_key(|[x, y, z]| [*z, *y, *x]);
            all
        };
        let by_ray = sorted(&mut grid.walk_ray(&ray, Rule::Closed));
        assert_eq!(by_ray, of_each(&|voxel| ray.overlaps(voxel)), "{grid:?} {ray:?}");
        let by_segment = sorted(&mut grid.walk_segment(&segment, Rule::Closed));
        assert_eq!(by_segment, of_each(&|voxel| segment.overlaps(voxel)), "{grid:?} {segment:?}");
        for rule in [Rule::Closed, Rule::HalfOpen, Rule::Thin] {
            let [mut there, mut back] =
                [&segment, &back].map(|segment| grid.walk_segment(segment, rule));
            assert_eq!(sorted(&mut there), sorted(&mut back), "{rule:?} {grid:?} {segment:?}");
        }
        met += by_ray.len() + by_segment.len();
    }
    assert!(met > 20_000, "{met}");
}

/// A line through a corner of voxels whose time there is beyond all floats.
#[test]
fn walks_through_a_corner_at_an_infinite_time() {
    let power = |exponent: i32| 2_f64.powi(exponent);
    let grid = Grid::new([-2.0, -2.0, 0.0], [1.0; 3], [4, 4, 1]).unwrap();
    let from = [-power(26), -49.0 * power(20), 0.5];
    let ray = Ray::new(from, [power(-998), 49.0 * power(-1004), 0.0]).unwrap();
    let mut walked: Vec<_> = grid.walk_ray(&ray, Rule::Closed).collect();
    walked.sort_unstable();
    let voxels = (0..16).map(|n| [n / 4, n % 4, 0]);
    let met = voxels.filter(|&voxel| ray.overlaps(&grid.voxel(voxel).unwrap()));
    assert_eq!(walked, met.collect::<Vec<_>>());
    assert!(walked.contains(&[2, 1, 0]) && walked.contains(&[1, 2, 0]));
    let half_open: Vec<_> = grid.walk_ray(&ray, Rule::HalfOpen).collect();
    let is_through = half_open.windows(2).any(|pair| pair == [[1, 1, 0], [2, 2, 0]]);
    assert!(is_through, "{half_open:?}");
}
