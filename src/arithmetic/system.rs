//! Number systems: the types of a length, an area and a volume.

use core::cmp::Ordering;
use core::marker::PhantomData;
use core::ops::Mul;

use super::index::{three, turn};
use super::number::Number;

/// A number system that a kernel runs in.
///
/// Every predicate is the sign of a polynomial in coordinate differences. A
/// difference is a [`Length`](Self::Length), a product of two an
/// [`Area`](Self::Area), a product of three a [`Volume`](Self::Volume), and the type
/// checker keeps them apart. One kernel serves all systems: integers that widen,
/// floats with an error bound, and a scalar's own rounding arithmetic.
///
/// # The frame of a box
///
/// Kernels put the centre of a box at the origin. Floats subtract and halve; integers,
/// which could lose half a unit that way, [double](Self::DOUBLED) every position and
/// extent instead. [`once`] and [`of_two`] hide the difference.
pub trait Arithmetic: Sized + 'static {
    /// Coordinates, differences, extents.
    type Length: Number;
    /// Products of two lengths.
    type Area: Number;
    /// Products of three lengths.
    type Volume: Number;
    /// Products of two areas.
    type Quartic: Number;
    /// Products of two volumes.
    type Sextic: Number;
    /// Operands of products of up to four, for boxes whose axes are numbers too.
    type Product: Number + Mul<Output = Self::Product>;
    /// The same lengths and areas with narrower volumes, for shapes that are
    /// small enough.
    type Narrow: Arithmetic<Length = Self::Length, Area = Self::Area>;

    /// Whether results are exact, without an error to allow for.
    const CERTAIN: bool;
    /// Whether a number takes several words. Kernels then stop at the first axis that separates,
    /// and the steps of each loop share one piece of code: a short stack and small code matter more
    /// than branches.
    const LARGE: bool = false;
    /// Whether lengths in the frame of a box are doubled.
    const DOUBLED: bool;
    /// Whether a box given by its centre takes the path of one given by its corners, with both
    /// corners at the centre, grown by the half-extents. That is as exact, a little slower, and
    /// half the code.
    const CORNER_FORM_ONLY: bool;

    /// The product of two lengths.
    fn area(a: Self::Length, b: Self::Length) -> Self::Area;
    /// The product of an area and a length.
    fn volume(a: Self::Area, b: Self::Length) -> Self::Volume;
    /// The product of two areas.
    fn quartic(a: Self::Area, b: Self::Area) -> Self::Quartic;
    /// The product of two volumes.
    fn sextic(a: Self::Volume, b: Self::Volume) -> Self::Sextic;
    /// The product of two areas, times a third.
    fn sextic_of_areas(a: Self::Quartic, b: Self::Area) -> Self::Sextic;
    /// a·b − c·d.
    #[inline(always)]
    fn minor([a, b]: [Self::Length; 2], [c, d]: [Self::Length; 2]) -> Self::Area {
        Self::area(a, b) - Self::area(c, d)
    }
    /// The sum of three volumes, a·b.
    #[inline(always)]
    fn dot(a: &[Self::Area; 3], b: &[Self::Length; 3]) -> Self::Volume {
        Self::volume(a[0], b[0]) + Self::volume(a[1], b[1]) + Self::volume(a[2], b[2])
    }
    /// The sign of a·b, if both are cross products, by short products; `None` if these leave a doubt,
    /// or are not cheaper.
    #[inline(always)]
    fn short_sign(a: &[Self::Area; 3], b: &[Self::Area; 3]) -> Option<Ordering> {
        let _ = (a, b);
        None
    }
    /// A length as an operand of products.
    fn operand(a: Self::Length) -> Self::Product;

    /// A narrow volume as a volume of this system.
    fn widened(narrow: <Self::Narrow as Arithmetic>::Volume) -> Self::Volume;
    /// Whether the [`Narrow`](Self::Narrow) volumes hold for lengths up to `size`, and whether they
    /// are worth the check.
    #[inline(always)]
    fn is_narrow(size: Self::Length) -> bool {
        let _ = size;
        false
    }

    /// Coordinates as integer multiples of a unit, below 2^40, for floats that are short enough.
    #[inline(always)]
    fn in_forty_bits<const K: usize>(
        coordinates: &[[Self::Length; 3]; K],
    ) -> Option<[[i64; 3]; K]> {
        let _ = coordinates;
        None
    }
}

/// A number whose products have its own type.
pub trait Factor: Number + Mul<Output = Self> + 'static {
    /// [`Arithmetic::CERTAIN`].
    const CERTAIN: bool;

    /// [`Arithmetic::in_forty_bits`].
    #[inline(always)]
    fn in_forty_bits<const K: usize>(coordinates: &[[Self; 3]; K]) -> Option<[[i64; 3]; K]> {
        let _ = coordinates;
        None
    }
}

/// The number system in which lengths and all products are numbers of one type.
#[derive(Clone, Copy, Debug)]
pub struct OneType<T>(PhantomData<T>);

impl<T: Factor> Arithmetic for OneType<T> {
    type Length = T;
    type Area = T;
    type Volume = T;
    type Quartic = T;
    type Sextic = T;
    type Product = T;
    type Narrow = Self;

    const CERTAIN: bool = T::CERTAIN;
    const DOUBLED: bool = false;
    const CORNER_FORM_ONLY: bool = false;

    #[inline(always)]
    fn area(a: T, b: T) -> T {
        a * b
    }
    #[inline(always)]
    fn volume(a: T, b: T) -> T {
        a * b
    }
    #[inline(always)]
    fn quartic(a: T, b: T) -> T {
        a * b
    }
    #[inline(always)]
    fn sextic(a: T, b: T) -> T {
        a * b
    }
    #[inline(always)]
    fn sextic_of_areas(a: T, b: T) -> T {
        a * b
    }
    #[inline(always)]
    fn operand(a: T) -> T {
        a
    }
    #[inline(always)]
    fn widened(narrow: T) -> T {
        narrow
    }
    #[inline(always)]
    fn in_forty_bits<const K: usize>(coordinates: &[[T; 3]; K]) -> Option<[[i64; 3]; K]> {
        T::in_forty_bits(coordinates)
    }
}

/// A difference or an extent in the frame of a box: integers double it.
#[inline(always)]
pub(crate) fn once<N: Arithmetic, T: Number>(x: T) -> T {
    if N::DOUBLED { x + x } else { x }
}

/// The mean of two differences in the frame of a box, given their sum: floats halve it.
#[inline(always)]
pub(crate) fn of_two<N: Arithmetic, T: Number>(x: T) -> T {
    if N::DOUBLED { x } else { x.half() }
}

/// Coordinate axis `i` and the next two, or a vertex and the next two, as the kernel's loops index
/// best: those over large numbers are not unrolled.
#[inline(always)]
pub(crate) fn following<N: Arithmetic>(i: usize) -> (usize, usize, usize) {
    if N::LARGE { turn(i) } else { (i, (i + 1) % 3, (i + 2) % 3) }
}

/// a × b.
#[inline(always)]
pub(crate) fn cross<N: Arithmetic>(a: &[N::Length; 3], b: &[N::Length; 3]) -> [N::Area; 3] {
    three(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        N::minor([a[j], b[k]], [a[k], b[j]])
    })
}

/// a·b.
#[inline(always)]
pub(crate) fn dot<N: Arithmetic>(a: &[N::Area; 3], b: &[N::Length; 3]) -> N::Volume {
    N::dot(a, b)
}

/// Coordinates, and one as an operand in their unit.
type AndOne<N, const K: usize> = ([[<N as Arithmetic>::Length; 3]; K], <N as Arithmetic>::Product);

/// A number system that the coordinates of a scalar `S` can be brought into.
pub trait Embeds<S>: Arithmetic {
    /// The number system whose lengths are the areas of this one: products of an axis and a
    /// half-extent.
    type OfAreas: Arithmetic<Length = Self::Area>;

    /// Whether this system holds the coordinates, and everything that kernels compute from them.
    fn holds<const K: usize>(coordinates: &[[S; 3]; K]) -> bool;

    /// Coordinates that this system holds, all in one unit.
    fn embed_held<const K: usize>(coordinates: &[[S; 3]; K]) -> [[Self::Length; 3]; K];

    /// The coordinates in this system, all in one unit; `None` if it does not hold them.
    ///
    /// Two steps, for callers that check first and then call a kernel out of line. That was worth a
    /// tenth of the time for a fresh shape.
    #[inline(always)]
    fn embed<const K: usize>(coordinates: &[[S; 3]; K]) -> Option<[[Self::Length; 3]; K]> {
        if Self::holds(coordinates) { Some(Self::embed_held(coordinates)) } else { None }
    }

    /// The coordinates, and one as an operand in their unit.
    #[inline(always)]
    fn embed_with_one<const K: usize>(coordinates: &[[S; 3]; K]) -> Option<AndOne<Self, K>> {
        let one = Self::one()?;
        Some((Self::embed(coordinates)?, one))
    }

    /// One as an operand, where operands have the scalar's unit.
    fn one() -> Option<Self::Product> {
        None
    }

    /// A length times one, as an area in the frame; `unit` is the scalar's `UNIT_LENGTH`, embedded with it. Systems
    /// that do not double lengths have their own.
    #[inline(always)]
    fn times_one(d: Self::Length, unit: Self::Length) -> Self::Area {
        Self::area(d + d, unit)
    }

    /// Whether quotients of lengths are as accurate as the scalar promises.
    const DIVIDES: bool;

    /// num/den to the nearest number of the scalar, or the end of its range; floats divide, and
    /// overflow to an infinity. The divisor is not zero.
    fn quotient_of_lengths(num: Self::Length, den: Self::Length) -> S;

    /// Whether quotients of volumes can be as accurate as the scalar promises.
    const HAS_QUOTIENTS: bool = true;

    /// The quotients of three volumes and a divisor, given their errors, and whether they are as
    /// accurate as the scalar promises.
    fn quotients(
        num: [Self::Volume; 3],
        den: Self::Volume,
        errors: [Self::Volume; 2],
    ) -> ([S; 3], bool);

    /// The quotients of three volumes and a divisor that lie side by side.
    #[inline(always)]
    fn quotients_of_row(
        [den, a, b, c]: [Self::Volume; 4],
        errors: [Self::Volume; 2],
    ) -> ([S; 3], bool) {
        Self::quotients([a, b, c], den, errors)
    }

    /// The number of the scalar to which all numbers between these two round, if they round to one.
    /// `None` if the system has none, and near the ends of the scalar's range.
    fn nearest([low, high]: [Self::Volume; 2]) -> Option<S> {
        let _ = (low, high);
        None
    }

    /// num/den as a number of the scalar, given the errors of both: the nearest, or in floats within
    /// 0.51 units in the last place. `None` if it is not known as well. The divisor is above zero.
    fn coordinate(num: Self::Sextic, den: Self::Sextic, errors: [Self::Sextic; 2]) -> Option<S>;

    /// The point a + v·num/den, each coordinate as of [`coordinate`](Self::coordinate), given the
    /// errors of `v` beside a roundoff of itself, of `num` and of `den`. Numbers without errors have
    /// [`coordinate`](Self::coordinate) instead.
    #[inline(always)]
    fn on_line(
        a: &[Self::Length; 3],
        v: &[Self::Area; 3],
        num: Self::Volume,
        den: Self::Quartic,
        errors: (Self::Area, Self::Volume, Self::Quartic),
    ) -> Option<[S; 3]> {
        let _ = (a, v, num, den, errors);
        None
    }

    /// How num/den compares with `t`, if `num` and `den` err by up to `errors` and `den` is
    /// certainly above zero. `None` in doubt.
    fn compare_quotient(
        num: Self::Volume,
        den: Self::Volume,
        errors: [Self::Volume; 2],
        t: S,
    ) -> Option<Ordering>;
}

/// Applies `f` to each coordinate.
///
/// A loop into a filled array, because `array::map` is often not inlined, and its way through
/// memory then costs more than a whole query.
#[inline(always)]
pub(super) fn convert<A: Copy, B: Copy, const K: usize>(
    from: &[[A; 3]; K],
    empty: B,
    mut f: impl FnMut(A) -> B,
) -> [[B; 3]; K] {
    let mut to = [[empty; 3]; K];
    for k in 0..K {
        for i in 0..3 {
            to[k][i] = f(from[k][i]);
        }
    }
    to
}
