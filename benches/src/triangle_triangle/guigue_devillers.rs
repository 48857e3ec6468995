//! Two triangles by the signs of volumes, rounded.
//!
//! Written from P. Guigue, O. Devillers, "Fast and Robust Triangle–Triangle Overlap Test Using
//! Orientation Predicates", Journal of Graphics Tools 8(1), 2003. Triangles in one plane are decided
//! by the lines of all six edges, in place of the paper's tree of cases.

use std::ops::{Add, Mul, Sub};

pub trait Real:
    Copy + Default + PartialOrd + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
}

impl Real for f32 {}
impl Real for f64 {}

type Vector<T> = [T; 3];

#[inline(never)]
pub fn overlap<T: Real>(first: &[Vector<T>; 3], second: &[Vector<T>; 3]) -> bool {
    let [[a, b, c], [d, e, f]] = [first, second].map(|[a, b, c]| [a, b, c]);
    let normal = cross(from(d, f), from(e, f));
    let sides = [a, b, c].map(|x| dot(from(x, f), normal));
    if are_alike(sides) {
        return false;
    }
    let normal = cross(from(b, a), from(c, a));
    let others = [d, e, f].map(|x| dot(from(x, c), normal));
    if are_alike(others) {
        return false;
    }
    match (with_apex([a, b, c], sides), with_apex([d, e, f], others)) {
        (Some((first, is_first_above)), Some((second, is_second_above))) => {
            // Each apex comes to lie above the plane of its partner.
            let [a, b, c] = ordered(first, is_second_above);
            let [d, e, f] = ordered(second, is_first_above);
            are_in_order(a, b, d, e) && are_in_order(a, c, f, d)
        }
        _ => overlap_in_plane(first, second, normal),
    }
}

fn are_alike<T: Real>([a, b, c]: [T; 3]) -> bool {
    a * b > T::default() && a * c > T::default()
}

/// The vertices from the apex on, which is alone on its side, and whether that side is above; `None`
/// if all vertices lie in the plane.
#[inline(always)]
fn with_apex<T: Real, P: Copy>([p, q, r]: [P; 3], [a, b, c]: [T; 3]) -> Option<([P; 3], bool)> {
    let zero = T::default();
    let (at_p, at_q, at_r) = ([p, q, r], [q, r, p], [r, p, q]);
    Some(if a > zero {
        if b > zero {
            (at_r, false)
        } else if c > zero {
            (at_q, false)
        } else {
            (at_p, true)
        }
    } else if a < zero {
        if b < zero {
            (at_r, true)
        } else if c < zero {
            (at_q, true)
        } else {
            (at_p, false)
        }
    } else if b > zero {
        if c > zero { (at_p, false) } else { (at_q, true) }
    } else if b < zero {
        if c < zero { (at_p, true) } else { (at_q, false) }
    } else if c != zero {
        (at_r, c > zero)
    } else {
        return None;
    })
}

fn ordered<P>([a, b, c]: [P; 3], as_given: bool) -> [P; 3] {
    if as_given { [a, b, c] } else { [a, c, b] }
}

fn are_in_order<T: Real>(a: &Vector<T>, b: &Vector<T>, c: &Vector<T>, d: &Vector<T>) -> bool {
    dot(cross(from(b, a), from(c, a)), from(d, a)) <= T::default()
}

/// In the projection along the greatest component of the normal.
#[cold]
#[inline(never)]
fn overlap_in_plane<T: Real>(
    first: &[Vector<T>; 3],
    second: &[Vector<T>; 3],
    normal: Vector<T>,
) -> bool {
    let [x, y, z] = normal.map(|x| if x < T::default() { T::default() - x } else { x });
    let (j, k) = if x >= y && x >= z { (1, 2) } else { [(0, 1), (2, 0)][usize::from(y > z)] };
    let turn = |a: &Vector<T>, b: &Vector<T>, c: &Vector<T>| {
        (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j])
    };
    let separates = |[a, b, c]: [&Vector<T>; 3], others: &[Vector<T>; 3]| {
        let inside = turn(a, b, c) > T::default();
        others.iter().all(|x| {
            let side = turn(a, b, x);
            side != T::default() && (side > T::default()) != inside
        })
    };
    let is_apart = |[a, b, c]: &[Vector<T>; 3], others: &[Vector<T>; 3]| {
        [[a, b, c], [b, c, a], [c, a, b]].into_iter().any(|edge| separates(edge, others))
    };
    !is_apart(first, second) && !is_apart(second, first)
}

fn from<T: Real>(a: &Vector<T>, b: &Vector<T>) -> Vector<T> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross<T: Real>(a: Vector<T>, b: Vector<T>) -> Vector<T> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot<T: Real>(a: Vector<T>, b: Vector<T>) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
