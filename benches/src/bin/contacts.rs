//! Contacts in `f32` and other scalars, beside the peers' in `f32`: time and wrong answers.

use std::hint::black_box;
use std::rc::Rc;
use std::time::{Duration, Instant};

use clap::Parser;
use parry3d::math::{Pose, Vector};
use parry3d::query;
use parry3d::shape::Triangle as ParryTriangle;
use septum::contact::{Contact, Translation, contact, least_translation};
use septum::{Aabb, Obb, Triangle};
use septum_benches::contact::{of_contact, of_manifold};
use septum_benches::obb_obb::{Placed, placed};
use septum_kit::fixed::types::I16F16;
use septum_kit::{Rng, Sample};

/// Times contacts of overlapping shapes.
#[derive(Parser)]
#[command(version)]
struct Options {
    /// Rounds in which all take turns; the best of each counts
    #[arg(long, default_value_t = 30, value_parser = clap::value_parser!(u32).range(1..))]
    rounds: u32,
    /// Pairs in each scene
    #[arg(long, default_value_t = 2000, value_parser = clap::value_parser!(u32).range(1..))]
    pairs: u32,
}

type Point = [f64; 3];

/// A box by its centre, axes and half-extents.
#[derive(Clone, Copy)]
struct Turned {
    center: Point,
    axes: [Point; 3],
    half: Point,
}

/// The first shape, which the box overlaps.
#[derive(Clone, Copy)]
enum First {
    Triangle([Point; 3]),
    Box(Turned),
}

/// The coordinate axes rotated by these angles.
fn turned(angles: Point) -> [Point; 3] {
    let mut frame = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for (angle, (i, j)) in angles.into_iter().zip([(0, 1), (1, 2), (2, 0)]) {
        let (sin, cos) = angle.sin_cos();
        for row in &mut frame {
            (row[i], row[j]) = (cos * row[i] - sin * row[j], sin * row[i] + cos * row[j]);
        }
    }
    frame
}

fn cube(rng: &mut Rng, angles: Point) -> Turned {
    let center = rng.triple(|rng| rng.real(-1.0, 1.0));
    let half = rng.triple(|rng| rng.real(0.1, 0.6));
    Turned { center, axes: turned(angles), half }
}

fn any(rng: &mut Rng) -> Point {
    rng.triple(|rng| rng.real(0.0, std::f64::consts::TAU))
}

/// A triangle of the floor, and a box that has sunk into it a little.
fn on_floor(rng: &mut Rng, angles: Point) -> (First, Turned) {
    let mut b = cube(rng, angles);
    let reach: f64 = (0..3).map(|k| b.half[k] * b.axes[k][2].abs()).sum();
    b.center[2] = reach - rng.real(0.001, 0.02);
    let corner = |rng: &mut Rng, x: f64, y: f64| {
        [b.center[0] + x + rng.real(-0.2, 0.2), b.center[1] + y + rng.real(-0.2, 0.2), 0.0]
    };
    let t = [corner(rng, -1.0, -1.0), corner(rng, 1.0, -1.0), corner(rng, 0.0, 1.0)];
    (First::Triangle(t), b)
}

fn obb<S: Sample>(b: &Turned) -> Obb<S> {
    let at = |p: Point| p.map(S::nearest);
    Obb::from_skewed_axes(at(b.center), b.axes.map(at), at(b.half)).expect("a box")
}

/// The two shapes of each pair.
enum Pairs<S> {
    Floor(Vec<(Triangle<S>, Aabb<S>)>),
    Triangles(Vec<(Triangle<S>, Obb<S>)>),
    Boxes(Vec<(Obb<S>, Obb<S>)>),
}

impl<S: Sample> Pairs<S> {
    fn new(scene: &[(First, Turned)], are_aligned: bool) -> Self {
        let triangle = |t: &[Point; 3]| {
            let [a, b, c] = t.map(|p| p.map(S::nearest));
            Triangle::new(a, b, c).expect("numbers")
        };
        let triangles = || {
            scene.iter().filter_map(|(first, b)| match first {
                First::Triangle(t) => Some((triangle(t), b)),
                First::Box(_) => None,
            })
        };
        let boxes = || {
            scene.iter().filter_map(|(first, b)| match first {
                First::Box(a) => Some((obb(a), obb(b))),
                First::Triangle(_) => None,
            })
        };
        if boxes().next().is_some() {
            return Self::Boxes(boxes().collect());
        }
        if !are_aligned {
            return Self::Triangles(triangles().map(|(t, b)| (t, obb(b))).collect());
        }
        let aabb = |b: &Turned| {
            let at = |p: Point| p.map(S::nearest);
            Aabb::from_center_half_extents(at(b.center), at(b.half)).expect("a box")
        };
        Self::Floor(triangles().map(|(t, b)| (t, aabb(b))).collect())
    }

    fn contact(&self, i: usize) -> Option<Contact<S>> {
        match self {
            Self::Floor(all) => contact(&all[i].0, &all[i].1),
            Self::Triangles(all) => contact(&all[i].0, &all[i].1),
            Self::Boxes(all) => contact(&all[i].0, &all[i].1),
        }
    }

    fn least(&self, i: usize) -> Option<Translation<S>> {
        match self {
            Self::Floor(all) => least_translation(&all[i].0, &all[i].1),
            Self::Triangles(all) => least_translation(&all[i].0, &all[i].1),
            Self::Boxes(all) => least_translation(&all[i].0, &all[i].1),
        }
    }
}

struct Method<'a> {
    name: String,
    /// The depth, if there is a contact.
    ask: Box<dyn Fn(usize) -> Option<f64> + 'a>,
}

fn of_scalar<'a, S: Sample>(pairs: &'a Pairs<S>) -> [Method<'a>; 2] {
    let depth = |t: Translation<S>| t.depth.approximate();
    let name = |what: &str| format!("septum, {what} {}", S::name());
    [
        Method {
            name: name("contact"),
            ask: Box::new(move |i| pairs.contact(i).map(|c| depth(black_box(c).translation))),
        },
        Method { name: name("translation"), ask: Box::new(move |i| pairs.least(i).map(depth)) },
    ]
}

/// The peers, each on shapes of its own made before the clock starts.
fn of_peers(scene: &[(First, Turned)]) -> Vec<Method<'static>> {
    let placed = |b: &Turned| placed(&obb(b));
    let boxes: Vec<[Placed; 2]> = scene
        .iter()
        .filter_map(|(first, b)| match first {
            First::Box(a) => Some([a, b].map(placed)),
            First::Triangle(_) => None,
        })
        .collect();
    if boxes.is_empty() {
        let triangles: Vec<(ParryTriangle, Placed)> = scene
            .iter()
            .filter_map(|(first, b)| match first {
                First::Triangle(t) => {
                    let [p, q, r] = t.map(|p| Vector::from(p.map(|x| x as f32)));
                    Some((ParryTriangle::new(p, q, r), placed(b)))
                }
                First::Box(_) => None,
            })
            .collect();
        let contact = move |i: usize| {
            let (t, b) = &triangles[i];
            let found = query::contact(&Pose::IDENTITY, t, &b.pose, &b.cuboid, 0.0);
            found.ok().flatten().map(|c| -f64::from(c.dist))
        };
        return vec![Method { name: "parry3d, contact".into(), ask: Box::new(contact) }];
    }
    let boxes = Rc::new(boxes);
    let method = |name: &str, ask: fn(&Placed, &Placed) -> Option<f64>| {
        let boxes = Rc::clone(&boxes);
        let ask = move |i: usize| ask(&boxes[i][0], &boxes[i][1]);
        Method { name: name.into(), ask: Box::new(ask) }
    };
    vec![method("parry3d, contact", of_contact), method("parry3d, manifold", of_manifold)]
}

fn race(title: &str, rounds: u32, count: usize, methods: &[Method<'_>]) {
    let mut best = vec![Duration::MAX; methods.len()];
    for _ in 0..rounds {
        for (method, best) in methods.iter().zip(&mut best) {
            let start = Instant::now();
            for i in 0..count {
                black_box((method.ask)(black_box(i)));
            }
            *best = start.elapsed().min(*best);
        }
    }
    println!("\n{title}");
    println!("{:28} {:>7} {:>9} {:>7} {:>6} {:>6}", "", "ns", "of ours", "missed", "short", "long");
    for (method, time) in methods.iter().zip(&best) {
        let mut wrong = [0; 3];
        for i in 0..count {
            let Some(least) = (methods[0].ask)(i) else { continue };
            match (method.ask)(i) {
                None => wrong[0] += 1,
                Some(depth) => {
                    wrong[1] += usize::from(depth < least * 0.999);
                    wrong[2] += usize::from(depth > least * 1.001);
                }
            }
        }
        println!(
            "{:28} {:7.0} {:9.2} {:7} {:6} {:6}",
            method.name,
            time.as_nanos() as f64 / count as f64,
            time.as_secs_f64() / best[0].as_secs_f64(),
            wrong[0],
            wrong[1],
            wrong[2],
        );
    }
}

fn main() {
    let options = Options::parse();
    let (rounds, count) = (options.rounds, options.pairs as usize);
    println!("{count} pairs; missed, and depth more than a thousandth too short or too long.");
    let mut rng = Rng::new(0xc0de);
    let mut scene =
        |title: &str, are_aligned: bool, one: &mut dyn FnMut(&mut Rng) -> (First, Turned)| {
            let mut all = Vec::new();
            while all.len() < count {
                let pair = one(&mut rng);
                let pairs = Pairs::<f32>::new(&[pair], are_aligned);
                if pairs.least(0).is_some() {
                    all.push(pair);
                }
            }
            let single = Pairs::<f32>::new(&all, are_aligned);
            let double = Pairs::<f64>::new(&all, are_aligned);
            let fixed = Pairs::<I16F16>::new(&all, are_aligned);
            let peers = of_peers(&all);
            let [a, b] = of_scalar(&single);
            let [c, d] = of_scalar(&double);
            let [e, f] = of_scalar(&fixed);
            let mut methods = vec![a, b, c, d, e, f];
            methods.extend(peers);
            race(title, rounds, count, &methods);
        };
    scene("triangle and axis-aligned box: on the floor", true, &mut |rng| on_floor(rng, [0.0; 3]));
    scene("triangle and oriented box: on the floor", false, &mut |rng| {
        let angles = any(rng);
        on_floor(rng, angles)
    });
    scene("triangle and oriented box: anyhow", false, &mut |rng| {
        let t = [(); 3].map(|()| rng.triple(|rng| rng.real(-1.0, 1.0)));
        let angles = any(rng);
        (First::Triangle(t), cube(rng, angles))
    });
    scene("oriented boxes: anyhow", false, &mut |rng| {
        let (a, b) = (any(rng), any(rng));
        (First::Box(cube(rng, a)), cube(rng, b))
    });
    scene("oriented boxes: stacked, turned alike", false, &mut |rng| {
        let angles = any(rng);
        let a = cube(rng, angles);
        let mut b = Turned { half: rng.triple(|rng| rng.real(0.1, 0.6)), ..a };
        let up = a.half[2] + b.half[2] - rng.real(0.001, 0.02);
        b.center = [0, 1, 2].map(|i: usize| a.center[i] + up * a.axes[2][i]);
        (First::Box(a), b)
    });
}
