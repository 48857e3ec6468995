//! The pictures: a query on a workload with a row for each scalar, and an overview of three
//! queries.

use std::error::Error;
use std::path::Path;

use crate::drawing::{grouped, short};
use crate::native::NAMES;

use super::frame::{Dot, Frame, Row};
use super::point::Point;
use super::style::{is_shown, label, look};

/// A picture's name and contents.
pub(super) struct Picture {
    pub(super) stem: &'static str,
    title: &'static str,
    workload: &'static str,
    yardstick: &'static str,
    sets: &'static str,
    /// Pixels above the band of zero, for a row with peers and for one without.
    heights: [f64; 2],
}

const BOXES: &str = "tests/kit/src/sets.rs";
const RAYS: &str = "tests/kit/src/rays/sets.rs";
const LINES: &str = "tests/kit/src/lines/sets.rs";
const FLATS: &str = "tests/kit/src/flat/sets.rs";
const OBBS: &str = "tests/kit/src/boxes/sets.rs";
const SPHERES: &str = "benches/src/accuracy/distance.rs";
const PUBLISHED: &str = "the test as published in 2001, in f32";
const IN_C: &str = "Möller–Trumbore as in C, in f32";
const SAT: &str = "the SAT test as published (Real-Time Rendering 16.7), in f32";

pub(super) const PICTURES: [Picture; 15] = [
    Picture {
        stem: "mesh-voxels",
        title: "A mesh in voxels",
        workload: "The teapot in 128 voxels, each box made on the way; a fifth of the pairs meet.",
        yardstick: PUBLISHED,
        sets: BOXES,
        heights: [140.0, 105.0],
    },
    Picture {
        stem: "ray-tree",
        title: "Rays down a tree",
        workload: "Random rays at a knot of 90,000 triangles: the first hit, by is_hit any. Wrong is \
                   whether there is one, for rays at vertices too.",
        yardstick: "parry3d's TriMesh, in f32",
        sets: "benches/src/accuracy/ray_tree.rs",
        heights: [190.0, 70.0],
    },
    Picture {
        stem: "triangle-box",
        title: "Triangle and box",
        workload: "Random triangles against one box, half of them meet it (Voorhies).",
        yardstick: PUBLISHED,
        sets: BOXES,
        heights: [140.0, 105.0],
    },
    Picture {
        stem: "triangle-box-voxel",
        title: "Triangle and voxels",
        workload: "Triangles against the cubes in their bounding boxes; a quarter of them meet.",
        yardstick: PUBLISHED,
        sets: BOXES,
        heights: [140.0, 105.0],
    },
    Picture {
        stem: "ray-triangle",
        title: "Ray and triangle",
        workload: "Random pairs, half of them meet.",
        yardstick: IN_C,
        sets: RAYS,
        heights: [190.0, 120.0],
    },
    Picture {
        stem: "ray-triangle-many",
        title: "One ray, many triangles",
        workload: "Each ray against 1,000 triangles, one in ten is hit. ×8: eight at once.",
        yardstick: IN_C,
        sets: RAYS,
        heights: [200.0, 160.0],
    },
    Picture {
        stem: "ray-box",
        title: "Ray and box",
        workload: "Each ray against 1,000 boxes, half of them meet. ×8: eight at once.",
        yardstick: SAT,
        sets: LINES,
        heights: [170.0, 130.0],
    },
    Picture {
        stem: "triangle-triangle",
        title: "Two triangles",
        workload: "Random pairs, half of them meet.",
        yardstick: "11 axes as one types them, in f32",
        sets: FLATS,
        heights: [140.0, 105.0],
    },
    Picture {
        stem: "box-box",
        title: "Two oriented boxes",
        workload: "Random pairs, half of them meet. parry3d takes axes as a quaternion.",
        yardstick: "parry3d, in f32",
        sets: OBBS,
        heights: [120.0, 105.0],
    },
    Picture {
        stem: "ray-oriented-box",
        title: "Ray and oriented box",
        workload: "Random pairs, half of them meet. The peer takes axes as a quaternion.",
        yardstick: "parry3d's cast_ray, in f32",
        sets: OBBS,
        heights: [120.0, 105.0],
    },
    Picture {
        stem: "sweep",
        title: "A box that moves past a triangle",
        workload: "A unit cube near triangles, half of the pairs meet. A hit that is late is wrong; \
                   box3d-rust stops 0.005 before, by design.",
        yardstick: "parry3d's cast_shapes, in f32",
        sets: "tests/kit/src/sweeps/sets.rs",
        heights: [130.0, 105.0],
    },
    Picture {
        stem: "contact",
        title: "Oriented boxes in each other",
        workload: "Half of the pairs are in each other. A depth a thousandth off is wrong; the \
                   peers' is that of their deepest point.",
        yardstick: "parry3d's manifold, in f32",
        sets: OBBS,
        heights: [130.0, 105.0],
    },
    Picture {
        stem: "sphere-triangle",
        title: "Sphere and triangle",
        workload: "Random spheres and triangles, most of them apart.",
        yardstick: "parry3d's projection, in f32",
        sets: SPHERES,
        heights: [130.0, 105.0],
    },
    Picture {
        stem: "capsule-triangle",
        title: "Capsule and triangle",
        workload: "Random capsules and triangles, most of them apart.",
        yardstick: "parry3d's intersection_test, in f32",
        sets: SPHERES,
        heights: [130.0, 105.0],
    },
    Picture {
        stem: "closest-point",
        title: "Closest point of a triangle",
        workload: "Random points and triangles. A coordinate is wrong if it is off by a thousandth of the \
                   triangle's size and a place. Ours also names the vertex or the edge.",
        yardstick: "parry3d's project_local_point, in f32",
        sets: SPHERES,
        heights: [130.0, 105.0],
    },
];

const HOW_TO_READ: &str = "Farther left is faster, lower is more often right. In the band marked 0 not one answer was \
     wrong; height within the band has no meaning. Wrong: false “disjoint” and false “overlap” \
     together, by an exact oracle; what is conservative errs to “overlap” alone, and means to. \
     The grey stair: nothing lies both left of it and below it.";

impl Picture {
    pub(super) fn draw(&self, points: &[Point], folder: &Path) -> Result<(), Box<dyn Error>> {
        let (all, points) = (points, self.shown(points));
        let line = fastest_peer(&points).map(|p| (p.time, format!("fastest peer: {}", label(p))));
        let mut rows: Vec<Row> = Vec::new();
        for point in &points {
            let dot = dot(point, label(point));
            match rows.iter_mut().find(|row| row.heading == point.scalar) {
                Some(row) => row.dots.push(dot),
                None => rows.push(Row {
                    heading: point.scalar.clone(),
                    dots: vec![dot],
                    height: self.heights[usize::from(!rows.is_empty())],
                    // Named only once.
                    line: line
                        .clone()
                        .map(|(at, text)| (at, if rows.is_empty() { text } else { String::new() })),
                }),
            }
        }
        let frame = Frame {
            title: self.title.into(),
            subtitle: self.workload.into(),
            rows,
            axis: format!("time per query; 1 is {}", self.yardstick),
            tick: short,
            base: 2.0,
            caption: format!(
                "{HOW_TO_READ} Up to {} cases, on every set in {} that the scalar holds; the mean \
                 is over sets. Peers take f32 alone: the dashed line shows their fastest to every \
                 scalar. Time: medians of rounds in one process, each in turn with the test that is \
                 1. {} measures and draws; the figures are in chart.csv.",
                most_cases(&points),
                self.sets,
                command(all),
            ),
            bars: true,
        };
        frame.draw(&folder.join(self.stem))
    }

    fn shown<'a>(&self, points: &'a [Point]) -> Vec<&'a Point> {
        points.iter().filter(|p| p.picture == self.stem && is_shown(p)).collect()
    }

    /// A sentence that compares our exact tests with the fastest peer.
    pub(super) fn verdict(&self, points: &[Point]) -> String {
        let points = self.shown(points);
        let Some(peer) = fastest_peer(&points) else { return String::new() };
        let mut text = format!("{}: {} {:.2}", self.stem, label(peer), peer.time);
        for point in points.iter().filter(|p| p.claims_to_be_exact()) {
            let side = if point.time <= peer.time { "left of it" } else { "right of it" };
            let (label, scalar, time) = (label(point), &point.scalar, point.time);
            text += &format!("\n  {label:<24} {scalar:<16} {time:.2} {side}");
        }
        text
    }
}

/// An overview of a few queries: all methods in `f32` with the peers, and the exact methods in the
/// other scalars.
pub(super) struct Overview {
    stem: &'static str,
    title: &'static str,
    /// For each query its picture, the pixels above the band of zero, and the exact test.
    rows: &'static [(&'static str, f64, &'static str)],
    note: &'static str,
}

pub(super) const OVERVIEWS: [Overview; 3] = [
    Overview {
        stem: "overview",
        title: "Speed and accuracy",
        rows: &[
            ("triangle-box", 130.0, "exact"),
            ("ray-triangle", 215.0, "exact hit"),
            ("ray-box", 165.0, "exact"),
        ],
        note: "I16F16, 18: coordinates of 18 bits; boxes by centre, for rays by corners.",
    },
    Overview {
        stem: "family",
        title: "Pairs, motion and contact",
        rows: &[
            ("triangle-triangle", 120.0, "exact"),
            ("box-box", 100.0, "exact"),
            ("ray-oriented-box", 100.0, "exact"),
            ("sweep", 120.0, "exact, when"),
            ("contact", 100.0, "exact, with points"),
        ],
        note: "I16F16, 18: coordinates of 18 bits. Of what moves a hit that is late is wrong.",
    },
    Overview {
        stem: "distances",
        title: "Distances",
        rows: &[
            ("sphere-triangle", 120.0, "exact"),
            ("capsule-triangle", 100.0, "exact"),
            ("closest-point", 120.0, "exact"),
        ],
        note: "I16F16, 18: coordinates of 18 bits. A closest point is wrong if a coordinate is off by a \
               thousandth of the triangle's size and a place; ours also names the vertex or the edge.",
    },
];

impl Overview {
    pub(super) fn draw(&self, points: &[Point], folder: &Path) -> Result<(), Box<dyn Error>> {
        let row = |stem: &str, height: f64, exact: &str| {
            let picture = PICTURES.iter().find(|p| p.stem == stem).expect("one of them");
            let points = picture.shown(points);
            let peer = fastest_peer(&points);
            let mut dots = Vec::new();
            for point in &points {
                let text = label(point);
                if point.form.contains("8 at once") || text.ends_with(", corners") {
                    continue;
                } else if point.scalar == "f32" {
                    dots.push(dot(point, text));
                } else if point.test == exact {
                    dots.push(dot(point, format!("exact, {}", point.scalar.replace(" bits", ""))));
                }
            }
            Row {
                heading: format!("{}: 1 is {}", picture.title, picture.yardstick),
                dots,
                height,
                line: peer.map(|p| (p.time, String::new())),
            }
        };
        let frame = Frame {
            title: self.title.into(),
            subtitle: "All methods in f32, the peers, and what is exact in every other scalar too."
                .into(),
            rows: self.rows.iter().map(|&(stem, height, exact)| row(stem, height, exact)).collect(),
            axis: "time per query".into(),
            tick: short,
            base: 2.0,
            caption: format!(
                "{HOW_TO_READ} The dashed line is the fastest peer. Times are medians of rounds in one \
             process, each in turn with the test that is 1. {} {} measures and draws; the figures \
             are in chart.csv.",
                self.note,
                command(points),
            ),
            bars: true,
        };
        frame.draw(&folder.join(self.stem))
    }
}

fn dot(point: &Point, label: String) -> Dot {
    let cost = [point.time_low, point.time, point.time_high];
    Dot { family: look(&point.test), label, cost, worst: point.worst, mean: point.mean }
}

/// What measured the points, and what it left out.
fn command(points: &[Point]) -> &'static str {
    let is_native = |point: &Point| NAMES.iter().any(|name| point.test.contains(name));
    match points.iter().any(is_native) {
        true => "“cargo native-chart”",
        false => "Peers in C++ are missing. “cargo chart”",
    }
}

fn fastest_peer<'a>(points: &[&'a Point]) -> Option<&'a Point> {
    let peers = points.iter().filter(|p| p.peer);
    peers.min_by(|a, b| a.time.total_cmp(&b.time)).copied()
}

fn most_cases(points: &[&Point]) -> String {
    grouped(points.iter().map(|p| p.cases).max().unwrap_or_default() as f64)
}
