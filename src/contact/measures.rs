//! A translation: its way, and its numbers, exact and rounded to the scalar.

use core::cmp::Ordering;

use super::answer::{Features, Translation};
use super::body::Vec64;
use super::directions::Direction;
use super::exact::{Size, farthest};
use crate::arithmetic::{Each, Soft, three};
use crate::scalar::Scalar;
use crate::shape::Vec3;

/// The numbers of a translation as the scalar has them.
#[derive(Debug, PartialEq)]
pub(super) struct Measures<S> {
    pub(super) vector: Vec3<S>,
    pub(super) depth: S,
    pub(super) normal: Vec3<S>,
    /// Whether the scalar holds the vector.
    pub(super) is_sufficient: bool,
}

impl<S: Scalar> Measures<S> {
    pub(super) fn translation(&self, features: Features) -> Translation<S> {
        let &Self { vector, depth, normal, is_sufficient } = self;
        Translation { vector, depth, normal, features, is_sufficient }
    }
}

/// A translation: its direction, and the signs along it.
#[derive(Clone, Copy)]
pub(super) struct Way {
    pub(super) direction: Direction,
    /// Whether the first shape goes along the direction, or against it.
    pub(super) is_along: bool,
    /// The signs of the sides of the shapes along the direction.
    pub(super) along: [[Ordering; 3]; 2],
    pub(super) is_held: bool,
}

impl Way {
    /// To be filled.
    pub(super) const NONE: Self = Self {
        direction: Direction::Sides(0, 0),
        is_along: false,
        along: [[Ordering::Equal; 3]; 2],
        is_held: false,
    };

    /// The side on which the opposite shape lies along the direction.
    pub(super) fn toward(&self, shape: usize) -> Ordering {
        if self.is_along == (shape == 0) { Ordering::Less } else { Ordering::Greater }
    }

    /// The vertices of a triangle that lie farthest toward the opposite shape.
    pub(super) fn farthest(&self, shape: usize) -> [bool; 3] {
        farthest(&self.along[shape % 2], self.toward(shape))
    }
}

/// A way, its numbers, and the unit vector along which the first shape moves. In this order no padding
/// before the vector is copied with it.
#[repr(C)]
pub(super) struct Directed<S> {
    pub(super) unit: Vec64,
    /// The exact depth, to a few roundings, where floats are functions; elsewhere infinity.
    pub(super) depth: f64,
    pub(super) measures: Measures<S>,
    pub(super) way: Way,
}

/// The lengths of a translation along a direction that is not zero.
pub(super) struct Lengths {
    /// The overlap, in units of the direction's length.
    pub(super) overlap: Soft,
    /// The length of the direction, and its square.
    pub(super) length: Soft,
    pub(super) square: Soft,
    /// The overlap as a length.
    pub(super) depth: Soft,
    /// The coordinates of the direction, as sign and size.
    pub(super) coordinates: [Option<(Ordering, Soft)>; 3],
}

impl Lengths {
    /// To be filled.
    pub(super) const NONE: Self = Self {
        overlap: Soft::ONE,
        length: Soft::ONE,
        square: Soft::ONE,
        depth: Soft::ONE,
        coordinates: [None; 3],
    };

    /// A vector from the sizes of its coordinates in real units, and whether the scalar can hold
    /// it.
    fn vector<S: Scalar>(
        &self,
        is_along: bool,
        units: i32,
        is_up: bool,
        sizes: [Size; 3],
    ) -> (Vec3<S>, bool) {
        let mut fits = true;
        let [x, y, z] = three(|i| match (self.coordinates[i], sizes[i]) {
            (Some((sign, _)), Some(size)) => {
                let (m, exponent) = size.scaled(units).upper();
                let is_negative = sign.is_gt() != is_along;
                let (x, is_held) = S::of_units(m, exponent, is_up, is_negative);
                fits &= is_held;
                x
            }
            _ => S::ZERO,
        });
        (Vec3::new(x, y, z), fits)
    }

    /// The numbers rounded to the scalar. Each coordinate of the vector is rounded away from zero,
    /// so that it is never too short.
    ///
    /// With a the direction and o the overlap along it, |tᵢ| ≥ |aᵢ|·o/(a·a), and tᵢ has the sign of
    /// aᵢ. Therefore a·t = Σ|aᵢ|·|tᵢ| ≥ o, and the shapes no longer overlap along this direction.
    pub(super) fn measures<S: Scalar>(&self, is_along: bool) -> Measures<S> {
        self.measures_of(is_along, self.ratios())
    }

    /// The depth, to a few roundings.
    pub(super) fn depth_in_double<S: Scalar>(&self) -> f64 {
        self.depth.scaled(-2 * i32::from(S::ONE.shift)).in_double()
    }

    /// The coordinates of the unit vector, in size.
    pub(super) fn ratios(&self) -> [Size; 3] {
        let length = self.length.divisor();
        self.coordinates.each(|x| x.map(|(_, size)| size.over_by(&length)))
    }

    pub(super) fn measures_of<S: Scalar>(&self, is_along: bool, ratios: [Size; 3]) -> Measures<S> {
        let one = i32::from(S::ONE.shift);
        let is_single = self.coordinates.iter().flatten().count() == 1;
        let square = self.square.divisor();
        let of = |size: Soft| {
            if is_single { self.depth } else { size.times(self.overlap).over_by(&square) }
        };
        let sizes = self.coordinates.each(|x| x.map(|(_, size)| of(size)));
        let (vector, is_sufficient) = self.vector(is_along, -one, true, sizes);
        let normal = self.vector(is_along, one, false, ratios).0;
        let (m, exponent) = self.depth.scaled(-one).upper();
        let depth = S::of_units(m, exponent, true, false).0;
        Measures { vector, depth, normal, is_sufficient }
    }

    /// The unit vector along which the first shape moves, in floats.
    pub(super) fn unit(&self, is_along: bool) -> Vec64 {
        unit_of(&self.coordinates, is_along, self.ratios())
    }
}

/// A unit vector: its signs come from `coordinates`, its sizes from `ratios`.
pub(super) fn unit_of(
    coordinates: &[Option<(Ordering, Soft)>; 3],
    is_along: bool,
    ratios: [Size; 3],
) -> Vec64 {
    three(|i| match (coordinates[i], ratios[i]) {
        (Some((sign, _)), Some(ratio)) => {
            let x = ratio.in_double();
            if sign.is_gt() == is_along { x } else { -x }
        }
        _ => 0.0,
    })
}
