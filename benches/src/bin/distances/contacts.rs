//! Contacts of spheres and capsules with triangles.

use parry3d::math::Pose;
use parry3d::query;
use parry3d::shape::{Ball, Capsule as ParryCapsule, Shape as ParryShape};
use septum::contact::{ContactWith, contact};
use septum::{Capsule, Sphere, Triangle};
use septum_benches::native::{Balls, balls};
use septum_benches::turns::Method;
use septum_kit::spheres::{CapsuleCase, Other};
use septum_kit::{Rng, Sample};

use crate::{Options, Point, faults, of_parry, still, triangle, wide, with_triangle};

/// What may be wrong with the depth of a contact.
const FAULTS: [&str; 4] = ["missed", "invented", "short", "long"];

/// The fault of a depth, by its number, or zero: short or long by more than a thousandth, and by a
/// millionth of the unit.
fn fault(truth: Option<f64>, depth: Option<f64>) -> u64 {
    match (truth, depth.filter(|depth| *depth > 0.0)) {
        (Some(_), None) => 1,
        (None, Some(_)) => 2,
        (Some(truth), Some(depth)) if depth < truth * 0.999 - 1e-6 => 3,
        (Some(truth), Some(depth)) if depth > truth * 1.001 + 1e-6 => 4,
        _ => 0,
    }
}

fn depth<S: Sample, A: ContactWith<S, Triangle<S>>>(a: &A, triangle: &Triangle<S>) -> Option<f64> {
    contact(a, triangle).map(|contact| contact.translation.depth.approximate())
}

fn race<A: ContactWith<f32, Triangle<f32>>, B: ContactWith<f64, Triangle<f64>>>(
    title: &str,
    options: &Options,
    are_spheres: bool,
    cases: &[(CapsuleCase<f32>, [Point; 3])],
    ours: impl Fn(&CapsuleCase<f32>) -> A,
    in_f64: impl Fn(&CapsuleCase<f64>) -> B,
    peer: impl Fn(&CapsuleCase<f32>) -> (Pose, Box<dyn ParryShape>),
) {
    let double: Vec<_> = cases
        .iter()
        .map(|&(CapsuleCase { ends, radius, .. }, t)| {
            let t = t.map(wide);
            let (ends, radius, other) = (ends.map(wide), radius.into(), Other::Triangle(t));
            let case = CapsuleCase { ends, radius, other };
            // Stops if this answer is wrong; the others are held against it.
            case.check_contacts();
            (in_f64(&case), Triangle::new(t[0], t[1], t[2]).expect("a triangle"))
        })
        .collect();
    let truth: Vec<_> = double.iter().map(|(a, t)| depth(a, t)).collect();
    let single: Vec<_> = cases.iter().map(|(case, t)| (ours(case), triangle(*t))).collect();
    let peer: Vec<_> = cases.iter().map(|(case, t)| (peer(case), of_parry(*t))).collect();
    let origin = Pose::IDENTITY;
    let mut methods = vec![
        Method {
            name: "septum, f32",
            ask: Box::new(|i| fault(truth[i], depth(&single[i].0, &single[i].1))),
        },
        Method {
            name: "septum, f64",
            ask: Box::new(|i| fault(truth[i], depth(&double[i].0, &double[i].1))),
        },
        Method {
            name: "parry3d contact",
            ask: Box::new(|i| {
                let ((at, shape), t) = &peer[i];
                let found = query::contact(at, &**shape, &origin, t, 0.0);
                fault(truth[i], found.ok().flatten().map(|contact| -f64::from(contact.dist)))
            }),
        },
    ];
    let of_spheres = |(case, t): &(CapsuleCase<f32>, _)| still(case.ends[0], case.radius, *t);
    let shots: Vec<_> = cases.iter().map(of_spheres).collect();
    let others = if are_spheres { balls(&shots) } else { Vec::new() };
    methods.extend(others.into_iter().map(|Balls { names, depth, .. }| Method {
        name: names[1],
        ask: Box::new({
            let truth = &truth;
            move |i| fault(truth[i], depth(i).map(f64::from))
        }),
    }));
    faults(title, options, cases.len(), &FAULTS, &methods);
}

/// Capsules whose ends are equal are spheres.
pub(crate) fn contacts(
    title: &str,
    options: &Options,
    are_spheres: bool,
    overlap: bool,
    case: impl Fn(&mut Rng) -> CapsuleCase<f32>,
) {
    let case = |rng: &mut Rng| loop {
        let mut case = case(rng);
        case.ends[1] = case.ends[usize::from(!are_spheres)];
        let is_triangle = matches!(case.other, Other::Triangle(_));
        if !overlap || is_triangle && case.truth().is_lt() {
            return case;
        }
    };
    let cases = with_triangle(options.pairs, case, |case| case.other);
    if are_spheres {
        race(
            title,
            options,
            are_spheres,
            &cases,
            |case| Sphere::new(case.ends[0], case.radius).expect("a sphere"),
            |case| Sphere::new(case.ends[0], case.radius).expect("a sphere"),
            |case| (Pose::from_translation(case.ends[0].into()), Box::new(Ball::new(case.radius))),
        );
    } else {
        race(
            title,
            options,
            are_spheres,
            &cases,
            |case| Capsule::new(case.ends[0], case.ends[1], case.radius).expect("a capsule"),
            |case| Capsule::new(case.ends[0], case.ends[1], case.radius).expect("a capsule"),
            |case| {
                let [a, b] = case.ends.map(Into::into);
                (Pose::IDENTITY, Box::new(ParryCapsule::new(a, b, case.radius)))
            },
        );
    }
}
