//! `heapless`: results of bounded size, which count the results that did not fit.

use heapless::Vec;

use crate::shape::Overlaps;

/// Up to N results, and the number of further ones.
///
/// Collect any iterator into it. It keeps the first N results in order, and counts the rest. With
/// the feature `heapless`.
///
/// ```
/// use septum::interop::Bounded;
///
/// let squares: Bounded<u32, 3> = (1..=5).map(|n| n * n).collect();
/// assert_eq!(squares.kept(), [1, 4, 9]);
/// assert_eq!((squares.missed(), squares.total()), (2, 5));
/// assert!(!squares.is_complete());
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bounded<T, const N: usize> {
    kept: Vec<T, N>,
    missed: usize,
}

impl<T, const N: usize> Bounded<T, N> {
    /// An empty collection.
    #[must_use]
    pub const fn new() -> Self {
        Self { kept: Vec::new(), missed: 0 }
    }

    /// Adds a result, or counts it if there is no room.
    pub fn push(&mut self, result: T) {
        if self.kept.push(result).is_err() {
            self.missed = self.missed.saturating_add(1);
        }
    }

    /// The first N results.
    #[must_use]
    pub fn kept(&self) -> &[T] {
        &self.kept
    }

    /// The number of results that did not fit.
    #[must_use]
    pub fn missed(&self) -> usize {
        self.missed
    }

    /// The number of all results.
    #[must_use]
    pub fn total(&self) -> usize {
        self.kept.len().saturating_add(self.missed)
    }

    /// Did all results fit?
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.missed == 0
    }

    /// The results as a vector of `heapless`, if all results fitted.
    ///
    /// # Errors
    /// Returns `self` if results are missing.
    pub fn into_complete(self) -> Result<Vec<T, N>, Self> {
        if self.is_complete() { Ok(self.kept) } else { Err(self) }
    }
}

impl<T, const N: usize> Default for Bounded<T, N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T, const N: usize> Extend<T> for Bounded<T, N> {
    fn extend<I: IntoIterator<Item = T>>(&mut self, results: I) {
        results.into_iter().for_each(|result| self.push(result));
    }
}

impl<T, const N: usize> FromIterator<T> for Bounded<T, N> {
    fn from_iter<I: IntoIterator<Item = T>>(results: I) -> Self {
        let mut bounded = Self::new();
        bounded.extend(results);
        bounded
    }
}

/// The indices of the shapes in `shapes` that overlap `other`: the first N, and the number of
/// further ones.
///
/// Exact, as the implementation of [`Overlaps`] for the pair. Needs the feature `heapless`.
///
/// *Panics*: never. *Cost*: one query for each shape, also for results that do not fit.
///
/// ```
/// use septum::interop::{Bounded, touched};
/// use septum::{Aabb, Triangle};
///
/// let wall = |x| Triangle::new([x, 0.0, 0.0], [x, 1.0, 0.0], [x, 0.0, 1.0]);
/// let walls = [wall(0.0)?, wall(1.0)?, wall(2.0)?, wall(3.0)?];
/// let tool = Aabb::from_min_max([1.0, 0.0, 0.0], [3.0, 1.0, 1.0])?;
///
/// let all: Bounded<usize, 4> = touched(&walls, &tool);
/// assert_eq!(all.kept(), [1, 2, 3]);
/// let some: Bounded<usize, 2> = touched(&walls, &tool);
/// assert_eq!((some.kept(), some.missed()), (&[1, 2][..], 1));
/// # Ok::<(), septum::ShapeError>(())
/// ```
#[must_use]
pub fn touched<Shape, Other, const N: usize>(shapes: &[Shape], other: &Other) -> Bounded<usize, N>
where
    Shape: Overlaps<Other>,
{
    shapes.iter().enumerate().filter(|(_, s)| s.overlaps(other)).map(|(i, _)| i).collect()
}
