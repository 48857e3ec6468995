//! Oriented boxes whose overlap shrinks to contact.

use septum_kit::boxes::ObbNumbers;
use septum_kit::{Rng, Sample};

use super::boxes::{Point, plus};
use crate::obb_obb::turned;

/// A box of size about 1 on a face of another box, overlapping it by about `depth`.
pub(super) fn sunk<S: Sample>(rng: &mut Rng, depth: f64) -> Option<[ObbNumbers<S>; 2]> {
    let boxes = [(); 2].map(|()| {
        let half: Point = rng.triple(|rng| rng.real(0.2, 0.6));
        (turned(rng.triple(|rng| rng.real(0.0, std::f64::consts::TAU))), half)
    });
    let [(u, h), (v, k)] = boxes;
    let face = rng.below(3);
    let dot = |a: &Point, b: &Point| (0..3).map(|i| a[i] * b[i]).sum::<f64>();
    let reach: f64 = (0..3).map(|j| k[j] * dot(&u[face], &v[j]).abs()).sum();
    let steps = [0, 1, 2].map(|i| match i == face {
        true => h[i] + reach - depth,
        false => rng.real(-0.5, 0.5) * h[i],
    });
    let center = (0..3).fold([0.0; 3], |at, i| plus(at, u[i].map(|x| x * steps[i])));
    let near = |p: Point| p.map(S::nearest);
    let numbers = |center: Point, axes: [Point; 3], half: Point| ObbNumbers {
        center: near(center),
        axes: axes.map(near),
        half: near(half),
    };
    Some([numbers([0.0; 3], u, h), numbers(center, v, k)])
}
