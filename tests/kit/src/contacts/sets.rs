//! Sets of overlapping shapes.

use super::{ContactCase, Solid};
use crate::boxes::{AnyBox, BoxSet, ObbNumbers};
use crate::rng::Rng;
use crate::sample::Sample;
use crate::{Each, case::BoxNumbers, three};

/// A kind of case, with numbers as in the sets of boxes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactSet {
    /// The numbers of this set of boxes.
    Like(BoxSet),
    /// Slivers, exact or nearly.
    Slivers,
    /// Two shapes separated by the crate's translation, rounded, and then moved by at most a unit
    /// in the last place.
    Parted,
    /// An edge of a triangle across an edge of a box, in integers.
    EdgeOnEdge,
    /// Boxes of which one or two half-extents are zero.
    Flat,
    /// Half the range of fixed point from each other, or as far in floats.
    FarOut,
    /// Boxes whose axes are skewed by quarters.
    Skewed,
    /// Triangles that are segments or points.
    Lines,
    /// An overlap below the rounding of the coordinates.
    Barely,
    /// Faces and edges that lie on each other, in one frame.
    Stacked,
}

impl ContactSet {
    pub const ALL: [Self; 14] = [
        Self::Like(BoxSet::Turned),
        Self::Like(BoxSet::NearlyParallel),
        Self::Like(BoxSet::Grid),
        Self::Like(BoxSet::Bits),
        Self::Like(BoxSet::Huge),
        Self::Slivers,
        Self::Parted,
        Self::EdgeOnEdge,
        Self::Flat,
        Self::FarOut,
        Self::Skewed,
        Self::Lines,
        Self::Barely,
        Self::Stacked,
    ];

    pub fn case<S: Sample>(self, rng: &mut Rng) -> ContactCase<S> {
        match self {
            Self::Like(set) => ContactCase { first: solid(set, rng), second: solid(set, rng) },
            Self::Slivers => {
                let (p, q) = (BoxSet::Turned.point::<S>(rng), BoxSet::Turned.point::<S>(rng));
                let t = rng.real(0.0, 1.0);
                let between = three(|i: usize| {
                    let (a, b) = (p[i].approximate(), q[i].approximate());
                    S::nearest(a + t * (b - a)).moved(rng.whole(-3, 3))
                });
                let first = Solid::Triangle([p, q, between]);
                ContactCase { first, second: solid(BoxSet::Turned, rng) }
            }
            Self::Parted => {
                let set = [BoxSet::Turned, BoxSet::NearlyParallel, BoxSet::Grid][rng.below(3)];
                let case = Self::Like(set).case::<S>(rng);
                let Some(Some(found)) = case.contact() else { return case };
                let by = found.translation.vector.to_array();
                let at = |x: S, i: usize| S::nearest(x.approximate() + by[i].approximate());
                let step = rng.triple(|rng| rng.whole(-1, 1));
                let moved = |p: [S; 3]| {
                    three(|i: usize| {
                        // Not from zero to the least number, because the oracles shrink shapes by
                        // more than that.
                        let x = at(p[i], i);
                        if x == S::ZERO { x } else { x.moved(step[i]) }
                    })
                };
                let first = match case.first {
                    Solid::Triangle(t) => Solid::Triangle(t.each(moved)),
                    Solid::Box(AnyBox::Obb(b)) => {
                        let center = moved(b.center);
                        Solid::Box(AnyBox::Obb(ObbNumbers { center, ..b }))
                    }
                    Solid::Box(AnyBox::Aabb(aabb)) => Solid::Box(AnyBox::Aabb(match aabb {
                        BoxNumbers::Center(c, h) => BoxNumbers::Center(moved(c), h),
                        BoxNumbers::Corners(p, q) => BoxNumbers::Corners(moved(p), moved(q)),
                    })),
                };
                ContactCase { first, ..case }
            }
            Self::EdgeOnEdge => {
                let touch = crate::Touch::edge(rng, crate::Touch::bits::<S>().min(12));
                let case = touch.case::<S>(rng.one_in(2));
                let along = touch.normal.each(|n| rng.whole(0, 2) * n.signum());
                let moved = |p: [S; 3]| {
                    three(|i: usize| {
                        S::nearest(p[i].approximate() - S::whole(along[i]).approximate())
                    })
                };
                let first = Solid::Triangle(case.vertices.each(moved));
                ContactCase { first, second: Solid::Box(AnyBox::Aabb(case.aabb)) }
            }
            Self::Flat => {
                let like = [BoxSet::Turned, BoxSet::Grid, BoxSet::NearlyParallel][rng.below(3)];
                let (first, second) = (solid(like, rng), solid(like, rng));
                let mut flat = |solid: Solid<S>| {
                    let axis = rng.below(3);
                    let is_flat = move |i: usize| (i == axis) != (axis == 2);
                    match solid {
                        Solid::Triangle(t) => Solid::Triangle(t),
                        Solid::Box(AnyBox::Obb(mut b)) => {
                            (0..3).filter(|&i| is_flat(i)).for_each(|i| b.half[i] = S::ZERO);
                            Solid::Box(AnyBox::Obb(b))
                        }
                        Solid::Box(AnyBox::Aabb(BoxNumbers::Center(c, mut h))) => {
                            (0..3).filter(|&i| is_flat(i)).for_each(|i| h[i] = S::ZERO);
                            Solid::Box(AnyBox::Aabb(BoxNumbers::Center(c, h)))
                        }
                        Solid::Box(AnyBox::Aabb(BoxNumbers::Corners(p, mut q))) => {
                            (0..3).filter(|&i| is_flat(i)).for_each(|i| q[i] = p[i]);
                            Solid::Box(AnyBox::Aabb(BoxNumbers::Corners(p, q)))
                        }
                    }
                };
                ContactCase { first: flat(first), second: flat(second) }
            }
            Self::FarOut => {
                let end = S::GREATEST.approximate().min(2_f64.powi(40)) / 2.0;
                let far = |rng: &mut Rng| {
                    let whole = rng.whole(-8, 8) as f64 / 8.0;
                    S::nearest(end * if rng.one_in(2) { whole } else { rng.real(-1.0, 1.0) })
                };
                let mut solid = || match rng.below(2) {
                    0 => Solid::Triangle([(); 3].each(|()| rng.triple(far))),
                    _ => {
                        let (p, q) = (rng.triple(far), rng.triple(far));
                        let sorted =
                            |i: usize| if p[i] < q[i] { [p[i], q[i]] } else { [q[i], p[i]] };
                        let rows = three(sorted);
                        let [p, q] = [0, 1].each(|k| rows.each(|row| row[k]));
                        Solid::Box(AnyBox::Aabb(BoxNumbers::Corners(p, q)))
                    }
                };
                ContactCase { first: solid(), second: solid() }
            }
            Self::Skewed => {
                let mut number = |most: i64, unit: f64| {
                    rng.triple(|rng| S::nearest(rng.whole(-most, most) as f64 * unit))
                };
                let mut skewed = || {
                    let half = number(8, 0.25).each(|x| {
                        if x < S::ZERO { S::from_ordinal(x.ordinal().saturating_neg()) } else { x }
                    });
                    let axes = [(); 3].each(|()| number(2, 0.25));
                    Solid::Box(AnyBox::Obb(ObbNumbers { center: number(4, 0.25), axes, half }))
                };
                let first = skewed();
                let second = skewed();
                let like = BoxSet::Grid;
                let second = if rng.one_in(2) { second } else { solid(like, rng) };
                if rng.one_in(2) {
                    ContactCase { first, second }
                } else {
                    ContactCase { first: second, second: first }
                }
            }
            Self::Lines => {
                let (p, d) = (BoxSet::Grid.point::<S>(rng), rng.triple(|rng| rng.whole(-2, 2)));
                let mut at = || {
                    let t = rng.whole(-3, 3);
                    [0, 1, 2]
                        .each(|i: usize| S::nearest(p[i].approximate() + (t * d[i]) as f64 / 2.0))
                };
                let line = Solid::Triangle([at(), at(), at()]);
                let other = solid([BoxSet::Grid, BoxSet::Turned][rng.below(2)], rng);
                if rng.one_in(2) {
                    ContactCase { first: line, second: other }
                } else {
                    ContactCase { first: other, second: line }
                }
            }
            Self::Barely => {
                // The upper face of the one where the lower face of the other is, or next to it.
                let axis = rng.below(3);
                let (mut center, half) = ([S::ZERO; 3], nonzero::<S>(rng));
                let BoxNumbers::Corners(p, q) = corners::<S>(rng) else { unreachable!() };
                for i in 0..3 {
                    let [p, q] = [p[i], q[i]].each(S::approximate);
                    center[i] = S::nearest(rng.real(p - 0.1, q + 0.1));
                }
                let top = q[axis].approximate() + half[axis].approximate();
                center[axis] = S::nearest(top).moved(rng.whole(-1, 1));
                let upper = if rng.one_in(2) {
                    AnyBox::Aabb(BoxNumbers::Center(center, half))
                } else {
                    AnyBox::Obb(ObbNumbers { center, axes: aligned(), half })
                };
                let (lower, upper) =
                    (Solid::Box(AnyBox::Aabb(BoxNumbers::Corners(p, q))), Solid::Box(upper));
                if rng.one_in(2) {
                    ContactCase { first: lower, second: upper }
                } else {
                    ContactCase { first: upper, second: lower }
                }
            }
            Self::Stacked => {
                let (s, c) = [(0.0, 1.0), (0.6, 0.8), (0.28, 0.96)][rng.below(3)];
                let frame = [[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]];
                let turn = rng.below(3);
                let frame =
                    three(|i: usize| three(|j: usize| frame[(i + turn) % 3][(j + turn) % 3]));
                // In quarters along the frame; what is on its lattice.
                let at = |x: [i64; 3]| {
                    three(|i: usize| {
                        S::nearest((0..3).map(|k| x[k] as f64 / 4.0 * frame[k][i]).sum())
                    })
                };
                let mut solid = || {
                    if rng.one_in(3) {
                        let plane = rng.whole(-2, 2);
                        let axis = rng.below(3);
                        return Solid::Triangle([(); 3].each(|()| {
                            let mut x = rng.triple(|rng| rng.whole(-4, 4));
                            x[axis] = plane;
                            at(x)
                        }));
                    }
                    let center = at(rng.triple(|rng| rng.whole(-2, 2)));
                    let half = rng.triple(|rng| S::nearest(rng.whole(1, 3) as f64 / 4.0));
                    if s == 0.0 && rng.one_in(2) {
                        return Solid::Box(AnyBox::Aabb(BoxNumbers::Center(center, half)));
                    }
                    let axes = frame.each(|u| u.each(S::nearest));
                    Solid::Box(AnyBox::Obb(ObbNumbers { center, axes, half }))
                };
                ContactCase { first: solid(), second: solid() }
            }
        }
    }
}

fn aligned<S: Sample>() -> [[S; 3]; 3] {
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].each(|u| u.each(S::nearest))
}

fn nonzero<S: Sample>(rng: &mut Rng) -> [S; 3] {
    rng.triple(|rng| S::nearest(rng.real(0.1, 1.0)))
}

fn corners<S: Sample>(rng: &mut Rng) -> BoxNumbers<S> {
    let (p, q) = (BoxSet::Turned.point::<S>(rng), nonzero::<S>(rng));
    let top = three(|i: usize| S::nearest(p[i].approximate() + q[i].approximate()));
    BoxNumbers::Corners(p, top)
}

fn solid<S: Sample>(set: BoxSet, rng: &mut Rng) -> Solid<S> {
    match rng.below(3) {
        0 => {
            let (a, b) = (set.point(rng), set.point(rng));
            Solid::Triangle([a, b, if rng.one_in(12) { b } else { set.point(rng) }])
        }
        1 => Solid::Box(AnyBox::Aabb(set.aabb(rng))),
        _ => Solid::Box(AnyBox::Obb(set.obb(rng))),
    }
}
