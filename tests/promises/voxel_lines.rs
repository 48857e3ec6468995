//! Solids by crossings along rows, and walks along lines, compared with oracles of other methods.

use septum::voxel::{Grid, Rule, Solid, TooFewWords};
use septum::{Ray, Segment, Triangle};
use septum_kit::voxels::{InScalar, VoxelScene};

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
