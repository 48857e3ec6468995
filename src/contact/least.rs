//! The minimum translation: the direction with the least overlap, and the numbers along it.

use core::cmp::Ordering;

use super::body::{Body, Rough, Vec64, cross, dot};
use super::cut::{Cut, Depth, Measured};
use super::directions::{Direction, all, sides_of_all};
use super::exact::{Exact, Given, farthest, length};
use super::filter::{Filter, Measure, Ruler};
use super::integers::{Half, Long, Short, Words};
use super::interior::InteriorEdges;
use super::lanes::Lanes;
use super::measures::{Lengths, Measures};
use super::settled::settled;
use super::sums::Sums;
use super::unit::unit;
use super::whole::{Shapes, Units, Whole, is_whole};
use crate::arithmetic::{OfFour, REGISTERS_ARE_WIDE, least as smaller, pick, turn, two};
use crate::robust::{Stage, note};
use crate::scalar::Scalar;

/// The exact numbers of two shapes: integers, or sums of products for all other inputs.
#[derive(Clone, Copy)]
pub(super) enum Numbers<'a> {
    Short(&'a Shapes<Short>),
    Long(&'a Shapes<Long>),
    Sums,
}

impl Numbers<'_> {
    /// The exact direction, if it is not zero. Some of the signs are known already.
    pub(super) fn along<S: Scalar>(
        self,
        bodies: &[Body<'_, S>; 2],
        direction: Direction,
        known: &[[Option<Ordering>; 3]; 2],
        wanted: [bool; 2],
    ) -> Option<Exact> {
        let triangles = [bodies[0].is_triangle(), bodies[1].is_triangle()];
        let own = direction.sides(triangles);
        match self {
            Self::Short(shapes) => {
                Exact::new(&Whole::new(shapes, own), triangles, own, known, wanted)
            }
            Self::Long(shapes) => {
                Exact::new(&Whole::new(shapes, own), triangles, own, known, wanted)
            }
            Self::Sums => Exact::new(&Sums::new(bodies, own), triangles, own, known, wanted),
        }
    }
}

/// A translation: its direction, and the signs along it.
pub(super) struct Way {
    pub(super) direction: Direction,
    /// Whether the first shape goes along the direction, or against it.
    pub(super) is_along: bool,
    /// The signs of the sides of the shapes along the direction.
    pub(super) along: [[Ordering; 3]; 2],
    pub(super) is_held: bool,
}

/// A plane separates the shapes.
pub(super) struct Apart;

/// Directions, and the translations that may be the least, as a bit for each direction: those against
/// it, and those along it.
struct Wanted {
    all: &'static [Direction],
    against: u16,
    along: u16,
}

/// The normal of the first shape, if it is a triangle.
const FACE: Direction = Direction::Face { is_second: false, k: 0 };

impl Wanted {
    /// Both translations along the normal of the first shape.
    const FACE: Self = Self { all: &[FACE], against: 1, along: 1 };

    /// The translations whose overlap may be the least, by floats; nearly always a single one.
    fn new<S: Scalar>(bodies: &[Body<'_, S>; 2], filter: &mut Filter<'_>) -> Result<Self, Apart> {
        let all = all(bodies);
        let mut needed = filter.needed(all);
        if !REGISTERS_ARE_WIDE {
            return Self::of_floats::<f64>(all, needed, &filter.ruler);
        }
        if needed > 15 {
            let short = two(|n| filter.ruler.shapes[n].short());
            let wanted =
                Self::of_floats::<<f32 as OfFour>::Quad>(all, needed, &Ruler::new(&short))?;
            if wanted.single().is_some() {
                return Ok(wanted);
            }
            needed = wanted.against | wanted.along;
        }
        Self::of_floats::<<f64 as OfFour>::Quad>(all, needed, &filter.ruler)
    }

    /// The same of the directions in `needed`, which are bits.
    #[inline(always)]
    fn of_floats<V: Lanes>(
        all: &'static [Direction],
        needed: u16,
        ruler: &Ruler<'_, V::Lane>,
    ) -> Result<Self, Apart> {
        let mut wanted = Self { all, against: 0, along: 0 };
        let (numbers, sides) = (numbers_of(needed), sides_of_all(ruler.are_triangles));
        let count = needed.count_ones() as usize;
        let infinity = V::same(V::Lane::INFINITY);
        let (mut least, mut bound) = (V::all([infinity; 2]), infinity);
        // As bits of these numbers, in their order.
        let mut unknown = 0;
        for (group, least) in least.as_mut().iter_mut().enumerate() {
            let begin = group * V::COUNT;
            if begin >= count {
                break;
            }
            let found = ruler.overlaps::<V>(|n| {
                let number = usize::from(numbers[(begin + n) % 16]);
                sides[number % 16]
            });
            if found.are_apart {
                return Err(Apart);
            }
            unknown |= found.unknown << begin;
            *least = found.least;
            bound = bound.least(found.most[0].least(found.most[1]));
        }
        let bound = (0..V::COUNT).map(|n| bound.lane(n)).fold(V::Lane::INFINITY, smaller);
        let may_be_least = |side: usize| {
            let mut left = unknown;
            for (group, least) in least.as_ref().iter().enumerate() {
                if group * V::COUNT >= count {
                    break;
                }
                left |= least[side].is_within(V::same(bound)) << (group * V::COUNT);
            }
            left &= (1 << count) - 1;
            let mut bits = 0;
            while left != 0 {
                bits |= 1 << numbers[left.trailing_zeros() as usize % 16];
                left &= left - 1;
            }
            bits
        };
        (wanted.against, wanted.along) = (may_be_least(0), may_be_least(1));
        Ok(wanted)
    }

    /// The translations whose overlap may be the least, by words; nearly always few. `cross` has the
    /// directions.
    #[inline(never)]
    fn in_words(
        all: &'static [Direction],
        cut: &Cut,
        cross: &dyn Fn(Direction) -> Option<[i32; 3]>,
    ) -> Result<Self, Apart> {
        let mut wanted = Self { all, against: 0, along: 0 };
        let needed = cut.needed(all);
        let mut measures: [Option<Measured>; 16] = [const { None }; 16];
        let mut bound: Option<Depth> = None;
        for (n, measured) in measures.iter_mut().enumerate() {
            if needed >> n & 1 == 0 {
                continue;
            }
            let Some(direction) = cross(wanted.direction(n)) else { continue };
            let here = cut.measured(&direction);
            if here.are_apart() {
                return Err(Apart);
            }
            let most = here.most();
            if bound.is_none_or(|bound| most.is_at_most(&bound)) {
                bound = Some(most);
            }
            *measured = Some(here);
        }
        for (n, measured) in measures.iter().enumerate() {
            if let (Some(measured), Some(bound)) = (measured, &bound) {
                let bit = |side| u16::from(measured.least(side).is_at_most(bound)) << n;
                wanted.against |= bit(false);
                wanted.along |= bit(true);
            }
        }
        Ok(wanted)
    }

    fn direction(&self, n: usize) -> Direction {
        self.all.get(n).copied().unwrap_or(FACE)
    }

    /// The directions with a translation that is wanted, in their order, and whether it is wanted
    /// against the direction, and along it.
    fn iter(&self) -> impl Iterator<Item = (Direction, [bool; 2])> {
        let mut left = self.against | self.along;
        core::iter::from_fn(move || {
            let n = left.trailing_zeros() as usize % 16;
            let wanted = [self.against, self.along].map(|bits| bits >> n & 1 == 1);
            let is_wanted = left != 0;
            left &= left.wrapping_sub(1);
            is_wanted.then(|| (self.direction(n), wanted))
        })
    }

    /// The translation that is wanted, if it is the only one.
    fn single(&self) -> Option<(Direction, bool)> {
        let all = self.against | self.along;
        let is_single = all.is_power_of_two() && self.against & self.along == 0;
        is_single.then(|| (self.direction(all.trailing_zeros() as usize % 16), self.along != 0))
    }
}

/// The numbers of these bits; what follows is any.
fn numbers_of(bits: u16) -> [u8; 16] {
    let mut numbers = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15];
    if bits & bits.wrapping_add(1) == 0 {
        return numbers;
    }
    let (mut left, mut last) = (bits, 0);
    for number in &mut numbers {
        last = if left == 0 { last } else { left.trailing_zeros() as u8 };
        left &= left.wrapping_sub(1);
        *number = last;
    }
    numbers
}

/// The least of the wanted translations in exact numbers.
fn exact<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    filter: &Filter<'_>,
    wanted: &Wanted,
) -> Result<Option<(Way, Lengths)>, Apart> {
    let (short, long);
    let numbers = match Units::new(bodies) {
        Some(units) if units.are_short => {
            short = units.shapes(bodies);
            Numbers::Short(&short)
        }
        Some(units) => {
            long = units.shapes(bodies);
            Numbers::Long(&long)
        }
        None => Numbers::Sums,
    };
    least_of(wanted, &|direction, wanted| {
        numbers.along(bodies, direction, &filter.along(direction), wanted)
    })
}

/// The least translation of a scalar that [`is_whole`]; of all, or along the normal of the first shape.
pub(super) fn exact_in_words<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    is_normal: bool,
) -> Result<Option<(Way, Lengths)>, Apart> {
    let (units, is_half) = Units::of_fixed(bodies);
    if is_half {
        least_in_words(bodies, &units.shapes::<Half, S>(bodies), is_normal)
    } else {
        least_in_words(bodies, &units.shapes::<Short, S>(bodies), is_normal)
    }
}

#[inline(never)]
fn least_in_words<N: Words, S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    shapes: &Shapes<N>,
    is_normal: bool,
) -> Result<Option<(Way, Lengths)>, Apart> {
    const NONE: [[Option<Ordering>; 3]; 2] = [[None; 3]; 2];
    let triangles = [bodies[0].is_triangle(), bodies[1].is_triangle()];
    let whole = |direction: Direction| Whole::new(shapes, direction.sides(triangles));
    let wanted = if is_normal {
        Wanted::FACE
    } else {
        let cut = Cut::new(shapes, triangles);
        Wanted::in_words(all(bodies), &cut, &|direction| whole(direction).cut())?
    };
    least_of(&wanted, &|direction, wanted| {
        let given: &dyn Given = &whole(direction);
        Exact::new(given, triangles, direction.sides(triangles), &NONE, wanted)
    })
}

/// The least of the wanted translations; of equal depths the first. `None` if all directions are zero,
/// `Err` if the shapes are apart or touch.
fn least_of(
    wanted: &Wanted,
    along: &dyn Fn(Direction, [bool; 2]) -> Option<Exact>,
) -> Result<Option<(Way, Lengths)>, Apart> {
    let mut best: Option<(Way, Lengths)> = None;
    for (direction, wanted) in wanted.iter() {
        note(Stage::Exact);
        let Some(exact) = along(direction, wanted) else { continue };
        let Some((length, square)) = length(&exact.coordinates) else { continue };
        let Exact { coordinates, along, overlaps } = exact;
        for is_along in [false, true] {
            if !wanted[usize::from(is_along)] {
                continue;
            }
            let overlap = overlaps[usize::from(is_along)].ok_or(Apart)?;
            let depth = overlap.over(length);
            if best.as_ref().is_none_or(|(_, best)| depth.is_less_than(best.depth)) {
                let way = Way { direction, is_along, along, is_held: false };
                best = Some((way, Lengths { overlap, length, square, depth, coordinates }));
            }
        }
    }
    Ok(best)
}

/// The least way out by exact numbers, of the directions that floats leave.
#[cfg(test)]
pub(super) fn least_exact<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    rough: &[Rough; 2],
) -> Option<(Way, Lengths)> {
    let mut filter = Filter::new::<S>(rough);
    let wanted = Wanted::new(bodies, &mut filter).ok()?;
    exact(bodies, &filter, &wanted).ok()?
}

/// The least way out and its numbers; `None` if a plane separates the shapes.
///
/// Floats select which of up to 30 ways may be the least, and nearly always know the numbers of a
/// single one. Exact numbers decide between several ways, and whether the shapes overlap at all.
pub(super) fn least_measures<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    rough: impl FnOnce() -> [Rough; 2],
) -> Option<(Way, Measures<S>)> {
    if is_whole::<S>() {
        let (way, lengths) = exact_in_words(bodies, false).ok()??;
        let measures = lengths.measures(way.is_along);
        return Some((way, measures));
    }
    let rough = rough();
    let mut filter = Filter::new::<S>(&rough);
    let wanted = Wanted::new(bodies, &mut filter).ok()?;
    if let Some((way, measures, _)) = from_floats(&filter, &wanted) {
        return Some((way, measures));
    }
    let (way, lengths) = exact(bodies, &filter, &wanted).ok()??;
    let measures = lengths.measures(way.is_along);
    Some((way, measures))
}

/// The way that floats leave and its numbers, if they are certain of all.
#[inline(always)]
fn from_floats<S: Scalar>(filter: &Filter<'_>, wanted: &Wanted) -> Option<(Way, Measures<S>, f64)> {
    // Small cores do without, for size.
    if !REGISTERS_ARE_WIDE {
        return None;
    }
    let (direction, is_along) = wanted.single()?;
    settled(filter, direction, is_along)
}

/// A way, its numbers, and the unit vector along which the first shape moves.
pub(super) type Directed<S> = (Way, Measures<S>, Vec64);

#[inline(never)]
fn directed<S: Scalar>((way, lengths): (Way, Lengths)) -> Directed<S> {
    let ratios = lengths.ratios();
    let measures = lengths.measures_of(way.is_along, ratios);
    let unit = lengths.unit_of(way.is_along, ratios);
    (way, measures, unit)
}

#[inline(always)]
fn least_directed<S: Scalar>(bodies: &[Body<'_, S>; 2], rough: &[Rough; 2]) -> Option<Directed<S>> {
    if is_whole::<S>() {
        return Some(directed(exact_in_words(bodies, false).ok()??));
    }
    let mut filter = Filter::new::<S>(rough);
    let wanted = Wanted::new(bodies, &mut filter).ok()?;
    let settled = from_floats(&filter, &wanted).and_then(|(way, measures, inverse)| {
        let unit = unit(bodies, way.direction, way.is_along, inverse)?;
        Some((way, measures, unit))
    });
    match settled {
        Some(best) => Some(best),
        None => Some(directed(exact(bodies, &filter, &wanted).ok()??)),
    }
}

/// The same for contact points, and in a mesh. Its frame is free before the points.
#[inline(never)]
pub(super) fn least_way<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    rough: &[Rough; 2],
    interior: InteriorEdges,
) -> Option<Directed<S>> {
    let best = least_directed(bodies, rough)?;
    if interior == InteriorEdges::NONE {
        return Some(best);
    }
    let is_across = across(&best.0, &best.2, &rough[0].sides, interior);
    // If the whole triangle lies across, the direction is its normal, or it may have none.
    if !is_across.unwrap_or(best.0.direction != FACE) {
        return Some(best);
    }
    let normal = if is_whole::<S>() {
        exact_in_words(bodies, true)
    } else {
        exact(bodies, &Filter::new::<S>(rough), &Wanted::FACE)
    };
    let (way, measures, unit) = directed(normal.ok()??);
    Some(if is_across.is_none() { best } else { (Way { is_held: true, ..way }, measures, unit) })
}

/// Whether the way out leads across an interior edge of the triangle, which is the first shape;
/// `None` if all its vertices are equally far along it.
fn across(way: &Way, unit: &Vec64, edges: &[Vec64; 3], interior: InteriorEdges) -> Option<bool> {
    let farthest = way.farthest(0);
    match farthest.iter().filter(|&&is| is).count() {
        3 => None,
        2 => Some((0..3).any(|k| farthest[k] && farthest[turn(k).1] && interior.contains(k))),
        _ => {
            let n = unit.map(|x| -x);
            let normal = cross(&edges[0], &edges[1]);
            let k = farthest.iter().position(|&is| is).unwrap_or(0);
            let outward = |k: usize| dot(&n, &cross(pick(edges, k), &normal)) >= 0.0;
            let (k, _, before) = turn(k);
            Some([k, before].into_iter().any(|k| interior.contains(k) && outward(k)))
        }
    }
}

impl Way {
    /// The side on which the opposite shape lies along the direction.
    pub(super) fn toward(&self, shape: usize) -> Ordering {
        if self.is_along == (shape == 0) { Ordering::Less } else { Ordering::Greater }
    }

    /// The vertices of a triangle that lie farthest toward the opposite shape.
    pub(super) fn farthest(&self, shape: usize) -> [bool; 3] {
        farthest(&self.along[shape % 2], self.toward(shape))
    }
}
