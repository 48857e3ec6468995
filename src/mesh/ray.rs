//! Ray casts through a tree.

use core::ops::{ControlFlow, Range};

use super::descent::Descent;
use super::descent::sealed::Cast;
use super::node::Node;
use super::walk::{Descend, Walk, descend};
use super::{Index, Tree};
use crate::arithmetic::REGISTERS_ARE_WIDE;
use crate::query::{Feature, Hit, HitRules, clear_misses};
use crate::scalar::Scalar;
use crate::shape::{Ray, Triangle, Vec3};

impl<'a, S: Scalar, I: Index> Tree<'a, S, I> {
    /// The first triangle that a ray hits, and the hit, if there is one.
    ///
    /// *Contact*: as [`Ray::hit`]. If several triangles are hit at the same point, as at a shared
    /// edge, the lowest index wins.
    ///
    /// *Numerics*: exact. Hits are ordered by their true t, as by [`Ray::compare_hits`], and the
    /// hit returned has the bits of [`Ray::hit`]. *Panics*: never.
    ///
    /// *Cost*: [`Ray::hit`] for each triangle in a leaf that the ray meets before its first hit, with
    /// vectors only for those that it does not clearly miss. On
    /// the way down, four boxes together take 24 multiplications in `f32`; in fixed point on 32-bit
    /// cores each box takes one [`Ray::overlaps`]. The stack has room for 104 places, 832 bytes; on
    /// 32-bit cores for 52, 416 bytes.
    ///
    /// See [`Tree`] for an example.
    #[doc(alias = "raycast")]
    #[must_use]
    pub fn first_hit(&self, ray: &Ray<S>) -> Option<(usize, Hit<S>)> {
        self.first_hit_with(ray, HitRules::new())
    }

    /// [`first_hit`](Self::first_hit) under other rules, such as culling.
    #[must_use]
    pub fn first_hit_with(&self, ray: &Ray<S>, rules: HitRules) -> Option<(usize, Hit<S>)> {
        self.first_hit_where(ray, rules, |_, _| true)
    }

    /// The first hit for which `accepts` returns `true`: past the triangle from which the ray
    /// starts, past layers that do not matter, or through holes of a texture, by u and v of the hit.
    ///
    /// *Contact*, *Numerics*: as [`first_hit`](Self::first_hit), among the accepted hits. *Panics*:
    /// never, unless `accepts` does.
    ///
    /// *Cost*: as [`first_hit`](Self::first_hit), with the first accepted hit in place of the first.
    /// `accepts` is called for each hit that would be first so far. Their order depends on the tree,
    /// but the result does not, if each hit always gets the same verdict. For any accepted hit, in
    /// place of the first, see [`hits`](Self::hits).
    ///
    /// ```
    /// use septum::mesh::{Mesh, Node, Tree};
    /// use septum::{HitRules, Ray, Vec3};
    ///
    /// // Two sheets, one above the other.
    /// let corners = [
    ///     [0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0],
    ///     [0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [0.0, 4.0, 1.0],
    /// ].map(Vec3::from);
    /// let mesh = Mesh::new(&corners, &[[0_u16, 1, 2], [3, 4, 5]])?;
    /// let (mut nodes, mut order) = ([Node::EMPTY], [0; 2]);
    /// let tree = Tree::build(mesh, &mut nodes, &mut order)?;
    ///
    /// let down = Ray::new([1.0, 1.0, 3.0], [0.0, 0.0, -1.0])?;
    /// assert_eq!(tree.first_hit(&down).unwrap().0, 1);
    /// let below = tree.first_hit_where(&down, HitRules::new(), |i, _| i != 1);
    /// assert_eq!(below.map(|(i, hit)| (i, hit.t)), Some((0, 3.0)));
    /// assert!(tree.hits(&down).any(|(i, _)| i != 1)); // any accepted hit
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "raycast")]
    #[doc(alias = "predicate")]
    #[doc(alias = "filter")]
    #[must_use]
    pub fn first_hit_where(
        &self,
        ray: &Ray<S>,
        rules: HitRules,
        accepts: impl FnMut(usize, &Hit<S>) -> bool,
    ) -> Option<(usize, Hit<S>)> {
        self.first_of(ray, rules, accepts)
    }

    #[inline(always)]
    pub(super) fn first_of<R: Cast<S>>(
        &self,
        ray: &R,
        rules: HitRules,
        mut accepts: impl FnMut(usize, &Hit<S>) -> bool,
    ) -> Option<(usize, Hit<S>)> {
        let mut descent = Descent::new(&self.grid, ray);
        let mut best: Option<(usize, Hit<S>)> = None;
        let _ = descend(self.nodes, &self.layout, &mut descent, |descent, leaf| {
            for i in self.not_missed(ray.ray(), leaf).map(|place| self.index(place)) {
                let Some(hit) = ray.hit(&self.mesh.known(i), rules) else { continue };
                let is_first =
                    best.is_none_or(|best| self.is_before(ray, (i, &hit), (best.0, &best.1)));
                if is_first && accepts(i, &hit) {
                    descent.limit(hit.t);
                    best = Some((i, hit));
                }
            }
            ControlFlow::Continue(())
        });
        best
    }

    /// The triangles of a leaf that the ray does not clearly miss.
    #[inline(always)]
    fn not_missed(&self, ray: &Ray<S>, leaf: Range<usize>) -> Near {
        let last = leaf.end.saturating_sub(1);
        let triangle = |k: usize| self.mesh.known(self.index(last.min(leaf.start + k)));
        let missed = clear_misses(ray, [triangle(0), triangle(1), triangle(2), triangle(3)]);
        Near { from: leaf.start, left: !missed & ((1 << leaf.len()) - 1) }
    }

    /// Whether hit `a` comes before hit `b` along the ray, or has the lower index if they tie.
    fn is_before<R: Cast<S>>(
        &self,
        ray: &R,
        (i, a): (usize, &Hit<S>),
        (j, b): (usize, &Hit<S>),
    ) -> bool {
        let (of_a, of_b) = (self.mesh.known(i), self.mesh.known(j));
        // A shortcut to the answer that the exact comparison would give.
        if is_same(&met(&of_a, a.feature), &met(&of_b, b.feature)) {
            return i < j;
        }
        ray.compare((&of_a, a.t), (&of_b, b.t)).then(i.cmp(&j)).is_lt()
    }

    /// Does a ray hit any triangle?
    ///
    /// *Contact*, *Numerics*: exact, as [`Ray::is_hit`]. *Panics*: never. *Cost*: as
    /// [`first_hit`](Self::first_hit), but it stops at any hit, divides nothing, and on 32-bit cores
    /// needs no stack. Use it for shadows and lines of sight.
    #[doc(alias = "raycast")]
    #[must_use]
    pub fn is_hit(&self, ray: &Ray<S>) -> bool {
        self.is_hit_with(ray, HitRules::new())
    }

    /// [`is_hit`](Self::is_hit) under other rules, such as culling.
    #[must_use]
    pub fn is_hit_with(&self, ray: &Ray<S>, rules: HitRules) -> bool {
        self.has_hit(ray, rules)
    }

    #[inline(always)]
    pub(super) fn has_hit<R: Cast<S>>(&self, ray: &R, rules: HitRules) -> bool {
        let is_hit = |i: usize| ray.is_hit(&self.mesh.known(i), rules);
        if !REGISTERS_ARE_WIDE {
            return LeafTriangles::new(self, ray).any(is_hit);
        }
        let mut descent = Descent::new(&self.grid, ray);
        descend(self.nodes, &self.layout, &mut descent, |_, leaf| {
            if self.not_missed(ray.ray(), leaf).any(|place| is_hit(self.index(place))) {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        })
        .is_break()
    }

    /// All triangles that a ray hits, with their hits, in the tree's order.
    ///
    /// *Contact*, *Numerics*: exact, as [`Ray::hit`]. *Panics*: never. *Cost*: [`Ray::hit`] for
    /// each triangle in a leaf that the ray meets. It needs no stack.
    ///
    /// ```
    /// use septum::mesh::{Mesh, Node, Tree};
    /// use septum::{HitRules, Ray, Vec3};
    ///
    /// let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]].map(Vec3::from);
    /// let mesh = Mesh::new(&corners, &[[0_u16, 1, 2], [3, 2, 1]])?;
    /// let (mut nodes, mut order) = ([Node::EMPTY], [0; 2]);
    /// let tree = Tree::build(mesh, &mut nodes, &mut order)?;
    ///
    /// let through_the_edge = Ray::new([0.5, 0.5, 1.0], [0.0, 0.0, -1.0])?;
    /// assert_eq!(tree.hits(&through_the_edge).count(), 2);
    /// assert_eq!(tree.hits_with(&through_the_edge, HitRules::new().once()).count(), 1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn hits<'t>(&'t self, ray: &Ray<S>) -> Hits<'t, 'a, S, I> {
        self.hits_with(ray, HitRules::new())
    }

    /// [`hits`](Self::hits) under other rules, such as culling.
    pub fn hits_with<'t>(&'t self, ray: &Ray<S>, rules: HitRules) -> Hits<'t, 'a, S, I> {
        Hits::new(self, ray, rules)
    }
}

/// The ends of the edge that was hit, or the vertex twice; `None` for the interior.
pub(super) fn met<S: Scalar>(triangle: &Triangle<S>, feature: Feature) -> Option<[Vec3<S>; 2]> {
    let [a, b, c] = *triangle.vertices();
    match feature {
        Feature::Interior => None,
        Feature::Edge(0) => Some([a, b]),
        Feature::Edge(1) => Some([b, c]),
        Feature::Edge(_) => Some([c, a]),
        Feature::Vertex(0) => Some([a; 2]),
        Feature::Vertex(1) => Some([b; 2]),
        Feature::Vertex(_) => Some([c; 2]),
    }
}

/// Whether two triangles were hit at the same edge or vertex. Then they were hit at the same point,
/// because a ray along an edge hits neither triangle.
pub(super) fn is_same<S: Scalar>(a: &Option<[Vec3<S>; 2]>, b: &Option<[Vec3<S>; 2]>) -> bool {
    match (a, b) {
        (Some([a, b]), Some([c, d])) => (a == c) & (b == d) | (a == d) & (b == c),
        _ => false,
    }
}

/// Some triangles of a leaf, by their place in the tree's order.
#[derive(Clone, Debug)]
struct Near {
    from: usize,
    /// Bit k stands for the triangle at `from` + k.
    left: u32,
}

impl Iterator for Near {
    type Item = usize;

    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        let k = self.left.trailing_zeros() as usize;
        self.left &= self.left.checked_sub(1)?;
        Some(self.from + k)
    }
}

/// The triangles in the leaves that a ray meets.
#[derive(Clone, Debug)]
struct LeafTriangles<'t, 'a, S: Scalar, I, R> {
    tree: &'t Tree<'a, S, I>,
    descent: Descent<S, R>,
    walk: Walk,
    leaf: Near,
}

impl<'t, 'a, S: Scalar, I: Index, R: Cast<S>> LeafTriangles<'t, 'a, S, I, R> {
    fn new(tree: &'t Tree<'a, S, I>, ray: &R) -> Self {
        let descent = Descent::new(&tree.grid, ray);
        let walk = Walk::new(tree.nodes, |root| descent.meets(root).mask);
        Self { tree, descent, walk, leaf: Near { from: 0, left: 0 } }
    }
}

impl<S: Scalar, I: Index, R: Cast<S>> Iterator for LeafTriangles<'_, '_, S, I, R> {
    /// The index of a triangle.
    type Item = usize;

    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        loop {
            if let Some(place) = self.leaf.next() {
                return Some(self.tree.index(place));
            }
            let mask = |node: &Node| self.descent.meets(node).mask;
            let leaf = self.walk.next(self.tree.nodes, &self.tree.layout, mask)?;
            self.leaf = self.tree.not_missed(self.descent.ray.ray(), leaf);
        }
    }
}

/// The triangles that a ray hits: see [`Tree::hits`].
#[derive(Clone, Debug)]
pub struct Hits<'t, 'a, S: Scalar, I, R = Ray<S>> {
    near: LeafTriangles<'t, 'a, S, I, R>,
    rules: HitRules,
}

impl<'t, 'a, S: Scalar, I: Index, R: Cast<S>> Hits<'t, 'a, S, I, R> {
    pub(super) fn new(tree: &'t Tree<'a, S, I>, ray: &R, rules: HitRules) -> Self {
        Self { near: LeafTriangles::new(tree, ray), rules }
    }
}

impl<S: Scalar, I: Index, R: Cast<S>> Iterator for Hits<'_, '_, S, I, R> {
    type Item = (usize, Hit<S>);

    fn next(&mut self) -> Option<Self::Item> {
        loop {
            let i = self.near.next()?;
            let triangle = self.near.tree.mesh.known(i);
            if let Some(hit) = self.near.descent.ray.hit(&triangle, self.rules) {
                return Some((i, hit));
            }
        }
    }
}
