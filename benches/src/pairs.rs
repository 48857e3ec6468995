//! Pairs of shapes: a scene, or a scene in the types that one candidate takes.

use std::hint::black_box;
use std::ops::Range;

/// Shapes of one type, each against some of another.
pub struct Pairs<L, R> {
    left: Vec<L>,
    right: Vec<R>,
    /// For each shape on the left, those on the right that it is tested against.
    spans: Vec<Range<usize>>,
}

impl<L, R> Pairs<L, R> {
    /// Every shape on the left against the same ones on the right.
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

    /// The same in other types.
    pub fn map<M, S>(&self, left: impl Fn(&L) -> M, right: impl Fn(&R) -> S) -> Pairs<M, S> {
        Pairs {
            left: self.left.iter().map(left).collect(),
            right: self.right.iter().map(right).collect(),
            spans: self.spans.clone(),
        }
    }

    /// The number of pairs that the test says yes to.
    ///
    /// The test is called through a pointer that the compiler cannot see
    /// through, so every candidate pays for one call, makes its whole answer,
    /// and no loop is merged.
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
    /// The number of shapes in all blocks that the test says yes to.
    pub fn count_inlined<T: Inlined<L, R::Shape>>(&self) -> usize {
        let mut count = 0;
        self.each::<T>(|answer| count += usize::from(answer));
        count
    }

    /// Each answer of the same, in order.
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
    /// One shape against all those that are tested against it alone.
    ///
    /// # Panics
    /// Where there is more than one shape on the right.
    pub fn turned(&self) -> Pairs<R, L> {
        assert_eq!(self.right.len(), 1, "one shape on the right");
        Pairs::all_against(self.right.clone(), self.left.clone())
    }

    /// The same with the shapes on the right in blocks of N.
    ///
    /// # Panics
    /// Where a shape on the left has a number of them that N does not divide.
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
    /// The same with what is made of each shape on the left and the first that it is tested
    /// against.
    ///
    /// # Panics
    /// Where there is none.
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
    /// Hands over each of them, in order.
    fn each(&self, ask: impl FnMut(Self::Shape));
}

/// A test as a program of its own would ask it, in the loop that makes the shapes. It makes what it
/// takes of a shape on the left once for all on the right.
///
/// It is a trait because the compiler may leave a closure out of line. Then the shapes go
/// through memory, and the time hangs on whether they did.
pub trait Inlined<L, R> {
    type Made;
    fn make(left: &L) -> Self::Made;
    /// To be marked as always inlined.
    fn ask(made: &Self::Made, right: R) -> bool;
}

/// What a test returns: one verdict, or those on a block of pairs.
pub trait Answer {
    /// How often it says yes.
    fn count(&self) -> usize;
    /// Adds the verdicts to those given.
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
