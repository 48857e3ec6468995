//! The best order of the axes: of the three groups, and of the nine cross products.

mod nine;
mod small_cores;
mod table;

use std::error::Error;
use std::path::PathBuf;

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use septum::published;
use septum::published::akenine_moller::Order;
use septum::{Aabb, Scalar, Triangle};

use crate::candidate::{Candidate, Course, Promise};
use crate::race::race;
use crate::triangle_aabb::course;
use crate::triangle_aabb::scenes::{Scene, grid, voorhies, voxel, walls};
use crate::unit::{F32, Form, I16F16_18, Unit};

/// Times the test as published with its axes in every order.
#[derive(Args)]
pub struct Options {
    /// Rounds
    #[arg(long, default_value_t = 60, value_parser = clap::value_parser!(u32).range(4..))]
    rounds: u32,
    /// Where the tables go
    #[arg(long, value_name = "FILE", default_value = "docs/experiments/order.md")]
    out: PathBuf,
    /// Instructions on small cores
    #[arg(long, value_name = "FILE", default_value = "docs/target.csv")]
    target: PathBuf,
}

/// The orders, in the paper's numbers: 1, the faces; 2, the normal; 3, the cross products. Times
/// are relative to the paper's own order, which comes first.
const ORDERS: [(&str, Order); 6] = [
    ("3-1-2", Order::EdgesFacesNormal),
    ("3-2-1", Order::EdgesNormalFaces),
    ("1-3-2", Order::FacesEdgesNormal),
    ("1-2-3", Order::FacesNormalEdges),
    ("2-3-1", Order::NormalEdgesFaces),
    ("2-1-3", Order::NormalFacesEdges),
];

type Test<S> = fn(&Triangle<S>, &Aabb<S>) -> bool;
type Workload = (&'static str, fn() -> Scene);

/// Workloads with different rates of overlap.
const WORKLOADS: [Workload; 4] =
    [("Voorhies", voorhies), ("Voxel", voxel), ("Grid", grid), ("Walls", walls)];

/// Relative times of all orders on one workload in one scalar: quartiles.
struct Race {
    workload: &'static str,
    scalar: &'static str,
    hits: f64,
    times: Vec<[f64; 3]>,
}

/// Times, prints and writes the tables.
pub fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    let rounds = options.rounds as usize;
    let bar = ProgressBar::new((rounds * WORKLOADS.len() * 3) as u64);
    let style = ProgressStyle::with_template("{wide_bar} {msg} {eta}");
    bar.set_style(style.expect("the template is valid"));
    let (mut groups, mut nine, mut counts) = (Vec::new(), Vec::new(), Vec::new());
    for (workload, scene) in WORKLOADS {
        bar.set_message(workload);
        let scene = scene();
        let time = |scalar, candidates: &[Candidate], into: &mut Vec<Race>| {
            let timings = race(candidates, rounds, &bar);
            let times = timings.iter().map(|t| t.quartiles.map(|speed| 1.0 / speed)).collect();
            let hits = candidates[0].overlaps as f64 / candidates[0].pairs as f64;
            into.push(Race { workload, scalar, hits, times });
        };
        time("f32", &in_orders(&scene, &F32), &mut groups);
        time("I16F16", &in_orders(&scene, &I16F16_18), &mut groups);
        let course = course(&scene, &F32, Form::Center);
        time("f32", &nine::candidates(&course), &mut nine);
        counts.push((workload, nine::counts(&scene)));
    }
    bar.finish_and_clear();
    let small_cores = small_cores::read(&options.target)?;
    let text = table::text(&groups, &nine, &counts, &small_cores);
    print!("{text}");
    if let Some(folder) = options.out.parent() {
        std::fs::create_dir_all(folder)?;
    }
    std::fs::write(&options.out, text).map_err(|e| format!("{}: {e}", options.out.display()))?;
    Ok(())
}

#[inline(never)]
fn published<S: Scalar, const K: usize>(t: &Triangle<S>, b: &Aabb<S>) -> bool {
    published::akenine_moller::overlaps_in(t, b, const { ORDERS[K].1 })
}

fn in_orders<S: Scalar>(scene: &Scene, unit: &Unit<S>) -> Vec<Candidate> {
    let course: Course<Triangle<S>, Aabb<S>> = course(scene, unit, Form::Center);
    let tests: [Test<S>; 6] = [
        published::<S, 0>,
        published::<S, 1>,
        published::<S, 2>,
        published::<S, 3>,
        published::<S, 4>,
        published::<S, 5>,
    ];
    let named = ORDERS.iter().zip(tests);
    named.map(|((name, _), test)| course.candidate(name, Promise::Nothing, test)).collect()
}
