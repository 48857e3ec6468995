//! The contact of a sphere or a capsule with a shape that its centre, or an end of its segment, is
//! apart from, and of a sphere within a box: in floats, on hosts. Each number is known within a
//! bound, and counts if all numbers within the bound round to one number of the scalar.
//!
//! A point of the flat shape and an end of the segment are nearest to each other if each is nearest to
//! the other: a local minimum is the global one.

use core::mem::size_of;

use super::answer::Part;
use super::body::{Flat, Round, dot};
use super::line::{Line, less, roundoffs};
use super::mesh::InteriorEdges;
use super::settled::{Known, is_single};
use crate::arithmetic::{Each, REGISTERS_ARE_WIDE, exp2, largest, root_of_machine, three};
use crate::scalar::Scalar;
use crate::shape::Vec3;

/// Roundoffs of a length, beside those of its coordinates; and of a quotient by it.
const LENGTH: u16 = 8;

/// A depth that may be off by more, of itself, is computed to more digits.
const CLEAR: f64 = exp2(-42);

/// The contact of a sphere around the end of a line.
fn known<S: Scalar>(line: &Line<S>, flat: Flat<'_, S>, to: &[S; 3], radius: f64) -> Known {
    let (a, errors, is_single) = (line.a, line.errors, is_single(&line.a));
    let length = if is_single { largest(&a) } else { root_of_machine(dot(&a, &a)) };
    let inverse = 1.0 / length;
    let of_length = (errors[0] + errors[1] + errors[2]) * inverse + roundoffs(LENGTH);
    let of_coordinates =
        three(|i| if errors[i] > 0.0 { errors[i] / a[i].abs() + of_length } else { 0.0 });
    let exact = if is_single { line.exact_depth(flat, to, radius) } else { None };
    let (depth, of_depth) = exact.map_or_else(
        || {
            let [distance, error] =
                line.height.map_or([length, 0.0], |height| height.each(|x| x * inverse));
            let (depth, error) = (radius - distance, error + distance.abs() * of_length);
            if error <= CLEAR * depth || distance < 0.0 {
                return (depth, error / depth);
            }
            let ([gap, of_gap, third], sum) = (line.gap(flat, to, radius), radius + distance);
            (gap / (third * sum), of_gap / gap + error / sum)
        },
        |depth| (depth, 0.0),
    );
    Known { a, of_coordinates, is_single, inverse, depth: depth * S::UNIT, of_depth }
}

/// A contact from the outside.
pub(super) struct Apart<S> {
    pub(super) known: Known,
    pub(super) parts: [Part; 2],
    point: [S; 3],
}

/// The contact, if one end of the segment is certainly nearer than the rest of it, or as near above a face,
/// and certainly apart from the flat shape.
///
/// # The error
///
/// If a vector is off by δ, its length is off by |δ|, which is at most the sum of its coordinates'
/// errors. Its square has 3 roundings, its root two more, and a quotient by it up to three:
/// [`LENGTH`]. r − d is off by as much as d; and (r² − d²)/(r + d) by that part of r + d, and by the
/// error of the first factor.
///
/// The numbers are rounded as in [`settled`](super::settled), with the error of the length in that of
/// each coordinate. The 24 roundoffs that `settled.g` has for the length leave room for the five of a
/// depth.
pub(super) fn apart<S: Scalar>(flat: Flat<'_, S>, round: &Round<S>) -> Option<Apart<S>> {
    // Floats of 53 digits do not round to as many.
    if !REGISTERS_ARE_WIDE || size_of::<S>() >= size_of::<f64>() {
        return None;
    }
    let ends = round.ends.each(Vec3::to_array);
    let is_sphere = ends[0] == ends[1];
    for (end, to) in ends.iter().enumerate().take(if is_sphere { 1 } else { 2 }) {
        let line = match flat {
            Flat::Triangle(triangle) => Line::of_triangle(triangle, to),
            Flat::Aabb(aabb) => Line::of_box(aabb, to),
        };
        let is_nearest = |line: &Line<S>| {
            let is_out = line.height.is_none_or(|[height, _]| height > 0.0);
            let way = less(to, &ends[1 - end]);
            // In exact numbers the first end of a level segment comes before the second.
            is_sphere || is_out && (line.is_behind(&way) || end == 0 && line.is_level(&way))
        };
        if let Some(line) = line.filter(is_nearest) {
            let known = known(&line, flat, to, round.radius.units());
            return Some(Apart {
                known,
                parts: [line.part, Part::Vertex(end as u8)],
                point: line.point,
            });
        }
    }
    None
}

impl<S: Scalar> Apart<S> {
    /// Whether the way leads across an interior edge of a triangle, if that is certain.
    pub(super) fn leads_across(&self, interior: InteriorEdges) -> Option<bool> {
        match self.parts[0] {
            Part::Edge(k) => Some(interior.contains(k.into())),
            Part::Vertex(_) if interior != InteriorEdges::NONE => None,
            Part::Vertex(_) | Part::Face(_) => Some(false),
        }
    }

    /// The nearest point, the deepest point of the round shape, and how far apart they are, if each
    /// number rounds to one of the scalar.
    pub(super) fn points(&self) -> Option<([Vec3<S>; 2], S)> {
        let plus = |x: S, (offset, error): (f64, f64)| {
            let [low, high] = [offset - offset * error, offset + offset * error];
            let rounded = x.plus_double(low);
            // The sign of a zero is in doubt.
            let is_clear = rounded != S::ZERO || x == S::ZERO;
            (is_clear && rounded == x.plus_double(high)).then_some(rounded)
        };
        let (mut on_round, a) = (self.point, &self.known.a);
        for (i, x) in on_round.iter_mut().enumerate().filter(|(i, _)| a[*i] != 0.0) {
            let [_, (size, error)] = self.known.coordinate(i);
            *x = plus(*x, (if a[i] > 0.0 { -size } else { size }, error))?;
        }
        let depth = plus(S::ZERO, self.known.depth())?;
        Some(([self.point.into(), on_round.into()], depth))
    }
}
