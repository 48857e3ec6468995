//! The light at a corner of a voxel's face: the visible part of sun and sky.

use crate::color::{Color, mix, plus, scaled};
use crate::march::Scene;

/// The direction of the sun: left, front, above.
const SUN: [f64; 3] = [-0.28, 0.80, 0.53];
/// The sun's radius, in radians: large, for soft shadows.
const SUN_RADIUS: f64 = 0.07;
const SUN_COLOR: Color = [1.62, 1.49, 1.29];
const ZENITH: Color = [0.56, 0.68, 0.90];
const HORIZON: Color = [0.72, 0.75, 0.80];
/// The light that the ground and other voxels reflect.
const GROUND: Color = [0.50, 0.48, 0.46];
const BOUNCE: Color = [0.16, 0.15, 0.15];

/// Light that arrives at a point of a surface.
#[derive(Clone, Copy, Default)]
pub(crate) struct Light {
    /// The part of the sun in view.
    pub(crate) sun: f64,
    /// Mean colour of the sky in view, cosine-weighted.
    pub(crate) sky: Color,
}

impl Light {
    /// The light at a point without obstacles.
    pub(crate) fn open(axis: usize) -> Self {
        let probe = Probe::new(64, 0.0);
        let mean = probe.hemisphere(axis).map(sky).fold([0.0; 3], plus);
        Self { sun: 1.0, sky: scaled(mean, 1.0 / probe.directions.len() as f64) }
    }

    /// The light between two points.
    pub(crate) fn mix(a: Self, b: Self, t: f64) -> Self {
        Self { sun: a.sun + (b.sun - a.sun) * t, sky: mix(a.sky, b.sky, t) }
    }

    /// The light that a white surface facing along `axis` reflects.
    pub(crate) fn reflected(&self, axis: usize) -> Color {
        let facing = SUN[axis].max(0.0);
        plus(self.sky, scaled(SUN_COLOR, facing * self.sun))
    }
}

/// The directions to probe. They are the same at every point, to avoid noise.
pub(crate) struct Probe {
    /// Directions around +y, distributed by the cosine.
    directions: Vec<[f64; 3]>,
    suns: Vec<[f64; 3]>,
    /// Voxels farther away than this block the sun, but not the sky.
    reach: f64,
}

impl Probe {
    /// Looks in `count` directions, as far as `reach`.
    pub(crate) fn new(count: usize, reach: f64) -> Self {
        let disc = |i: usize, n: usize| {
            let (r, phi) = (((i as f64 + 0.5) / n as f64).sqrt(), 2.399_963_229_728_653 * i as f64);
            (r * phi.cos(), r * phi.sin())
        };
        let directions = (0..count).map(|i| {
            let (x, z) = disc(i, count);
            [x, (1.0 - x * x - z * z).max(0.0).sqrt(), z]
        });
        let suns = (0..count / 2).map(|i| {
            let (x, z) = disc(i, count / 2);
            [SUN[0] + SUN_RADIUS * x, SUN[1], SUN[2] + SUN_RADIUS * z]
        });
        Self { directions: directions.collect(), suns: suns.collect(), reach }
    }

    /// The directions about an axis.
    fn hemisphere(&self, axis: usize) -> impl Iterator<Item = [f64; 3]> {
        self.directions.iter().map(move |&[x, y, z]| match axis {
            0 => [y, z, x],
            1 => [x, y, z],
            _ => [z, x, y],
        })
    }

    /// The light at a point of the lattice, for a surface that faces along `axis`. It is the mean
    /// over the four faces of size `step` that meet there. Each is probed from a little inside, so
    /// that a wall beside the corner counts and the shading has no seams.
    pub(crate) fn look(
        &self,
        scene: &Scene<'_>,
        axis: usize,
        corner: [f64; 3],
        step: f64,
    ) -> Light {
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let inset = 0.3 * step;
        let from = |quarter: usize| {
            let mut point = corner;
            point[axis] += 0.02;
            point[j] += if quarter & 1 == 0 { -inset } else { inset };
            point[k] += if quarter & 2 == 0 { -inset } else { inset };
            point
        };
        let origins = [from(0), from(1), from(2), from(3)];
        let mut light = Light::default();
        for (i, dir) in self.hemisphere(axis).enumerate() {
            let seen = match scene.march(origins[i % 4], dir, self.reach) {
                Some(hit) => mix(BOUNCE, sky(dir), (hit.t / self.reach).powi(2)),
                None => sky(dir),
            };
            light.sky = plus(light.sky, scaled(seen, 1.0 / self.directions.len() as f64));
        }
        if SUN[axis] > 0.0 {
            let free = |(i, &dir): (usize, &[f64; 3])| {
                scene.march(origins[i % 4], dir, f64::INFINITY).is_none()
            };
            let in_view = self.suns.iter().enumerate().filter(|&s| free(s)).count();
            light.sun = in_view as f64 / self.suns.len() as f64;
        }
        light
    }
}

fn sky(dir: [f64; 3]) -> Color {
    if dir[1] < 0.0 { GROUND } else { mix(HORIZON, ZENITH, dir[1].sqrt()) }
}
