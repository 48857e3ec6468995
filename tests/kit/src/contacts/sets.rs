//! Sets of overlapping shapes.

use super::{ContactCase, Solid};
use crate::boxes::{AnyBox, BoxSet};
use crate::rng::Rng;
use crate::sample::Sample;

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
}

impl ContactSet {
    pub const ALL: [Self; 8] = [
        Self::Like(BoxSet::Turned),
        Self::Like(BoxSet::NearlyParallel),
        Self::Like(BoxSet::Grid),
        Self::Like(BoxSet::Bits),
        Self::Like(BoxSet::Huge),
        Self::Slivers,
        Self::Parted,
        Self::EdgeOnEdge,
    ];

    pub fn case<S: Sample>(self, rng: &mut Rng) -> ContactCase<S> {
        match self {
            Self::Like(set) => ContactCase { first: solid(set, rng), second: solid(set, rng) },
            Self::Slivers => {
                let (p, q) = (BoxSet::Turned.point::<S>(rng), BoxSet::Turned.point::<S>(rng));
                let t = rng.real(0.0, 1.0);
                let between = [0, 1, 2].map(|i: usize| {
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
                    [0, 1, 2].map(|i: usize| {
                        // Not from zero to the least number, because the oracles shrink shapes by
                        // more than that.
                        let x = at(p[i], i);
                        if x == S::ZERO { x } else { x.moved(step[i]) }
                    })
                };
                let first = match case.first {
                    Solid::Triangle(t) => Solid::Triangle(t.map(moved)),
                    Solid::Box(AnyBox::Obb(b)) => {
                        let center = moved(b.center);
                        Solid::Box(AnyBox::Obb(crate::boxes::ObbNumbers { center, ..b }))
                    }
                    Solid::Box(AnyBox::Aabb(aabb)) => Solid::Box(AnyBox::Aabb(match aabb {
                        crate::BoxNumbers::Center(c, h) => crate::BoxNumbers::Center(moved(c), h),
                        crate::BoxNumbers::Corners(p, q) => {
                            crate::BoxNumbers::Corners(moved(p), moved(q))
                        }
                    })),
                };
                ContactCase { first, ..case }
            }
            Self::EdgeOnEdge => {
                let touch = crate::Touch::edge(rng, crate::Touch::bits::<S>().min(12));
                let case = touch.case::<S>(rng.one_in(2));
                let along = touch.normal.map(|n| rng.whole(0, 2) * n.signum());
                let moved = |p: [S; 3]| {
                    [0, 1, 2].map(|i: usize| {
                        S::nearest(p[i].approximate() - S::whole(along[i]).approximate())
                    })
                };
                let first = Solid::Triangle(case.vertices.map(moved));
                ContactCase { first, second: Solid::Box(AnyBox::Aabb(case.aabb)) }
            }
        }
    }
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
