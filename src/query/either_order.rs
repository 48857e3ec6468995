//! The pairs with their arguments exchanged: each forwards to the pair in its first order.

use super::relation::{Relate, Relation};
use crate::scalar::Scalar;
use crate::shape::{
    Aabb, Capsule, Near, Obb, Overlaps, Plane, Polygon, Ray, Segment, Sphere, Triangle,
};

macro_rules! reversed {
    ($($shape:ident with $other:ident $(<$life:lifetime>)?;)*) => {$(
        impl<S: Scalar> Overlaps<$other<$($life,)? S>> for $shape<S> {
            #[doc = concat!(
                "[`", stringify!($other), "::overlaps`] with the arguments in the other order.",
            )]
            #[inline]
            fn overlaps(&self, other: &$other<$($life,)? S>) -> bool {
                Overlaps::overlaps(other, self)
            }

            #[doc = concat!(
                "[`", stringify!($other), "::may_overlap`] with the arguments in the other order.",
            )]
            #[inline]
            fn may_overlap(&self, other: &$other<$($life,)? S>) -> bool {
                Overlaps::may_overlap(other, self)
            }
        }
    )*};
}
reversed! {
    Aabb with Triangle;
    Aabb with Plane;
    Aabb with Segment;
    Aabb with Ray;
    Aabb with Polygon<'_>;
    Obb with Triangle;
    Obb with Aabb;
    Obb with Segment;
    Obb with Ray;
    Triangle with Segment;
    Triangle with Sphere;
    Aabb with Sphere;
    Segment with Sphere;
    Plane with Sphere;
    Ray with Sphere;
    Obb with Sphere;
    Triangle with Capsule;
    Aabb with Capsule;
    Segment with Capsule;
    Plane with Capsule;
    Ray with Capsule;
    Obb with Capsule;
    Sphere with Capsule;
}

impl<S, T> Overlaps<Near<Triangle<S>>> for Near<T>
where
    Near<Triangle<S>>: Overlaps<Self>,
{
    #[inline]
    fn overlaps(&self, triangle: &Near<Triangle<S>>) -> bool {
        triangle.overlaps(self)
    }
    #[inline]
    fn may_overlap(&self, triangle: &Near<Triangle<S>>) -> bool {
        triangle.may_overlap(self)
    }
}

macro_rules! relations_reversed {
    ($($shape:ident with $other:ident;)*) => {$(
        impl<S: Scalar> Relate<$other<S>> for $shape<S> {
            #[inline]
            fn relation(&self, other: &$other<S>) -> Relation {
                other.relation(self)
            }
        }
    )*};
}
relations_reversed! {
    Aabb with Triangle;
    Obb with Triangle;
    Obb with Aabb;
    Triangle with Segment;
    Triangle with Sphere;
    Segment with Sphere;
    Aabb with Sphere;
    Plane with Sphere;
    Ray with Sphere;
    Obb with Sphere;
    Triangle with Capsule;
    Segment with Capsule;
    Aabb with Capsule;
    Plane with Capsule;
    Ray with Capsule;
    Obb with Capsule;
    Sphere with Capsule;
}
