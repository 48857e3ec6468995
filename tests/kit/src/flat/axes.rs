//! The second oracle, for triangles that are not segments: the 11 axes, and for coplanar triangles
//! the edges' normals in their plane.

use crate::{Each, lattice::Ring, three};

use super::oracle::Corners;

/// Whether an axis separates two triangles; `None` if either is a segment or a point.
pub(super) fn separate<I: Ring>(first: &Corners<I>, second: &Corners<I>) -> Option<bool> {
    let edges = |t: &Corners<I>| three(|k: usize| I::difference(&t[(k + 1) % 3], &t[k]));
    let (e, f) = (edges(first), edges(second));
    let (m, n) = (I::cross(&e[0], &e[1]), I::cross(&f[0], &f[1]));
    if [&m, &n].iter().any(|normal| normal.iter().all(|x| x.sign() == 0)) {
        return None;
    }
    let across = e.iter().flat_map(|e| f.iter().map(|f| I::cross(e, f)));
    let in_plane = e.iter().map(|e| I::cross(&m, e)).chain(f.iter().map(|f| I::cross(&n, f)));
    let mut axes = [m.clone(), n.clone()].into_iter().chain(across).chain(in_plane);
    Some(axes.any(|axis| {
        let on_axis = |t: &Corners<I>| t.each_ref().each(|p| I::dot(&axis, p));
        let (p, q) = (on_axis(first), on_axis(second));
        let all_below =
            |p: &[I; 3], q: &[I; 3]| p.iter().all(|p| q.iter().all(|q| q.minus(p).sign() > 0));
        all_below(&p, &q) || all_below(&q, &p)
    }))
}
