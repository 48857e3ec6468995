//! A number for each of several directions, in one word or side by side.

use core::ops::{Add, Div, Mul, Sub};

use crate::arithmetic::{Float, Quad, exp2, greatest, least};

/// A float in which directions are measured.
pub(super) trait Measure: Float + Div<Output = Self> {
    /// If the square of a cross product is below this part of P², it may be off by more than
    /// [`SPREAD`](Self::SPREAD).
    const NOISE: Self;
    /// The relative error of the square of a cross product.
    const SPREAD: Self;
    /// The same if the square is at least a sixteenth of P².
    const LEAST_SPREAD: Self;
    /// The spread of each of four squares, by bits that are set for [`SPREAD`](Self::SPREAD).
    const SPREADS: [[Self; 4]; 16] = spreads([Self::LEAST_SPREAD, Self::SPREAD]);
    /// The range of sizes, and of sides with half-extents. A number within it may be squared, cubed,
    /// and squared again; in `f32` a product may be squared.
    const SIZES: (Self, Self);
    /// The range of P. Axes that are parallel except for a residue have a short cross product.
    const PRODUCTS: (Self, Self);
    const INFINITY: Self;

    fn is_size(self) -> bool {
        (self > Self::SIZES.0) & (self < Self::SIZES.1)
    }

    /// Whether a product is so great that underflow does not matter, and no more than that.
    fn is_product(self) -> bool {
        (self > Self::PRODUCTS.0) & (self < Self::PRODUCTS.1)
    }
}

impl Measure for f64 {
    const NOISE: Self = exp2(-54);
    const SPREAD: Self = exp2(-20);
    const LEAST_SPREAD: Self = exp2(-45);
    const SIZES: (Self, Self) = (exp2(-100), exp2(100));
    const PRODUCTS: (Self, Self) = (exp2(-150), exp2(100));
    const INFINITY: Self = Self::INFINITY;
}

impl Measure for f32 {
    const NOISE: Self = exp2(-22) as Self;
    const SPREAD: Self = exp2(-8) as Self;
    const LEAST_SPREAD: Self = exp2(-16) as Self;
    const SIZES: (Self, Self) = (exp2(-20) as Self, exp2(20) as Self);
    const PRODUCTS: (Self, Self) = (exp2(-20) as Self, exp2(20) as Self);
    const INFINITY: Self = Self::INFINITY;
}

const fn spreads<F: Copy>(of: [F; 2]) -> [[F; 4]; 16] {
    let mut spreads = [[of[0]; 4]; 16];
    let mut n = 0;
    while n < 64 {
        spreads[n / 4][n % 4] = of[(n / 4) >> (n % 4) & 1];
        n += 1;
    }
    spreads
}

/// A number for each of several directions: a float, or four as hosts have them. Comparisons with NaN
/// are false.
pub(super) trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    type Lane: Measure;
    /// Numbers of 16 directions or more, against them and along them.
    type All: AsRef<[[Self; 2]]> + AsMut<[[Self; 2]]>;
    /// How many.
    const COUNT: usize;

    fn all(all: [Self; 2]) -> Self::All;
    fn of(lane: impl Fn(usize) -> Self::Lane) -> Self;
    fn lane(self, n: usize) -> Self::Lane;
    fn size(self) -> Self;
    fn most(self, other: Self) -> Self;
    fn least(self, other: Self) -> Self;
    /// The lanes in which this is the greater, as bits.
    fn is_above(self, other: Self) -> u32;
    /// The lanes in which this is at most `other`.
    fn is_within(self, other: Self) -> u32;

    #[inline(always)]
    fn same(x: Self::Lane) -> Self {
        Self::of(|_| x)
    }
}

// One direction at a time, for cores with 32-bit registers.
macro_rules! one {
    ($float:ty) => {
        impl Lanes for $float {
            type Lane = Self;
            type All = [[Self; 2]; 16];
            const COUNT: usize = 1;

            fn all(all: [Self; 2]) -> Self::All {
                [all; 16]
            }
            #[inline(always)]
            fn of(lane: impl Fn(usize) -> Self) -> Self {
                lane(0)
            }
            #[inline(always)]
            fn lane(self, _: usize) -> Self {
                self
            }
            #[inline(always)]
            fn size(self) -> Self {
                self.abs()
            }
            #[inline(always)]
            fn most(self, other: Self) -> Self {
                greatest(self, other)
            }
            #[inline(always)]
            fn least(self, other: Self) -> Self {
                least(self, other)
            }
            #[inline(always)]
            fn is_above(self, other: Self) -> u32 {
                (self > other).into()
            }
            #[inline(always)]
            fn is_within(self, other: Self) -> u32 {
                (self <= other).into()
            }
        }
    };
}
one! { f32 }
one! { f64 }

impl<Q: Quad<Lane: Measure>> Lanes for Q {
    type Lane = Q::Lane;
    type All = [[Self; 2]; 4];
    const COUNT: usize = 4;

    #[inline(always)]
    fn all(all: [Self; 2]) -> Self::All {
        [all; 4]
    }
    #[inline(always)]
    fn of(lane: impl Fn(usize) -> Q::Lane) -> Self {
        Q::new([lane(0), lane(1), lane(2), lane(3)])
    }
    #[inline(always)]
    fn lane(self, n: usize) -> Q::Lane {
        self.to_array()[n % 4]
    }
    #[inline(always)]
    fn size(self) -> Self {
        self.magnitude()
    }
    #[inline(always)]
    fn most(self, other: Self) -> Self {
        self.greatest(other)
    }
    #[inline(always)]
    fn least(self, other: Self) -> Self {
        Quad::least(self, other)
    }
    #[inline(always)]
    fn is_above(self, other: Self) -> u32 {
        self.exceeds(other)
    }
    #[inline(always)]
    fn is_within(self, other: Self) -> u32 {
        self.is_at_most(other)
    }
}
