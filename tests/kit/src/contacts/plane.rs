//! Convex polygons in a plane, in floats: what two have in common by their edges' lines, and how far
//! a point is off a hull.

type Point = [f64; 2];

fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn across(a: Point, b: Point) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// Twice the area, with the sign of the order.
fn area(polygon: &[Point]) -> f64 {
    (1..polygon.len().max(1) - usize::from(polygon.len() > 1))
        .map(|k| across(minus(polygon[k], polygon[0]), minus(polygon[k + 1], polygon[0])))
        .sum()
}

/// The part of the way from a to b that lies on the inner side of all edges, drawn in.
fn clipped([a, b]: [Point; 2], polygon: &[Point], by: f64) -> Option<[Point; 2]> {
    let sign = area(polygon).signum();
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for k in 0..polygon.len() {
        let (p, q) = (polygon[k], polygon[(k + 1) % polygon.len()]);
        let e = minus(q, p);
        let length = dot(e, e).sqrt();
        if length == 0.0 {
            continue;
        }
        let height = |x: Point| sign * across(e, minus(x, p)) / length - by;
        let (h, i) = (height(a), height(b));
        match (h >= 0.0, i >= 0.0) {
            (false, false) => return None,
            (true, false) => to = to.min(h / (h - i)),
            (false, true) => from = from.max(h / (h - i)),
            (true, true) => {}
        }
    }
    let at = |t: f64| [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
    (from <= to).then(|| [at(from), at(to)])
}

/// Corners of what two convex polygons have in common, one of them drawn in by so much; of two that
/// have no area nothing.
pub(super) fn intersection(first: &[Point], second: &[Point], by: f64) -> Vec<Point> {
    let [a, b] = [area(first).abs(), area(second).abs()];
    let (drawn, other) = if a > b { (first, second) } else { (second, first) };
    if a.max(b) == 0.0 || drawn.len() < 3 {
        return Vec::new();
    }
    let edges = |of: &[Point]| -> Vec<[Point; 2]> {
        (0..of.len()).map(|k| [of[k], of[(k + 1) % of.len()]]).collect()
    };
    let mut found: Vec<Point> =
        edges(other).into_iter().filter_map(|edge| clipped(edge, drawn, by)).flatten().collect();
    if other.len() > 2 && area(other) != 0.0 {
        // Corners of the one drawn in are crossings of lines; what of its own edges is left.
        for edge in edges(drawn) {
            found.extend(clipped(edge, other, by).into_iter().flatten());
        }
    }
    found
}

/// How far a point is off a segment.
fn off_segment([a, b]: [Point; 2], at: Point) -> f64 {
    let e = minus(b, a);
    let t = (dot(minus(at, a), e) / dot(e, e)).clamp(0.0, 1.0);
    let t = if t.is_nan() { 0.0 } else { t };
    let d = minus(at, [a[0] + t * e[0], a[1] + t * e[1]]);
    dot(d, d).sqrt()
}

/// Whether some triangle of the points holds a point.
fn contains(points: &[Point], at: Point) -> bool {
    let n = points.len();
    let is_in = |i: usize, j: usize, k: usize| {
        let t = [points[i], points[j], points[k]];
        let side = |k: usize| across(minus(t[(k + 1) % 3], t[k]), minus(at, t[k]));
        let sides = [side(0), side(1), side(2)];
        sides.iter().all(|s| *s >= 0.0) || sides.iter().all(|s| *s <= 0.0)
    };
    points.contains(&at)
        || (0..n).any(|i| {
            (0..i).any(|j| {
                (0..j).any(|k| area(&[points[i], points[j], points[k]]) != 0.0 && is_in(i, j, k))
            })
        })
}

/// How far a point is off the hull of some.
pub(super) fn off_hull(points: &[Point], at: Point) -> f64 {
    if contains(points, at) {
        return 0.0;
    }
    let pairs = points.iter().flat_map(|a| points.iter().map(move |b| [*a, *b]));
    pairs.map(|pair| off_segment(pair, at)).fold(f64::INFINITY, f64::min)
}
