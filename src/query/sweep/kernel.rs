//! A triangle that moves past a box, in any number system. The frame is the box's, which
//! stands still.
//!
//! The triangle sweeps a convex set: the sum of the triangle and the segment d of its motion. That
//! set minus the box is convex too, and its faces decide whether it contains the origin. Two edges
//! of box, triangle and d span each face, so there are 19 axes: the 13 of triangle and box, the
//! cross products of d with the three coordinate axes, and those with the three edges. These axes
//! also suffice for flat boxes, triangles and motions. If a flat box does not meet the triangle,
//! neither does a box that is thicker by a hair; one of the axes separates the thicker box, and
//! with it the flat one.
//!
//! Along an axis the triangle moves by s. Over the whole motion it covers s more: its middle moves
//! by s/2, and its radius grows by |s|/2. The triangle meets the box at the times when none of the
//! 13 axes separates, and these times are an interval. An axis with a gap g at the start stops
//! separating at g/|s|, if ever. The latest of these times is the time of first contact, if there
//! is a contact.

use super::FirstContact;
use super::error_bound::{Along, AtStart, FACE, along, at_start};
use super::latest::{Closing, Closings, Last, Later, Latest, closing_time};
use crate::arithmetic::{
    Arithmetic, Each, Number, cross, dot, following, greatest, least, of_two, once, out_of_line,
    pick,
};
use crate::query::Axis;
use crate::query::relation::{Nearness, Reading, Relation};
use crate::query::triangle_aabb::frame::{Frame, range};
use crate::query::triangle_aabb::kernel::normal;
use crate::robust::Uncertain;
use crate::scalar::Scalar;

/// A triangle in the frame of a box, and its motion d, which is not doubled.
pub(super) struct Course<N: Arithmetic> {
    pub(super) frame: Frame<N>,
    pub(super) d: [N::Length; 3],
}

/// Adds an axis with this middle and this total radius, if it has a direction of its own.
#[inline(always)]
fn axis<T: Number, R: Reading>(so_far: &mut R, is_own: bool, middle: T, radius: T, error: T) {
    so_far.add_if(is_own, middle.magnitude() - radius, radius, error);
}

impl<N: Arithmetic> Course<N> {
    /// Whether the triangle misses the box all the way, if `N` decides it.
    #[inline(always)]
    pub(super) fn misses(&self) -> Option<bool> {
        let faces = self.face(0).or(self.face(1)).or(self.face(2));
        if faces.certain {
            return Some(true);
        }
        let mut so_far = faces;
        self.read_slanted(&mut so_far)?;
        so_far.verdict()
    }

    /// How near the triangle comes to the box on its way: the relation of the box and all that the
    /// triangle sweeps.
    pub(super) fn relation(&self) -> Option<Relation> {
        let mut found = Nearness::NONE;
        for i in 0..3 {
            self.read_face(&mut found, i);
        }
        if !found.is_disjoint {
            self.read_slanted(&mut found)?;
        }
        found.answer(N::CERTAIN)
    }

    /// All axes except the faces.
    #[inline(always)]
    fn read_slanted<R: Reading>(&self, so_far: &mut R) -> Option<()> {
        let Self { frame, d } = self;
        let none = Along { area: Number::ZERO, volume: Number::ZERO };
        let error = if N::LARGE { none } else { along::<N>(frame.size_along(d))? };
        let n = normal(frame);
        let half_way = of_two::<N, _>(dot::<N>(&n, d));
        apart_if_large::<N>(|| self.plane(so_far, &n, half_way, error.volume));
        // Of large numbers one axis after another, until one separates.
        for k in 0..3 {
            if !(N::LARGE && so_far.is_disjoint()) {
                apart_if_large::<N>(|| self.edge(so_far, k, &n, half_way, &error));
            }
        }
        for i in 0..3 {
            if !(N::LARGE && so_far.is_disjoint()) {
                apart_if_large::<N>(|| self.across(so_far, i, error.area));
            }
        }
        Some(())
    }

    /// A face of the box, for the relation.
    #[inline(always)]
    fn read_face(&self, found: &mut Nearness, i: usize) {
        let (Frame { v, h, gaps, .. }, zero) = (&self.frame, N::Length::ZERO);
        let (low, high) = range(v, i);
        let d = once::<N, _>(self.d[i]);
        if N::CERTAIN {
            // Without differences, which might not fit.
            let (low, high) = (low + least(d, zero), high + greatest(d, zero));
            let (min, max) = (-h[i], h[i]);
            let is_touch = (low == max) | (high == min);
            let is_point = (low == high) & (max == zero);
            found.add_known((low > max) | (high < min), is_touch & !is_point);
            return;
        }
        // See `face`. From a gap of any size the triangle enters all of the slab or touches it.
        // Without a gap it is inside already.
        let toward = if low > zero { -d } else { d };
        let rest = Uncertain::not_below(gaps[i] - toward, self.face_error(i));
        let is_flat = (h[i] == zero) & (gaps[i] == zero);
        let is_near = (gaps[i] >= zero) & (rest.possible | is_flat);
        found.add_known(self.face(i).certain, is_near);
    }

    /// A face of the box.
    #[inline(always)]
    fn face(&self, i: usize) -> Uncertain {
        let (Frame { v, h, gaps, .. }, zero) = (&self.frame, N::Length::ZERO);
        let d = once::<N, _>(self.d[i]);
        let (low, high) = range(v, i);
        if N::CERTAIN {
            let is_beyond = (low + least(d, zero) > h[i]) | (high + greatest(d, zero) < -h[i]);
            return Uncertain::known(is_beyond);
        }
        // The gap's sign is certain except at zero (see `Frame`): where there is a gap, its side is
        // known.
        let gap = gaps[i];
        let (is_gap, is_rounded) = (gap > zero, !self.frame.gaps_are_exact & (gap == zero));
        let toward = if low > zero { -d } else { d };
        let left = Uncertain::above(gap - toward, self.face_error(i));
        let is_open = toward <= zero;
        Uncertain {
            certain: is_gap & (is_open | left.certain),
            possible: (is_gap & (is_open | left.possible)) | is_rounded,
        }
    }

    #[inline(always)]
    pub(super) fn face_error(&self, i: usize) -> N::Length {
        let Frame { h, gaps, .. } = &self.frame;
        (gaps[i].magnitude() + h[i] + self.d[i].magnitude()).error(FACE)
    }

    /// The plane of the triangle.
    #[inline(always)]
    fn plane<R: Reading>(
        &self,
        so_far: &mut R,
        n: &[N::Area; 3],
        half_way: N::Volume,
        error: N::Volume,
    ) {
        let Frame { v, e, h, .. } = &self.frame;
        let radius = half_way.magnitude() + reach::<N>(n, h);
        // A triangle in a coordinate plane has a face normal here.
        let zero = N::Length::ZERO;
        let is_flat = |i: usize| (e[0][i] == zero) & (e[1][i] == zero);
        let is_own = !(is_flat(0) | is_flat(1) | is_flat(2));
        axis(so_far, is_own, dot::<N>(n, &v[0]) + half_way, radius, error);
    }

    /// The cross products of an edge with the coordinate axes and with the motion.
    #[inline(always)]
    fn edge<R: Reading>(
        &self,
        so_far: &mut R,
        k: usize,
        n: &[N::Area; 3],
        half_way: N::Volume,
        error: &Along<N>,
    ) {
        let (Frame { h, .. }, d, zero) = (&self.frame, &self.d, N::Length::ZERO);
        let (k, ..) = following::<N>(k);
        let (e, v) = (&self.frame.e[k], &self.frame.v[k]);
        let q = cross::<N>(e, d);
        // If the edge or the motion lies along a coordinate axis, or if both lie in one coordinate
        // plane, another axis has the same direction.
        let along = |x: &[N::Length; 3]| {
            let zeros = x.each(|x| x == zero);
            (zeros[0] & (zeros[1] | zeros[2])) | (zeros[1] & zeros[2])
        };
        let both = |i: usize| (e[i] == zero) & (d[i] == zero);
        let is_known = along(e) | along(d) | both(0) | both(1) | both(2);
        // The axis is perpendicular to the edge and to the motion. It sees the edge as a point and
        // the motion as nothing, and the opposite vertex at the distance that the plane moves.
        axis(
            so_far,
            !is_known,
            dot::<N>(&q, v) - half_way,
            half_way.magnitude() + reach::<N>(&q, h),
            error.volume,
        );

        let p = cross::<N>(e, v);
        for i in 0..3 {
            let (_, j, l) = following::<N>(i);
            let (middle, half_way) = (of_two::<N, _>(n[i]), of_two::<N, _>(q[i]));
            let r = N::area(e[l].magnitude(), h[j]) + N::area(e[j].magnitude(), h[l]);
            let radius = middle.magnitude() + half_way.magnitude() + r;
            let is_own = (e[j] != zero) & (e[l] != zero);
            axis(so_far, is_own, p[i] + middle + half_way, radius, error.area);
        }
    }

    /// The cross product of a coordinate axis and the motion.
    #[inline(always)]
    fn across<R: Reading>(&self, so_far: &mut R, i: usize, error: N::Area) {
        let (_, j, l) = following::<N>(i);
        let (Frame { v, h, .. }, d) = (&self.frame, &self.d);
        let on_axis = |v: &[N::Length; 3]| N::area(d[j], v[l]) - N::area(d[l], v[j]);
        let [a, b, c] = [on_axis(&v[0]), on_axis(&v[1]), on_axis(&v[2])];
        let r = N::area(d[l].magnitude(), h[j]) + N::area(d[j].magnitude(), h[l]);
        let (low, high) = (least(least(a, b), c), greatest(greatest(a, b), c));
        let zero = N::Length::ZERO;
        let is_own = (d[j] != zero) & (d[l] != zero);
        so_far.add_if(is_own, greatest(low, -high) - r, (high - low) + r, error);
    }

    /// When and on which axis the triangle meets the box, if it does and `N` decides it.
    #[inline(always)]
    pub(super) fn first_contact<S: Scalar>(&self) -> Option<FirstContact<S>> {
        let mut latest = Latest::<S>::NONE;
        self.add_closings(&mut latest)?;
        latest.known()
    }

    /// The axis that closes last, if the triangle meets the box and `N` decides it.
    pub(super) fn last(&self) -> Option<Last> {
        let mut later = Later::NONE;
        self.add_closings(&mut later)?;
        later.last()
    }

    #[inline(always)]
    fn add_closings(&self, latest: &mut impl Closings) -> Option<()> {
        let error: AtStart<N> = at_start(self.frame.size_along(&self.d))?;
        for i in 0..3 {
            latest.add(Axis::Face(i as u8), self.closing_face(i));
        }
        let n = normal(&self.frame);
        let plane = || Some(self.closing_plane(&n, &error));
        apart_if_large::<N>(|| latest.add(Axis::Normal, plane()));
        for i in 0..3 {
            for k in 0..3 {
                let (axis, n) = (Axis::Edge { axis: i as u8, edge: k as u8 }, *pick(&n, i));
                apart_if_large::<N>(|| latest.add(axis, self.closing_edge(i, k, n, &error)));
            }
        }
        Some(())
    }

    /// The same, given the axis that closes last.
    #[inline(always)]
    pub(super) fn at_last<S: Scalar>(&self, last: Last) -> Option<FirstContact<S>> {
        let error: AtStart<N> = at_start(self.frame.size_along(&self.d))?;
        let n = || normal(&self.frame);
        last.at(match last.axis {
            Axis::Face(i) => closing_time(self.closing_face(usize::from(i % 3))?),
            Axis::Normal => closing_time(self.closing_plane(&n(), &error)),
            Axis::Edge { axis, edge } => {
                let (i, k) = (usize::from(axis % 3), usize::from(edge % 3));
                closing_time(self.closing_edge(i, k, n()[i], &error)?)
            }
        }?)
    }

    /// The gap on a face at the start and the speed that closes it, each with its error; `None` if
    /// there is certainly no gap.
    #[inline(always)]
    pub(super) fn closing_face(&self, i: usize) -> Option<Closing<N::Length>> {
        let Frame { v, h, gaps, gaps_are_exact, .. } = &self.frame;
        let speed = once::<N, _>(self.d[i]).magnitude();
        let gap = if N::CERTAIN {
            let (low, high) = range(v, i);
            greatest(low, -high) - h[i]
        } else {
            gaps[i]
        };
        // The sign of a gap that is not zero is right.
        let is_known = N::CERTAIN | gaps_are_exact | (gap < N::Length::ZERO);
        let is_none = is_known & (gap <= N::Length::ZERO);
        let closing = || [[gap, self.face_error(i)], [speed, speed.error(2)]];
        if is_none { None } else { Some(closing()) }
    }

    /// The same on the normal of the triangle.
    #[inline(always)]
    pub(super) fn closing_plane(&self, n: &[N::Area; 3], error: &AtStart<N>) -> Closing<N::Volume> {
        let Frame { v, h, .. } = &self.frame;
        let gap = dot::<N>(n, &v[0]).magnitude() - reach::<N>(n, h);
        let speed = once::<N, _>(dot::<N>(n, &self.d)).magnitude();
        [[gap, error.gap.plane], [speed, error.volume_speed]]
    }

    /// The same on the cross product of coordinate axis `i` and edge `k`, given component `i` of the
    /// normal; `None` if that is a face normal, which comes first in the order.
    #[inline(always)]
    pub(super) fn closing_edge(
        &self,
        i: usize,
        k: usize,
        n: N::Area,
        error: &AtStart<N>,
    ) -> Option<Closing<N::Area>> {
        let ((_, j, l), (k, ..)) = (following::<N>(i), following::<N>(k));
        let (e, v, h, d) = (&self.frame.e[k], &self.frame.v[k], &self.frame.h, &self.d);
        if (e[j] == N::Length::ZERO) | (e[l] == N::Length::ZERO) {
            return None;
        }
        let p = N::area(e[j], v[l]) - N::area(e[l], v[j]);
        let r = N::area(e[l].magnitude(), h[j]) + N::area(e[j].magnitude(), h[l]);
        let middle = of_two::<N, _>(n);
        let gap = (p + middle).magnitude() - (middle.magnitude() + r);
        let speed = once::<N, _>(N::area(e[j], d[l]) - N::area(e[l], d[j])).magnitude();
        Some([[gap, error.gap.edge], [speed, error.area_speed]])
    }
}

/// A call, if numbers are large.
#[inline(always)]
fn apart_if_large<N: Arithmetic>(f: impl FnOnce()) {
    if N::LARGE { out_of_line(f) } else { f() }
}

/// How far a box reaches along a vector.
#[inline(always)]
fn reach<N: Arithmetic>(n: &[N::Area; 3], h: &[N::Length; 3]) -> N::Volume {
    dot::<N>(&[n[0].magnitude(), n[1].magnitude(), n[2].magnitude()], h)
}
