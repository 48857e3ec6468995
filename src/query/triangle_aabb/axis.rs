use crate::scalar::Scalar;
use crate::shape::{Triangle, Vec3};

/// One of the 13 axes that can separate a triangle from an axis-aligned box.
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
    /// *Numerics*: rounded in the scalar's own arithmetic. Use it for display or for a push, but
    /// not for a decision: [`Triangle::is_separated_by`] decides exactly. A face is exact. An edge
    /// consists of differences, each rounded once; in fixed point they wrap if they overflow. A
    /// normal also has products, which in fixed point lose their last bits. The vector is zero if
    /// all of its bits are lost, and for the axes of a degenerate triangle. Indices count modulo 3.
    ///
    /// *Panics*: never. *Cost*: at most 6 multiplications.
    ///
    /// ```
    /// use septum::{Aabb, Axis, Triangle, Vec3};
    ///
    /// let cell = Aabb::from_min_max([0.0; 3], [1.0; 3])?;
    /// let t = Triangle::new([2.5, 0.0, 0.5], [0.0, 2.5, 0.5], [3.0, 3.0, 0.5])?;
    /// let axis = t.separating_axis(&cell).unwrap();
    /// assert_eq!(axis.vector(&t), Vec3::new(-2.5, -2.5, 0.0));
    /// # Ok::<(), septum::ShapeError>(())
    /// ```
    #[must_use]
    pub fn vector<S: Scalar>(self, triangle: &Triangle<S>) -> Vec3<S> {
        let [a, b, c] = triangle.vertices();
        let from =
            |p: &Vec3<S>, q: &Vec3<S>| [q.x.plain_sub(p.x), q.y.plain_sub(p.y), q.z.plain_sub(p.z)];
        let zero = S::ZERO;
        match self {
            Self::Face(i) => {
                let one = S::plain_one();
                match i % 3 {
                    0 => Vec3::new(one, zero, zero),
                    1 => Vec3::new(zero, one, zero),
                    _ => Vec3::new(zero, zero, one),
                }
            }
            Self::Normal => {
                let ([x, y, z], [u, v, w]) = (from(a, b), from(a, c));
                let minor = |p: S, q: S, r: S, s: S| p.plain_mul(q).plain_sub(r.plain_mul(s));
                Vec3::new(minor(y, w, z, v), minor(z, u, x, w), minor(x, v, y, u))
            }
            Self::Edge { axis, edge } => {
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
