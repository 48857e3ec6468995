//! The last stage for an oriented box: exact sums of products of the numbers as given, as
//! for an axis-aligned box. The axes are those of the kernel; every term has four factors.

use core::cmp::Ordering;

use crate::arithmetic::{Parts, pick, turn};
use crate::robust::{ExactSum, Vector, add_scaled_determinant, difference, single};
use crate::scalar::Scalar;

/// A triangle and a parallelepiped, taken apart.
pub(crate) struct ExactParallelepiped {
    /// The vertices from the centre.
    t: [Vector; 3],
    /// The edges.
    e: [Vector; 3],
    /// The axes.
    u: [Vector; 3],
    h: [Parts; 3],
}

impl ExactParallelepiped {
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
            u: axes.map(|u| u.map(|x| single(x.parts()))),
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
        let un = [0, 1, 2].map(|i| sign::<S>(&[Term(S::ONE, pick(&self.u, i), e0, e1)]));
        self.normal::<S>(&un) || (0..3).any(|k| (0..3).any(|i| self.edge::<S>(i, k, *pick(&un, i))))
    }

    /// All vertices beyond h_i·|det u|, on either side.
    fn face<S: Scalar>(&self, i: usize, volume: Ordering) -> bool {
        let (i, j, k) = turn(i);
        let (u, v) = (pick(&self.u, j), pick(&self.u, k));
        let [u0, u1, u2] = &self.u;
        [Ordering::Greater, Ordering::Less].into_iter().any(|side| {
            let h = signed(*pick(&self.h, i), volume == side);
            (0..3).all(|k| {
                sign::<S>(&[Term(S::ONE, u, v, pick(&self.t, k)), Term(h, u0, u1, u2)]) == side
            })
        })
    }

    /// n·t_0 beyond Σ h_i·|u_i·n|, on either side.
    fn normal<S: Scalar>(&self, un: &[Ordering; 3]) -> bool {
        let [e0, e1, _] = &self.e;
        [Ordering::Greater, Ordering::Less].into_iter().any(|side| {
            let box_term = |i: usize| {
                Term(signed(*pick(&self.h, i), *pick(un, i) == side), pick(&self.u, i), e0, e1)
            };
            sign::<S>(&[Term(S::ONE, &self.t[0], e0, e1), box_term(0), box_term(1), box_term(2)])
                == side
        })
    }

    /// The interval of the triangle on e_k × u_i beyond the box's, on either side.
    fn edge<S: Scalar>(&self, i: usize, k: usize, un: Ordering) -> bool {
        let (i, j, l) = turn(i);
        let (k, _, opposite) = turn(k);
        let [ui, uj, ul] = [i, j, l].map(|i| pick(&self.u, i));
        let e = pick(&self.e, k);
        // w_l·e and w_j·e
        let along_l = sign::<S>(&[Term(S::ONE, ui, uj, e)]);
        let along_j = sign::<S>(&[Term(S::ONE, ul, ui, e)]);
        [Ordering::Greater, Ordering::Less].into_iter().any(|side| {
            // The end of the interval nearer to the box: p, or that of the vertex
            // opposite, p + u·n.
            let nearer = if un == side.reverse() { opposite } else { k };
            sign::<S>(&[
                Term(S::ONE, ui, e, pick(&self.t, nearer)),
                Term(signed(*pick(&self.h, j), along_l == side), ui, uj, e),
                Term(signed(*pick(&self.h, l), along_j == side), ul, ui, e),
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
        add_scaled_determinant(&mut sum, a, b, c, *factor);
    }
    sum.sign()
}
