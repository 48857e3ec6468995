//! Boxes that move past meshes near the origin.

use super::super::moving_box;
use super::{Index, Tree};
use crate::arithmetic::{Embeds, InRaw, IntNear};
use crate::query::{FirstContact, Motion, Moving};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Near, Triangle, Vec3};

/// Moving boxes. Contacts have the same bits as in the ordinary tree.
impl<S: Scalar + InRaw<Raw = i32>, I: Index> Near<Tree<'_, S, I>>
where
    IntNear: Embeds<S>,
{
    /// [`Tree::first_contact`] of a box without the code for distant shapes.
    ///
    /// ```
    /// use fixed::types::I16F16;
    /// use septum::mesh::{Mesh, Node, Tree};
    /// use septum::sweep::Motion;
    /// use septum::{Aabb, Axis, Vec3};
    ///
    /// // A unit in the last place is a micrometre.
    /// let at = |x: i32, y: i32, z: i32| Vec3::from([x, y, z].map(|mm| I16F16::from_bits(1000 * mm)));
    /// let corners = [at(0, 0, 0), at(90, 0, 0), at(0, 90, 0), at(90, 90, 0)];
    /// let mesh = Mesh::new(&corners, &[[0_u16, 1, 2], [3, 2, 1]])?;
    /// let (mut nodes, mut order) = ([Node::EMPTY], [0; 2]);
    /// let floor = Tree::build(mesh, &mut nodes, &mut order)?.near()?;
    /// let body = Aabb::from_center_half_extents(at(80, 80, 90), at(10, 10, 10))?.near()?;
    /// let falling = body.moving(Motion::new(at(0, 0, 90), at(0, 0, -70))?)?;
    /// let (triangle, first) = floor.first_contact(&falling).unwrap();
    /// assert_eq!((triangle, first.t, first.axis), (1, I16F16::from_num(0.5), Some(Axis::Face(2))));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "time of impact")]
    #[must_use]
    pub fn first_contact(&self, aabb: &Moving<Aabb<S>, S>) -> Option<(usize, FirstContact<S>)> {
        self.first_contact_where(aabb, |_, _| true)
    }

    /// [`Tree::first_contact_where`] of a box without the code for distant shapes.
    #[must_use]
    pub fn first_contact_where(
        &self,
        aabb: &Moving<Aabb<S>, S>,
        accepts: impl FnMut(usize, &FirstContact<S>) -> bool,
    ) -> Option<(usize, FirstContact<S>)> {
        let (tree, shape) = (self.get(), aabb.shape().get());
        let way = moving_box::Moving::new(&tree.grid, shape, aabb.motion(), meets_at(aabb));
        let contact = |triangle: &Triangle<S>| aabb.first_contact(&Near::unchecked(*triangle));
        tree.first_met(way, contact, |first| first.t, accepts)
    }

    /// [`Tree::last_free`] of a box without the code for distant shapes.
    ///
    /// ```
    /// use fixed::types::I16F16;
    /// use septum::mesh::{Mesh, Node, Tree};
    /// use septum::sweep::Motion;
    /// use septum::{Aabb, Vec3};
    ///
    /// // A unit in the last place is a micrometre: a floor, and a wall at x = 90.
    /// let at = |x: i32, y: i32, z: i32| Vec3::from([x, y, z].map(|mm| I16F16::from_bits(1000 * mm)));
    /// let corners = [
    ///     at(0, 0, 0), at(90, 0, 0), at(0, 90, 0), at(90, 90, 0), at(90, 0, 90), at(90, 90, 90),
    /// ];
    /// let room = Mesh::new(&corners, &[[0_u16, 1, 2], [3, 2, 1], [1, 3, 4], [5, 4, 3]])?;
    /// let (mut nodes, mut order) = ([Node::EMPTY], [0; 4]);
    /// let room = Tree::build(room, &mut nodes, &mut order)?.near()?;
    /// let body = Aabb::from_center_half_extents(at(20, 40, 10), at(10, 10, 10))?.near()?;
    /// let slide = body.moving(Motion::new(at(20, 40, 10), at(110, 40, 10))?)?;
    /// let (place, wall) = room.last_free(&slide).unwrap();
    /// assert_eq!((place, wall), (at(80, 40, 10), Some(2))); // along the floor, to the wall
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "shape cast")]
    #[must_use]
    pub fn last_free(&self, aabb: &Moving<Aabb<S>, S>) -> Option<(Vec3<S>, Option<usize>)> {
        let relation = |way: &Motion<S>, triangle: &Triangle<S>| {
            aabb.along(way).relation_along(&Near::unchecked(*triangle))
        };
        self.get().last_free_of(aabb.shape().get(), aabb.motion(), meets_at(aabb), relation)
    }
}

/// When a box near the origin meets a box of the tree on a part of its way.
fn meets_at<S: Scalar>(aabb: &Moving<Aabb<S>, S>) -> impl Fn(&Motion<S>, &Aabb<S>) -> Option<S>
where
    IntNear: Embeds<S>,
{
    |way, cell| aabb.along(way).meets_at(cell)
}

#[cfg(test)]
mod tests {
    use fixed::types::I16F16;

    use super::super::tests::{MOST, faces};
    use crate::arithmetic::Each;
    use crate::mesh::{Mesh, Node, Tree};
    use crate::sweep::Motion;
    use crate::{Aabb, Vec3};

    /// A mesh on a coarse grid, where shapes often touch, up to the limit.
    #[test]
    fn the_same_triangles_are_met() {
        let mut random = crate::random::Random(5);
        let mut point = || -> Vec3<I16F16> {
            [(); 3].each(|()| I16F16::from_bits((random.below(9) as i32 - 4) * (MOST >> 2))).into()
        };
        let corners: [_; 40] = core::array::from_fn(|_| point());
        let faces = faces();
        let mesh = Mesh::new(&corners, &faces).unwrap();
        let (mut nodes, mut order) = ([Node::EMPTY; Node::count_for(60)], [0; 60]);
        let tree = Tree::build(mesh, &mut nodes, &mut order).unwrap();
        let near = tree.near().unwrap();
        let (mut met, mut later, mut stops) = (0, 0, [0; 4]);
        for n in 0..3_000 {
            // Some lie between the corners of the grid, and are small.
            let (center, down) = (point().to_array(), [2, 2, 5][n % 3]);
            let center = center.each(|x| x - I16F16::from_bits(MOST >> 4) * ((n / 3 % 2) as i32));
            let half = point().to_array().each(|x| x.abs() >> down);
            let Ok(aabb) = Aabb::from_center_half_extents(center, half).unwrap().near() else {
                continue;
            };
            let motion = Motion::new(center, point()).unwrap();
            let Ok(moving) = aabb.moving(motion) else { continue };
            let first = tree.first_contact(aabb.get(), &motion);
            assert_eq!(near.first_contact(&moving), first, "{moving:?}");
            let is_next = |i: usize| first.is_none_or(|(j, _)| i != j);
            let next = tree.first_contact_where(aabb.get(), &motion, |i, _| is_next(i));
            assert_eq!(near.first_contact_where(&moving, |i, _| is_next(i)), next);
            met += usize::from(first.is_some());
            later += usize::from(next.is_some_and(|(_, first)| first.axis.is_some()));
            let stop = tree.last_free(aabb.get(), &motion);
            assert_eq!(near.last_free(&moving), stop, "{moving:?}");
            stops[match stop {
                None => 0,
                Some((_, None)) => 1,
                Some((place, Some(_))) => 2 + usize::from(place != motion.from()),
            }] += 1;
        }
        assert!(met > 300 && later > 100, "{met} {later}");
        // Inside at the start, free to the end, blocked at the start, and on the way.
        assert!(stops.iter().zip([200, 30, 5, 200]).all(|(&n, least)| n > least), "{stops:?}");
    }
}
