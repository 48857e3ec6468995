//! Axes that are parallel but for the residue of a quarter turn, or for a tilt of any size: exact,
//! for all pairs with an oriented box.

use septum_kit::boxes::BoxSet;
use septum_kit::lines::LineObb;
use septum_kit::{Case, Oriented, Rng, Sample, three};

/// So many cases of each pair.
const CASES: usize = 4_000;

/// How many are apart and how many meet, as the crate and the oracle say.
fn counted(mut check: impl FnMut(&mut Rng) -> Option<bool>) -> [usize; 2] {
    // `RESIDUES=1000000 cargo test --release --test promises residues -- --nocapture`
    let cases = std::env::var("RESIDUES").map_or(CASES, |n| n.parse().expect("a number of cases"));
    let (mut rng, mut seen) = (Rng::new(0x4e51d), [0; 2]);
    for _ in 0..cases {
        if let Some(meets) = check(&mut rng) {
            seen[usize::from(meets)] += 1;
        }
    }
    assert!(seen.iter().all(|&n| n > cases / 20), "{seen:?}");
    seen
}

fn all_pairs<S: Sample>() {
    const SET: BoxSet = BoxSet::Residue;
    let boxes = counted(|rng| SET.case::<S>(rng).check());
    let triangles = counted(|rng| {
        let case = Oriented::<S>::case(SET, rng);
        case.check().map(|truth| truth != septum_kit::flat::Truth::Apart)
    });
    let lines = counted(|rng| LineObb::<S>::case(SET, rng).check());
    // Triangles in a coordinate plane, turned about axes of space.
    let plates = counted(|rng| {
        let (obb, aabb) = (SET.case::<S>(rng).second, SET.aabb(rng));
        let vertex = |rng: &mut Rng| {
            let along = rng.triple(|rng| rng.whole(-4, 4) as f64 / 4.0);
            let on =
                |i: usize| (0..2).map(|k| along[k] * obb.axes[k][i].approximate()).sum::<f64>();
            three(|i: usize| S::nearest(on(i)))
        };
        let case = Case { vertices: rng.triple(vertex), aabb };
        let (triangle, aabb) = case.shapes();
        let meets = septum_kit::meets(&case);
        assert_eq!(triangle.overlaps(&aabb), meets, "{case:?}");
        assert!(triangle.may_overlap(&aabb) || !meets, "{case:?}");
        Some(meets)
    });
    println!("{}: apart, meeting: {boxes:?} {triangles:?} {lines:?} {plates:?}", S::name());
}

#[test]
fn in_f32() {
    all_pairs::<f32>();
}

#[test]
fn in_f64() {
    all_pairs::<f64>();
}
