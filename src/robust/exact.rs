//! The last stage: the 13 axes by exact sums of products of the coordinates as
//! they were given.
//!
//! No difference is formed, for it might round. A difference is a list of
//! signed coordinates, a product of differences the sum of all products of one
//! from each list, and only the sum's sign is asked for. Slow, short, and right
//! for every finite input, the extremes of `f64` included.

use core::cmp::Ordering;

use crate::linear::{pick, turn};
use crate::scalar::{ExactSum, Parts, Scalar};
use crate::shape::{AabbForm, PlaneForm};

pub(super) const ZERO: Parts = Parts { negative: false, magnitude: 0, shift: 0 };

/// A sum of up to three signed coordinates.
pub(super) type Linear = [Parts; 3];

/// a − b.
pub(super) fn difference(a: Parts, b: Parts) -> Linear {
    [a, b.negated(), ZERO]
}

/// The number one, as a factor that changes nothing.
const UNIT: Linear = [Parts { negative: false, magnitude: 1, shift: 0 }, ZERO, ZERO];

/// Adds a·b·c to the sum, or takes it away. Out of line: code this cold should be small.
#[inline(never)]
fn add_product<T: ExactSum>(sum: &mut T, [a, b, c]: [&Linear; 3], minus: bool) {
    let nonzero = |x: &&Parts| x.magnitude != 0;
    for &x in a.iter().filter(nonzero) {
        let x = if minus { x.negated() } else { x };
        for &y in b.iter().filter(nonzero) {
            for &z in c.iter().filter(nonzero) {
                sum.add(&[x, y, z]);
            }
        }
    }
}

/// The sign of a sum of coordinates.
#[inline(never)]
fn sign<S: Scalar>(x: &Linear) -> Ordering {
    let mut sum = S::Sum::new();
    add_product(&mut sum, [x, &UNIT, &UNIT], false);
    sum.sign()
}

/// Adds a·b to the sum, or takes it away.
pub(super) fn add_area<T: ExactSum>(sum: &mut T, a: &Linear, b: &Linear, minus: bool) {
    add_product(sum, [a, b, &UNIT], minus);
}

/// Adds (a_j·b_k − a_k·b_j)·c to the sum.
fn add_volume<T: ExactSum>(sum: &mut T, a: &[Linear; 3], b: &[Linear; 3], i: usize, c: &Linear) {
    let (_, j, k) = turn(i);
    add_product(sum, [pick(a, j), pick(b, k), c], false);
    add_product(sum, [pick(a, k), pick(b, j), c], true);
}

/// The coordinates of a triangle, taken apart.
pub(crate) struct ExactTriangle {
    v: [[Parts; 3]; 3],
}

impl ExactTriangle {
    pub(crate) fn new<S: Scalar>(points: &[[S; 3]; 3]) -> Self {
        Self { v: points.map(|p| p.map(S::parts)) }
    }

    /// Edge k, from vertex k to the next.
    fn edge(&self, k: usize) -> [Linear; 3] {
        let (k, next, _) = turn(k);
        let (from, to) = (pick(&self.v, k), pick(&self.v, next));
        core::array::from_fn(|i| difference(to[i], from[i]))
    }

    /// The sign of component `i` of the normal, e0 × e1.
    pub(crate) fn normal_sign<S: Scalar>(&self, i: usize) -> Ordering {
        self.normal_sum::<S>(i).sign()
    }

    /// Component `i` of the normal, e0 × e1.
    pub(crate) fn normal_sum<S: Scalar>(&self, i: usize) -> S::Sum {
        let (_, j, k) = turn(i);
        let (e0, e1) = (self.edge(0), self.edge(1));
        let mut sum = S::Sum::new();
        add_area(&mut sum, pick(&e0, j), pick(&e1, k), false);
        add_area(&mut sum, pick(&e0, k), pick(&e1, j), true);
        sum
    }
}

/// The faces of a box, taken apart: each the sum of two numbers.
pub(crate) struct ExactBox {
    min: [[Parts; 2]; 3],
    max: [[Parts; 2]; 3],
}

impl ExactBox {
    pub(crate) fn new<S: Scalar>(form: &AabbForm<S>) -> Self {
        match form {
            AabbForm::Center { center, half } => {
                let (c, h) = (center.to_array().map(S::parts), half.to_array().map(S::parts));
                Self {
                    min: core::array::from_fn(|i| [c[i], h[i].negated()]),
                    max: core::array::from_fn(|i| [c[i], h[i]]),
                }
            }
            AabbForm::Corners { min, max } => Self {
                min: min.to_array().map(|x| [x.parts(), ZERO]),
                max: max.to_array().map(|x| [x.parts(), ZERO]),
            },
        }
    }

    /// From `x` to the face of axis `i` that lies farther along `toward`.
    #[inline(never)]
    pub(crate) fn to_face(&self, x: Parts, i: usize, toward: Ordering) -> Linear {
        let face = if toward == Ordering::Less { &self.min } else { &self.max };
        let [a, b] = *pick(face, i);
        [a, b, x.negated()]
    }

    /// Whether face axis `i` separates.
    pub(crate) fn face_separates<S: Scalar>(&self, t: &ExactTriangle, i: usize) -> bool {
        let all = |toward: Ordering| {
            let side = |v| sign::<S>(&self.to_face(*pick(v, i), i, toward));
            t.v.iter().all(|v| side(v) == toward.reverse())
        };
        all(Ordering::Greater) || all(Ordering::Less)
    }

    /// Whether the triangle's normal separates, given the signs of its
    /// components.
    pub(crate) fn normal_separates<S: Scalar>(
        &self,
        t: &ExactTriangle,
        signs: &[Ordering; 3],
    ) -> bool {
        let (e0, e1) = (t.edge(0), t.edge(1));
        // The critical corner along the normal, or against it, from vertex 0.
        let corner = |along: bool| {
            let mut sum = S::Sum::new();
            for i in 0..3 {
                let toward = if along { signs[i] } else { signs[i].reverse() };
                add_volume(&mut sum, &e0, &e1, i, &self.to_face(*pick(&t.v[0], i), i, toward));
            }
            sum.sign()
        };
        corner(true) == Ordering::Less || corner(false) == Ordering::Greater
    }

    /// Whether the cross product of coordinate axis `i` and edge `k` separates,
    /// given the sign of component `i` of the normal.
    pub(crate) fn edge_separates<S: Scalar>(
        &self,
        t: &ExactTriangle,
        i: usize,
        k: usize,
        normal: Ordering,
    ) -> bool {
        let (_, j, l) = turn(i);
        let (k, _, opposite) = turn(k);
        let e = t.edge(k);
        let (ej, el) = (sign::<S>(pick(&e, j)), sign::<S>(pick(&e, l)));
        // (e × (z − v))_i is greatest over the box for z_l along e_j and z_j
        // against e_l. The triangle covers the interval from 0 to n_i: from the
        // edge's own vertex to the one opposite.
        let beyond = |along: bool| {
            let base = if (normal == Ordering::Greater) == along {
                // Beyond the far end: measure from the vertex opposite.
                pick(&t.v, opposite)
            } else {
                pick(&t.v, k)
            };
            let turn = |o: Ordering| if along { o } else { o.reverse() };
            let mut sum = S::Sum::new();
            let z_l = self.to_face(*pick(base, l), l, turn(ej).reverse());
            let z_j = self.to_face(*pick(base, j), j, turn(el));
            add_area(&mut sum, pick(&e, j), &z_l, false);
            add_area(&mut sum, pick(&e, l), &z_j, true);
            sum.sign() == turn(Ordering::Greater)
        };
        // The whole box above the interval, or the whole box below it.
        beyond(true) || beyond(false)
    }
}

impl ExactBox {
    /// The sign of n·(x − p), or of n·x + d, at the corner x of the box that lies
    /// farthest along n, or least far.
    pub(crate) fn corner_side<S: Scalar>(
        &self,
        normal: [S; 3],
        form: &PlaneForm<S>,
        along: bool,
    ) -> Ordering {
        let mut sum = S::Sum::new();
        for (i, n) in normal.into_iter().enumerate() {
            let toward = n.partial_cmp(&S::ZERO).unwrap_or(Ordering::Equal);
            let toward = if along { toward } else { toward.reverse() };
            let from = match form {
                PlaneForm::Point(p) => p.to_array()[i].parts(),
                PlaneForm::Offset(_) => ZERO,
            };
            add_area(&mut sum, &[n.parts(), ZERO, ZERO], &self.to_face(from, i, toward), false);
        }
        if let PlaneForm::Offset(d) = form {
            sum.add(&[d.parts(), S::ONE]);
        }
        sum.sign()
    }
}
