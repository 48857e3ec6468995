//! Rays and segments near the origin against oriented boxes: in words of 32 bits alone.

use super::exact::ExactLine;
use super::{Disjoint, Line};
use crate::arithmetic::{Each, InRaw, out_of_line, three};
use crate::query::Overlaps;
use crate::query::triangle_obb::exact::InWords;
use crate::robust::Predicate;
use crate::scalar::Scalar;
use crate::shape::{Near, Obb, Ray, Segment, Triangle};

impl<S: Scalar + InRaw<Raw = i32>> Disjoint<'_, S> {
    /// The answer for a ray near the origin.
    #[cold]
    #[inline(never)]
    fn in_whole_words(&self, ray: &Ray<S>) -> bool {
        // A box is near only if a word of its type can hold one.
        let Some(one) = S::one_in() else { return self.exact() };
        let words = |row: [S; 3]| row.each(S::in_word);
        let [o, d, _] = self.rows().each(words);
        let [c, u, v, w, h] = self.obb.numbers().map(words);
        let ends = [ray.t_min(), ray.t_max()].each(|t| t.map(S::in_word));
        ExactLine::<InWords<i32>>::new(three(|i| o[i] - c[i]), d, ends, [u, v, w], h, one)
            .is_separated()
    }
}

impl<S: Scalar + InRaw<Raw = i32>> Overlaps<Near<Obb<S>>> for Near<Ray<S>> {
    /// Do a ray and an oriented box near the origin have a point in common?
    ///
    /// *Geometry*: the part of the ray within its range of t, whose ends belong to it, and the
    /// parallelepiped that the numbers of the box describe. *Contact*: touching is overlap.
    /// *Numerics*: exact for every range of t, in words of 32 bits and sums of their products.
    /// `may_overlap` is the same here. For shapes anywhere it may be `true` where `overlaps` is
    /// `false`. *Range*: that of [`near`](crate::near). *Panics*: never. *Cost*: as for a triangle near
    /// the origin: the ray is one without area. Within rounding of contact whole products decide
    /// about six axes.
    ///
    /// ```
    /// use fixed::types::I16F16;
    /// use septum::{Obb, Ray};
    ///
    /// let at = |x: i32, y: i32, z: i32| [x, y, z].map(|k| I16F16::from_bits(k << 12));
    /// let axes = [at(4, 4, 0), at(-4, 4, 0), at(0, 0, 4)];
    /// let turned = Obb::from_skewed_axes(at(0, 0, 0), axes, at(16, 16, 16))?.near()?;
    /// let ray = Ray::new(at(8, -9, 0), at(0, 3, 0))?;
    /// assert!(ray.near()?.overlaps(&turned)); // at an edge, y = 0
    /// let until = |t: f32| ray.with_range(I16F16::ZERO, I16F16::from_num(t));
    /// assert!(until(3.0)?.near()?.overlaps(&turned) && !until(2.9)?.near()?.overlaps(&turned));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    fn overlaps(&self, obb: &Near<Obb<S>>) -> bool {
        let question = Disjoint { line: Line::Ray(self.get()), obb: obb.get() };
        // Its stack is free again before the last stage.
        let in_short = out_of_line(|| question.ray_in_short_words(self.get()));
        !in_short.unwrap_or_else(|| question.in_whole_words(self.get()))
    }
}

impl<S: Scalar> Overlaps<Near<Obb<S>>> for Near<Segment<S>>
where
    Near<Triangle<S>>: Overlaps<Near<Obb<S>>>,
{
    /// Do a segment and an oriented box near the origin have a point in common?
    ///
    /// *Contact*: touching is overlap. *Numerics*: exact, in 32-bit words alone. `may_overlap` is
    /// the same here. For shapes anywhere it may be `true` where `overlaps` is `false`. *Panics*:
    /// never. *Cost*: as for a triangle near the origin: the segment is one without area.
    ///
    /// ```
    /// use fixed::types::I16F16;
    /// use septum::{Obb, Segment};
    ///
    /// let at = |x: i32, y: i32, z: i32| [x, y, z].map(|k| I16F16::from_bits(k << 12));
    /// let axes = [at(4, 4, 0), at(-4, 4, 0), at(0, 0, 4)];
    /// let turned = Obb::from_skewed_axes(at(0, 0, 0), axes, at(16, 16, 16))?.near()?;
    /// let touching = Segment::new(at(8, -9, 0), at(8, 9, 0))?.near()?;
    /// assert!(touching.overlaps(&turned)); // at an edge
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    fn overlaps(&self, obb: &Near<Obb<S>>) -> bool {
        let (p, q, is_by_center) = self.get().numbers();
        // No sum wraps.
        let [a, b] = if is_by_center {
            [three(|i| p[i].plain_sub(q[i])), three(|i| p[i].plain_add(q[i]))]
        } else {
            [p, q]
        };
        Near::unchecked(Triangle::unchecked([a.into(), b.into(), b.into()])).overlaps(obb)
    }
}
