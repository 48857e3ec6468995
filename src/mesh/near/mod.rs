//! Meshes near the origin.

mod sweep;

use core::cmp::Ordering;

use fixed::FixedI32;
use fixed::types::extra::LeEqU32;

use super::descent::sealed::Cast;
use super::overlapping::sealed::Bounded;
use super::{Hits, Index, Overlapping, Tree};
use crate::arithmetic::InRaw;
use crate::query::{Hit, HitRules};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Near, Overlaps, Ray, ShapeError, Triangle};

impl<Frac: LeEqU32 + Send + Sync + 'static, I: Index> Tree<'_, FixedI32<Frac>, I> {
    /// The tree, for queries without the code for distant shapes: see [`near`](crate::near).
    ///
    /// *Cost*: three comparisons a vertex; call it once.
    ///
    /// # Errors
    /// [`ShapeError::NotNear`] if a vertex is below −2¹⁷ units in the last place, or 2¹⁷ or more, on some
    /// axis.
    pub fn near(self) -> Result<Near<Self>, ShapeError> {
        let is_near = self.mesh.vertices().iter().all(Near::is_in_range);
        Near::checked(self, is_near)
    }
}

impl<'a, S: Scalar, I: Index> Near<Tree<'a, S, I>> {
    /// [`Tree::overlapping`] without the code for distant shapes. The shape is an [`Aabb`], an
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

/// Rays. Hits have the same bits as in the ordinary tree.
impl<'a, S: Scalar, I: Index> Near<Tree<'a, S, I>>
where
    Near<Ray<S>>: Cast<S>,
{
    /// [`Tree::first_hit`] without the code for distant shapes.
    ///
    /// ```
    /// use fixed::types::I16F16;
    /// use septum::mesh::{Mesh, Node, Tree};
    /// use septum::{Ray, Vec3};
    ///
    /// // A unit in the last place is a micrometre.
    /// let at = |x: i32, y: i32, z: i32| Vec3::from([x, y, z].map(|mm| I16F16::from_bits(1000 * mm)));
    /// let corners = [at(0, 0, 0), at(90, 0, 0), at(0, 90, 0), at(90, 90, 0)];
    /// let mesh = Mesh::new(&corners, &[[0_u16, 1, 2], [3, 2, 1]])?;
    /// let (mut nodes, mut order) = ([Node::EMPTY], [0; 2]);
    /// let floor = Tree::build(mesh, &mut nodes, &mut order)?.near()?;
    /// let down = Ray::new(at(80, 80, 40), at(0, 0, -80))?.near()?;
    /// let (triangle, hit) = floor.first_hit(&down).unwrap();
    /// assert_eq!((triangle, hit.t), (1, I16F16::from_num(0.5)));
    /// let through_the_edge = Ray::new(at(45, 45, 40), at(0, 0, -80))?.near()?;
    /// assert_eq!(floor.first_hit(&through_the_edge).unwrap().0, 0); // the lowest index
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "raycast")]
    #[must_use]
    pub fn first_hit(&self, ray: &Near<Ray<S>>) -> Option<(usize, Hit<S>)> {
        self.first_hit_where(ray, HitRules::new(), |_, _| true)
    }

    /// [`Tree::first_hit_where`] without the code for distant shapes.
    #[must_use]
    pub fn first_hit_where(
        &self,
        ray: &Near<Ray<S>>,
        rules: HitRules,
        accepts: impl FnMut(usize, &Hit<S>) -> bool,
    ) -> Option<(usize, Hit<S>)> {
        self.get().first_of(ray, rules, accepts)
    }

    /// [`Tree::is_hit`] without the code for distant shapes.
    #[must_use]
    pub fn is_hit(&self, ray: &Near<Ray<S>>) -> bool {
        self.is_hit_with(ray, HitRules::new())
    }

    /// [`Tree::is_hit_with`] without the code for distant shapes.
    #[must_use]
    pub fn is_hit_with(&self, ray: &Near<Ray<S>>, rules: HitRules) -> bool {
        self.get().has_hit(ray, rules)
    }

    /// [`Tree::hits_with`] without the code for distant shapes.
    pub fn hits_with<'t>(
        &'t self,
        ray: &Near<Ray<S>>,
        rules: HitRules,
    ) -> Hits<'t, 'a, S, I, Near<Ray<S>>> {
        Hits::new(self.get(), ray, rules)
    }
}

/// For the triangles and the boxes of a near tree alone. Its grid has steps of at most 8 units, and so
/// no box reaches 2²⁰ units.
impl<S: Scalar + InRaw<Raw = i32>> Cast<S> for Near<Ray<S>>
where
    Self: Overlaps<Near<Aabb<S>>>,
{
    #[inline(always)]
    fn ray(&self) -> &Ray<S> {
        self.get()
    }
    #[inline(always)]
    fn until(self, t_max: S) -> Self {
        Self::unchecked(self.get().until(t_max))
    }
    #[inline(always)]
    fn meets(&self, aabb: &Aabb<S>) -> bool {
        self.overlaps(&Near::unchecked(*aabb))
    }
    #[inline(always)]
    fn hit(&self, triangle: &Triangle<S>, rules: HitRules) -> Option<Hit<S>> {
        self.hit_with(&Near::unchecked(*triangle), rules)
    }
    #[inline(always)]
    fn is_hit(&self, triangle: &Triangle<S>, rules: HitRules) -> bool {
        self.is_hit_with(&Near::unchecked(*triangle), rules)
    }
    #[inline(always)]
    fn compare(&self, a: (&Triangle<S>, S), b: (&Triangle<S>, S)) -> Ordering {
        self.compare_found(a, b)
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
    use crate::arithmetic::Each;
    use fixed::types::I16F16;

    use crate::mesh::{Mesh, Node, Tree};
    use crate::{Aabb, Capsule, HitRules, Obb, Ray, ShapeError, Sphere, Vec3};

    pub(super) const MOST: i32 = (1 << 17) - 1;

    /// Triangles of 40 corners, some with corners in common.
    pub(super) fn faces() -> [[u16; 3]; 60] {
        core::array::from_fn(|k| [k, k * 7 + 1, k * 11 + 2].each(|i| (i % 40) as u16))
    }

    #[test]
    fn a_far_vertex_is_refused() {
        for (far, is_known) in
            [(MOST, true), (-MOST - 1, true), (MOST + 1, false), (i32::MIN, false)]
        {
            let corners =
                [[0, 0, 0], [9, 0, 0], [0, 9, far]].each(|p| p.each(I16F16::from_bits).into());
            let mesh = Mesh::new(&corners, &[[0_u16, 1, 2]]).unwrap();
            let (mut nodes, mut order) = ([Node::EMPTY], [0]);
            let near = Tree::build(mesh, &mut nodes, &mut order).unwrap().near();
            assert_eq!(near.map(|_| ()), if is_known { Ok(()) } else { Err(ShapeError::NotNear) });
        }
    }

    /// Rays with ranges that end anywhere, through a mesh on a coarse grid with many hits at one point,
    /// up to the limit.
    #[test]
    fn the_same_triangles_are_hit() {
        let mut random = crate::random::Random(4);
        let mut below = |n: i32| (random.bits() % n as u64) as i32;
        let mut point = |most: i32| -> Vec3<I16F16> {
            let fine = below(2);
            [(); 3]
                .each(|()| I16F16::from_bits((below(9) - 4) * (most >> 2) + below(7) * fine))
                .into()
        };
        let mut near = || loop {
            let p = point(MOST);
            if p.to_array().iter().all(|x| (-MOST - 1..=MOST).contains(&x.to_bits())) {
                break p;
            }
        };
        let corners: [_; 40] = core::array::from_fn(|_| near());
        let faces = faces();
        let mesh = Mesh::new(&corners, &faces).unwrap();
        let (mut nodes, mut order) = ([Node::EMPTY; Node::count_for(60)], [0; 60]);
        let tree = Tree::build(mesh, &mut nodes, &mut order).unwrap();
        let close = tree.near().unwrap();
        let (mut hits, mut ties) = (0, 0);
        for case in 0..6_000 {
            let (p, q) = (near(), near());
            // The direction of a point, of a corner, or up to the limit.
            let to = if case % 2 == 0 { q } else { corners[case % 40] };
            let d = core::array::from_fn(|i| to.to_array()[i] - p.to_array()[i]);
            let d = if case % 3 == 0 { q.to_array().each(|x| x * 4) } else { d };
            let Ok(ray) = Ray::new(p, d) else { continue };
            let end = q.to_array()[0];
            let ranges = [
                Some(ray),
                ray.with_range(None, end).ok(),
                ray.with_range(end.min(-end), I16F16::MAX).ok(),
                ray.with_range(I16F16::ZERO, end.abs()).ok(),
            ];
            for ray in ranges.into_iter().flatten() {
                let near = ray.near().unwrap();
                let first = tree.first_hit(&ray);
                assert_eq!(close.first_hit(&near), first, "{ray:?}");
                assert_eq!(close.is_hit(&near), first.is_some());
                for rules in [HitRules::new(), HitRules::new().once()] {
                    assert!(close.hits_with(&near, rules).eq(tree.hits_with(&ray, rules)));
                    let without_first = |i: usize| first.is_none_or(|(j, _)| i != j);
                    let next = close.first_hit_where(&near, rules, |i, _| without_first(i));
                    assert_eq!(next, tree.first_hit_where(&ray, rules, |i, _| without_first(i)));
                    assert_eq!(close.is_hit_with(&near, rules), tree.is_hit_with(&ray, rules));
                    let is_tie = |t| first.is_some_and(|(_, hit)| hit.t == t);
                    ties += u32::from(next.is_some_and(|(_, hit)| is_tie(hit.t)));
                }
                hits += u32::from(first.is_some());
            }
        }
        assert!(hits > 3_000 && ties > 1_000, "{hits} {ties}");
    }

    /// A mesh on a coarse grid, where shapes often touch, up to the limit.
    #[test]
    fn the_same_triangles_overlap() {
        let mut random = crate::random::Random(3);
        let mut below = |n: i32| (random.bits() % n as u64) as i32;
        let mut point = || -> Vec3<I16F16> {
            [(); 3].each(|()| I16F16::from_bits((below(9) - 4) * (MOST >> 2))).into()
        };
        let corners: [_; 40] = core::array::from_fn(|_| point());
        let faces = faces();
        let mesh = Mesh::new(&corners, &faces).unwrap();
        let (mut nodes, mut order) = ([Node::EMPTY; Node::count_for(60)], [0; 60]);
        let tree = Tree::build(mesh, &mut nodes, &mut order).unwrap();
        let near = tree.near().unwrap();
        let mut met = [0; 4];
        for _ in 0..3_000 {
            let (p, q) = (point(), point());
            let half = q.to_array().each(|x| x.abs() >> 2);
            let radius = half[0];
            let axes = [point(), point(), point()].each(|u| u.to_array().each(|x| x >> 1));
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
