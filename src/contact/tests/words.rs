//! On small cores words have the numbers of sums, and leave few directions.

use super::{Draw, NOTHING_IS_KNOWN, by_sums};
use crate::arithmetic::Each;
use crate::contact::Shape;
use crate::contact::cut::{Cut, Rounded};
use crate::contact::directions::all;
use crate::contact::exact::{Exact, Given};
use crate::contact::least::{Numbers, exact_in_words};
use crate::contact::measures::{Lengths, Way};
use crate::contact::wanted::Wanted;
use crate::contact::whole::{Pair, in_words};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Obb, Triangle};

/// Whether a contact is found, the directions that half words leave of it, and whether words hold the shapes.
fn check_pair<S: Scalar>(first: &impl Shape<S>, second: &impl Shape<S>) -> [usize; 3] {
    let bodies = [first.body(), second.body()];
    let mut least = (Way::NONE, Lengths::NONE);
    let mut pair = Pair::NONE;
    if !in_words(&bodies, &mut pair) {
        return [0; 3];
    }
    let is_found = exact_in_words(&bodies, false, &mut least).unwrap();
    let is_found = is_found.is_ok_and(|is_found| is_found);
    let least = is_found.then_some(least);
    let found = least.map(|(way, lengths)| (way.direction, way.is_along, Some(lengths.depth)));
    assert_eq!(found, by_sums(&bodies), "{bodies:?}");
    for &direction in all(&bodies) {
        let own = direction.sides(pair.are_triangles);
        let given: &dyn Given = &pair.along(direction.numbers(pair.are_triangles));
        let exact = Exact::new(given, pair.are_triangles, own, &NOTHING_IS_KNOWN, [true; 2]);
        let sums = Numbers::Sums.along(&bodies, direction, &NOTHING_IS_KNOWN, [true; 2]);
        assert_eq!(exact, sums, "{direction:?} {bodies:?}");
    }
    let mut rounded = Rounded::NONE;
    let wanted = Wanted::in_words(all(&bodies), &Cut::new(&pair, &mut rounded)).ok();
    let left = wanted.map_or(0, |wanted| wanted.iter().count());
    if found.is_some() { [1, left, 1] } else { [0, 0, 1] }
}

fn check_scalar<S: Scalar>(bits: u32, of: fn(f64) -> S, axis: fn(f64) -> S) -> [usize; 3] {
    let (mut draw, mut seen) = (Draw(u64::from(bits)), [0; 3]);
    for _ in 0..30 {
        let [a, b, c, p, q, r] = [(); 6].map(|()| draw.point(bits, of));
        let half = [(); 2].each(|()| draw.half(bits, of));
        let axes = [(); 2].each(|()| [(); 3].each(|()| draw.point(bits, axis)));
        let [t, u] = [[a, b, c], [p, q, r]].each(|[a, b, c]| Triangle::new(a, b, c).unwrap());
        let aabb = Aabb::from_center_half_extents(p, half[0]).unwrap();
        let obb = |k: usize| Obb::from_skewed_axes([q, r][k], axes[k], half[k]);
        let (Ok(c), Ok(d)) = (obb(0), obb(1)) else { continue };
        let pairs = [check_pair(&t, &u), check_pair(&t, &aabb), check_pair(&c, &u)];
        let more = [check_pair(&aabb, &c), check_pair(&c, &d), check_pair(&c, &c)];
        for pair in pairs.into_iter().chain(more) {
            seen = [0, 1, 2].each(|k: usize| seen[k] + pair[k]);
        }
    }
    seen
}

/// On small cores: the same least way as by all sums, or that the shapes are apart, the numbers of sums,
/// and few directions that half words leave.
#[cfg(feature = "fixed")]
#[test]
fn words_agree_with_sums() {
    use fixed::FixedI32;
    use fixed::types::extra::{U30, U32};
    use fixed::types::{I4F28, I8F8, I16F16, I32F0};

    let near = |x: f64| I16F16::from_num(x * 1000.0);
    let [contacts, left, _] = check_scalar(20, near, |x| I16F16::from_num(x));
    assert!(2 * left < 3 * contacts, "{left} in {contacts}");
    check_scalar(2, |x| I16F16::from_num(x), |x| I16F16::from_num(x));
    let far = |x: f64| I16F16::from_num(x * 32767.0);
    check_scalar(28, far, |x| I16F16::from_num(x));
    check_scalar(28, far, far);
    check_scalar(3, |x| I8F8::from_num(x), |x| I8F8::from_num(x));
    check_scalar(28, |x| I4F28::from_num(x * 7.5), |x| I4F28::from_num(x));
    let short = |x: f64| FixedI32::<U30>::from_num(x * 1.9);
    check_scalar(28, short, short);
    let least = |x: f64| FixedI32::<U32>::from_num(x * 0.49);
    check_scalar(28, least, least);
    let whole = |x: f64| I32F0::from_num(x * f64::from(i32::MAX));
    check_scalar(28, whole, |x| I32F0::from_num(x * 3.0));
    check_scalar(28, whole, whole);
    // The least numbers of a type next to its greatest.
    let ends = |x: f64| {
        let all = [I16F16::MIN, I16F16::MIN + I16F16::DELTA, I16F16::ZERO, I16F16::DELTA];
        *all.get(((x + 1.0) * 2.5) as usize).unwrap_or(&I16F16::MAX)
    };
    check_scalar(20, ends, |x| I16F16::from_num(x));
    check_scalar(20, ends, ends);
}

/// So do floats that words hold, which of usual sizes are most.
#[test]
fn floats_in_words_agree_with_sums() {
    let few = |x: f64| x as f32;
    fn power(x: f64, most: i32) -> f32 {
        (x * 2_f64.powi((x * 1e5) as i32 % most)) as f32
    }
    let shares = [
        check_scalar(3, few, few),
        check_scalar(24, few, few),
        check_scalar(28, |x| (x * 0.7) as f32, |x| (x * 0.7) as f32),
        check_scalar(28, |x| (100.0 + x * 0.7) as f32, |x| (x * 0.7) as f32),
        check_scalar(24, |x| (x * 1e6) as f32, few),
        check_scalar(24, |x| (x * 1e-30) as f32, |x| (x * 1e20) as f32),
        check_scalar(28, |x| power(x, 6), few),
        check_scalar(28, few, |x| power(x, 6)),
        check_scalar(28, |x| power(x, 20), |x| power(x, 3)),
    ];
    // Of 180 scenes.
    let held = shares.map(|[_, _, held]| held);
    assert!(held[..5].iter().all(|&held| held > 170), "{shares:?}");
    assert!(held[5..].iter().all(|&held| (10..90).contains(&held)), "{shares:?}");
    let [contacts, left, _] = shares[2];
    assert!(2 * left < 3 * contacts, "{shares:?}");
}
