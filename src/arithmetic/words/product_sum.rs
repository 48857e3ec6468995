//! Sums of products of two words; only their signs are used.

use core::ops::{Add, Shl};

/// A sum of products of two lengths: see the table at [`Word`](super::Word).
pub trait ProductSum<W>: Copy {
    /// Whether one multiplication gives a whole product.
    const IS_WHOLE: bool;

    /// a·b + c·d.
    fn new(a: W, b: W, c: W, d: W) -> Self;

    /// The sum with one more product, a·b.
    fn with_product(self, a: W, b: W) -> Self;

    /// A word that is negative exactly if the area is.
    fn sign(self) -> W;

    /// The sum over 2^[`SPLIT`](super::Word::SPLIT), rounded down, if a word holds it.
    fn scaled(self) -> W;

    /// [`scaled`](Self::scaled) over 2^`places`, rounded down.
    fn scaled_by(self, places: u32) -> W;

    /// A sum of products of an area and a length.
    type Volume: Copy;
    /// The area times one.
    fn volume(self) -> Self::Volume;
    /// The empty sum.
    const ZERO: Self::Volume;
    /// The sum with one more product.
    fn sum(volume: Self::Volume, area: Self, length: W) -> Self::Volume;
    /// Whether the sum is negative.
    fn is_negative(volume: Self::Volume) -> bool;
    /// The type of the parts of a sum.
    type Part;
    /// The sum as one number, for a `T` that can hold it.
    fn whole<T>(volume: Self::Volume) -> T
    where
        T: From<Self::Part> + Add<Output = T> + Shl<u32, Output = T>;
}
