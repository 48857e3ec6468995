use super::cascade::in_exact_numbers;
#[cfg(feature = "fixed")]
use crate::arithmetic::InRaw;
use crate::arithmetic::{
    Embeds, Filtered, Float, InFloat, InWholeWord, InWord, ShortFloat, WholeWord, Word,
};
use crate::scalar::Backend;

/// The reason why a fast path has no answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clue {
    /// It does not serve this question.
    Unasked,
    /// The answer is in doubt.
    Doubt,
    /// The answer is certainly yes, but the numbers are not accurate enough.
    NoNumbers,
}

/// A question about coordinates of the scalar `S`.
///
/// It can be evaluated in any number system; the scalar chooses the systems, the cheapest first.
pub trait Predicate<S> {
    /// Yes or no, or the result.
    type Answer: Default;

    /// Whether it takes products of three lengths. If not, integers for 28 bits cost no more than
    /// those for 18.
    const HAS_VOLUMES: bool = true;

    /// The answer, if `N` is certain of it.
    fn filter<N: Embeds<S>>(&self) -> Option<Self::Answer>;

    /// The answer in `f64`, in a single pass without branches.
    #[inline(always)]
    fn fast_path(&self) -> Result<Self::Answer, Clue>
    where
        Filtered<f64>: Embeds<S>,
    {
        self.filter::<Filtered<f64>>().ok_or(Clue::Doubt)
    }

    /// The answer from more than the precision of `f64`, if that is certain; `None` if the question
    /// has no such stage.
    #[inline(always)]
    fn refined(&self, clue: Clue) -> Option<Self::Answer>
    where
        Filtered<f64>: Embeds<S>,
    {
        let _ = clue;
        None
    }

    /// Whether the question has its own kernel for floats, four at once, which then replaces
    /// [`filter`](Self::filter).
    const IN_QUADS: bool = false;

    /// The answer from floats, four at once, if they are certain of it.
    #[inline(always)]
    fn in_quads<F: Float>(&self) -> Option<Self::Answer>
    where
        S: InFloat<F>,
    {
        None
    }

    /// The answer in words of `W`, for a question with its own kernel for narrow registers, if the
    /// shapes are close enough to each other.
    #[inline(always)]
    fn narrow<W: Word>(&self) -> Option<Self::Answer>
    where
        S: InWord<W>,
    {
        None
    }

    /// The answer in words of `W` to a question about volumes.
    #[inline(always)]
    fn narrow_volumes<W: WholeWord>(&self) -> Option<Self::Answer>
    where
        S: InWholeWord<W>,
    {
        None
    }

    /// The answer to a question about numbers, by short multiples of a power of two, for cores
    /// without `f64`. It has the same bits as the answer by `f64` and later stages.
    #[inline(always)]
    fn in_short_multiples(&self) -> Option<Self::Answer>
    where
        S: ShortFloat,
    {
        None
    }

    /// Whether the question has its own kernel for fixed point cut to words of 32 bits, with an
    /// error bound. It then comes before all other integers.
    #[cfg(feature = "fixed")]
    const IN_SHORT: bool = false;

    /// The answer from coordinates cut to words of 32 bits, if it is certain.
    #[cfg(feature = "fixed")]
    #[inline(always)]
    fn in_short(&self) -> Option<Self::Answer>
    where
        S: InRaw,
    {
        None
    }

    /// A conservative answer from cut coordinates, if an exact one is expensive because the scalar
    /// is wide or the question long; `None` if the question has none.
    #[cfg(feature = "fixed")]
    #[inline(always)]
    fn cut_down(&self) -> Option<Self::Answer>
    where
        S: InRaw,
    {
        None
    }

    /// The answer for every input.
    fn exact(&self) -> Self::Answer
    where
        S: Backend,
        Self: Sized,
    {
        in_exact_numbers(self)
    }
}
