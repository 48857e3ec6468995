//! Labels that keep clear of marks and of each other.

use super::{Canvas, GREY, width_of};

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
    bounds: Area,
    size: f64,
}

impl Labels {
    pub(crate) fn new(bounds: Area, size: f64) -> Self {
        Self { taken: Vec::new(), marks: Vec::new(), bounds, size }
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
        for ring in 0..7 {
            let gap = 8.0 + 11.0 * f64::from(ring);
            for turn in 0..16 {
                let angle = f64::from(turn) / 16.0 * std::f64::consts::TAU;
                let (dx, dy) = (angle.cos(), angle.sin());
                // The edge of the label that faces the mark lies at the gap.
                let left = x + dx * gap + (dx - 1.0) / 2.0 * w;
                let top = y + dy * gap - h / 2.0 + dy * h / 4.0;
                let area = [left, top, left + w, top + h];
                let mut cost = gap + 3.0 * (1.0 - dx) + 2.0 * dy.abs();
                cost += 60.0 * self.taken.iter().map(|a| overlap(a, &area)).sum::<f64>();
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
        let near = [x.clamp(area[0], area[2]), y.clamp(area[1], area[3])];
        let distance = distance(&area, place.at);
        if distance > 13.0 {
            let part = 5.0 / distance;
            let from = [x + (near[0] - x) * part, y + (near[1] - y) * part];
            canvas.line(from, near, GREY, 0.6, "");
        }
        let base = [area[0], area[3] - 0.2 * h];
        canvas.haloed(base, self.size, "white", place.color, &place.text);
        self.taken.push([area[0] - 2.0, area[1], area[2] + 2.0, area[3]]);
    }
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
