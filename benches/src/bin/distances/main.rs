//! Spheres, capsules and closest points beside the peer's in `f32`: time and wrong answers.

mod contacts;
mod sweeps;

use clap::Parser;
use parry3d::math::{Pose, Vector};
use parry3d::query::details::intersection_test_point_query_ball;
use parry3d::query::{PointQuery, intersection_test};
use parry3d::shape::{Ball, Capsule as ParryCapsule, Triangle as ParryTriangle};
use septum::{Capsule, Sphere, Triangle};
use septum_benches::distance::{anywhere, capsule_anywhere};
use septum_benches::native::{Balls, balls};
use septum_benches::sweep::{Shot, scene, voorhies, wall};
use septum_benches::turns::{Method, race};
use septum_kit::Rng;
use septum_kit::spheres::{CapsuleCase, Other, SphereCase, SphereSet};

use crate::contacts::contacts;
use crate::sweeps::{grazing, sweeps};

/// Times spheres, capsules and closest points with triangles, their contacts and sweeps, and counts
/// wrong answers.
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

type Point = [f32; 3];

/// Cases with a triangle, out of cases with any shape.
fn with_triangle<C>(
    pairs: u32,
    case: impl Fn(&mut Rng) -> C,
    other: impl Fn(&C) -> Other<f32>,
) -> Vec<(C, [Point; 3])> {
    let mut rng = Rng::new(0xd15);
    let triangle = |case: C| match other(&case) {
        Other::Triangle(t) => Some((case, t)),
        _ => None,
    };
    let cases = std::iter::repeat_with(|| case(&mut rng)).filter_map(triangle);
    cases.take(pairs as usize).collect()
}

fn triangle([a, b, c]: [Point; 3]) -> Triangle<f32> {
    Triangle::new(a, b, c).expect("a triangle")
}

fn of_parry([a, b, c]: [Point; 3]) -> ParryTriangle {
    ParryTriangle::new(a.into(), b.into(), c.into())
}

/// A sphere that does not move, as a shot.
fn still(center: Point, radius: f32, triangle: [Point; 3]) -> Shot {
    Shot { center, half: [radius; 3], way: [0.0; 3], triangle }
}

fn wide(p: Point) -> [f64; 3] {
    p.map(f64::from)
}

fn spheres(title: &str, options: &Options, case: impl Fn(&mut Rng) -> SphereCase<f32>) {
    let cases = with_triangle(options.pairs, case, |case| case.other);
    let truth: Vec<_> = cases.iter().map(|(case, _)| u64::from(case.truth().is_le())).collect();
    let ours: Vec<_> = cases
        .iter()
        .map(|&(case, t)| (Sphere::new(case.center, case.radius).expect("a sphere"), triangle(t)))
        .collect();
    let in_f64: Vec<_> = cases
        .iter()
        .map(|&(case, t)| {
            let sphere = Sphere::new(wide(case.center), case.radius.into()).expect("a sphere");
            let [a, b, c] = t.map(wide);
            (sphere, Triangle::new(a, b, c).expect("a triangle"))
        })
        .collect();
    let peer: Vec<_> = cases
        .iter()
        .map(|&(case, t)| {
            (Pose::from_translation(case.center.into()), Ball::new(case.radius), of_parry(t))
        })
        .collect();
    let methods = [
        Method { name: "septum, f32", ask: Box::new(|i| ours[i].0.overlaps(&ours[i].1).into()) },
        Method {
            name: "septum, f64",
            ask: Box::new(|i| in_f64[i].0.overlaps(&in_f64[i].1).into()),
        },
        Method {
            name: "parry3d, by projection",
            ask: Box::new(|i| {
                let (at, ball, triangle) = &peer[i];
                intersection_test_point_query_ball(at, triangle, ball).intersecting.into()
            }),
        },
    ];
    race(title, options.rounds, cases.len(), &truth, &methods);
}

fn capsules(title: &str, options: &Options, case: impl Fn(&mut Rng) -> CapsuleCase<f32>) {
    let cases = with_triangle(options.pairs, case, |case| case.other);
    let truth: Vec<_> = cases.iter().map(|(case, _)| u64::from(case.truth().is_le())).collect();
    let ours: Vec<_> = cases
        .iter()
        .map(|&(CapsuleCase { ends: [a, b], radius, .. }, t)| {
            (Capsule::new(a, b, radius).expect("a capsule"), triangle(t))
        })
        .collect();
    let peer: Vec<_> = cases
        .iter()
        .map(|&(CapsuleCase { ends: [a, b], radius, .. }, t)| {
            (ParryCapsule::new(a.into(), b.into(), radius), of_parry(t))
        })
        .collect();
    let at = Pose::identity();
    let methods = [
        Method { name: "septum, f32", ask: Box::new(|i| ours[i].0.overlaps(&ours[i].1).into()) },
        Method {
            name: "parry3d intersection_test",
            ask: Box::new(|i| {
                let (capsule, triangle) = &peer[i];
                intersection_test(&at, capsule, &at, triangle)
                    .is_ok_and(|meet| meet.intersecting)
                    .into()
            }),
        },
    ];
    race(title, options.rounds, cases.len(), &truth, &methods);
}

/// Closest points. A point is wrong if it is farther than the least distance by a millionth, of the
/// distance and of the unit.
fn closest(title: &str, options: &Options, case: impl Fn(&mut Rng) -> SphereCase<f32>) {
    let cases = with_triangle(options.pairs, case, |case| case.other);
    let ours: Vec<_> = cases.iter().map(|&(case, t)| (case.center, triangle(t))).collect();
    let peer: Vec<_> =
        cases.iter().map(|&(case, t)| (Vector::from(case.center), of_parry(t))).collect();
    let least: Vec<_> = cases.iter().map(|(case, _)| case.squared().root()).collect();
    let is_far = |i: usize, q: Point| {
        let d = [0, 1, 2].map(|k: usize| f64::from(ours[i].0[k]) - f64::from(q[k]));
        let distance = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
        u64::from(distance > least[i] * 1.000_001 + 1e-6)
    };
    let mut methods = vec![
        Method {
            name: "septum closest_point, f32",
            ask: Box::new(|i| {
                let closest = ours[i].1.closest_point(ours[i].0).expect("a finite point");
                is_far(i, closest.point.to_array())
            }),
        },
        Method {
            name: "parry3d project_local_point",
            ask: Box::new(|i| {
                let found = peer[i].1.project_local_point(peer[i].0, false).point;
                is_far(i, [found.x, found.y, found.z])
            }),
        },
    ];
    let shots: Vec<_> = cases.iter().map(|&(case, t)| still(case.center, case.radius, t)).collect();
    methods.extend(balls(&shots).into_iter().map(|Balls { names, closest, .. }| Method {
        name: names[2],
        ask: Box::new(move |i| is_far(i, closest(i))),
    }));
    race(title, options.rounds, cases.len(), &vec![0; cases.len()], &methods);
}

/// Races methods that tell the number of what is wrong with an answer, and prints how many of a
/// million answers have each fault.
fn faults(title: &str, options: &Options, count: usize, names: &[&str], methods: &[Method<'_>]) {
    race(title, options.rounds, count, &vec![0; count], methods);
    for method in methods {
        let mut seen = vec![0; names.len()];
        let faults = (0..count).map(|i| (method.ask)(i));
        faults.filter(|&fault| fault > 0).for_each(|fault| seen[fault as usize - 1] += 1);
        let all = names.iter().zip(&seen).filter(|(_, n)| **n > 0);
        let all: Vec<_> = all
            .map(|(name, n)| format!("{name} {:.0}", f64::from(*n) * 1e6 / count as f64))
            .collect();
        if !all.is_empty() {
            println!("    {}: {}", method.name, all.join(", "));
        }
    }
}

fn main() {
    let options = Options::parse();
    println!("Triangles in f32 with other shapes; wrong answers per million.");
    spheres("spheres anywhere", &options, anywhere);
    spheres("spheres about to touch", &options, |rng| SphereSet::Random.case(rng));
    spheres("spheres that touch by whole numbers", &options, |rng| SphereSet::Touch.case(rng));
    capsules("capsules anywhere", &options, capsule_anywhere);
    capsules("capsules about to touch", &options, |rng| SphereSet::Random.capsule(rng));
    closest("closest points, anywhere", &options, anywhere);
    closest("closest points, of slivers", &options, |rng| SphereSet::Slivers.case(rng));
    contacts("contacts of spheres", &options, true, true, capsule_anywhere);
    contacts("contacts of spheres about to touch", &options, true, false, |rng| {
        let SphereCase { center, radius, other } = SphereSet::Random.case(rng);
        CapsuleCase { ends: [center; 2], radius, other }
    });
    contacts("contacts of capsules", &options, false, true, capsule_anywhere);
    contacts("contacts of capsules about to touch", &options, false, false, |rng| {
        SphereSet::Random.capsule(rng)
    });
    sweeps("spheres that move near triangles", &options, voorhies);
    sweeps("spheres that move among small triangles", &options, scene);
    sweeps("spheres that are shot through a wall", &options, wall);
    sweeps("spheres that graze on their way", &options, |rng| grazing(rng, voorhies));
}
