//! The kernel in machine words, for narrow registers: for a core on which a product of words is cheap
//! and a wider one is not.

use super::Disjoint;
use crate::arithmetic::{InWord, Word, out_of_line_if_wide};
use crate::query::one_sided::{Projection, one_sided, relation};
use crate::query::relation::Relation;
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Triangle, Vec3};

impl<S: Scalar> Disjoint<'_, S> {
    /// The answer in words wide enough for shapes anywhere.
    #[inline(never)]
    pub(super) fn in_any_words<W: Word>(&self) -> bool
    where
        S: InWord<W>,
    {
        let projections = self.projections();
        Projection::are_apart(&projections) || one_sided(&projections)
    }

    /// The answer in words wide enough for shapes near each other; `None` if they are not.
    #[inline(never)]
    pub(super) fn in_near_words<W: Word>(&self) -> Option<bool>
    where
        S: InWord<W>,
    {
        let ([x, y, z], _) = extents(self.aabb);
        let projections = self.projections();
        (W::is_central(x)
            && W::is_central(y)
            && W::is_central(z)
            && Projection::are_near(&projections))
        .then(|| Projection::are_apart(&projections) || one_sided(&projections))
    }

    /// How the shapes lie to each other, likewise.
    #[inline(never)]
    pub(super) fn relation_in_words<W: Word>(&self) -> Option<Relation>
    where
        S: InWord<W>,
    {
        let (min, _) = extents(self.aabb);
        let projections = self.projections();
        let is_near = min.iter().all(|x| x.is_central()) && Projection::are_near(&projections);
        (S::ALWAYS_NEAR || is_near).then(|| relation(&projections))
    }

    /// The same in words wide enough for shapes anywhere.
    #[cfg(feature = "fixed")]
    #[inline(never)]
    pub(super) fn relation_in_any_words<W: Word>(&self) -> Relation
    where
        S: InWord<W>,
    {
        relation(&self.projections())
    }

    #[inline(always)]
    fn projections<W: Word>(&self) -> [Projection<W>; 3]
    where
        S: InWord<W>,
    {
        projections(self.triangle, self.aabb)
    }
}

/// The shapes projected on the coordinate axes, relative to the least corner of the box.
#[inline(always)]
pub(in crate::query) fn projections<S: Scalar + InWord<W>, W: Word>(
    triangle: &Triangle<S>,
    aabb: &Aabb<S>,
) -> [Projection<W>; 3] {
    out_of_line_if_wide!(W, {
        let (min, size) = extents(aabb);
        let [a, b, c] = triangle.vertices();
        let [a, b, c] = [words(a), words(b), words(c)];
        let projection = |i: usize| Projection::new(min[i], size[i], [a[i], b[i], c[i]]);
        [projection(0), projection(1), projection(2)]
    })
}

/// The least corner of the box, and its extents.
#[inline(always)]
pub(in crate::query) fn extents<S: Scalar + InWord<W>, W: Word>(
    aabb: &Aabb<S>,
) -> ([W; 3], [W; 3]) {
    match aabb.form() {
        AabbForm::Center { center, half } => {
            let (center, half) = (words(center), words(half));
            (each(center, half, W::minus), each(half, half, W::plus))
        }
        AabbForm::Corners { min, max } => {
            let (min, max) = (words(min), words(max));
            (min, each(max, min, W::minus))
        }
    }
}

#[inline(always)]
pub(in crate::query) fn words<S: InWord<W> + Copy, W: Word>(v: &Vec3<S>) -> [W; 3] {
    [v.x.in_word(), v.y.in_word(), v.z.in_word()]
}

#[inline(always)]
pub(in crate::query) fn each<W: Word>(a: [W; 3], b: [W; 3], f: fn(W, W) -> W) -> [W; 3] {
    [f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2])]
}
