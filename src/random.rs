//! Random numbers for unit tests, the same for ever.

/// SplitMix64 (G. L. Steele, D. Lea, C. H. Flood, "Fast Splittable Pseudorandom Number
/// Generators", OOPSLA 2014).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number from −1 to 1.
    pub(crate) fn number(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// A number from −1 to 1 of so many bits.
    pub(crate) fn short(&mut self, bits: u32) -> f64 {
        let whole = (self.bits() as i64) >> (64 - bits);
        whole as f64 * 2_f64.powi(1 - bits as i32)
    }

    /// A triangle that contains this point, but for roundings, in such numbers.
    pub(crate) fn triangle_across(&mut self, point: [f64; 3], bits: u32) -> [[f64; 3]; 3] {
        let [u, v] = [(); 2].map(|()| [(); 3].map(|()| self.short(bits)));
        let [s, t] = [(); 2].map(|()| self.short(bits).abs());
        let at = |s: f64, t: f64| [0, 1, 2].map(|i: usize| point[i] + s * u[i] + t * v[i]);
        [at(1.0, 0.0), at(-s, t), at(0.0, -1.0)]
    }

    /// An integer from zero to n − 1.
    pub(crate) fn below(&mut self, n: u64) -> i64 {
        ((u128::from(self.bits()) * u128::from(n)) >> 64) as i64
    }
}

#[cfg(feature = "fixed")]
impl Random {
    /// An integer from −n to n.
    pub(crate) fn within(&mut self, n: u32) -> i64 {
        let z = self.bits() as u32;
        ((u64::from(z) * u64::from(2 * n + 1)) >> 32) as i64 - i64::from(n)
    }

    /// A number of `bits` bits without its sign: any, at the end of the range, or from a small set.
    pub(crate) fn of_bits(&mut self, kind: i64, bits: u32) -> i64 {
        let end = (1 << bits) - 1;
        match kind {
            0 => self.below(2 << bits) - end - 1,
            1 => [-end - 1, end, 0, 1, -1][self.below(5) as usize],
            2 => (self.below(5) - 2) << (bits - 2).min(14),
            _ => self.below(7) - 3,
        }
    }
}
