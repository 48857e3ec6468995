//! The ends of every scalar's range: right answers, without panic or overflow (tests are built with
//! overflow checks).

use fixed::types::extra::{U0, U8, U16, U32, U64};
use fixed::{FixedI8, FixedI16, FixedI32, FixedI64};
use septum::prepared::PreparedTriangle;
use septum::{Axis, published};
use septum_kit::rays::{RayCase, crossing};
use septum_kit::{BoxNumbers, Case, Each, GROUP_ORDERS, Rng, Sample, is_collinear, meets, three};

/// Runs every query; exact answers are compared with the oracle.
fn ask_everything<S: Sample>(case: &Case<S>) {
    let (triangle, aabb) = case.shapes();
    let expected = meets(case);
    assert_eq!(triangle.overlaps(&aabb), expected, "{case:?}");
    assert_eq!(PreparedTriangle::new(&triangle).overlaps(&aabb), expected, "{case:?}");
    assert!(triangle.may_overlap(&aabb) >= expected, "{case:?}");
    let axis = triangle.separating_axis(&aabb);
    assert_eq!(axis.is_none(), expected, "{case:?}");
    let separates = |axis: &Axis| triangle.is_separated_by(&aabb, *axis);
    assert_eq!(Axis::ALL.iter().find(|axis| separates(axis)), axis.as_ref(), "{case:?}");
    assert_eq!(triangle.is_degenerate(), is_collinear(case), "{case:?}");
    // These may be wrong, but must return.
    let _ = published::shared_normal::overlaps(&triangle, &aabb);
    // The published test gives the same answer, right or wrong, in every order of its groups.
    let published = published::akenine_moller::overlaps(&triangle, &aabb);
    for order in GROUP_ORDERS {
        assert_eq!(
            published::akenine_moller::overlaps_in(&triangle, &aabb, order),
            published,
            "{case:?}"
        );
    }
}

/// Fifteen numbers from a pool.
fn from_pool<S: Sample>(rng: &mut Rng, pool: &[S]) -> Case<S> {
    let mut point = || rng.triple(|rng| pool[rng.below(pool.len())]);
    let vertices = [point(), point(), point()];
    let (p, q) = (point(), point());
    let aabb = if q.iter().all(|&x| x >= S::ZERO) {
        BoxNumbers::Center(p, q)
    } else {
        let least = three(|i| if p[i] < q[i] { p[i] } else { q[i] });
        let greatest = three(|i| if p[i] < q[i] { q[i] } else { p[i] });
        BoxNumbers::Corners(least, greatest)
    };
    Case { vertices, aabb }
}

/// The extremes, their neighbours, and numbers around zero.
fn ends<S: Sample>() -> Vec<S> {
    let near = |x: S| [x.moved(-2), x.moved(-1), x, x.moved(1), x.moved(2)];
    let half = |x: S| S::nearest(x.approximate() / 2.0);
    let (least, greatest) = (S::LEAST, S::GREATEST);
    [near(least), near(half(least)), near(S::ZERO), near(half(greatest)), near(greatest)].concat()
}

fn at_the_ends<S: Sample>() {
    let (mut rng, pool) = (Rng::new(81), ends::<S>());
    for _ in 0..4_000 {
        ask_everything(&from_pool(&mut rng, &pool));
    }
}

/// Every triangle and every box with vertices at the corners of the range.
fn between_the_corners_of_the_range<S: Sample>() {
    let ends = [S::LEAST, S::GREATEST];
    let corner = |n: usize| [ends[n & 1], ends[n >> 1 & 1], ends[n >> 2 & 1]];
    let middle = [S::LEAST, S::ZERO, S::GREATEST];
    let spans = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];
    let triples = (0..512).map(|n| [n >> 6, n >> 3 & 7, n & 7]);
    for vertices in triples.filter(|[a, b, c]| a <= b && b <= c).map(|triple| triple.each(corner)) {
        for number in 0..216 {
            let span = [number % 6, number / 6 % 6, number / 36].each(|n| spans[n]);
            let aabb = BoxNumbers::Corners(
                span.each(|(least, _)| middle[least]),
                span.each(|(_, greatest)| middle[greatest]),
            );
            let case = Case { vertices, aabb };
            let (triangle, aabb) = case.shapes();
            assert_eq!(triangle.overlaps(&aabb), meets(&case), "{case:?}");
        }
    }
}

fn check<S: Sample>() {
    at_the_ends::<S>();
    between_the_corners_of_the_range::<S>();
}

#[test]
fn f32() {
    check::<f32>();
}

#[test]
fn f64() {
    check::<f64>();
}

#[test]
fn eight_bits() {
    check::<FixedI8<U0>>();
    check::<FixedI8<U8>>();
}

#[test]
fn sixteen_bits() {
    check::<FixedI16<U0>>();
    check::<FixedI16<U8>>();
    check::<FixedI16<U16>>();
}

#[test]
fn thirty_two_bits() {
    check::<FixedI32<U0>>();
    check::<FixedI32<U16>>();
    check::<FixedI32<U32>>();
}

#[test]
fn sixty_four_bits() {
    check::<FixedI64<U0>>();
    check::<FixedI64<U32>>();
    check::<FixedI64<U64>>();
}

/// From the least subnormal to the greatest number in one scene.
fn subnormals<S: Sample>(normal: S) {
    let tiny = S::ZERO.moved(1);
    let mut pool = vec![S::ZERO, tiny, tiny.moved(1), normal.moved(-1), normal, normal.moved(1)];
    let mut rng = Rng::new(82);
    for wide in [vec![], vec![S::nearest(1.0)], vec![S::GREATEST, S::nearest(1.5e-20)]] {
        pool.extend(wide);
        let opposites: Vec<S> = pool.iter().map(|x| S::from_ordinal(-x.ordinal())).collect();
        let both = [pool.clone(), opposites].concat();
        for _ in 0..3_000 {
            ask_everything(&from_pool(&mut rng, &both));
        }
    }
}

#[test]
fn subnormal_f32() {
    subnormals(f32::MIN_POSITIVE);
}

#[test]
fn subnormal_f64() {
    subnormals(f64::MIN_POSITIVE);
}

/// The thresholds between integer systems: around every power of two.
fn about_powers_of_two<S: Sample>() {
    let mut rng = Rng::new(83);
    for power in 2..S::WHOLE_BITS {
        let size = 1_i64 << power;
        let near = [size - 1, size, size.saturating_add(1)];
        let mut pool: Vec<S> =
            near.into_iter().filter(|x| x >> S::WHOLE_BITS == 0).map(S::whole).collect();
        pool.extend([-size - 1, -size, 1 - size].each(|x| S::from_ordinal(x)));
        pool.extend([S::ZERO, S::whole(1), S::whole(size / 2), S::whole(-size / 2)]);
        for _ in 0..300 {
            ask_everything(&from_pool(&mut rng, &pool));
        }
    }
}

#[test]
fn about_powers_of_two_in_fixed_point() {
    about_powers_of_two::<FixedI8<U8>>();
    about_powers_of_two::<FixedI16<U16>>();
    about_powers_of_two::<FixedI32<U16>>();
    about_powers_of_two::<FixedI64<U32>>();
}

/// Rays and triangles at the ends of each integer width, with every choice of signs, so that
/// determinants reach their greatest value.
fn every_sign(end: i32) {
    let number = |bits: i32| FixedI32::<U16>::from_bits(bits);
    let point = |signs: u32| three(|i| number(if signs >> i & 1 == 0 { end } else { -end }));
    for signs in 0..1 << 12 {
        let [b, c, o, d] = [0, 3, 6, 9].each(|shift| point(signs >> shift));
        for a in [[number(0); 3], point(0)] {
            let case = RayCase::new(o, d, [a, b, c]);
            let truth = crossing(&case);
            let (ray, triangle) = (case.ray(), case.triangle());
            let hit = ray.hit(&triangle);
            let told = hit.map(|hit| (hit.facing, hit.feature));
            assert_eq!(told, truth.as_ref().map(|t| (t.facing, t.feature)), "{case:?}");
            assert_eq!(ray.is_hit(&triangle), truth.is_some(), "{case:?}");
        }
    }
}

#[test]
fn determinants_of_every_width() {
    for bits in [17, 18, 19, 20, 27, 28, 29, 30, 31] {
        every_sign(((1_i64 << bits) - 1) as i32);
        every_sign((1_i64 << (bits - 1)) as i32);
    }
}

/// A box so large that its faces are out of the type's range, and a triangle just beside it: a
/// kernel that prepares differences in the type must not take a wrapped one for small.
#[test]
fn boxes_beyond_the_range() {
    use fixed::types::I16F16;
    let at = |p: [i32; 3]| p.each(I16F16::from_bits);
    let e = 1 << 28;
    let aabb = BoxNumbers::Center(at([i32::MAX, 0, 0]), at([i32::MAX; 3]));
    let beside = [at([1 - 2 * e, -e, -e]), at([-e, e, -e / 2]), at([-e / 3, 0, e])];
    let within = beside.each(|[x, y, z]| [-x, y, z]);
    for (vertices, expected) in [(beside, false), (within, true)] {
        let case = Case { vertices, aabb };
        assert_eq!(meets(&case), expected);
        ask_everything(&case);
    }
}
