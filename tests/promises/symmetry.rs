//! Changes that must not change a verdict: the order of vertices, the order of the published test's
//! groups, the 48 symmetries of the box, powers of two, and translations without rounding.

use septum::published;
use septum_kit::{
    BoxNumbers, Case, Each, GROUP_ORDERS, Rng, Sample, Set, Touch, VERTEX_ORDERS, for_every_scalar,
    three,
};

/// Cases of each set.
const COUNT: usize = 1_500;

fn overlaps<S: Sample>(case: &Case<S>) -> bool {
    let (triangle, aabb) = case.shapes();
    triangle.overlaps(&aabb)
}

fn order_of_vertices<S: Sample>() {
    for set in Set::ALL {
        for case in set.cases::<S>(71, COUNT) {
            let expected = overlaps(&case);
            for order in VERTEX_ORDERS {
                let vertices = order.each(|k| case.vertices[k]);
                assert_eq!(overlaps(&Case { vertices, ..case }), expected, "{set:?}: {case:?}");
            }
        }
    }
}

fn order_of_the_published_tests_groups<S: Sample>() {
    for set in Set::ALL {
        for case in set.cases::<S>(75, COUNT) {
            let (triangle, aabb) = case.shapes();
            let expected = published::akenine_moller::overlaps(&triangle, &aabb);
            for order in GROUP_ORDERS {
                let verdict = published::akenine_moller::overlaps_in(&triangle, &aabb, order);
                assert_eq!(verdict, expected, "{set:?}, {order:?}: {case:?}");
            }
        }
    }
}

fn symmetries_of_the_box<S: Sample>() {
    for set in Set::ALL {
        // The least fixed-point number cannot be negated.
        let can_turn = |case: &Case<S>| case.numbers().into_iter().all(|x| opposite(x).is_some());
        for case in set.cases::<S>(72, COUNT).into_iter().filter(can_turn) {
            let expected = overlaps(&case);
            for symmetry in 0..48 {
                let turned = turned(&case, VERTEX_ORDERS[symmetry / 8], symmetry % 8);
                assert_eq!(overlaps(&turned), expected, "{set:?}, {symmetry}: {case:?}");
            }
        }
    }
}

/// −x, if the scalar has it.
fn opposite<S: Sample>(x: S) -> Option<S> {
    let y = S::from_ordinal(x.ordinal().checked_neg()?);
    (y.ordinal() == -x.ordinal()).then_some(y)
}

/// The case with its axes permuted, and the axes in the bits of `mirrored` reversed.
fn turned<S: Sample>(case: &Case<S>, order: [usize; 3], mirrored: usize) -> Case<S> {
    let is_mirrored = |i: usize| mirrored >> i & 1 != 0;
    let length = |v: [S; 3]| order.each(|k| v[k]);
    let place = |v: [S; 3]| {
        let v = length(v);
        core::array::from_fn(|i| {
            if is_mirrored(i) { opposite(v[i]).expect("an opposite") } else { v[i] }
        })
    };
    let aabb = match case.aabb {
        BoxNumbers::Center(c, h) => BoxNumbers::Center(place(c), length(h)),
        BoxNumbers::Corners(min, max) => {
            // Reversal exchanges least and greatest.
            let (p, q) = (place(min), place(max));
            let pick = |i, p: [S; 3], q: [S; 3]| if is_mirrored(i) { q[i] } else { p[i] };
            let (min, max) = (three(|i| pick(i, p, q)), three(|i| pick(i, q, p)));
            BoxNumbers::Corners(min, max)
        }
    };
    Case { vertices: case.vertices.each(place), aabb }
}

fn powers_of_two<S: Sample>() {
    let mut scalings = 0;
    for set in Set::ALL {
        for case in set.cases::<S>(73, COUNT) {
            let expected = overlaps(&case);
            // From the last subnormals to the last before infinity.
            for power in [-1021, -140, -120, -30, -14, -3, -2, -1, 1, 2, 3, 8, 14, 60, 120, 900] {
                let Some(scaled) = scaled(&case, power) else { continue };
                scalings += 1;
                assert_eq!(overlaps(&scaled), expected, "{set:?}, 2^{power}: {case:?}");
            }
        }
    }
    // Scalings that round are left out; they must not be nearly all.
    assert!(scalings > COUNT * 3, "{scalings}");
}

/// The case times 2^power, if no number of it rounds.
fn scaled<S: Sample>(case: &Case<S>, power: i32) -> Option<Case<S>> {
    let odd = |x: S, power: i32| {
        let (mantissa, exponent) = x.mantissa_exponent();
        let zeros = mantissa.trailing_zeros();
        (mantissa != 0).then(|| (mantissa >> zeros, exponent + zeros as i32 + power))
    };
    let number = |x: S| {
        let y = S::nearest(x.approximate() * 2_f64.powi(power));
        (odd(y, 0) == odd(x, power)).then_some(y)
    };
    let numbers = case.numbers().map(number);
    let triple = |r: usize| Some([numbers[3 * r]?, numbers[3 * r + 1]?, numbers[3 * r + 2]?]);
    let (p, q) = (triple(3)?, triple(4)?);
    Some(Case {
        vertices: [triple(0)?, triple(1)?, triple(2)?],
        aabb: match case.aabb {
            BoxNumbers::Center(..) => BoxNumbers::Center(p, q),
            BoxNumbers::Corners(..) => BoxNumbers::Corners(p, q),
        },
    })
}

/// Contacts and near misses, translated by integers.
fn translation<S: Sample>() {
    let mut rng = Rng::new(74);
    let most = (1 << Touch::bits::<S>()) - 1;
    let mut moves = 0;
    while moves < 8 * COUNT {
        let mut touch = Touch::of_any_size::<S>(&mut rng);
        let (k, i) = (rng.below(3), rng.below(3));
        touch.vertices[k][i] += rng.whole(-1, 1);
        let by_center = rng.one_in(2);
        let expected = overlaps(&touch.case::<S>(by_center));
        for _ in 0..8 {
            let by = rng.triple(|rng| rng.whole(-most, most));
            let there = translated(&touch, by);
            let corners = there.vertices.into_iter().chain([there.least, there.greatest]);
            if corners.flatten().all(|x| x.abs() <= most) {
                moves += 1;
                assert_eq!(overlaps(&there.case::<S>(by_center)), expected, "{touch:?} by {by:?}");
            }
        }
    }
}

fn translated(touch: &Touch, by: [i64; 3]) -> Touch {
    let moved = |v: [i64; 3]| core::array::from_fn(|i| v[i] + by[i]);
    Touch {
        vertices: touch.vertices.each(moved),
        least: moved(touch.least),
        greatest: moved(touch.greatest),
        ..*touch
    }
}

for_every_scalar!(
    order_of_vertices,
    order_of_the_published_tests_groups,
    symmetries_of_the_box,
    powers_of_two,
    translation,
);
