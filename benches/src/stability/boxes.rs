//! Triangles and boxes that approach each regime.

use septum_kit::{BoxNumbers, Case, Rng, Sample, Touch};

pub(super) type Point = [f64; 3];

pub(super) fn point(rng: &mut Rng, reach: f64) -> Point {
    rng.triple(|rng| rng.real(-reach, reach))
}

pub(super) fn plus(a: Point, b: Point) -> Point {
    [0, 1, 2].map(|i| a[i] + b[i])
}

pub(super) fn along(from: Point, to: Point, part: f64) -> Point {
    [0, 1, 2].map(|i| from[i] + part * (to[i] - from[i]))
}

/// A vector at right angles to the line through two points, of the length of their distance.
pub(super) fn across(rng: &mut Rng, a: Point, b: Point) -> Point {
    let (d, r) = ([0, 1, 2].map(|i| b[i] - a[i]), point(rng, 1.0));
    let n = [(1, 2), (2, 0), (0, 1)].map(|(j, k)| d[j] * r[k] - d[k] * r[j]);
    let length = |v: Point| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    n.map(|x| x * length(d) / length(n).max(1e-9))
}

/// By centre and half-extents: the form in which the published methods take a box.
fn case<S: Sample>(vertices: [Point; 3], center: Point, half: Point) -> Case<S> {
    let near = |p: Point| p.map(S::nearest);
    Case { vertices: vertices.map(near), aabb: BoxNumbers::Center(near(center), near(half)) }
}

/// Whether the range of the scalar includes this size.
pub(super) fn holds<S: Sample>(size: f64) -> bool {
    S::GREATEST.approximate() > size
}

/// A triangle as wide as `aspect` times its length; the box near the long edge.
pub(super) fn sliver<S: Sample>(rng: &mut Rng, aspect: f64) -> Option<Case<S>> {
    let (a, b) = (point(rng, 2.0), point(rng, 2.0));
    let side = across(rng, a, b).map(|x| x * aspect);
    let c = plus(along(a, b, rng.real(-0.5, 1.5)), side);
    let near = along(a, b, rng.real(-0.5, 1.5));
    let mut vertices = [a, b, c];
    vertices.rotate_left(rng.below(3));
    let center = plus(near, point(rng, 0.25));
    Some(case(vertices, center, rng.triple(|rng| rng.real(0.0, 0.25))))
}

/// A triangle of size `size` at the surface of a box of size 1.
pub(super) fn small<S: Sample>(rng: &mut Rng, size: f64) -> Option<Case<S>> {
    let (center, half) = (point(rng, 1.0), rng.triple(|rng| rng.real(0.25, 0.5)));
    // On the surface of the box as the scalar represents it.
    let held = |x: f64| S::nearest(x).approximate();
    let (center, half) = (center.map(held), half.map(held));
    let face = rng.below(3);
    let offset = [0, 1, 2].map(|i| match i == face {
        true if rng.one_in(2) => half[i],
        true => -half[i],
        false => rng.real(-half[i], half[i]),
    });
    let at = plus(center, offset);
    let vertices = [(); 3].map(|()| plus(at, point(rng, size)));
    Some(case(vertices, center, half))
}

/// A random triangle and box at `distance` from the origin.
pub(super) fn far<S: Sample>(rng: &mut Rng, distance: f64) -> Option<Case<S>> {
    let sign = |rng: &mut Rng| if rng.one_in(2) { -distance } else { distance };
    let origin = rng.triple(sign);
    let vertices = [(); 3].map(|()| plus(origin, point(rng, 2.0)));
    let (center, half) = (plus(origin, point(rng, 1.0)), rng.triple(|rng| rng.real(0.0, 1.0)));
    holds::<S>(distance + 4.0).then(|| case(vertices, center, half))
}

/// A random triangle and box at that scale.
pub(super) fn scaled<S: Sample>(rng: &mut Rng, scale: f64) -> Option<Case<S>> {
    let vertices = [(); 3].map(|()| point(rng, 2.0 * scale));
    let (center, half) = (point(rng, scale), rng.triple(|rng| rng.real(0.0, scale)));
    let some_bits = S::nearest(scale / 4.0) != S::ZERO;
    (holds::<S>(4.0 * scale) && some_bits).then(|| case(vertices, center, half))
}

/// A pair in exact contact; then the box is moved by `steps` units in the last place of the
/// greatest coordinates, into the triangle or away from it.
pub(super) fn touch<S: Sample>(rng: &mut Rng, steps: f64) -> Option<Case<S>> {
    let bits = S::WHOLE_BITS.min(40);
    let mut touch = match rng.below(3) {
        0 => Touch::vertex(rng, bits),
        1 => Touch::edge(rng, bits),
        _ => Touch::corner(rng, bits),
    };
    let axis = (0..3).find(|&i| touch.normal[i] != 0).expect("a normal");
    let moved = if rng.one_in(2) { steps as i64 } else { -(steps as i64) };
    touch.least[axis] += moved;
    touch.greatest[axis] += moved;
    Some(touch.case(true))
}

/// Integer coordinates of `bits` bits without the sign, in units of the last place.
pub(super) fn bits<S: Sample>(rng: &mut Rng, bits: f64) -> Option<Case<S>> {
    let most = most::<S>(bits)?;
    let mut number = |rng: &mut Rng| S::from_ordinal(rng.whole(-most, most));
    let mut point = |rng: &mut Rng| rng.triple(&mut number);
    let vertices = [point(rng), point(rng), point(rng)];
    let center = point(rng).map(|x| S::from_ordinal(x.ordinal() / 2));
    let half = rng.triple(|rng| S::from_ordinal(rng.whole(0, most / 2)));
    Some(Case { vertices, aabb: BoxNumbers::Center(center, half) })
}

/// The greatest integer of `bits` bits, if the type has it.
pub(super) fn most<S: Sample>(bits: f64) -> Option<i64> {
    let bits = bits as u32;
    (bits <= S::WHOLE_BITS).then(|| (u64::MAX >> (64 - bits)) as i64)
}
