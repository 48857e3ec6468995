//! The number types that a scene may be converted to.

use crate::scene::Scene;

/// A number type.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Kind {
    Fixed { bits: u32, frac: u32 },
    F32,
    F64,
}

use Kind::{F32, F64, Fixed};

impl Kind {
    pub(crate) fn bits(self) -> u32 {
        match self {
            Fixed { bits, .. } => bits,
            F32 => 32,
            F64 => 64,
        }
    }

    /// The fraction bits of a fixed-point type. Floats count as having none.
    pub(crate) fn fraction_bits(self) -> u32 {
        match self {
            Fixed { frac, .. } => frac,
            F32 | F64 => 0,
        }
    }

    pub(crate) fn is_float(self) -> bool {
        self == F32 || self == F64
    }

    /// Its name in the crate `fixed`: the short one if there is one.
    pub(crate) fn name(self) -> String {
        match self {
            Fixed { bits, frac } if 2 * frac == bits => format!("I{frac}F{frac}"),
            Fixed { bits, frac } => format!("FixedI{bits}<U{frac}>"),
            F32 => "f32".into(),
            F64 => "f64".into(),
        }
    }

    /// The type with its whole path.
    pub(crate) fn path(self) -> String {
        match self {
            Fixed { bits, frac } => format!("fixed::FixedI{bits}<fixed::types::extra::U{frac}>"),
            F32 | F64 => self.name(),
        }
    }

    /// The nearest number to `x`, in units of the last place, if an integer of `bits`
    /// bits holds it.
    pub(crate) fn raw(x: f64, bits: u32, frac: u32) -> Option<f64> {
        let raw = (x * f64::from(frac).exp2()).round_ties_even();
        let end = f64::from(bits - 1).exp2();
        (-end <= raw && raw < end).then_some(raw)
    }

    /// The nearest number to `x`, if the type's range holds it.
    pub(crate) fn nearest(self, x: f64) -> Option<f64> {
        match self {
            Fixed { bits, frac } => Some(Self::raw(x, bits, frac)? / f64::from(frac).exp2()),
            F32 => Some(f64::from(x as f32)).filter(|x| x.is_finite()),
            F64 => Some(x),
        }
    }

    /// The power of two that is the least strict upper bound of all numbers.
    pub(crate) fn end(self) -> f64 {
        match self {
            Fixed { bits, frac } => (f64::from(bits) - 1.0 - f64::from(frac)).exp2(),
            F32 => 128_f64.exp2(),
            F64 => f64::INFINITY,
        }
    }

    /// The greatest number; for 64 bits, to the nearest `f64`.
    pub(crate) fn greatest(self) -> f64 {
        match self {
            Fixed { frac, .. } => self.end() - f64::from(frac).exp2().recip(),
            F32 => f64::from(f32::MAX),
            F64 => f64::MAX,
        }
    }

    /// Whether both ends of the range are within the type's range.
    pub(crate) fn holds(self, range: [f64; 2]) -> bool {
        range.iter().all(|&x| self.nearest(x).is_some())
    }
}

/// The most fraction bits with which the range fits in `below` of the type's `bits` bits. A faster
/// stage decides numbers that fit in fewer bits.
pub(crate) fn most_fraction_bits(bits: u32, below: u32, range: [f64; 2]) -> Option<u32> {
    (0..=bits).rev().find(|&frac| range.iter().all(|&x| Kind::raw(x, below, frac).is_some()))
}

/// The types that are considered: types that hold the scene, and types that do not.
pub(crate) struct Candidates {
    pub(crate) held: Vec<Kind>,
    pub(crate) too_large: Vec<Kind>,
}

impl Candidates {
    /// For each width, the type with the most fraction bits that holds the scene; for each stage of
    /// its cascade, the type with the most fraction bits that the stage can decide. Also the types
    /// with the point in the middle, and the floats.
    pub(crate) fn of(scene: &Scene) -> Self {
        let range = scene.range();
        let mut all = Vec::new();
        for (bits, stages) in [(8, &[8][..]), (16, &[16]), (32, &[19, 29, 32]), (64, &[40, 61, 64])]
        {
            let most = stages.iter().filter_map(|&below| most_fraction_bits(bits, below, range));
            let mut fracs: Vec<u32> = most.chain([bits / 2]).collect();
            if fracs.len() == 1 {
                fracs.push(0);
            }
            fracs.sort_unstable();
            fracs.dedup();
            all.extend(fracs.into_iter().map(|frac| Fixed { bits, frac }));
        }
        all.extend([F32, F64]);
        let (held, too_large) = all.into_iter().partition(|kind| kind.holds(range));
        Self { held, too_large }
    }
}
