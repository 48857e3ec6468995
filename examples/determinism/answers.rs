//! Hashes of answers.

use septum::lanes::{Hits, Ranges};
use septum::relation::Relation;
use septum::sweep::FirstContact;
use septum::{Axis, Crossing, Facing, Feature, HasAxes, Hit, Segment, Vec3};

use super::super::draw::Draw;
use super::queries::Query;

/// The destination of answers.
pub(crate) trait Answers {
    /// The hash for the answers to a query.
    fn to(&mut self, query: Query) -> &mut Hash;
}

/// FNV-1a, 64 bits (Fowler, Noll, Vo).
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct Hash(pub(crate) u64);

impl Hash {
    /// The hash of nothing.
    pub(crate) const EMPTY: Self = Self(0xcbf2_9ce4_8422_2325);

    pub(crate) fn byte(&mut self, byte: u8) {
        self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    }

    pub(crate) fn yes(&mut self, answer: bool) {
        self.byte(answer.into());
    }

    pub(crate) fn relation(&mut self, relation: Relation) {
        self.byte(match relation {
            Relation::Disjoint => 0,
            Relation::Touching => 1,
            Relation::Overlapping => 2,
        });
    }

    pub(crate) fn number<S: Draw>(&mut self, x: S) {
        x.bits().to_le_bytes().into_iter().for_each(|byte| self.byte(byte));
    }

    pub(crate) fn maybe<S: Draw>(&mut self, x: Option<S>) {
        self.yes(x.is_some());
        x.into_iter().for_each(|x| self.number(x));
    }

    pub(crate) fn vector<S: Draw>(&mut self, vector: Option<Vec3<S>>) {
        self.yes(vector.is_some());
        if let Some(Vec3 { x, y, z }) = vector {
            [x, y, z].into_iter().for_each(|x| self.number(x));
        }
    }

    pub(crate) fn range<S: Draw>(&mut self, range: Option<(S, S)>) {
        self.yes(range.is_some());
        if let Some((from, to)) = range {
            self.number(from);
            self.number(to);
        }
    }

    pub(crate) fn segment<S: Draw>(&mut self, segment: Option<Segment<S>>) {
        let ends = segment.and_then(|segment| segment.ends());
        self.vector(ends.map(|(from, _)| from));
        self.vector(ends.map(|(_, to)| to));
    }

    pub(crate) fn crossings<S: Draw>(
        &mut self,
        found: Option<[Crossing<S>; 2]>,
        shape: &impl HasAxes<S>,
    ) {
        self.yes(found.is_some());
        for crossing in found.iter().flatten() {
            self.number(crossing.t);
            self.byte(crossing.face.unwrap_or(0xff));
            self.vector(crossing.normal(shape));
        }
    }

    pub(crate) fn contact<S: Draw>(&mut self, first: Option<FirstContact<S>>) {
        self.yes(first.is_some());
        if let Some(FirstContact { t, axis }) = first {
            self.number(t);
            self.axis(axis);
        }
    }

    /// Hashes a set of numbers below 32.
    pub(crate) fn set(&mut self, of: impl Iterator<Item = usize>) {
        let mask = of.fold(0_u32, |mask, i| mask ^ 1 << (i % 32));
        mask.to_le_bytes().into_iter().for_each(|byte| self.byte(byte));
    }

    pub(crate) fn axis(&mut self, axis: Option<Axis>) {
        self.byte(match axis {
            None => 0,
            Some(Axis::Face(i)) => 1 + i,
            Some(Axis::Normal) => 4,
            Some(Axis::Edge { axis, edge }) => 5 + 3 * axis + edge,
        });
    }

    pub(crate) fn hit<S: Draw>(&mut self, hit: Option<Hit<S>>) {
        let Some(hit) = hit else { return self.byte(0) };
        self.byte(match hit.facing {
            Facing::Front => 1,
            Facing::Back => 2,
        });
        self.byte(match hit.feature {
            Feature::Interior => 0,
            Feature::Edge(k) => 1 + k,
            Feature::Vertex(k) => 4 + k,
        });
        self.number(hit.t);
        self.number(hit.u);
        self.number(hit.v);
    }
}

/// The answers of four lanes.
impl Hash {
    pub(crate) fn hits<S: Draw>(&mut self, hits: &Hits<S, 4>) {
        (0..4).for_each(|k| self.hit(hits.get(k)));
    }

    pub(crate) fn verdicts(&mut self, overlaps: [bool; 4]) {
        overlaps.into_iter().for_each(|overlaps| self.yes(overlaps));
    }

    pub(crate) fn ranges<S: Draw>(&mut self, ranges: &Ranges<S, 4>) {
        (0..4).for_each(|k| self.range(ranges.get(k)));
    }
}
