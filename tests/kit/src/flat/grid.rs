//! Every pair of triangles on the grid {0, 1, 2}³, up to its symmetries.

use std::collections::HashSet;

use septum::Triangle;

use super::oracle::{Truth, truth_of_whole};
use crate::sample::Sample;
use crate::{Each, orders::VERTEX_ORDERS};

type Corners = [[i128; 3]; 3];

/// All triples of grid points regardless of order, repetitions included.
fn triples() -> Vec<Corners> {
    let point = |n: usize| [n / 9, n / 3 % 3, n % 3].each(|x| x as i128);
    let mut all = Vec::new();
    for a in 0..27 {
        for b in a..27 {
            all.extend((b..27).map(|c| [point(a), point(b), point(c)]));
        }
    }
    all
}

/// The least of the images under the 48 symmetries of the grid.
fn least_image(corners: &Corners) -> Corners {
    let image = |order: [usize; 3], mirrored: usize| {
        let mut image = corners.each(|p| {
            core::array::from_fn(|i| {
                let x = p[order[i]];
                if mirrored >> i & 1 == 1 { 2 - x } else { x }
            })
        });
        image.sort_unstable();
        image
    };
    VERTEX_ORDERS
        .into_iter()
        .flat_map(|order| (0..8).map(move |mirrored| image(order, mirrored)))
        .min()
        .expect("48 images")
}

/// Checks every pair, the first triangle up to symmetry; in every order of vertices and triangles,
/// or only in one. Panics at the first wrong answer; returns how many pairs are disjoint, touch and
/// overlap.
pub fn every_pair_on_the_grid<S: Sample>(in_all_orders: bool) -> [u32; 3] {
    let all = triples();
    let first: HashSet<Corners> = all.iter().map(least_image).collect();
    let shape = |corners: &Corners, order: [usize; 3]| -> Triangle<S> {
        let [a, b, c] = order.each(|k| corners[k].each(|x| S::nearest(x as f64)));
        Triangle::new(a, b, c).expect("finite vertices")
    };
    let orders = if in_all_orders { &VERTEX_ORDERS[..] } else { &VERTEX_ORDERS[..1] };
    let mut seen = [0; 3];
    for one in &first {
        for other in &all {
            let truth = truth_of_whole(one, other);
            seen[truth as usize] += 1;
            for &i in orders {
                for &k in orders {
                    let (t, u) = (shape(one, i), shape(other, k));
                    let answers = [t.overlaps(&u), u.overlaps(&t)];
                    let expected = truth != Truth::Apart;
                    assert_eq!(answers, [expected; 2], "{t:?}, {u:?}");
                }
            }
        }
    }
    seen
}
