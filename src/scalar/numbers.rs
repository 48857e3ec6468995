//! Number systems: in what types a length, an area and a volume are held.

use core::cmp::Ordering;
use core::ops::Mul;

use super::number::Number;

/// A number system for the separating-axis kernels.
///
/// Every predicate here is the sign of a polynomial in coordinate differences.
/// A difference is a [`Length`](Self::Length), a product of two an
/// [`Area`](Self::Area), a product of three a [`Volume`](Self::Volume), and the
/// type checker keeps them apart. One kernel serves all systems: integers that
/// widen, floats with an error bound, and the scalar's own rounding arithmetic.
///
/// # The frame
///
/// The kernels work on a box centred at the origin. Floats put it there by
/// subtraction; integers, which could lose half a unit that way, double every
/// position and extent instead. [`middle`](Self::middle) hides the difference.
pub trait Numbers: Sized + 'static {
    /// Coordinates, differences, extents.
    type Length: Number;
    /// Products of two lengths: cross products, normals, the nine edge axes.
    type Area: Number;
    /// Products of three lengths: the plane axis.
    type Volume: Number;
    /// The same lengths and areas with narrower volumes, for shapes that are
    /// small enough.
    type Slim: Numbers<Length = Self::Length, Area = Self::Area>;

    /// Whether a result is final as it stands, with no error to allow for.
    const FINAL: bool;

    /// Whether a box given by its centre goes the way of one given by its corners,
    /// both at the centre and grown by the half-extents: as exact, a little
    /// slower, half the code.
    const ONE_FORM: bool;

    /// The product of two lengths.
    fn area(a: Self::Length, b: Self::Length) -> Self::Area;
    /// The product of an area and a length.
    fn volume(a: Self::Area, b: Self::Length) -> Self::Volume;

    /// A position in the frame of a box given by its centre.
    fn from_center(v: Self::Length, center: Self::Length) -> Self::Length;
    /// A position in the frame of a box given by its least and greatest corner.
    fn from_corners(v: Self::Length, min: Self::Length, max: Self::Length) -> Self::Length;
    /// The half-extent, in the frame, of a box given by its centre.
    fn half_extent(half: Self::Length) -> Self::Length;
    /// The half-extent, in the frame, of a box given by its corners.
    fn half_between(min: Self::Length, max: Self::Length) -> Self::Length;
    /// The middle of the interval from nought to `n`, where `n` is a product of
    /// two differences and the interval is one of products with a position in
    /// the frame.
    fn middle(n: Self::Area) -> Self::Area;

    /// How far a sum of computed areas may be from the truth, each the product of
    /// an operand up to `a` and one up to `b`, but one that is up to `c`:
    /// `roundoffs` times the unit roundoff times a·b + c. `None` where that is not
    /// known.
    fn area_bound(
        a: Self::Length,
        b: Self::Length,
        c: Self::Area,
        roundoffs: u8,
    ) -> Option<Self::Area> {
        let _ = (a, b, c, roundoffs);
        None
    }

    /// How far a sum of computed volumes may be from the truth, each the product
    /// of an operand up to `a`, one up to `b` and one up to `c`: `roundoffs` times
    /// the unit roundoff times a·b·c. `None` where that is not known.
    fn volume_bound(
        a: Self::Length,
        b: Self::Length,
        c: Self::Length,
        roundoffs: u8,
    ) -> Option<Self::Volume> {
        let _ = (a, b, c, roundoffs);
        None
    }

    /// How far a computed length of that size may be from the truth: `roundoffs` times
    /// the unit roundoff times `size`. For integers nought.
    fn length_error(size: Self::Length, roundoffs: u8) -> Self::Length;
    /// The same of an area, products that underflow allowed for.
    fn area_error(size: Self::Area, roundoffs: u8) -> Self::Area;

    /// A slim volume as one of this system.
    fn widened(slim: <Self::Slim as Numbers>::Volume) -> Self::Volume;

    /// Whether the [`Slim`](Self::Slim) volumes hold for operands up to `reach`,
    /// and are worth the question.
    fn is_slim(reach: Self::Length) -> bool;

    /// Products of up to four operands, for boxes whose axes are numbers too.
    type Product: Number + Mul<Output = Self::Product>;
    /// A length as an operand of such products.
    fn operand(a: Self::Length) -> Self::Product;
    /// How far such products may be from the truth, for axes up to `axes`,
    /// lengths up to `length` and half-extents up to `half`. With reach the
    /// greater of length and half·axes: the three given numbers times the unit
    /// roundoff, times axes²·reach, axes·reach² and reach³. `None` where that is
    /// not known or the products may not fit.
    fn product_bounds(
        axes: Self::Product,
        length: Self::Product,
        half: Self::Product,
        roundoffs: [u16; 3],
    ) -> Option<[Self::Product; 3]> {
        let _ = (axes, length, half, roundoffs);
        None
    }

    /// How far a computed area and a computed volume may be from the truth,
    /// when no operand exceeds `reach`: `areas` and `volumes` times the unit
    /// roundoff times reach² and reach³. `None` where that is not known,
    /// because something may overflow or underflow.
    fn bounds(reach: Self::Length, areas: u8, volumes: u8) -> Option<(Self::Area, Self::Volume)>;
}

/// A number system that the coordinates of a scalar `S` can be brought into.
pub trait Holds<S>: Numbers {
    /// Whether this system holds the coordinates, and all that is made of them.
    fn fits<const K: usize>(coordinates: &[[S; 3]; K]) -> bool;

    /// One as an operand, where operands have the scalar's unit.
    fn one() -> Option<Self::Product> {
        None
    }

    /// A length times one, as an area in the frame, where one has the scalar's
    /// unit.
    fn times_one(d: Self::Length) -> Option<Self::Area> {
        let _ = d;
        None
    }

    /// Whether quotients of lengths are as good as the scalar promises.
    const DIVIDES: bool;

    /// num/den to the nearest number of the scalar, or the end of its range; floats
    /// divide, and overflow to an infinity. The divisor is not nought.
    fn quotient_of_lengths(num: Self::Length, den: Self::Length) -> S;

    /// The same of three volumes, and whether they are as good as the scalar
    /// promises, given how far from the truth the first may be, and the others.
    fn quotients(
        num: [Self::Volume; 3],
        den: Self::Volume,
        errors: [Self::Volume; 2],
    ) -> ([S; 3], bool);

    /// How num/den compares with `t`, where `num` and `den` err by up to `errors`;
    /// `den` is above nought, whatever its error. `None` in doubt.
    fn compare_quotient(
        num: Self::Volume,
        den: Self::Volume,
        errors: [Self::Volume; 2],
        t: S,
    ) -> Option<Ordering>;

    /// Brings points and extents that fit into this system, the points relative
    /// to an origin of the system's choice.
    fn place<const P: usize, const E: usize>(
        points: &[[S; 3]; P],
        extents: &[[S; 3]; E],
    ) -> Placed<Self::Length, P, E>;
}

/// Points and extents in a number system.
#[derive(Clone, Copy, Debug)]
pub struct Placed<L, const P: usize, const E: usize> {
    /// The points.
    pub points: [[L; 3]; P],
    /// The extents.
    pub extents: [[L; 3]; E],
}

/// Every coordinate by `f`, in order.
///
/// A loop into a filled array: `array::map` is often not inlined, and then its
/// round trip through memory costs more than a whole query.
#[inline(always)]
pub(super) fn convert<A: Copy, B: Copy, const K: usize>(
    from: &[[A; 3]; K],
    empty: B,
    mut f: impl FnMut(usize, A) -> B,
) -> [[B; 3]; K] {
    let mut to = [[empty; 3]; K];
    for k in 0..K {
        for i in 0..3 {
            to[k][i] = f(i, from[k][i]);
        }
    }
    to
}
