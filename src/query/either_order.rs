//! The pairs with their arguments exchanged: each forwards to the pair in its first order.

use super::relation::{Relate, Relation};
use crate::scalar::Scalar;
use crate::shape::{
    Aabb, Capsule, Near, Obb, Overlaps, Plane, Polygon, Ray, Segment, Sphere, Triangle,
};

macro_rules! reversed {
    ($($shape:ident with $other:ident $(<$life:lifetime>)? $(: $relate:ident)?;)*) => {$(
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

        $(impl<S: Scalar> $relate<$other<S>> for $shape<S> {
            #[inline]
            fn relation(&self, other: &$other<S>) -> Relation {
                other.relation(self)
            }
        })?
    )*};
    (near: $($other:ident)*) => {$(
        impl<S, T> Overlaps<Near<$other<S>>> for Near<T>
        where
            Near<$other<S>>: Overlaps<Self>,
        {
            #[inline]
            fn overlaps(&self, other: &Near<$other<S>>) -> bool {
                other.overlaps(self)
            }
            #[inline]
            fn may_overlap(&self, other: &Near<$other<S>>) -> bool {
                other.may_overlap(self)
            }
        }
    )*};
}
reversed! {
    Aabb with Triangle: Relate;
    Aabb with Plane;
    Aabb with Segment;
    Aabb with Ray;
    Aabb with Polygon<'_>;
    Obb with Triangle: Relate;
    Obb with Aabb: Relate;
    Obb with Segment;
    Obb with Ray;
    Triangle with Segment: Relate;
    Triangle with Sphere: Relate;
    Aabb with Sphere: Relate;
    Segment with Sphere: Relate;
    Plane with Sphere: Relate;
    Ray with Sphere: Relate;
    Obb with Sphere: Relate;
    Triangle with Capsule: Relate;
    Aabb with Capsule: Relate;
    Segment with Capsule: Relate;
    Plane with Capsule: Relate;
    Ray with Capsule: Relate;
    Obb with Capsule: Relate;
    Sphere with Capsule: Relate;
}

reversed! { near: Triangle Ray Segment }

impl<S, T> Relate<Near<Triangle<S>>> for Near<T>
where
    Near<Triangle<S>>: Relate<Self>,
{
    #[inline]
    fn relation(&self, triangle: &Near<Triangle<S>>) -> Relation {
        triangle.relation(self)
    }
}
