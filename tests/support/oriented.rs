//! Triangles against oriented boxes: an oracle that takes the vertices into the
//! box's own coordinates, in whole numbers, and clips there.

use dashu_int::IBig;
use septum::{Obb, Triangle, Vec3};

use super::lattice::{Lattice, Ring, Shapes};
use super::scalar::Sample;

pub(crate) type Point<S> = [S; 3];

/// A triangle, and the centre, axes and half-extents of a box.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Oriented<S> {
    pub(crate) t: [Point<S>; 3],
    pub(crate) center: Point<S>,
    pub(crate) axes: [Point<S>; 3],
    pub(crate) half: Point<S>,
}

impl<S: Sample> Oriented<S> {
    pub(crate) fn triangle(&self) -> Triangle<S> {
        let [a, b, c] = self.t;
        Triangle::new(a, b, c).unwrap()
    }

    pub(crate) fn obb(&self) -> Option<Obb<S>> {
        Obb::from_skewed_axes(self.center, self.axes.map(Vec3::from), self.half).ok()
    }

    /// Whether the two have a point in common. In units of the least exponent, with one in that unit.
    pub(crate) fn meets(&self) -> bool {
        let rows = [self.t, self.axes].concat();
        let rows = || rows.iter().chain([&self.center, &self.half]).flatten();
        let parts = rows().map(|x| x.mantissa_exponent());
        let unit = parts.filter(|x| x.0 != 0).map(|x| x.1).min().unwrap_or(0).min(0);
        let whole = |x: &S| {
            let (m, e) = x.mantissa_exponent();
            if m == 0 { IBig::ZERO } else { IBig::from(m) << (e - unit) as usize }
        };
        let vector = |p: &Point<S>| p.each_ref().map(whole);
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
