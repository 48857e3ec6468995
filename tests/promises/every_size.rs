//! Verdicts are exact at every size of shape and every distance from the origin: each integer width
//! escalates to the next before it overflows (overflow checks are on), and float stages escalate
//! before they underflow.

use septum::prepared::PreparedTriangle;
use septum_kit::{BoxNumbers, Case, Each, Rng, Sample, for_every_scalar, meets, three};

/// A point with coordinates up to `size` numbers of the type away from those of `from`. In half of
/// the cases it is at the very ends, where products are largest.
fn near<S: Sample>(rng: &mut Rng, from: [S; 3], size: i64) -> [S; 3] {
    let at_the_ends = rng.one_in(2);
    from.each(|x| {
        let step = if at_the_ends {
            [-size, size, size - 1][rng.below(3)]
        } else {
            rng.whole(-size, size)
        };
        x.moved(step)
    })
}

fn exact_at_every_size<S: Sample>() {
    let mut rng = Rng::new(0x512e);
    let range = S::GREATEST.ordinal();
    let bits = 64 - range.leading_zeros();
    for _ in 0..200 {
        // Powers of two, and the numbers just below them.
        for size in (0..bits).flat_map(|k| [1_i64 << k, (1 << k) - 1]) {
            // Around the origin, and around a point anywhere in the range.
            let origin = if rng.one_in(2) {
                [S::ZERO; 3]
            } else {
                [(); 3].each(|()| S::from_ordinal(rng.whole(-range, range)))
            };
            let mut point = || near(&mut rng, origin, size);
            let vertices = [point(), point(), point()];
            let (p, q) = (point(), point());
            let smaller = |i: usize| if p[i] < q[i] { (p[i], q[i]) } else { (q[i], p[i]) };
            let corners = BoxNumbers::Corners(three(|i| smaller(i).0), three(|i| smaller(i).1));
            let half =
                near(&mut rng, [S::ZERO; 3], size).each(|h| if h < S::ZERO { S::ZERO } else { h });
            for aabb in [corners, BoxNumbers::Corners(p, p), BoxNumbers::Center(p, half)] {
                let case = Case { vertices, aabb };
                let (triangle, shape) = case.shapes();
                let expected = meets(&case);
                assert_eq!(triangle.overlaps(&shape), expected, "{case:?}");
                let prepared = PreparedTriangle::new(&triangle);
                assert_eq!(prepared.overlaps(&shape), expected, "{case:?}");
                assert_eq!(triangle.separating_axis(&shape).is_none(), expected, "{case:?}");
                assert!(!expected || triangle.may_overlap(&shape), "{case:?}");
            }
        }
    }
}
for_every_scalar!(exact_at_every_size);
