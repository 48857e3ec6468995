//! The triangles of a mesh that a shape overlaps.

use core::ops::Range;

use super::node::{Cell, Grid, Node};
use super::walk::Walk;
use super::{Index, Tree};
use crate::arithmetic::{Each, REGISTERS_ARE_WIDE};
use crate::query::PreparedObb;
use crate::scalar::Scalar;
use crate::shape::{Aabb, Capsule, Obb, Overlaps, Segment, Sphere, Triangle, Vec3};

/// A shape that [`Tree::overlapping`] accepts.
///
/// The trait is sealed.
pub trait Probe<S: Scalar>: Overlaps<Triangle<S>> + sealed::Bounded<S> {}

impl<S: Scalar, P: Overlaps<Triangle<S>> + sealed::Bounded<S>> Probe<S> for P {}

pub(super) mod sealed {
    use core::fmt::Debug;

    use crate::scalar::Scalar;
    use crate::shape::{Aabb, Triangle};

    pub trait Bounded<S: Scalar> {
        /// The numbers that are computed once for all triangles.
        type Prepared: Clone + Debug;

        fn prepared(&self) -> Self::Prepared;

        /// Whether the shape overlaps a triangle, given its own numbers.
        fn overlaps_prepared(&self, prepared: &Self::Prepared, triangle: &Triangle<S>) -> bool;

        /// Whether the shape may meet a box that meets its bounding box; `true` unless it is narrow.
        fn may_meet(&self, _: &Aabb<S>) -> bool {
            true
        }

        /// Two corners of a box that encloses the shape, clamped to the range of fixed point; `None`
        /// if floats have no such box.
        fn corners(&self) -> Option<[[S; 3]; 2]>;

        /// Whether [`may_overlap`](crate::Overlaps::may_overlap) excludes enough boxes that meet the
        /// shape's bounding box to be worth its time.
        const IS_NARROW: bool = false;

        /// Whether testing a triangle costs more than testing the bounding box first.
        const IS_DEAR: bool = false;
    }
}

impl<S: Scalar> sealed::Bounded<S> for Obb<S> {
    type Prepared = PreparedObb<S>;

    #[inline(always)]
    fn prepared(&self) -> PreparedObb<S> {
        PreparedObb::new(self)
    }

    #[inline(always)]
    fn overlaps_prepared(&self, prepared: &PreparedObb<S>, triangle: &Triangle<S>) -> bool {
        prepared.overlaps(triangle)
    }

    // On small cores the short-word test of an oriented box in fixed point rejects most
    // triangles for less than the test of an axis-aligned box far from the origin.
    const IS_DEAR: bool = REGISTERS_ARE_WIDE || S::FLOAT.is_some();

    fn corners(&self) -> Option<[[S; 3]; 2]> {
        let (min, max) = self.aabb()?.min_max()?;
        Some([min.to_array(), max.to_array()])
    }
}

macro_rules! bounded {
    ($($shape:ident, $is_narrow:literal, |$it:ident| $corners:expr;)*) => {$(
        impl<S: Scalar> sealed::Bounded<S> for $shape<S> {
            type Prepared = ();

            fn prepared(&self) {}

            #[inline(always)]
            fn overlaps_prepared(&self, (): &(), triangle: &Triangle<S>) -> bool {
                self.overlaps(triangle)
            }

            #[inline(always)]
            fn may_meet(&self, aabb: &Aabb<S>) -> bool {
                self.may_overlap(aabb)
            }

            const IS_NARROW: bool = $is_narrow;

            fn corners(&self) -> Option<[[S; 3]; 2]> {
                let $it = self;
                $corners
            }
        }
    )*};
}
bounded! {
    Aabb, false, |aabb| aabb.min_max().map(|(min, max)| [min.to_array(), max.to_array()]);
    Triangle, true, |triangle| Some(triangle.corners());
    Segment, true, |segment| segment.corners();
    Sphere, false, |sphere| sphere.corners();
    Capsule, false, |capsule| capsule.corners();
}

impl<'a, S: Scalar, I: Index> Tree<'a, S, I> {
    /// The triangles that overlap a shape, in the tree's order. The shape is an [`Aabb`], an
    /// [`Obb`], a [`Triangle`], a [`Segment`], a [`Sphere`] or a [`Capsule`]: the triangles within a
    /// distance of a point or a segment.
    ///
    /// *Contact*: touching is overlap.
    ///
    /// *Numerics*: exact: the shape's own [`overlaps`](Overlaps::overlaps) decides for each
    /// triangle nearby. *Panics*: never.
    ///
    /// *Cost*: 6 integer comparisons for each box on the way down; a triangle or a segment also
    /// runs [`may_overlap`](Overlaps::may_overlap) on each box that passes these. It needs no
    /// stack: the path is kept in one word.
    ///
    /// See [`Tree`] for an example.
    #[doc(alias = "broad phase")]
    pub fn overlapping<'t, P: Probe<S>>(&'t self, shape: &'t P) -> Overlapping<'t, 'a, S, I, P> {
        Overlapping::new(self, shape)
    }
}

/// The boxes of a node that a shape may meet; `cell` is the shape's bounding box.
#[inline(always)]
pub(super) fn mask<S: Scalar, P: sealed::Bounded<S>>(
    grid: &Grid<S>,
    node: &Node,
    cell: &Cell,
    shape: &P,
) -> u32 {
    let mut mask = node.meeting(cell);
    if P::IS_NARROW {
        for k in 0..4 {
            let misses = || !shape.may_meet(&grid.aabb(&node.cell(k)));
            if mask >> k & 1 == 1 && misses() {
                mask ^= 1 << k;
            }
        }
    }
    mask
}

/// The triangles that a shape overlaps: see [`Tree::overlapping`].
#[derive(Clone, Debug)]
pub struct Overlapping<'t, 'a, S: Scalar, I, P: sealed::Bounded<S>> {
    tree: &'t Tree<'a, S, I>,
    shape: &'t P,
    /// From the first triangle nearby.
    prepared: Option<P::Prepared>,
    corners: Option<[[S; 3]; 2]>,
    cell: Cell,
    walk: Walk,
    leaf: Range<usize>,
}

impl<'t, 'a, S: Scalar, I: Index, P: sealed::Bounded<S>> Overlapping<'t, 'a, S, I, P> {
    #[inline(always)]
    pub(super) fn new(tree: &'t Tree<'a, S, I>, shape: &'t P) -> Self {
        let corners = shape.corners();
        let cell = corners.map_or(Cell::ALL, |corners| tree.grid.cell(corners));
        let walk = Walk::new(tree.nodes, |root| mask(&tree.grid, root, &cell, shape));
        Self { tree, shape, prepared: None, corners, cell, walk, leaf: 0..0 }
    }
}

impl<S: Scalar, I: Index, P: sealed::Bounded<S>> Iterator for Overlapping<'_, '_, S, I, P> {
    type Item = usize;

    fn next(&mut self) -> Option<usize> {
        let Self { tree, shape, corners, cell, .. } = *self;
        loop {
            for place in self.leaf.by_ref() {
                let i = tree.index(place);
                let triangle = tree.mesh.known(i);
                let is_near = corners.is_none_or(|corners| is_near::<S, P>(&corners, &triangle));
                if !is_near {
                    continue;
                }
                let prepared = self.prepared.get_or_insert_with(|| shape.prepared());
                if shape.overlaps_prepared(prepared, &triangle) {
                    return Some(i);
                }
            }
            let mask = |node: &Node| mask(&tree.grid, node, &cell, shape);
            self.leaf = self.walk.next(tree.nodes, &tree.layout, mask)?;
        }
    }
}

/// Whether a triangle may meet a shape whose bounding box has these corners.
#[inline(always)]
fn is_near<S: Scalar, P: sealed::Bounded<S>>(
    [min, max]: &[[S; 3]; 2],
    triangle: &Triangle<S>,
) -> bool {
    let [a, b, c] = triangle.vertices().each(Vec3::to_array);
    for i in 0..3 {
        // Without branches where a wrong guess is dearer than a comparison.
        let all = |is: fn(S, S) -> bool, end: S| {
            if REGISTERS_ARE_WIDE {
                is(a[i], end) & is(b[i], end) & is(c[i], end)
            } else {
                is(a[i], end) && is(b[i], end) && is(c[i], end)
            }
        };
        let is_below = all(|x, min| x < min, min[i]);
        if is_below || all(|x, max| x > max, max[i]) {
            return false;
        }
    }
    !P::IS_DEAR || triangle.may_overlap(&Aabb::between((*min).into(), (*max).into()))
}
