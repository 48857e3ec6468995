//! The boxes that a shape overlaps.

use super::BoxTree;
use crate::mesh::node::{Cell, Node};
use crate::mesh::overlapping::{mask, sealed::Bounded};
use crate::mesh::walk::Walk;
use crate::mesh::{Index, MeshError, sort};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Overlaps};

/// A shape that [`BoxTree::overlapping`] accepts: an [`Aabb`], an [`Obb`](crate::Obb), a
/// [`Triangle`](crate::Triangle) or a [`Segment`](crate::Segment).
///
/// The trait is sealed.
pub trait BoxProbe<S: Scalar>: Overlaps<Aabb<S>> + Bounded<S> {}

impl<S: Scalar, P: Overlaps<Aabb<S>> + Bounded<S>> BoxProbe<S> for P {}

impl<S: Scalar, I: Index> BoxTree<'_, S, I> {
    /// The boxes that a shape overlaps, in ascending order, at the front of `found`.
    ///
    /// *Contact*: touching is overlap. *Numerics*: exact, as [`Overlaps::overlaps`]. *Panics*: never.
    ///
    /// *Cost*: as for [`mesh::Tree::overlapping`](crate::mesh::Tree::overlapping), and a sort of what
    /// was found.
    ///
    /// # Errors
    /// [`MeshError::Length`] with their number if there are more than `found` can hold.
    ///
    /// ```
    /// use septum::Aabb;
    /// use septum::broad_phase::BoxTree;
    /// use septum::mesh::Node;
    ///
    /// let boxes = [3.0, 1.0, 2.0]
    ///     .map(|x| Aabb::from_min_max([x, 0.0, 0.0], [x + 0.5, 1.0, 1.0]).unwrap());
    /// let (mut nodes, mut order) = ([Node::EMPTY], [0_u16; 3]);
    /// let tree = BoxTree::build(&boxes, &mut nodes, &mut order)?;
    /// let blast = Aabb::from_center_half_extents([2.5, 0.5, 0.5], [0.5; 3])?;
    /// assert_eq!(tree.overlapping(&blast, &mut [0; 3])?, [0, 2]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn overlapping<'f, P: BoxProbe<S>>(
        &self,
        shape: &P,
        found: &'f mut [I],
    ) -> Result<&'f [I], MeshError> {
        let mut count = 0;
        let cell = shape.corners().map_or(Cell::ALL, |corners| self.grid.cell(corners));
        let mask = |node: &Node| mask(&self.grid, node, &cell, shape);
        let mut walk = Walk::new(self.nodes, mask);
        let mut all = self.is_beyond.then_some(0..self.boxes.len());
        let mut next = || {
            if self.is_beyond { all.take() } else { walk.next(self.nodes, &self.layout, mask) }
        };
        while let Some(leaf) = next() {
            for i in leaf.map(|place| self.index(place)) {
                if self.boxes.get(i).is_some_and(|aabb| shape.overlaps(aabb)) {
                    if let Some(to) = found.get_mut(count) {
                        *to = I::of(i);
                    }
                    count += 1;
                }
            }
        }
        sorted(found, count)
    }
}

/// The first `needed` elements in ascending order, if there is room for them.
pub(super) fn sorted<T: Copy + Ord>(found: &mut [T], needed: usize) -> Result<&[T], MeshError> {
    let found = found.get_mut(..needed).ok_or(MeshError::Length { needed })?;
    sort(found, Ord::cmp);
    Ok(found)
}
