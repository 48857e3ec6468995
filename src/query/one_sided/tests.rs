//! The types that hold an area, beside each other.

use super::*;
use crate::arithmetic::{Each, SplitSum};
use crate::random::Random;

/// All ways to hold an area agree, on the widest shapes that a word permits and in contact.
/// `tests/` checks that they are right.
#[test]
fn areas_agree() {
    let mut random = Random(1);
    let mut below = |n: u64| random.below(n) as i32;
    for (bits, is_narrow) in [(18, true), (29, false)] {
        let far = (1 << bits) - 1;
        let mut apart = 0;
        for case in 0..100_000 {
            let projections = [(); 3].each(|()| match case % 3 {
                0 => ([(); 3].each(|()| below(2 * far as u64 + 1) - far), below(1 << bits)),
                1 => ([(); 3].each(|()| [-far, -1, 0, 1, far][below(5) as usize]), far * below(2)),
                _ => ([(); 3].each(|()| below(13) - 4), 4),
            });
            let short = projections.each(|(t, size)| Projection { t, size });
            let long = projections
                .each(|(t, size)| Projection { t: t.each(i64::from), size: i64::from(size) });
            let verdict = in_areas::<_, SplitSum<_>, Closed>(&long);
            assert_eq!(verdict, in_areas::<_, i64, Closed>(&short), "{projections:?}");
            assert!(
                !is_narrow || verdict == in_areas::<_, SplitSum<_>, Closed>(&short),
                "{projections:?}"
            );
            apart += u32::from(verdict);
        }
        assert!((25_000..75_000).contains(&apart), "{apart} of 100,000 are apart");
    }
}
