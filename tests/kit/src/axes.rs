/// Applies `f` to each coordinate axis. In a build for tests `array::map` compiles to six functions
/// for each closure, and this to one.
pub fn three<T>(mut f: impl FnMut(usize) -> T) -> [T; 3] {
    [f(0), f(1), f(2)]
}

/// `array::map` of short arrays: see [`three`]. The crate has the same, which it does not publish.
pub trait Each {
    /// Of the array given.
    type Item;
    /// An array as long, of other elements.
    type Of<U>;

    /// Applies `f` to each element.
    fn each<U>(self, f: impl FnMut(Self::Item) -> U) -> Self::Of<U>;
}

impl<T> Each for [T; 2] {
    type Item = T;
    type Of<U> = [U; 2];

    fn each<U>(self, mut f: impl FnMut(T) -> U) -> [U; 2] {
        let [a, b] = self;
        [f(a), f(b)]
    }
}

impl<T> Each for [T; 3] {
    type Item = T;
    type Of<U> = [U; 3];

    fn each<U>(self, mut f: impl FnMut(T) -> U) -> [U; 3] {
        let [a, b, c] = self;
        [f(a), f(b), f(c)]
    }
}

impl<T> Each for [T; 4] {
    type Item = T;
    type Of<U> = [U; 4];

    fn each<U>(self, mut f: impl FnMut(T) -> U) -> [U; 4] {
        let [a, b, c, d] = self;
        [f(a), f(b), f(c), f(d)]
    }
}
