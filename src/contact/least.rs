//! The minimum translation: the direction with the least overlap, and the numbers along it.

use core::cmp::Ordering;

use super::body::{Body, Rough, Vec64, cross, dot, in_floats};
use super::cut::{Cut, Rounded};
use super::directions::{Apart, Direction, all, sides_of_all};
use super::exact::{Exact, Given, Sums, length};
use super::filter::Filter;
use super::integers::{Long, Short, Words, has_words, is_whole};
use super::measures::{Directed, Lengths, Way, unit_of};
use super::mesh::InteriorEdges;
use super::on_axis::on_axis;
use super::settled::settled;
use super::wanted::{FACE, Wanted};
use super::whole::{Pair, Units, in_words};
use crate::arithmetic::{Each, REGISTERS_ARE_WIDE, pick, turn};
use crate::robust::{Stage, note};
use crate::scalar::Scalar;

/// The exact numbers of two shapes: integers, or sums of products for all other inputs.
#[derive(Clone, Copy)]
pub(super) enum Numbers<'a> {
    Short(&'a Pair<Short>),
    Long(&'a Pair<Long>),
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
        let numbers = direction.numbers(triangles);
        match self {
            Self::Short(pair) => Exact::new(&pair.along(numbers), triangles, own, known, wanted),
            Self::Long(pair) => Exact::new(&pair.along(numbers), triangles, own, known, wanted),
            Self::Sums => Exact::new(&Sums::new(bodies, own), triangles, own, known, wanted),
        }
    }
}

/// The least of the wanted translations in exact numbers.
fn exact<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    filter: &Filter<'_>,
    wanted: &Wanted,
    best: &mut (Way, Lengths),
) -> Result<bool, Apart> {
    let (short, long);
    // Small cores do without, for size.
    let units = if REGISTERS_ARE_WIDE { Units::new(bodies) } else { None };
    let numbers = match units {
        Some(units) if units.are_short => {
            short = units.pair(bodies);
            Numbers::Short(&short)
        }
        Some(units) => {
            long = units.pair(bodies);
            Numbers::Long(&long)
        }
        None => Numbers::Sums,
    };
    let along =
        |direction, wanted| numbers.along(bodies, direction, &filter.along(direction), wanted);
    least_of(wanted, &along, best)
}

/// The least translation of shapes that [`Words`] hold, and `None` of others; of all, or along the normal of the
/// first shape.
#[inline(never)]
pub(super) fn exact_in_words<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    is_normal: bool,
    best: &mut (Way, Lengths),
) -> Option<Result<bool, Apart>> {
    let mut pair = Pair::NONE;
    in_words(bodies, &mut pair).then(|| least_of_pair(bodies, &pair, is_normal, best))
}

fn least_of_pair<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    pair: &Pair<Words>,
    is_normal: bool,
    best: &mut (Way, Lengths),
) -> Result<bool, Apart> {
    let mut rounded = Rounded::NONE;
    let cut = Cut::new(pair, &mut rounded);
    let wanted = if is_normal { Wanted::FACE } else { Wanted::in_words(all(bodies), &cut)? };
    let along = |direction: Direction, wanted| {
        let (own, numbers) =
            (direction.sides(pair.are_triangles), direction.numbers(pair.are_triangles));
        let (given, known): (&dyn Given, _) = (&pair.along(numbers), cut.along(numbers));
        Exact::new(given, pair.are_triangles, own, &known, wanted)
    };
    least_of(&wanted, &along, best)
}

/// The least of the wanted translations, of equal depths the first. It is filled where it is: an assignment
/// of all would copy it. `false` if all directions are zero, `Err` if the shapes are apart or touch.
fn least_of(
    wanted: &Wanted,
    along: &dyn Fn(Direction, [bool; 2]) -> Option<Exact>,
    (way, lengths): &mut (Way, Lengths),
) -> Result<bool, Apart> {
    let mut is_found = false;
    for (direction, wanted) in wanted.iter() {
        note(Stage::Exact);
        let exact = along(direction, wanted);
        let Some(Exact { coordinates, along, overlaps }) = &exact else { continue };
        let Some((length, square)) = length(coordinates) else { continue };
        for is_along in [false, true] {
            if !wanted[usize::from(is_along)] {
                continue;
            }
            let overlap = overlaps[usize::from(is_along)].ok_or(Apart)?;
            let depth = overlap.over(length);
            if !is_found || depth.is_less_than(lengths.depth) {
                is_found = true;
                (way.direction, way.is_along, way.along) = (direction, is_along, *along);
                (lengths.overlap, lengths.length, lengths.square) = (overlap, length, square);
                (lengths.depth, lengths.coordinates) = (depth, *coordinates);
            }
        }
    }
    Ok(is_found)
}

/// The least way out by exact numbers, of the directions that floats leave.
#[cfg(test)]
pub(super) fn least_exact<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    rough: &[Rough; 2],
) -> Option<(Way, Lengths)> {
    let filter = Filter::new::<S>(rough);
    let wanted = Wanted::new(bodies, &filter).ok()?;
    let mut best = (Way::NONE, Lengths::NONE);
    exact(bodies, &filter, &wanted, &mut best).ok()?.then_some(best)
}

/// The least way out and its numbers, without a unit vector; `None` if a plane separates the shapes.
///
/// Floats select which of up to 30 ways may be the least, and nearly always know the numbers of a
/// single one. Exact numbers decide between several ways, and whether the shapes overlap at all.
pub(super) fn least_measures<S: Scalar>(bodies: &[Body<'_, S>; 2]) -> Option<Directed<S>> {
    let measured = |(way, lengths): &(Way, Lengths)| {
        let measures = lengths.measures(way.is_along);
        Directed { unit: [0.0; 3], depth: f64::INFINITY, measures, way: *way }
    };
    let mut best = (Way::NONE, Lengths::NONE);
    if let Some(is_found) = found_in_words(bodies, false, &mut best) {
        return is_found.then(|| measured(&best));
    }
    let rough = in_floats(bodies);
    least_in_floats(bodies, &rough, false, measured)
}

/// Whether words find a translation, if they hold the shapes.
#[inline(always)]
fn found_in_words<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    is_normal: bool,
    best: &mut (Way, Lengths),
) -> Option<bool> {
    if !has_words::<S>() {
        return None;
    }
    let is_found = exact_in_words(bodies, is_normal, best);
    // So that the rest is not linked.
    let is_found = if is_whole::<S>() { is_found.unwrap_or(Ok(false)) } else { is_found? };
    Some(is_found.unwrap_or(false))
}

/// The least way by floats, which have a unit vector if `has_unit`.
#[inline(always)]
fn least_in_floats<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    rough: &[Rough; 2],
    has_unit: bool,
    numbers: impl Fn(&(Way, Lengths)) -> Directed<S>,
) -> Option<Directed<S>> {
    let filter = Filter::new::<S>(rough);
    let wanted = Wanted::new(bodies, &filter).ok()?;
    from_floats(&filter, &wanted, bodies, has_unit).or_else(|| {
        let mut best = (Way::NONE, Lengths::NONE);
        exact(bodies, &filter, &wanted, &mut best).ok()?.then(|| numbers(&best))
    })
}

/// The way that floats leave and its numbers, if they are certain of all; with a unit vector if `has_unit`.
#[inline(always)]
fn from_floats<S: Scalar>(
    filter: &Filter<'_>,
    wanted: &Wanted,
    bodies: &[Body<'_, S>; 2],
    has_unit: bool,
) -> Option<Directed<S>> {
    // Small cores do without, for size.
    if !REGISTERS_ARE_WIDE {
        return None;
    }
    let (n, is_along) = wanted.single()?;
    // Without a branch for each kind of direction.
    let direction = (wanted.direction(n), sides_of_all(filter.ruler.are_triangles)[n % 16]);
    let axis = filter.axes.axis(direction.1);
    let known = axis.and_then(|axis| on_axis(filter, bodies, direction, axis, is_along));
    known.or_else(|| settled(filter, direction, is_along, has_unit.then_some(bodies)))
}

#[inline(never)]
fn directed<S: Scalar>((way, lengths): &(Way, Lengths)) -> Directed<S> {
    let ratios = lengths.ratios();
    let measures = lengths.measures_of(way.is_along, ratios);
    let unit = unit_of(&lengths.coordinates, way.is_along, ratios);
    let depth = if REGISTERS_ARE_WIDE { f64::INFINITY } else { lengths.depth_in_double::<S>() };
    Directed { unit, depth, measures, way: *way }
}

/// The same for contact points, and in a mesh. Its frame is free before the points. A scalar that
/// [`has_words`] needs floats only where they do not hold the shapes.
#[inline(never)]
pub(super) fn least_way<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    rough: Option<&[Rough; 2]>,
    interior: InteriorEdges,
) -> Option<Directed<S>> {
    let best = match rough {
        Some(rough) => least_in_floats(bodies, rough, true, directed),
        None => {
            let mut best = (Way::NONE, Lengths::NONE);
            match found_in_words(bodies, false, &mut best) {
                Some(is_found) => is_found.then(|| directed(&best)),
                None if has_words::<S>() => {
                    least_in_floats(bodies, &in_floats(bodies), true, directed)
                }
                None => None,
            }
        }
    };
    if interior == InteriorEdges::NONE {
        return best;
    }
    let best = best?;
    let is_across = match rough {
        Some([first, _]) => across(&best.way, &best.unit, &first.sides, interior),
        None => across(&best.way, &best.unit, &bodies[0].rough(&bodies[1], 1.0).sides, interior),
    };
    // If the whole triangle lies across, the direction is its normal, or it may have none.
    if !is_across.unwrap_or(best.way.direction != FACE) {
        return Some(best);
    }
    let mut normal = (Way::NONE, Lengths::NONE);
    let along_normal = |rough: &[Rough; 2], normal: &mut (Way, Lengths)| {
        exact(bodies, &Filter::new::<S>(rough), &Wanted::FACE, normal).unwrap_or(false)
    };
    let is_found = match (rough, found_in_words(bodies, true, &mut normal)) {
        (Some(rough), _) => along_normal(rough, &mut normal),
        (None, Some(is_found)) => is_found,
        (None, None) => along_normal(&in_floats(bodies), &mut normal),
    };
    let mut normal = is_found.then(|| directed(&normal))?;
    normal.way.is_held = true;
    Some(if is_across.is_none() { best } else { normal })
}

/// Whether the way out leads across an interior edge of the triangle, which is the first shape;
/// `None` if all its vertices are equally far along it.
fn across(way: &Way, unit: &Vec64, edges: &[Vec64; 3], interior: InteriorEdges) -> Option<bool> {
    let farthest = way.farthest(0);
    match farthest.iter().filter(|&&is| is).count() {
        3 => None,
        2 => Some((0..3).any(|k| farthest[k] && farthest[turn(k).1] && interior.contains(k))),
        _ => {
            let n = unit.each(|x| -x);
            let normal = cross(&edges[0], &edges[1]);
            let k = farthest.iter().position(|&is| is).unwrap_or(0);
            let outward = |k: usize| dot(&n, &cross(pick(edges, k), &normal)) >= 0.0;
            let (k, _, before) = turn(k);
            Some([k, before].into_iter().any(|k| interior.contains(k) && outward(k)))
        }
    }
}
