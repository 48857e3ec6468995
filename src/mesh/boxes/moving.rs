//! Rays and moving boxes against a tree over boxes.

use core::ops::ControlFlow;

use super::BoxTree;
use crate::mesh::Index;
use crate::mesh::descent::Descent;
use crate::mesh::moving_box::{Moving, meets_at};
use crate::mesh::walk::Descend;
use crate::mesh::walk::descend;
use crate::query::{FirstContact, Motion, Sweep};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Ray};

impl<S: Scalar, I: Index> BoxTree<'_, S, I> {
    /// The box that a ray enters first, and the t at which it does, among the boxes for which
    /// `accepts` returns `true`.
    ///
    /// *Contact*, *Numerics*: the t is that of [`Ray::t_range`], with its rounding. Of boxes with the
    /// same rounded t the lowest index wins. *Panics*: never.
    ///
    /// *Cost*: [`Ray::t_range`] for each box in a leaf that the ray meets before it enters the first
    /// box. If a box extends beyond the range of the scalar, for each box.
    ///
    /// ```
    /// use septum::broad_phase::BoxTree;
    /// use septum::mesh::Node;
    /// use septum::{Aabb, Ray};
    ///
    /// let boxes = [3.0, 1.0, 2.0]
    ///     .map(|x| Aabb::from_min_max([x, 0.0, 0.0], [x + 0.5, 1.0, 1.0]).unwrap());
    /// let (mut nodes, mut order) = ([Node::EMPTY], [0_u16; 3]);
    /// let tree = BoxTree::build(&boxes, &mut nodes, &mut order)?;
    /// let ray = Ray::new([0.0, 0.5, 0.5], [1.0, 0.0, 0.0])?;
    /// assert_eq!(tree.first_hit(&ray, |_| true), Some((1, 1.0)));
    /// assert_eq!(tree.first_hit(&ray, |i| i != 1), Some((2, 2.0)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "raycast")]
    #[must_use]
    pub fn first_hit(
        &self,
        ray: &Ray<S>,
        mut accepts: impl FnMut(usize) -> bool,
    ) -> Option<(usize, S)> {
        let mut best = None;
        let enter = |i: usize| {
            let (t, _) = self.boxes.get(i).and_then(|aabb| ray.t_range(aabb))?;
            (is_before(&best, t, i) && accepts(i)).then(|| {
                best = Some((i, t));
                t
            })
        };
        self.pass(|| Descent::new(&self.grid, ray), enter, Descent::limit);
        best
    }

    /// The box that a moving box meets first, and the time of impact, among the boxes for which
    /// `accepts` returns `true`: a body excludes itself.
    ///
    /// *Contact*, *Numerics*: exact; the contact has the bits of [`Sweep::first_contact`]. Of boxes
    /// whose times round to the same number the lowest index wins. *Panics*: never.
    ///
    /// *Cost*: [`Sweep::first_contact`] for each box in a leaf that the moving box meets before its
    /// first contact.
    #[doc(alias = "time of impact")]
    #[must_use]
    pub fn first_contact(
        &self,
        aabb: &Aabb<S>,
        motion: &Motion<S>,
        mut accepts: impl FnMut(usize) -> bool,
    ) -> Option<(usize, FirstContact<S>)> {
        let mut best: Option<(usize, FirstContact<S>)> = None;
        let meet = |i: usize| {
            let first = aabb.first_contact(motion, self.boxes.get(i)?)?;
            let so_far = best.map(|(i, best)| (i, best.t));
            (is_before(&so_far, first.t, i) && accepts(i)).then(|| {
                best = Some((i, first));
                first.t
            })
        };
        let moving = || Moving::new(&self.grid, aabb, motion, meets_at(aabb));
        self.pass(moving, meet, Moving::limit);
        best
    }

    /// Visits the boxes near something that moves, roughly in the order in which it reaches them. `visit`
    /// returns a t beyond which no box matters.
    #[inline(always)]
    fn pass<D: Descend>(
        &self,
        moving: impl FnOnce() -> D,
        mut visit: impl FnMut(usize) -> Option<S>,
        limit: impl Fn(&mut D, S),
    ) {
        if self.is_beyond {
            for i in 0..self.boxes.len() {
                visit(i);
            }
            return;
        }
        let _ = descend(self.nodes, &self.layout, &mut moving(), |moving, leaf| {
            for t in leaf.filter_map(|place| visit(self.index(place))) {
                limit(moving, t);
            }
            ControlFlow::Continue(())
        });
    }
}

/// Whether a contact at t with number i comes before the best one so far.
pub(in crate::mesh) fn is_before<S: Scalar>(best: &Option<(usize, S)>, t: S, i: usize) -> bool {
    best.is_none_or(|(j, other)| t < other || t == other && i < j)
}
