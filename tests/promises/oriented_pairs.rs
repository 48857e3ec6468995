//! Boxes against oriented boxes: exact.

use septum_kit::boxes::{AnyBox, BoxCase, BoxSet, ObbNumbers};
use septum_kit::{BoxNumbers, Rng, Sample, for_every_scalar, with_every_scalar};

/// The number of cases of each set.
const CASES: usize = 800;

fn agrees_with_the_oracle<S: Sample>() {
    for set in BoxSet::ALL {
        let mut rng = Rng::new(0x0bb);
        let mut seen = [0; 2];
        for _ in 0..CASES {
            if let Some(meets) = set.case::<S>(&mut rng).check() {
                seen[usize::from(meets)] += 1;
            }
        }
        if matches!(set, BoxSet::Turned | BoxSet::NearlyParallel | BoxSet::Grid) {
            assert!(seen.iter().all(|&n| n > CASES / 20), "{set:?}: {seen:?}");
        }
    }
}
for_every_scalar!(agrees_with_the_oracle);

/// A hundred times as many cases: `cargo test --release --test promises oriented_pairs --
/// --ignored`.
#[test]
#[ignore = "takes minutes"]
fn agrees_with_the_oracle_on_many() {
    fn many<S: Sample>() {
        for set in BoxSet::ALL {
            let mut rng = Rng::new(0x0bb1);
            let mut seen = [0; 3];
            for _ in 0..50_000 {
                seen[set.case::<S>(&mut rng).check().map_or(0, |meets| 1 + usize::from(meets))] +=
                    1;
            }
            println!("{:8} {set:?}: no boxes, apart, meeting: {seen:?}", S::name());
        }
    }
    with_every_scalar!(many);
}

/// Cases with obvious answers, also for the oracle.
#[test]
fn contact_is_overlap() {
    let along = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let turned = [[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0], [0.0, 0.0, 1.0]];
    let obb = |center, axes, half| ObbNumbers { center, axes, half };
    let unit = AnyBox::Obb(obb([0.0; 3], along, [1.0; 3]));
    let corners = AnyBox::Aabb(BoxNumbers::Corners([-1.0; 3], [1.0; 3]));
    let after = 2.000_000_000_000_000_4;
    for first in [unit, corners] {
        for (second, expected) in [
            // Face on face, edge on edge, corner on corner; and one unit in the last place apart.
            (obb([2.0, 0.0, 0.0], along, [1.0; 3]), true),
            (obb([after, 0.0, 0.0], along, [1.0; 3]), false),
            (obb([2.0, 2.0, 0.0], along, [1.0; 3]), true),
            (obb([2.0, after, 0.0], along, [1.0; 3]), false),
            (obb([2.0; 3], along, [1.0; 3]), true),
            (obb([2.0, 2.0, after], along, [1.0; 3]), false),
            // An edge on a face.
            (obb([2.0, 0.0, 0.0], turned, [0.0, 0.0, 3.0]), false),
            (obb([1.0, 0.0, 0.0], turned, [0.0, 0.0, 3.0]), true),
            // One inside the other, and a point.
            (obb([0.0; 3], turned, [0.5; 3]), true),
            (obb([0.0; 3], turned, [9.0; 3]), true),
            (obb([1.0; 3], turned, [0.0; 3]), true),
            (obb([1.0, 1.0, 1.000_000_000_000_000_2], turned, [0.0; 3]), false),
        ] {
            assert_eq!(BoxCase { first, second }.check(), Some(expected), "{first:?} {second:?}");
        }
    }
}
