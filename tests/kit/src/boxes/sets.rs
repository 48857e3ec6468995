//! Sets of boxes and oriented boxes.

use super::{AnyBox, BoxCase, ObbNumbers, Point};
use crate::rng::Rng;
use crate::sample::Sample;
use crate::{Each, case::BoxNumbers, three};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoxSet {
    /// Random rotations.
    Turned,
    /// Slight rotations, for nearly parallel axes.
    NearlyParallel,
    /// Integers, with axes parallel to the coordinate axes or diagonal: contact of every kind.
    Grid,
    /// Any bits.
    Bits,
    /// At the ends of the type.
    Huge,
    /// Turned about an axis of space, often by quarter turns in floats, and tilted by 1e-3 to
    /// 1e-31: axes parallel but for a residue. Boxes overlap, or stand on each other as rounded.
    Residue,
}

impl BoxSet {
    pub const ALL: [Self; 5] =
        [Self::Turned, Self::NearlyParallel, Self::Grid, Self::Bits, Self::Huge];

    pub fn case<S: Sample>(self, rng: &mut Rng) -> BoxCase<S> {
        let mut second: ObbNumbers<S> = self.obb(rng);
        let first = match rng.below(3) {
            0 => AnyBox::Aabb(self.aabb(rng)),
            _ => AnyBox::Obb(self.obb(rng)),
        };
        if self == Self::Residue && rng.one_in(2) {
            // Next to each other along an axis of space.
            let (i, sum) =
                (rng.below(3), |x: S, y: S| S::nearest(x.approximate() + y.approximate()));
            let top = match first {
                AnyBox::Aabb(BoxNumbers::Center(p, q)) => sum(p[i], q[i]),
                AnyBox::Aabb(BoxNumbers::Corners(_, q)) => q[i],
                AnyBox::Obb(obb) => sum(obb.center[i], obb.half[i]),
            };
            second.center[i] = sum(top, second.half[i]).moved(rng.whole(-1, 1));
        }
        BoxCase { first, second }
    }

    pub fn aabb<S: Sample>(self, rng: &mut Rng) -> BoxNumbers<S> {
        let (p, q) = (self.point(rng), self.half(rng));
        if rng.one_in(2) {
            return BoxNumbers::Center(p, q);
        }
        let q = self.point(rng);
        let sorted = |i: usize| if p[i] < q[i] { [p[i], q[i]] } else { [q[i], p[i]] };
        let rows = three(sorted);
        BoxNumbers::Corners(rows.each(|r| r[0]), rows.each(|r| r[1]))
    }

    fn number<S: Sample>(self, rng: &mut Rng) -> S {
        match self {
            Self::Turned | Self::NearlyParallel => S::nearest(rng.real(-1.5, 1.5)),
            Self::Grid => S::nearest(rng.whole(-3, 3) as f64 / 2.0),
            Self::Residue if rng.one_in(2) => S::nearest(rng.whole(-6, 6) as f64 / 4.0),
            Self::Residue => S::nearest(rng.real(-1.5, 1.5)),
            Self::Bits => S::from_ordinal(rng.bits() as i64 >> rng.below(64)),
            Self::Huge => {
                let end = [S::LEAST, S::GREATEST, S::ZERO, S::nearest(1.0)][rng.below(4)];
                end.moved(rng.whole(-2, 2))
            }
        }
    }

    pub(crate) fn point<S: Sample>(self, rng: &mut Rng) -> Point<S> {
        rng.triple(|rng| self.number(rng))
    }

    fn half<S: Sample>(self, rng: &mut Rng) -> Point<S> {
        rng.triple(|rng| {
            let x: S = self.number(rng);
            let size = if x < S::ZERO { S::from_ordinal(x.ordinal().saturating_neg()) } else { x };
            if rng.one_in(8) { S::ZERO } else { size }
        })
    }

    pub(crate) fn obb<S: Sample>(self, rng: &mut Rng) -> ObbNumbers<S> {
        let (center, half) = (self.point(rng), self.half(rng));
        let turned = |angles: [f64; 3]| {
            let mut frame = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            for (k, (i, j)) in [(0, 1), (1, 2), (2, 0)].into_iter().enumerate() {
                let (sin, cos) = angles[k].sin_cos();
                for row in &mut frame {
                    (row[i], row[j]) = (cos * row[i] - sin * row[j], sin * row[i] + cos * row[j]);
                }
            }
            frame.each(|row| row.each(S::nearest))
        };
        let axes = match self {
            Self::Turned => turned(rng.triple(|rng| rng.real(0.0, 6.3))),
            Self::NearlyParallel => {
                turned(rng.triple(|rng| if rng.one_in(2) { 0.0 } else { rng.real(-1e-7, 1e-7) }))
            }
            Self::Residue => {
                let (i, quarters) = (rng.below(3), rng.whole(-2, 2) as f64);
                let mut angles = [0.0; 3];
                angles[i] = if rng.one_in(2) {
                    quarters * std::f64::consts::FRAC_PI_2
                } else {
                    rng.real(0.0, 6.3)
                };
                if rng.one_in(2) {
                    angles[(i + 1) % 3] = 10_f64.powf(rng.real(-31.0, -3.0));
                }
                turned(angles)
            }
            // Parallel, or skewed by integers.
            Self::Grid => {
                let skew = if rng.one_in(2) { 0 } else { 1 };
                let mut axes = [[0; 3]; 3];
                for (i, axis) in axes.iter_mut().enumerate() {
                    *axis = rng.triple(|rng| rng.whole(-skew, skew));
                    axis[i] = 1;
                }
                axes.each(|u| u.each(|x| S::nearest(x as f64)))
            }
            Self::Bits | Self::Huge => [(); 3].each(|()| self.point(rng)),
        };
        ObbNumbers { center, axes, half }
    }
}
