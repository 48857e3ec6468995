//! Lines against oriented boxes. The oracle transforms the line into the box's own coordinates, by
//! Cramer's rule in integers, and clips it there.

use dashu_int::IBig;
use septum::{Obb, Overlaps};

use super::{Fraction, InFrame, Line, clip, faces};
use crate::boxes::{AnyBox, BoxSet, ObbNumbers};
use crate::exact::{Parts, least_exponent, whole};
use crate::lattice::Ring;
use crate::{BoxNumbers, Each, Rng, Sample, three};

/// A line and an oriented box.
#[derive(Clone, Copy, Debug)]
pub struct LineObb<S> {
    pub line: Line<S>,
    pub obb: ObbNumbers<S>,
}

impl<S: Sample> LineObb<S> {
    /// A box of the set, and a line: through a corner of the box, the midpoint of an edge or of a
    /// face, or its centre, as near as rounding allows, or a random line.
    pub fn case(set: BoxSet, rng: &mut Rng) -> Self {
        let case = set.case::<S>(rng);
        let obb = case.second;
        let (p, q) = match case.first {
            AnyBox::Aabb(BoxNumbers::Center(p, q) | BoxNumbers::Corners(p, q)) => (p, q),
            AnyBox::Obb(other) => (other.center, other.axes[0]),
        };
        let signs = rng.triple(|rng| rng.whole(-1, 1) as f64);
        let target = three(|i: usize| {
            let along =
                |k: usize| signs[k] * obb.half[k].approximate() * obb.axes[k][i].approximate();
            S::nearest(obb.center[i].approximate() + along(0) + along(1) + along(2))
        });
        let minus = |a: [S; 3], b: [S; 3]| {
            three(|i: usize| S::nearest(a[i].approximate() - b[i].approximate()))
        };
        let aims = !rng.one_in(3);
        let line = match rng.below(6) {
            0 => Line::Ends(p, if aims { target } else { q }),
            1 => Line::Center(p, if aims { minus(target, p) } else { q }),
            _ => {
                let direction = if aims { minus(target, p) } else { q };
                let zero = S::ZERO;
                let mut ends = [(); 2].each(|()| match rng.below(3) {
                    0 => None,
                    1 => Some(zero),
                    _ => Some([q[0], S::nearest(1.0), p[1], S::nearest(-1.0)][rng.below(4)]),
                });
                if let [Some(from), Some(to)] = ends {
                    if from > to {
                        ends = [Some(to), Some(from)];
                    }
                }
                Line::Ray(p, direction, ends)
            }
        };
        Self { line, obb }
    }

    /// Both ends of the part of the line inside the box, if there is one; an end is `None` if it is
    /// unbounded.
    pub fn clip(&self) -> Option<[Option<Fraction>; 2]> {
        LineObb { line: self.line.parts(), obb: self.obb.map(S::mantissa_exponent) }.clip_in_parts()
    }

    /// The faces on which both ends of the clipped line lie.
    pub fn faces(&self) -> Option<[Option<u8>; 2]> {
        let of = LineObb { line: self.line.parts(), obb: self.obb.map(S::mantissa_exponent) };
        faces(&of.frame())
    }

    /// Checks verdicts against the oracle, in either order, and returns its answer; `None` if the
    /// numbers are invalid.
    ///
    /// # Panics
    /// If a verdict is wrong.
    pub fn check(&self) -> Option<bool> {
        fn asked<S: Sample, L: Overlaps<Obb<S>>>(line: &L, obb: &Obb<S>) -> [bool; 3]
        where
            Obb<S>: Overlaps<L>,
        {
            [line.overlaps(obb), Overlaps::overlaps(obb, line), line.may_overlap(obb)]
        }
        let obb = self.obb.shape().ok()?;
        let [one, other, may] = match (self.line.ray(), self.line.segment()) {
            (Some(ray), _) => asked(&ray, &obb),
            (None, segment) => asked(&segment?, &obb),
        };
        let meets = self.clip().is_some();
        assert_eq!([one, other], [meets; 2], "{self:?}");
        assert!(may || !meets, "may_overlap: {self:?}");
        Some(meets)
    }
}

impl LineObb<Parts> {
    /// In units of the least exponent, with `one` in that unit: x = c + Σ s_i·u_i/one has
    /// s_i·det = one·w_i·(x − c).
    fn clip_in_parts(&self) -> Option<[Option<Fraction>; 2]> {
        clip(self.frame())
    }

    fn frame(&self) -> InFrame {
        let ObbNumbers { center, axes, half } = self.obb;
        let mut numbers: Vec<_> = self.line.numbers().chain(center).chain(half).collect();
        numbers.extend(axes.as_flattened());
        let unit = least_exponent(&numbers).min(0);
        let vector = |p: [Parts; 3]| p.each(|x| whole(x, unit));
        let one = IBig::ONE << (-unit) as usize;
        let (origin, d, range) = self.line.whole(unit);
        let [u, v, n] = axes.each(vector);
        let w = [IBig::cross(&v, &n), IBig::cross(&n, &u), IBig::cross(&u, &v)];
        let det = IBig::dot(&u, &w[0]);
        let hand = IBig::from(Ring::sign(&det));
        let size = &det * &hand;
        let faces = vector(half).each(|h| [-(&h * &size), h * &size]);
        let from = IBig::difference(&origin, &vector(center));
        let along = |x: &[IBig; 3]| three(|i: usize| IBig::dot(&w[i], x) * &one * &hand);
        InFrame { origin: along(&from), d: along(&d), faces, range }
    }
}
