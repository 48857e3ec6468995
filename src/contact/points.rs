//! Contact points: where shapes touch after the least translation.

use super::answer::{Features, MOST, Part, Point, Points};
use super::body::{Body, Place, Rough, Vec64, difference_in_double, dot, flipped, minus, scaled};
use super::clip::clip;
use super::directions::Direction;
use super::faces::{Face, ones};
use super::measures::{Directed, Way};
use super::sides::Unit;
use super::solid::{Solid, edge_of_box};
use super::view::{Edge, Pair, Pairs, View, distance};
use crate::arithmetic::{Each, exp2, greatest, out_of_line, part, three, two};
use crate::scalar::Scalar;
use crate::shape::Vec3;

/// Three answers as bits.
#[inline(always)]
fn bits(is: impl Fn(usize) -> bool) -> u8 {
    u8::from(is(0)) | u8::from(is(1)) << 1 | u8::from(is(2)) << 2
}

/// The axes on which the shape's upper end is nearer to the opposite shape than its lower end, as bits; also
/// those perpendicular to the direction.
fn upper(way: &Way, shape: usize) -> u8 {
    let away = way.toward(shape).reverse();
    bits(|k| way.along[shape % 2][k] != away)
}

/// The faces or edges that the direction of a translation comes from.
pub(super) fn features<S: Scalar>(bodies: &[Body<'_, S>; 2], way: &Way) -> Features {
    let face = |shape: usize, k: u8| {
        let is_triangle = bodies[shape % 2].is_triangle();
        if is_triangle { 0 } else { 2 * k + (upper(way, shape) >> k & 1) }
    };
    let edge = |shape: usize, k: u8| {
        let is_triangle = bodies[shape % 2].is_triangle();
        if is_triangle { k } else { edge_of_box(k, upper(way, shape)) }
    };
    match way.direction {
        Direction::Face { is_second: false, k } => Features::First(face(0, k)),
        Direction::Face { is_second: true, k } => Features::Second(face(1, k)),
        Direction::Sides(i, j) => Features::Edges(edge(0, i), edge(1, j)),
    }
}

/// Shapes outside of these sizes are scaled, so that fourth powers of lengths stay within range.
const RANGE: (f64, f64) = (exp2(-400), exp2(400));
const UP: f64 = exp2(800);
const DOWN: f64 = exp2(-600);

/// The contact points of a translation.
// Inlined on a small core, its frame would be there while the way is sought.
#[cfg_attr(not(target_pointer_width = "64"), inline(never))]
pub(super) fn points<S: Scalar>(
    bodies: &[Body<'_, S>; 2],
    origin: &Place<S>,
    rough: &mut [Rough; 2],
    translation: &Directed<S>,
    features: Features,
) -> Points<S> {
    let Directed { unit: normal, way, .. } = translation;
    let mut solids = two(|n| Solid::new(&rough[n]));
    let size = greatest(solids[0].size, solids[1].size);
    let mut scale = 1.0;
    // Fixed point stays within them. NaN and infinity are too great; `greatest` may pass over a NaN.
    if S::FLOAT.is_some() && !(size > RANGE.0 && solids.iter().all(|solid| solid.size < RANGE.1)) {
        scale = if size < 1.0 { UP } else { DOWN };
        *rough = two(|n| bodies[n].rough(&bodies[1], scale));
        solids = two(|n| Solid::new(&rough[n]));
    }
    let size = greatest(solids[0].size, solids[1].size);
    let view = View::new(normal, size, Unit::new::<S>(size));
    let [first, second] = &solids;
    let is_second = matches!(features, Features::Second(_));
    let shapes = if is_second { [second, first] } else { [first, second] };
    let outward = three(|i| flipped(normal[i], !is_second));
    let mut found = Pairs::NONE;
    match (features, way.direction) {
        (Features::First(face) | Features::Second(face), _) => {
            part(|| by_face(&view, way, shapes, face, &outward, &mut found));
        }
        (Features::Edges(..), Direction::Sides(i, j)) => {
            let edges = |n: usize, k: u8| {
                let across = bits(|k| way.along[n % 2][k].is_eq());
                let is_triangle = bodies[n % 2].is_triangle();
                let ends = if is_triangle {
                    let farthest = way.farthest(n);
                    bits(|k| farthest[k])
                } else {
                    upper(way, n)
                };
                solids[n % 2].support_edges(k, across, ends)
            };
            part(|| by_edges(&view, &solids, [edges(0, i), edges(1, j)], normal, &mut found));
        }
        (Features::Edges(..) | Features::Nearest(..), _) => {}
    }
    let depth = if scale == 1.0 { translation.depth } else { f64::INFINITY };
    let is_deep = |found: &Pairs| is_deep(found.deepest(), depth, &view, shapes, &outward);
    if found.count == 0 || (!way.is_held && !is_deep(&found)) {
        by_any_faces(&view, shapes, &outward, &mut found);
    }
    rounded(&found, origin, scale, is_second)
}

/// Whether the deepest point is as deep as the shapes overlap.
///
/// # The error
///
/// With the sizes of [`View`]: a term of an overlap errs by 11·u of itself, with the roundings of the
/// shapes, of the normal, of the product and of the sums, and a place by 3·u·S too. The sizes of all terms
/// of a shape have a sum of at most √3·S, so an overlap errs by 2·(11 + 3)·√3·u·S. The exact depth is at most
/// 2·√3·S and errs by 3·u of itself, as floats have it. With two differences more, that is below 75·u·S: a
/// point that is above that depth less three tolerances, of 256·u·S, is above the overlap less four. `view.g`
/// proves it.
fn is_deep(
    deepest: f64,
    exact: f64,
    view: &View,
    shapes: [&Solid<'_>; 2],
    outward: &Vec64,
) -> bool {
    if deepest >= exact - 3.0 * view.tolerance {
        return true;
    }
    let back = outward.each(|x| -x);
    let overlap = shapes[0].reach_along(outward) + shapes[1].reach_along(&back);
    deepest >= overlap - 4.0 * view.tolerance
}

/// The contact points of face `number` of `shape` and a face of `other`.
///
/// After the least translation the deepest vertices of `other` touch the face, so a single face
/// that contains these vertices is enough. A translation held to a triangle's normal need not be
/// the least, and the face with the deepest vertices may lie beyond the triangle. Then the face
/// that is deepest over the triangle is used.
fn by_face(
    view: &View,
    way: &Way,
    [shape, other]: [&Solid<'_>; 2],
    number: u8,
    outward: &Vec64,
    found: &mut Pairs,
) {
    let incident = usize::from(matches!(way.direction, Direction::Face { is_second: false, .. }));
    let reference = Face::new(view, shape, number);
    let mut is_enough = |number: u8| {
        add_deeper(found, view, [&reference, &Face::new(view, other, number)], outward);
        found.count > 0 && !way.is_held
    };
    let of = bits(|k| way.along[incident % 2][k].is_ne());
    let first = other.face_against(outward, of, upper(way, incident));
    if !is_enough(first) {
        other.other_faces_against(outward, first).any(is_enough);
    }
}

/// The deepest contact points of any two faces.
///
/// If the relative difference of two depths is below 2^-55, the first direction is used, although
/// the second may be the true minimum. Then the parts that name the first direction need not touch
/// after the translation, but two other faces do.
#[inline(never)]
fn by_any_faces(view: &View, [shape, other]: [&Solid<'_>; 2], outward: &Vec64, found: &mut Pairs) {
    for number in shape.faces() {
        let face = Face::new(view, shape, number);
        for number in other.faces() {
            add_deeper(found, view, [&face, &Face::new(view, other, number)], outward);
        }
    }
    if found.count == 0 {
        // The coordinates overflow f64.
        let lowest = |shape| Face::new(view, shape, 0).lowest(outward);
        let ((below, first), (at, second)) = (lowest(shape), lowest(other));
        let depth = dot(&minus(&below, &at), outward);
        if let Some(parts) = found.add(Pair { at: [below, at], depth }, 0.0) {
            *parts = [first, second].each(Part::Vertex);
        }
    }
}

/// Takes the points of two faces instead of those found, if they are deeper.
fn add_deeper(found: &mut Pairs, view: &View, faces: [&Face; 2], outward: &Vec64) {
    if found.count == 0 {
        // No second place for points.
        return clip(view, faces, outward, found);
    }
    out_of_line(|| {
        let mut here = Pairs::NONE;
        clip(view, faces, outward, &mut here);
        if here.deepest() > found.deepest() {
            *found = here;
        }
    });
}

/// The crossing of an edge of each shape, projected along the normal. Among several pairs of edges,
/// the pair with the least distance across the normal is used.
fn by_edges(
    view: &View,
    solids: &[Solid<'_>; 2],
    [edges, others]: [u16; 2],
    normal: &Vec64,
    found: &mut Pairs,
) {
    let mut nearest = view.tolerance * view.tolerance;
    for number in ones(edges.into()) {
        let number = number as u8;
        let ends = solids[0].edge(view, number);
        let edge = Edge { ends: ends.each_ref(), number };
        for number in ones(others.into()) {
            let number = number as u8;
            let ends = solids[1].edge(view, number);
            let other = Edge { ends: ends.each_ref(), number };
            let [x, y] = edge.meet(&other, edge.sides(&other));
            let apart = distance(&x, &y);
            if apart <= nearest {
                let depth = greatest(dot(&minus(&y.at, &x.at), normal), 0.0);
                let parts = [Part::Edge(edge.number), Part::Edge(other.number)];
                (found.pairs[0], found.parts[0]) = (Pair { at: [x.at, y.at], depth }, parts);
                (found.count, nearest) = (1, apart);
            }
        }
    }
}

/// Rounds the points to the scalar. In each pair, the point on the first shape comes first.
#[inline(never)]
fn rounded<S: Scalar>(found: &Pairs, origin: &Place<S>, scale: f64, is_second: bool) -> Points<S> {
    // The origin is the mean of two places; this is the offset from the first.
    let is_whole = |i: usize| S::FLOAT.is_none() && origin.0[i] == origin.1[i];
    let offset = three(|i| {
        let difference = || difference_in_double(origin.1[i], origin.0[i], scale) * 0.5;
        if is_whole(i) { 0.0 } else { difference() }
    });
    // Exact, of a power of two.
    let unit = 1.0 / scale;
    // A large offset may overflow where the sum does not: add its half twice.
    let plus = |x: S, offset: f64| {
        part(|| {
            if S::FLOAT.is_some() && scale < 1.0 {
                let half = offset * 0.5 * unit;
                x.plus_double(half).plus_double(half)
            } else {
                x.plus_double(scaled::<S>(offset, unit))
            }
        })
    };
    let place = |at: &Vec64| {
        let [x, y, z] =
            three(|i| plus(origin.0[i], if is_whole(i) { at[i] } else { at[i] + offset[i] }));
        Vec3::new(x, y, z)
    };
    // Without a branch.
    let [first, second] = if is_second { [1, 0] } else { [0, 1] };
    // Where it is returned: not borrowed, and so not copied.
    let mut points = Points::none();
    let mut n = 0;
    while n < found.count.min(MOST) {
        let (pair, parts) = (&found.pairs[n % MOST], &found.parts[n % MOST]);
        let [on_first, on_second] = [place(&pair.at[first]), place(&pair.at[second])];
        let (depth, parts) = (plus(S::ZERO, pair.depth), [parts[first], parts[second]]);
        points.points[n % MOST] = Point { on_first, on_second, depth, parts };
        n += 1;
    }
    points.count = n;
    points
}
