//! Moving boxes and all pairs of them that overlap, each tick: a tree that is refitted, beside the
//! peer's, which updates its own.

use std::hint::black_box;
use std::time::{Duration, Instant};

use clap::Parser;
use fixed::types::I16F16;
use parry3d::bounding_volume::Aabb as ParryAabb;
use parry3d::math::Vector;
use parry3d::partitioning::{Bvh, BvhWorkspace};
use septum::broad_phase::BoxTree;
use septum::mesh::Node;
use septum::{Aabb, Scalar};
use septum_kit::Rng;

/// Times all pairs of boxes that move.
#[derive(Parser)]
#[command(version)]
struct Options {
    /// Boxes
    #[arg(long, default_value_t = 10_000, value_parser = clap::value_parser!(u32).range(2..60_001))]
    boxes: u32,
    /// Ticks
    #[arg(long, default_value_t = 200, value_parser = clap::value_parser!(u32).range(2..))]
    ticks: u32,
    /// The way of a box in a tick, as a part of its size
    #[arg(long, default_value_t = 0.1)]
    speed: f32,
    /// Ticks from one build of our tree to the next
    #[arg(long, default_value_t = 16, value_parser = clap::value_parser!(u32).range(1..))]
    rebuild: u32,
}

/// A box with its motion, in a cube with walls.
#[derive(Clone)]
struct Body {
    center: [f32; 3],
    half: [f32; 3],
    velocity: [f32; 3],
}

const SIDE: f32 = 100.0;

impl Body {
    fn step(&mut self) {
        for i in 0..3 {
            self.center[i] += self.velocity[i];
            if !(0.0..SIDE).contains(&self.center[i]) {
                self.velocity[i] = -self.velocity[i];
                self.center[i] = self.center[i].clamp(0.0, SIDE);
            }
        }
    }

    fn ends(&self) -> [[f32; 3]; 2] {
        [-1.0, 1.0].map(|sign| [0, 1, 2].map(|i| self.center[i] + sign * self.half[i]))
    }
}

/// Takes the tick and the boxes; returns the number of pairs, and the time.
type Find<'a> = dyn FnMut(u32, &[[[f32; 3]; 2]]) -> (usize, Duration) + 'a;

/// A way of finding all pairs. It has the time that it took.
struct Racer<'a> {
    name: &'static str,
    find: Box<Find<'a>>,
    /// The tick's and the whole time.
    all: Vec<Duration>,
}

fn ours<'a, S: Scalar>(
    name: &'static str,
    count: usize,
    rebuild: u32,
    nearest: fn(f32) -> S,
) -> Racer<'a> {
    let mut nodes = vec![Node::EMPTY; Node::count_for(count)];
    let mut order = vec![0_u16; count];
    let mut found = vec![[0_u16; 2]; 64 * count];
    let find = move |tick: u32, ends: &[[[f32; 3]; 2]]| {
        let of = |&[min, max]: &[[f32; 3]; 2]| {
            Aabb::from_min_max(min.map(nearest), max.map(nearest)).expect("a box")
        };
        let boxes: Vec<Aabb<S>> = ends.iter().map(of).collect();
        let start = Instant::now();
        let tree = if tick.is_multiple_of(rebuild) {
            BoxTree::build(&boxes, &mut nodes, &mut order)
        } else {
            BoxTree::refit(&boxes, &mut nodes, &order)
        };
        let pairs = tree.expect("room").pairs(&mut found).expect("room").len();
        (pairs, start.elapsed())
    };
    Racer { name, find: Box::new(find), all: Vec::new() }
}

fn parry<'a>() -> Racer<'a> {
    let (mut tree, mut workspace) = (Bvh::new(), BvhWorkspace::default());
    let mut found: Vec<[u32; 2]> = Vec::new();
    let find = move |_: u32, ends: &[[[f32; 3]; 2]]| {
        let of = |&[min, max]: &[[f32; 3]; 2]| ParryAabb::new(Vector::from(min), Vector::from(max));
        let boxes: Vec<ParryAabb> = ends.iter().map(of).collect();
        let start = Instant::now();
        // As rapier does it each step.
        for (i, aabb) in boxes.iter().enumerate() {
            tree.insert_or_update_partially(*aabb, i as u32, 0.0);
        }
        tree.refit(&mut workspace);
        tree.optimize_incremental(&mut workspace);
        found.clear();
        tree.traverse_bvtt_single_tree::<false>(&mut workspace, &mut |a, b| {
            found.push([a.min(b), a.max(b)]);
        });
        (black_box(&found).len(), start.elapsed())
    };
    Racer { name: "parry3d, unsorted", find: Box::new(find), all: Vec::new() }
}

fn main() {
    let Options { boxes, ticks, speed, rebuild } = Options::parse();
    let (count, mut rng) = (boxes as usize, Rng::new(7));
    let mut bodies: Vec<Body> = (0..count)
        .map(|_| {
            let center = rng.triple(|rng| rng.real(0.0, SIDE.into()) as f32);
            let half = rng.triple(|rng| rng.real(0.5, 1.5) as f32);
            let velocity = rng.triple(|rng| rng.real(-2.0, 2.0) as f32 * speed);
            Body { center, half, velocity }
        })
        .collect();
    let mut racers = [
        ours("f32, refitted", count, rebuild, |x| x),
        ours("f32, built each tick", count, 1, |x| x),
        ours("f64, refitted", count, rebuild, f64::from),
        ours("I16F16, refitted", count, rebuild, I16F16::from_num),
        parry(),
    ];
    let mut pairs = 0;
    for tick in 0..ticks {
        bodies.iter_mut().for_each(Body::step);
        let ends: Vec<_> = bodies.iter().map(Body::ends).collect();
        let mut counts = racers.iter_mut().map(|racer| {
            let (pairs, time) = (racer.find)(tick, &ends);
            racer.all.push(time);
            (racer.name, pairs)
        });
        let counts: Vec<_> = counts.by_ref().collect();
        // In fixed point the boxes are others.
        let expected = counts[0].1;
        assert!(
            counts.iter().all(|&(name, n)| name.starts_with('I') || n == expected),
            "{counts:?}"
        );
        pairs += expected;
    }
    println!(
        "{count} boxes, {ticks} ticks, {} pairs a tick; ours sorted, built anew every {rebuild} ticks",
        pairs / ticks as usize
    );
    println!("{:22} {:>9} {:>9} {:>9}", "", "median", "mean", "ratio");
    let median = |racer: &mut Racer<'_>| {
        racer.all.sort_unstable();
        racer.all[racer.all.len() / 2]
    };
    let peer = median(&mut racers[4]);
    let mean = |racer: &Racer<'_>| racer.all.iter().sum::<Duration>() / ticks;
    let peer_mean = mean(&racers[4]);
    for racer in &mut racers {
        let (median, mean) = (median(racer), mean(racer));
        let ratio = median.as_secs_f64() / peer.as_secs_f64();
        let of_means = mean.as_secs_f64() / peer_mean.as_secs_f64();
        println!(
            "{:22} {:>6.0} µs {:>6.0} µs {ratio:>9.2} {of_means:>9.2}",
            racer.name,
            median.as_secs_f64() * 1e6,
            mean.as_secs_f64() * 1e6
        );
    }
}
