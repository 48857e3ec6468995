//! `heapless`: results of bounded size, which say what did not fit.

use heapless::Vec;

use crate::shape::Overlaps;

/// Up to N results, and how many there were beyond.
///
/// Collect any iterator into it. The first N are kept, in their order; nothing is
/// lost without a trace. With the feature `heapless`.
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
    /// Nothing yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { kept: Vec::new(), missed: 0 }
    }

    /// Takes one more result, or counts it where there is no room.
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

    /// How many results there was no room for.
    #[must_use]
    pub fn missed(&self) -> usize {
        self.missed
    }

    /// How many results there were.
    #[must_use]
    pub fn total(&self) -> usize {
        self.kept.len().saturating_add(self.missed)
    }

    /// Whether all results are here.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.missed == 0
    }

    /// The results as a vector of `heapless`, if all of them are here.
    ///
    /// # Errors
    /// This again, where some are missing.
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

/// The places in `shapes` of those that meet `other`, the first N of them, and how
/// many more do.
///
/// *When to choose it*: where there is no allocator, and a bound on what a caller
/// can use. Exact as the question itself: see the implementations of [`Overlaps`].
/// With the feature `heapless`.
///
/// *Panics*: never. *Cost*: one question for each shape, whether or not it fits.
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
