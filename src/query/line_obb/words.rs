//! For narrow registers: the line as a triangle without area (`triangle_obb::short`).
//!
//! A ray is cut at 2^n as in `obb_short`. Its ends are in units of 2^(n−28). The way to its origin has
//! less than 2^27 of these, an end at most 2^29; each is rounded to the nearest. A product of factors
//! cut to 30 bits is off by (2^30 + 1/4)/2^31 besides. Together this is less than 2, and cut by 13 bits
//! less than 2^-12.

use super::{Disjoint, Line};
use crate::arithmetic::{InRaw, Raw, Word, greatest, three};
use crate::query::obb_short::{ends, size};
use crate::query::triangle_obb::{EXACT, Known, Size, are_disjoint, raw};
use crate::scalar::Scalar;
use crate::shape::{Ray, SegmentForm, Vec3};

/// The bits of the end of a ray: one less than fit, as a cut by one bit overflows the greatest number.
const END: i32 = 28;
/// The bits by which it is too long.
const SPARE: i32 = 13;

impl<S: Scalar + InRaw> Disjoint<'_, S> {
    /// The answer; `None` in doubt, and where differences may not fit.
    #[inline(never)]
    pub(super) fn in_short_words(&self) -> Option<bool> {
        match self.line {
            Line::Ray(ray) => self.ray_in_short_words(ray),
            Line::Segment(segment) => {
                let (p, q) = match segment.form() {
                    SegmentForm::Ends(a, b) => (self.way_to(a)?, self.way_to(b)?),
                    SegmentForm::Center { center, half } => {
                        let (way, half) = (self.way_to(center)?, raw(half));
                        let is_short = |x: S::Raw| x.folded().bits() < S::Raw::BITS as i32 - 2;
                        let fits = S::ALWAYS_NEAR || way.into_iter().chain(half).all(is_short);
                        fits.then_some(())?;
                        (three(|i| way[i].minus(half[i])), three(|i| way[i].plus(half[i])))
                    }
                };
                are_disjoint(self.obb, || Known::Nothing, EXACT, || ([p, q, q], 0))
            }
        }
    }

    #[inline(always)]
    pub(super) fn ray_in_short_words(&self, ray: &Ray<S>) -> Option<bool> {
        let (way, d) = (self.way_to(&ray.origin())?, raw(&ray.direction()));
        let span = Size::of(self.obb);
        let reach = greatest(size(&[way]).bits(), span.reach + 2) + 1;
        let unit = reach - END;
        let [beyond] = Raw::cut([d], size(&[d]).bits() - END - 1);

        let Some([from, to]) = ends(ray, reach, unit, beyond) else { return Some(true) };
        let [way] = Raw::cut([way], unit);
        let (p, q) = (three(|i| way[i] + from[i]), three(|i| way[i] + to[i]));
        are_disjoint(self.obb, move || Known::Size(span), unit + SPARE, || ([p, q, q], unit))
    }

    /// The way from the centre of the box to a point, if the difference fits.
    #[inline(always)]
    fn way_to(&self, p: &Vec3<S>) -> Option<[S::Raw; 3]> {
        let (p, c) = (raw(p), raw(&self.obb.center()));
        let way = three(|i| p[i].minus(c[i]));
        let is_central = c.iter().all(|x| x.is_central());
        (S::ALWAYS_NEAR || is_central && size(&[way]).bits() < S::Raw::BITS as i32 - 1)
            .then_some(way)
    }
}
