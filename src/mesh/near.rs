//! Meshes near the origin.

use fixed::FixedI32;
use fixed::types::extra::LeEqU32;

use super::overlapping::sealed::Bounded;
use super::{Index, Overlapping, Tree};
use crate::scalar::Scalar;
use crate::shape::{Near, Overlaps, ShapeError, Triangle};

impl<Frac: LeEqU32 + Send + Sync + 'static, I: Index> Tree<'_, FixedI32<Frac>, I> {
    /// The tree, for queries without the code for distant shapes: see [`near`](crate::near).
    ///
    /// *Cost*: three comparisons a vertex; call it once.
    ///
    /// # Errors
    /// [`ShapeError::NotNear`] if a vertex is 2¹⁷ units in the last place or more from zero on some
    /// axis.
    pub fn near(self) -> Result<Near<Self>, ShapeError> {
        let is_near = self.mesh.vertices().iter().all(Near::is_in_range);
        if is_near { Ok(Near::unchecked(self)) } else { Err(ShapeError::NotNear) }
    }
}

impl<'a, S: Scalar, I: Index> Near<Tree<'a, S, I>> {
    /// [`Tree::overlapping`] without the code for distant shapes. The shape is an [`Aabb`](crate::Aabb), an
    /// [`Obb`](crate::Obb), a [`Sphere`](crate::Sphere) or a [`Capsule`](crate::Capsule).
    ///
    /// ```
    /// use fixed::types::I16F16;
    /// use septum::mesh::{Mesh, Node, Tree};
    /// use septum::{Sphere, Vec3};
    ///
    /// // A unit in the last place is a micrometre.
    /// let at = |x: i32, y: i32, z: i32| Vec3::from([x, y, z].map(|mm| I16F16::from_bits(1000 * mm)));
    /// let corners = [at(0, 0, 0), at(90, 0, 0), at(0, 90, 0), at(90, 90, 0)];
    /// let mesh = Mesh::new(&corners, &[[0_u16, 1, 2], [3, 2, 1]])?;
    /// let (mut nodes, mut order) = ([Node::EMPTY], [0; 2]);
    /// let floor = Tree::build(mesh, &mut nodes, &mut order)?.near()?;
    /// let ball = Sphere::new(at(20, 20, 5), I16F16::from_bits(5000))?.near()?;
    /// assert!(floor.overlapping(&ball).eq([0])); // it rests on one of the triangles
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn overlapping<'t, P>(&'t self, shape: &'t Near<P>) -> Overlapping<'t, 'a, S, I, Near<P>>
    where
        Near<P>: Bounded<S>,
    {
        Overlapping::new(self.get(), shape)
    }
}

/// For triangles near the origin alone.
impl<S: Scalar, P: Bounded<S>> Bounded<S> for Near<P>
where
    Near<Triangle<S>>: Overlaps<Self>,
{
    type Prepared = ();

    fn prepared(&self) {}

    fn overlaps_prepared(&self, (): &(), triangle: &Triangle<S>) -> bool {
        Near::unchecked(*triangle).overlaps(self)
    }

    fn corners(&self) -> Option<[[S; 3]; 2]> {
        self.get().corners()
    }
}

#[cfg(test)]
mod tests {
    use fixed::types::I16F16;

    use crate::mesh::{Mesh, Node, Tree};
    use crate::{Aabb, Capsule, Obb, ShapeError, Sphere, Vec3};

    const MOST: i32 = (1 << 17) - 1;

    #[test]
    fn a_far_vertex_is_refused() {
        for (far, is_known) in
            [(MOST, true), (-MOST - 1, true), (MOST + 1, false), (i32::MIN, false)]
        {
            let corners =
                [[0, 0, 0], [9, 0, 0], [0, 9, far]].map(|p| p.map(I16F16::from_bits).into());
            let mesh = Mesh::new(&corners, &[[0_u16, 1, 2]]).unwrap();
            let (mut nodes, mut order) = ([Node::EMPTY], [0]);
            let near = Tree::build(mesh, &mut nodes, &mut order).unwrap().near();
            assert_eq!(near.map(|_| ()), if is_known { Ok(()) } else { Err(ShapeError::NotNear) });
        }
    }

    /// A mesh on a coarse grid, where shapes often touch, up to the limit.
    #[test]
    fn the_same_triangles_overlap() {
        let mut random = crate::random::Random(3);
        let mut below = |n: i32| (random.bits() % n as u64) as i32;
        let mut point = || -> Vec3<I16F16> {
            [(); 3].map(|()| I16F16::from_bits((below(9) - 4) * (MOST >> 2))).into()
        };
        let corners: [_; 40] = core::array::from_fn(|_| point());
        let faces: [_; 60] =
            core::array::from_fn(|k| [k, k * 7 + 1, k * 11 + 2].map(|i| (i % 40) as u16));
        let mesh = Mesh::new(&corners, &faces).unwrap();
        let (mut nodes, mut order) = ([Node::EMPTY; Node::count_for(60)], [0; 60]);
        let tree = Tree::build(mesh, &mut nodes, &mut order).unwrap();
        let near = tree.near().unwrap();
        let mut met = [0; 4];
        for _ in 0..3_000 {
            let (p, q) = (point(), point());
            let half = q.to_array().map(|x| x.abs() >> 2);
            let radius = half[0];
            let axes = [point(), point(), point()].map(|u| u.to_array().map(|x| x >> 1));
            if let Ok(aabb) = Aabb::from_center_half_extents(p, half).unwrap().near() {
                assert!(near.overlapping(&aabb).eq(tree.overlapping(aabb.get())));
                met[0] += near.overlapping(&aabb).count();
            }
            if let Ok(obb) = Obb::from_skewed_axes(p, axes, half) {
                let obb = obb.near().unwrap();
                assert!(near.overlapping(&obb).eq(tree.overlapping(obb.get())));
                met[1] += near.overlapping(&obb).count();
            }
            let sphere = Sphere::new(p, radius).unwrap().near().unwrap();
            assert!(near.overlapping(&sphere).eq(tree.overlapping(sphere.get())));
            met[2] += near.overlapping(&sphere).count();
            let capsule = Capsule::new(p, q, radius).unwrap().near().unwrap();
            assert!(near.overlapping(&capsule).eq(tree.overlapping(capsule.get())));
            met[3] += near.overlapping(&capsule).count();
        }
        assert!(met.iter().all(|&n| n > 3_000), "{met:?}");
    }
}
