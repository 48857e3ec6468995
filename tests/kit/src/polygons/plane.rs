//! Exactly planar convex polygons, clipped as a whole.

use dashu_int::IBig;

use super::PolygonCase;
use crate::oracle::{clip, closed};
use crate::rng::Rng;
use crate::sample::Sample;
use crate::{Each, case::BoxNumbers, three};

type Whole = [i64; 3];

/// The points o + a·u + b·v for the corners (a, b) of a convex polygon, and a box. A corner may lie
/// between its neighbours.
pub struct PlanePolygon {
    corners: Vec<[i64; 2]>,
    o: Whole,
    u: Whole,
    v: Whole,
    center: Whole,
    half: Whole,
}

impl PlanePolygon {
    /// All numbers with as many bits as the scalar has, or fewer.
    pub fn random<S: Sample>(rng: &mut Rng) -> Self {
        // Three products of a 3-bit number and another number, and a sum of two.
        let bits = rng.whole(1, i64::from(S::WHOLE_BITS.min(40)) - 6) as u32;
        let mut vector = |bits: u32| rng.triple(|rng| rng.whole(-1 << bits, 1 << bits));
        let (mut o, u, v, mut w) = (vector(bits), vector(bits), vector(bits), vector(bits));
        // Sometimes in one plane with a face of the box.
        if rng.one_in(4) {
            w[rng.below(3)] = 0;
        }
        let corners = corners(rng);
        // The box lies around a point of the plane, or around a corner.
        let [a, b] = if rng.one_in(2) { corners[0] } else { [rng.whole(0, 7), rng.whole(0, 7)] };
        let half = w.each(i64::abs);
        let center = if rng.one_in(2) {
            three(|i: usize| o[i] + a * u[i] + b * v[i])
        } else {
            // This point is on one of the box's faces, edges or corners.
            three(|i: usize| o[i] + a * u[i] + b * v[i] + rng.whole(-1, 1) * half[i])
        };
        // Around the origin, so that all numbers fit.
        for i in 0..3 {
            o[i] -= center[i];
        }
        let offset = rng.triple(|rng| rng.whole(-1 << bits, 1 << bits));
        let o = three(|i: usize| o[i] + offset[i]);
        Self { corners, o, u, v, center: offset, half }
    }

    /// The same case in the scalar.
    pub fn case<S: Sample>(&self, by_center: bool) -> PolygonCase<S> {
        let Self { o, u, v, center, half, .. } = self;
        let at = |&[a, b]: &[i64; 2]| three(|i| S::whole(o[i] + a * u[i] + b * v[i]));
        let corner = |sign: i64| three(|i| S::whole(center[i] + sign * half[i]));
        let aabb = if by_center {
            BoxNumbers::Center(center.each(S::whole), half.each(S::whole))
        } else {
            BoxNumbers::Corners(corner(-1), corner(1))
        };
        PolygonCase { vertices: self.corners.iter().map(at).collect(), aabb }
    }

    /// Whether clipping the polygon by the six half-spaces of the box leaves a point.
    pub fn meets(&self) -> bool {
        let big = |x: [i64; 3]| x.each(IBig::from);
        let mut cycle = closed(self.corners.iter().map(|&[a, b]| big([a, b, 1])).collect());
        for i in 0..3 {
            let from_center = self.o[i] - self.center[i];
            for sign in [-1, 1] {
                let form = [sign * self.u[i], sign * self.v[i], self.half[i] + sign * from_center];
                cycle = clip(&cycle, &big(form));
            }
        }
        !cycle.is_empty()
    }
}

/// The corners of a convex polygon with coordinates from 0 to 7, in either orientation, starting
/// anywhere.
fn corners(rng: &mut Rng) -> Vec<[i64; 2]> {
    loop {
        let mut points: Vec<_> =
            (0..3 + rng.below(9)).map(|_| [rng.whole(0, 7), rng.whole(0, 7)]).collect();
        points.sort_unstable();
        points.dedup();
        // Both chains (A. M. Andrew, "Another efficient algorithm for convex hulls in two
        // dimensions", *Information Processing Letters* 9(5), 1979). Points on a side stay.
        let mut cycle = chain(points.iter());
        cycle.pop();
        let upper = chain(points.iter().rev());
        // All points on one line: the upper chain repeats the lower one.
        if upper.len() == points.len() && cycle.len() + 1 == points.len() {
            continue;
        }
        cycle.extend(&upper[..upper.len() - 1]);
        if rng.one_in(2) {
            cycle.reverse();
        }
        let from = rng.below(cycle.len());
        cycle.rotate_left(from);
        return cycle;
    }
}

fn chain<'a>(points: impl Iterator<Item = &'a [i64; 2]>) -> Vec<[i64; 2]> {
    let mut chain: Vec<[i64; 2]> = Vec::new();
    for &p in points {
        while let [.., a, b] = chain.as_slice() {
            if (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) >= 0 {
                break;
            }
            chain.pop();
        }
        chain.push(p);
    }
    chain
}
