//! Counts how many of a fixed stream of questions escalate past each stage.
//!
//! An error bound that is too wide gives no wrong answer, so no hash of answers reveals it: it only
//! sends questions to more expensive arithmetic. The counts do reveal it, and they are the same on
//! every machine. After a change of a bound or a cascade, measure its price and write down the new
//! counts: `counts.txt`, and `counts_narrow.txt` for 32-bit registers (`--cfg septum_narrow`).

mod seldom;
mod stream;

use crate::arithmetic::{Each, InRaw};
use crate::random::Random;
use crate::scalar::Scalar;

trait Sample: Scalar {
    /// A number of one of three kinds: on a coarse grid, on a fine grid, or on a fine grid far from
    /// zero, where the last digits of the type decide contact.
    fn sample(rng: &mut Random, kind: u32) -> Self;

    /// Orthogonal axes, of length one or nearly.
    fn turned() -> [[Self; 3]; 3];
}

/// The axes after two rotations by the angles of the 3-4-5 triangle, in hundredths.
const TURNED: [[i64; 3]; 3] = [[60, 80, 0], [-48, 36, 80], [64, -48, 60]];

/// A sample of a float. In `f64` the samples for `f32` are exact, so they are rounded once.
fn float(rng: &mut Random, kind: u32, far: f64) -> f64 {
    match kind {
        0 => rng.within(4) as f64,
        1 => rng.within(1 << 20) as f64 / 262_144.0,
        _ => far + rng.within(1 << 20) as f64 / 262_144.0,
    }
}

impl Sample for f32 {
    fn sample(rng: &mut Random, kind: u32) -> Self {
        float(rng, kind, 1e5) as Self
    }
    fn turned() -> [[Self; 3]; 3] {
        TURNED.each(|u| u.each(|x| x as Self / 100.0))
    }
}

impl Sample for f64 {
    fn sample(rng: &mut Random, kind: u32) -> Self {
        float(rng, kind, 1e14)
    }
    fn turned() -> [[Self; 3]; 3] {
        TURNED.each(|u| u.each(|x| x as Self / 100.0))
    }
}

impl<S: Scalar + InRaw> Sample for S {
    fn sample(rng: &mut Random, kind: u32) -> Self {
        let [coarse, fine, far] = match S::FRACTION_BITS {
            8 => [6, 13, 13],
            16 => [15, 18, 30],
            _ => [30, 20, 62],
        };
        Self::from_raw(match kind {
            0 => rng.within(4) << coarse,
            1 => rng.within(1 << 20) >> (20 - fine),
            _ => (1 << far) + (rng.within(1 << 20) >> (20 - fine)),
        })
    }
    fn turned() -> [[Self; 3]; 3] {
        TURNED.each(|u| u.each(|x| Self::from_raw((x << S::FRACTION_BITS) / 100)))
    }
}
