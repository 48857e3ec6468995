//! The legend: the marks of all families, and the meaning of full marks, hollow marks and bars.

use crate::drawing::{Anchor, BLACK, Canvas, GREY, Mark, width_of};

use super::style::Family;

/// A text, and a function that draws its symbol.
type Key = (&'static str, fn(&mut Canvas, f64, f64));

const SIZE: f64 = 12.0;
const LINE: f64 = 20.0;

/// Draws the legend from a height on; returns the height where it ends.
pub(super) fn draw(
    canvas: &mut Canvas,
    families: &[Family],
    [left, right]: [f64; 2],
    y: f64,
    bars: bool,
) -> f64 {
    let (mut x, mut y) = (left, y);
    for family in families {
        let width = 22.0 + width_of(family.name, SIZE) + 18.0;
        if x + width > right {
            (x, y) = (left, y + LINE);
        }
        family.mark.draw(canvas, [x + 7.0, y - 4.0], 5.5, family.color, true);
        canvas.text([x + 20.0, y], SIZE, Anchor::Start, BLACK, family.name);
        x += width;
    }
    (x, y) = (left, y + LINE);
    let keys: [Key; 4] = [
        ("full: its worst set", |canvas, x, y| {
            Mark::Circle.draw(canvas, [x, y], 5.0, BLACK, true);
        }),
        ("hollow: the mean of all sets", |canvas, x, y| {
            Mark::Circle.draw(canvas, [x, y], 4.0, BLACK, false);
        }),
        ("the middle half of all rounds", |canvas, x, y| {
            canvas.line([x - 9.0, y], [x + 9.0, y], BLACK, 1.4, "");
            canvas.line([x - 9.0, y - 3.5], [x - 9.0, y + 3.5], BLACK, 1.4, "");
            canvas.line([x + 9.0, y - 3.5], [x + 9.0, y + 3.5], BLACK, 1.4, "");
        }),
        ("the front: nothing is both faster and more often right", |canvas, x, y| {
            canvas.line([x - 9.0, y], [x + 9.0, y], GREY, 4.0, "");
        }),
    ];
    for (text, key) in keys.into_iter().filter(|(text, _)| bars || !text.contains("rounds")) {
        let width = 26.0 + width_of(text, SIZE) + 16.0;
        if x + width > right {
            (x, y) = (left, y + LINE);
        }
        key(canvas, x + 9.0, y - 4.0);
        canvas.text([x + 24.0, y], SIZE, Anchor::Start, BLACK, text);
        x += width;
    }
    y + 8.0
}
