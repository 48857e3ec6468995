//! Grids of bits as sets: the answers of a set of the standard library.

use std::collections::BTreeSet;

use septum::voxel::{Bits, DifferentGrids, Grid, Word};
use septum_kit::Rng;

/// z, y, x: the order of iteration.
type Voxels = BTreeSet<[u32; 3]>;

fn listed<W: Word>(bits: &Bits<'_, f32, W>) -> Vec<[u32; 3]> {
    bits.iter().map(|[x, y, z]| [z, y, x]).collect()
}

/// Random sets in a grid of any width, the bits beyond the grid set and clear.
fn agrees<W: Word>(filled: [W; 2]) {
    let mut rng = Rng::new(0xb175);
    for width in [1, 3, 31, 32, 33, 64, 65, 130] {
        let size = [width, 1 + rng.below(4) as u32, 1 + rng.below(4) as u32];
        let whole = Grid::new([0.0_f32; 3], [1.0; 3], size).unwrap();
        let n = whole.words::<W>();
        // The bits beyond the grid stay as they are.
        let mut words = [vec![filled[0]; n], vec![filled[1]; n]];
        let mut sets = [Voxels::new(), Voxels::new()];
        for (words, set) in words.iter_mut().zip(&mut sets) {
            let mut bits = Bits::new(&whole, words).unwrap();
            for x in 0..size[0] {
                for y in 0..size[1] {
                    for z in 0..size[2] {
                        let (was_set, is_set) = (bits.contains([x, y, z]), rng.one_in(3));
                        assert_eq!(bits.set([x, y, z], is_set), was_set);
                        assert_eq!(bits.set([x, y, z], is_set), is_set);
                        if is_set {
                            set.insert([z, y, x]);
                        }
                    }
                }
            }
            assert!(!bits.set([size[0], 0, 0], true) && !bits.set([0, 0, u32::MAX], true));
        }
        let [a, b] = &sets;
        let beyond = |words: &[W]| {
            let ones = |w: &W| (0..W::BITS).filter(|&k| *w >> k & W::ONE == W::ONE).count();
            words.iter().map(ones).sum::<usize>() as u64
        };
        let other = words[1].clone();
        let mut right = other.clone();
        let right = Bits::new(&whole, &mut right).unwrap();
        type Operation<W> =
            fn(&mut Bits<'_, f32, W>, &Bits<'_, f32, W>) -> Result<(), DifferentGrids>;
        let cases: [(Operation<W>, Voxels); 3] = [
            (|a, b| a.union_with(b), a | b),
            (|a, b| a.intersect_with(b), a & b),
            (|a, b| a.difference_with(b), a - b),
        ];
        for (operation, expected) in cases {
            let mut left = words[0].clone();
            let spare = beyond(&left) - a.len() as u64;
            let mut bits = Bits::new(&whole, &mut left).unwrap();
            assert_eq!(bits.is_disjoint(&right), Ok(a.is_disjoint(b)));
            assert_eq!(operation(&mut bits, &right), Ok(()));
            assert_eq!(listed(&bits), expected.iter().copied().collect::<Vec<_>>());
            assert_eq!(bits.count(), expected.len() as u64);
            let boxes: Vec<_> = bits.iter().map(|voxel| whole.voxel(voxel).unwrap()).collect();
            assert_eq!(bits.boxes().collect::<Vec<_>>(), boxes);
            if operation(&mut bits, &right).is_ok() && bits.difference_with(&right).is_ok() {
                assert_eq!(bits.is_disjoint(&right), Ok(true));
            }
            bits.clear();
            assert_eq!(bits.iter().next(), None);
            let mut left = words[0].clone();
            operation(&mut Bits::new(&whole, &mut left).unwrap(), &right).unwrap();
            assert_eq!(beyond(&left) - expected.len() as u64, spare, "bits beyond the grid");
        }
    }
}

#[test]
fn agrees_with_sets_of_the_standard_library() {
    agrees::<u32>([0, u32::MAX]);
    agrees::<u32>([u32::MAX, 0]);
    agrees::<u64>([0, u64::MAX]);
    agrees::<u64>([u64::MAX, u64::MAX]);
}

#[test]
fn sets_of_different_grids_are_refused() {
    let whole = Grid::new([0.0_f32; 3], [1.0; 3], [4, 4, 4]).unwrap();
    let part = whole.part([0..4, 0..4, 1..3]).unwrap();
    let moved = Grid::new([0.5_f32; 3], [1.0; 3], [4, 4, 4]).unwrap();
    for other in [part, moved] {
        let (mut a, mut b) = ([0_u32; 16], [0_u32; 16]);
        let mut bits = Bits::new(&whole, &mut a).unwrap();
        let other = Bits::new(&other, &mut b).unwrap();
        assert_eq!(bits.union_with(&other), Err(DifferentGrids));
        assert_eq!(bits.intersect_with(&other), Err(DifferentGrids));
        assert_eq!(bits.difference_with(&other), Err(DifferentGrids));
        assert_eq!(bits.is_disjoint(&other), Err(DifferentGrids));
    }
}
