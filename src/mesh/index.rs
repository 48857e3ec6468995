/// An index of a vertex or a triangle: `u16`, which saves flash, or `u32`.
///
/// The trait is sealed.
pub trait Index: sealed::Sealed + Copy + Ord + core::fmt::Debug + Send + Sync + 'static {
    /// The number of different indices.
    #[doc(hidden)]
    const COUNT: u64;
    #[doc(hidden)]
    fn get(self) -> usize;
    /// The index `i`, which is below [`COUNT`](Self::COUNT).
    #[doc(hidden)]
    fn of(i: usize) -> Self;
}

impl Index for u16 {
    const COUNT: u64 = 1 << 16;

    #[inline(always)]
    fn get(self) -> usize {
        self.into()
    }

    #[inline(always)]
    fn of(i: usize) -> Self {
        i as Self
    }
}

impl Index for u32 {
    const COUNT: u64 = 1 << 32;

    #[inline(always)]
    fn get(self) -> usize {
        self as usize
    }

    #[inline(always)]
    fn of(i: usize) -> Self {
        i as Self
    }
}

mod sealed {
    pub trait Sealed {}

    impl Sealed for u16 {}
    impl Sealed for u32 {}
}
