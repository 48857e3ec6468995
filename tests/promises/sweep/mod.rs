//! Shapes that move: whether they meet, and when first.

use septum_kit::sweeps::SweepSet;
use septum_kit::{Sample, for_every_scalar};

/// So many cases of each set.
const CASES: usize = 300;

fn triangles_with_boxes<S: Sample>() {
    for set in SweepSet::ALL {
        let mut seen = [0; 3];
        for sweep in set.cases::<S>(0x5eeb, CASES) {
            let found = sweep.check();
            seen[found.map_or(0, |first| 1 + usize::from(first.axis.is_some()))] += 1;
        }
        println!("{set:?}: {seen:?}");
    }
}
for_every_scalar!(triangles_with_boxes);

fn boxes_with_boxes<S: Sample>() {
    for set in SweepSet::ALL {
        let mut seen = [0; 3];
        for sweep in set.boxes::<S>(0x5eec, CASES) {
            let found = sweep.check();
            seen[found.map_or(0, |first| 1 + usize::from(first.axis.is_some()))] += 1;
        }
        println!("{set:?}: {seen:?}");
    }
}
for_every_scalar!(boxes_with_boxes);
