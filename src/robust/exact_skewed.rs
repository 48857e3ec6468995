//! The last stage for a box with axes of its own: exact sums of products of the
//! numbers as given, as in [`super::exact`]. The axes are those of
//! `axis::skewed`; every term has four factors.

use core::cmp::Ordering;

use super::exact::{Linear, ZERO, difference};
use crate::linear::turn;
use crate::scalar::{ExactSum, Parts, Scalar};

/// A vector of linear forms.
type Vector = [Linear; 3];

/// A triangle and a parallelepiped, taken apart.
pub(crate) struct ExactSkewed {
    /// The vertices from the centre.
    t: [Vector; 3],
    /// The edges.
    e: [Vector; 3],
    /// The axes.
    u: [Vector; 3],
    h: [Parts; 3],
}

impl ExactSkewed {
    pub(crate) fn new<S: Scalar>(
        points: &[[S; 3]; 3],
        center: [S; 3],
        axes: &[[S; 3]; 3],
        half: [S; 3],
    ) -> Self {
        let from = |to: [S; 3], from: [S; 3]| {
            core::array::from_fn(|i| difference(to[i].parts(), from[i].parts()))
        };
        let [a, b, c] = *points;
        Self {
            t: [from(a, center), from(b, center), from(c, center)],
            e: [from(b, a), from(c, b), from(a, c)],
            u: axes.map(|u| u.map(|x| [x.parts(), ZERO, ZERO])),
            h: half.map(S::parts),
        }
    }

    /// Whether one of the 13 axes separates.
    pub(crate) fn separates<S: Scalar>(&self) -> bool {
        let [u0, u1, u2] = &self.u;
        let volume = sign::<S>(&[Term(S::ONE, u0, u1, u2)]);
        if (0..3).any(|i| self.face::<S>(i, volume)) {
            return true;
        }
        let [e0, e1, _] = &self.e;
        let un = [0, 1, 2].map(|i| sign::<S>(&[Term(S::ONE, &self.u[i], e0, e1)]));
        self.normal::<S>(&un) || (0..3).any(|k| (0..3).any(|i| self.edge::<S>(i, k, un[i])))
    }

    /// All vertices beyond h_i·|det u|, on either side.
    fn face<S: Scalar>(&self, i: usize, volume: Ordering) -> bool {
        let (i, j, k) = turn(i);
        let (u, v) = (&self.u[j], &self.u[k]);
        let [u0, u1, u2] = &self.u;
        [Ordering::Greater, Ordering::Less].into_iter().any(|side| {
            let h = signed(self.h[i], volume == side);
            (0..3)
                .all(|k| sign::<S>(&[Term(S::ONE, u, v, &self.t[k]), Term(h, u0, u1, u2)]) == side)
        })
    }

    /// n·t_0 beyond Σ h_i·|u_i·n|, on either side.
    fn normal<S: Scalar>(&self, un: &[Ordering; 3]) -> bool {
        let [e0, e1, _] = &self.e;
        [Ordering::Greater, Ordering::Less].into_iter().any(|side| {
            let box_term = |i: usize| Term(signed(self.h[i], un[i] == side), &self.u[i], e0, e1);
            sign::<S>(&[Term(S::ONE, &self.t[0], e0, e1), box_term(0), box_term(1), box_term(2)])
                == side
        })
    }

    /// The interval of the triangle on e_k × u_i beyond the box's, on either side.
    fn edge<S: Scalar>(&self, i: usize, k: usize, un: Ordering) -> bool {
        let (i, j, l) = turn(i);
        let (k, _, opposite) = turn(k);
        let (u, e) = (&self.u, &self.e[k]);
        // w_l·e and w_j·e
        let along_l = sign::<S>(&[Term(S::ONE, &u[i], &u[j], e)]);
        let along_j = sign::<S>(&[Term(S::ONE, &u[l], &u[i], e)]);
        [Ordering::Greater, Ordering::Less].into_iter().any(|side| {
            // The end of the interval nearer to the box: p, or that of the vertex
            // opposite, p + u·n.
            let nearer = if un == side.reverse() { opposite } else { k };
            sign::<S>(&[
                Term(S::ONE, &u[i], e, &self.t[nearer]),
                Term(signed(self.h[j], along_l == side), &u[i], &u[j], e),
                Term(signed(self.h[l], along_j == side), &u[l], &u[i], e),
            ]) == side
        })
    }
}

/// A factor times the determinant of three vectors.
struct Term<'a>(Parts, &'a Vector, &'a Vector, &'a Vector);

fn signed(x: Parts, minus: bool) -> Parts {
    if minus { x.negated() } else { x }
}

/// The sign of a sum of terms.
fn sign<S: Scalar>(terms: &[Term<'_>]) -> Ordering {
    let mut sum = S::Sum::new();
    for Term(factor, a, b, c) in terms {
        for i in 0..3 {
            let (_, j, k) = turn(i);
            add(&mut sum, *factor, &a[i], &b[j], &c[k]);
            add(&mut sum, factor.negated(), &a[i], &b[k], &c[j]);
        }
    }
    sum.sign()
}

fn add<T: ExactSum>(sum: &mut T, factor: Parts, a: &Linear, b: &Linear, c: &Linear) {
    for x in a {
        for y in b {
            for z in c {
                sum.add(&[factor, *x, *y, *z]);
            }
        }
    }
}
