//! One picture: a query on a workload, a row for each scalar.

use std::error::Error;
use std::path::Path;

use crate::drawing::{
    Anchor, BLACK, Canvas, GREY, LIGHT, Labels, PALE, PURPLE, Place, Scale, WIDTH, Zeroed, grouped,
    short, width_of,
};

use super::legend;
use super::point::Point;
use super::style::{families, label, look};

/// What it is called, and what it shows.
pub(super) struct Picture {
    pub(super) stem: &'static str,
    title: &'static str,
    workload: &'static str,
    yardstick: &'static str,
    sets: &'static str,
    /// Pixels for a row with peers, and for one without.
    rows: [f64; 2],
}

const BOXES: &str = "tests/support/sets.rs";
const RAYS: &str = "tests/support/rays/sets.rs";
const LINES: &str = "tests/support/ray_boxes.rs";
const PUBLISHED: &str = "the test as published in 2001, in f32";
const IN_C: &str = "Möller–Trumbore as in C, in f32";

impl Picture {
    pub(super) const ALL: [Self; 5] = [
        Self {
            stem: "triangle-box",
            title: "Triangle and box",
            workload: "Random triangles against one box, half of them meet it (Voorhies).",
            yardstick: PUBLISHED,
            sets: BOXES,
            rows: [250.0, 175.0],
        },
        Self {
            stem: "triangle-box-voxel",
            title: "Triangle and voxels",
            workload: "Triangles against the cubes in their bounding boxes, a quarter of them meet.",
            yardstick: PUBLISHED,
            sets: BOXES,
            rows: [250.0, 175.0],
        },
        Self {
            stem: "ray-triangle",
            title: "Ray and triangle",
            workload: "Random pairs, half of them meet.",
            yardstick: IN_C,
            sets: RAYS,
            rows: [330.0, 250.0],
        },
        Self {
            stem: "ray-triangle-many",
            title: "One ray, many triangles",
            workload: "Each ray against 1,000 triangles, one in ten is hit; ×8: eight at once.",
            yardstick: IN_C,
            sets: RAYS,
            rows: [360.0, 290.0],
        },
        Self {
            stem: "ray-box",
            title: "Ray and box",
            workload: "Each ray against 1,000 boxes, half of them meet; by corners, but where centre is said.",
            yardstick: "the SAT test of Real-Time Rendering 16.7 in f32 (overlaps_as_published)",
            sets: LINES,
            rows: [310.0, 250.0],
        },
    ];

    /// Draws and saves it.
    pub(super) fn draw(&self, points: &[&Point], folder: &Path) -> Result<(), Box<dyn Error>> {
        let rows: Vec<&[&Point]> = points.chunk_by(|a, b| a.scalar == b.scalar).collect();
        let rows = gathered(&rows);
        let [left, right] = [64.0, WIDTH - 12.0];
        let x = Scale { values: reach(points), pixels: [left, right] };
        let height = |row: &Vec<&Point>| {
            let lanes = lanes(row, &x).1 as f64 * LANE + 8.0;
            lanes + self.rows[usize::from(!row.iter().any(|p| p.peer))]
        };
        let total: f64 = rows.iter().map(height).sum();
        let mut canvas = Canvas::new(WIDTH, total + 290.0);

        canvas.bold([12.0, 26.0], 18.0, Anchor::Start, BLACK, self.title);
        let at = 22.0 + width_of(self.title, 18.0) * 1.12;
        canvas.text([at, 26.0], 13.0, Anchor::Start, BLACK, self.workload);
        let mut y = legend::draw(&mut canvas, &families(points), 16.0, right, 50.0) + 24.0;
        let top = y;
        for row in &rows {
            let end = y + height(row);
            self.row(&mut canvas, row, &x, [y, end]);
            y = end;
        }
        self.peers_line(&mut canvas, points, &x, [top, y]);
        for tick in x.powers(2.0) {
            canvas.text([x.at(tick), y + 16.0], 12.0, Anchor::Middle, BLACK, &short(tick));
        }
        let axis = format!("time per query; 1 is {}", self.yardstick);
        canvas.text([(left + right) / 2.0, y + 34.0], 12.0, Anchor::Middle, BLACK, &axis);
        let middle = (top + y) / 2.0;
        canvas.upright([14.0, middle], 12.0, BLACK, "wrong answers per million");
        self.caption(&mut canvas, points, y + 58.0);
        canvas.save(&folder.join(self.stem))
    }

    fn row(&self, canvas: &mut Canvas, row: &[&Point], x: &Scale, [top, bottom]: [f64; 2]) {
        let (lane_of, lanes) = lanes(row, x);
        let y = Zeroed::new(top + 16.0, bottom - 6.0, lanes as f64 * LANE + 2.0);
        grid(canvas, x, &y, [top, bottom]);
        let name = &row[0].scalar;
        let wide = width_of(name, 13.0) * 1.15 + 12.0;
        let heading = [x.pixels[0] + 1.0, y.rates.at(3.2), x.pixels[0] + wide, y.rates.at(1.0)];
        canvas.bold([x.pixels[0] + 7.0, y.rates.at(1.6)], 13.0, Anchor::Start, BLACK, name);

        front(canvas, row, x, &y);
        let mut labels =
            Labels::new([x.pixels[0] + 2.0, top + 2.0, x.pixels[1], y.band[0] - 2.0], 11.0);
        labels.avoid_area(heading);
        let mut places = Vec::new();
        for (point, lane) in row.iter().zip(&lane_of) {
            let look = look(&point.test);
            let across = x.at(point.time);
            let up = match lane {
                Some(lane) => y.band[0] + 1.0 + (*lane as f64 + 0.5) * LANE,
                None => y.at(point.worst),
            };
            bar(canvas, point, x, up, look.color);
            if lane.is_some() {
                look.mark.draw(canvas, [across, up], 5.0, look.color, true);
                let at = [across + 10.0, up + 4.0];
                canvas.text(at, 11.0, Anchor::Start, look.color, &label(point));
            } else {
                let mean = y.at(point.mean);
                canvas.line([across, up], [across, mean], look.color, 0.8, "");
                look.mark.draw(canvas, [across, mean], 3.8, look.color, false);
                look.mark.draw(canvas, [across, up], 5.0, look.color, true);
                labels.avoid([across, up], 6.0);
                labels.avoid([across, mean], 5.0);
                labels.avoid_line(across, [up, mean]);
                let (text, color) = (label(point), look.color);
                places.push(Place { at: [across, up], text, color });
            }
        }
        places.sort_by(|a, b| a.at[1].total_cmp(&b.at[1]));
        for place in &places {
            labels.write(canvas, place);
        }
    }

    /// Where the fastest peer is, through all rows.
    fn peers_line(&self, canvas: &mut Canvas, points: &[&Point], x: &Scale, [top, end]: [f64; 2]) {
        let Some(fastest) = fastest_peer(points) else { return };
        let at = x.at(fastest.time);
        canvas.line([at, top - 4.0], [at, end], PURPLE, 1.0, "5 4");
        let text = format!("fastest peer: {}", label(fastest));
        let anchor = if at > WIDTH / 2.0 { Anchor::End } else { Anchor::Start };
        canvas.text([at, top - 8.0], 11.0, anchor, PURPLE, &text);
    }

    fn caption(&self, canvas: &mut Canvas, points: &[&Point], y: f64) {
        let most = points.iter().map(|p| p.cases).max().unwrap_or_default();
        let text = format!(
            "Farther left is faster, lower is more often right. In the band marked 0 not one of \
             up to {} answers was wrong; places within the band have no meaning. Answers are \
             counted against an exact oracle on every set of cases in {} that the scalar holds, \
             false “disjoint” and false “overlap” together; what is conservative errs only to \
             “overlap”, and means to. Peers take f32 alone; the dashed line shows the fastest of \
             them to all scalars. Time: medians of rounds in one process, in turns with the test \
             that is 1. Drawn by “cargo chart”; the figures are in chart.csv.",
            grouped(most as f64),
            self.sets,
        );
        canvas.paragraph([16.0, y], WIDTH - 32.0, 12.0, &text);
    }

    /// Where our exact tests lie beside the fastest peer, in words.
    pub(super) fn verdict(&self, points: &[&Point]) -> String {
        let Some(peer) = fastest_peer(points) else { return String::new() };
        let mut text = format!("{}: {} {:.2}", self.stem, label(peer), peer.time);
        for point in points.iter().filter(|p| p.claims_to_be_exact()) {
            let side = if point.time <= peer.time { "left" } else { "RIGHT" };
            text +=
                &format!("\n  {:<24} {:<16} {:.2} {side}", label(point), point.scalar, point.time);
        }
        text
    }
}

/// Pixels for each line of marks in the band of nought.
const LANE: f64 = 15.0;

fn fastest_peer<'a>(points: &[&'a Point]) -> Option<&'a Point> {
    let peers = points.iter().filter(|p| p.peer);
    peers.min_by(|a, b| a.time.total_cmp(&b.time)).copied()
}

/// The points of each scalar, in the order in which scalars first appear.
fn gathered<'a>(parts: &[&[&'a Point]]) -> Vec<Vec<&'a Point>> {
    let mut rows: Vec<Vec<&Point>> = Vec::new();
    for part in parts {
        match rows.iter_mut().find(|row| row[0].scalar == part[0].scalar) {
            Some(row) => row.extend_from_slice(part),
            None => rows.push(part.to_vec()),
        }
    }
    rows
}

/// From below the least to above the greatest time, in powers of the root of two.
fn reach(points: &[&Point]) -> [f64; 2] {
    let fold = |f: fn(f64, f64) -> f64, start: f64| points.iter().map(|p| p.time).fold(start, f);
    let low = (fold(f64::min, 1.0).log2() * 2.0 - 0.6).floor() / 2.0;
    // Room for the labels of the slowest.
    let high = (fold(f64::max, 1.0).log2() * 2.0 + 1.0).ceil() / 2.0;
    [low.exp2(), high.exp2()]
}

/// For each point that was never wrong the line that it stands on, so that their labels
/// keep clear of each other; and the number of lines.
fn lanes(row: &[&Point], x: &Scale) -> (Vec<Option<usize>>, usize) {
    let mut order: Vec<usize> = (0..row.len()).filter(|&k| row[k].worst == 0.0).collect();
    order.sort_by(|&a, &b| row[a].time.total_cmp(&row[b].time));
    let mut ends: Vec<f64> = Vec::new();
    let mut lane_of = vec![None; row.len()];
    for k in order {
        let start = x.at(row[k].time_low.min(row[k].time)) - 8.0;
        let bar = x.at(row[k].time_high) + 4.0;
        let end = bar.max(x.at(row[k].time) + 16.0 + width_of(&label(row[k]), 11.0));
        let free = ends.iter().position(|&taken| taken < start);
        let lane = free.unwrap_or_else(|| {
            ends.push(0.0);
            ends.len() - 1
        });
        ends[lane] = end;
        lane_of[k] = Some(lane);
    }
    (lane_of, ends.len().max(1))
}

fn grid(canvas: &mut Canvas, x: &Scale, y: &Zeroed, [top, bottom]: [f64; 2]) {
    let [left, right] = x.pixels;
    let [from, to] = y.band;
    canvas.rect([left, from], [right - left, to - from], PALE);
    for tick in x.powers(2.0) {
        let width = if tick == 1.0 { 1.2 } else { 0.6 };
        let color = if tick == 1.0 { GREY } else { LIGHT };
        canvas.line([x.at(tick), top + 6.0], [x.at(tick), bottom - 6.0], color, width, "");
    }
    for rate in y.rates.powers(10.0) {
        canvas.line([left, y.at(rate)], [right, y.at(rate)], LIGHT, 0.6, "");
    }
    for rate in y.rates.powers(100.0) {
        let text = grouped(rate);
        canvas.text([left - 5.0, y.at(rate) + 3.5], 10.0, Anchor::End, BLACK, &text);
    }
    canvas.bold([left - 5.0, y.zero() + 4.5], 13.0, Anchor::End, BLACK, "0");
}

/// The middle half of the rounds.
fn bar(canvas: &mut Canvas, point: &Point, x: &Scale, y: f64, color: &str) {
    let ends = [point.time_low, point.time_high].map(|t| x.at(t));
    canvas.line([ends[0], y], [ends[1], y], color, 1.2, "");
    for end in ends {
        canvas.line([end, y - 3.0], [end, y + 3.0], color, 1.2, "");
    }
}

/// The Pareto front by the worst set: a stair that nothing lies below and left of.
fn front(canvas: &mut Canvas, row: &[&Point], x: &Scale, y: &Zeroed) {
    let mut order: Vec<&&Point> = row.iter().collect();
    order.sort_by(|a, b| a.time.total_cmp(&b.time).then(a.worst.total_cmp(&b.worst)));
    let mut stair: Vec<[f64; 2]> = Vec::new();
    let mut least = f64::INFINITY;
    for point in order {
        if point.worst < least {
            let (across, up) = (x.at(point.time), y.at(point.worst));
            match stair.last() {
                Some(&[_, last]) => stair.push([across, last]),
                None => stair.push([across, y.rates.pixels[1] - 8.0]),
            }
            stair.push([across, up]);
            least = point.worst;
        }
    }
    if let Some(&[_, last]) = stair.last() {
        stair.push([x.pixels[1], last]);
    }
    canvas.polyline(&stair, "#BBBBBB", 4.0, "");
}
