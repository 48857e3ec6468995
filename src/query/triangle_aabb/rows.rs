//! The kernel in floats: the same 13 axes, with x, y and z of a point side by side.
//!
//! The cross product of two rows takes one turn of each, a × b = turned(a·turned(b) −
//! turned(a)·b), and comes out as (z, x, y) before the last turn. So do radii. All nine
//! edge axes stay as they come out, and nothing is ever transposed: one row is the three
//! axes of an edge.

use super::error_bound::error_bound;
use crate::arithmetic::{Filtered, Float, InFloat, Number, Quad, THREE, greatest};
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Triangle, Vec3};

mod zeros;

/// What of a triangle is the same for every box.
#[derive(Clone, Copy, Debug)]
pub(in crate::query) struct Rows<Q> {
    /// The vertices.
    pub(in crate::query) v: [Q; 3],
    /// The least and the greatest of their coordinates.
    pub(in crate::query) low: Q,
    pub(in crate::query) high: Q,
    /// The edges, each from a vertex to the next.
    pub(in crate::query) e: [Edge<Q>; 3],
    /// The normal.
    pub(in crate::query) n: Q,
    /// Half the normal, as products come out.
    pub(in crate::query) middle: Q,
}

#[derive(Clone, Copy, Debug)]
pub(in crate::query) struct Edge<Q> {
    pub(in crate::query) e: Q,
    pub(in crate::query) turned: Q,
}

impl<Q: Quad> Edge<Q> {
    #[inline(always)]
    pub(in crate::query) fn new(e: Q) -> Self {
        Self { e, turned: e.turned() }
    }
}

/// Whether one of the 13 axes separates, if floats can tell.
#[inline(always)]
pub(super) fn pair<S: Scalar + InFloat<F>, F: Float>(
    triangle: &Triangle<S>,
    aabb: &Aabb<S>,
) -> Option<bool> {
    let apart = match *aabb.form() {
        AabbForm::Center { center: c, half: h } => {
            by_center::<S, F>(triangle, c.x, c.y, c.z, h.x, h.y, h.z)
        }
        AabbForm::Corners { min: a, max: b } => {
            by_corners::<S, F>(triangle, a.x, a.y, a.z, b.x, b.y, b.z)
        }
    };
    match apart {
        Apart::Yes => Some(true),
        Apart::No => Some(false),
        Apart::Unknown => None,
        Apart::UnlessByRounding => {
            // A copy, for the reason that `overlaps` gives.
            let copy = *aabb;
            zeros::is_on_grid::<S, F>(triangle, &copy).then_some(false)
        }
        Apart::UnlessByGap => match *aabb.form() {
            AabbForm::Center { center, half } => {
                zeros::gaps_are_exact::<S, F>(triangle, &center, &half).then_some(false)
            }
            AabbForm::Corners { .. } => Some(false),
        },
    }
}

#[allow(clippy::too_many_arguments)] // each in a register
#[inline(never)]
fn by_center<S: Scalar + InFloat<F>, F: Float>(
    triangle: &Triangle<S>,
    cx: S,
    cy: S,
    cz: S,
    hx: S,
    hy: S,
    hz: S,
) -> Apart {
    let (center, half) = (row(&Vec3::new(cx, cy, cz)), row(&Vec3::new(hx, hy, hz)));
    rows::<S, F::Quad>(triangle).apart_by_center(S::LIMIT, center, half)
}

#[allow(clippy::too_many_arguments)] // each in a register
#[inline(never)]
fn by_corners<S: Scalar + InFloat<F>, F: Float>(
    triangle: &Triangle<S>,
    ax: S,
    ay: S,
    az: S,
    bx: S,
    by: S,
    bz: S,
) -> Apart {
    let (min, max) = (row(&Vec3::new(ax, ay, az)), row(&Vec3::new(bx, by, bz)));
    rows::<S, F::Quad>(triangle).apart_by_corners(S::LIMIT, min, max)
}

#[inline(always)]
pub(in crate::query) fn row<S: InFloat<Q::Lane>, Q: Quad>(v: &Vec3<S>) -> Q {
    Q::of_three([v.x.in_float(), v.y.in_float(), v.z.in_float()])
}

#[inline(always)]
fn rows<S: Scalar + InFloat<Q::Lane>, Q: Quad<Lane: Float>>(triangle: &Triangle<S>) -> Rows<Q> {
    Rows::of(triangle)
}

/// Whether an axis separates.
#[derive(Clone, Copy)]
pub(super) enum Apart {
    Yes,
    No,
    /// No, if nothing was rounded.
    UnlessByRounding,
    /// No, if a gap of zero is one indeed and not a rounded one.
    UnlessByGap,
    /// Floats cannot say.
    Unknown,
}

impl<Q: Quad<Lane: Float>> Rows<Q> {
    #[inline(always)]
    pub(in crate::query) fn of<S: Scalar + InFloat<Q::Lane>>(triangle: &Triangle<S>) -> Self {
        let [a, b, c] = triangle.vertices();
        let point = |v: &Vec3<S>| [v.x.in_float(), v.y.in_float(), v.z.in_float()];
        Self::new([point(a), point(b), point(c)])
    }

    #[inline(always)]
    pub(super) fn new([[px, py, pz], [qx, qy, qz], [rx, ry, rz]]: [[Q::Lane; 3]; 3]) -> Self {
        // Four at a time, as they lie in memory; the last has no one behind it.
        let before = Q::new([qz, rx, ry, rz]).to_array();
        let v = [
            Q::new([px, py, pz, qx]),
            Q::new([qx, qy, qz, rx]),
            Q::new([before[1], before[2], before[3], before[3]]),
        ];
        let e = [Edge::new(v[1] - v[0]), Edge::new(v[2] - v[1]), Edge::new(v[0] - v[2])];
        let product = e[0].e * e[1].turned - e[0].turned * e[1].e;
        Self {
            v,
            low: v[0].least(v[1]).least(v[2]),
            high: v[0].greatest(v[1]).greatest(v[2]),
            e,
            n: product.turned(),
            middle: half_of(product),
        }
    }

    /// Whether none of the coordinates was rounded when it became a float.
    #[inline(always)]
    pub(in crate::query) fn are_within(&self, limit: Option<Q::Lane>, p: Q, q: Q) -> bool {
        let Some(limit) = limit else { return true };
        let most = self.low.magnitude().greatest(self.high.magnitude());
        let most = most.greatest(p.magnitude()).greatest(q.magnitude());
        Q::splat(limit).exceeds(most) & THREE == THREE
    }

    /// Whether an axis separates the triangle from the box with this centre and these
    /// half-extents, if that is certain. From `limit` on a coordinate may have been rounded.
    #[inline(always)]
    pub(super) fn apart_by_center(&self, limit: Option<Q::Lane>, center: Q, half: Q) -> Apart {
        if !self.are_within(limit, center, half) {
            return Apart::Unknown;
        }
        let (low, high) = (self.low - center, self.high - center);
        let minus = Q::splat(Q::Lane::ZERO) - half;
        if (low.exceeds(half) | minus.exceeds(high)) & THREE != 0 {
            return Apart::Yes;
        }
        // A gap of zero may be a rounded one. The sign of any other is right: rounding
        // keeps order.
        let meets = half.exceeds(low) & high.exceeds(minus) & THREE == THREE;
        let v = [self.v[0] - center, self.v[1] - center, self.v[2] - center];
        self.apart_in_frame(v, half, high - low, meets)
    }

    /// The same for the box with these corners.
    #[inline(always)]
    pub(super) fn apart_by_corners(&self, limit: Option<Q::Lane>, min: Q, max: Q) -> Apart {
        if !self.are_within(limit, min, max) {
            return Apart::Unknown;
        }
        if (self.low.exceeds(max) | min.exceeds(self.high)) & THREE != 0 {
            return Apart::Yes;
        }
        // Not v − (min + max)/2: the sum rounds by the distance from the origin, the
        // differences only by the distance from the box.
        let [a, b, c] = self.v;
        let from = |v: Q| half_of((v - min) + (v - max));
        self.apart_in_frame(
            [from(a), from(b), from(c)],
            half_of(max - min),
            self.high - self.low,
            true,
        )
    }

    /// Whether the normal or an edge axis separates, in the frame of the box. `meets` says
    /// that no face does.
    #[inline(always)]
    fn apart_in_frame(&self, v: [Q; 3], half: Q, extent: Q, meets: bool) -> Apart {
        let Some(bound) = error_bound::<Filtered<Q::Lane>>(size(half, extent)) else {
            return Apart::Unknown;
        };

        // The plane of the triangle first: of most boxes near a triangle it is the plane
        // that misses them.
        let distance = sum(self.n * v[0]).magnitude();
        let beyond_plane = distance - sum(self.n.magnitude() * half);
        if beyond_plane > bound.plane {
            return Apart::Yes;
        }

        let (radius, half_turned) = (self.middle.magnitude(), half.turned());
        let beyond = |k: usize| {
            let Edge { e, turned } = self.e[k];
            let p = e * v[k].turned() - turned * v[k];
            let r = half * turned.magnitude() + half_turned * e.magnitude();
            (p + self.middle).magnitude() - (radius + r)
        };
        let beyond = [beyond(0), beyond(1), beyond(2)];
        let most = beyond[0].greatest(beyond[1]).greatest(beyond[2]);
        if most.exceeds(Q::splat(bound.edge)) & THREE != 0 {
            return Apart::Yes;
        }

        // What else may separate? An axis that is along a face normal, or zero, separates only
        // if that face does: so of a triangle that lies along a coordinate plane, and of an
        // edge that does. Without this every box-shaped mesh would be in doubt.
        let mut doubt =
            beyond_plane >= -bound.plane && self.high.exceeds(self.low) & THREE == THREE;
        let least = Q::splat(-bound.edge);
        if most.exceeds(least) & THREE != 0 {
            let zero = Q::splat(Q::Lane::ZERO);
            let may_separate = |k: usize| {
                let Edge { e, turned } = self.e[k];
                let is_slanted = e.magnitude().exceeds(zero) & turned.magnitude().exceeds(zero);
                beyond[k].exceeds(least) & is_slanted
            };
            doubt |= (may_separate(0) | may_separate(1) | may_separate(2)) & THREE != 0;
        }
        if doubt {
            let seems_apart =
                most.exceeds(Q::splat(Q::Lane::ZERO)) & THREE != 0 || beyond_plane > Q::Lane::ZERO;
            // "Yes" would be as sure on a grid, but not every machine has this kernel, and
            // `may_overlap` is the same on all.
            if seems_apart { Apart::Unknown } else { Apart::UnlessByRounding }
        } else if meets {
            Apart::No
        } else {
            Apart::UnlessByGap
        }
    }
}

/// No coordinate in the frame of the box exceeds this, if no face separates; nor does an
/// edge, nor a half-extent.
#[inline(always)]
pub(in crate::query) fn size<Q: Quad>(half: Q, extent: Q) -> Q::Lane {
    let [x, y, z] = (half + extent).three();
    greatest(greatest(x, y), z)
}

#[inline(always)]
pub(in crate::query) fn half_of<Q: Quad<Lane: Float>>(x: Q) -> Q {
    x * Q::splat(Q::Lane::HALF)
}

/// The sum of the first three, in order.
#[inline(always)]
pub(in crate::query) fn sum<Q: Quad>(row: Q) -> Q::Lane {
    let [x, y, z] = row.three();
    x + y + z
}
