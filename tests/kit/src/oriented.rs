//! Triangles against oriented boxes. The oracle transforms the vertices into the box's own
//! coordinates, in integers, and clips there.

use crate::{Each, three};
use dashu_int::IBig;
use septum::relation::Relate;
use septum::{Obb, Triangle, Vec3};

use super::boxes::{BoxSet, ObbNumbers};
use super::contact::truth_of;
use super::exact::{Parts, least_exponent, whole};
use super::flat::Truth;
use super::lattice::{Lattice, Ring, Shapes};
use super::rng::Rng;
use super::sample::Sample;

pub type Point<S> = [S; 3];

/// A triangle, and the centre, axes and half-extents of a box.
#[derive(Clone, Copy, Debug)]
pub struct Oriented<S> {
    pub t: [Point<S>; 3],
    pub center: Point<S>,
    pub axes: [Point<S>; 3],
    pub half: Point<S>,
}

impl<S: Sample> Oriented<S> {
    pub fn triangle(&self) -> Triangle<S> {
        let [a, b, c] = self.t;
        Triangle::new(a, b, c).unwrap()
    }

    pub fn obb(&self) -> Option<Obb<S>> {
        Obb::from_skewed_axes(self.center, self.axes.each(Vec3::from), self.half).ok()
    }

    /// A box of the set, and a triangle with a vertex at a corner of the box, at the midpoint of an
    /// edge or of a face, or at its centre, as near as rounding allows, or anywhere.
    pub fn case(set: BoxSet, rng: &mut Rng) -> Self {
        let ObbNumbers { center, axes, half } = set.obb::<S>(rng);
        let vertex = |rng: &mut Rng| {
            if rng.one_in(2) {
                return set.point(rng);
            }
            let signs = rng.triple(|rng| rng.whole(-1, 1) as f64);
            three(|i: usize| {
                let along = |k: usize| signs[k] * half[k].approximate() * axes[k][i].approximate();
                S::nearest(center[i].approximate() + along(0) + along(1) + along(2))
            })
        };
        let mut t = rng.triple(vertex);
        if rng.one_in(16) {
            t[2] = t[1];
        }
        Self { t, center, axes, half }
    }

    /// Whether the two have a point in common.
    pub fn meets(&self) -> bool {
        Lattice::Wide(self.in_parts().in_box()).meets()
    }

    /// The relation of the two shapes.
    pub fn truth(&self) -> Truth {
        truth_of(self.in_parts().in_box())
    }

    /// Checks verdicts and relation against the oracle, in either order, and returns its answer;
    /// `None` if the numbers are invalid.
    ///
    /// # Panics
    /// If an answer is wrong.
    pub fn check(&self) -> Option<Truth> {
        let [a, b, c] = self.t;
        let (triangle, obb) = (Triangle::new(a, b, c).ok()?, self.obb()?);
        let truth = self.truth();
        let meets = truth != Truth::Apart;
        assert_eq!([triangle.overlaps(&obb), obb.overlaps(&triangle)], [meets; 2], "{self:?}");
        assert!(triangle.may_overlap(&obb) || !meets, "may_overlap: {self:?}");
        let relations = [triangle.relation(&obb), obb.relation(&triangle)];
        assert_eq!(relations, [truth.relation(); 2], "{self:?}");
        Some(truth)
    }

    fn in_parts(&self) -> Oriented<Parts> {
        let parts = |p: Point<S>| p.each(S::mantissa_exponent);
        Oriented {
            t: self.t.each(parts),
            center: parts(self.center),
            axes: self.axes.each(parts),
            half: parts(self.half),
        }
    }
}

impl Oriented<Parts> {
    /// The triangle in the coordinates of the box, in units of the least exponent, and one in that
    /// unit.
    fn in_box(&self) -> Shapes<IBig> {
        let rows = [self.t, self.axes].concat();
        let rows = rows.iter().chain([&self.center, &self.half]);
        let unit = least_exponent(rows.flatten()).min(0);
        let vector = |p: &Point<Parts>| p.each(|x| whole(x, unit));
        let one = IBig::ONE << (-unit) as usize;

        // x = c + Σ s_i·u_i/one has s_i·det = one·w_i·(x − c).
        let [u, v, n] = self.axes.each_ref().each(vector);
        let w = [IBig::cross(&v, &n), IBig::cross(&n, &u), IBig::cross(&u, &v)];
        let det = IBig::dot(&u, &w[0]);
        let center = vector(&self.center);
        let half = vector(&self.half);
        let reach = three(|i: usize| &half[i] * &det * IBig::from(Ring::sign(&det)));
        let vertices = self.t.each_ref().each(|p| {
            let from = IBig::difference(&vector(p), &center);
            three(|i: usize| IBig::dot(&w[i], &from) * &one + &reach[i])
        });
        let extent = reach.each(|r| r * IBig::from(2));
        Shapes { vertices, extent }
    }
}
