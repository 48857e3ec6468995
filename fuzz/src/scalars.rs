//! The choice of the scalar.

use fixed::types::extra::{U0, U1, U4, U7, U8, U15, U16, U30, U31, U32, U63, U64};
use fixed::{FixedI8, FixedI16, FixedI32, FixedI64};

use crate::bytes::Bytes;
use crate::shapes::Shapes;
use septum::interop::FixedPoint;
use septum_kit::Sample;

/// A check in any scalar.
pub(crate) trait Check {
    fn check<S: Sample>(shapes: &mut Shapes<'_, S>);
}

/// A check in fixed point.
pub(crate) trait FixedCheck {
    fn check<S: Sample + FixedPoint>(shapes: &mut Shapes<'_, S>);
}

/// Runs the check in the scalar that the first byte selects.
pub(crate) fn run<C: Check>(data: &[u8]) {
    let mut bytes = Bytes::new(data);
    // Floats have more stages, so they are chosen twice as often.
    match bytes.below(20) {
        0 | 1 => C::check(&mut Shapes::<f32>::new(bytes)),
        2 | 3 => C::check(&mut Shapes::<f64>::new(bytes)),
        n => run_fixed::<InFixedPoint<C>>(n - 4, bytes),
    }
}

/// Runs the check in fixed-point type `n`: the usual types, and types whose bits are all, all but
/// one, or not at all fraction bits.
pub(crate) fn run_fixed<C: FixedCheck>(n: usize, bytes: Bytes<'_>) {
    match n % FIXED {
        0 => C::check(&mut Shapes::<FixedI8<U4>>::new(bytes)),
        1 => C::check(&mut Shapes::<FixedI16<U8>>::new(bytes)),
        2 => C::check(&mut Shapes::<FixedI32<U16>>::new(bytes)),
        3 => C::check(&mut Shapes::<FixedI64<U32>>::new(bytes)),
        4 => C::check(&mut Shapes::<FixedI8<U7>>::new(bytes)),
        5 => C::check(&mut Shapes::<FixedI8<U8>>::new(bytes)),
        6 => C::check(&mut Shapes::<FixedI16<U0>>::new(bytes)),
        7 => C::check(&mut Shapes::<FixedI16<U15>>::new(bytes)),
        8 => C::check(&mut Shapes::<FixedI16<U16>>::new(bytes)),
        9 => C::check(&mut Shapes::<FixedI32<U0>>::new(bytes)),
        10 => C::check(&mut Shapes::<FixedI32<U30>>::new(bytes)),
        11 => C::check(&mut Shapes::<FixedI32<U31>>::new(bytes)),
        12 => C::check(&mut Shapes::<FixedI64<U1>>::new(bytes)),
        13 => C::check(&mut Shapes::<FixedI64<U31>>::new(bytes)),
        14 => C::check(&mut Shapes::<FixedI64<U63>>::new(bytes)),
        _ => C::check(&mut Shapes::<FixedI64<U64>>::new(bytes)),
    }
}

const FIXED: usize = 16;

/// Makes a check in any scalar a check in fixed point.
struct InFixedPoint<C>(core::marker::PhantomData<C>);

impl<C: Check> FixedCheck for InFixedPoint<C> {
    fn check<S: Sample + FixedPoint>(shapes: &mut Shapes<'_, S>) {
        C::check(shapes);
    }
}
