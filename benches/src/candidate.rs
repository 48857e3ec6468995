//! Candidates: a test on its data, with its answers checked.

use std::rc::Rc;

use crate::pairs::{Answer, Block, Inlined, Pairs};

/// The promise that a test makes about its answers.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Promise {
    Exact,
    /// Misses no overlap.
    NeverMisses,
    /// Reports no false overlap.
    NeverInvents,
    Nothing,
}

/// The input of tests: pairs of shapes, and the true answers.
pub struct Course<L, R> {
    pub scalar: &'static str,
    pub form: &'static str,
    pairs: Rc<Pairs<L, R>>,
    truth: Rc<[bool]>,
}

impl<L: 'static, R: 'static> Course<L, R> {
    pub fn new(
        (scalar, form): (&'static str, &'static str),
        pairs: Pairs<L, R>,
        truth: Vec<bool>,
    ) -> Self {
        Self { scalar, form, pairs: Rc::new(pairs), truth: truth.into() }
    }

    /// The same pairs in another form, made before the clock starts.
    pub fn prepared<M, S>(
        &self,
        form: &'static str,
        prepare: impl FnOnce(&Pairs<L, R>) -> Pairs<M, S>,
    ) -> Course<M, S> {
        Course {
            scalar: self.scalar,
            form,
            pairs: Rc::new(prepare(&self.pairs)),
            truth: Rc::clone(&self.truth),
        }
    }

    /// Makes a candidate of a test. The test should be a function that is called, not inlined.
    pub fn candidate<A: Answer + 'static>(
        &self,
        who: &str,
        promise: Promise,
        test: fn(&L, &R) -> A,
    ) -> Candidate {
        let pairs = Rc::clone(&self.pairs);
        let run = Box::new(move || pairs.count(test));
        self.judged(who, promise, self.pairs.answers(test), run)
    }

    fn judged(
        &self,
        who: &str,
        promise: Promise,
        answers: Vec<bool>,
        run: Box<dyn Fn() -> usize>,
    ) -> Candidate {
        assert_eq!(answers.len(), self.truth.len(), "{who} answered another question");
        let differ = |said: bool| {
            let wrong = |(a, t): &(&bool, &bool)| **a == said && **t != said;
            answers.iter().zip(&*self.truth).filter(wrong).count()
        };
        Candidate {
            who: who.into(),
            scalar: self.scalar,
            form: self.form,
            pairs: answers.len(),
            overlaps: answers.iter().filter(|a| **a).count(),
            false_disjoint: differ(false),
            false_overlap: differ(true),
            answers,
            run,
            promise,
        }
    }
}

impl<L: 'static, R: Block + 'static> Course<L, R> {
    /// Makes a candidate of an inlined test, on shapes made while the clock runs.
    pub fn candidate_inlined<T: Inlined<L, R::Shape>>(
        &self,
        who: &str,
        promise: Promise,
    ) -> Candidate {
        let pairs = Rc::clone(&self.pairs);
        let run = Box::new(move || pairs.count_inlined::<T>());
        let judged = self.judged(who, promise, self.pairs.answers_inlined::<T>(), run);
        // These answers are too many to keep, and not needed.
        Candidate { answers: Vec::new(), ..judged }
    }
}

/// One test on one scene.
pub struct Candidate {
    pub who: String,
    pub scalar: &'static str,
    pub form: &'static str,
    pub pairs: usize,
    pub overlaps: usize,
    pub false_disjoint: usize,
    pub false_overlap: usize,
    /// The answer to each pair; empty if the shapes are made while the clock runs.
    pub answers: Vec<bool>,
    /// Runs through the scene once and counts the overlaps.
    pub run: Box<dyn Fn() -> usize>,
    promise: Promise,
}

impl Candidate {
    /// The same under another name.
    pub fn named(self, who: &str) -> Self {
        Self { who: who.into(), ..self }
    }

    /// Whether the test kept its promise on this scene.
    pub fn kept_its_word(&self) -> bool {
        let (misses, inventions) = (self.false_disjoint, self.false_overlap);
        match self.promise {
            Promise::Exact => misses == 0 && inventions == 0,
            Promise::NeverMisses => misses == 0,
            Promise::NeverInvents => inventions == 0,
            Promise::Nothing => true,
        }
    }
}
