//! Overlapping shapes: two oracles in integers. Linear programming decides whether shapes overlap,
//! and whether a translation separates them; the minimum over all axes gives the depth.

mod hull;
mod plane;
mod points;
mod sets;
mod simplex;

pub use points::PointErrors;
pub use sets::ContactSet;
pub use simplex::holds_zero;

use dashu_int::IBig;
use septum::contact::{
    Contact, Features, InteriorEdges, Translation, contact, contact_in_mesh, least_translation,
};
use septum::{Aabb, Obb, Triangle};

use crate::case::BoxNumbers;
use crate::exact::{Parts, least_exponent, whole};
use crate::lattice::Ring;
use crate::sample::Sample;
use crate::{Each, boxes::AnyBox};
use hull::{Depth, Hull, Point, depths, is_flat, scaled, share_an_interior_point, sum};

/// A shape that has contacts, as plain numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Solid<S> {
    Triangle([[S; 3]; 3]),
    Box(AnyBox<S>),
}

/// The shapes made from these numbers.
enum Made<S> {
    Triangle(Triangle<S>),
    Aabb(Aabb<S>),
    Obb(Obb<S>),
}

/// Two shapes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactCase<S> {
    pub first: Solid<S>,
    pub second: Solid<S>,
}

impl<S: Sample> Solid<S> {
    fn numbers(&self) -> Vec<Parts> {
        let rows: Vec<[S; 3]> = match *self {
            Self::Triangle(t) => t.to_vec(),
            Self::Box(AnyBox::Aabb(BoxNumbers::Center(p, q) | BoxNumbers::Corners(p, q))) => {
                vec![p, q]
            }
            Self::Box(AnyBox::Obb(b)) => [b.axes.as_slice(), &[b.center, b.half]].concat(),
        };
        rows.as_flattened().iter().map(|x| x.mantissa_exponent()).collect()
    }

    fn made(&self) -> Option<Made<S>> {
        Some(match *self {
            Self::Triangle([a, b, c]) => Made::Triangle(Triangle::new(a, b, c).ok()?),
            Self::Box(AnyBox::Aabb(aabb)) => Made::Aabb(aabb.shape().ok()?),
            Self::Box(AnyBox::Obb(obb)) => Made::Obb(obb.shape().ok()?),
        })
    }

    /// In units of 2^(2·unit − 1).
    fn hull(&self, unit: i32) -> Hull {
        let one = IBig::ONE << (-unit) as usize;
        let vector = |p: &[S; 3]| p.each(|x| whole(x.mantissa_exponent(), unit));
        let two = &one * IBig::from(2);
        let zero = IBig::ZERO;
        let (center, sides, half) = match self {
            Self::Triangle(t) => {
                let points: Vec<Point> = t.iter().map(|p| scaled(&vector(p), &two)).collect();
                let side = |k: usize| IBig::difference(&points[(k + 1) % 3], &points[k]);
                let sides = [side(0), side(1), side(2)];
                let extends = sides.each_ref().each(|s| s.iter().any(|x| *x != zero));
                return Hull { points, sides, is_triangle: true, extends };
            }
            Self::Box(AnyBox::Obb(b)) => (
                scaled(&vector(&b.center), &two),
                b.axes.each_ref().each(vector),
                scaled(&vector(&b.half), &2.into()),
            ),
            Self::Box(AnyBox::Aabb(aabb)) => {
                let z = || zero.clone();
                let along =
                    [[one.clone(), z(), z()], [z(), one.clone(), z()], [z(), z(), one.clone()]];
                match aabb {
                    BoxNumbers::Center(c, h) => {
                        (scaled(&vector(c), &two), along, scaled(&vector(h), &2.into()))
                    }
                    BoxNumbers::Corners(p, q) => {
                        let (p, q) = (vector(p), vector(q));
                        (scaled(&sum(&p, &q), &one), along, IBig::difference(&q, &p))
                    }
                }
            }
        };
        let corner = |k: usize| {
            (0..3).fold(center.clone(), |at, i| {
                let step = scaled(&sides[i], &half[i]);
                if k >> i & 1 == 1 { sum(&at, &step) } else { IBig::difference(&at, &step) }
            })
        };
        let points = (0..8).map(corner).collect();
        Hull { points, sides, is_triangle: false, extends: half.each(|h| h != zero) }
    }
}

impl<S: Sample> ContactCase<S> {
    /// The crate's answer.
    pub fn contact(&self) -> Option<Option<Contact<S>>> {
        let both = (self.first.made()?, self.second.made()?);
        macro_rules! each {
            ($($a:ident $b:ident),*) => {
                match &both {$(
                    (Made::$a(a), Made::$b(b)) => {
                        let found = contact(a, b);
                        let alone = least_translation(a, b);
                        assert_eq!(alone, found.as_ref().map(|c| c.translation), "{self:?}");
                        found
                    }
                )*}
            };
        }
        Some(each!(
            Triangle Triangle, Triangle Aabb, Triangle Obb, Aabb Triangle, Aabb Aabb, Aabb Obb,
            Obb Triangle, Obb Aabb, Obb Obb
        ))
    }

    /// The crate's answer for the first shape as a triangle of a mesh.
    pub fn contact_in_mesh(&self, interior: InteriorEdges) -> Option<Option<Contact<S>>> {
        let Made::Triangle(t) = self.first.made()? else { return None };
        Some(match self.second.made()? {
            Made::Triangle(other) => contact_in_mesh(&t, interior, &other),
            Made::Aabb(other) => contact_in_mesh(&t, interior, &other),
            Made::Obb(other) => contact_in_mesh(&t, interior, &other),
        })
    }

    /// The minimum depth over all axes; `None` if there is no contact.
    pub fn least_depth(&self) -> Option<f64> {
        let unit = least_exponent(&[self.first.numbers(), self.second.numbers()].concat()).min(0);
        let all = depths(&[self.first.hull(unit), self.second.hull(unit)])?;
        let depth = |d: &Depth| d.overlap.to_f64().value() / d.square.to_f64().value().sqrt();
        let least = all.iter().map(depth).min_by(f64::total_cmp)?;
        Some(least * 2_f64.powi(2 * unit - 1))
    }

    /// Checks the crate's answer, and returns whether it was a contact with numbers in range.
    ///
    /// # Panics
    /// If something is wrong.
    pub fn check(&self, with_programming: bool) -> Option<bool> {
        let found = self.contact()?;
        let mut numbers = [self.first.numbers(), self.second.numbers()].concat();
        if let Some(Contact { translation: t, .. }) = &found {
            let all = [t.vector.to_array().as_slice(), &[t.depth]].concat();
            let nonzero = all.iter().filter(|x| x.is_finite() && **x != S::ZERO);
            for &x in nonzero {
                numbers.extend([x, inward(x)].each(S::mantissa_exponent));
            }
        }
        let unit = least_exponent(&numbers).min(0);
        let hulls = [self.first.hull(unit), self.second.hull(unit)];
        let depths = depths(&hulls);
        let least = depths.as_ref().and_then(|all| {
            all.iter().min_by(|a, b| {
                let square = |x: &Depth, other: &Depth| &x.overlap * &x.overlap * &other.square;
                square(a, b).cmp(&square(b, a))
            })
        });
        assert_eq!(found.is_some(), least.is_some(), "{self:?}");
        if with_programming && !is_flat(&hulls) {
            let truth = share_an_interior_point(&hulls[0].points, &hulls[1].points);
            assert_eq!(found.is_some(), truth, "by programming: {self:?}");
        }
        let (Some(found), Some(least)) = (found, least) else { return Some(false) };
        assert!(!found.is_held && !found.points().is_empty(), "{self:?}");
        // In units of positions.
        let length = |x: S| whole(x.mantissa_exponent(), unit) << (1 - unit) as usize;
        let t = found.translation;
        self.check_depth(t.depth, least, &length);
        let sign = |x: S| IBig::from(if x < S::ZERO { -1 } else { i8::from(x > S::ZERO) });
        let a = self.direction(t.features, &hulls);
        let along = IBig::dot(&a, &t.vector.to_array().each(sign));
        let a = if along < IBig::ZERO { a.each(|x| -x) } else { a };
        let depths = depths.as_deref().unwrap_or_default();
        let is_before = depths.iter().take_while(|d| !core::ptr::eq(*d, least));
        let is_same = |d: &Depth| {
            IBig::cross(&d.axis, &a) == [IBig::ZERO, IBig::ZERO, IBig::ZERO]
                && IBig::dot(&d.axis, &a) > IBig::ZERO
        };
        let is_first = is_same(least) || is_before.into_iter().any(is_same);
        // A third candidate, too near for a comparison, may come between two that are equal.
        let is_near = |d: &Depth| {
            let square = |x: &Depth, other: &Depth| &x.overlap * &x.overlap * &other.square;
            let (a, b) = (square(d, least), square(least, d));
            a != b && (a - &b) << 54 <= b
        };
        let is_tie = depths.iter().any(is_near)
            && depths.iter().filter(|d| is_same(d)).all(|d| {
                is_near(d)
                    || &d.overlap * &d.overlap * &least.square
                        == &least.overlap * &least.overlap * &d.square
            });
        assert!(is_first || is_tie, "not the first of equals: {self:?} {t:?}");
        self.check_vector(&t, &a, &hulls, &length);
        self.check_normal(&t.normal.to_array(), &a);
        if with_programming && t.is_sufficient {
            let vector = t.vector.to_array().each(length);
            let still = share_an_interior_point(&hulls[0].moved(&vector), &hulls[1].points);
            assert!(!still, "not parted: {self:?} {t:?}");
        }
        if let Some(points) = self.check_points(&found) {
            assert!(points.is_ok(), "{points:?} {self:?} {found:?}");
        }
        Some(t.is_sufficient)
    }

    /// The cross product that the features name.
    fn direction(&self, features: Features, hulls: &[Hull; 2]) -> Point {
        match features {
            Features::First(k) => hulls[0].normals()[usize::from(k / 2)].clone(),
            Features::Second(k) => hulls[1].normals()[usize::from(k / 2)].clone(),
            Features::Edges(i, j) => IBig::cross(hulls[0].side(i), hulls[1].side(j)),
            Features::Nearest(..) => unreachable!("shapes with flat faces"),
        }
    }

    /// The depth is not below the minimum, and the number before it is less than 2^-55 of the
    /// minimum above it. Beyond the range it is clamped.
    fn check_depth(&self, depth: S, least: &Depth, length: &dyn Fn(S) -> IBig) {
        let square = |x: IBig| &x * &x * &least.square;
        let of_overlap = &least.overlap * &least.overlap;
        if square(length(S::GREATEST)) < of_overlap {
            assert!(depth >= S::GREATEST, "depth {depth:?} within range: {self:?}");
            return;
        }
        let near = (IBig::ONE << 55) + IBig::ONE;
        if depth.is_finite() {
            assert!(square(length(depth)) >= of_overlap, "depth {depth:?} too small: {self:?}");
        }
        let before = if depth.is_finite() { inward(depth) } else { S::GREATEST };
        let before = length(before) << 55;
        assert!(square(before) < of_overlap * &near * &near, "depth {depth:?} too great: {self:?}");
    }

    /// Each coordinate is |aᵢ|·o/(a·a) for the direction `a`, rounded away from zero like the depth,
    /// and the vector separates the shapes along `a`, unless a coordinate is beyond the range.
    fn check_vector(
        &self,
        t: &Translation<S>,
        a: &Point,
        hulls: &[Hull; 2],
        length: &dyn Fn(S) -> IBig,
    ) {
        let ([_, top], [bottom, _]) = (hulls[1].ends(a), hulls[0].ends(a));
        let overlap = top - bottom;
        let square = IBig::dot(a, a);
        let near = (IBig::ONE << 55) + IBig::ONE;
        let (mut is_held, mut may_be_held) = (true, true);
        for (i, x) in t.vector.to_array().into_iter().enumerate() {
            let sign = IBig::from(Ring::sign(&a[i]));
            let size = &a[i] * &sign * &overlap;
            if x == S::ZERO {
                assert!(sign == IBig::ZERO, "coordinate {i} is zero: {self:?}");
                continue;
            }
            let end = if sign > IBig::ZERO { S::GREATEST } else { S::LEAST };
            let most = length(end) * &sign * &square;
            is_held &= &most << 55 >= &size * &near;
            may_be_held &= most >= size;
            if most < size {
                assert!(x == end || !x.is_finite(), "coordinate {i} within range: {self:?}");
                continue;
            }
            if x.is_finite() {
                let long = length(x) * &sign * &square;
                assert!(long >= size || x == end, "coordinate {i} too short: {self:?}");
            }
            let before = length(if x.is_finite() { inward(x) } else { end }) * &sign;
            assert!(before * (&square << 55) < size * &near, "coordinate {i} too long: {self:?}");
        }
        let is_told = if t.is_sufficient { may_be_held } else { !is_held };
        assert!(is_told, "sufficient or not: {self:?} {t:?}");
        if t.is_sufficient {
            let along = IBig::dot(a, &t.vector.to_array().each(length));
            assert!(along >= overlap, "not parted on its axis: {self:?}");
        }
    }

    /// Each coordinate is that of the unit vector along `a`, off by 2^-55 of itself and half a unit in
    /// the last place at most.
    fn check_normal(&self, normal: &[S; 3], a: &Point) {
        let square: IBig = IBig::dot(a, a) << 110;
        for (i, &x) in normal.iter().enumerate() {
            let (m, e) = x.mantissa_exponent();
            let sign = IBig::from(Ring::sign(&a[i]));
            let m = IBig::from(m) * &sign * IBig::from(2);
            let doubled = |x: IBig| if x > IBig::ZERO { &x * &x * &square } else { IBig::ZERO };
            let (below, above) = (doubled(&m - IBig::ONE), doubled(&m + IBig::ONE));
            let scaled = |by: i8| {
                let near = (IBig::ONE << 55) + IBig::from(by);
                (&a[i] * &a[i] * &near * &near) << (2 - 2 * e) as usize
            };
            let is_end = x >= S::GREATEST || x <= S::LEAST;
            assert!(below <= scaled(1), "normal {i} too long: {self:?}");
            assert!(above >= scaled(-1) || is_end, "normal {i} too short: {self:?}");
        }
    }
}

/// The next number toward zero.
fn inward<S: Sample>(x: S) -> S {
    x.moved(if x > S::ZERO { -1 } else { 1 })
}
