//! Shoots rays through closed meshes. Counts rays that meet no triangle at a wall, and rays that
//! meet two.

use std::ops::AddAssign;

use super::measure::Instance;
use septum_kit::Sample;
use septum_kit::rays::{Aim, Method, Scene};

/// The counts of one row.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tally {
    pub(crate) rays: u64,
    /// Rays that passed a wall without a hit, in the order of [`Method::ALL`].
    pub(crate) leaks: [u64; Method::ALL.len()],
    /// Rays that hit two triangles or more on entering or on leaving.
    pub(crate) doubles: [u64; Method::ALL.len()],
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.rays += other.rays;
        for k in 0..Method::ALL.len() {
            self.leaks[k] += other.leaks[k];
            self.doubles[k] += other.doubles[k];
        }
    }
}

/// One kind of target on one mesh in one scalar.
pub(crate) struct LeakRow<'a> {
    pub(crate) scalar: &'a Instance,
    pub(crate) scene: Scene,
    pub(crate) aim: Aim,
    pub(crate) tally: Tally,
}

impl LeakRow<'_> {
    /// Why the scalar cannot hold the mesh, if it cannot.
    pub(crate) fn misfit(&self) -> Option<&'static str> {
        (self.scalar.scene_misfit)(self.scene)
    }

    pub(crate) fn measure(&self, seed: u64, count: usize) -> Tally {
        (self.scalar.leaks)(self.scene, self.aim, seed, count)
    }
}

/// Counts, on the triangles that each ray comes near.
pub(crate) fn measure<S: Sample>(scene: Scene, aim: Aim, seed: u64, count: usize) -> Tally {
    let mesh = scene.mesh::<S>();
    let mut tally = Tally::default();
    for shot in scene.shots(&mesh, aim, seed, count) {
        tally.rays += 1;
        for (k, count) in shot.counts(&mesh, Method::ALL).into_iter().enumerate() {
            tally.leaks[k] += u64::from(shot.leaks(count));
            tally.doubles[k] += u64::from(shot.doubles(count));
        }
    }
    tally
}
