//! `defmt`: shapes, answers and errors as log records, with numbers rather than text.
//!
//! A fixed-point number is sent as a float, and the host formats it; the device formats no digits.
//! Types of up to 32 bits are sent exactly, types of 64 bits as the nearest `f64`.

use defmt::{Format, Formatter, write};

use crate::contact::{Contact, Point, Translation};
use crate::lanes::{
    Aabbs, CellTriangle, Cells, Hits, NormalTriangles, Ranges, Rays, SlabRays, Triangles,
};
use crate::prepared::{HitRay, HitTriangle, PreparedRay, PreparedTriangle};
use crate::published::projected::ProjectedTriangle;
use crate::published::slabs::SlabRay;
use crate::published::slopes::SlopeRay;
use crate::published::stored_normal::NormalTriangle;
use crate::published::watertight::ShearedRay;
use crate::query::{Crossing, FirstContact, Hit, Motion, SphereContact};
use crate::scalar::Scalar;
use crate::shape::{
    Aabb, AabbForm, Capsule, Obb, Plane, Polygon, Ray, Segment, SegmentForm, Sphere, Triangle, Vec3,
};

/// One number.
struct Number<S>(S);

impl<S: Scalar> Format for Number<S> {
    fn format(&self, to: Formatter<'_>) {
        self.0.log(to);
    }
}

/// A number, or the absence of one.
fn optional<S: Scalar>(x: Option<S>) -> Option<Number<S>> {
    x.map(Number)
}

/// `impl Format` for shapes and answers, from their public parts.
macro_rules! formats {
    ($($type:ident $([$lanes:ident])?: |$this:ident, $to:ident| $body:expr;)*) => {$(
        impl<S: Scalar $(, const $lanes: usize)?> Format for $type<S $(, $lanes)?> {
            fn format(&self, $to: Formatter<'_>) {
                let $this = self;
                $body
            }
        }
    )*};
}
formats! {
    Vec3: |v, to| write!(to, "({}, {}, {})", Number(v.x), Number(v.y), Number(v.z));
    Triangle: |t, to| {
        let [a, b, c] = t.vertices();
        write!(to, "Triangle[{}, {}, {}]", a, b, c)
    };
    Aabb: |aabb, to| match aabb.form() {
        AabbForm::Center { center, half } => {
            write!(to, "Aabb {{ center: {}, half_extents: {} }}", center, half)
        }
        AabbForm::Corners { min, max } => write!(to, "Aabb {{ min: {}, max: {} }}", min, max),
    };
    Obb: |obb, to| {
        let [u, v, w] = obb.axes();
        write!(
            to,
            "Obb {{ center: {}, axes: [{}, {}, {}], half_extents: {} }}",
            obb.center(), u, v, w, obb.half_extents()
        )
    };
    Plane: |plane, to| match plane.point() {
        Some(point) => write!(to, "Plane {{ point: {}, normal: {} }}", point, plane.normal()),
        None => {
            write!(to, "Plane {{ normal: {}, d: {} }}", plane.normal(), Number(plane.numbers().1))
        }
    };
    Segment: |segment, to| match segment.form() {
        SegmentForm::Ends(a, b) => write!(to, "Segment[{}, {}]", a, b),
        SegmentForm::Center { center, half } => {
            write!(to, "Segment {{ center: {}, half_vector: {} }}", center, half)
        }
    };
    Sphere: |sphere, to| write!(
        to,
        "Sphere {{ center: {}, radius: {} }}",
        sphere.center(), Number(sphere.radius())
    );
    Capsule: |capsule, to| write!(
        to,
        "Capsule {{ a: {}, b: {}, radius: {} }}",
        capsule.ends().0, capsule.ends().1, Number(capsule.radius())
    );
    Ray: |ray, to| write!(
        to,
        "Ray {{ origin: {}, direction: {}, t_min: {}, t_max: {} }}",
        ray.origin(), ray.direction(), optional(ray.t_min()), optional(ray.t_max())
    );
    Hit: |hit, to| write!(
        to,
        "Hit {{ t: {}, u: {}, v: {}, facing: {}, feature: {} }}",
        Number(hit.t), Number(hit.u), Number(hit.v), hit.facing, hit.feature
    );
    Translation: |out, to| write!(
        to,
        "Translation {{ vector: {}, depth: {}, normal: {}, features: {}, is_sufficient: {} }}",
        out.vector, Number(out.depth), out.normal, out.features, out.is_sufficient
    );
    Point: |point, to| write!(
        to,
        "Point {{ on_first: {}, on_second: {}, depth: {}, parts: {} }}",
        point.on_first, point.on_second, Number(point.depth), point.parts
    );
    Contact: |found, to| write!(
        to,
        "Contact {{ {}, is_held: {}, points: {=[?]} }}",
        found.translation, found.is_held, found.points()
    );
    Motion: |motion, to| write!(to, "Motion {{ from: {}, to: {} }}", motion.from(), motion.to());
    FirstContact: |first, to| {
        write!(to, "FirstContact {{ t: {}, axis: {} }}", Number(first.t), first.axis)
    };
    Crossing: |crossing, to| {
        write!(to, "Crossing {{ t: {}, face: {} }}", Number(crossing.t), crossing.face)
    };
    // Prepared shapes log the shape that they were made from.
    NormalTriangle: |t, to| write!(to, "NormalTriangle {{ normal: {}, .. }}", t.normal());
    ProjectedTriangle: |_t, to| write!(to, "ProjectedTriangle {{ .. }}");
    ShearedRay: |sheared, to| write!(to, "ShearedRay {{ ray: {}, .. }}", sheared.ray);
    HitRay: |prepared, to| write!(to, "HitRay {{ {} }}", prepared.ray());
    HitTriangle: |prepared, to| write!(to, "HitTriangle {{ {} }}", prepared.triangle());
    PreparedRay: |prepared, to| write!(to, "PreparedRay {{ {} }}", prepared.ray());
    PreparedTriangle: |prepared, to| {
        write!(to, "PreparedTriangle {{ {} }}", prepared.triangle())
    };
    CellTriangle: |prepared, to| write!(to, "CellTriangle {{ {} }}", prepared.triangle());
    SlabRay: |_r, to| write!(to, "SlabRay {{ .. }}");
    SlopeRay: |_r, to| write!(to, "SlopeRay {{ .. }}");
    Triangles[N]: |all, to| { write!(to, "Triangles"); lanes(to, N, |k| all.get(k)) };
    NormalTriangles[N]: |all, to| { write!(to, "NormalTriangles"); lanes(to, N, |k| all.get(k)) };
    Rays[N]: |all, to| { write!(to, "Rays"); lanes(to, N, |k| all.get(k)) };
    SlabRays[N]: |all, to| { write!(to, "SlabRays"); lanes(to, N, |k| all.get(k)) };
    Aabbs[N]: |all, to| { write!(to, "Aabbs"); lanes(to, N, |k| all.get(k)) };
    Cells[N]: |all, to| { write!(to, "Cells"); lanes(to, N, |k| all.get(k)) };
    Hits[N]: |all, to| { write!(to, "Hits"); lanes(to, N, |k| all.get(k)) };
    Ranges[N]: |all, to| {
        write!(to, "Ranges");
        let numbers = |(enter, leave)| (Number(enter), Number(leave));
        lanes(to, N, |k| all.get(k).map(numbers))
    };
}

/// Each lane in brackets.
fn lanes<T: Format>(to: Formatter<'_>, count: usize, lane: impl Fn(usize) -> T) {
    (0..count).for_each(|k| write!(to, "[{}]", lane(k)));
}

impl<S: Scalar> Format for Polygon<'_, S> {
    fn format(&self, to: Formatter<'_>) {
        write!(to, "Polygon{=[?]}", self.vertices());
    }
}

impl<S: Scalar, P: Format> Format for SphereContact<S, P> {
    fn format(&self, to: Formatter<'_>) {
        write!(to, "SphereContact {{ t: {}, part: {} }}", Number(self.t), self.part);
    }
}

#[cfg(feature = "heapless")]
impl<T: Format, const N: usize> Format for super::Bounded<T, N> {
    fn format(&self, to: Formatter<'_>) {
        write!(to, "{=[?]} and {=usize} more", self.kept(), self.missed());
    }
}
