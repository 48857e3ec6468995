//! The axes of two symmetric shapes, given by the way between their centres and half-vectors in integers.

use super::ERROR;
use crate::arithmetic::{product, three, turn};
use crate::query::relation::Relation;

/// How two symmetric shapes lie to each other, given the way between their centres and the
/// half-vectors of the two boxes; `None` in doubt.
// On a small core its frame is there only while it runs.
#[cfg_attr(not(target_pointer_width = "64"), inline(never))]
pub(super) fn relation<const K: usize>(way: &[i32; 3], spans: &[[i32; 3]; K]) -> Option<Relation> {
    let is_beyond = |i: usize| {
        let reach: i64 = spans.iter().map(|g| i64::from(g[i]).abs()).sum();
        i64::from(way[i]).abs() - reach > ERROR
    };
    if (0..3).any(is_beyond) {
        return Some(Relation::Disjoint);
    }
    let (mut has_normal, mut is_overlap) = (false, true);
    // How far all other half-vectors reach along the normal of two. The determinant of three is what each reaches
    // along the normal of the others.
    let mut reach = [[0; K]; K];
    for p in 0..K {
        for q in p + 1..K {
            let x = cross(&spans[p], &spans[q]);
            let size = x[0].abs() + x[1].abs() + x[2].abs();
            if size == 0 {
                continue;
            }
            for r in q + 1..K {
                let determinant = dot(&x, &spans[r]);
                for (i, j) in [(p, q), (p, r), (q, r)] {
                    reach[i][j] += determinant;
                }
            }
            let gap = dot(&x, way) - reach[p][q];
            if gap > ERROR * size {
                return Some(Relation::Disjoint);
            }
            has_normal = true;
            is_overlap &= gap < -ERROR * size;
        }
    }
    (has_normal && is_overlap).then_some(Relation::Overlapping)
}

fn cross(a: &[i32; 3], b: &[i32; 3]) -> [i64; 3] {
    three(|i| {
        let (_, j, k) = turn(i);
        product(a[j], b[k]) - product(a[k], b[j])
    })
}

/// The magnitude of the product.
fn dot(x: &[i64; 3], g: &[i32; 3]) -> i64 {
    (x[0] * i64::from(g[0]) + x[1] * i64::from(g[1]) + x[2] * i64::from(g[2])).abs()
}
