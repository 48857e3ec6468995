//! Whether a mesh has an inside, and how to close an open one.
//!
//! A mesh is closed if every edge belongs to an even number of its faces. Then the parity of a
//! ray's crossings decides whether a point is inside (even-odd rule).

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// A face, by the indices of its vertices.
pub(crate) type Face = [usize; 3];

/// An edge, from one vertex to another.
type Edge = [usize; 2];

/// The edges of a face, in its direction. A face that repeats a vertex has fewer: an edge from a
/// vertex to itself bounds nothing.
fn edges(&[a, b, c]: &Face) -> impl Iterator<Item = Edge> {
    [[a, b], [b, c], [c, a]].into_iter().filter(|[a, b]| a != b)
}

/// The same edge in either direction.
fn undirected([a, b]: Edge) -> Edge {
    [a.min(b), a.max(b)]
}

/// The edges that belong to an odd number of faces, each in the direction of its last face. A
/// closed mesh has none.
pub(crate) fn open_edges(faces: &[Face]) -> Vec<Edge> {
    let mut open = BTreeMap::new();
    for edge in faces.iter().flat_map(edges) {
        if open.remove(&undirected(edge)).is_none() {
            open.insert(undirected(edge), edge);
        }
    }
    open.into_values().collect()
}

/// Faces that close the mesh: for each hole a fan of triangles around one vertex of its rim. They
/// add no vertex. If the faces around a hole are oriented consistently, its fan has the same
/// orientation.
pub(crate) fn caps(faces: &[Face]) -> Vec<Face> {
    let open = open_edges(faces);
    let mut rims = Rims::new(&open);
    let mut caps = Vec::new();
    for &[a, b] in &open {
        // Against the direction of the face. An earlier rim may have had the edge.
        if !rims.take([b, a]) {
            continue;
        }
        let mut rim = vec![b, a];
        let mut last = a;
        // Every vertex has an even number of open edges, so that each rim returns.
        while let Some(next) = rims.step(last).filter(|&next| next != b) {
            rim.push(next);
            last = next;
        }
        caps.extend(rim[1..].windows(2).map(|pair| [b, pair[0], pair[1]]));
    }
    caps
}

/// Open edges that no rim has taken yet, as the neighbours of each vertex.
struct Rims(BTreeMap<usize, BTreeSet<usize>>);

impl Rims {
    fn new(open: &[Edge]) -> Self {
        let mut neighbours = BTreeMap::<usize, BTreeSet<usize>>::new();
        for &[a, b] in open {
            neighbours.entry(a).or_default().insert(b);
            neighbours.entry(b).or_default().insert(a);
        }
        Self(neighbours)
    }

    /// Takes an edge, if it is still there.
    fn take(&mut self, [a, b]: Edge) -> bool {
        let mut remove = |a, b| self.0.get_mut(&a).is_some_and(|of_a| of_a.remove(&b));
        remove(a, b) && remove(b, a)
    }

    /// Takes an edge at a vertex, and returns its end.
    fn step(&mut self, from: usize) -> Option<usize> {
        let to = *self.0.get(&from)?.first()?;
        self.take([from, to]).then_some(to)
    }
}

/// Sorts the faces into parts: faces that share an edge belong to one part. Within a part the faces
/// keep their order.
pub(crate) fn sort_into_parts(faces: &mut Vec<Face>) -> Vec<Range<usize>> {
    // A tree for each part; the root is its first face.
    let mut parent: Vec<usize> = (0..faces.len()).collect();
    let mut first_with_edge = BTreeMap::new();
    for (i, face) in faces.iter().enumerate() {
        for edge in edges(face) {
            let other = *first_with_edge.entry(undirected(edge)).or_insert(i);
            let (a, b) = (root(&mut parent, i), root(&mut parent, other));
            parent[a.max(b)] = a.min(b);
        }
    }
    let mut parts = BTreeMap::<usize, Vec<Face>>::new();
    for (i, face) in faces.iter().enumerate() {
        parts.entry(root(&mut parent, i)).or_default().push(*face);
    }
    faces.clear();
    let mut ranges = Vec::new();
    for part in parts.into_values() {
        ranges.push(faces.len()..faces.len() + part.len());
        faces.extend(part);
    }
    ranges
}

/// The root of a face's tree. It halves the path to the root on the way.
fn root(parent: &mut [usize], mut face: usize) -> usize {
    while parent[face] != face {
        parent[face] = parent[parent[face]];
        face = parent[face];
    }
    face
}
