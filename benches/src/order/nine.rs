//! The nine cross products in different orders, in the paper's arithmetic: after the faces and
//! before the plane, as in the fastest order of groups.

use std::cell::RefCell;

use septum::{Aabb, Triangle};

use crate::candidate::{Candidate, Course, Promise};
use crate::triangle_aabb::scenes::Scene;
use crate::unit::{F32, Form};

use super::Test;

/// An axis of the box, and an edge of the triangle.
type Axis = (usize, usize);

/// The orders, the paper's first.
pub(super) const ORDERS: [(&str, [Axis; 9]); 6] = [
    ("edge by edge", [(0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (2, 1), (0, 2), (1, 2), (2, 2)]),
    ("axis by axis", [(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2), (2, 0), (2, 1), (2, 2)]),
    ("diagonals", [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0), (0, 2), (1, 0), (2, 1)]),
    (
        "edge by edge, back",
        [(2, 2), (1, 2), (0, 2), (2, 1), (1, 1), (0, 1), (2, 0), (1, 0), (0, 0)],
    ),
    (
        "axis by axis, back",
        [(2, 2), (2, 1), (2, 0), (1, 2), (1, 1), (1, 0), (0, 2), (0, 1), (0, 0)],
    ),
    ("diagonals, back", [(2, 1), (1, 0), (0, 2), (2, 0), (1, 2), (0, 1), (2, 2), (1, 1), (0, 0)]),
];

type Point = [f32; 3];

struct Shapes {
    v: [Point; 3],
    e: [Point; 3],
    h: Point,
}

impl Shapes {
    #[inline(always)]
    fn new(t: &Triangle<f32>, b: &Aabb<f32>) -> Self {
        let (c, h) = b.center_half_extents().expect("made of centre and half-extents");
        let minus = |a: Point, b: Point| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
        let [p, q, r] = t.vertices().map(|p| minus(p.to_array(), c.to_array()));
        Self { v: [p, q, r], e: [minus(q, p), minus(r, q), minus(p, r)], h: h.to_array() }
    }

    #[inline(always)]
    fn faces(&self) -> bool {
        let [a, b, c] = &self.v;
        (0..3).any(|i| {
            let least = if a[i] < b[i] { a[i] } else { b[i] };
            let most = if a[i] < b[i] { b[i] } else { a[i] };
            let least = if c[i] < least { c[i] } else { least };
            let most = if c[i] > most { c[i] } else { most };
            least > self.h[i] || most < -self.h[i]
        })
    }

    #[inline(always)]
    fn edge(&self, (i, k): Axis) -> bool {
        let (j, l) = ((i + 1) % 3, (i + 2) % 3);
        let e = &self.e[k];
        let on = |v: &Point| e[j] * v[l] - e[l] * v[j];
        let (p, q) = (on(&self.v[k]), on(&self.v[(k + 2) % 3]));
        let r = e[l].abs() * self.h[j] + e[j].abs() * self.h[l];
        let (least, most) = if p < q { (p, q) } else { (q, p) };
        least > r || most < -r
    }

    #[inline(always)]
    fn normal(&self) -> bool {
        let [a, b, _] = &self.e;
        let n = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        let d = n[0] * self.v[0][0] + n[1] * self.v[0][1] + n[2] * self.v[0][2];
        let r = n[0].abs() * self.h[0] + n[1].abs() * self.h[1] + n[2].abs() * self.h[2];
        d.abs() > r
    }
}

#[inline(never)]
fn overlaps<const K: usize>(t: &Triangle<f32>, b: &Aabb<f32>) -> bool {
    let s = Shapes::new(t, b);
    let order = const { ORDERS[K].1 };
    // Written out, so that every index is known to the compiler.
    let edges = s.edge(order[0])
        || s.edge(order[1])
        || s.edge(order[2])
        || s.edge(order[3])
        || s.edge(order[4])
        || s.edge(order[5])
        || s.edge(order[6])
        || s.edge(order[7])
        || s.edge(order[8]);
    !(s.faces() || edges || s.normal())
}

pub(super) fn candidates(course: &Course<Triangle<f32>, Aabb<f32>>) -> Vec<Candidate> {
    let tests: [Test<f32>; 6] =
        [overlaps::<0>, overlaps::<1>, overlaps::<2>, overlaps::<3>, overlaps::<4>, overlaps::<5>];
    let named = ORDERS.iter().zip(tests);
    named.map(|((name, _), test)| course.candidate(name, Promise::Nothing, test)).collect()
}

/// The counts of separating axes on a workload, the same on every machine.
pub(super) struct Counts {
    pub(super) pairs: usize,
    pub(super) apart: usize,
    /// Pairs that each group separates: the faces, the normal, the cross products.
    pub(super) groups: [usize; 3],
}

pub(super) fn counts(scene: &Scene) -> Counts {
    let groups = RefCell::new([0; 3]);
    let pairs = scene.map(|t| F32.triangle(t), |c| F32.aabb(c, Form::Center));
    let answers = pairs.answers(|t, b| {
        let s = Shapes::new(t, b);
        let edges = ORDERS[0].1.into_iter().any(|axis| s.edge(axis));
        let found = [s.faces(), s.normal(), edges];
        for (sum, found) in groups.borrow_mut().iter_mut().zip(found) {
            *sum += usize::from(found);
        }
        found.contains(&true)
    });
    let apart = answers.iter().filter(|apart| **apart).count();
    Counts { pairs: answers.len(), apart, groups: groups.into_inner() }
}

#[cfg(test)]
mod tests {
    use super::{ORDERS, candidates};
    use crate::triangle_aabb::{course, scenes::grid};
    use crate::unit::{F32, Form};

    /// Small integers are not rounded, so every order must find the truth.
    #[test]
    fn every_order_has_all_nine_axes_and_finds_the_truth() {
        for (name, mut order) in ORDERS {
            order.sort_unstable();
            assert_eq!(order, std::array::from_fn(|n| (n / 3, n % 3)), "{name}");
        }
        for candidate in candidates(&course(&grid(), &F32, Form::Center)) {
            assert_eq!((candidate.false_disjoint, candidate.false_overlap), (0, 0));
            assert!(candidate.overlaps > 1_000);
        }
    }
}
