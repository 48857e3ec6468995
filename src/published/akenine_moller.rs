//! Triangle against axis-aligned box as published in 2001: its arithmetic, its 13 axes, its
//! interval tests.
//!
//! T. Akenine-Möller, "Fast 3D Triangle-Box Overlap Testing", *Journal of Graphics Tools* 6(1),
//! 2001. Written from the paper. Other tests measure their speed against it, and it shows what
//! rounding does.

use super::rounded;
use crate::arithmetic::{Each, Number, Rounded, cross3, dot3, greatest, least, minus3};
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Obb, Triangle, Vec3};

/// The order in which the three groups of axes are tested.
///
/// The paper calls the groups bullets: 1, the box's face normals; 2, the triangle's normal; 3, the
/// nine cross products. It found the order 3-1-2 fastest on one machine, and no difference on
/// another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Order {
    /// Cross products, faces, normal: the paper's choice.
    #[default]
    EdgesFacesNormal,
    /// Cross products, normal, faces.
    EdgesNormalFaces,
    /// Faces, cross products, normal.
    FacesEdgesNormal,
    /// Faces, normal, cross products.
    FacesNormalEdges,
    /// Normal, cross products, faces.
    NormalEdgesFaces,
    /// Normal, faces, cross products.
    NormalFacesEdges,
}

/// Does the triangle overlap the box, by the test of 2001? In the scalar's own arithmetic and the
/// paper's order of axes, and sometimes wrong.
///
/// *Numerics*: in `f32` it misses about 3 of 100 slivers. In fixed point, products lose their last
/// bits and wrap around outside the range. A box given by its corners is first converted to centre
/// and half-extents, rounded.
///
/// *Panics*: never. *Cost*: up to 66 multiplications, 13 early exits.
///
/// *Source*: Akenine-Möller 2001, section 2.
#[inline]
pub fn overlaps<S: Scalar>(triangle: &Triangle<S>, aabb: &Aabb<S>) -> bool {
    overlaps_in(triangle, aabb, Order::default())
}

/// Does the triangle overlap the box, by [`overlaps`] with the groups of axes in another order?
// Always inlined, so that the order is a constant: deciding it at run time costs a quarter of the
// time.
#[inline(always)]
#[must_use]
pub fn overlaps_in<S: Scalar>(triangle: &Triangle<S>, aabb: &Aabb<S>, order: Order) -> bool {
    let (center, h) = match aabb.form() {
        AabbForm::Center { center, half } => (center.to_array(), half.to_array()),
        AabbForm::Corners { min, max } => {
            let center = |a: S, b: S| a.plain_add(b).plain_half();
            let half = |a: S, b: S| b.plain_sub(a).plain_half();
            (
                [center(min.x, max.x), center(min.y, max.y), center(min.z, max.z)],
                [half(min.x, max.x), half(min.y, max.y), half(min.z, max.z)],
            )
        }
    };
    let p = Published::new(&triangle.points(), rounded(center), rounded(h));
    !match order {
        Order::EdgesFacesNormal => p.edges() || p.faces() || p.normal(),
        Order::EdgesNormalFaces => p.edges() || p.normal() || p.faces(),
        Order::FacesEdgesNormal => p.faces() || p.edges() || p.normal(),
        Order::FacesNormalEdges => p.faces() || p.normal() || p.edges(),
        Order::NormalEdgesFaces => p.normal() || p.edges() || p.faces(),
        Order::NormalFacesEdges => p.normal() || p.faces() || p.edges(),
    }
}

/// Does the triangle overlap the oriented box, by the test of 2001? In the scalar's own arithmetic,
/// and sometimes wrong.
///
/// The triangle is transformed into the box's frame and tested there against an axis-aligned box.
/// Every step is rounded.
///
/// *Geometry*: the inverse of a rotation is its transpose, so the axes must be orthonormal. Their
/// deviation adds to the rounding.
///
/// *Numerics*: see [`overlaps`].
///
/// *Panics*: never. *Cost*: 27 multiplications and the test.
///
/// *Source*: Akenine-Möller 2001, section 2.
pub fn overlaps_obb<S: Scalar>(triangle: &Triangle<S>, obb: &Obb<S>) -> bool {
    let center = obb.center().to_array();
    let into = |p: [S; 3]| {
        let d = [0, 1, 2].each(|i: usize| Rounded(p[i]) - Rounded(center[i]));
        obb.axes().each(|axis| {
            let [x, y, z] = axis.to_array().each(Rounded);
            (x * d[0] + y * d[1] + z * d[2]).0
        })
    };
    let [a, b, c] = triangle.points().each(into).each(Vec3::from);
    let aabb = Aabb::about_origin(obb.half_extents());
    overlaps(&Triangle::unchecked([a, b, c]), &aabb)
}

/// The triangle with the box's centre at the origin. Each method is one bullet of the paper and
/// returns whether one of its axes separates.
struct Published<S> {
    v: [[Rounded<S>; 3]; 3],
    e: [[Rounded<S>; 3]; 3],
    h: [Rounded<S>; 3],
}

impl<S: Scalar> Published<S> {
    #[inline(always)]
    fn new(points: &[[S; 3]; 3], center: [Rounded<S>; 3], h: [Rounded<S>; 3]) -> Self {
        let from = |p: [S; 3]| minus3(&rounded(p), &center);
        let v = [from(points[0]), from(points[1]), from(points[2])];
        Self { v, e: [minus3(&v[1], &v[0]), minus3(&v[2], &v[1]), minus3(&v[0], &v[2])], h }
    }

    /// Bullet 1: the minimal box around the triangle against the box.
    #[inline(always)]
    fn faces(&self) -> bool {
        let [a, b, c] = &self.v;
        (0..3).any(|i| {
            least(least(a[i], b[i]), c[i]) > self.h[i]
                || greatest(greatest(a[i], b[i]), c[i]) < -self.h[i]
        })
    }

    /// Bullet 2: the triangle's plane against the diagonal of the box that is closest to its
    /// normal.
    #[inline(always)]
    fn normal(&self) -> bool {
        let n = cross3(&self.e[0], &self.e[1]);
        let zero = Rounded::ZERO;
        // From vertex 0, which lies in the plane, to the corner against n or along n.
        let corner = |along: bool| {
            let from_vertex = |i: usize| {
                let side = if (n[i] > zero) == along { self.h[i] } else { -self.h[i] };
                side - self.v[0][i]
            };
            [from_vertex(0), from_vertex(1), from_vertex(2)]
        };
        dot3(&n, &corner(false)) > zero || dot3(&n, &corner(true)) < zero
    }

    /// Bullet 3: nine cross products. Two of the three vertices project to the same point, so two
    /// projections give the interval.
    #[inline(always)]
    fn edges(&self) -> bool {
        // No closures here: whether the compiler inlines them depends on the rest of the program,
        // and that was worth a quarter of the time.
        for k in 0..3 {
            if self.edge(0, k) || self.edge(1, k) || self.edge(2, k) {
                return true;
            }
        }
        false
    }

    #[inline(always)]
    fn edge(&self, i: usize, k: usize) -> bool {
        let (j, l) = ((i + 1) % 3, (i + 2) % 3);
        let e = &self.e[k];
        let on = |v: &[Rounded<S>; 3]| e[j] * v[l] - e[l] * v[j];
        let (p, q) = (on(&self.v[k]), on(&self.v[(k + 2) % 3]));
        let r = e[l].magnitude() * self.h[j] + e[j].magnitude() * self.h[l];
        least(p, q) > r || greatest(p, q) < -r
    }
}
