//! Hits whose t overflow, or round to one number.

use septum_kit::meshes::{Faces, MeshRay, MeshSet};
use septum_kit::{Each, Rng, Sample};

/// `cargo edges 1000000` checks a million cases of each scalar.
pub(super) fn hits_are_in_true_order<S: Sample>() {
    let mut rng = Rng::new(0xed6e);
    for set in MeshSet::ALL {
        let mut seen = [0; 2];
        for _ in 0..3_000 {
            let [hits, alike] = set.ray::<S>(&mut rng).check();
            seen[0] += hits;
            seen[1] += usize::from(alike > 0);
        }
        assert!(seen[0] > 2_000, "{} {set:?}: {seen:?}", S::name());
        assert!(seen[1] > 50 || set == MeshSet::Grid, "{} {set:?}: {seen:?}", S::name());
    }
}

pub(super) fn contacts_are_the_first<S: Sample>() {
    let mut rng = Rng::new(0xed6f);
    let met = (0..300).filter(|k| MeshSet::ALL[k % 3].sweep::<S>(&mut rng).check().is_some());
    let met = met.count();
    assert!(met > 30, "{}: {met} met", S::name());
}

/// All t round to −∞, and the triangle that is found first is not the first on the line.
#[test]
fn the_first_hit_may_be_at_minus_infinity() {
    let points = [
        [0xfe7f_fff8_u32, 0xfe9f_fffb, 0x0],
        [0xfe9f_fffb, 0x7d7f_fff8, 0xfe3f_fffa],
        [0xfe9f_fffb, 0x7d7f_fff8, 0x7ebf_fffa],
        [0xfe3f_fffa, 0x0, 0xfebf_fffa],
        [0x7e7f_fff8, 0xfdff_fff8, 0xfe7f_fff8],
    ];
    let at = |p: [u32; 3]| p.each(f32::from_bits);
    // The second mesh needs two leaves: the hit in the first one must not hide the hit in the other.
    let pair = vec![[3, 0, 1], [1, 3, 0]];
    let leaves = vec![[3, 4, 2], [2, 3, 4], [2, 1, 3], [2, 3, 2], [2, 2, 0]];
    for faces in [pair, leaves] {
        let case = MeshRay {
            mesh: Faces { vertices: points.map(at).to_vec(), faces },
            origin: at([0x7dbf_fffa, 0xfcff_fff8, 0xfe5f_fff9]),
            direction: at([0x3e00_0000, 0, 0]),
            range: [None, None],
        };
        let [hits, _] = case.check();
        assert!(hits > 1);
    }
}
