//! Rays and triangles that approach each regime.

use septum_kit::rays::RayCase;
use septum_kit::{Rng, Sample};

use super::boxes::{Point, across, along, most, plus, point};

/// A point of the triangle's plane, in about half of the cases inside the triangle.
fn on_plane(rng: &mut Rng, [a, b, c]: [Point; 3]) -> Point {
    let (u, v) = (rng.real(-0.2, 1.0), rng.real(-0.2, 1.0));
    [0, 1, 2].map(|i| a[i] + u * (b[i] - a[i]) + v * (c[i] - a[i]))
}

/// A ray that reaches the target at t = 2, so that the direction is no longer than the distance of
/// the points.
fn aimed<S: Sample>(origin: Point, target: Point, vertices: [Point; 3]) -> Option<RayCase<S>> {
    let near = |p: Point| p.map(S::nearest);
    let direction = [0, 1, 2].map(|i| (target[i] - origin[i]) / 2.0);
    let case = RayCase::new(near(origin), near(direction), vertices.map(near));
    case.is_valid().then_some(case)
}

fn holds<S: Sample>(size: f64) -> bool {
    S::GREATEST.approximate() > size
}

/// A triangle as wide as `aspect` times its length.
pub(super) fn sliver<S: Sample>(rng: &mut Rng, aspect: f64) -> Option<RayCase<S>> {
    let (a, b) = (point(rng, 2.0), point(rng, 2.0));
    let side = across(rng, a, b).map(|x| x * aspect);
    let c = plus(along(a, b, rng.real(-0.5, 1.5)), side);
    let mut vertices = [a, b, c];
    vertices.rotate_left(rng.below(3));
    aimed(point(rng, 2.0), on_plane(rng, vertices), vertices)
}

/// A triangle of size `size`, at a distance of about 1.
pub(super) fn small<S: Sample>(rng: &mut Rng, size: f64) -> Option<RayCase<S>> {
    let at = point(rng, 1.0);
    let vertices = [(); 3].map(|()| plus(at, point(rng, size)));
    aimed(point(rng, 2.0), on_plane(rng, vertices), vertices)
}

/// A random ray and triangle at `distance` from the origin.
pub(super) fn far<S: Sample>(rng: &mut Rng, distance: f64) -> Option<RayCase<S>> {
    let sign = |rng: &mut Rng| if rng.one_in(2) { -distance } else { distance };
    let center = rng.triple(sign);
    let vertices = [(); 3].map(|()| plus(center, point(rng, 2.0)));
    let (origin, target) = (plus(center, point(rng, 2.0)), on_plane(rng, vertices));
    aimed(origin, target, vertices).filter(|_| holds::<S>(distance + 4.0))
}

/// A random ray and triangle at that scale.
pub(super) fn scaled<S: Sample>(rng: &mut Rng, scale: f64) -> Option<RayCase<S>> {
    let vertices = [(); 3].map(|()| point(rng, 2.0 * scale));
    let case = aimed(point(rng, 2.0 * scale), on_plane(rng, vertices), vertices);
    let some_bits = S::nearest(scale / 4.0) != S::ZERO;
    case.filter(|_| holds::<S>(4.0 * scale) && some_bits)
}

/// A ray at an angle to the plane of the triangle, given by its sine.
pub(super) fn parallel<S: Sample>(rng: &mut Rng, sine: f64) -> Option<RayCase<S>> {
    let vertices = [(); 3].map(|()| point(rng, 2.0).map(|x| S::nearest(x).approximate()));
    let [a, b, c] = vertices;
    let (e, f) = ([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
    let normal = [(1, 2), (2, 0), (0, 1)].map(|(j, k)| e[j] * f[k] - e[k] * f[j]);
    let length = |v: Point| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let (p, q) = (rng.real(-1.0, 1.0), rng.real(-1.0, 1.0));
    let within: Point = [0, 1, 2].map(|i| p * e[i] + q * f[i]);
    let (flat, up) = ((1.0 - sine * sine).sqrt() / length(within), sine / length(normal));
    let up = if rng.one_in(2) { up } else { -up };
    let direction: Point = [0, 1, 2].map(|i| flat * within[i] + up * normal[i]);
    let target = on_plane(rng, vertices);
    let back = rng.real(0.0, 2.0);
    let origin = [0, 1, 2].map(|i| S::nearest(target[i] - back * direction[i]));
    let case = RayCase::new(origin, direction.map(S::nearest), vertices.map(|v| v.map(S::nearest)));
    (length(normal) > 0.0 && case.is_valid()).then_some(case)
}

/// A ray toward a point of an edge; then a vertex of the edge is moved by `steps` units in the last
/// place.
pub(super) fn edge<S: Sample>(rng: &mut Rng, steps: f64) -> Option<RayCase<S>> {
    // Integers such that the midpoint of the edge and the ray's direction are integers too.
    let bits = S::WHOLE_BITS.min(40);
    let most = 1_i64 << (bits - 3);
    let whole = |rng: &mut Rng| rng.triple(|rng| rng.whole(-most, most));
    let (middle, half, third) = (whole(rng), whole(rng), whole(rng));
    let step = whole(rng).map(|x| x / 4);
    let at = |sign: i64| [0, 1, 2].map(|i| middle[i] + sign * half[i] / 2);
    let ends = [1, -1].map(at);
    let on_line = [0, 1, 2].map(|i| ends[1][i] + (ends[0][i] - ends[1][i]) / 2);
    let moved = if rng.one_in(2) { steps as i64 } else { -(steps as i64) };
    let axis = rng.below(3);
    let mut origin = [0, 1, 2].map(|i| on_line[i] - 2 * step[i]);
    origin[axis] += moved;
    let held = |v: [i64; 3]| v.map(S::whole);
    let case = RayCase::new(held(origin), held(step), [held(ends[0]), held(ends[1]), held(third)]);
    case.is_valid().then_some(case)
}

/// Integer coordinates of `bits` bits without the sign, in units of the last place.
pub(super) fn bits<S: Sample>(rng: &mut Rng, bits: f64) -> Option<RayCase<S>> {
    let most = most::<S>(bits)?;
    let point = |rng: &mut Rng| rng.triple(|rng| rng.whole(-most, most));
    let (vertices, origin) = ([point(rng), point(rng), point(rng)], point(rng));
    // Toward a weighted mean of the vertices with random weights, inside or outside.
    let (u, v) = (rng.real(-0.2, 0.8), rng.real(-0.2, 0.8));
    let mean = |i: usize| {
        let [a, b, c] = vertices.map(|p| p[i] as f64);
        (1.0 - u - v) * a + u * b + v * c
    };
    let step = |i: usize| ((mean(i) - origin[i] as f64) / 4.0) as i64;
    let direction = [0, 1, 2].map(|i| S::from_ordinal(step(i).clamp(-most, most)));
    let held = |v: [i64; 3]| v.map(S::from_ordinal);
    let case = RayCase::new(held(origin), direction, vertices.map(held));
    case.is_valid().then_some(case)
}
