//! Labels that keep clear of marks and of each other.

use super::{Canvas, GREY, width_of};

/// Circles around a mark on which its label may begin.
const RINGS: u32 = 14;

/// A rectangle: least x and y, greatest x and y.
type Area = [f64; 4];

/// The position of a label.
#[derive(Clone, Debug)]
pub(crate) struct Place {
    pub(crate) at: [f64; 2],
    pub(crate) text: String,
    pub(crate) color: &'static str,
}

/// Labels, and the areas that they must avoid.
pub(crate) struct Labels {
    taken: Vec<Area>,
    marks: Vec<[f64; 2]>,
    written: Vec<Area>,
    bounds: Area,
    size: f64,
}

impl Labels {
    pub(crate) fn new(bounds: Area, size: f64) -> Self {
        Self { taken: Vec::new(), marks: Vec::new(), written: Vec::new(), bounds, size }
    }

    /// Keeps clear of a mark.
    pub(crate) fn avoid(&mut self, [x, y]: [f64; 2], r: f64) {
        self.taken.push([x - r, y - r, x + r, y + r]);
        self.marks.push([x, y]);
    }

    pub(crate) fn avoid_area(&mut self, area: Area) {
        self.taken.push(area);
    }

    /// Writes a label near its mark where it hides least, with a leader line if it is not next to
    /// the mark.
    pub(crate) fn write(&mut self, canvas: &mut Canvas, place: &Place) {
        let (w, h) = (width_of(&place.text, self.size), self.size);
        let [x, y] = place.at;
        let mut best: Option<(f64, Area)> = None;
        for ring in 0..RINGS {
            let gap = 8.0 + 9.0 * f64::from(ring);
            for turn in 0..16 {
                let angle = f64::from(turn) / 16.0 * std::f64::consts::TAU;
                let (dx, dy) = (angle.cos(), angle.sin());
                // The edge of the label that faces the mark lies at the gap.
                let left = x + dx * gap + (dx - 1.0) / 2.0 * w;
                let top = y + dy * gap - h / 2.0 + dy * h / 4.0;
                let area = [left, top, left + w, top + h];
                let mut cost = gap + 3.0 * (1.0 - dx) + 2.0 * dy.abs();
                let leader = leader(place.at, &area);
                let hidden = |area: &Area| self.taken.iter().map(|a| overlap(a, area)).sum::<f64>();
                cost += 60.0 * hidden(&area);
                cost += 20.0 * self.written.iter().filter(|w| crosses(w, &leader)).count() as f64;
                cost += 1e3 * outside(&self.bounds, &area);
                // A label nearer to another mark would seem to belong to it.
                let own = distance(&area, place.at);
                let nearer = |mark: &&[f64; 2]| distance(&area, **mark) < own;
                cost += 12.0 * self.marks.iter().filter(nearer).count().min(3) as f64;
                if best.is_none_or(|(least, _)| cost < least) {
                    best = Some((cost, area));
                }
            }
        }
        let (_, area) = best.expect("there are places");
        let line = leader(place.at, &area);
        if let (Some(&from), Some(&near)) = (line.first(), line.last()) {
            canvas.line(from, near, GREY, 0.6, "");
            self.taken.extend(line.iter().map(|[x, y]| [x - 1.5, y - 1.5, x + 1.5, y + 1.5]));
        }
        let base = [area[0], area[3] - 0.2 * h];
        canvas.haloed(base, self.size, "white", place.color, &place.text);
        let around = [area[0] - 4.0, area[1], area[2] + 4.0, area[3]];
        self.taken.push(around);
        self.written.push(around);
    }
}

/// Points on the line from a mark to its label; none if the label is next to it.
fn leader([x, y]: [f64; 2], area: &Area) -> Vec<[f64; 2]> {
    let near = [x.clamp(area[0], area[2]), y.clamp(area[1], area[3])];
    let length = distance(area, [x, y]);
    if length <= 13.0 {
        return Vec::new();
    }
    let steps = (length / 4.0).ceil();
    let on = |part: f64| [x + (near[0] - x) * part, y + (near[1] - y) * part];
    let first = 5.0 / length;
    (0..=steps as u32).map(|k| on(first + (1.0 - first) * f64::from(k) / steps)).collect()
}

/// Whether a point of the line lies in the area.
fn crosses(area: &Area, line: &[[f64; 2]]) -> bool {
    line.iter().any(|&point| distance(area, point) == 0.0)
}

/// The overlap of two areas, as a length.
fn overlap(a: &Area, b: &Area) -> f64 {
    let side = |i: usize| (a[i + 2].min(b[i + 2]) - a[i].max(b[i])).max(0.0);
    (side(0) * side(1)).sqrt()
}

/// The distance from a point to an area.
fn distance(area: &Area, [x, y]: [f64; 2]) -> f64 {
    (x - x.clamp(area[0], area[2])).hypot(y - y.clamp(area[1], area[3]))
}

/// The extent of an area outside the bounds.
fn outside(bounds: &Area, area: &Area) -> f64 {
    let low = (0..2).map(|i| (bounds[i] - area[i]).max(0.0));
    let high = (2..4).map(|i| (area[i] - bounds[i]).max(0.0));
    low.chain(high).sum()
}
