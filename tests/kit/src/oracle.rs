//! The oracle for triangle and box. It clips, where the crate looks for separating axes.
//!
//! A closed convex set meets the box exactly if clipping it by the box's six closed half-spaces
//! leaves a point (I. E. Sutherland, G. W. Hodgman, "Reentrant Polygon Clipping", *CACM* 17(1),
//! 1974). Clipping is done in barycentric coordinates, where every point of the triangle is some
//! u·a + v·b + w·c with u, v, w ≥ 0 not all zero, up to a positive factor. There
//! - a triangle that is a segment or a point is still a whole triangle; only the map to space is
//!   not one-to-one;
//! - a half-space is a linear form in u, v, w, given by its values at the three vertices;
//! - each side of the clipped polygon lies on a line with a known form, and a new corner is the
//!   cross product of two forms. So corners stay short however many cuts they go through, and no
//!   fraction appears.

use super::case::Case;
use super::lattice::{Lattice, Ring, Shapes};
use super::sample::Sample;
use crate::three;

/// Whether triangle and box have a point in common.
pub fn meets<S: Sample>(case: &Case<S>) -> bool {
    Lattice::new(case).meets()
}

/// Whether the triangle's vertices lie on one line or in one point: equality in the Cauchy–Schwarz
/// inequality for two of its edges.
pub fn is_collinear<S: Sample>(case: &Case<S>) -> bool {
    Lattice::new(case).is_collinear()
}

impl Lattice {
    fn is_collinear(&self) -> bool {
        let shapes = match self {
            Self::Narrow(shapes) => &shapes.big(),
            Self::Wide(shapes) => shapes,
        };
        let (e, f) = (shapes.edge(0), shapes.edge(1));
        let ef = Ring::dot(&e, &f);
        Ring::dot(&e, &e) * Ring::dot(&f, &f) == &ef * &ef
    }

    /// Whether the two shapes have a point in common.
    pub fn meets(&self) -> bool {
        match self {
            Self::Narrow(shapes) => shapes.meet(),
            Self::Wide(shapes) => shapes.meet(),
        }
    }
}

/// A corner of the clipped polygon, and the line of the side to the next corner.
#[derive(Clone)]
pub(crate) struct Corner<I> {
    pub(crate) point: [I; 3],
    side: [I; 3],
}

/// The polygon with these corners, before clipping. No two neighbours coincide, and no coordinate
/// is negative.
pub(crate) fn closed<I: Ring>(points: Vec<[I; 3]>) -> Vec<Corner<I>> {
    let next = points.iter().cycle().skip(1);
    let corner = |(p, next): (&[I; 3], _)| Corner { point: p.clone(), side: I::cross(p, next) };
    points.iter().zip(next).map(corner).collect()
}

/// The triangle before clipping.
pub(crate) fn uncut<I: Ring>() -> Vec<Corner<I>> {
    let unit = |k: usize| core::array::from_fn(|i| I::from_bit(i == k));
    // On the side from vertex k to the next, the third coordinate is zero.
    three(|k: usize| Corner { point: unit(k), side: unit((k + 2) % 3) }).into()
}

impl<I: Ring> Shapes<I> {
    fn meet(&self) -> bool {
        let spaces = self.half_spaces();
        // Two early exits: a vertex in the box, and a half-space without a vertex.
        let inside = |form: &[I; 3], k: usize| form[k].sign() >= 0;
        if (0..3).any(|k| spaces.iter().all(|form| inside(form, k))) {
            return true;
        }
        if spaces.iter().any(|form| !(0..3).any(|k| inside(form, k))) {
            return false;
        }
        !cut(&spaces).is_empty()
    }

    /// The six half-spaces as forms that are not negative inside.
    fn half_spaces(&self) -> [[I; 3]; 6] {
        core::array::from_fn(|s| {
            let i = s % 3;
            core::array::from_fn(|k| {
                let x = &self.vertices[k][i];
                if s < 3 { x.clone() } else { self.extent[i].minus(x) }
            })
        })
    }
}

/// The corners of the triangle after clipping by all half-spaces. Each is given by its values at
/// the three vertices, not negative inside.
fn cut<I: Ring>(spaces: &[[I; 3]]) -> Vec<Corner<I>> {
    let mut cycle = uncut();
    for form in spaces {
        cycle = clip(&cycle, form);
        if cycle.is_empty() {
            break;
        }
    }
    cycle
}

/// Whether clipping by closed half-spaces leaves a point of the triangle that is not on the
/// boundary of any half-space in `open`. The result is convex, so all of it lies on the boundaries
/// only if all of it lies on one of them.
pub(crate) fn remains<I: Ring>(closed: &[[I; 3]], open: &[[I; 3]]) -> bool {
    let left = cut(&[closed, open].concat());
    let is_inside = |form: &[I; 3]| left.iter().any(|c| I::dot(&c.point, form).sign() > 0);
    !left.is_empty() && open.iter().all(is_inside)
}

/// Clips the polygon by a half-space.
pub(crate) fn clip<I: Ring>(cycle: &[Corner<I>], form: &[I; 3]) -> Vec<Corner<I>> {
    let signs: Vec<i32> = cycle.iter().map(|c| I::dot(&c.point, form).sign()).collect();
    if signs.iter().all(|&sign| sign >= 0) {
        return cycle.to_vec();
    }
    let mut left = Vec::with_capacity(cycle.len() + 1);
    for (i, Corner { point, side }) in cycle.iter().enumerate() {
        let (here, next) = (signs[i], signs[(i + 1) % signs.len()]);
        let keep = |point, side: &[I; 3]| Corner { point, side: side.clone() };
        match (here, next) {
            (0.., 0..) => left.push(keep(point.clone(), side)),
            // Leaving the half-space: the new side runs along the cut to the point of return.
            (1, _) => {
                left.push(keep(point.clone(), side));
                left.push(keep(crossing(side, form), form));
            }
            (0, _) => left.push(keep(point.clone(), form)),
            (_, 1) => left.push(keep(crossing(side, form), side)),
            _ => {}
        }
    }
    left
}

/// The intersection of two lines, which lies inside the triangle: no coordinate is negative, after
/// a change of all signs if necessary.
fn crossing<I: Ring>(a: &[I; 3], b: &[I; 3]) -> [I; 3] {
    let point = I::cross(a, b);
    if point.iter().any(|x| x.sign() < 0) { I::cross(b, a) } else { point }
}
