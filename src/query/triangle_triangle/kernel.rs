use crate::arithmetic::{Arithmetic, Number, cross, dot, pick, turn};
use crate::query::orientation::{apex, error_bound, from, larger, sides, size};
use crate::query::relation::Relation;
use crate::robust::certain_sign;

/// Three points.
type Points<N> = [[<N as Arithmetic>::Length; 3]; 3];

/// The relation of two triangles, if their planes cross and all signs are certain.
///
/// Unless one triangle lies on one side of the other's plane, each has an apex: a vertex alone on
/// its side. The two planes meet in a line, and on that line the two edges from each apex cut out
/// an interval. The signs of two volumes, each spanned by an edge of either triangle, say whether
/// the intervals meet. All volumes have the first triangle's apex as origin, and share its
/// differences.
#[inline(always)]
pub(super) fn crossing<N: Arithmetic>(first: &Points<N>, second: &Points<N>) -> Option<Relation> {
    let [p, q] = [first, second];
    let (e, f) = (from::<N>(&q[1], &q[0]), from::<N>(&q[2], &q[0]));
    let v = [from::<N>(&p[0], &q[0]), from::<N>(&p[1], &q[0]), from::<N>(&p[2], &q[0])];
    let first = sides::<N, 3>([&e, &f], &v, size::<N, 3>(&v))?;
    if is_one_sided(first) {
        return Some(Relation::Disjoint);
    }
    if is_unclear::<N>(first) {
        return None;
    }

    let (i, is_first_above) = apex(first);
    let (i, j, k) = turn(i);
    let [a, b, c] = [i, j, k].map(|i| pick(p, i));
    let (e, f) = (from::<N>(b, a), from::<N>(c, a));
    let v = [from::<N>(&q[0], a), from::<N>(&q[1], a), from::<N>(&q[2], a)];
    let reach = size::<N, 3>(&v);
    let second = sides::<N, 3>([&e, &f], &v, reach)?;
    if is_one_sided(second) {
        return Some(Relation::Disjoint);
    }
    if is_unclear::<N>(second) {
        return None;
    }

    // Each triangle in the order that puts its partner's apex above its plane.
    let (i, is_second_above) = apex(second);
    let (i, j, k) = turn(i);
    let (e, f) = if is_second_above { (e, f) } else { (f, e) };
    let (j, k) = if is_first_above { (j, k) } else { (k, j) };
    let [u, v, w] = [i, j, k].map(|i| pick(&v, i));
    let edges = if N::CERTAIN { N::Length::ZERO } else { larger::<N>(&e, &f) };
    let error = error_bound::<N>([edges, reach, reach])?;
    let ends = [
        certain_sign(dot::<N>(&cross::<N>(&e, u), v), error),
        certain_sign(dot::<N>(&cross::<N>(&f, w), u), error),
    ];
    if ends[0] > 0 || ends[1] > 0 {
        return Some(Relation::Disjoint);
    }
    if ends[0] < 0 && ends[1] < 0 && straddles(first) && straddles(second) {
        return Some(Relation::Overlapping);
    }
    if N::CERTAIN { Some(Relation::Touching) } else { None }
}

/// Whether the first triangle certainly lies on one side of the plane of the second.
#[inline(always)]
pub(super) fn is_beyond<N: Arithmetic>(first: &Points<N>, second: &Points<N>) -> bool {
    let [a, b, c] = second;
    let (e, f) = (from::<N>(b, a), from::<N>(c, a));
    let v = [from::<N>(&first[0], a), from::<N>(&first[1], a), from::<N>(&first[2], a)];
    sides::<N, 3>([&e, &f], &v, size::<N, 3>(&v)).is_some_and(is_one_sided)
}

#[inline(always)]
fn is_one_sided([a, b, c]: [i8; 3]) -> bool {
    a != 0 && a == b && b == c
}

#[inline(always)]
fn straddles(signs: [i8; 3]) -> bool {
    signs.contains(&1) && signs.contains(&-1)
}

/// Whether a sign is in doubt, or all are zero.
#[inline(always)]
fn is_unclear<N: Arithmetic>([a, b, c]: [i8; 3]) -> bool {
    if N::CERTAIN { (a | b | c) == 0 } else { (a == 0) | (b == 0) | (c == 0) }
}
