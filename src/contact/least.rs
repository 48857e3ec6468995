//! The minimum translation: the direction with the least overlap, and the numbers along it.

use core::cmp::Ordering;

use super::body::{Body, Rough, Vec64};
use super::directions::{Direction, Filter, Finding, all, cross, dot};
use super::exact::{Exact, Size, farthest};
use super::interior::InteriorEdges;
use super::sums::Sums;
use super::whole::{Long, Shapes, Short, Units, Whole};
use crate::arithmetic::{Soft, pick, three, turn};
use crate::robust::{Stage, note};
use crate::scalar::Scalar;
use crate::shape::Vec3;

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

/// The translation along one direction.
pub(super) struct Way {
    pub(super) direction: Direction,
    /// Whether the first shape goes along the direction, or against it.
    pub(super) is_along: bool,
    /// The overlap, in units of the direction's length.
    overlap: Soft,
    length: Soft,
    square: Soft,
    /// The overlap as a length.
    pub(super) depth: Soft,
    coordinates: [Option<(Ordering, Soft)>; 3],
    /// The signs of the sides of the shapes along the direction.
    pub(super) along: [[Ordering; 3]; 2],
    pub(super) is_held: bool,
}

/// A plane separates the shapes.
struct Apart;

/// Updates the best way with one or both ways along a direction; of equal depths the first stays.
/// `Err` if the shapes are apart or touch.
fn least<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    numbers: Numbers<'_>,
    filter: &Filter<'_>,
    direction: Direction,
    wanted: [bool; 2],
    best: &mut Option<Way>,
) -> Result<(), Apart> {
    note(Stage::Exact);
    let known = filter.along(direction);
    let Some(exact) = numbers.along(bodies, direction, &known, wanted) else {
        return Ok(());
    };
    let Some((length, square)) = exact.length() else { return Ok(()) };
    let Exact { coordinates, along, overlaps } = exact;
    for is_along in [false, true] {
        if !wanted[usize::from(is_along)] {
            continue;
        }
        let overlap = overlaps[usize::from(is_along)].ok_or(Apart)?;
        let depth = overlap.over(length);
        if best.as_ref().is_none_or(|best| depth.is_less_than(best.depth)) {
            let is_held = false;
            *best = Some(Way {
                direction,
                is_along,
                overlap,
                length,
                square,
                depth,
                coordinates,
                along,
                is_held,
            });
        }
    }
    Ok(())
}

/// The least way out; `None` if a plane separates the shapes.
///
/// Floats select which of up to 30 ways may be the least, nearly always a single one. Exact numbers
/// decide between the selected ways, and whether the shapes overlap at all.
pub(super) fn least_way<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    rough: &[Rough; 2],
    interior: InteriorEdges,
) -> Option<Way> {
    let mut filter = Filter::new::<S>(rough);
    let mut found = [None; 15];
    let mut bound = f64::INFINITY;
    for (found, direction) in found.iter_mut().zip(all(bodies)) {
        match filter.finding(direction) {
            Finding::Apart => return None,
            Finding::Nothing => {}
            Finding::Overlaps(overlaps) => {
                for overlap in overlaps {
                    bound = if overlap.most < bound { overlap.most } else { bound };
                }
                *found = Some((direction, overlaps));
            }
        }
    }
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
    let mut best: Option<Way> = None;
    for (direction, overlaps) in found.into_iter().flatten() {
        let wanted = [overlaps[0].least <= bound, overlaps[1].least <= bound];
        if wanted == [false; 2] {
            continue;
        }
        least(bodies, numbers, &filter, direction, wanted, &mut best).ok()?;
    }
    let best = best?;
    if interior == InteriorEdges::NONE {
        return Some(best);
    }
    let face = Direction::Face { is_second: false, k: 0 };
    let is_held = match across(&best, &rough[0].sides, interior) {
        Some(is_held) => is_held,
        // The whole triangle lies across: the direction is its normal, or the triangle has none.
        None => {
            let none = [[None; 3]; 2];
            best.direction != face && numbers.along(bodies, face, &none, [false; 2]).is_none()
        }
    };
    if !is_held {
        return Some(best);
    }
    let mut held = None;
    least(bodies, numbers, &filter, face, [true; 2], &mut held).ok()?;
    held.map(|way| Way { is_held: true, ..way })
}

/// Whether the way out leads across an interior edge of the triangle, which is the first shape;
/// `None` if all its vertices are equally far along it.
fn across(way: &Way, edges: &[Vec64; 3], interior: InteriorEdges) -> Option<bool> {
    let farthest = way.farthest(0);
    match farthest.iter().filter(|&&is| is).count() {
        3 => None,
        2 => Some((0..3).any(|k| farthest[k] && farthest[turn(k).1] && interior.contains(k))),
        _ => {
            let n = way.unit(&way.ratios()).map(|x| -x);
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

    /// The sizes of the coordinates of the unit vector along which the first shape moves.
    pub(super) fn ratios(&self) -> [Size; 3] {
        three(|i| self.coordinates[i].map(|(_, size)| size.over(self.length)))
    }

    /// The unit vector, before it is rounded.
    pub(super) fn unit(&self, ratios: &[Size; 3]) -> Vec64 {
        three(|i| match (self.coordinates[i], ratios[i]) {
            (Some((sign, _)), Some(ratio)) => {
                let x = ratio.in_double();
                if sign.is_gt() == self.is_along { x } else { -x }
            }
            _ => 0.0,
        })
    }

    /// A vector along the way, from the sizes of its coordinates in real units, and whether the
    /// scalar can hold it.
    fn vector<S: Scalar>(&self, units: i32, is_up: bool, sizes: [Size; 3]) -> (Vec3<S>, bool) {
        let mut fits = true;
        let [x, y, z] = three(|i| match (self.coordinates[i], sizes[i]) {
            (Some((sign, _)), Some(size)) => {
                let (m, exponent) = size.scaled(units).upper();
                let is_negative = sign.is_gt() != self.is_along;
                let (x, is_held) = S::of_units(m, exponent, is_up, is_negative);
                fits &= is_held;
                x
            }
            _ => S::ZERO,
        });
        (Vec3::new(x, y, z), fits)
    }

    /// The translation, with each coordinate rounded away from zero, so that it is never too short.
    ///
    /// With a the direction and o the overlap along it, |tᵢ| ≥ |aᵢ|·o/(a·a), and tᵢ has the sign of
    /// aᵢ. Therefore a·t = Σ|aᵢ|·|tᵢ| ≥ o, and the shapes no longer overlap along this direction.
    pub(super) fn translation<S: Scalar>(&self) -> (Vec3<S>, bool) {
        let is_single = self.coordinates.iter().flatten().count() == 1;
        let of = |size: Soft| {
            if is_single { self.depth } else { size.times(self.overlap).over(self.square) }
        };
        let sizes = three(|i| self.coordinates[i].map(|(_, size)| of(size)));
        self.vector(-i32::from(S::ONE.shift), true, sizes)
    }

    pub(super) fn normal<S: Scalar>(&self, ratios: [Size; 3]) -> Vec3<S> {
        self.vector(i32::from(S::ONE.shift), false, ratios).0
    }

    pub(super) fn depth<S: Scalar>(&self) -> S {
        let (m, exponent) = self.depth.scaled(-i32::from(S::ONE.shift)).upper();
        S::of_units(m, exponent, true, false).0
    }
}
