//! A box that moves past triangles, beside the peers' casts of shapes: wrong answers, late times,
//! and how long it takes.

use std::hint::black_box;
use std::time::{Duration, Instant};

use box3d_rust::distance::{ShapeCastPairInput, make_proxy, shape_cast};
use box3d_rust::math_functions as box3d;
use clap::Parser;
use fixed::types::{I16F16, I32F32};
use parry3d::math::{Pose, Vector};
use parry3d::query::{ShapeCastOptions, cast_shapes};
use parry3d::shape::{Cuboid, Triangle as ParryTriangle};
use septum::sweep::{Motion, Sweep};
use septum::{Aabb, Scalar, Triangle};
use septum_kit::Rng;

/// Counts wrong answers of sweeps, and times them.
#[derive(Parser)]
#[command(version)]
struct Options {
    /// Shots at the wall, and pairs of the other scenes
    #[arg(long, default_value_t = 1_000_000, value_parser = clap::value_parser!(u32).range(1..))]
    shots: u32,
    /// Rounds in which all take turns; the best of each counts
    #[arg(long, default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..))]
    rounds: u32,
}

/// When a shot first meets its triangle, by somebody's method.
type Cast = fn(&Shot) -> Option<f32>;

/// A box at the start, how far it moves, and a triangle.
#[derive(Clone, Copy)]
struct Shot {
    center: [f32; 3],
    half: [f32; 3],
    way: [f32; 3],
    triangle: [[f32; 3]; 3],
}

/// The same in a scalar.
struct Given<S> {
    aabb: Aabb<S>,
    motion: Motion<S>,
    triangle: Triangle<S>,
}

impl Shot {
    fn given<S: Scalar>(&self, near: impl Fn(f32) -> S) -> Given<S> {
        let p = |p: [f32; 3]| p.map(&near);
        let [a, b, c] = self.triangle;
        Given {
            aabb: Aabb::from_center_half_extents(p(self.center), p(self.half)).expect("a box"),
            motion: Motion::new(p([0.0; 3]), p(self.way)).expect("finite"),
            triangle: Triangle::new(p(a), p(b), p(c)).expect("finite"),
        }
    }
}

/// Triangles about the origin, a unit cube near it, and a way of about its size.
fn voorhies(rng: &mut Rng) -> Shot {
    let mut point = |most: f64| rng.triple(|rng| rng.real(-most, most) as f32);
    let (triangle, center, way) = ([point(2.0), point(2.0), point(2.0)], point(1.0), point(1.0));
    Shot { center, half: [0.5; 3], way, triangle }
}

/// What a body meets in a scene: small triangles about its way.
fn scene(rng: &mut Rng) -> Shot {
    let way = rng.triple(|rng| rng.real(-1.0, 1.0) as f32);
    let t = rng.real(0.0, 1.0);
    let middle = [0, 1, 2].map(|i: usize| t * f64::from(way[i]) + rng.real(-0.7, 0.7));
    let triangle =
        [(); 3].map(|()| [0, 1, 2].map(|i: usize| (middle[i] + rng.real(-0.2, 0.2)) as f32));
    Shot { center: [0.0; 3], half: [0.5; 3], way, triangle }
}

/// From one side of a wall of one triangle to the other, at any angle, at any speed.
fn wall(rng: &mut Rng) -> Shot {
    let normal = rng.triple(|rng| rng.real(-1.0, 1.0));
    let size = 0.001 + rng.real(0.0, 1.0).powi(4);
    let far = 2_f64.powf(rng.real(-3.0, 10.0));
    // Two ways along it.
    let u = rng.triple(|rng| rng.real(-1.0, 1.0));
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let (p, q) = (cross(normal, u), cross(normal, cross(normal, u)));
    let at = |a: f64, b: f64, c: f64| [0, 1, 2].map(|i: usize| a * p[i] + b * q[i] + c * normal[i]);
    let wide = 4096.0;
    let triangle = [at(-wide, -wide, 0.0), at(wide, -wide, 0.0), at(0.0, wide, 0.0)];
    let length = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt().max(1e-3);
    // Far enough to be wholly on one side.
    let off = (far + 2.0 * size) / length(normal);
    let slant = |rng: &mut Rng| rng.real(-0.5, 0.5) * far;
    let start = at(slant(rng), slant(rng), off);
    let end = at(slant(rng), slant(rng), -off);
    Shot {
        center: start.map(|x| x as f32),
        half: [size as f32; 3],
        way: [0, 1, 2].map(|i: usize| (end[i] - start[i]) as f32),
        triangle: triangle.map(|v| v.map(|x| x as f32)),
    }
}

fn vector(p: [f32; 3]) -> Vector {
    Vector::new(p[0], p[1], p[2])
}

/// parry3d's time, if it hits.
#[inline(never)]
fn parry(shot: &Shot) -> Option<f32> {
    let [a, b, c] = shot.triangle.map(vector);
    let cuboid = Cuboid::new(vector(shot.half));
    let pose = Pose::from_translation(vector(shot.center));
    let options = ShapeCastOptions::with_max_time_of_impact(1.0);
    let triangle = ParryTriangle::new(a, b, c);
    let (still, zero) = (Pose::IDENTITY, vector([0.0; 3]));
    cast_shapes(&pose, vector(shot.way), &cuboid, &still, zero, &triangle, options)
        .expect("it has a cast for these")
        .map(|hit| hit.time_of_impact)
}

/// box3d-rust's, which stops a linear slop of 5 mm before.
#[inline(never)]
fn box3d_cast(shot: &Shot) -> Option<f32> {
    let point = |[x, y, z]: [f32; 3]| box3d::Vec3 { x, y, z };
    let corners: [_; 8] = std::array::from_fn(|k| {
        point(std::array::from_fn(|i| {
            shot.center[i] + if k >> i & 1 == 0 { -shot.half[i] } else { shot.half[i] }
        }))
    });
    let output = shape_cast(&ShapeCastPairInput {
        proxy_a: make_proxy(&shot.triangle.map(point), 0.0),
        proxy_b: make_proxy(&corners, 0.0),
        transform: box3d::TRANSFORM_IDENTITY,
        translation_b: point(shot.way),
        max_fraction: 1.0,
        can_encroach: true,
    });
    output.hit.then_some(output.fraction)
}

fn ours(shot: &Shot) -> Option<f32> {
    let Given { aabb, motion, triangle } = shot.given(|x| x);
    aabb.first_contact(&motion, &triangle).map(|first| first.t)
}

/// Answers beside the true ones, which `f64` has to its last bit.
fn count(title: &str, shots: &[Shot]) {
    let truth: Vec<Option<f64>> = shots
        .iter()
        .map(|shot| {
            let Given { aabb, motion, triangle } = shot.given(f64::from);
            aabb.first_contact(&motion, &triangle).map(|first| first.t)
        })
        .collect();
    let hits = truth.iter().flatten().count();
    println!("\n{title}: {} shots, {hits} hit", shots.len());
    println!(
        "{:12} {:>9} {:>11} {:>9} {:>12} {:>12}",
        "", "misses", "false hits", "late", "most late", "most early"
    );
    let methods: [(&str, Cast); 3] =
        [("septum", ours), ("parry3d", parry), ("box3d-rust", box3d_cast)];
    for (name, cast) in methods {
        let (mut misses, mut inventions, mut late) = (0, 0, 0);
        let (mut most_late, mut most_early) = (0.0_f64, 0.0_f64);
        for (shot, truth) in shots.iter().zip(&truth) {
            match (cast(shot), truth) {
                (None, Some(_)) => misses += 1,
                (Some(_), None) => inventions += 1,
                (Some(t), Some(truth)) => {
                    // Rounding to the nearest would not be late.
                    late += usize::from(f64::from(t.next_down()) > *truth);
                    let t = f64::from(t);
                    most_late = most_late.max(t - truth);
                    most_early = most_early.max(truth - t);
                }
                (None, None) => {}
            }
        }
        println!(
            "{name:12} {misses:9} {inventions:11} {late:9} {most_late:12.1e} {most_early:12.1e}"
        );
    }
}

struct Method<'a> {
    name: &'static str,
    run: Box<dyn Fn() -> usize + 'a>,
}

/// In turns, and how many times as long as the first.
fn race(title: &str, rounds: u32, pairs: usize, methods: &[Method<'_>]) {
    let mut best = vec![Duration::MAX; methods.len()];
    for _ in 0..rounds {
        for (method, best) in methods.iter().zip(&mut best) {
            let start = Instant::now();
            black_box((method.run)());
            *best = start.elapsed().min(*best);
        }
    }
    println!("\n{title}");
    for (method, time) in methods.iter().zip(&best) {
        let ns = time.as_nanos() as f64 / pairs as f64;
        let ratio = time.as_secs_f64() / best[0].as_secs_f64();
        println!("{:26} {ns:8.1} ns {ratio:7.2}   {} hits", method.name, (method.run)());
    }
}

fn of_scalar<'a, S: Scalar>(given: &'a [Given<S>]) -> Vec<Method<'a>> {
    let count = |ask: fn(&Given<S>) -> bool| -> Box<dyn Fn() -> usize + 'a> {
        Box::new(move || given.iter().filter(|g| ask(g)).count())
    };
    vec![
        Method { name: "at the start: overlaps", run: count(|g| g.triangle.overlaps(&g.aabb)) },
        Method { name: "meets_along", run: count(|g| g.aabb.meets_along(&g.motion, &g.triangle)) },
        Method {
            name: "first_contact",
            run: count(|g| g.aabb.first_contact(&g.motion, &g.triangle).is_some()),
        },
    ]
}

fn time(title: &str, rounds: u32, shots: &[Shot]) {
    let n = shots.len();
    let given: Vec<_> = shots.iter().map(|shot| shot.given(|x| x)).collect();
    let mut methods = of_scalar(&given);
    methods.push(Method {
        name: "parry3d cast_shapes",
        run: Box::new(|| shots.iter().filter(|shot| parry(shot).is_some()).count()),
    });
    methods.push(Method {
        name: "box3d-rust shape_cast",
        run: Box::new(|| shots.iter().filter(|shot| box3d_cast(shot).is_some()).count()),
    });
    race(&format!("{title}, f32"), rounds, n, &methods);
    let given: Vec<_> = shots.iter().map(|shot| shot.given(f64::from)).collect();
    race(&format!("{title}, f64 of f32"), rounds, n, &of_scalar(&given));
    let long = |x: f32| f64::from(x) * 1.000_000_001_234_567;
    let given: Vec<_> = shots.iter().map(|shot| shot.given(long)).collect();
    race(&format!("{title}, f64"), rounds, n, &of_scalar(&given));
    let given: Vec<_> = shots.iter().map(|shot| shot.given(I16F16::from_num)).collect();
    race(&format!("{title}, I16F16"), rounds, n, &of_scalar(&given));
    let given: Vec<_> = shots.iter().map(|shot| shot.given(I32F32::from_num)).collect();
    race(&format!("{title}, I32F32"), rounds, n, &of_scalar(&given));
}

fn main() {
    let Options { shots, rounds } = Options::parse();
    let make = |seed: u64, one: fn(&mut Rng) -> Shot, n: u32| -> Vec<Shot> {
        let rng = &mut Rng::new(seed);
        (0..n).map(|_| one(rng)).collect()
    };
    count("A wall of one triangle, shot through", &make(1, wall, shots));
    count("A unit cube near triangles", &make(2, voorhies, shots));
    count("A unit cube among small triangles", &make(3, scene, shots));
    time("A unit cube near triangles", rounds, &make(2, voorhies, 20_000));
    time("A unit cube among small triangles", rounds, &make(3, scene, 20_000));
}
