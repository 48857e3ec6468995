//! A case: a ray and a triangle, as plain numbers.

use septum::{Ray, Triangle};

use crate::Sample;

/// A ray, the range of its t, and a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayCase<S> {
    pub origin: [S; 3],
    pub direction: [S; 3],
    pub vertices: [[S; 3]; 3],
    pub t_min: Option<S>,
    pub t_max: Option<S>,
}

impl<S: Sample> RayCase<S> {
    /// With the range t ≥ 0.
    pub fn new(origin: [S; 3], direction: [S; 3], vertices: [[S; 3]; 3]) -> Self {
        Self { origin, direction, vertices, t_min: Some(S::ZERO), t_max: None }
    }

    /// The same on the whole line.
    pub fn line(self) -> Self {
        Self { t_min: None, t_max: None, ..self }
    }

    /// Whether the ray is valid: its direction is not zero, its range not empty.
    pub fn is_valid(&self) -> bool {
        self.direction != [S::ZERO; 3]
            && !self.t_min.zip(self.t_max).is_some_and(|(min, max)| min > max)
    }

    /// The ray.
    pub fn ray(&self) -> Ray<S> {
        Ray::new(self.origin, self.direction)
            .and_then(|ray| ray.with_range(self.t_min, self.t_max))
            .expect("a valid ray")
    }

    /// The triangle.
    pub fn triangle(&self) -> Triangle<S> {
        let [a, b, c] = self.vertices;
        Triangle::new(a, b, c).expect("finite vertices")
    }
}
