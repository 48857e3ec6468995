use core::cmp::Ordering;

use crate::arithmetic::{Each, Parts, Rounded, compare, cross3, pick, three, turn};
use crate::robust::{along_axis, differences, side, singles};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Obb, Triangle, Vec3};

/// One of the 13 axes that can separate a triangle from an axis-aligned box. Two axis-aligned boxes
/// have the three [`Face`](Self::Face) axes, and an oriented box has three of its own.
///
/// For a triangle abc, edge 0 is b − a, edge 1 is c − b, edge 2 is a − c. In Akenine-Möller's
/// paper, bullet 1 is [`Face`](Self::Face), bullet 2 [`Normal`](Self::Normal), bullet 3
/// [`Edge`](Self::Edge).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Axis {
    /// A face normal of the box: coordinate axis 0, 1 or 2.
    Face(u8),
    /// The normal of the triangle.
    Normal,
    /// The cross product of coordinate axis `axis` and triangle edge `edge`.
    Edge {
        /// The coordinate axis, 0, 1 or 2.
        axis: u8,
        /// The edge of the triangle, 0, 1 or 2.
        edge: u8,
    },
}

impl Axis {
    /// The vector of the axis, for this triangle and any axis-aligned box: the unit vector of a
    /// [`Face`](Self::Face), (b − a) × (c − a) for the [`Normal`](Self::Normal), and the cross
    /// product of unit vector and edge for an [`Edge`](Self::Edge). It is not normalised.
    ///
    /// In place of the triangle an [`Aabb`] may be given, for the axes of two boxes, or an [`Obb`]. A
    /// box has no vectors but those of its faces; the remaining axes give zero. The vector of a face
    /// is the outward normal of the upper side. For an oriented box with the axes u, v, n it is v × n,
    /// n × u or u × v, turned around if the axes are left-handed: along the axis if they are at right
    /// angles.
    ///
    /// *Numerics*: rounded in the scalar's own arithmetic. Use it for display or for a push, but
    /// not for a decision: [`Triangle::is_separated_by`] decides exactly. A face is exact, with the
    /// greatest number in a type that does not hold one. An edge consists of differences, each
    /// rounded once; in fixed point they wrap if they overflow. A normal also has products, which in
    /// fixed point lose their last bits. So has a face of an oriented box, and its side is exact. The
    /// vector is zero if all of its bits are lost, and for the axes of a degenerate triangle. Indices
    /// count modulo 3.
    ///
    /// *Panics*: never. *Cost*: at most 6 multiplications, and for an oriented box an exact sum.
    ///
    /// ```
    /// use septum::{Aabb, Axis, Triangle, Vec3};
    ///
    /// let cell = Aabb::from_min_max([0.0; 3], [1.0; 3])?;
    /// let t = Triangle::new([2.5, 0.0, 0.5], [0.0, 2.5, 0.5], [3.0, 3.0, 0.5])?;
    /// let axis = t.separating_axis(&cell).unwrap();
    /// assert_eq!(axis.vector(&t), Vec3::new(-2.5, -2.5, 0.0));
    /// assert_eq!(Axis::Face(1).vector(&cell), Vec3::new(0.0, 1.0, 0.0));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[must_use]
    pub fn vector<S: Scalar>(self, shape: &impl HasAxes<S>) -> Vec3<S> {
        shape.axis(self)
    }

    /// All 13 axes, in the order in which [`Triangle::separating_axis`] tests them.
    pub const ALL: [Self; 13] = [
        Self::Face(0),
        Self::Face(1),
        Self::Face(2),
        Self::Normal,
        Self::Edge { axis: 0, edge: 0 },
        Self::Edge { axis: 0, edge: 1 },
        Self::Edge { axis: 0, edge: 2 },
        Self::Edge { axis: 1, edge: 0 },
        Self::Edge { axis: 1, edge: 1 },
        Self::Edge { axis: 1, edge: 2 },
        Self::Edge { axis: 2, edge: 0 },
        Self::Edge { axis: 2, edge: 1 },
        Self::Edge { axis: 2, edge: 2 },
    ];
}

/// A shape whose axes have vectors: a [`Triangle`], an [`Aabb`] beside a second box, or an [`Obb`].
///
/// The trait is sealed.
pub trait HasAxes<S: Scalar>: sealed::HasAxes<S> {}

impl<S: Scalar> HasAxes<S> for Triangle<S> {}
impl<S: Scalar> HasAxes<S> for Aabb<S> {}
impl<S: Scalar> HasAxes<S> for Obb<S> {}

pub(in crate::query) mod sealed {
    use super::{Axis, Ordering, Scalar, Vec3};

    pub trait HasAxes<S: Scalar> {
        /// The vector of the axis, rounded.
        fn axis(&self, axis: Axis) -> Vec3<S>;

        /// The sign of (to − from)·a, with a the exact vector of the axis.
        fn along(&self, axis: Axis, way: [Vec3<S>; 2]) -> Ordering;
    }
}

fn unit<S: Scalar>(i: u8) -> Vec3<S> {
    three(|k| if k == usize::from(i % 3) { S::plain_one() } else { S::ZERO }).into()
}

fn along_unit<S: Scalar>(i: u8, way: [Vec3<S>; 2]) -> Ordering {
    let [from, to] = way.map(|p| *pick(&p.to_array(), usize::from(i % 3)));
    compare(to, from)
}

impl<S: Scalar> sealed::HasAxes<S> for Aabb<S> {
    fn axis(&self, axis: Axis) -> Vec3<S> {
        match axis {
            Axis::Face(i) => unit(i),
            Axis::Normal | Axis::Edge { .. } => Vec3::splat(S::ZERO),
        }
    }

    fn along(&self, axis: Axis, way: [Vec3<S>; 2]) -> Ordering {
        match axis {
            Axis::Face(i) => along_unit(i, way),
            Axis::Normal | Axis::Edge { .. } => Ordering::Equal,
        }
    }
}

/// The rounded cross product of two vectors.
fn plain_cross<S: Scalar>(a: &[S; 3], b: &[S; 3]) -> Vec3<S> {
    cross3(&a.each(Rounded), &b.each(Rounded)).each(|x| x.0).into()
}

/// The vector in the opposite direction.
pub(in crate::query) fn negated<S: Scalar>(v: Vec3<S>) -> Vec3<S> {
    let [x, y, z] = v.to_array().each(|x| S::ZERO.plain_sub(x));
    Vec3::new(x, y, z)
}

impl<S: Scalar> sealed::HasAxes<S> for Obb<S> {
    fn axis(&self, axis: Axis) -> Vec3<S> {
        let Axis::Face(i) = axis else { return Vec3::splat(S::ZERO) };
        let (_, j, k) = turn(usize::from(i % 3));
        let u = self.axes_as_arrays();
        let normal = plain_cross(pick(&u, j), pick(&u, k));
        if self.hand() == Ordering::Less { negated(normal) } else { normal }
    }

    fn along(&self, axis: Axis, way: [Vec3<S>; 2]) -> Ordering {
        let Axis::Face(i) = axis else { return Ordering::Equal };
        let (_, j, k) = turn(usize::from(i % 3));
        let u = self.axes_as_arrays().each(singles);
        let [from, to] = way.each(Vec3::to_array);
        let d = differences(&to, &from);
        let side = side::<S::SeptumSum>([pick(&u, j), pick(&u, k), &d]);
        if self.hand() == Ordering::Less { side.reverse() } else { side }
    }
}

impl<S: Scalar> sealed::HasAxes<S> for Triangle<S> {
    fn axis(&self, axis: Axis) -> Vec3<S> {
        let [a, b, c] = self.vertices();
        let from =
            |p: &Vec3<S>, q: &Vec3<S>| [q.x.plain_sub(p.x), q.y.plain_sub(p.y), q.z.plain_sub(p.z)];
        let zero = S::ZERO;
        match axis {
            Axis::Face(i) => unit(i),
            Axis::Normal => plain_cross(&from(a, b), &from(a, c)),
            Axis::Edge { axis, edge } => {
                let [x, y, z] = match edge % 3 {
                    0 => from(a, b),
                    1 => from(b, c),
                    _ => from(c, a),
                };
                let minus = |x: S| zero.plain_sub(x);
                match axis % 3 {
                    0 => Vec3::new(zero, minus(z), y),
                    1 => Vec3::new(z, zero, minus(x)),
                    _ => Vec3::new(minus(y), x, zero),
                }
            }
        }
    }

    fn along(&self, axis: Axis, way: [Vec3<S>; 2]) -> Ordering {
        let points = self.points();
        let edge = |k: usize| {
            let (k, next, _) = turn(k % 3);
            differences(pick(&points, next), pick(&points, k))
        };
        let [a, b] = match axis {
            Axis::Face(i) => return along_unit(i, way),
            Axis::Normal => [edge(0), edge(1)],
            Axis::Edge { axis, edge: k } => {
                [along_axis(usize::from(axis % 3), Parts::UNIT), edge(k.into())]
            }
        };
        let [from, to] = way.each(Vec3::to_array);
        side::<S::SeptumSum>([&a, &b, &differences(&to, &from)])
    }
}
