//! Floats exclude only directions that are not the least, and integers equal the sums. What floats
//! know has the bits of exact numbers.

mod round;
mod words;

use super::Shape;
use super::body::{Body, Rough, in_floats};
use super::directions::{Direction, all};
use super::exact::{Size, length};
use super::integers::has_words;
use super::least::{Numbers, least_exact, least_way};
use super::measures::{Directed, Lengths, Measures, Way};
use super::mesh::InteriorEdges;
use super::solid::Solid;
use super::view::View;
use super::whole::Units;
use crate::arithmetic::{Each, REGISTERS_ARE_WIDE, greatest};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Obb, Triangle};

extern crate std;

/// Numbers from −1 to 1, in steps of 2^-bits.
pub(super) struct Draw(pub(super) u64);

impl Draw {
    fn number(&mut self, bits: u32) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let whole = (self.0 >> 33) % (2 << bits);
        (whole as f64) / f64::from(1 << bits) - 1.0
    }

    pub(super) fn point<S: Copy>(&mut self, bits: u32, of: fn(f64) -> S) -> [S; 3] {
        [(); 3].each(|()| of(self.number(bits)))
    }

    pub(super) fn half<S: Copy>(&mut self, bits: u32, of: fn(f64) -> S) -> [S; 3] {
        [(); 3].each(|()| of(self.number(bits).abs()))
    }
}

const NOTHING_IS_KNOWN: [[Option<core::cmp::Ordering>; 3]; 2] = [[None; 3]; 2];

/// The least way from exact sums alone: its direction, whether it goes along it, and its depth.
fn by_sums<S: Scalar>(bodies: &[Body<'_, S>; 2]) -> Option<(Direction, bool, Size)> {
    let mut best: Option<(Direction, bool, Size)> = None;
    for &direction in all(bodies) {
        let exact = Numbers::Sums.along(bodies, direction, &NOTHING_IS_KNOWN, [true; 2]);
        let Some(exact) = exact else { continue };
        let (length, _) = length(&exact.coordinates).unwrap();
        for is_along in [false, true] {
            let depth = exact.overlaps[usize::from(is_along)]?.over(length);
            let is_less = |(_, _, best): (_, _, Size)| depth.is_less_than(best.unwrap());
            if best.is_none_or(is_less) {
                best = Some((direction, is_along, Some(depth)));
            }
        }
    }
    best
}

/// The numbers from floats, if they are certain, are those from exact numbers.
fn assert_is_settled_as_exact<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    rough: &[Rough; 2],
    exact: Option<(Way, Lengths)>,
) {
    let least = least_way(bodies, (!has_words::<S>()).then_some(rough), InteriorEdges::NONE);
    assert_eq!(least.is_some(), exact.is_some(), "{bodies:?}");
    if let (Some(found), Some((exact_way, lengths))) = (least, exact) {
        let Directed { unit, measures: found, way, .. } = found;
        let exact: Measures<S> = lengths.measures(way.is_along);
        assert_eq!((way.direction, way.along), (exact_way.direction, exact_way.along));
        assert_eq!((found, unit), (exact, lengths.unit(way.is_along)), "{bodies:?}");
    }
}

/// The exact depth in floats is the overlap, within a third of the tolerance of points.
fn assert_depth_is_overlap<S: Scalar>(rough: &[Rough; 2], (way, lengths): &(Way, Lengths)) {
    let [first, second] = [Solid::new(&rough[0]), Solid::new(&rough[1])];
    let size = greatest(first.size, second.size);
    if S::FLOAT.is_some() && !(1e-100..1e100).contains(&size) {
        return;
    }
    let unit = lengths.unit(way.is_along);
    let overlap = first.reach_along(&unit.each(|x| -x)) + second.reach_along(&unit);
    let off = (overlap - lengths.depth_in_double::<S>()).abs();
    assert!(off < View::new(&unit, size, None).tolerance / 3.0, "{off} {overlap}");
}

/// Whether there is a contact, and whether 60 bits hold the shapes, or 250.
pub(super) fn check<S: Scalar>(first: &impl Shape<S>, second: &impl Shape<S>) -> [bool; 3] {
    let bodies = [first.body(), second.body()];
    let rough = in_floats(&bodies);
    let least = least_exact(&bodies, &rough);
    let found = least.as_ref().map(|(way, l)| (way.direction, way.is_along, Some(l.depth)));
    assert_eq!(found, by_sums(&bodies), "{bodies:?}");
    if let Some(least) = &least {
        assert_depth_is_overlap::<S>(&rough, least);
    }
    assert_is_settled_as_exact(&bodies, &rough, least);
    let units = Units::new(&bodies).filter(|_| REGISTERS_ARE_WIDE);
    let is_short = units.as_ref().is_some_and(|units| units.are_short);
    if let Some(units) = &units {
        // What 60 bits hold, 250 bits hold as well.
        let (long, short) = (units.pair(&bodies), is_short.then(|| units.pair(&bodies)));
        let numbers = [Some(Numbers::Long(&long)), short.as_ref().map(Numbers::Short)];
        for (direction, numbers) in all(&bodies).iter().flat_map(|&d| numbers.each(|n| (d, n))) {
            let exact = |n: Numbers<'_>| n.along(&bodies, direction, &NOTHING_IS_KNOWN, [true; 2]);
            if let Some(numbers) = numbers {
                assert_eq!(exact(numbers), exact(Numbers::Sums), "{direction:?} {bodies:?}");
            }
        }
    }
    [found.is_some(), is_short, units.is_some()]
}

/// All pairs, with numbers that come from numbers of so many bits.
fn check_all<S: Scalar>(bits: u32, of: fn(f64) -> S, axis: fn(f64) -> S) -> [usize; 4] {
    let (mut draw, mut seen) = (Draw(7 + u64::from(bits)), [0; 4]);
    for _ in 0..12 {
        let mut triangle = || {
            let [a, b, c] = [(); 3].each(|()| draw.point(bits, of));
            Triangle::new(a, b, c).unwrap()
        };
        let (t, u) = (triangle(), triangle());
        let [a, b] = [(); 2].each(|()| {
            Aabb::from_center_half_extents(draw.point(bits, of), draw.half(bits, of)).unwrap()
        });
        let [c, d] = [(); 2].each(|()| {
            let axes = [(); 3].each(|()| draw.point(bits, axis));
            Obb::from_skewed_axes(draw.point(bits, of), axes, draw.half(bits, of)).unwrap()
        });
        let all = [check(&t, &u), check(&t, &a), check(&c, &u), check(&a, &b), check(&b, &c)];
        for [is_contact, is_short, is_whole] in all.into_iter().chain([check(&c, &d)]) {
            seen[0] += usize::from(is_contact);
            seen[1] += usize::from(!is_contact);
            seen[2] += usize::from(is_short);
            seen[3] += usize::from(is_whole);
        }
    }
    assert!(seen[0] > 9 && seen[1] > 9, "{seen:?}");
    seen
}

#[test]
fn all_ways_agree() {
    let few = |x: f64| x as f32;
    let short = [check_all::<f32>(3, few, few), check_all(24, few, few)];
    let long = [check_all::<f64>(3, |x| x, |x| x), check_all(30, |x| x / 3.0, |x| x * 0.7)];
    let wholes = [short, long].each(|seen| seen.each(|[.., short, _]| short));
    if REGISTERS_ARE_WIDE {
        assert!(wholes.as_flattened().iter().all(|&whole| whole > 30), "{wholes:?}");
    }
    // Places far finer than axes, and numbers that 60 bits seldom hold.
    check_all::<f64>(24, |x| x / 3.0 * 2_f64.powi(-90), |x| x);
    let any = check_all::<f64>(20, |x| x * x * x * x * x / 7.0, |x| x * x * x * x / 3.0);
    assert!(any[2] < 60, "{any:?}");
}

/// A side so short that its products underflow, with a half-extent that makes it as long as others.
#[test]
fn tiny_sides_are_left_to_exact_numbers() {
    let (mut draw, mut contacts) = (Draw(3), 0);
    let short = 2_f64.powi(-40);
    let half = [0.25 / short, 0.25 / short, 1.0 / f64::MIN_POSITIVE];
    for n in 0..60 {
        let mut axes = [(); 3].each(|()| draw.point(30, |x| x * 0.7).each(|x| x * short));
        axes[2] = draw.point(4, |x| x * f64::MIN_POSITIVE);
        let obb = Obb::from_skewed_axes([0.0; 3], axes, half).unwrap();
        let reach = axes[2].each(|x| x * half[2]);
        let near = |p: [f64; 3]| {
            [0, 1, 2].each(|i: usize| p[i] + reach[i] * (1.0 + 0.01 * f64::from(n % 7)))
        };
        let [a, b, c] = [(); 3].each(|()| near(draw.point(20, |x| x * 0.2)));
        let t = Triangle::new(a, b, c).unwrap();
        contacts += usize::from(check(&t, &obb)[0]);
    }
    assert!(contacts > 5 && contacts < 55, "{contacts}");
}
