//! Grids of voxels: planes are exactly where documented, and the voxels that a triangle marks agree
//! with an oracle that clips it, and with one test for each voxel.

use septum::voxel::{Bits, Grid, GridError, Row, Rule, TooFewWords};
use septum::{Triangle, Vec3};
use septum_kit::voxels::{InScalar, VoxelScene};
use septum_kit::{Each, Rng, three};

const RULES: [Rule; 3] = [Rule::Closed, Rule::HalfOpen, Rule::Thin];

/// Checks every scene in the scalar's range, under every rule. Returns their number.
fn is_exact(scalar: InScalar, n: u32) -> u32 {
    let mut held = 0;
    for scene in VoxelScene::all(n) {
        for rule in RULES {
            let Some(found) = scalar.check(&scene, rule) else { continue };
            held += 1;
            let what = format!("{scalar:?}, {}, {rule:?}: {found:?}", scene.name);
            assert!(found.missed == 0 && found.extra == 0, "{what}");
            assert!(found.set > u64::from(10 * n) || rule == Rule::Thin, "{what}");
        }
    }
    held
}

#[test]
fn voxels_are_those_of_the_oracle() {
    assert!(is_exact(InScalar::F32, 24) >= 18);
}

#[test]
fn in_every_scalar() {
    for scalar in InScalar::ALL.into_iter().skip(1) {
        assert!(is_exact(scalar, 10) >= 18, "{scalar:?}");
    }
}

/// Every scene at 32 to 128, in every scalar: takes minutes.
#[test]
#[ignore = "takes minutes"]
fn at_high_resolution() {
    for scalar in InScalar::ALL {
        let held = [32, 64, 128].each(|n| is_exact(scalar, n));
        println!("{scalar:?}: scenes and rules at 32, 64 and 128: {held:?}");
        assert!(held[0] > 0, "{scalar:?}");
    }
}

#[test]
fn rows_say_what_pairs_and_the_oracle_say() {
    for scalar in InScalar::ALL {
        let met = scalar.rows_agree_with_pairs(1, 200, 9);
        assert!(met > 8_000, "{scalar:?}: {met}");
        let marked = scalar.marks_agree_with_oracle(3, 60, 6);
        assert!(marked > 3_000, "{scalar:?}: {marked}");
        // Blocks of up to 30 voxels a side.
        let met = scalar.rows_agree_with_pairs(4, 12, 30);
        assert!(met > 2_000, "{scalar:?}: {met}");
        // Rows, layers and slabs of several blocks and several words.
        let met = scalar.rows_agree_with_pairs(2, 4, 80);
        assert!(met > 500, "{scalar:?}: {met}");
    }
}

#[test]
fn order_and_slabs_change_nothing() {
    for scene in VoxelScene::all(20) {
        for rule in RULES {
            InScalar::F32.keeps_order_and_slabs(&scene, rule);
        }
    }
}

/// Rows, bits and the inside: of every part of small grids those of the whole.
#[test]
fn marks_in_parts_are_those_of_the_whole() {
    marks_in_parts(4_000);
}

/// `cargo test --release --test promises -- --ignored --nocapture a_million_marks_in_parts`
#[test]
#[ignore = "a million for each scalar"]
fn a_million_marks_in_parts() {
    marks_in_parts(1_000_000);
}

fn marks_in_parts(cases: u64) {
    for scalar in InScalar::ALL {
        let found = scalar.marks_in_parts(1, cases);
        println!("{scalar:?}: {found:?}");
        assert!(found.wrong == 0 && found.cases >= cases, "{scalar:?}: {found:?}");
    }
}

/// Grids of up to 2^90 voxels: a call that visits the rows that it does not return does not end.
#[test]
fn rows_of_the_largest_grids() {
    for scalar in InScalar::ALL {
        assert_eq!(scalar.rows_under_nothing(), 0, "{scalar:?}");
        let found = scalar.first_rows(1, 2_000);
        assert!(found.wrong == 0 && found.cases >= 2_000, "{scalar:?}: {found:?}");
    }
    // The last plane of the largest grid.
    let grid = Grid::new([0.0; 3], [1.0; 3], [Grid::<f64>::MOST; 3]).unwrap();
    let m = f64::from(Grid::<f64>::MOST);
    let last = Triangle::new([m - 0.5; 3], [m, m - 1.5, m], [m - 0.25, m, m - 1.5]).unwrap();
    let rows: u32 = grid.rows(&last, Rule::Closed).map(|row| row.x.end - row.x.start).sum();
    let end = Grid::<f64>::MOST - 1;
    let voxels = (0..8).map(|n| three(|i| end - (n >> i & 1)));
    let met = voxels.filter(|&v| last.overlaps(&grid.voxel(v).unwrap())).count();
    assert!(met > 2 && rows == met as u32);
}

/// A grid-aligned cube of 30 voxels a side.
#[test]
fn faces_on_planes() {
    let cube = VoxelScene::all(32).into_iter().find(|scene| scene.name == "aligned cube");
    let cube = VoxelScene {
        triangles: cube.unwrap().triangles[..12].to_vec(),
        ..VoxelScene::all(32)[3].clone()
    };
    let set = |rule| InScalar::F64.check(&cube, rule).unwrap().set;
    // Closed: two layers of 32 and 30 a side, without the inside. Half-open: from 1 to 31.
    assert_eq!(set(Rule::Closed), 32_u64.pow(3) - 28_u64.pow(3));
    assert_eq!(set(Rule::HalfOpen), 31_u64.pow(3) - 29_u64.pow(3));
}

#[test]
fn planes_are_origin_and_cells() {
    let rng = &mut Rng::new(5);
    for _ in 0..200 {
        let (o, c) = (rng.real(-9.0, 9.0) as f32, rng.real(0.01, 3.0) as f32);
        let grid = Grid::new([o; 3], [c; 3], [77; 3]).unwrap();
        let k = rng.whole(0, 76) as u32;
        let voxel = grid.voxel([k; 3]).unwrap();
        let plane = |k: u32| Vec3::splat(o + k as f32 * c);
        assert_eq!(voxel.min_max(), Some((plane(k), plane(k + 1))));
        let part = grid.part([k..77, k..77, k..77]).unwrap();
        assert_eq!((part.voxel([0; 3]), part.offset()), (Some(voxel), [k; 3]));
        assert_eq!(grid.voxel([77, 0, 0]), None);
    }
    // From one end of a type to the other.
    use fixed::types::I8F8;
    let grid = Grid::new([I8F8::MIN; 3], [I8F8::from_bits(257); 3], [255; 3]).unwrap();
    let (_, max) = grid.voxel([254; 3]).unwrap().min_max().unwrap();
    assert_eq!(max, Vec3::splat(I8F8::MAX));
}

#[test]
fn bad_grids() {
    let grid = |o: f32, c: f32, n: u32| Grid::new([0.0, o, 0.0], [1.0, c, 1.0], [1, n, 1]).err();
    assert_eq!(grid(f32::NAN, 1.0, 1), Some(GridError::NotFinite));
    assert_eq!(grid(0.0, f32::INFINITY, 1), Some(GridError::NotFinite));
    assert_eq!(grid(0.0, 0.0, 1), Some(GridError::CellNotPositive));
    assert_eq!(grid(0.0, -1.0, 1), Some(GridError::CellNotPositive));
    assert_eq!(grid(0.0, 1.0, 0), Some(GridError::NoVoxels));
    assert_eq!(grid(0.0, 1.0, u32::MAX), Some(GridError::TooManyVoxels));
    assert_eq!(grid(0.0, f32::MAX, 2), Some(GridError::OutOfRange));
    // 8 roundoffs of 2^24 are 8, the size of a cell here; two of its planes are two numbers apart.
    let far = 2_f32.powi(24);
    assert_eq!(grid(far, 7.0, 1), Some(GridError::CellTooSmall));
    assert_eq!(grid(far - 9.0, 9.0, 1), None);
    assert_eq!(grid(0.0, 1.0, 1 << 21), None);
    assert_eq!(grid(0.0, 1.0, (1 << 21) + 1), Some(GridError::CellTooSmall));
    let fixed =
        |n: u32| Grid::new([fixed::types::I8F8::ZERO; 3], [fixed::types::I8F8::ONE; 3], [n; 3]);
    assert!(fixed(127).is_ok());
    assert_eq!(fixed(128).err(), Some(GridError::OutOfRange));

    let grid = Grid::new([0.0; 3], [1.0; 3], [65, 2, 3]).unwrap();
    assert!(grid.part([0..65, 0..2, 0..4]).is_none() && grid.part([9..9, 0..2, 0..3]).is_none());
    assert_eq!((grid.words::<u64>(), grid.words::<u32>()), (12, 18));
    let short = Bits::new(&grid, &mut [0_u64; 11]).err();
    assert_eq!(short, Some(TooFewWords { needed: 12 }));
    assert!(Bits::new(&grid, &mut [0_u64; 13]).is_ok());
}

#[test]
fn words_of_either_width() {
    let grid = Grid::new([0.0_f32; 3], [1.0; 3], [150, 20, 9]).unwrap();
    let t = Triangle::new([-5.0, 1.0, 1.0], [160.0, 3.0, 2.0], [80.0, 19.0, 8.0]).unwrap();
    // Bits beyond the grid in a row's last word are unchanged.
    let mut wide = vec![0_u64; grid.words::<u64>()];
    wide[2] = 1 << 22;
    let mut narrow = vec![0_u32; grid.words::<u32>()];
    Bits::new(&grid, &mut wide).unwrap().fill(&t, Rule::Closed);
    Bits::new(&grid, &mut narrow).unwrap().fill(&t, Rule::Closed);
    assert!(wide[2] >> 22 == 1 && wide[5] >> 22 == 0);
    let (wide, narrow) =
        (Bits::new(&grid, &mut wide).unwrap(), Bits::new(&grid, &mut narrow).unwrap());
    let mut count = 0;
    for (x, y, z) in (0..150 * 20 * 9).map(|n| (n % 150, n / 150 % 20, n / 3000)) {
        assert_eq!(wide.contains([x, y, z]), narrow.contains([x, y, z]));
        count += u64::from(wide.contains([x, y, z]));
    }
    assert!(count > 1000 && wide.count() == count && narrow.count() == count);
    assert!(!wide.contains([150, 0, 0]) && !wide.contains([0, 20, 0]) && !wide.contains([0, 0, 9]));
}

/// A few voxels on both sides of a word's end.
#[test]
fn a_few_voxels_of_two_words() {
    let grid = Grid::new([0.0_f32; 3], [1.0; 3], [70, 4, 4]).unwrap();
    let mut words = vec![0_u32; grid.words::<u32>()];
    for x in [29.5, 30.5, 31.5, 61.5, 62.5, 63.5, 66.5] {
        let t = Triangle::new([x, 0.2, 0.6], [x + 2.7, 1.9, 1.4], [x + 0.4, 1.5, 1.7]).unwrap();
        words.fill(0);
        let mut bits = Bits::new(&grid, &mut words).unwrap();
        bits.fill(&t, Rule::Closed);
        let mut count = 0;
        for voxel in (0..70 * 4 * 4).map(|n| [n % 70, n / 70 % 4, n / 280]) {
            let meets = t.overlaps(&grid.voxel(voxel).unwrap());
            assert_eq!(bits.contains(voxel), meets, "{voxel:?} {t:?}");
            count += u64::from(meets);
        }
        assert!((5..=16).contains(&count) && bits.count() == count, "{count}");
    }
}

/// The reciprocal of the cell size is infinite, and the positions of zero are NaN.
#[test]
fn cells_without_a_reciprocal() {
    let c = 2_f64.powi(-1000) * 2_f64.powi(-30);
    let grid = Grid::new([0.0_f64; 3], [c, 1.0, 1.0], [8; 3]).unwrap();
    for points in [
        [[0.0, 0.5, 0.5], [0.0, 5.5, 0.5], [0.0, 0.5, 5.5]],
        [[5.5 * c, 0.5, 0.5], [2.0 * c, 6.5, 0.5], [0.0, 0.5, 6.0]],
    ] {
        let t = Triangle::new(points[0], points[1], points[2]).unwrap();
        let mut words = vec![0_u64; grid.words::<u64>()];
        let mut bits = Bits::new(&grid, &mut words).unwrap();
        bits.fill(&t, Rule::Closed);
        let rows: u32 = grid.rows(&t, Rule::Closed).map(|row| row.x.end - row.x.start).sum();
        let mut met = 0;
        for voxel in (0..512).map(|n| [n % 8, n / 8 % 8, n / 64]) {
            let expected = t.overlaps(&grid.voxel(voxel).unwrap());
            assert_eq!(bits.contains(voxel), expected, "{voxel:?}");
            met += u32::from(expected);
        }
        assert_eq!(rows, met);
        assert!(met > 10);
    }
}

/// The normal's products overflow, though the triangle contains the middle of all its rows.
#[test]
fn normals_beyond_floats() {
    let f = f64::from_bits;
    let [by, bz] = [f(0x5ff9_4034_bed7_1c68), f(0x5ffe_6a35_0f3d_bd9c)];
    let [cy, cz] = [f(0xe012_f027_8f21_554e), f(0xe016_cfa7_cb6e_4e35)];
    let x = 2_f64.powi(500);
    let t = Triangle::new([-x, 0.0, 0.0], [x, by, bz], [x, cy, cz]).unwrap();
    let grid = Grid::new([0.0, -3.0, -3.0], [3.0; 3], [8, 2, 2]).unwrap();
    let mut words = vec![0_u64; grid.words::<u64>()];
    let mut bits = Bits::new(&grid, &mut words).unwrap();
    bits.fill(&t, Rule::Closed);
    let rows: Vec<_> = grid.rows(&t, Rule::Closed).collect();
    let mut count = 0;
    for voxel in (0..32).map(|n| [n % 8, n / 8 % 2, n / 16]) {
        let meets = t.overlaps(&grid.voxel(voxel).unwrap());
        assert_eq!(bits.contains(voxel), meets, "{voxel:?}");
        let in_rows = |row: &Row| [row.y, row.z] == voxel[1..] && row.x.contains(&voxel[0]);
        assert_eq!(rows.iter().any(in_rows), meets, "{voxel:?}");
        count += u32::from(meets);
    }
    assert!(count >= 8, "{count}");
}

/// For any numbers, an answer comes, and soon.
#[test]
fn extremes() {
    let many = [f32::MAX, -f32::MAX, 1e-45, 0.0, 3.0, 1e30, -1e30, f32::MIN_POSITIVE];
    let grids = [
        Grid::new([-1.0_f32; 3], [0.25; 3], [8; 3]),
        Grid::new([-1e38_f32; 3], [2.5e37; 3], [8; 3]),
        Grid::new([0.0_f32; 3], [1e-45; 3], [8; 3]),
    ];
    for grid in grids {
        let grid = grid.unwrap();
        for n in (0..many.len().pow(3)).step_by(5) {
            let pick = |k: usize| many[n / many.len().pow(k as u32 % 3) % many.len()];
            let t = Triangle::new(
                [pick(0), pick(1), pick(2)],
                [pick(1), pick(2), 0.5],
                [pick(2), -0.25, pick(0)],
            );
            let t = t.unwrap();
            let mut set = [[[false; 8]; 8]; 8];
            for row in grid.rows(&t, Rule::Closed) {
                row.x.for_each(|x| set[row.z as usize][row.y as usize][x as usize] = true);
            }
            for (x, y, z) in (0..8 * 8 * 8).map(|n| (n % 8, n / 8 % 8, n / 64)) {
                let voxel = grid.voxel([x, y, z]).unwrap();
                let is_set = set[z as usize][y as usize][x as usize];
                assert_eq!(is_set, t.overlaps(&voxel), "{t:?} {voxel:?}");
            }
        }
    }
}
