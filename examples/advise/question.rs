//! The question about a triangle and a box, and its answer in any number type.

use septum::contact::least_translation;
use septum::sweep::{Motion, Sweep};
use septum::{Aabb, Capsule, Obb, Scalar, Sphere, Triangle, Vec3};

use crate::kind::Kind;
use crate::options::Ask;
use crate::scene::{Query, Scene};

/// The axes of rotated boxes: a rotation about two axes by the angles of the 3-4-5 triangle.
pub(crate) const TURNED: [[f64; 3]; 3] = [[0.6, 0.8, 0.0], [-0.48, 0.36, 0.8], [0.64, -0.48, 0.6]];

/// The question.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Question {
    /// Whether they overlap.
    Overlap,
    /// The same for the box rotated about its centre.
    Turned,
    /// The same for the triangle through three corners of the box.
    Triangle,
    /// Whether they overlap, with the triangle as a polygon.
    Polygon,
    /// Whether the rotated box overlaps the bounding box of the triangle.
    Boxes,
    /// When the box, moving by this vector, first meets the triangle.
    Sweep([f64; 3]),
    /// The minimum translation of the box out of the triangle.
    Contact,
    /// Whether the largest sphere in the box overlaps the triangle.
    Sphere,
    /// The same for a capsule, half as long as the box and a quarter as wide.
    Capsule,
    /// The point of the triangle closest to the middle of the box.
    Closest,
}

impl Question {
    pub(crate) fn new(ask: Ask, way: Option<[f64; 3]>) -> Result<Self, String> {
        match (ask, way) {
            (Ask::Sweep, Some(way)) => Ok(Self::Sweep(way)),
            (Ask::Sweep, None) => {
                Err("a sweep needs the way of the boxes: --way X,Y,Z (see --help)".into())
            }
            (_, Some(_)) => Err("--way is the way of a sweep: add --ask sweep".into()),
            (Ask::Overlap, None) => Ok(Self::Overlap),
            (Ask::Turned, None) => Ok(Self::Turned),
            (Ask::Triangle, None) => Ok(Self::Triangle),
            (Ask::Polygon, None) => Ok(Self::Polygon),
            (Ask::Boxes, None) => Ok(Self::Boxes),
            (Ask::Contact, None) => Ok(Self::Contact),
            (Ask::Sphere, None) => Ok(Self::Sphere),
            (Ask::Capsule, None) => Ok(Self::Capsule),
            (Ask::Closest, None) => Ok(Self::Closest),
        }
    }

    pub(crate) fn way(self) -> [f64; 3] {
        if let Self::Sweep(way) = self { way } else { [0.0; 3] }
    }

    /// Whether boxes are rotated.
    pub(crate) fn turns(self) -> bool {
        matches!(self, Self::Turned | Self::Boxes)
    }

    /// The places of its centres and its radius, in boxes, if the shape in question is round or a
    /// point.
    pub(crate) fn round(self) -> Option<(&'static [f64], f64)> {
        match self {
            Self::Sphere => Some((&[0.5], 0.5)),
            Self::Capsule => Some((&[0.25, 0.5, 0.75], 0.25)),
            Self::Closest => Some((&[0.5], 0.0)),
            _ => None,
        }
    }

    /// Whether the stages of fixed point differ from those for a triangle and a box at rest.
    pub(crate) fn is_staged_otherwise(self) -> bool {
        self.turns() || self.round().is_some() || matches!(self, Self::Triangle | Self::Polygon)
    }

    /// The overhang of a rotated box along an axis, beyond the unrotated box, in boxes.
    pub(crate) fn overhang(self, axis: usize) -> f64 {
        if !self.turns() {
            return 0.0;
        }
        (TURNED.iter().map(|u| u[axis].abs()).sum::<f64>() - 1.0) / 2.0
    }

    /// Numbers of the scene that are directions rather than positions.
    pub(crate) fn directions(self) -> &'static [f64] {
        if self.turns() { TURNED.as_flattened() } else { &[] }
    }

    /// How much nearer rounding may bring triangle and box, in tolerances: each moves by one, and a
    /// moving box by one more at either end of its path.
    pub(crate) fn slack(self) -> f64 {
        if let Self::Sweep(_) = self { 4.0 } else { 2.0 }
    }

    /// The number in the answer.
    pub(crate) fn number(self) -> Option<&'static str> {
        match self {
            Self::Sweep(_) => Some("time"),
            Self::Contact => Some("depth"),
            Self::Closest => Some("squared distance"),
            _ => None,
        }
    }

    /// The rows in the tables of costs: query, mode and path.
    pub(crate) fn in_tables(self) -> [&'static str; 3] {
        match self {
            Self::Overlap => ["triangle/box", "exact", "full"],
            Self::Turned => ["triangle/oriented box", "exact", "full"],
            Self::Triangle => ["triangle/triangle", "exact", "full"],
            Self::Polygon => ["polygon/box", "exact", "pentagons"],
            Self::Boxes => ["oriented box/oriented box", "exact", "full"],
            Self::Sweep(_) => ["triangle/box sweep", "when", "hit"],
            Self::Contact => ["triangle/box contact", "points too", "full"],
            Self::Sphere => ["sphere/triangle", "exact", "full"],
            Self::Capsule => ["capsule/triangle", "exact", "full"],
            Self::Closest => ["closest point/triangle", "exact", "full"],
        }
    }

    /// The query of these rows, in words.
    pub(crate) fn that_is_tabled(self) -> &'static str {
        match self {
            Self::Overlap | Self::Turned => "of a query on a {core} where all 13 axes are tried",
            Self::Triangle => "of a query on a {core} about triangles that cross",
            Self::Polygon => "of a query on a {core} about pentagons",
            Self::Boxes => "of a query on a {core} about two oriented boxes, all 15 axes tried",
            Self::Sweep(_) => "of the time of a box that meets the triangle, on a {core}",
            Self::Contact => "of a contact with its points, on a {core}, all axes tried",
            Self::Sphere => "of a query on a {core} about a sphere that meets the triangle",
            Self::Capsule => "of a query on a {core} about a capsule that meets the triangle",
            Self::Closest => "of a closest point, on a {core}",
        }
    }
}

impl Kind {
    /// Whether the answer is yes for the shapes of the query, as the type represents them.
    pub(crate) fn meets(self, scene: &Scene, query: Query) -> bool {
        match scene.question {
            Question::Overlap => self.overlaps(scene, query),
            Question::Sweep(_) | Question::Contact | Question::Closest => {
                self.number(scene, query).is_some()
            }
            Question::Sphere => {
                sphere(scene, query, |x| self.held(x)).overlaps(&self.triangle(scene, query))
            }
            Question::Capsule => {
                capsule(scene, query, |x| self.held(x)).overlaps(&self.triangle(scene, query))
            }
            Question::Turned => turned(scene, query, |x| self.held(x), |x| self.held(x))
                .overlaps(&self.triangle(scene, query)),
            Question::Triangle => {
                across(scene, query, |x| self.held(x)).overlaps(&self.triangle(scene, query))
            }
            // The polygon is the triangle itself.
            Question::Polygon => self.overlaps(scene, query),
            Question::Boxes => turned(scene, query, |x| self.held(x), |x| self.held(x))
                .overlaps(&around(&self.triangle(scene, query))),
        }
    }

    fn held(self, x: f64) -> f64 {
        self.nearest(x).expect("a type that holds the scene")
    }

    fn triangle(self, scene: &Scene, query: Query) -> Triangle<f64> {
        let [a, b, c, ..] = scene.points(query).map(|p| p.map(|x| self.held(x)));
        Triangle::new(a, b, c).expect("the scene is finite")
    }

    /// The time, the depth or the squared distance, if there is one, in the type.
    ///
    /// `f64` holds every scene that a type holds. The answer in `f64` is exact except for one
    /// rounding. Rounding it again, down or up, gives the answer of the type itself; to the nearest,
    /// it may give the number beside that.
    pub(crate) fn number(self, scene: &Scene, query: Query) -> Option<f64> {
        let nearest = |p: [f64; 3]| p.map(|x| self.held(x));
        let triangle = self.triangle(scene, query);
        let [.., min, max] = scene.points(query).map(nearest);
        let aabb = Aabb::from_min_max(min, max).expect("rounding keeps the order");
        match scene.question {
            Question::Sweep(_) => {
                let [from, to] = scene.places(query).map(nearest);
                let motion = Motion::new(from, to).expect("the scene is finite");
                let first = aabb.first_contact(&motion, &triangle)?;
                Some(self.rounded_down(first.t))
            }
            Question::Contact => Some(self.rounded_up(least_translation(&aabb, &triangle)?.depth)),
            Question::Closest => {
                let middle = middle(scene, query, |x| self.held(x));
                let squared = triangle.distance_squared(middle).expect("the scene is finite");
                Some(self.nearest(squared).unwrap_or(self.greatest()))
            }
            _ => None,
        }
    }

    /// The greatest number of the type that is not above `x`, which is not negative.
    pub(crate) fn rounded_down(self, x: f64) -> f64 {
        let down = match self {
            Self::Fixed { frac, .. } => {
                let unit = f64::from(frac).exp2();
                (x * unit).floor() / unit
            }
            Self::F32 if f64::from(x as f32) > x => {
                f64::from(f32::from_bits((x as f32).to_bits() - 1))
            }
            Self::F32 => f64::from(x as f32),
            Self::F64 => x,
        };
        down.min(self.greatest())
    }

    /// The least number of the type that is not below `x`, which is not negative.
    fn rounded_up(self, x: f64) -> f64 {
        let up = match self {
            Self::Fixed { frac, .. } => {
                let unit = f64::from(frac).exp2();
                (x * unit).ceil() / unit
            }
            Self::F32 if f64::from(x as f32) < x => {
                f64::from(f32::from_bits((x as f32).to_bits() + 1))
            }
            Self::F32 => f64::from(x as f32),
            Self::F64 => x,
        };
        up.min(self.greatest())
    }
}

/// The middle of the box of a query, in a scalar.
pub(crate) fn middle<S: Scalar>(scene: &Scene, query: Query, near: impl Fn(f64) -> S) -> [S; 3] {
    query.cell.map(|i| near(scene.face(i) + scene.cell / 2.0))
}

/// The largest sphere in the box of a query.
pub(crate) fn sphere<S: Scalar>(scene: &Scene, query: Query, near: impl Fn(f64) -> S) -> Sphere<S> {
    let radius = near(scene.cell / 2.0);
    Sphere::new(middle(scene, query, near), radius).expect("the scene is finite")
}

/// A capsule along x in the box of a query.
pub(crate) fn capsule<S: Scalar>(
    scene: &Scene,
    query: Query,
    near: impl Fn(f64) -> S,
) -> Capsule<S> {
    let [_, y, z] = middle(scene, query, &near);
    let end = |part: f64| [near(scene.face(query.cell[0]) + part * scene.cell), y, z];
    let radius = near(scene.cell / 4.0);
    Capsule::new(end(0.25), end(0.75), radius).expect("the scene is finite")
}

/// The box of a query, rotated about its centre, in a scalar.
pub(crate) fn turned<S: Scalar>(
    scene: &Scene,
    query: Query,
    near: impl Fn(f64) -> S,
    direction: impl Fn(f64) -> S,
) -> Obb<S> {
    let half = scene.cell / 2.0;
    let center = middle(scene, query, &near);
    let axes = TURNED.map(|u| Vec3::from(u.map(&direction)));
    // Rounding to a coarse type skews the axes.
    Obb::from_skewed_axes(center, axes, [near(half), near(half), near(half)])
        .expect("the scene is finite")
}

/// The triangle through three corners of the box of a query.
pub(crate) fn across<S: Scalar>(
    scene: &Scene,
    query: Query,
    near: impl Fn(f64) -> S,
) -> Triangle<S> {
    let [.., p, q] = scene.points(query).map(|p| p.map(&near));
    let corners = [[q[0], p[1], p[2]], [p[0], q[1], p[2]], [p[0], p[1], q[2]]];
    let [a, b, c] = corners.map(Vec3::from);
    Triangle::new(a, b, c).expect("the scene is finite")
}

/// The bounding box of a triangle.
pub(crate) fn around<S: Scalar>(triangle: &Triangle<S>) -> Aabb<S> {
    let [a, b, c] = triangle.vertices().map(|v| v.to_array());
    let bound = |takes: fn(&S, &S) -> bool| {
        [0, 1, 2].map(|i: usize| {
            [b[i], c[i]].into_iter().fold(a[i], |x, y| if takes(&y, &x) { y } else { x })
        })
    };
    Aabb::from_min_max(bound(S::lt), bound(S::gt)).expect("its corners are in order")
}

/// The differences between the numbers in a type's answers and in `f64`'s answers on the unrounded
/// scene, for queries with both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Off {
    /// Ninety-nine of a hundred differences are within this.
    pub(crate) usual: f64,
    pub(crate) most: f64,
}

impl Off {
    pub(crate) fn of(kind: Kind, scene: &Scene, queries: &[Query]) -> Option<Self> {
        let difference = |&query: &Query| {
            let (truth, said) = (Kind::F64.number(scene, query)?, kind.number(scene, query)?);
            Some((said - truth).abs())
        };
        let mut all: Vec<f64> = queries.iter().filter_map(difference).collect();
        all.sort_by(f64::total_cmp);
        let most = *all.last()?;
        Some(Self { usual: all[(all.len() * 99).div_ceil(100) - 1], most })
    }
}
