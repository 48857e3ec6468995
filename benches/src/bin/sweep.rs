//! A box that moves past triangles, beside the peers' shape casts: wrong answers, late times, and
//! speed.

use std::hint::black_box;
use std::time::{Duration, Instant};

use clap::Parser;
use fixed::types::{I16F16, I32F32};
use septum::Scalar;
use septum::sweep::Sweep;
use septum_benches::sweep::{Given, Shot, box3d_cast, parry, scene, voorhies, wall};
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

/// A method for the time at which a shot first meets its triangle.
type Cast = fn(&Shot) -> Option<f32>;

fn ours(shot: &Shot) -> Option<f32> {
    let Given { aabb, motion, triangle } = shot.given(|x| x);
    aabb.first_contact(&motion, &triangle).map(|first| first.t)
}

/// Compares answers with the true ones, which `f64` computes exactly enough.
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
                    // A time rounded to the nearest is not counted as late.
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

/// Races the methods in turns, and prints times relative to the first.
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
