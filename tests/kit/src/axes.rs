/// Applies `f` to each coordinate axis. In a build for tests `array::map` compiles to six functions
/// for each closure, and this to one.
pub fn three<T>(mut f: impl FnMut(usize) -> T) -> [T; 3] {
    [f(0), f(1), f(2)]
}
