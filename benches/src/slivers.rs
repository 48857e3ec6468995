//! Pictures of the near-degenerate normal: the verdicts of every method on a family of slivers,
//! with a pixel for each.

use std::error::Error;
use std::fmt::Write;
use std::path::PathBuf;

use clap::Args;

use crate::accuracy::{triangle_box, triangle_box_peers};
use crate::candidate::Candidate;
use crate::drawing::{Anchor, BLACK, Canvas, GREY, WIDTH, grouped};
use septum_kit::{BoxNumbers, Case, Sample, meets};

/// Draws the verdicts of every method on slivers whose one vertex moves by single units in the last
/// place.
#[derive(Args)]
pub struct Options {
    /// The picture, without its extension
    #[arg(long, value_name = "STEM", default_value = "docs/experiments/slivers")]
    out: PathBuf,
}

/// Pixels of a map along each side.
const SIDE: i64 = 128;
const CELL: f64 = 1.6;
const GAP: f64 = 12.0;

// The classes differ in lightness: right verdicts are pale, wrong ones dark.
const CLASSES: [(&str, &str); 4] = [
    ("right: they meet", "#BBDDEE"),
    ("right: they are apart", "#FFFFEE"),
    ("wrong: said to be apart", "#000000"),
    ("wrong: said to meet", "#D55E00"),
];

/// Runs all methods, and draws.
pub fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    eprintln!("{} slivers, every method", SIDE * SIDE);
    let cases: Vec<Case<f32>> = (0..SIDE * SIDE).map(sliver).collect();
    let truth: Vec<bool> = cases.iter().map(meets).collect();
    let mut candidates = triangle_box("f32", &cases);
    candidates.extend(triangle_box_peers("f32", &cases));
    let wanted = [
        ("exact", "septum: exact"),
        ("conservative", "septum: conservative"),
        ("rounded", "septum: rounded"),
        ("as published", "as published in 2001"),
        ("box3d-rust test_bounds_triangle_overlap", "box3d-rust"),
        ("parry3d …_cuboid_triangle", "parry3d"),
    ];
    let find = |who: &str| -> &Candidate {
        let same = |c: &&Candidate| c.who == who && c.form == "centre";
        candidates.iter().find(same).expect("there is such a test")
    };
    let mut maps = vec![("the truth, by clipping", truth.clone())];
    maps.extend(wanted.map(|(who, name)| (name, find(who).answers.clone())));

    let mut canvas = Canvas::new(WIDTH, 720.0);
    canvas.bold([12.0, 26.0], 18.0, Anchor::Start, BLACK, "Slivers");
    let subtitle = "A pixel is a triangle and a box: does the method say right whether they meet?";
    canvas.text([100.0, 26.0], 13.0, Anchor::Start, BLACK, subtitle);
    let side = SIDE as f64 * CELL;
    for (n, (name, answers)) in maps.iter().enumerate() {
        let left = 16.0 + (n % 4) as f64 * (side + GAP);
        let top = 66.0 + (n / 4) as f64 * (side + 52.0);
        let wrong = answers.iter().zip(&truth).filter(|(a, b)| a != b).count();
        canvas.bold([left, top - 20.0], 12.5, Anchor::Start, BLACK, name);
        let share = format!("{} of {} wrong", grouped(wrong as f64), grouped(answers.len() as f64));
        let share = if n == 0 { "what all should be".into() } else { share };
        canvas.text([left, top - 6.0], 11.0, Anchor::Start, BLACK, &share);
        map(&mut canvas, answers, &truth, [left, top]);
        if n > 0 && name.ends_with(": exact") && wrong > 0 {
            return Err("the exact method was wrong".into());
        }
    }
    let (left, top) = (16.0 + 3.0 * (side + GAP), 66.0 + side + 52.0);
    legend(&mut canvas, [left, top]);
    let caption = "f32. Two vertices of the triangle and the box stay where they are. The third \
        vertex lies on the line through the two, where it can: across it is moved by units in the \
        last place in y, up in z, 64 to either side. So the triangle is at most 91 \
        units in the last place wide, and its computed normal is mostly rounding. The box is small \
        and far from the vertex to which that normal is applied; its corner touches the long edge \
        along the two sides of the pale blue field. The conservative method may say “meet” where \
        shapes come that near, never “apart” where they meet. “cargo slivers” asks and draws.";
    let y = canvas.paragraph([16.0, top + side + 26.0], WIDTH - 32.0, 12.0, caption);
    canvas.crop(y);
    canvas.save(&options.out)
}

/// The sliver of a pixel, counted from the upper left.
fn sliver(pixel: i64) -> Case<f32> {
    let (across, up) = (pixel % SIDE - SIDE / 2, SIDE / 2 - 1 - pixel / SIDE);
    let (a, b) = ([-1.1_f32, -0.7, 0.3], [0.9_f32, 0.6, -0.35]);
    let along = |t: f32| [0, 1, 2].map(|i| a[i] + t * (b[i] - a[i]));
    let [x, y, z] = along(1.45);
    let c = [x, y.moved(across), z.moved(up)];
    // A small box far along the line. Its corner lies nearly on the line, on the side where the
    // line does not enter the box.
    let (corner, half) = (along(1.2), [0.003_f32; 3]);
    let nearer = 1.5e-6;
    let center = [corner[0] + half[0], corner[1] - half[1] + nearer, corner[2] + half[2] - nearer];
    Case { vertices: [a, b, c], aabb: BoxNumbers::Center(center, half) }
}

/// A rectangle for each run of pixels of one class, one path for each class.
fn map(canvas: &mut Canvas, answers: &[bool], truth: &[bool], [left, top]: [f64; 2]) {
    let class = |n: usize| match (answers[n], truth[n]) {
        (true, true) => 0,
        (false, false) => 1,
        (false, true) => 2,
        (true, false) => 3,
    };
    let side = SIDE as usize;
    let mut paths = [const { String::new() }; 4];
    for y in 0..side {
        let mut x = 0;
        while x < side {
            let here = class(y * side + x);
            let run = (x..side).take_while(|&x| class(y * side + x) == here).count();
            write!(paths[here], "M{x} {y}h{run}v1h-{run}z").expect("a string takes all");
            x += run;
        }
    }
    for (data, (_, color)) in paths.into_iter().zip(CLASSES) {
        canvas.pixels(data, color, [left, top], CELL);
    }
    let size = SIDE as f64 * CELL;
    let (right, bottom) = (left + size, top + size);
    let frame = [[left, top], [right, top], [right, bottom], [left, bottom], [left, top]];
    canvas.polyline(&frame, GREY, 0.8, "");
}

fn legend(canvas: &mut Canvas, [left, top]: [f64; 2]) {
    for (n, (name, color)) in CLASSES.iter().enumerate() {
        let y = top + 24.0 + 30.0 * n as f64;
        canvas.rect([left, y], [20.0, 20.0], color);
        let (right, bottom) = (left + 20.0, y + 20.0);
        let frame = [[left, y], [right, y], [right, bottom], [left, bottom], [left, y]];
        canvas.polyline(&frame, GREY, 0.8, "");
        canvas.text([left + 28.0, y + 14.5], 12.5, Anchor::Start, BLACK, name);
    }
}
