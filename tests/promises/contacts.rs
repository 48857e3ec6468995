//! Shapes in each other: the least translation takes them apart, and is least; points and parts.

use septum_kit::boxes::BoxSet;
use septum_kit::contacts::ContactSet;
use septum_kit::{Rng, Sample, for_every_scalar};

/// Cases of each set; so many of them by linear programming too.
const CASES: usize = 160;
const PROGRAMMED: usize = 30;

fn agrees_with_the_oracles<S: Sample>() {
    for set in ContactSet::ALL {
        let mut rng = Rng::new(0xc0a1);
        let mut seen = [0; 2];
        for n in 0..CASES {
            // What numbers of any size shrink by is not known to be too little.
            let few_bits = !matches!(set, ContactSet::Like(BoxSet::Bits | BoxSet::Huge));
            let case = set.case::<S>(&mut rng);
            if let Some(is_contact) = case.check(few_bits && n < PROGRAMMED) {
                seen[usize::from(is_contact)] += 1;
            }
        }
        let is_mixed = seen.iter().all(|&n| n > CASES / 20);
        let may_be_one_sided = matches!(set, ContactSet::Like(BoxSet::Bits | BoxSet::Huge));
        assert!(is_mixed || may_be_one_sided, "{} {set:?}: {seen:?}", S::name());
    }
}
for_every_scalar!(agrees_with_the_oracles);
