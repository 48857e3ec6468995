//! The contacts of a shape with a whole mesh, and the interior edges of a surface, on which nothing may
//! catch.

use core::cmp::Ordering;

use super::body::Body;
use super::{Contact, ContactWith, contact_in_mesh};
use crate::arithmetic::{Each, pick, three, turn};
use crate::mesh::{Index, Mesh, MeshError, Overlapping, Probe, Tree, by_place, sort};
use crate::robust::{self, differences};
use crate::scalar::Scalar;
use crate::shape::Triangle;

impl<'a, S: Scalar, I: Index> Tree<'a, S, I> {
    /// The contacts of a shape with the mesh: for each triangle that the shape penetrates, its index
    /// and its contact manifold, in the tree's order. The shape is an [`Aabb`](crate::Aabb), an
    /// [`Obb`](crate::Obb), a [`Triangle`], a [`Sphere`](crate::Sphere) or a
    /// [`Capsule`](crate::Capsule).
    ///
    /// `interior` has the interior edges of each triangle, by its index in the mesh, as
    /// [`interior_edges`] computes them. With them no contact is a
    /// ghost collision: a translation that leads across an interior edge is replaced by one along
    /// the triangle's normal, and [`Contact::is_held`] is `true`.
    ///
    /// *Geometry*: each contact has the bits of [`contact_in_mesh`]. The triangle is the first
    /// shape of the contact, so the shape moves by minus the vector.
    ///
    /// *Contact*: triangles that only touch the shape have none. *Numerics*: exact, with rounded
    /// points: see [the module](crate::contact). *Panics*: never.
    ///
    /// *Cost*: the walk of [`overlapping`](Self::overlapping), and [`contact_in_mesh`] for each
    /// triangle that it finds. The iterator computes a contact when it is asked for it, and keeps
    /// none.
    ///
    /// # Errors
    /// [`MeshError::Length`] if `interior` has fewer entries than the mesh has triangles.
    ///
    /// ```
    /// use septum::contact::{InteriorEdges, interior_edges};
    /// use septum::mesh::{Mesh, Node, Tree};
    /// use septum::{Aabb, Vec3};
    ///
    /// let corners = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [4.0, 4.0, 0.0]].map(Vec3::from);
    /// let floor = Mesh::new(&corners, &[[0_u16, 1, 2], [3, 2, 1]])?;
    /// let mut interior = [InteriorEdges::NONE; 2];
    /// interior_edges(&floor, &mut [(0, 0); 6], &mut interior)?;
    /// let (mut nodes, mut order) = ([Node::EMPTY], [0; 2]);
    /// let tree = Tree::build(floor, &mut nodes, &mut order)?;
    ///
    /// // A crate that sank a sixteenth into the floor, over its diagonal.
    /// let sunk = Aabb::from_min_max([1.0, 2.0, -0.0625], [2.0, 2.5, 0.9375])?;
    /// let mut found = 0;
    /// for (triangle, contact) in tree.contacts(&sunk, &interior)? {
    ///     assert_eq!(contact.translation.vector.to_array(), [0.0, 0.0, -0.0625]);
    ///     assert!(triangle < 2 && !contact.points().is_empty());
    ///     found += 1;
    /// }
    /// assert_eq!(found, 2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "manifold")]
    #[doc(alias = "ghost collision")]
    #[doc(alias = "penetration")]
    pub fn contacts<'t, P: Probe<S>>(
        &'t self,
        shape: &'t P,
        interior: &'t [InteriorEdges],
    ) -> Result<Contacts<'t, 'a, S, I, P>, MeshError>
    where
        Triangle<S>: ContactWith<S, P>,
    {
        let needed = self.mesh().triangles().len();
        if interior.len() < needed {
            return Err(MeshError::Length { needed });
        }
        Ok(Contacts { tree: self, shape, interior, overlapping: self.overlapping(shape) })
    }
}

/// The contacts of a shape with a mesh: see [`Tree::contacts`].
#[derive(Clone, Debug)]
pub struct Contacts<'t, 'a, S: Scalar, I, P: Probe<S>> {
    tree: &'t Tree<'a, S, I>,
    shape: &'t P,
    interior: &'t [InteriorEdges],
    overlapping: Overlapping<'t, 'a, S, I, P>,
}

impl<S: Scalar, I: Index, P: Probe<S>> Iterator for Contacts<'_, '_, S, I, P>
where
    Triangle<S>: ContactWith<S, P>,
{
    type Item = (usize, Contact<S>);

    fn next(&mut self) -> Option<Self::Item> {
        let Self { tree, shape, interior, .. } = *self;
        self.overlapping.find_map(|i| {
            let edges = interior.get(i).copied().unwrap_or_default();
            Some((i, contact_in_mesh(&tree.mesh().known(i), edges, shape)?))
        })
    }
}

/// The edges of a triangle that are interior to the surface of a mesh, one bit each.
///
/// An edge is interior if the surface continues beyond it, level or upward. A body that rests on
/// the triangle there rests on its neighbour too, so no direction across the edge leads out.
///
/// ```
/// use septum::contact::InteriorEdges;
///
/// let two = InteriorEdges::new([true, false, true]);
/// assert!(two.contains(0) && !two.contains(1) && two != InteriorEdges::NONE);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(transparent)]
pub struct InteriorEdges(u8);

impl InteriorEdges {
    /// No edge is interior: the triangle stands alone.
    pub const NONE: Self = Self(0);
    /// All three edges are interior.
    pub const ALL: Self = Self(7);

    /// The set of interior edges; edge k goes from vertex k to the next.
    #[must_use]
    pub const fn new(edges: [bool; 3]) -> Self {
        Self(edges[0] as u8 | (edges[1] as u8) << 1 | (edges[2] as u8) << 2)
    }

    /// Whether edge `k` is interior.
    #[must_use]
    pub const fn contains(self, k: usize) -> bool {
        k < 3 && self.0 >> k & 1 == 1
    }

    fn add(&mut self, k: u8) {
        self.0 |= 1 << (k % 3);
    }
}

/// Which edges of each triangle of a mesh are interior? The answer goes into `edges`.
///
/// *Geometry*: an edge that exactly two triangles share is interior in two cases. Either the
/// triangles lie in one plane, side by side, or each triangle lies above its neighbour's plane;
/// above is the side from which the neighbour's vertices go counterclockwise. Border edges and
/// edges of three or more triangles are not interior. If two neighbours are oriented oppositely,
/// they have no common upper side, and their edge is interior only if they lie in one plane. An
/// edge of a triangle that is a segment or a point is not interior. Edges are compared by the
/// positions of their ends, not by indices.
///
/// *Numerics*: exact. *Panics*: never. *Cost*: sorts the edges in `scratch`, three for each
/// triangle, and evaluates a determinant or two for each pair.
///
/// # Errors
/// [`MeshError::Length`] if `scratch` has fewer than three entries for each triangle, or `edges`
/// fewer than one.
///
/// ```
/// use septum::Vec3;
/// use septum::contact::{InteriorEdges, interior_edges};
/// use septum::mesh::{Mesh, MeshError};
///
/// // A square in two triangles, and a wall on its first edge.
/// let vertices = [
///     [0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0], [1.0, 0.0, 2.0],
/// ].map(Vec3::from);
/// let mesh = Mesh::new(&vertices, &[[0_u16, 1, 2], [0, 2, 3], [1, 0, 4]])?;
/// let mut edges = [InteriorEdges::NONE; 3];
/// interior_edges(&mesh, &mut [(0, 0); 9], &mut edges)?;
/// assert_eq!(edges[0], InteriorEdges::new([true, false, true])); // to the wall, to the diagonal
/// assert_eq!(edges[1], InteriorEdges::new([true, false, false]));
/// assert_eq!(edges[2], InteriorEdges::new([true, false, false]));
/// # Ok::<(), MeshError>(())
/// ```
pub fn interior_edges<S: Scalar, I: Index>(
    mesh: &Mesh<'_, S, I>,
    scratch: &mut [(I, u8)],
    edges: &mut [InteriorEdges],
) -> Result<(), MeshError> {
    let count = mesh.triangles().len();
    let sides = scratch.get_mut(..3 * count).ok_or(MeshError::Length { needed: 3 * count })?;
    let edges = edges.get_mut(..count).ok_or(MeshError::Length { needed: count })?;
    edges.fill(InteriorEdges::NONE);
    let numbers = (0..count).flat_map(|t| [0, 1, 2].each(|k| (I::of(t), k)));
    for (side, number) in sides.iter_mut().zip(numbers) {
        *side = number;
    }
    // The lesser end first, and whether the edge begins there.
    let ends = |&(t, k): &(I, u8)| {
        let t = mesh.known(t.get());
        let (k, next, _) = turn(k.into());
        let (a, b) = (*pick(t.vertices(), k), *pick(t.vertices(), next));
        if by_place(&a, &b).is_gt() { ([b, a], false) } else { ([a, b], true) }
    };
    let by_ends = |a: &(I, u8), b: &(I, u8)| {
        let ([a, b], [c, d]) = (ends(a).0, ends(b).0);
        by_place(&a, &c).then_with(|| by_place(&b, &d))
    };
    sort(sides, |a, b| by_ends(a, b).then_with(|| a.cmp(b)));
    let mut rest: &[(I, u8)] = sides;
    while let [first, others @ ..] = rest {
        let same = others.iter().take_while(|side| by_ends(first, side).is_eq()).count();
        rest = others.get(same..).unwrap_or_default();
        let ([(u, l), ..], 1) = (others, same) else { continue };
        let ((t, k), (u, l)) = (*first, (*u, *l));
        let are_turned_alike = ends(&(t, k)).1 != ends(&(u, l)).1;
        let both = [mesh.known(t.get()), mesh.known(u.get())];
        let apexes = [k, l].each(|k| usize::from((k + 2) % 3));
        if t != u && is_interior(&both, apexes, are_turned_alike) {
            for (t, k) in [(t, k), (u, l)] {
                if let Some(edges) = edges.get_mut(t.get()) {
                    edges.add(k);
                }
            }
        }
    }
    Ok(())
}

/// Whether the edge between two triangles is interior, given the vertices opposite to it.
fn is_interior<S: Scalar>(
    triangles: &[Triangle<S>; 2],
    apexes: [usize; 2],
    are_turned_alike: bool,
) -> bool {
    let [first, second] = triangles;
    let (normals, edges) = (triangles.each_ref().each(normal_signs), Body::Triangle(first));
    if normals.contains(&[Ordering::Equal; 3]) {
        return false;
    }
    // If the apex of the second triangle lies above the first, the apex of the first lies above the
    // second.
    let (base, apex) = (first.points()[0], *pick(&second.points(), apexes[1]));
    let height = differences(&apex, &base);
    match robust::side::<S::SeptumSum>([&edges.side(0), &edges.side(1), &height]) {
        Ordering::Greater => are_turned_alike,
        Ordering::Less => false,
        // In one plane they lie side by side, and are not folded, if the normals agree with the
        // orientation.
        Ordering::Equal => (normals[0] == normals[1]) == are_turned_alike,
    }
}

/// The signs of the coordinates of the normal.
fn normal_signs<S: Scalar>(triangle: &Triangle<S>) -> [Ordering; 3] {
    let body = Body::Triangle(triangle);
    let (x, y) = (body.side(0), body.side(1));
    three(|i| robust::minor_sign::<S::SeptumSum>(&x, &y, i))
}
