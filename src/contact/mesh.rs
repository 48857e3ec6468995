//! The contacts of a shape with a whole mesh.

use super::{Contact, ContactWith, InteriorEdges, contact_in_mesh};
use crate::mesh::{Index, MeshError, Overlapping, Probe, Tree};
use crate::scalar::Scalar;
use crate::shape::Triangle;

impl<'a, S: Scalar, I: Index> Tree<'a, S, I> {
    /// The contacts of a shape with the mesh: for each triangle that the shape penetrates, its index
    /// and its contact manifold, in the tree's order. The shape is an [`Aabb`](crate::Aabb), an
    /// [`Obb`](crate::Obb), a [`Triangle`], a [`Sphere`](crate::Sphere) or a
    /// [`Capsule`](crate::Capsule).
    ///
    /// `interior` has the interior edges of each triangle, by its index in the mesh, as
    /// [`interior_edges`](crate::contact::interior_edges) computes them. With them no contact is a
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
