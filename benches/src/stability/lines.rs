//! The methods that get a line, and its look: colour and mark by method, dashes by scalar.

use crate::accuracy::Tally;
use crate::drawing::{BLACK, BLUE, GREEN, Mark, ORANGE, PURPLE, VERMILION};

/// A line's look.
#[derive(Clone, Copy, Debug)]
pub(super) struct Style {
    pub(super) label: &'static str,
    pub(super) mark: Mark,
    pub(super) color: &'static str,
    pub(super) dash: &'static str,
}

const SOLID: &str = "";
const DASHED: &str = "7 3";
const DOTTED: &str = "2 3";

/// The name of a test, its form, its scalar; and the look of its line.
type Line = (&'static str, &'static str, &'static str, Style);

const fn line(
    who: [&'static str; 3],
    label: &'static str,
    mark: Mark,
    color: &'static str,
    dash: &'static str,
) -> Line {
    (who[0], who[1], who[2], Style { label, mark, color, dash })
}

const LINES: [Line; 45] = [
    line(["as published", "centre", "f32"], "as published, f32", Mark::Square, VERMILION, SOLID),
    line(["as published", "centre", "f64"], "as published, f64", Mark::Square, VERMILION, DASHED),
    line(["as published", "centre", "I16F16"], "as publ., I16F16", Mark::Square, VERMILION, DOTTED),
    line(["as published", "centre", "I32F32"], "as publ., I32F32", Mark::Square, VERMILION, DOTTED),
    line(["rounded", "centre", "f32"], "rounded, f32", Mark::Circle, BLUE, SOLID),
    line(["rounded", "centre", "I16F16"], "rounded, I16F16", Mark::Circle, BLUE, DOTTED),
    line(["rounded", "centre", "I32F32"], "rounded, I32F32", Mark::Circle, BLUE, DOTTED),
    line(["conservative", "centre", "f32"], "conservative, f32", Mark::Up, GREEN, SOLID),
    line(["conservative", "centre", "I16F16"], "conserv., I16F16", Mark::Up, GREEN, DOTTED),
    line(["conservative", "centre", "I32F32"], "conserv., I32F32", Mark::Up, GREEN, DOTTED),
    line(
        ["box3d-rust test_bounds_triangle_overlap", "centre", "f32"],
        "box3d-rust, f32",
        Mark::Plus,
        PURPLE,
        SOLID,
    ),
    line(
        ["parry3d …_cuboid_triangle", "centre", "f32"],
        "parry3d, f32",
        Mark::Cross,
        PURPLE,
        SOLID,
    ),
    line(
        ["yardstick: Möller–Trumbore as in C", "", "f32"],
        "M.–T. as in C, f32",
        Mark::Square,
        VERMILION,
        SOLID,
    ),
    line(["Möller–Trumbore", "", "f64"], "M.–T., f64", Mark::Square, VERMILION, DASHED),
    line(
        ["Möller–Trumbore as in C, wrapping", "", "I16F16"],
        "M.–T., I16F16",
        Mark::Square,
        VERMILION,
        DOTTED,
    ),
    line(["Möller–Trumbore", "", "I32F32"], "M.–T., I32F32", Mark::Square, VERMILION, DOTTED),
    line(
        ["stored normal", "triangle prepared", "f32"],
        "stored normal, f32",
        Mark::Diamond,
        BLUE,
        SOLID,
    ),
    line(
        ["stored normal", "triangle prepared", "I32F32"],
        "stored n., I32F32",
        Mark::Diamond,
        BLUE,
        DOTTED,
    ),
    line(
        ["watertight (Woop)", "ray prepared", "f32"],
        "watertight, f32",
        Mark::Down,
        ORANGE,
        SOLID,
    ),
    line(
        ["watertight (Woop)", "ray prepared", "I32F32"],
        "watert., I32F32",
        Mark::Down,
        ORANGE,
        DOTTED,
    ),
    line(["parry3d cast_local_ray", "", "f32"], "parry3d, f32", Mark::Cross, PURPLE, SOLID),
    line(
        ["obvhs Triangle::intersect", "ray prepared", "f32"],
        "obvhs, f32",
        Mark::HourGlass,
        PURPLE,
        SOLID,
    ),
    line(["parry3d cast_shapes", "", "f32"], "parry3d, f32", Mark::Cross, PURPLE, SOLID),
    line(["box3d-rust shape_cast", "", "f32"], "box3d-rust, f32", Mark::Plus, ORANGE, SOLID),
    line(["exact, when", "", "f32"], "exact, f32", Mark::Star, BLACK, SOLID),
    line(["exact, when", "", "f64"], "exact, f64", Mark::Star, BLACK, DASHED),
    line(["exact, when", "", "I16F16"], "exact, I16F16", Mark::Star, BLACK, DOTTED),
    line(["parry3d contact", "", "f32"], "parry3d, f32", Mark::Cross, PURPLE, SOLID),
    line(["exact, translation", "", "f32"], "exact, f32", Mark::Star, BLACK, SOLID),
    line(["exact, translation", "", "f64"], "exact, f64", Mark::Star, BLACK, DASHED),
    line(["exact, translation", "", "I16F16"], "exact, I16F16", Mark::Star, BLACK, DOTTED),
    line(["as published (Ericson)", "", "f32"], "Ericson, f32", Mark::Square, VERMILION, SOLID),
    line(["as published (Ericson)", "", "f64"], "Ericson, f64", Mark::Square, VERMILION, DASHED),
    line(["parry3d", "", "f32"], "parry3d, f32", Mark::Cross, PURPLE, SOLID),
    line(["exact", "", "f32"], "exact, f32", Mark::Star, BLACK, SOLID),
    line(["exact", "", "f64"], "exact, f64", Mark::Star, BLACK, DASHED),
    line(["exact", "", "I16F16"], "exact, I16F16", Mark::Star, BLACK, DOTTED),
    line(["exact", "centre", "f32"], "exact, f32", Mark::Star, BLACK, SOLID),
    line(["exact", "centre", "f64"], "exact, f64", Mark::Star, BLACK, DASHED),
    line(["exact", "centre", "I16F16"], "exact, I16F16", Mark::Star, BLACK, DOTTED),
    line(["exact", "centre", "I32F32"], "exact, I32F32", Mark::Star, BLACK, DOTTED),
    line(["exact hit", "", "f32"], "exact, f32", Mark::Star, BLACK, SOLID),
    line(["exact hit", "", "f64"], "exact, f64", Mark::Star, BLACK, DASHED),
    line(["exact hit", "", "I16F16"], "exact, I16F16", Mark::Star, BLACK, DOTTED),
    line(["exact hit", "", "I32F32"], "exact, I32F32", Mark::Star, BLACK, DOTTED),
];

/// The look of a test's line, if it has one, and its place among them.
pub(super) fn style(tally: &Tally) -> Option<(usize, Style)> {
    let same = |(who, form, scalar, _): &Line| {
        tally.who == *who && tally.form == *form && tally.scalar == *scalar
    };
    LINES.iter().position(same).map(|k| (k, LINES[k].3))
}
