//! The rounded methods of ray against triangle: right in easy cases, closed, and free of panics in
//! hopeless ones; and the watertight method leaves no gap.

use septum::published;
use septum::published::projected::ProjectedTriangle;
use septum::published::stored_normal::NormalTriangle;
use septum::published::watertight::ShearedRay;
use septum::{Cull, Facing, Feature, Hit, Ray, Triangle};
use septum_kit::{Each, Rng, Sample, for_every_scalar, three};

for_every_scalar!(
    all_agree_with_the_exact_hit,
    culling_and_range,
    touching_is_a_hit,
    flat_triangles_have_none,
    extremes_are_quiet,
    no_gap_along_an_edge,
    no_gap_around_a_vertex,
);

type Method<S> = fn(&Ray<S>, &Triangle<S>, Cull) -> Option<Hit<S>>;

fn methods<S: Sample>() -> [(&'static str, Method<S>); 5] {
    [
        ("moller_trumbore", |r, t, cull| published::moller_trumbore::hit(r, t, cull)),
        ("stored_normal", |r, t, cull| {
            published::stored_normal::hit(r, &NormalTriangle::new(t), cull)
        }),
        ("projected", |r, t, cull| published::projected::hit(r, &ProjectedTriangle::new(t), cull)),
        ("volumes", |r, t, cull| published::volumes::hit(r, t, cull)),
        ("sheared", |r, t, cull| ShearedRay::new(r).hit(t, cull)),
    ]
}

fn at<S: Sample>(x: [f64; 3]) -> [S; 3] {
    x.each(S::nearest)
}

fn triangle<S: Sample>(points: [[f64; 3]; 3]) -> Triangle<S> {
    let [a, b, c] = points;
    Triangle::new(at(a), at(b), at(c)).unwrap()
}

fn ray<S: Sample>(origin: [f64; 3], direction: [f64; 3]) -> Ray<S> {
    Ray::new(at(origin), at(direction)).unwrap()
}

/// The permitted error of a quotient of numbers of about one: a few hundred units of the last
/// place. An eighth in 8 bits leaves nothing to compare.
fn tolerance<S: Sample>() -> f64 {
    let one = S::nearest(1.0);
    500.0 * (one.moved(1).approximate() - one.approximate())
}

fn mix([a, b, c]: [[f64; 3]; 3], [w, u, v]: [f64; 3]) -> [f64; 3] {
    three(|i| w * a[i] + u * b[i] + v * c[i])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn normal([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    let [p, q] = [b, c].each(|x| [x[0] - a[0], x[1] - a[1], x[2] - a[2]]);
    [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
}

/// Fat triangles, steep rays, points well inside or well outside.
fn all_agree_with_the_exact_hit<S: Sample>() {
    let rng = &mut Rng::new(1);
    let (mut hits, mut misses) = (0, 0);
    while hits + misses < 20_000 {
        let points = rng.triple(|rng| rng.triple(|rng| rng.real(-1.5, 1.5)));
        let n = normal(points);
        let (u, v) = (rng.real(-0.5, 1.5), rng.real(-0.5, 1.5));
        let weights = [1.0 - u - v, u, v];
        let origin = rng.triple(|rng| rng.real(-1.5, 1.5));
        let target = mix(points, weights);
        let direction = three(|i| target[i] - origin[i]);
        let steep = dot(n, direction).abs() / (dot(n, n) * dot(direction, direction)).sqrt();
        let clear = weights.iter().all(|w| w.abs() > 0.1);
        let small = direction.iter().all(|d| d.abs() < 2.0);
        if dot(n, n) < 0.5
            || steep.is_nan()
            || steep < 0.5
            || !clear
            || !small
            || dot(n, direction).abs() < 0.5
        {
            continue;
        }
        let (ray, triangle) = (ray::<S>(origin, direction), triangle::<S>(points));
        let exact = ray.hit(&triangle);
        for (name, method) in methods::<S>() {
            // Four fraction bits are too few for any point to be well inside.
            if S::name() == "I4F4" {
                method(&ray, &triangle, Cull::Nothing);
                continue;
            }
            let hit = method(&ray, &triangle, Cull::Nothing);
            let context = || format!("{name} {ray:?} {triangle:?}\n{hit:?}\n{exact:?}");
            assert_eq!(hit.is_some(), exact.is_some(), "{}", context());
            let (Some(hit), Some(exact)) = (hit, exact) else { continue };
            assert_eq!((hit.facing, hit.feature), (exact.facing, exact.feature), "{}", context());
            for (x, y) in [(hit.t, exact.t), (hit.u, exact.u), (hit.v, exact.v)] {
                let error = (x.approximate() - y.approximate()).abs();
                assert!(error <= tolerance::<S>(), "{error} {}", context());
            }
        }
        if exact.is_some() { hits += 1 } else { misses += 1 }
    }
    assert!(hits > 2_000 && misses > 2_000, "{hits} {misses}");
}

fn culling_and_range<S: Sample>() {
    let floor = triangle::<S>([[0.0; 3], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]]);
    let down = ray::<S>([0.5, 0.5, 1.5], [0.0, 0.0, -1.0]);
    let up = ray::<S>([0.5, 0.5, -1.5], [0.0, 0.0, 1.0]);
    for (name, method) in methods::<S>() {
        let facing = |ray, cull| method(ray, &floor, cull).map(|hit| hit.facing);
        assert_eq!(facing(&down, Cull::Nothing), Some(Facing::Front), "{name}");
        assert_eq!(facing(&down, Cull::Back), Some(Facing::Front), "{name}");
        assert_eq!(facing(&down, Cull::Front), None, "{name}");
        assert_eq!(facing(&up, Cull::Nothing), Some(Facing::Back), "{name}");
        assert_eq!(facing(&up, Cull::Front), Some(Facing::Back), "{name}");
        assert_eq!(facing(&up, Cull::Back), None, "{name}");

        let far = S::nearest(1.5);
        let t = |min: Option<S>, max: Option<S>| {
            let ray = down.with_range(min, max).unwrap();
            method(&ray, &floor, Cull::Nothing).map(|hit| hit.t)
        };
        assert_eq!(t(Some(far), Some(far)), Some(far), "{name}");
        assert_eq!(t(None, None), Some(far), "{name}");
        assert_eq!(t(None, Some(far.moved(-1))), None, "{name}");
        assert_eq!(t(Some(far.moved(1)), None), None, "{name}");
        let away = ray::<S>([0.5, 0.5, 1.5], [0.0, 0.0, 1.0]);
        assert!(method(&away, &floor, Cull::Nothing).is_none(), "{name}");
        let line = away.with_range(None, None).unwrap();
        assert_eq!(method(&line, &floor, Cull::Nothing).unwrap().t, S::nearest(-1.5), "{name}");
    }
}

/// Every point of a grid on a triangle, where all arithmetic is exact.
fn touching_is_a_hit<S: Sample>() {
    let points = [[0.0; 3], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]];
    for turn in 0..3 {
        let turned = |p: [f64; 3]| [p[turn], p[(turn + 1) % 3], p[(turn + 2) % 3]];
        let triangle = triangle::<S>(points.each(turned));
        for (i, j) in (-1..=5).flat_map(|i| (-1..=5).map(move |j| (i, j))) {
            let (x, y) = (f64::from(i) / 2.0, f64::from(j) / 2.0);
            let (u, v, w) = (i, j, 4 - i - j);
            let feature = match (w == 0, u == 0, v == 0) {
                (false, true, true) => Feature::Vertex(0),
                (true, false, true) => Feature::Vertex(1),
                (true, true, false) => Feature::Vertex(2),
                (false, false, true) => Feature::Edge(0),
                (true, false, false) => Feature::Edge(1),
                (false, true, false) => Feature::Edge(2),
                _ => Feature::Interior,
            };
            let ray = ray::<S>(turned([x, y, 1.0]), turned([0.0, 0.0, -1.0]));
            for (name, method) in methods::<S>() {
                let hit = method(&ray, &triangle, Cull::Nothing).map(|hit| hit.feature);
                let expected = (u >= 0 && v >= 0 && w >= 0).then_some(feature);
                assert_eq!(hit, expected, "{name} {x} {y} {turn}");
            }
        }
    }
}

fn flat_triangles_have_none<S: Sample>() {
    let rng = &mut Rng::new(2);
    for _ in 0..10_000 {
        let whole = |rng: &mut Rng| rng.whole(-1, 1) as f64;
        let (p, e) = (rng.triple(whole), rng.triple(whole));
        let on = |k: f64| three(|i| p[i] + k * e[i]);
        let flat = triangle::<S>([p, on(whole(rng)), on(2.0 * whole(rng))]);
        let d = rng.triple(whole);
        if d == [0.0; 3] {
            continue;
        }
        let ray = ray::<S>(rng.triple(whole), d);
        for (name, method) in methods::<S>() {
            assert_eq!(method(&ray, &flat, Cull::Nothing), None, "{name} {ray:?} {flat:?}");
        }
    }
}

/// Coordinates at the ends of the range and near zero: no panic, and a hit has finite numbers, with
/// t in the range.
fn extremes_are_quiet<S: Sample>() {
    let zero = S::ZERO;
    let values = [
        S::LEAST,
        S::GREATEST,
        S::LEAST.moved(1),
        zero,
        zero.moved(1),
        zero.moved(-1),
        S::nearest(1.0),
        S::nearest(-1.0),
        S::GREATEST.between(zero),
    ];
    let rng = &mut Rng::new(3);
    for _ in 0..50_000 {
        let mut point = || rng.triple(|rng| values[rng.below(values.len())]);
        let triangle = Triangle::new(point(), point(), point()).unwrap();
        let Ok(ray) = Ray::new(point(), point()) else { continue };
        let line = ray.with_range(None, None).unwrap();
        for (name, method) in methods::<S>() {
            for ray in [ray, line] {
                let Some(hit) = method(&ray, &triangle, Cull::Nothing) else { continue };
                let numbers = [hit.t, hit.u, hit.v].iter().all(|x| x.is_finite());
                assert!(numbers, "{name} {ray:?} {triangle:?} {hit:?}");
                assert!(ray.t_min().is_none_or(|t| hit.t >= t), "{name} {ray:?} {triangle:?}");
            }
        }
    }
}

/// Rays toward the edge that two triangles share, seen closed by the ray: one triangle is hit,
/// however thin, small or far away.
fn no_gap_along_an_edge<S: Sample>() {
    // With four fraction bits the rounded ray may pass both triangles.
    if S::name() == "I4F4" {
        return;
    }
    let rng = &mut Rng::new(4);
    for case in 0..40_000 {
        let (scene, far) = scene::<S>(case);
        let mut point = || at::<S>(rng.triple(|rng| far + rng.real(-scene, scene)));
        let (p, q, o) = (point(), point(), point());
        let share = rng.real(0.0, 1.0);
        let target = three(|i| p[i].approximate() * (1.0 - share) + q[i].approximate() * share);
        let d = three(|i| target[i] - o[i].approximate());
        // Sideways from the edge, on either side of the plane of ray and edge.
        let edge = three(|i| q[i].approximate() - p[i].approximate());
        let side = normal([[0.0; 3], edge, d]);
        let length = dot(side, side).sqrt();
        let direction = at::<S>(d);
        let Ok(ray) = Ray::new(o, direction) else { continue };
        if length < 0.2 * scene * scene || dot(d, d) < 0.2 * scene * scene {
            continue;
        }
        let apart = |k: f64| at::<S>(three(|i| target[i] + k * scene * side[i] / length));
        let (left, right) = (apart(rng.real(0.2, 0.9)), apart(-rng.real(0.2, 0.9)));
        let sheared = ShearedRay::new(&ray.with_range(None, None).unwrap());
        let met = [[p, q, left], [q, p, right]].iter().any(|&[a, b, c]| {
            let turned = [[a, b, c], [b, c, a], [c, a, b]][case % 3];
            let triangle = Triangle::new(turned[0], turned[1], turned[2]).unwrap();
            sheared.hit(&triangle, Cull::Nothing).is_some()
        });
        // The ray may pass the edge beyond its ends.
        let inside = share > 0.1 && share < 0.9;
        assert!(met || !inside, "{p:?} {q:?} {left:?} {right:?} {ray:?}");
    }
}

/// The extent of a scene and its distance from the origin. In the smallest scenes all products of
/// two coordinates are rounded to zero.
fn scene<S: Sample>(case: usize) -> (f64, f64) {
    match S::name().as_str() {
        "I4F4" => (1.0, 0.0),
        "I8F8" => [(3.0, 0.0), (3.0, 90.0)][case % 2],
        "I16F16" => [(60.0, 0.0), (4.0, 0.0), (60.0, 30_000.0), (0.003, 0.0)][case % 4],
        "I32F32" => [(9000.0, 0.0), (1.0, 0.0), (1.0, 1e6)][case % 3],
        _ => [(1.0, 0.0), (1.0, 1e4), (1e-25, 0.0), (1e15, 0.0)][case % 4],
    }
}

/// Rays toward the middle of a closed fan.
fn no_gap_around_a_vertex<S: Sample>() {
    let rng = &mut Rng::new(5);
    for case in 0..20_000 {
        let (scene, far) = scene::<S>(case);
        let mut point = |size: f64| rng.triple(|rng| far + size * rng.real(-scene, scene));
        let (origin, target) = (at::<S>(point(1.0)), at::<S>(point(1.0)));
        let along = three(|i| target[i].approximate() - origin[i].approximate());
        let d = three(|i| S::nearest(along[i]));
        let Ok(ray) = Ray::new(origin, d) else { continue };
        if dot(along, along) < 0.5 * scene * scene {
            continue;
        }
        // Two directions across the ray, and spokes all around.
        let least = (0..3).min_by(|&i, &j| along[i].abs().total_cmp(&along[j].abs())).unwrap();
        let mut any = [0.0; 3];
        any[least] = scene;
        let x = normal([[0.0; 3], along, any]);
        let y = normal([[0.0; 3], along, x]);
        let unit = |v: [f64; 3]| v.each(|c| c / dot(v, v).sqrt());
        let (x, y) = (unit(x), unit(y));
        let rim: Vec<[S; 3]> = (0..6)
            .map(|k| {
                let (sin, cos) = (f64::from(k) * std::f64::consts::FRAC_PI_3).sin_cos();
                let reach = scene * rng.real(0.3, 0.8);
                at(three(|i| target[i].approximate() + reach * (cos * x[i] + sin * y[i])))
            })
            .collect();
        let sheared = ShearedRay::new(&ray.with_range(None, None).unwrap());
        let met = (0..6).any(|k| {
            let triangle = Triangle::new(target, rim[k], rim[(k + 1) % 6]).unwrap();
            sheared.hit(&triangle, Cull::Nothing).is_some()
        });
        assert!(met, "{target:?} {rim:?} {ray:?}");
    }
}
