//! The ways to ask where a ray hits a triangle.

use septum::{Cull, Hit, Ray, Triangle};

use crate::support::Sample;

/// A method; all but the last two in the scalar's own arithmetic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Method {
    /// `hit_moller_trumbore`
    MollerTrumbore,
    /// `hit_stored_normal`
    StoredNormal,
    /// `hit_projected`
    Projected,
    /// `hit_volumes`
    Volumes,
    /// `sheared().hit`
    Watertight,
    /// `hit`
    Exact,
    /// `hit_once`
    Once,
}

impl Method {
    /// All methods.
    pub(crate) const ALL: [Self; 7] = [
        Self::MollerTrumbore,
        Self::StoredNormal,
        Self::Projected,
        Self::Volumes,
        Self::Watertight,
        Self::Exact,
        Self::Once,
    ];

    /// What it is called.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::MollerTrumbore => "Möller–Trumb.",
            Self::StoredNormal => "stored normal",
            Self::Projected => "projected",
            Self::Volumes => "volumes",
            Self::Watertight => "Woop",
            Self::Exact => "exact",
            Self::Once => "once",
        }
    }

    /// Where the ray hits the triangle, according to this method.
    pub(crate) fn ask<S: Sample>(self, ray: &Ray<S>, triangle: &Triangle<S>) -> Option<Hit<S>> {
        match self {
            Self::MollerTrumbore => ray.hit_moller_trumbore(triangle, Cull::Nothing),
            Self::StoredNormal => ray.hit_stored_normal(&triangle.with_normal(), Cull::Nothing),
            Self::Projected => ray.hit_projected(&triangle.projected(), Cull::Nothing),
            Self::Volumes => ray.hit_volumes(triangle, Cull::Nothing),
            Self::Watertight => ray.sheared().hit(triangle, Cull::Nothing),
            Self::Exact => ray.hit(triangle),
            Self::Once => ray.hit_once(triangle),
        }
    }
}
