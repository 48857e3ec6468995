//! The kernel in machine words, for narrow registers: for a core on which a product of words is cheap
//! and a wider one is not.

use super::Disjoint;
use crate::arithmetic::{Each, InRaw, Word, out_of_line_if_wide, three};
use crate::query::one_sided::{Projection, are_disjoint, relation};
use crate::query::relation::Relation;
use crate::scalar::Scalar;
use crate::shape::{Aabb, AabbForm, Triangle, Vec3};

impl<S: Scalar + InRaw> Disjoint<'_, S> {
    /// The answer in words wide enough for shapes anywhere.
    #[inline(never)]
    pub(super) fn in_any_words<W: Word>(&self) -> bool {
        are_disjoint::<W>(&projections(self.triangle, self.aabb))
    }

    /// How the shapes lie to each other, likewise.
    #[inline(never)]
    pub(super) fn relation_in_any_words<W: Word>(&self) -> Relation {
        relation::<W>(&projections(self.triangle, self.aabb))
    }

    /// The answer in words wide enough for shapes near each other; `None` if they are not.
    #[inline(never)]
    pub(super) fn in_near_words<W: Word>(&self) -> Option<bool> {
        let (min, _) = extents::<_, W>(self.aabb);
        let shapes = projections(self.triangle, self.aabb);
        are_near(&min, &shapes).then(|| are_disjoint(&shapes))
    }

    /// How the shapes lie to each other, likewise.
    #[inline(never)]
    pub(super) fn relation_in_near_words<W: Word>(&self) -> Option<Relation> {
        let (min, _) = extents::<_, W>(self.aabb);
        let shapes = projections(self.triangle, self.aabb);
        are_near(&min, &shapes).then(|| relation(&shapes))
    }
}

/// Whether words have room for shapes and the least corner of the box.
#[inline(always)]
fn are_near<W: Word>([x, y, z]: &[W; 3], shapes: &[Projection<W>; 3]) -> bool {
    x.is_central() && y.is_central() && z.is_central() && Projection::are_near(shapes)
}

/// The shapes projected on the coordinate axes, relative to the least corner of the box.
#[inline(always)]
pub(in crate::query) fn projections<S: Scalar + InRaw, W: Word>(
    triangle: &Triangle<S>,
    aabb: &Aabb<S>,
) -> [Projection<W>; 3] {
    out_of_line_if_wide!(W, {
        let (min, size) = extents(aabb);
        let [a, b, c] = triangle.points().each(|p| p.each(S::in_word));
        three(|i| Projection::new(min[i], size[i], [a[i], b[i], c[i]]))
    })
}

/// The least corner of the box, and its extents.
#[inline(always)]
pub(in crate::query) fn extents<S: Scalar + InRaw, W: Word>(aabb: &Aabb<S>) -> ([W; 3], [W; 3]) {
    match aabb.form() {
        AabbForm::Center { center, half } => {
            let (center, half) = (words(center), words(half));
            (minus(&center, &half), half.each(|h| h.plus(h)))
        }
        AabbForm::Corners { min, max } => {
            let (min, max) = (words(min), words(max));
            (min, minus(&max, &min))
        }
    }
}

#[inline(always)]
pub(in crate::query) fn words<S: InRaw + Copy, W: Word>(v: &Vec3<S>) -> [W; 3] {
    [v.x.in_word(), v.y.in_word(), v.z.in_word()]
}

/// a − b, wrapped.
#[inline(always)]
pub(in crate::query) fn minus<W: Word>(a: &[W; 3], b: &[W; 3]) -> [W; 3] {
    three(|i| a[i].minus(b[i]))
}
