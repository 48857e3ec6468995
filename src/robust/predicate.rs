use super::cascade::in_exact_numbers;
#[cfg(feature = "fixed")]
use crate::arithmetic::InRaw;
use crate::arithmetic::{
    Embeds, Filtered, Float, InFloat, InWholeWord, InWord, ShortFloat, WholeWord, Word,
};
use crate::scalar::Backend;

/// Why a fast path has no answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clue {
    /// It is not for such a question.
    Unasked,
    /// The answer is in doubt.
    Doubt,
    /// It is yes for certain, but the numbers are not good.
    NoNumbers,
}

/// A question about coordinates of the scalar `S`.
///
/// It knows how to answer itself in any number system; the scalar knows which
/// systems to try, the cheapest first.
pub trait Predicate<S> {
    /// Yes or no, or what was found.
    type Answer: Default;

    /// Whether it takes products of three lengths. If not, integers for 28 bits cost no more
    /// than those for 18.
    const HAS_VOLUMES: bool = true;

    /// The answer, if `N` can vouch for it.
    fn filter<N: Embeds<S>>(&self) -> Option<Self::Answer>;

    /// The same in `f64`, where it takes but one pass without branches.
    #[inline(always)]
    fn fast_path(&self) -> Result<Self::Answer, Clue>
    where
        Filtered<f64>: Embeds<S>,
    {
        self.filter::<Filtered<f64>>().ok_or(Clue::Doubt)
    }

    /// The answer by more than the precision of `f64`, if that can vouch for it; `None` where the
    /// question has none.
    #[inline(always)]
    fn refined(&self, clue: Clue) -> Option<Self::Answer>
    where
        Filtered<f64>: Embeds<S>,
    {
        let _ = clue;
        None
    }

    /// Whether the question has a kernel of its own for floats, four at once. Then that is
    /// asked in place of [`filter`](Self::filter).
    const IN_QUADS: bool = false;

    /// The answer by floats, four at once, if they can vouch for it.
    #[inline(always)]
    fn in_quads<F: Float>(&self) -> Option<Self::Answer>
    where
        S: InFloat<F>,
    {
        None
    }

    /// The answer in words of `W`, for a question that has a kernel of its own for
    /// narrow registers, if the shapes are near enough to each other.
    #[inline(always)]
    fn narrow<W: Word>(&self) -> Option<Self::Answer>
    where
        S: InWord<W>,
    {
        None
    }

    /// The same for a question about volumes.
    #[inline(always)]
    fn narrow_volumes<W: WholeWord>(&self) -> Option<Self::Answer>
    where
        S: InWholeWord<W>,
    {
        None
    }

    /// The answer to a question with a number for an answer, by short multiples of a power of two,
    /// for cores that have no `f64`; the same bits as by `f64` and what comes after it.
    #[inline(always)]
    fn in_short_multiples(&self) -> Option<Self::Answer>
    where
        S: ShortFloat,
    {
        None
    }

    /// Whether the question has a kernel of its own for fixed point cut down to words of 32
    /// bits, with a bound on the error. Then that is asked first.
    #[cfg(feature = "fixed")]
    const IN_SHORT: bool = false;

    /// The answer by coordinates cut down to words of 32 bits, if they can vouch for it.
    #[cfg(feature = "fixed")]
    #[inline(always)]
    fn in_short(&self) -> Option<Self::Answer>
    where
        S: InRaw,
    {
        None
    }

    /// A conservative answer by coordinates cut down, for scalars so wide or questions so
    /// long that an exact one is dear; `None` where the question has none.
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
