//! Whether a mesh is closed, and whether it then contains a point.

use core::cmp::Ordering;

use super::node::Cell;
use super::walk::Walk;
use super::{Index, Mesh, MeshError, Tree};
use crate::arithmetic::{REGISTERS_ARE_WIDE, compare};
use crate::query::crossing;
use crate::scalar::Scalar;
use crate::shape::Vec3;

impl<S: Scalar, I: Index> Mesh<'_, S, I> {
    /// Checks that the mesh is closed: every edge belongs to an even number of triangles.
    ///
    /// A closed mesh has an inside: all rays from a point cross the mesh an odd number of times, or
    /// all an even number. The mesh may have several parts, and the orientation of its triangles
    /// does not matter.
    ///
    /// Edges are compared by the positions of their ends, so a seam of duplicate vertices counts as
    /// closed. An edge of length zero is ignored.
    ///
    /// *Numerics*: exact. *Panics*: never. *Cost*: sorts the edges in `scratch`, three for each
    /// triangle.
    ///
    /// # Errors
    /// [`MeshError::OpenEdge`] with the first open edge, in the order of positions;
    /// [`MeshError::Length`] if `scratch` is too short.
    ///
    /// ```
    /// use septum::Vec3;
    /// use septum::mesh::{Mesh, MeshError};
    ///
    /// let [o, x, y, z] =
    ///     [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vec3::from);
    /// let (corners, faces) = ([o, x, y, z], [[0_u16, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]);
    /// let mut scratch = [[0; 2]; 12];
    /// assert_eq!(Mesh::new(&corners, &faces)?.check_closed(&mut scratch), Ok(()));
    ///
    /// let without_roof = Mesh::new(&corners, &faces[..3])?;
    /// let open = without_roof.check_closed(&mut scratch);
    /// assert_eq!(open, Err(MeshError::OpenEdge { vertices: [3, 2] }));
    /// # Ok::<(), MeshError>(())
    /// ```
    pub fn check_closed(&self, scratch: &mut [[I; 2]]) -> Result<(), MeshError> {
        let needed = 3 * self.triangles.len();
        let edges = scratch.get_mut(..needed).ok_or(MeshError::Length { needed })?;
        let place = |i: I| self.vertices.get(i.get()).copied().unwrap_or(Vec3::splat(S::ZERO));
        let sides = self.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        for (edge, [a, b]) in edges.iter_mut().zip(sides) {
            // The end that comes first in the order of positions.
            let is_in_order = by_place(&place(a), &place(b)) != Ordering::Greater;
            *edge = if is_in_order { [a, b] } else { [b, a] };
        }
        let by_ends = |&[a, b]: &[I; 2], &[c, d]: &[I; 2]| {
            by_place(&place(a), &place(c)).then_with(|| by_place(&place(b), &place(d)))
        };
        // Ties are broken by index, so that every machine reports the same edge.
        sort(edges, |a, b| by_ends(a, b).then_with(|| a.cmp(b)));
        let alike = edges.chunk_by(|a, b| by_ends(a, b) == Ordering::Equal);
        for group in alike.filter(|group| group.len() % 2 == 1) {
            let [a, b] = group[0];
            if by_place(&place(a), &place(b)) != Ordering::Equal {
                return Err(MeshError::OpenEdge { vertices: [a.get(), b.get()] });
            }
        }
        Ok(())
    }
}

/// Sorts; the comparison leaves no ties between different elements. Small cores, and all machines
/// with the feature `small`, run a heap sort, which has a tenth of the code of the standard sort and
/// links no panic.
pub(crate) fn sort<T: Copy>(all: &mut [T], compare: impl Fn(&T, &T) -> Ordering) {
    if REGISTERS_ARE_WIDE {
        all.sort_unstable_by(compare);
        return;
    }
    let n = all.len();
    // Heap sort. The first n/2 steps build the heap, from the last parent to the root; each of
    // the next n steps moves the root, the greatest, to the end.
    for step in (0..n + n / 2).rev() {
        let (mut top, count) = if step >= n { (step - n, n) } else { (0, step) };
        if step < n {
            swap(all, 0, step);
        }
        loop {
            let is_less = |a: usize, b: usize| match (all.get(a), all.get(b)) {
                (Some(a), Some(b)) => compare(a, b) == Ordering::Less,
                _ => false,
            };
            let mut below = 2 * top + 1;
            if below + 1 < count && is_less(below, below + 1) {
                below += 1;
            }
            if below >= count || !is_less(top, below) {
                break;
            }
            swap(all, top, below);
            top = below;
        }
    }
}

/// Swaps two elements, and links no panic.
fn swap<T: Copy>(all: &mut [T], a: usize, b: usize) {
    if let (Some(&x), Some(&y)) = (all.get(a), all.get(b)) {
        all[a] = y;
        all[b] = x;
    }
}

/// An order of positions. Coordinates are finite, and the two zeros compare equal.
pub(crate) fn by_place<S: Scalar>(a: &Vec3<S>, b: &Vec3<S>) -> Ordering {
    compare(a.x, b.x).then_with(|| compare(a.y, b.y)).then_with(|| compare(a.z, b.z))
}

impl<S: Scalar, I: Index> Tree<'_, S, I> {
    /// Does the closed mesh contain a point, inside it or on a triangle?
    ///
    /// *Geometry*: a point is inside if a ray from it crosses the mesh an odd number of times
    /// (even-odd rule). The orientation of triangles does not matter. By this rule the overlap of
    /// two parts of the mesh is outside; use [`winding`](Self::winding) there, if the triangles are
    /// oriented consistently. For a mesh that is not closed
    /// ([`Mesh::check_closed`](super::Mesh::check_closed)) the answer counts the crossings of the
    /// ray along the positive x axis.
    ///
    /// *Contact*: the surface belongs to the inside. A point with a NaN or infinite coordinate is
    /// not contained.
    ///
    /// *Numerics*: exact for every valid input, in every scalar, also for points or rays on faces,
    /// edges and vertices. *Panics*: never.
    ///
    /// *Cost*: 5 integer comparisons for each box along the ray; for each triangle there two planar
    /// areas, and a volume if the triangle extends from before the point to behind it.
    ///
    /// *Source*: crossings are counted as in M. Shimrat, "Algorithm 112: Position of Point Relative
    /// to Polygon", *Communications of the ACM* 5(8), 1962, in the projection along the ray.
    #[inline]
    #[must_use]
    pub fn contains(&self, point: impl Into<Vec3<S>>) -> bool {
        self.winding(point).is_none_or(|winding| winding % 2 != 0)
    }

    /// The winding number of a closed mesh about a point: how many times the mesh encloses it.
    /// `None` for a point on a triangle.
    ///
    /// Use it for meshes whose triangles are oriented consistently, counterclockwise seen from
    /// outside. Overlapping parts each add 1, so every point with a number other than 0 is inside
    /// some part. A part that is turned inside out adds −1.
    ///
    /// *Numerics*, *Panics*, *Cost*: as [`contains`](Self::contains). A point with a NaN or
    /// infinite coordinate has winding number 0.
    #[must_use]
    pub fn winding(&self, point: impl Into<Vec3<S>>) -> Option<i32> {
        let p: Vec3<S> = point.into();
        if !p.is_finite() {
            return Some(0);
        }
        let p = p.to_array();
        let Cell { low, high } = self.grid.cell([p, p]);
        let row = Cell { low, high: [u16::MAX, high[1], high[2]] };
        let mut winding = 0;
        let mut walk = Walk::new(self.nodes, |root| root.meeting(&row));
        while let Some(leaf) = walk.next(self.nodes, &self.layout, |node| node.meeting(&row)) {
            for place in leaf {
                let triangle = self.mesh.known(self.index(place));
                if triangle.contains(p) {
                    return None;
                }
                winding += crossing(p, &triangle);
            }
        }
        Some(winding)
    }
}
