//! Convex hulls in integers: whether two share an interior point, and their overlap on every axis.

use dashu_int::IBig;

use super::simplex::holds_zero;
use crate::{Each, lattice::Ring, three};

pub(super) type Point = [IBig; 3];

/// The convex hull of points, with the vectors along its sides and the number of faces that have
/// separate normals.
pub(super) struct Hull {
    pub(super) points: Vec<Point>,
    pub(super) sides: [Point; 3],
    pub(super) is_triangle: bool,
    /// The sides that it extends along.
    pub(super) extends: [bool; 3],
}

pub(super) fn scaled(p: &Point, by: &IBig) -> Point {
    three(|i: usize| &p[i] * by)
}

pub(super) fn sum(a: &Point, b: &Point) -> Point {
    three(|i: usize| &a[i] + &b[i])
}

impl Hull {
    pub(super) fn moved(&self, by: &Point) -> Vec<Point> {
        self.points.iter().map(|p| sum(p, by)).collect()
    }

    pub(super) fn normals(&self) -> Vec<Point> {
        let [a, b, c] = &self.sides;
        let all = if self.is_triangle { vec![(a, b)] } else { vec![(b, c), (c, a), (a, b)] };
        all.into_iter().map(|(x, y)| IBig::cross(x, y)).collect()
    }

    pub(super) fn ends(&self, a: &Point) -> [IBig; 2] {
        let along = || self.points.iter().map(|p| IBig::dot(p, a));
        [along().min().expect("points"), along().max().expect("points")]
    }
}

/// Whether two hulls still have a point in common after both shrink by a factor of 1 − 2^−128 about
/// their centres.
pub(super) fn share_an_interior_point(first: &[Point], second: &[Point]) -> bool {
    let shrunk = |points: &[Point], other: usize| -> Vec<Point> {
        let count = IBig::from(points.len());
        let center = points.iter().fold([IBig::ZERO, IBig::ZERO, IBig::ZERO], |s, p| sum(&s, p));
        let less = ((IBig::ONE << 128) - IBig::ONE) * count;
        // In a common unit, divided by the number of points of either hull.
        let shrink = |p: &Point| scaled(&sum(&scaled(p, &less), &center), &IBig::from(other));
        points.iter().map(shrink).collect()
    };
    let (a, b) = (shrunk(first, second.len()), shrunk(second, first.len()));
    let differences: Vec<Point> =
        a.iter().flat_map(|p| b.iter().map(move |q| IBig::difference(p, q))).collect();
    holds_zero(&differences)
}

/// The overlap of the shapes along a direction: |a|·depth, and a.
pub(super) struct Depth {
    /// The direction that the first shape moves along.
    pub(super) axis: Point,
    pub(super) overlap: IBig,
    pub(super) square: IBig,
}

/// Whether both hulls lie in one plane, or in parallel planes.
pub(super) fn is_flat(hulls: &[Hull; 2]) -> bool {
    let sides: Vec<&Point> = hulls
        .iter()
        .flat_map(|h| h.sides.iter().zip(h.extends).filter(|(_, e)| *e).map(|(s, _)| s))
        .collect();
    let normals = || sides.iter().flat_map(|a| sides.iter().map(move |b| IBig::cross(a, b)));
    !normals().any(|n| sides.iter().any(|c| IBig::dot(&n, c) != IBig::ZERO))
}

/// The overlaps of the shapes on all axes, in both directions, in the order in which the first of equal
/// ones counts; `None` if an axis separates.
pub(super) fn depths(hulls: &[Hull; 2]) -> Option<Vec<Depth>> {
    let [first, second] = hulls;
    let mut normals = [first.normals(), second.normals()];
    if second.is_triangle && !first.is_triangle {
        normals.reverse();
    }
    let mut axes = normals.concat();
    for x in &first.sides {
        axes.extend(second.sides.iter().map(|y| IBig::cross(x, y)));
    }
    let mut all = Vec::new();
    for a in axes {
        let square = IBig::dot(&a, &a);
        if square == IBig::ZERO {
            continue;
        }
        let ([b, e], [c, f]) = (first.ends(&a), second.ends(&a));
        let against = a.each_ref().each(|x| -x);
        for (axis, overlap) in [(against, e - c), (a, f - b)] {
            if overlap <= IBig::ZERO {
                return None;
            }
            all.push(Depth { axis, overlap, square: square.clone() });
        }
    }
    (!all.is_empty()).then_some(all)
}
