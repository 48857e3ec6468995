//! Both measurements, joined into points.

use fixed::types::{I8F8, I16F16, I32F32};
use indicatif::{ProgressBar, ProgressStyle};

use crate::accuracy::{self, Exam, Tally, examine};
use crate::candidate::Candidate;
use crate::distance::{self, Closest, OfCapsule, OfSphere};
use crate::native::NAMES;
use crate::pairs::Pairs;
use crate::race::{Timing, race};
use crate::session::Group;
use crate::unit::{F32, Form};
use crate::{
    contact, line_obb, obb_obb, ray_aabb, ray_tree, ray_triangle, sweep, triangle_aabb,
    triangle_triangle,
};

use super::point::Point;

/// The number of rays that are also tested against every triangle of a mesh.
const MOST_RAYS: usize = 2_000;

/// Counts wrong answers in four scalars.
macro_rules! in_every_scalar {
    ($what:literal, $sets:path, $cases:expr) => {{
        use $sets as sets;
        eprintln!(concat!($what, ": wrong answers"));
        let floats = [sets::<f32>("f32"), sets::<f64>("f64")].into_iter();
        Accuracy::of($cases, floats.chain([sets::<I8F8>("I8F8"), sets::<I16F16>("I16F16")]))
    }};
}

/// Every point of every picture but those of [`distances`].
pub(super) fn points(rounds: usize, cases: usize) -> Vec<Point> {
    eprintln!("triangle/box: wrong answers");
    let boxes = Accuracy::of(cases, {
        use accuracy::triangle_box_sets as sets;
        [sets::<f32>("f32"), sets::<f64>("f64"), sets::<I8F8>("I8F8"), sets::<I16F16>("I16F16")]
            .into_iter()
            .chain([sets::<I32F32>("I32F32")])
    });
    eprintln!("rays down a tree: wrong answers");
    let down = Accuracy::of(cases.min(MOST_RAYS), accuracy::ray_tree_sets());
    eprintln!("ray/triangle: wrong answers");
    let rays = Accuracy::of(cases, {
        use accuracy::ray_triangle_sets as sets;
        [sets::<f32>("f32"), sets::<f64>("f64"), sets::<I8F8>("I8F8"), sets::<I16F16>("I16F16")]
            .into_iter()
            .chain([sets::<I32F32>("I32F32")])
    });
    eprintln!("ray/box: wrong answers");
    let lines = Accuracy::of(cases, {
        use accuracy::ray_box_sets as sets;
        [sets::<f32>("f32"), sets::<f64>("f64"), sets::<I8F8>("I8F8"), sets::<I16F16>("I16F16")]
            .into_iter()
            .chain([sets::<I32F32>("I32F32")])
    });

    // Big-integer oracles are slow.
    let fewer = cases.div_ceil(10);
    let triangles = in_every_scalar!("triangle/triangle", accuracy::triangle_pair_sets, fewer);
    let obbs = in_every_scalar!("oriented boxes", accuracy::obb_sets, fewer);
    let turned = in_every_scalar!("ray/oriented box", accuracy::line_obb_sets, fewer);
    let touching = in_every_scalar!("contacts", accuracy::contact_sets, fewer);
    let moving = in_every_scalar!("sweeps", accuracy::sweep_sets, fewer);

    let mut points = Vec::new();
    let mut add = |picture: &str, timed: Vec<(Candidate, Timing)>, accuracy: &Accuracy| {
        points.extend(timed.iter().map(|(c, timing)| accuracy.point(picture, c, timing)));
    };
    let (groups, yardstick) = (mesh::groups(), mesh::yardstick);
    let timed = time("teapot in voxels", mesh::teapot(), yardstick, &groups, rounds);
    add("mesh-voxels", timed, &boxes);
    let (groups, yardstick) = (ray_tree::groups(), ray_tree::yardstick);
    let timed = time("rays down a tree", ray_tree::random(), yardstick, &groups, rounds);
    add("ray-tree", timed, &down);
    let (groups, yardstick) = (triangle_aabb::groups(), triangle_aabb::yardstick);
    let timed = time("triangle/box: Voorhies", voorhies(), yardstick, &groups, rounds);
    add("triangle-box", timed, &boxes);
    let timed = time("triangle/box: Voxel", voxel(), yardstick, &groups, rounds);
    add("triangle-box-voxel", timed, &boxes);

    let (mut groups, yardstick) = (ray_triangle::groups(), ray_triangle::yardstick);
    let half = ray_triangle::scenes::half_hit();
    let timed = time("ray/triangle: 50 % hits", half, yardstick, &groups, rounds);
    add("ray-triangle", timed, &rays);
    groups.extend(ray_triangle::groups_of_lanes());
    let many = ray_triangle::scenes::many_tenth_hit();
    let timed = time("ray/triangle: one against many", many, yardstick, &groups, rounds);
    add("ray-triangle-many", timed, &rays);

    let (mut groups, yardstick) = (ray_aabb::groups(), ray_aabb::as_published);
    let parry = |scene: &_| {
        let rays = ray_aabb::course(scene, &F32, Form::Corners);
        vec![ray_aabb::parry_cast(&rays, "parry3d cast_local_ray")]
    };
    groups.push(("f32 parry3d", Box::new(parry)));
    let half = ray_aabb::scenes::half_hit();
    let timed = time("ray/box: 50 % hits", half, yardstick, &groups, rounds);
    add("ray-box", timed, &lines);

    let (groups, yardstick) = (triangle_triangle::groups(), triangle_triangle::yardstick);
    // Its accuracy was not counted in I32F32.
    let groups: Vec<_> =
        groups.into_iter().filter(|(name, _)| !name.starts_with("I32F32")).collect();
    let half = triangle_triangle::half();
    let timed = time("triangle/triangle", half, yardstick, &groups, rounds);
    add("triangle-triangle", timed, &triangles);
    let (groups, yardstick) = (obb_obb::groups(), obb_obb::yardstick);
    let timed = time("oriented boxes", obb_obb::half(), yardstick, &groups, rounds);
    add("box-box", timed, &obbs);
    let (groups, yardstick) = (line_obb::groups(), line_obb::yardstick);
    let timed = time("ray/oriented box", line_obb::half_hit(), yardstick, &groups, rounds);
    add("ray-oriented-box", timed, &turned);
    let (groups, yardstick) = (sweep::groups(), sweep::yardstick);
    let timed = time("sweep", sweep::half(), yardstick, &groups, rounds);
    add("sweep", timed, &moving);
    let (groups, yardstick) = (contact::groups(), contact::yardstick);
    let timed = time("contact", contact::half(), yardstick, &groups, rounds);
    add("contact", timed, &touching);
    points
}

/// The points of spheres, capsules and closest points.
pub(super) fn distances(rounds: usize, cases: usize) -> Vec<Point> {
    // Big-integer oracles are slow.
    let fewer = cases.div_ceil(10);
    let mut points = Vec::new();
    macro_rules! points_of {
        ($picture:literal, $query:ty, $sets:path) => {{
            let accuracy = in_every_scalar!($picture, $sets, fewer);
            let (groups, yardstick) = (distance::groups::<$query>(), distance::yardstick::<$query>);
            let timed = time($picture, distance::random(), yardstick, &groups, rounds);
            points.extend(timed.iter().map(|(c, timing)| accuracy.point($picture, c, timing)));
        }};
    }
    points_of!("sphere-triangle", OfSphere, accuracy::sphere_sets);
    points_of!("capsule-triangle", OfCapsule, accuracy::capsule_sets);
    points_of!("closest-point", Closest, accuracy::closest_sets);
    points
}

use crate::triangle_aabb::mesh;
use crate::triangle_aabb::scenes::{voorhies, voxel};

/// Each group races against the yardstick, brings its own data, and is dropped before
/// the next.
fn time<L, R>(
    name: &str,
    scene: Pairs<L, R>,
    yardstick: fn(&Pairs<L, R>) -> Candidate,
    groups: &[Group<Pairs<L, R>>],
    rounds: usize,
) -> Vec<(Candidate, Timing)> {
    let bar = ProgressBar::new((rounds * groups.len()) as u64);
    let style = ProgressStyle::with_template("{prefix}, time {wide_bar} {msg} {eta}");
    bar.set_style(style.expect("the template is valid"));
    bar.set_prefix(name.to_owned());
    let mut timed: Vec<(Candidate, Timing)> = Vec::new();
    for (group, make) in groups {
        bar.set_message(*group);
        let mut candidates = vec![yardstick(&scene)];
        candidates.extend(make(&scene));
        let timings = race(&candidates, rounds, &bar);
        // The yardstick appears in every group; keep it once.
        let skipped = usize::from(!timed.is_empty());
        timed.extend(candidates.into_iter().zip(timings).skip(skipped));
        // The data are no longer needed.
        timed.iter_mut().for_each(|(candidate, _)| candidate.run = Box::new(|| 0));
    }
    bar.finish_and_clear();
    timed
}

/// The counts: a tally for each set and candidate.
struct Accuracy(Vec<(&'static str, Tally)>);

impl Accuracy {
    fn of(cases: usize, exams: impl Iterator<Item = Vec<Exam<&'static str>>>) -> Self {
        let exams: Vec<_> = exams.flatten().collect();
        let tallies = examine(&exams, cases);
        let labelled = exams.iter().zip(tallies);
        Self(labelled.flat_map(|(e, t)| t.into_iter().map(|t| (e.label, t))).collect())
    }

    fn point(&self, picture: &str, candidate: &Candidate, timing: &Timing) -> Point {
        let scalar = candidate.scalar.split(',').next().expect("a name");
        let (who, form) = alone(&candidate.who, candidate.form);
        let sets: Vec<_> = self
            .0
            .iter()
            .filter(|(_, t)| t.who == who && t.form == form && t.scalar == scalar && t.cases > 0)
            .collect();
        assert!(!sets.is_empty(), "{who}, {form}, {scalar}: timed, but not examined");
        let sum = |of: fn(&Tally) -> u64| sets.iter().map(|(_, t)| of(t)).sum();
        let rates = || sets.iter().map(|(set, t)| (*set, t.per_million()));
        let worst = rates().max_by(|a, b| a.1.total_cmp(&b.1)).expect("there are sets");
        let [fast, median, slow] = timing.quartiles.map(|speed| 1.0 / speed);
        Point {
            picture: picture.into(),
            test: candidate.who.clone(),
            scalar: candidate.scalar.into(),
            form: candidate.form.into(),
            peer: is_peer(&candidate.who),
            time_low: slow,
            time: median,
            time_high: fast,
            cases: sum(|t| t.cases),
            false_disjoint: sum(|t| t.false_disjoint),
            false_overlap: sum(|t| t.false_overlap),
            worst_set: if worst.1 > 0.0 { worst.0.into() } else { String::new() },
            worst: worst.1,
            mean: rates().map(|(_, rate)| rate).sum::<f64>() / sets.len() as f64,
        }
    }
}

fn is_peer(who: &str) -> bool {
    ["parry3d", "box3d", "obvhs", "bvh"].iter().chain(&NAMES).any(|peer| who.contains(peer))
}

/// The test whose accuracy counts for this one because it gives the same bits: single shapes for
/// lanes, and prepared data for shapes made on the way; and the yardsticks by their other names.
fn alone<'a>(who: &'a str, form: &'a str) -> (&'a str, &'a str) {
    let who = match who {
        "yardstick: as published" => "as published",
        "yardstick: as published (SAT)" => "as published (SAT)",
        "yardstick: 11 axes" => "11 axes",
        "yardstick: parry3d" => "parry3d",
        "yardstick: parry3d cast_ray" => "parry3d cast_ray",
        "yardstick: parry3d cast_shapes" => "parry3d cast_shapes",
        "yardstick: parry3d manifold" => "parry3d manifold",
        _ => who,
    };
    match form {
        "8 at once" if who == "exact" => ("exact hit", ""),
        "8 at once" => (who, ""),
        "8 at once, ray prepared" => (who, "ray prepared"),
        "8 at once, prepared" => (who, "triangle prepared"),
        "corners, 8 at once" => (who, "corners"),
        "on the way" if who == "exact, prepared" => ("exact", "centre"),
        "on the way" => (who, "centre"),
        _ => (who, form),
    }
}
