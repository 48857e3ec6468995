//! Triangles against oriented boxes: an oracle that takes the vertices into the
//! box's own coordinates, in whole numbers, and clips there.

use dashu_int::IBig;
use septum::{Obb, Triangle, Vec3};

use super::exact::{Parts, least_exponent, whole};
use super::lattice::{Lattice, Ring, Shapes};
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
        Obb::from_skewed_axes(self.center, self.axes.map(Vec3::from), self.half).ok()
    }

    /// Whether the two have a point in common.
    pub fn meets(&self) -> bool {
        let parts = |p: Point<S>| p.map(S::mantissa_exponent);
        Oriented {
            t: self.t.map(parts),
            center: parts(self.center),
            axes: self.axes.map(parts),
            half: parts(self.half),
        }
        .meets_in_parts()
    }
}

impl Oriented<Parts> {
    /// In units of the least exponent, with one in that unit.
    fn meets_in_parts(&self) -> bool {
        let rows = [self.t, self.axes].concat();
        let rows = rows.iter().chain([&self.center, &self.half]);
        let unit = least_exponent(rows.flatten()).min(0);
        let vector = |p: &Point<Parts>| p.map(|x| whole(x, unit));
        let one = IBig::ONE << (-unit) as usize;

        // x = c + Σ s_i·u_i/one has s_i·det = one·w_i·(x − c).
        let [u, v, n] = self.axes.each_ref().map(vector);
        let w = [IBig::cross(&v, &n), IBig::cross(&n, &u), IBig::cross(&u, &v)];
        let det = IBig::dot(&u, &w[0]);
        let center = vector(&self.center);
        let half = vector(&self.half);
        let reach = [0, 1, 2].map(|i: usize| &half[i] * &det * IBig::from(Ring::sign(&det)));
        let vertices = self.t.each_ref().map(|p| {
            let from = IBig::difference(&vector(p), &center);
            [0, 1, 2].map(|i: usize| IBig::dot(&w[i], &from) * &one + &reach[i])
        });
        let extent = reach.map(|r| r * IBig::from(2));
        Lattice::Wide(Shapes { vertices, extent }).meets()
    }
}
