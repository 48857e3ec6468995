//! Time against tilt: boxes and a plate that stand on the coordinate axes, but for a tilt or for the
//! residue of a quarter turn.

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::hint::black_box;

use cpu_time::ThreadTime;
use parry3d::query::details::{intersection_test_cuboid_cuboid, intersection_test_cuboid_triangle};
use parry3d::query::{Ray as ParryRay, RayCast, contact as parry_contact};
use parry3d::shape::{TriMesh, Triangle as ParryTriangle};
use septum::contact::contact;
use septum::mesh::Tree;
use septum::{Aabb, Obb, Ray, Triangle};
use septum_kit::{Rng, Sample};

use super::Options;
use super::boxes::{Point, plus, point};
use super::picture::{LEFT, RIGHT, label};
use super::regimes::{Ticks, tens};
use crate::drawing::{Anchor, BLACK, Canvas, LIGHT, Mark, PURPLE, Scale, WIDTH, grouped};
use crate::obb_obb::{Placed, Turned, placed, turned};
use crate::peer_shapes::parry_vector;
use crate::ray_tree::{parry_mesh, tree};

/// Pairs in each scene, and rounds of which the best counts.
const PAIRS: usize = 500;
const ROUNDS: usize = 20;
/// The steps of the plate along its sides; each has two triangles.
const PLATE: [u32; 2] = [120, 80];
const PANEL: f64 = 130.0;

const STEM: &str = "tilt";
const TITLE: &str = "Time against tilt";
const CAPTION: &str = "Boxes turned about a coordinate axis, by a quarter or by any angle, and then \
    tilted: nearly parallel axes, which overlap clearly. The last panel has rays through edges of a \
    plate of 19,200 triangles, turned by a quarter and tilted. Means over 500 questions, the best of \
    20 rounds; “cargo stability” measures and draws; the figures are in tilt.csv.";

/// The methods, and the looks of their lines.
const LINES: [(&str, Mark, &str, &str); 3] = [
    ("parry3d, f32", Mark::Cross, PURPLE, ""),
    ("exact, f32", Mark::Star, BLACK, ""),
    ("exact, f64", Mark::Star, BLACK, "7 3"),
];

/// All questions of a scene to one method.
type Run = Box<dyn Fn() -> usize>;
type Scene = fn(&mut Rng, f64) -> [Run; LINES.len()];

const SCENES: [(&str, Scene); 5] = [
    ("two oriented boxes", oriented),
    ("axis-aligned and oriented box", aligned),
    ("triangle and oriented box", triangles),
    ("contact of two oriented boxes", contacts),
    ("first hit through an edge of a plate", plate),
];

fn run<T: 'static>(questions: Vec<T>, ask: impl Fn(&T) -> bool + 'static) -> Run {
    Box::new(move || questions.iter().filter(|&question| ask(black_box(question))).count())
}

fn frame(rng: &mut Rng, tilt: f64) -> [Point; 3] {
    let (mut angles, i) = ([0.0; 3], rng.below(3));
    angles[i] = if rng.one_in(2) { FRAC_PI_2 } else { rng.real(0.0, TAU) };
    angles[(i + 1) % 3] = tilt;
    turned(angles)
}

fn half(rng: &mut Rng) -> Point {
    rng.triple(|rng| rng.real(0.05, 0.65))
}

fn standing(rng: &mut Rng, tilt: f64) -> Turned {
    Turned { center: point(rng, 0.5), axes: frame(rng, tilt), half: half(rng) }
}

fn obb<S: Sample>(b: &Turned) -> Obb<S> {
    let near = |p: Point| p.map(S::nearest);
    Obb::from_skewed_axes(near(b.center), b.axes.map(near), near(b.half)).expect("a box")
}

/// Pairs of shapes that overlap.
fn overlapping<A>(rng: &mut Rng, tilt: f64, first: fn(&mut Rng, f64) -> A) -> Vec<(A, Turned)>
where
    A: Meets,
{
    let pairs = std::iter::repeat_with(|| (first(rng, tilt), standing(rng, tilt)));
    pairs.filter(|(a, b)| a.meets(&obb(b))).take(PAIRS).collect()
}

/// A shape before it is given to a method.
trait Meets {
    fn meets(&self, obb: &Obb<f64>) -> bool;
}

impl Meets for Turned {
    fn meets(&self, other: &Obb<f64>) -> bool {
        obb::<f64>(self).overlaps(other)
    }
}

impl Meets for [Point; 3] {
    fn meets(&self, obb: &Obb<f64>) -> bool {
        triangle::<f64>(self).overlaps(obb)
    }
}

fn of_parry(pairs: &[(Turned, Turned)]) -> Vec<[Placed; 2]> {
    pairs.iter().map(|(a, b)| [placed(&obb(a)), placed(&obb(b))]).collect()
}

fn oriented(rng: &mut Rng, tilt: f64) -> [Run; 3] {
    fn ours<S: Sample>(pairs: &[(Turned, Turned)]) -> Run {
        let pairs = pairs.iter().map(|(a, b)| (obb::<S>(a), obb::<S>(b))).collect();
        run(pairs, |(a, b)| a.overlaps(b))
    }
    let pairs = overlapping(rng, tilt, standing);
    [run(of_parry(&pairs), cuboids), ours::<f32>(&pairs), ours::<f64>(&pairs)]
}

fn cuboids([a, b]: &[Placed; 2]) -> bool {
    intersection_test_cuboid_cuboid(&a.pose.inv_mul(&b.pose), &a.cuboid, &b.cuboid)
}

fn aligned(rng: &mut Rng, tilt: f64) -> [Run; 3] {
    fn ours<S: Sample>(pairs: &[(Turned, Turned)]) -> Run {
        let aabb = |b: &Turned| {
            let (center, half) = (b.center.map(S::nearest), b.half.map(S::nearest));
            Aabb::from_center_half_extents(center, half).expect("a box")
        };
        run(pairs.iter().map(|(a, b)| (aabb(a), obb(b))).collect(), |(a, b)| a.overlaps(b))
    }
    let upright = |rng: &mut Rng, _| Turned { axes: turned([0.0; 3]), ..standing(rng, 0.0) };
    let pairs = overlapping(rng, tilt, upright);
    [run(of_parry(&pairs), cuboids), ours::<f32>(&pairs), ours::<f64>(&pairs)]
}

fn triangle<S: Sample>(vertices: &[Point; 3]) -> Triangle<S> {
    let [a, b, c] = vertices.map(|p| p.map(S::nearest));
    Triangle::new(a, b, c).expect("finite")
}

/// With two edges along coordinate axes.
fn upright(rng: &mut Rng, _: f64) -> [Point; 3] {
    let (center, i) = (point(rng, 0.4), rng.below(3));
    let [x, y] = [(); 2].map(|()| rng.real(0.3, 1.0));
    [[-x, -y], [x, -y], [-x, y]].map(|[x, y]| {
        let mut by = [0.0; 3];
        (by[i], by[(i + 1) % 3]) = (x, y);
        plus(center, by)
    })
}

fn triangles(rng: &mut Rng, tilt: f64) -> [Run; 3] {
    fn ours<S: Sample>(pairs: &[([Point; 3], Turned)]) -> Run {
        let pairs = pairs.iter().map(|(t, b)| (triangle::<S>(t), obb(b))).collect();
        run(pairs, |(t, b)| t.overlaps(b))
    }
    let pairs = overlapping(rng, tilt, upright);
    let peers = pairs.iter().map(|(t, b)| {
        let corners = triangle::<f32>(t).vertices().map(parry_vector);
        (ParryTriangle::from(corners), placed(&obb(b)))
    });
    let parry = run(peers.collect(), |(t, b)| {
        intersection_test_cuboid_triangle(&b.pose.inverse(), &b.cuboid, t)
    });
    [parry, ours::<f32>(&pairs), ours::<f64>(&pairs)]
}

fn contacts(rng: &mut Rng, tilt: f64) -> [Run; 3] {
    fn ours<S: Sample>(pairs: &[(Turned, Turned)]) -> Run {
        let pairs = pairs.iter().map(|(a, b)| (obb::<S>(a), obb::<S>(b))).collect();
        run(pairs, |(a, b)| black_box(contact(a, b)).is_some())
    }
    let pairs = overlapping(rng, tilt, standing);
    let parry = run(of_parry(&pairs), |[a, b]| {
        let found = parry_contact(&a.pose, &a.cuboid, &b.pose, &b.cuboid, 0.0);
        black_box(found).is_ok_and(|contact| contact.is_some())
    });
    [parry, ours::<f32>(&pairs), ours::<f64>(&pairs)]
}

fn plate(rng: &mut Rng, tilt: f64) -> [Run; 3] {
    let frame = turned([FRAC_PI_2, tilt, 0.0]);
    let turn = |p: Point| [0, 1, 2].map(|i: usize| (0..3).map(|k| p[k] * frame[k][i]).sum::<f64>());
    let [columns, rows] = PLATE;
    let at = |i: f64, j: f64| [0.025 * i - 1.5, 0.025 * j - 1.0, 0.3];
    let corners: Vec<Point> =
        (0..=columns).flat_map(|i| (0..=rows).map(move |j| turn(at(i.into(), j.into())))).collect();
    let corner = |i: u32, j: u32| i * (rows + 1) + j;
    let faces: Vec<[u32; 3]> = (0..columns)
        .flat_map(|i| (0..rows).map(move |j| [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]))
        .flat_map(|[a, b, c, d]| {
            let [a, b, c, d] = [a, b, c, d].map(|(i, j)| corner(i, j));
            [[a, b, c], [a, c, d]]
        })
        .collect();
    let aimed = || {
        let [i, j] = PLATE.map(|n| rng.below(n as usize) as f64);
        let target = at(i + rng.real(0.1, 0.9), j);
        let origin = [rng.real(-1.0, 1.0), rng.real(-1.0, 1.0), rng.real(0.8, 1.5)];
        let (target, origin) = (turn(target), turn(origin));
        (origin, [0, 1, 2].map(|i| target[i] - origin[i]))
    };
    let rays: Vec<(Point, Point)> = std::iter::repeat_with(aimed).take(PAIRS).collect();

    fn built<S: Sample>(corners: &[Point], faces: &[[u32; 3]]) -> Tree<'static, S, u32> {
        let vertices = corners.iter().map(|p| p.map(S::nearest).into()).collect();
        tree(vertices, faces).expect("a mesh").0
    }
    fn in_scalar<S: Sample>(rays: &[(Point, Point)]) -> Vec<Ray<S>> {
        let ray = |(o, d): &(Point, Point)| Ray::new(o.map(S::nearest), d.map(S::nearest));
        rays.iter().map(|r| ray(r).expect("a ray")).collect()
    }
    fn ours<S: Sample>(tree: Tree<'static, S, u32>, rays: &[(Point, Point)]) -> Run {
        run(in_scalar::<S>(rays), move |ray| black_box(tree.first_hit(ray)).is_some())
    }
    let single = built::<f32>(&corners, &faces);
    let peer: TriMesh = parry_mesh(single.mesh()).expect("a mesh");
    let peers = in_scalar::<f32>(&rays).iter().map(crate::peer_shapes::parry_ray).collect();
    let parry = run(peers, move |ray: &ParryRay| {
        black_box(peer.cast_local_ray(ray, f32::MAX, false)).is_some()
    });
    [parry, ours(single, &rays), ours(built::<f64>(&corners, &faces), &rays)]
}

/// The means in ns; all methods take turns.
fn measure(runs: &[Run; LINES.len()]) -> [f64; LINES.len()] {
    let mut best = [f64::INFINITY; LINES.len()];
    for _ in 0..ROUNDS {
        for (run, best) in runs.iter().zip(&mut best) {
            let start = ThreadTime::now();
            black_box(run());
            *best = best.min(start.elapsed().as_secs_f64());
        }
    }
    best.map(|seconds| seconds * 1e9 / PAIRS as f64)
}

/// Measures, and draws a picture with a panel for each scene.
pub(super) fn draw(options: &Options) -> Result<(), Box<dyn Error>> {
    let steps = tens(-32, -1, 1);
    let path = options.out.join("tilt.csv");
    let mut table =
        csv::Writer::from_path(&path).map_err(|e| format!("{}: {e}", path.display()))?;
    table.write_record(["scene", "tilt", "test", "ns"])?;

    let mut canvas = Canvas::new(WIDTH, 1200.0);
    canvas.bold([12.0, 26.0], 18.0, Anchor::Start, BLACK, TITLE);
    let mut y = canvas.paragraph([16.0, 48.0], WIDTH - 32.0, 12.5, CAPTION) + 12.0;
    let top = y;
    let across = Scale {
        values: [steps[0], *steps.last().expect("steps")],
        pixels: [LEFT + 8.0, RIGHT - 8.0],
    };
    for (name, scene) in SCENES {
        let mut times = Vec::new();
        for &tilt in &steps {
            let means = measure(&scene(&mut Rng::new(0x711 ^ tilt.to_bits()), tilt));
            for (mean, (line, ..)) in means.iter().zip(LINES) {
                table.write_record([name, &format!("{tilt:e}"), line, &format!("{mean:.0}")])?;
            }
            times.push(means);
        }
        panel(&mut canvas, name, &across, &steps, &times, y);
        y += PANEL + 62.0;
    }
    canvas.upright([12.0, (top + y) / 2.0], 12.0, BLACK, "ns per question");
    canvas.text([(LEFT + RIGHT) / 2.0, y], 12.0, Anchor::Middle, BLACK, "tilt, as an angle");
    canvas.crop(y + 16.0);
    canvas.save(&options.out.join(STEM))?;
    Ok(table.flush()?)
}

fn panel(
    canvas: &mut Canvas,
    name: &str,
    across: &Scale,
    steps: &[f64],
    times: &[[f64; LINES.len()]],
    top: f64,
) {
    let all = || times.as_flattened().iter().copied();
    let least = 10_f64.powf(all().fold(f64::INFINITY, f64::min).log10().floor());
    let most = 10_f64.powf(all().fold(0.0, f64::max).log10().ceil());
    let y = Scale { values: [least, most], pixels: [top + 22.0 + PANEL, top + 22.0] };
    canvas.bold([LEFT, top + 14.0], 13.0, Anchor::Start, BLACK, name);
    for time in y.powers(10.0) {
        canvas.line([LEFT, y.at(time)], [RIGHT, y.at(time)], LIGHT, 0.6, "");
        canvas.text([LEFT - 5.0, y.at(time) + 3.5], 9.5, Anchor::End, BLACK, &grouped(time));
    }
    for &step in steps {
        if let Some(text) = Ticks::Ten(4).text(step) {
            let x = across.at(step);
            canvas.line([x, y.pixels[1]], [x, y.pixels[0]], LIGHT, 0.6, "");
            canvas.text([x, y.pixels[0] + 14.0], 11.0, Anchor::Middle, BLACK, &text);
        }
    }
    let mut ends = Vec::new();
    for (k, (text, mark, color, dash)) in LINES.into_iter().enumerate() {
        let path: Vec<[f64; 2]> =
            steps.iter().zip(times).map(|(&s, t)| [across.at(s), y.at(t[k])]).collect();
        canvas.polyline(&path, color, 1.6, dash);
        for point in path.iter().skip(2 * k).step_by(6) {
            mark.draw(canvas, *point, 3.6, color, true);
        }
        ends.extend(path.last().map(|&end| (end, text, color)));
    }
    label(canvas, ends, [top + 18.0, y.pixels[0]]);
}
