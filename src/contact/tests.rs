//! Floats exclude only directions that are not the least, and integers equal the sums. What floats
//! know has the bits of exact numbers.

use std::format;

use super::body::{Body, Flat, Rough, Round, in_floats};
use super::cut::{Cut, Rounded};
use super::directions::{Direction, all};
use super::exact::{Exact, Given, Size, length};
use super::integers::has_words;
use super::least::{Numbers, exact_in_words, least_exact, least_way};
use super::measures::{Directed, Lengths, Measures, Way};
use super::mesh::InteriorEdges;
use super::solid::Solid;
use super::view::View;
use super::wanted::Wanted;
use super::whole::{Pair, Units, in_words};
use super::{Shape, round};
use crate::arithmetic::{Each, REGISTERS_ARE_WIDE, greatest, root};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Obb, Triangle, Vec3};

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

/// How many of these contacts floats know, and how many they leave in doubt. What they know has the
/// bits of exact numbers.
fn known<S: Scalar>(flat: Flat<'_, S>, ends: [[S; 3]; 2], radius: S) -> [usize; 2] {
    let (round, mut seen) = (Round { ends: ends.each(Vec3::from), radius }, [0; 2]);
    for bits in 0..16 {
        let bits = if let Flat::Aabb(_) = flat { bits & 1 } else { bits };
        let interior = InteriorEdges::new([1, 2, 4].each(|bit| bits & (bit * 2) != 0));
        let found = round::in_floats(flat, &round, bits % 2 == 1, interior);
        seen[usize::from(found.is_none())] += 1;
        if let Some(found) = found {
            let exact = round::exactly(flat, &round, bits % 2 == 1, interior);
            // Zeros have signs.
            assert_eq!(
                format!("{found:?}"),
                format!("{exact:?}"),
                "{flat:?} {round:?} {interior:?}"
            );
        }
    }
    seen
}

/// Spheres and capsules near triangles and boxes. Each number is drawn by `of`, and radii are larger
/// than the distance or next to it.
fn known_of<S: Scalar>(mut of: impl FnMut(&mut Draw) -> S, ulp: f64) -> [usize; 2] {
    let (mut draw, mut seen) = (Draw(11), [0; 2]);
    for n in 0..3000 {
        let [a, b, c, p, q] = [(); 5].map(|()| [(); 3].each(|()| of(&mut draw)));
        let triangle = Triangle::new(a, b, c).unwrap();
        let order = |i: usize| if a[i] < b[i] { [a[i], b[i]] } else { [b[i], a[i]] };
        let [low, high] = [0, 1].each(|end| [0, 1, 2].each(|i| order(i)[end]));
        let half = q.each(|x| if x < S::ZERO { S::ZERO } else { x });
        let aabb = match n % 4 {
            1 => Aabb::from_min_max(low, high).unwrap(),
            _ => Aabb::from_center_half_extents(a, half).unwrap(),
        };
        let (flat, point) = if n % 4 < 2 {
            (Flat::Aabb(&aabb), aabb.closest_point(p).unwrap())
        } else {
            (Flat::Triangle(&triangle), triangle.closest_point(p).unwrap().point)
        };
        let square = |x: f64| x * x;
        let [x, y, z] =
            [0, 1, 2].each(|i: usize| square(p[i].beyond_in_double(point.to_array()[i])));
        let distance = root(x + y + z + f64::MIN_POSITIVE);
        let more = [ulp, -ulp, 0.125, 0.5][n % 7 % 4];
        let radius = S::ZERO.plus_double(distance * (1.0 + more));
        if distance < 1e30 && !(S::ZERO..=S::ZERO).contains(&radius) {
            let known = known(flat, [p, if n % 3 == 0 { q } else { p }], radius);
            seen = [seen[0] + known[0], seen[1] + known[1]];
        }
    }
    seen
}

/// Floats know most contacts of spheres, and about each what exact numbers know.
#[test]
fn contacts_of_spheres_in_floats_have_the_bits_of_exact_numbers() {
    if !REGISTERS_ARE_WIDE {
        return;
    }
    let ulp = 2_f64.powi(-24);
    let mut seen = [[0; 2]; 4];
    seen[0] = known_of::<f32>(|draw| draw.number(24) as f32, ulp);
    // On a grid, slivers far from the origin, and of any size.
    seen[1] = known_of::<f32>(|draw| draw.number(2) as f32, ulp);
    seen[2] = known_of::<f32>(|draw| (draw.number(3) + draw.number(24) * 1e-6 + 9.0) as f32, ulp);
    let power = |draw: &mut Draw| 2_f64.powi((draw.number(20) * 120.0) as i32);
    seen[3] = known_of::<f32>(|draw| (draw.number(24) * power(draw)) as f32, ulp);
    #[cfg(feature = "fixed")]
    {
        use fixed::types::{I4F28, I8F8, I16F16};
        known_of::<I16F16>(|draw| I16F16::from_num(draw.number(20)), ulp);
        known_of::<I4F28>(|draw| I4F28::from_num(draw.number(28)), ulp);
        known_of::<I8F8>(|draw| I8F8::from_num(draw.number(8) * 60.0), ulp);
    }
    let least = [20_000, 15_000, 18_000, 6_000];
    assert!((0..4).all(|k| seen[k][0] > least[k]), "{seen:?}");
}

/// Capsules along a level floor, an end a little above the other or none: of how many floats know the
/// contact, of those that lie level above it, and whose ends are not over its edges.
fn known_along_a_floor<S: Scalar>(of: fn(f64) -> S) -> [usize; 2] {
    let (mut draw, mut seen) = (Draw(7), [0; 2]);
    for n in 0..400 {
        let (axis, width, rise) = (n % 3, [0.4, 2.0][n / 3 % 2], [0.0, 0.0, 1.0, -1.0][n / 6 % 4]);
        let at = |p: [f64; 3]| [0, 1, 2].each(|i: usize| of(p[(i + 3 - axis) % 3]));
        let mut end = |z: f64| at([z, draw.number(4) * width, draw.number(5) * width]);
        let ends = [end(0.5), end(0.5 + rise / 256.0)];
        let floor = [[0.25, -1.0, -1.0], [0.25, 2.0, -1.0], [0.25, -1.0, 2.0]].map(at);
        let triangle = Triangle::new(floor[0], floor[1], floor[2]).unwrap();
        let low = at([-1.0; 3]);
        let aabb = Aabb::from_min_max(low, at([0.25, 1.0, 1.0])).unwrap();
        for flat in [Flat::Triangle(&triangle), Flat::Aabb(&aabb)] {
            let [floats, _] = known(flat, ends, of(0.375));
            if rise == 0.0 && width < 1.0 {
                seen = [seen[0] + floats, seen[1] + 16];
            }
        }
    }
    seen
}

/// Of ends as near to a floor the first counts, and else the nearer one.
#[test]
fn capsules_along_a_floor_in_floats_have_the_bits_of_exact_numbers() {
    if !REGISTERS_ARE_WIDE {
        return;
    }
    let known = known_along_a_floor::<f32>(|x| x as f32);
    assert_eq!(known[0], known[1]);
    #[cfg(feature = "fixed")]
    {
        use fixed::types::{I4F28, I8F8, I16F16};
        for known in [
            known_along_a_floor::<I16F16>(I16F16::from_num),
            known_along_a_floor::<I4F28>(I4F28::from_num),
            known_along_a_floor::<I8F8>(I8F8::from_num),
        ] {
            assert_eq!(known[0], known[1]);
        }
    }
}
