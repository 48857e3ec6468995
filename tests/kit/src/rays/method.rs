//! The methods of testing a ray against a triangle.

use septum::published;
use septum::published::projected::ProjectedTriangle;
use septum::published::stored_normal::NormalTriangle;
use septum::published::watertight::ShearedRay;
use septum::{Cull, Hit, Ray, Triangle};

use crate::Sample;

/// A method; all but the last two in the scalar's own arithmetic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
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
    pub const ALL: [Self; 7] = [
        Self::MollerTrumbore,
        Self::StoredNormal,
        Self::Projected,
        Self::Volumes,
        Self::Watertight,
        Self::Exact,
        Self::Once,
    ];

    /// The name of the method.
    pub fn name(self) -> &'static str {
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
    pub fn ask<S: Sample>(self, ray: &Ray<S>, triangle: &Triangle<S>) -> Option<Hit<S>> {
        match self {
            Self::MollerTrumbore => published::moller_trumbore::hit(ray, triangle, Cull::Nothing),
            Self::StoredNormal => {
                published::stored_normal::hit(ray, &NormalTriangle::new(triangle), Cull::Nothing)
            }
            Self::Projected => {
                published::projected::hit(ray, &ProjectedTriangle::new(triangle), Cull::Nothing)
            }
            Self::Volumes => published::volumes::hit(ray, triangle, Cull::Nothing),
            Self::Watertight => ShearedRay::new(ray).hit(triangle, Cull::Nothing),
            Self::Exact => ray.hit(triangle),
            Self::Once => ray.hit_once(triangle),
        }
    }
}
