//! The points of a contact lie on both shapes, on the parts that they name.

use septum::contact::{Axis, Contact, Part, Point, contact};
use septum::{Aabb, Obb, Triangle, Vec3};
use septum_kit::boxes::{AnyBox, BoxSet};
use septum_kit::contacts::{ContactSet, Solid};
use septum_kit::{BoxNumbers, Rng};

type P = [f64; 3];

fn dot(a: P, b: P) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

fn minus(a: P, b: P) -> P {
    [0, 1, 2].map(|i: usize| a[i] - b[i])
}

fn cross(a: P, b: P) -> P {
    [(1, 2), (2, 0), (0, 1)].map(|(j, k)| a[j] * b[k] - a[k] * b[j])
}

fn length(a: P) -> f64 {
    dot(a, a).sqrt()
}

/// A shape in floats.
enum Shape {
    Triangle([P; 3]),
    Box { center: P, axes: [P; 3], half: P },
}

impl Shape {
    fn new(solid: &Solid<f64>) -> Self {
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        match *solid {
            Solid::Triangle(t) => Self::Triangle(t),
            Solid::Box(AnyBox::Obb(b)) => {
                Self::Box { center: b.center, axes: b.axes, half: b.half }
            }
            Solid::Box(AnyBox::Aabb(BoxNumbers::Center(center, half))) => {
                Self::Box { center, axes, half }
            }
            Solid::Box(AnyBox::Aabb(BoxNumbers::Corners(p, q))) => {
                let of = |f: fn(f64, f64) -> f64| [0, 1, 2].map(|i: usize| f(p[i], q[i]) / 2.0);
                Self::Box { center: of(|p, q| p + q), axes, half: of(|p, q| q - p) }
            }
        }
    }

    /// The ends of the axes on which a part of a box lies, from its number.
    fn ends(part: Part) -> [Option<bool>; 3] {
        let mut ends = [None; 3];
        match part {
            Part::Face(n) => ends[usize::from(n / 2)] = Some(n % 2 == 1),
            Part::Edge(n) => {
                let i = usize::from(n / 4);
                ends[(i + 1) % 3] = Some(n & 1 == 1);
                ends[(i + 2) % 3] = Some(n & 2 == 2);
            }
            Part::Vertex(n) => ends = [n & 1, n & 2, n & 4].map(|bit| Some(bit != 0)),
        }
        ends
    }

    /// The distance of a point from a part and its ends.
    fn distance(&self, part: Part, at: P) -> f64 {
        match self {
            Self::Triangle(t) => match part {
                Part::Vertex(k) => length(minus(at, t[usize::from(k)])),
                Part::Edge(k) => {
                    let (a, b) = (t[usize::from(k)], t[usize::from(k + 1) % 3]);
                    length(cross(minus(at, a), minus(b, a))) / length(minus(b, a))
                }
                Part::Face(_) => {
                    let n = cross(minus(t[1], t[0]), minus(t[2], t[0]));
                    dot(n, minus(at, t[0])).abs() / length(n)
                }
            },
            Self::Box { center, axes, half } => {
                let off = |i: usize| {
                    let x = dot(minus(at, *center), axes[i]);
                    match Self::ends(part)[i] {
                        Some(upper) => (x - if upper { half[i] } else { -half[i] }).abs(),
                        None => (x.abs() - half[i]).max(0.0),
                    }
                };
                off(0).max(off(1)).max(off(2))
            }
        }
    }
}

fn check_points(shapes: [&Shape; 2], found: &Contact<f64>) {
    let t = found.translation;
    let normal = t.normal.to_array();
    assert!((length(normal) - 1.0).abs() < 1e-12);
    let mut deepest = 0.0_f64;
    for point in found.points() {
        let both = [point.on_first, point.on_second].map(Vec3::to_array);
        // From the first point to the second along the translation.
        let between = minus(both[1], both[0]);
        let along = normal.map(|n| n * point.depth);
        assert!(length(minus(between, along)) < 1e-9, "{found:?}");
        for k in 0..2 {
            let off = shapes[k].distance(point.parts[k], both[k]);
            // Nearly parallel axes and edges leave a point less accurate.
            assert!(off < 1e-6, "{off} off {:?}: {found:?}", point.parts[k]);
        }
        assert!(point.depth > -1e-6, "a point that is not within: {found:?}");
        deepest = deepest.max(point.depth);
    }
    assert!((deepest - t.depth).abs() < 1e-6, "{deepest}: {found:?}");
}

#[test]
fn points_lie_on_both_shapes() {
    let mut rng = Rng::new(0x9017);
    let (mut faces, mut edges, mut most) = (0, 0, 0);
    for _ in 0..6_000 {
        let case = ContactSet::Like(BoxSet::Turned).case::<f64>(&mut rng);
        let Some(Some(found)) = case.contact() else { continue };
        let shapes = [Shape::new(&case.first), Shape::new(&case.second)];
        let is_flat = |s: &Shape| matches!(s, Shape::Box { half, .. } if half.contains(&0.0));
        if shapes.iter().any(is_flat) {
            continue;
        }
        check_points([&shapes[0], &shapes[1]], &found);
        match found.translation.axis {
            Axis::Edges(..) => edges += 1,
            _ => faces += 1,
        }
        most = most.max(found.points().len());
    }
    assert!(faces > 300 && edges > 100 && most > 4, "{faces} {edges} {most}");
}

fn parts(found: &Contact<f32>) -> Vec<[Part; 2]> {
    let mut all: Vec<[Part; 2]> = found.points().iter().map(|p: &Point<f32>| p.parts).collect();
    all.sort();
    all
}

/// A box that tilts, slides and sinks a little from frame to frame keeps its parts.
#[test]
fn parts_are_the_same_from_frame_to_frame() {
    let floor = Triangle::new([-8.0_f32, -8.0, 0.0], [8.0, -8.0, 0.0], [0.0, 9.0, 0.0]).unwrap();
    let frame = |n: u8| {
        let tilt = 1e-4 * f32::from(n);
        let axes = [[1.0, 0.0, tilt], [0.0, 1.0, -tilt / 2.0], [-tilt, tilt / 2.0, 1.0]];
        let center = [0.01 * f32::from(n), 0.0, 0.99 - 0.001 * f32::from(n)];
        Obb::new(center, axes, [1.0; 3]).unwrap()
    };
    let first = parts(&contact(&floor, &frame(0)).unwrap());
    let expected = [0, 1, 2, 3].map(|k| [Part::Face(0), Part::Vertex(k)]);
    assert_eq!(first, expected);
    for n in 1..10 {
        let found = contact(&floor, &frame(n)).unwrap();
        assert_eq!((found.translation.axis, parts(&found)), (Axis::First(0), first.clone()));
    }
}

/// One rectangle across another: eight corners, each from two edges.
#[test]
fn a_square_on_a_square_has_eight_points() {
    let below = Aabb::from_min_max([-1.0, -1.0, -2.0], [1.0, 1.0, 0.0]).unwrap();
    let r = 0.5_f32.sqrt();
    let axes = [[r, r, 0.0], [-r, r, 0.0], [0.0, 0.0, 1.0]];
    let above = Obb::new([0.0, 0.0, 0.96875], axes, [1.0, 1.0, 1.0]).unwrap();
    let found = contact(&above, &below).unwrap();
    assert_eq!(found.translation.depth, 0.03125);
    assert_eq!(found.translation.normal.to_array(), [0.0, 0.0, 1.0]);
    assert_eq!(found.points().len(), 8);
    let all = parts(&found);
    assert!(all.iter().all(|p| matches!(p, [Part::Edge(_), Part::Edge(_)])));
    assert!(all.windows(2).all(|two| two[0] != two[1]));
    // A small rectangle on a large one: the corners of the small one.
    let small = Aabb::from_min_max([-0.25, -0.25, -0.5], [0.25, 0.25, 0.5]).unwrap();
    let small = contact(&small, &below).unwrap();
    assert_eq!(parts(&small), [0, 1, 2, 3].map(|k| [Part::Vertex(k), Part::Face(5)]));
}
