//! Rays and triangles near the origin, in the word kernel only.

use super::counted::Crosses;
use super::narrow::rounded;
use super::{Hit, HitRules};
use crate::arithmetic::InWholeWord;
use crate::scalar::Scalar;
use crate::shape::{Near, Ray, Triangle};

impl<S: Scalar + InWholeWord<i32>> Near<Ray<S>> {
    /// [`Ray::hit`], in 32-bit words alone.
    #[inline]
    #[must_use]
    pub fn hit(&self, triangle: &Near<Triangle<S>>) -> Option<Hit<S>> {
        self.hit_with(triangle, HitRules::new())
    }

    /// [`Ray::hit_once`], in 32-bit words alone.
    #[inline]
    #[must_use]
    pub fn hit_once(&self, triangle: &Near<Triangle<S>>) -> Option<Hit<S>> {
        self.hit_with(triangle, HitRules::new().once())
    }

    /// [`Ray::hit_with`], in 32-bit words alone.
    #[inline]
    #[must_use]
    pub fn hit_with(&self, triangle: &Near<Triangle<S>>, rules: HitRules) -> Option<Hit<S>> {
        let question = Crosses { ray: self.get(), triangle: triangle.get(), rules };
        question.in_any_words::<i32>().map(|counted| rounded(&counted))
    }

    /// [`Ray::is_hit`], in 32-bit words alone.
    #[inline]
    #[must_use]
    pub fn is_hit(&self, triangle: &Near<Triangle<S>>) -> bool {
        self.is_hit_with(triangle, HitRules::new())
    }

    /// [`Ray::is_hit_with`], in 32-bit words alone.
    #[inline]
    #[must_use]
    pub fn is_hit_with(&self, triangle: &Near<Triangle<S>>, rules: HitRules) -> bool {
        let question = Crosses { ray: self.get(), triangle: triangle.get(), rules };
        question.in_any_words::<i32>().is_some()
    }
}
