//! Interior edges of a surface, on which nothing may catch.

use core::cmp::Ordering;

use super::body::Body;
use crate::arithmetic::{Each, pick, three, turn};
use crate::mesh::{Index, Mesh, MeshError, by_place, sort};
use crate::robust::{self, differences};
use crate::scalar::Scalar;
use crate::shape::Triangle;

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
