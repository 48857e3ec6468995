//! Pairs of shapes: a scene, or a scene converted to one candidate's types.

use std::hint::black_box;
use std::ops::Range;

/// Shapes of one type, each paired with some shapes of another.
pub struct Pairs<L, R> {
    left: Vec<L>,
    right: Vec<R>,
    /// For each shape on the left, its partners on the right.
    spans: Vec<Range<usize>>,
}

impl<L, R> Pairs<L, R> {
    /// Every shape on the left paired with all shapes on the right.
    pub fn all_against(left: Vec<L>, right: Vec<R>) -> Self {
        let spans = vec![0..right.len(); left.len()];
        Self { left, right, spans }
    }

    pub fn push(&mut self, left: L, right: impl IntoIterator<Item = R>) {
        let start = self.right.len();
        self.right.extend(right);
        self.left.push(left);
        self.spans.push(start..self.right.len());
    }

    pub fn len(&self) -> usize {
        self.spans.iter().map(ExactSizeIterator::len).sum()
    }

    /// The shapes on the left, in order.
    pub fn lefts(&self) -> impl Iterator<Item = &L> {
        self.left.iter()
    }

    /// The same pairs in other types.
    pub fn map<M, S>(&self, left: impl Fn(&L) -> M, right: impl Fn(&R) -> S) -> Pairs<M, S> {
        Pairs {
            left: self.left.iter().map(left).collect(),
            right: self.right.iter().map(right).collect(),
            spans: self.spans.clone(),
        }
    }

    /// The number of pairs for which the test returns yes.
    ///
    /// The test is called through a pointer that is opaque to the compiler, so that every candidate
    /// pays for one call and computes its whole answer, and loops are not merged.
    pub fn count<A: Answer>(&self, test: fn(&L, &R) -> A) -> usize {
        let test = black_box(test);
        let mut count = 0;
        for (left, span) in self.left.iter().zip(&self.spans) {
            for right in &self.right[span.clone()] {
                count += test(left, right).count();
            }
        }
        count
    }

    /// Each answer, in order.
    pub fn answers<A: Answer>(&self, test: impl Fn(&L, &R) -> A) -> Vec<bool> {
        let mut answers = Vec::with_capacity(self.len());
        for (left, span) in self.left.iter().zip(&self.spans) {
            for right in &self.right[span.clone()] {
                test(left, right).tell(&mut answers);
            }
        }
        answers
    }
}

impl<L, R: Block> Pairs<L, R> {
    /// The number of shapes in all blocks for which the test returns yes.
    pub fn count_inlined<T: Inlined<L, R::Shape>>(&self) -> usize {
        let mut count = 0;
        self.each::<T>(|answer| count += usize::from(answer));
        count
    }

    /// Each of these answers, in order.
    pub fn answers_inlined<T: Inlined<L, R::Shape>>(&self) -> Vec<bool> {
        let mut answers = Vec::new();
        self.each::<T>(|answer| answers.push(answer));
        answers
    }

    #[inline(always)]
    fn each<T: Inlined<L, R::Shape>>(&self, mut tell: impl FnMut(bool)) {
        for (left, span) in self.left.iter().zip(&self.spans) {
            let made = T::make(left);
            for block in &self.right[span.clone()] {
                block.each(|right| tell(T::ask(&made, right)));
            }
        }
    }
}

impl<L: Clone, R: Clone> Pairs<L, R> {
    /// The pairs with left and right exchanged, for a single shape on the right.
    ///
    /// # Panics
    /// If there is more than one shape on the right.
    pub fn turned(&self) -> Pairs<R, L> {
        assert_eq!(self.right.len(), 1, "one shape on the right");
        Pairs::all_against(self.right.clone(), self.left.clone())
    }

    /// The same pairs with the shapes on the right in blocks of N.
    ///
    /// # Panics
    /// If N does not divide the number of partners of a shape on the left.
    pub fn blocks<const N: usize>(&self) -> Pairs<L, [R; N]> {
        let whole = |n: usize| {
            assert!(n.is_multiple_of(N), "a scene for blocks consists of whole ones");
            n / N
        };
        Pairs {
            left: self.left.clone(),
            right: self.right.as_chunks::<N>().0.to_vec(),
            spans: self.spans.iter().map(|s| whole(s.start)..whole(s.end)).collect(),
        }
    }
}

impl<L, R: Clone> Pairs<L, R> {
    /// The same pairs, with each shape on the left replaced by a value made from it and its first
    /// partner.
    ///
    /// # Panics
    /// If a shape has no partner.
    pub fn map_with_first<M>(&self, make: impl Fn(&L, &R) -> M) -> Pairs<M, R> {
        let left = self.left.iter().zip(&self.spans);
        Pairs {
            left: left.map(|(left, span)| make(left, &self.right[span.start])).collect(),
            right: self.right.clone(),
            spans: self.spans.clone(),
        }
    }
}

impl<L, R> Default for Pairs<L, R> {
    fn default() -> Self {
        Self { left: Vec::new(), right: Vec::new(), spans: Vec::new() }
    }
}

/// Many shapes that are made while the clock runs, and never all at once.
pub trait Block {
    type Shape;
    /// Passes each shape to `ask`, in order.
    fn each(&self, ask: impl FnMut(Self::Shape));
}

/// A test inlined into the loop that makes the shapes, as in a user's program. It prepares each
/// shape on the left once for all partners.
///
/// It is a trait, because the compiler may leave a closure out of line. Then the shapes go through
/// memory, and the time depends on it.
pub trait Inlined<L, R> {
    type Made;
    fn make(left: &L) -> Self::Made;
    /// Must be marked `inline(always)`.
    fn ask(made: &Self::Made, right: R) -> bool;
}

/// The return type of a test: one verdict, or the verdicts on a block of pairs.
pub trait Answer {
    /// The number of verdicts that are yes.
    fn count(&self) -> usize;
    /// Appends the verdicts.
    fn tell(&self, verdicts: &mut Vec<bool>);
}

impl Answer for bool {
    fn count(&self) -> usize {
        usize::from(*self)
    }

    fn tell(&self, verdicts: &mut Vec<bool>) {
        verdicts.push(*self);
    }
}

impl<T> Answer for Option<T> {
    fn count(&self) -> usize {
        self.is_some().count()
    }

    fn tell(&self, verdicts: &mut Vec<bool>) {
        self.is_some().tell(verdicts);
    }
}
