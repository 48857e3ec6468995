/// What a conservative method in floats must allow for.
#[derive(Clone, Copy, Debug)]
pub struct Padding<S> {
    /// Eight times the unit roundoff.
    pub ratio: S,
    /// The least normal number.
    pub least: S,
    /// Between these a number has a reciprocal that is a normal number, with a wide
    /// margin.
    pub tame: (S, S),
}
