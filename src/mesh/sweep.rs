//! A box or a sphere that moves past a mesh.

use core::ops::ControlFlow;

use super::boxes::is_before;
use super::build::Leaves;
use super::moving_box::{Moving, meets_at};
use super::node::Node;
use super::walk::{Descend, Met, descend};
use super::{Index, Tree};
use crate::query::{Feature, FirstContact, Motion, Relation, SphereContact, Sweep};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Sphere, Triangle, Vec3};

/// A shape that moves past a mesh: a box or a sphere.
///
/// The trait is sealed.
pub trait Mover<S: Scalar>:
    Sweep<Triangle<S>, Scalar = S, Contact: Copy> + sealed::Bounded<S>
{
}

impl<S: Scalar> Mover<S> for Aabb<S> {}
impl<S: Scalar> Mover<S> for Sphere<S> {}

mod sealed {
    use crate::query::Sweep;
    use crate::scalar::Scalar;
    use crate::shape::{Aabb, Triangle};

    pub trait Bounded<S: Scalar>: Sweep<Triangle<S>> {
        /// A box that encloses the shape and meets all that it meets no later.
        fn bounds(&self) -> Option<Aabb<S>>;
        /// The time of a contact.
        fn time(contact: &Self::Contact) -> S;
    }
}

impl<S: Scalar> sealed::Bounded<S> for Aabb<S> {
    fn bounds(&self) -> Option<Self> {
        Some(*self)
    }

    fn time(contact: &FirstContact<S>) -> S {
        contact.t
    }
}

impl<S: Scalar> sealed::Bounded<S> for Sphere<S> {
    // A sphere has finite numbers, and the box has no others.
    fn bounds(&self) -> Option<Aabb<S>> {
        Aabb::from_center_half_extents(self.center(), [self.radius(); 3]).ok()
    }

    fn time(contact: &SphereContact<S, Feature>) -> S {
        contact.t
    }
}

impl<S: Scalar, I: Index> Tree<'_, S, I> {
    /// The first triangle that a moving box or sphere meets, and the time of impact, if it meets one.
    ///
    /// *Contact*: as [`Sweep::first_contact`]. If the times of several triangles round to the same
    /// number of the scalar, the lowest index wins.
    ///
    /// *Numerics*: exact; the contact returned has the bits of [`Sweep::first_contact`]. *Panics*:
    /// never.
    ///
    /// *Cost*: [`Sweep::first_contact`] for each triangle whose bounding box the box, or the sphere's
    /// bounding box, meets before the first contact. The descent costs as much as in
    /// [`first_hit`](Self::first_hit).
    ///
    /// ```
    /// use septum::mesh::{Mesh, Node, Tree};
    /// use septum::sweep::Motion;
    /// use septum::{Aabb, Axis, Feature, Sphere, Vec3};
    ///
    /// let corners = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [4.0, 4.0, 0.0]].map(Vec3::from);
    /// let floor = Mesh::new(&corners, &[[0_u16, 1, 2], [3, 2, 1]])?;
    /// let (mut nodes, mut order) = ([Node::EMPTY], [0; 2]);
    /// let tree = Tree::build(floor, &mut nodes, &mut order)?;
    ///
    /// let body = Aabb::from_center_half_extents([3.0, 3.0, 9.0], [1.0; 3])?;
    /// let fall = Motion::new([3.0, 3.0, 9.0], [3.0, 3.0, -7.0])?;
    /// let (triangle, first) = tree.first_contact(&body, &fall).unwrap();
    /// assert_eq!((triangle, first.t, first.axis), (0, 0.5, Some(Axis::Face(2))));
    ///
    /// let ball = Sphere::new([3.0, 3.0, 9.0], 1.0)?;
    /// let (triangle, first) = tree.first_contact(&ball, &fall).unwrap();
    /// assert_eq!((triangle, first.t, first.part), (1, 0.5, Some(Feature::Interior)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "time of impact")]
    #[must_use]
    pub fn first_contact<M: Mover<S>>(
        &self,
        shape: &M,
        motion: &Motion<S>,
    ) -> Option<(usize, M::Contact)> {
        self.first_contact_where(shape, motion, |_, _| true)
    }

    /// The first contact for which `accepts` returns `true`: past triangles that do not matter, or
    /// past contacts at the start.
    ///
    /// *Contact*, *Numerics*: as [`first_contact`](Self::first_contact), among the accepted contacts.
    /// *Panics*: never, unless `accepts` does. *Cost*: as
    /// [`first_hit_where`](Self::first_hit_where).
    #[doc(alias = "time of impact")]
    #[doc(alias = "predicate")]
    #[doc(alias = "filter")]
    #[must_use]
    pub fn first_contact_where<M: Mover<S>>(
        &self,
        shape: &M,
        motion: &Motion<S>,
        accepts: impl FnMut(usize, &M::Contact) -> bool,
    ) -> Option<(usize, M::Contact)> {
        let bounds = shape.bounds()?;
        let moving = Moving::new(&self.grid, &bounds, motion, meets_at(&bounds));
        self.first_met(moving, |triangle| shape.first_contact(motion, triangle), M::time, accepts)
    }

    /// The first accepted contact, given that with each triangle, and its time.
    #[inline(always)]
    pub(super) fn first_met<C: Copy>(
        &self,
        moving: Moving<'_, S, impl Fn(&Motion<S>, &Aabb<S>) -> Option<S>>,
        contact: impl Fn(&Triangle<S>) -> Option<C>,
        time: impl Fn(&C) -> S,
        mut accepts: impl FnMut(usize, &C) -> bool,
    ) -> Option<(usize, C)> {
        let mut best: Option<(usize, C)> = None;
        self.pass(moving, |moving, i| {
            let Some(first) = contact(&self.mesh.known(i)) else { return };
            let t = time(&first);
            let so_far = best.map(|(j, other)| (j, time(&other)));
            if is_before(&so_far, t, i) && accepts(i, &first) {
                moving.limit(t);
                best = Some((i, first));
            }
        });
        best
    }

    /// Where on its way can a moving box or sphere stop, at the latest, without overlapping a
    /// triangle, and which triangle blocks the next step? The triangle of the lowest index, if several
    /// do. `None` if the shape overlaps a triangle at the start.
    ///
    /// The place is that of [`Sweep::last_free`] for all triangles: a [`place`](Motion::place) of
    /// the motion to which the straight way is free, with a next step that is not. If the whole
    /// motion is free, the place is [`to`](Motion::to), and no triangle is returned. A shape that
    /// begins in touch may slide along triangles, also across the edges between them, or leave
    /// them.
    ///
    /// *Numerics*: exact: see [`Sweep::last_free`]. *Panics*: never.
    ///
    /// *Cost*: if the motion is free, one descent, with [`Sweep::relation_along`] for each triangle
    /// near the way. Otherwise a descent for each binary digit of the number of steps, except where
    /// the triangle found last blocks the shorter way too.
    ///
    /// ```
    /// use septum::mesh::{Mesh, Node, Tree};
    /// use septum::sweep::Motion;
    /// use septum::{Aabb, Vec3};
    ///
    /// // A floor, and a wall at x = 4.
    /// let corners = [
    ///     [0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [4.0, 4.0, 0.0], [4.0, 0.0, 4.0],
    ///     [4.0, 4.0, 4.0],
    /// ].map(Vec3::from);
    /// let room = Mesh::new(&corners, &[[0_u16, 1, 2], [3, 2, 1], [1, 3, 4], [5, 4, 3]])?;
    /// let (mut nodes, mut order) = ([Node::EMPTY], [0; 4]);
    /// let tree = Tree::build(room, &mut nodes, &mut order)?;
    ///
    /// let body = Aabb::from_center_half_extents([1.0, 2.0, 0.5], [0.5; 3])?; // on the floor
    /// let slide = Motion::new([1.0, 2.0, 0.5], [9.0, 2.0, 0.5])?;
    /// let (place, wall) = tree.last_free(&body, &slide).unwrap();
    /// assert_eq!((place, wall), (Vec3::new(3.5, 2.0, 0.5), Some(2)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "shape cast")]
    #[must_use]
    pub fn last_free<M: Mover<S>>(
        &self,
        shape: &M,
        motion: &Motion<S>,
    ) -> Option<(Vec3<S>, Option<usize>)> {
        let bounds = shape.bounds()?;
        self.last_free_of(&bounds, motion, meets_at(&bounds), |way, triangle| {
            shape.relation_along(way, triangle)
        })
    }

    /// The same, given the box that encloses the shape, when that meets another box on its way, and the
    /// relation of the shape on its way to a triangle.
    #[inline(always)]
    pub(super) fn last_free_of(
        &self,
        bounds: &Aabb<S>,
        motion: &Motion<S>,
        meets_at: impl Fn(&Motion<S>, &Aabb<S>) -> Option<S>,
        relation: impl Fn(&Motion<S>, &Triangle<S>) -> Relation,
    ) -> Option<(Vec3<S>, Option<usize>)> {
        let is_blocked_by =
            |way: &Motion<S>, i: usize| relation(way, &self.mesh.known(i)) == Relation::Overlapping;
        let blocker = |way: &Motion<S>| {
            let mut least: Option<usize> = None;
            self.pass(Moving::new(&self.grid, bounds, way, &meets_at), |_, i| {
                if least.is_none_or(|j| i < j) && is_blocked_by(way, i) {
                    least = Some(i);
                }
            });
            least
        };
        // Each question is about the whole mesh, so that no answer depends on the tree's order. The
        // triangle that blocks a long way often blocks a shorter one.
        let Some(first) = blocker(motion) else { return Some((motion.to(), None)) };
        let known = core::cell::Cell::new(first);
        let is_free = |way: &Motion<S>| {
            if is_blocked_by(way, known.get()) {
                return false;
            }
            blocker(way).map(|i| known.set(i)).is_none()
        };
        let step = motion.last_free_step(motion.steps(), is_free)?;
        Some((motion.place(step), blocker(&motion.until(step + 1))))
    }

    /// Visits the triangles whose boxes a moving box meets, roughly in the order in which it reaches
    /// them; on cores without floats all triangles of a leaf, because boxes cost too much there.
    #[inline(always)]
    fn pass<'m, F: Fn(&Motion<S>, &Aabb<S>) -> Option<S>>(
        &self,
        mut moving: Moving<'m, S, F>,
        mut visit: impl FnMut(&mut Moving<'m, S, F>, usize),
    ) {
        let _ = descend(self.nodes, &self.layout, &mut moving, |moving, leaf| {
            let mut met = Met { mask: 0b1111, sooner: [i32::MIN; 4] };
            if S::IS_FAST {
                let mut boxes = Node::EMPTY;
                for (k, place) in leaf.clone().enumerate() {
                    boxes.set(k, self.mesh.cell(&self.grid, self.index(place)));
                }
                met = moving.meets(&boxes);
            }
            for (k, place) in leaf.enumerate() {
                if met.mask >> k & 1 == 1 && moving.reaches(met.sooner[k % 4]) {
                    visit(moving, self.index(place));
                }
            }
            ControlFlow::Continue(())
        });
    }
}
