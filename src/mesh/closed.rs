//! Whether a mesh is closed.

use core::cmp::Ordering;

use super::{Index, Mesh, MeshError};
use crate::arithmetic::{SMALL_CODE, compare};
use crate::scalar::Scalar;
use crate::shape::Vec3;

impl<S: Scalar, I: Index> Mesh<'_, S, I> {
    /// Checks that the mesh is closed: every edge belongs to an even number of triangles.
    ///
    /// A closed mesh has an inside, for any ray from a point crosses it an odd number of times
    /// or any ray an even number. The triangles' orientation does not matter, nor how many
    /// parts the mesh has.
    ///
    /// An edge is known by where its ends are, so that a seam of vertices in the same place
    /// is closed. An edge between two vertices in one place bounds nothing.
    ///
    /// *Numerics*: exact. *Panics*: never. *Cost*: sorts the edges in `scratch`, three for
    /// each triangle.
    ///
    /// # Errors
    /// [`MeshError::OpenEdge`] with the first edge that is not closed, in the order of places;
    /// [`MeshError::Length`] where `scratch` is too short.
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
            // The lesser place first.
            let is_in_order = by_place(&place(a), &place(b)) != Ordering::Greater;
            *edge = if is_in_order { [a, b] } else { [b, a] };
        }
        let by_ends = |&[a, b]: &[I; 2], &[c, d]: &[I; 2]| {
            by_place(&place(a), &place(c)).then_with(|| by_place(&place(b), &place(d)))
        };
        // By index where places are the same, so that the same edge is named everywhere.
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

/// Sorts; where code is dear by a heap, in a tenth of what the library's sort links.
pub(crate) fn sort<T: Copy>(all: &mut [T], compare: impl Fn(&T, &T) -> Ordering) {
    if !SMALL_CODE {
        all.sort_unstable_by(compare);
        return;
    }
    let n = all.len();
    // First each place that has any below it is brought in order with those, from the last on.
    // Then the first, which is the greatest, goes to the end, again and again.
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

/// Without a panic.
fn swap<T: Copy>(all: &mut [T], a: usize, b: usize) {
    if let (Some(&x), Some(&y)) = (all.get(a), all.get(b)) {
        all[a] = y;
        all[b] = x;
    }
}

/// An order of places. All coordinates are numbers; zeros of either sign are alike.
pub(crate) fn by_place<S: Scalar>(a: &Vec3<S>, b: &Vec3<S>) -> Ordering {
    compare(a.x, b.x).then_with(|| compare(a.y, b.y)).then_with(|| compare(a.z, b.z))
}
