use crate::arithmetic::{Arithmetic, Each, cross, dot, pick, turn, two};
use crate::query::orientation::{Vector, apex, error_bound, from, sides, size};
use crate::query::relation::Relation;
use crate::robust::certain_sign;

/// Three points.
type Points<N> = [[<N as Arithmetic>::Length; 3]; 3];

/// An edge of a triangle: the first or the second triangle, and the numbers of two vertices.
pub(super) type Edge = (usize, [usize; 2]);

/// The edges on which a segment begins and ends.
pub(super) type Ends = [Edge; 2];

/// Two triangles that cut the line in which their planes meet.
///
/// Unless one triangle lies on one side of the other's plane, each has an apex: a vertex alone on
/// its side. On the line of both planes the two edges from each apex cut out an interval. All
/// volumes have the first triangle's apex as origin, and share its differences.
struct Cut<N: Arithmetic> {
    /// The sides of the other plane on which the vertices of each triangle lie.
    sides: [[i8; 3]; 2],
    /// The vertices of each triangle from its apex, in the order that puts its partner's apex above
    /// its plane.
    vertices: [[usize; 3]; 2],
    /// Whether the apex of each triangle is above the plane of its partner.
    are_above: [bool; 2],
    /// From the apex of the first triangle to its other vertices.
    edges: [Vector<N>; 2],
    /// From there to the vertices of the second triangle.
    across: [Vector<N>; 3],
    error: N::Volume,
}

/// The cut, or else the relation of the triangles; without either a sign is in doubt, or the
/// triangles lie in one plane.
#[inline(always)]
fn cut<N: Arithmetic>(
    first: &Points<N>,
    second: &Points<N>,
    first_sides: [i8; 3],
) -> Result<Cut<N>, Option<Relation>> {
    let sides = [first_sides, clear_sides::<N>(second, first)?];
    let ((i, is_first_above), (l, is_second_above)) = (apex(sides[0]), apex(sides[1]));
    let ((i, j, k), (l, m, n)) = (turn(i), turn(l));
    let (j, k) = if is_second_above { (j, k) } else { (k, j) };
    let (m, n) = if is_first_above { (m, n) } else { (n, m) };
    let from_apex = |x: &Vector<N>| from::<N>(x, pick(first, i));
    let edges = [from_apex(pick(first, j)), from_apex(pick(first, k))];
    let across = [l, m, n].each(|x| from_apex(pick(second, x)));
    let reach = size::<N, 3>(&across);
    let error = error_bound::<N>([size::<N, 2>(&edges), reach, reach]).ok_or(None)?;
    let (vertices, are_above) = ([[i, j, k], [l, m, n]], [is_first_above, is_second_above]);
    Ok(Cut { sides, vertices, are_above, edges, across, error })
}

/// The sides of the plane of `triangle` on which three points lie, if all signs are certain and not
/// all zero; or else that they lie on one side, or nothing.
#[inline(always)]
pub(super) fn clear_sides<N: Arithmetic>(
    points: &Points<N>,
    triangle: &Points<N>,
) -> Result<[i8; 3], Option<Relation>> {
    let sides = sides_of_plane::<N>(points, triangle).ok_or(None)?;
    let [a, b, c] = sides;
    if is_one_sided(sides) {
        Err(Some(Relation::Disjoint))
    } else if if N::CERTAIN { (a | b | c) == 0 } else { (a & b & c & 1) == 0 } {
        Err(None)
    } else {
        Ok(sides)
    }
}

/// The relation of two triangles, if their planes cross and all signs are certain.
///
/// The signs of two volumes, each spanned by an edge of either triangle, say whether the intervals
/// meet.
#[inline(always)]
pub(super) fn crossing<N: Arithmetic>(
    first: &Points<N>,
    second: &Points<N>,
    first_sides: [i8; 3],
) -> Option<Relation> {
    let cut = match cut::<N>(first, second, first_sides) {
        Ok(cut) => cut,
        Err(relation) => return relation,
    };
    let Cut { sides, edges: [e, f], across: [u, v, w], error, .. } = cut;
    let ends = [
        certain_sign(dot::<N>(&cross::<N>(&e, &u), &v), error),
        certain_sign(dot::<N>(&cross::<N>(&f, &w), &u), error),
    ];
    if ends[0] > 0 || ends[1] > 0 {
        return Some(Relation::Disjoint);
    }
    if ends[0] < 0 && ends[1] < 0 && straddles(sides[0]) && straddles(sides[1]) {
        return Some(Relation::Overlapping);
    }
    if N::CERTAIN { Some(Relation::Touching) } else { None }
}

/// The ends of the segment in which two triangles in different planes meet, along the cross product
/// of their normals, if all signs are certain. No segment if they meet in a point or not at all.
///
/// Let a, b, c and d, e, f be the vertices in the order of [`Cut`]. The volume of a, x, d, y says
/// in which order the edges a x and d y meet the line of both planes. Along the cross product of
/// the normals, for the vertices in this order, the first triangle's interval goes from c to b, and
/// the second triangle's from e to f.
#[inline(always)]
pub(super) fn ends<N: Arithmetic>(first: &Points<N>, second: &Points<N>) -> Option<Option<Ends>> {
    let cut = clear_sides::<N>(first, second).and_then(|sides| cut::<N>(first, second, sides));
    let cut = match cut {
        Ok(cut) => cut,
        Err(None) if !N::CERTAIN => return None,
        Err(_) => return Some(None),
    };
    let Cut { sides, vertices: [[a, b, c], [d, e, f]], edges, across: [u, v, w], error, .. } = cut;
    // An apex in the other plane is the only point of its triangle there.
    if *pick(&sides[0], a) == 0 || *pick(&sides[1], d) == 0 {
        return Some(None);
    }
    let [to_b, to_c] = two(|i| cross::<N>(&edges[i], &u));
    let order = |to: &[N::Area; 3], vertex: &Vector<N>| certain_sign(dot::<N>(to, vertex), error);
    let (be, cf) = (order(&to_b, &v), order(&to_c, &w));
    if be > 0 || cf < 0 {
        return Some(None);
    }
    let (bf, ce) = (order(&to_b, &w), order(&to_c, &v));
    if be == 0 || cf == 0 {
        return if N::CERTAIN { Some(None) } else { None };
    }
    if !N::CERTAIN && (bf == 0 || ce == 0) {
        return None;
    }
    let from = if ce > 0 { (1, [d, e]) } else { (0, [a, c]) };
    let to = if bf > 0 { (0, [a, b]) } else { (1, [d, f]) };
    let is_along = cut.are_above[0] == cut.are_above[1];
    Some(Some(if is_along { [from, to] } else { [to, from] }))
}

/// Whether the first triangle certainly lies on one side of the plane of the second.
#[inline(always)]
pub(super) fn is_beyond<N: Arithmetic>(first: &Points<N>, second: &Points<N>) -> bool {
    sides_of_plane::<N>(first, second).is_some_and(is_one_sided)
}

/// The sides of the plane of a triangle on which three points lie: zero in doubt.
#[inline(always)]
fn sides_of_plane<N: Arithmetic>(points: &Points<N>, [a, b, c]: &Points<N>) -> Option<[i8; 3]> {
    let v = points.each(|point| from::<N>(&point, a));
    sides::<N, 3>([&from::<N>(b, a), &from::<N>(c, a)], &v, size::<N, 3>(&v))
}

#[inline(always)]
fn is_one_sided([a, b, c]: [i8; 3]) -> bool {
    (a + b + c).abs() == 3
}

#[inline(always)]
fn straddles(signs: [i8; 3]) -> bool {
    signs.contains(&1) && signs.contains(&-1)
}
