//! Ray against axis-aligned boxes by slopes, prepared for many boxes.
//!
//! M. Eisemann, M. Magnor, T. Grosch, S. Müller, "Fast Ray/Axis-Aligned Bounding Box Overlap Tests
//! using Ray Slopes", *Journal of Graphics Tools* 12(4), 2007; Real-Time Rendering 16.7.3. Seen
//! along a coordinate axis, the ray is a line with a slope. It misses the box if it passes outside
//! one of the two corners that its slope points to. The paper has a function for each of 26 classes
//! of direction. Here each axis on which the ray falls is mirrored, which leaves one class; zeros
//! are found in advance. A range of t other than t ≥ 0 is ours.

use crate::arithmetic::{Each, Number, Rounded, greatest};
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Ray};

/// A ray prepared for many boxes: the slopes of its three projections.
///
/// It decides by multiplications with slopes, without t; the origin occurs only in constants. On
/// processors that do several operations at once [`SlabRay`](super::slabs::SlabRay) is faster and
/// also gives t. Choose slopes for comparison, or for rays that share them.
///
/// ```
/// use septum::published::slopes::SlopeRay;
/// use septum::{Aabb, Ray};
///
/// let ray = SlopeRay::new(&Ray::new([-1.0_f32, 0.0, 0.5], [1.0, 0.0, -0.0])?);
/// let flat = Aabb::from_min_max([0.0; 3], [1.0, 0.0, 1.0])?;
/// assert!(ray.overlaps_rounded(&flat));
/// assert_eq!(ray.t_enter_rounded(&flat), Some(1.0));
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SlopeRay<S> {
    /// The axes on which the ray falls; on these, everything else here is mirrored.
    falls: [bool; 3],
    origin: [Rounded<S>; 3],
    /// How far coordinates i + 1 and i + 2 rise while coordinate i rises by one, and their values
    /// where coordinate i is zero.
    slope: [[Rounded<S>; 2]; 3],
    offset: [[Rounded<S>; 2]; 3],
    /// Where the ray begins and ends; an open end is the end of the scalar.
    first: [Rounded<S>; 3],
    last: [Rounded<S>; 3],
    reciprocal: [Rounded<S>; 3],
    from: S,
    /// Axes along which the ray does not rise, or not enough for a slope.
    flat: [bool; 3],
    is_plain: bool,
}

impl<S: Scalar> SlopeRay<S> {
    /// Prepares the ray for many boxes.
    ///
    /// *Panics*: never. *Cost*: nine divisions.
    #[inline]
    #[must_use]
    pub fn new(ray: &Ray<S>) -> Self {
        let zero = Rounded::<S>::ZERO;
        let one = Rounded(S::plain_one());
        let over = |a: Rounded<S>, b: Rounded<S>| Rounded(a.0.plain_div(b.0));
        let (o, d) = (ray.origin().to_array(), ray.direction().to_array());
        let falls = d.each(|d| d < S::ZERO);
        let mirrored = |i: usize, x: S| if falls[i] { -Rounded(x) } else { Rounded(x) };
        let origin = [0, 1, 2].each(|i: usize| mirrored(i, o[i]));
        let m = d.each(|d| Rounded(d).magnitude());
        let mut this = Self {
            falls,
            origin,
            slope: [[zero; 2]; 3],
            offset: [[zero; 2]; 3],
            first: origin,
            last: origin,
            reciprocal: [zero; 3],
            from: ray.t_min().unwrap_or(over(-one, zero).0),
            flat: [false; 3],
            is_plain: true,
        };
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let slope = [over(m[j], m[i]), over(m[k], m[i])];
            let reciprocal = over(one, m[i]);
            let finite = [slope[0], slope[1], reciprocal].iter().all(|x| x.0.is_finite());
            this.flat[i] = m[i] == zero || !finite;
            if !this.flat[i] {
                this.slope[i] = slope;
                this.offset[i] =
                    [origin[j] - slope[0] * origin[i], origin[k] - slope[1] * origin[i]];
                this.reciprocal[i] = reciprocal;
            }
            if m[i] != zero {
                let at = |t: S| origin[i] + Rounded(t) * m[i];
                this.first[i] = ray.t_min().map_or(over(-one, zero), at);
                this.last[i] = ray.t_max().map_or(over(one, zero), at);
            }
            this.is_plain &= !this.flat[i];
        }
        this
    }

    /// Does the ray overlap the box? In the scalar's own arithmetic, and occasionally wrong.
    ///
    /// *Contact*: touching counts as overlap, as far as rounding allows.
    ///
    /// *Numerics*: the constants contain the ray's distance from the world's origin, and the error
    /// grows with it; for large distances slabs are far better. Zero components of the direction
    /// add no error. In fixed point slopes have few bits, and products wrap around.
    ///
    /// *Panics*: never. *Cost*: 6 multiplications, 6 sums, 12 comparisons.
    ///
    /// *Source*: Eisemann et al. 2007.
    #[inline]
    #[must_use]
    pub fn overlaps_rounded(&self, aabb: &Aabb<S>) -> bool {
        let (near, far) = self.faces(aabb);
        !self.misses(&near, &far)
    }

    /// Where does the ray enter the box? In the scalar's own arithmetic; `None` if it misses the
    /// box.
    ///
    /// *Numerics*: the verdict of [`overlaps_rounded`](Self::overlaps_rounded). For a box
    /// given by its corners t is within 2 units in the last place. A ray that starts in the box
    /// enters it where its range begins.
    ///
    /// *Panics*: never. *Cost*: 9 multiplications, 9 sums, 15 comparisons.
    #[inline]
    #[must_use]
    pub fn t_enter_rounded(&self, aabb: &Aabb<S>) -> Option<S> {
        let (near, far) = self.faces(aabb);
        if self.misses(&near, &far) {
            return None;
        }
        let mut t = Rounded(self.from);
        for i in 0..3 {
            let enter = (near[i] - self.origin[i]) * self.reciprocal[i];
            t = if self.flat[i] { t } else { greatest(t, enter) };
        }
        Some(t.0)
    }

    /// The coordinates at which the ray enters and leaves the box, mirrored.
    #[inline(always)]
    fn faces(&self, aabb: &Aabb<S>) -> ([Rounded<S>; 3], [Rounded<S>; 3]) {
        let mut to = ([Rounded::ZERO; 3], [Rounded::ZERO; 3]);
        match aabb.form() {
            AabbForm::Corners { min, max } => {
                let (min, max) = (min.to_array(), max.to_array());
                for i in 0..3 {
                    let (low, high) = (Rounded(min[i]), Rounded(max[i]));
                    to.0[i] = if self.falls[i] { -high } else { low };
                    to.1[i] = if self.falls[i] { -low } else { high };
                }
            }
            AabbForm::Center { center, half } => {
                let (center, half) = (center.to_array(), half.to_array());
                for i in 0..3 {
                    let center = Rounded(center[i]);
                    let center = if self.falls[i] { -center } else { center };
                    to.0[i] = center - Rounded(half[i]);
                    to.1[i] = center + Rounded(half[i]);
                }
            }
        }
        to
    }

    #[inline(always)]
    fn misses(&self, near: &[Rounded<S>; 3], far: &[Rounded<S>; 3]) -> bool {
        let mut out = false;
        for i in 0..3 {
            out |= (self.first[i] > far[i]) | (near[i] > self.last[i]);
        }
        if self.is_plain {
            for i in 0..3 {
                out |= self.passes(i, near, far);
            }
            return out;
        }
        for i in 0..3 {
            out |= !self.flat[i] & self.passes(i, near, far);
        }
        out
    }

    /// Whether the ray leaves slab i before it enters one of the two remaining slabs.
    #[inline(always)]
    fn passes(&self, i: usize, near: &[Rounded<S>; 3], far: &[Rounded<S>; 3]) -> bool {
        let at = |k: usize| self.slope[i][k] * far[i] + self.offset[i][k];
        (at(0) < near[(i + 1) % 3]) | (at(1) < near[(i + 2) % 3])
    }
}
