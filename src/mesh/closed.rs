//! Whether a mesh is closed.

use core::cmp::Ordering;

use super::{Index, Mesh, MeshError};
use crate::arithmetic::{REGISTERS_ARE_WIDE, compare};
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
