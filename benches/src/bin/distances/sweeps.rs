//! Spheres that move past triangles.

use parry3d::math::{Pose, Vector};
use parry3d::query::{ShapeCastOptions, cast_shapes};
use parry3d::shape::{Ball, Triangle as ParryTriangle};
use septum::sweep::{Motion, Sweep};
use septum::{Sphere, Triangle};
use septum_benches::native::{Balls, balls};
use septum_benches::sweep::Shot;
use septum_benches::turns::Method;
use septum_kit::spheres::{CapsuleCase, Other, SphereSweep};
use septum_kit::{Rng, Sample};

use crate::{Options, faults, of_parry, triangle, wide};

/// What may be wrong with the time of a contact.
const FAULTS: [&str; 3] = ["missed", "invented", "late"];

/// The fault of a time, by its number, or zero. A time rounded to the nearest is not counted as late.
fn fault(truth: Option<f64>, t: Option<f32>) -> u64 {
    match (truth, t) {
        (Some(_), None) => 1,
        (None, Some(_)) => 2,
        (Some(truth), Some(t)) if f64::from(t.next_down()) > truth => 3,
        _ => 0,
    }
}

/// A ball of half the size of a shot's box.
fn case(shot: &Shot) -> SphereSweep<f64> {
    let way = [[0.0; 3], wide(shot.way)];
    let other = Other::Triangle(shot.triangle.map(wide));
    SphereSweep { center: wide(shot.center), radius: shot.half[0].into(), way, other }
}

/// A shot whose ball passes the triangle at a distance of its radius, rounded, or a number beside it.
pub(crate) fn grazing(rng: &mut Rng, shot: fn(&mut Rng) -> Shot) -> Shot {
    let mut shot = shot(rng);
    let SphereSweep { center, radius, way, other } = case(&shot);
    let end = [0, 1, 2].map(|i: usize| center[i] + way[1][i]);
    let distance = CapsuleCase { ends: [center, end], radius, other }.squared().root();
    shot.half = [f32::nearest(distance).moved(rng.whole(-1, 1)).max(0.0); 3];
    shot
}

pub(crate) fn sweeps(title: &str, options: &Options, shot: impl Fn(&mut Rng) -> Shot) {
    let mut rng = Rng::new(0xba11);
    let shots: Vec<_> = (0..options.pairs).map(|_| shot(&mut rng)).collect();
    let in_f64: Vec<_> = shots
        .iter()
        .map(|shot| {
            // Stops if this answer is wrong; the others are held against it.
            case(shot).check();
            let [a, b, c] = shot.triangle.map(wide);
            let sphere = Sphere::new(wide(shot.center), shot.half[0].into()).expect("a sphere");
            let motion = Motion::new([0.0; 3], wide(shot.way)).expect("a motion");
            (sphere, motion, Triangle::new(a, b, c).expect("a triangle"))
        })
        .collect();
    let exact = |i: usize| {
        let (sphere, motion, triangle) = &in_f64[i];
        sphere.first_contact(motion, triangle).map(|first| first.t)
    };
    let truth: Vec<_> = (0..shots.len()).map(exact).collect();
    let ours: Vec<_> = shots
        .iter()
        .map(|shot| {
            let sphere = Sphere::new(shot.center, shot.half[0]).expect("a sphere");
            let motion = Motion::new([0.0; 3], shot.way).expect("a motion");
            (sphere, motion, triangle(shot.triangle))
        })
        .collect();
    let peer: Vec<_> = shots
        .iter()
        .map(|shot| {
            let at = Pose::from_translation(shot.center.into());
            (at, Ball::new(shot.half[0]), Vector::from(shot.way), of_parry(shot.triangle))
        })
        .collect();
    let (still, zero) = (Pose::IDENTITY, Vector::from([0.0; 3]));
    let cast = |at: &Pose, ball: &Ball, way: Vector, triangle: &ParryTriangle| {
        let options = ShapeCastOptions::with_max_time_of_impact(1.0);
        let hit = cast_shapes(at, way, ball, &still, zero, triangle, options);
        hit.expect("it has a cast for these").map(|hit| hit.time_of_impact)
    };
    let mut methods = vec![
        Method {
            name: "septum first_contact, f32",
            ask: Box::new(|i| {
                let (sphere, motion, triangle) = &ours[i];
                fault(truth[i], sphere.first_contact(motion, triangle).map(|first| first.t))
            }),
        },
        Method {
            name: "septum meets_along, f32",
            ask: Box::new(|i| {
                let (sphere, motion, triangle) = &ours[i];
                let meets = sphere.meets_along(motion, triangle);
                fault(truth[i], meets.then_some(0.0))
            }),
        },
        Method {
            name: "septum first_contact, f64",
            ask: Box::new(|i| u64::from(exact(i) != truth[i])),
        },
        Method {
            name: "parry3d cast_shapes",
            ask: Box::new(|i| {
                let (at, ball, way, triangle) = &peer[i];
                fault(truth[i], cast(at, ball, *way, triangle))
            }),
        },
    ];
    methods.extend(balls(&shots).into_iter().map(|Balls { names, cast, .. }| Method {
        name: names[0],
        ask: Box::new({
            let truth = &truth;
            move |i| fault(truth[i], cast(i))
        }),
    }));
    faults(title, options, shots.len(), &FAULTS, &methods);
}
