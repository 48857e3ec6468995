//! Draws rows of marks, with cost on the horizontal axis and error rate on the vertical.

use std::error::Error;
use std::path::Path;

use crate::drawing::{
    Anchor, BLACK, Canvas, GREY, LIGHT, Labels, PALE, PURPLE, Place, Scale, WIDTH, Zeroed, grouped,
    width_of,
};

use super::legend;
use super::style::Family;

/// One mark, or two: the rate on the worst set and on the mean of all sets.
pub(super) struct Dot {
    pub(super) family: Family,
    pub(super) label: String,
    /// Lower quartile, median, upper quartile.
    pub(super) cost: [f64; 3],
    pub(super) worst: f64,
    pub(super) mean: f64,
}

pub(super) struct Row {
    pub(super) heading: String,
    pub(super) dots: Vec<Dot>,
    /// Pixels of the part above the band of zero.
    pub(super) height: f64,
    /// A vertical line at the fastest peer.
    pub(super) line: Option<(f64, String)>,
}

/// A picture.
pub(super) struct Frame {
    pub(super) title: String,
    pub(super) subtitle: String,
    pub(super) rows: Vec<Row>,
    /// The quantity on the horizontal axis, and the format of its ticks.
    pub(super) axis: String,
    pub(super) tick: fn(f64) -> String,
    pub(super) base: f64,
    pub(super) caption: String,
    pub(super) bars: bool,
}

/// Pixels for each line of marks in the band of zero, and above a row.
const LANE: f64 = 15.0;
const HEADING: f64 = 24.0;
const LEFT: f64 = 76.0;
const RIGHT: f64 = WIDTH - 12.0;
const SMALL: f64 = 11.0;

impl Frame {
    pub(super) fn draw(&self, stem: &Path) -> Result<(), Box<dyn Error>> {
        let x = Scale { values: self.reach(), pixels: [LEFT, RIGHT] };
        let height = |row: &Row| HEADING + row.height + row.lanes(&x).1 as f64 * LANE + 8.0;
        let total: f64 = self.rows.iter().map(height).sum();
        let mut canvas = Canvas::new(WIDTH, total + 250.0);

        canvas.bold([12.0, 26.0], 18.0, Anchor::Start, BLACK, &self.title);
        let at = 22.0 + width_of(&self.title, 18.0) * 1.12;
        let fits = at + width_of(&self.subtitle, 13.0) < WIDTH;
        let legend = if fits {
            canvas.text([at, 26.0], 13.0, Anchor::Start, BLACK, &self.subtitle);
            50.0
        } else {
            canvas.paragraph([16.0, 47.0], WIDTH - 32.0, 13.0, &self.subtitle) + 2.0
        };
        let mut families: Vec<Family> = Vec::new();
        for dot in self.rows.iter().flat_map(|row| &row.dots) {
            if !families.contains(&dot.family) {
                families.push(dot.family);
            }
        }
        families.sort_by_key(|family| family.rank());
        let mut y = legend::draw(&mut canvas, &families, [16.0, RIGHT], legend, self.bars);
        let (top, floor) = (y, self.floor());
        for row in &self.rows {
            let end = y + height(row);
            row.draw(&mut canvas, &x, floor, self.base, [y, end]);
            y = end;
        }
        for tick in x.powers(self.base) {
            canvas.text([x.at(tick), y + 14.0], 12.0, Anchor::Middle, BLACK, &(self.tick)(tick));
        }
        canvas.text([(LEFT + RIGHT) / 2.0, y + 32.0], 12.0, Anchor::Middle, BLACK, &self.axis);
        canvas.upright([12.0, (top + y) / 2.0], 12.0, BLACK, "wrong answers per million");
        y = canvas.paragraph([16.0, y + 56.0], WIDTH - 32.0, 12.0, &self.caption);
        canvas.crop(y);
        canvas.save(stem)
    }

    fn dots(&self) -> impl Iterator<Item = &Dot> {
        self.rows.iter().flat_map(|row| &row.dots)
    }

    /// A range from below the least cost to above the greatest, with room for a label.
    fn reach(&self) -> [f64; 2] {
        let lines = self.rows.iter().filter_map(|row| row.line.as_ref()).map(|(x, _)| *x);
        // The extremes of paths count. The extremes of times come from disturbed rounds, so only
        // the median counts.
        let from = if self.bars { 1 } else { 0 };
        let dots = self.dots().flat_map(|dot| [dot.cost[from], dot.cost[1]]);
        let costs: Vec<f64> = dots.chain(lines).collect();
        let low = costs.iter().copied().fold(f64::INFINITY, f64::min);
        let high = costs.iter().copied().fold(0.0, f64::max);
        let room = (high / low).ln() * 0.1;
        let left = low * (-0.4 * room).exp() * 0.9;
        let right = high * (1.2 * room).exp() * 1.1;
        // In the band of zero a label always stands to the right of its mark.
        let needed = self.dots().filter(|dot| dot.worst == 0.0).map(|dot| {
            let width = RIGHT - LEFT;
            let share = width / (width - 20.0 - width_of(&dot.label, SMALL));
            left * (dot.cost[2] / left).powf(share)
        });
        [left, needed.fold(right, f64::max)]
    }

    /// The power of ten below all rates except zero.
    fn floor(&self) -> f64 {
        let rates = self.dots().map(|dot| dot.mean).filter(|rate| *rate > 0.0);
        let least = rates.fold(1e4, f64::min);
        10_f64.powf(least.log10().floor()).clamp(1.0, 1e3)
    }
}

impl Row {
    /// The line for each dot with no wrong answer, so that labels keep clear of each other, and the
    /// number of lines.
    fn lanes(&self, x: &Scale) -> (Vec<Option<usize>>, usize) {
        let dots = &self.dots;
        let mut order: Vec<usize> = (0..dots.len()).filter(|&k| dots[k].worst == 0.0).collect();
        order.sort_by(|&a, &b| dots[a].cost[1].total_cmp(&dots[b].cost[1]));
        let mut ends: Vec<f64> = Vec::new();
        let mut lane_of = vec![None; dots.len()];
        for k in order {
            let [low, middle, high] = dots[k].cost.map(|cost| x.at(cost));
            // As the label is written, and space after it.
            let end = high.max(middle) + 18.0 + width_of(&dots[k].label, SMALL);
            let free = ends.iter().position(|&taken| taken < low.min(middle - 8.0));
            let lane = free.unwrap_or_else(|| {
                ends.push(0.0);
                ends.len() - 1
            });
            ends[lane] = end;
            lane_of[k] = Some(lane);
        }
        (lane_of, ends.len().max(1))
    }

    fn draw(&self, canvas: &mut Canvas, x: &Scale, floor: f64, base: f64, [top, bottom]: [f64; 2]) {
        let (lane_of, lanes) = self.lanes(x);
        let y = Zeroed::new([floor, 1e6], [top + HEADING + 6.0, bottom - 2.0], lanes as f64 * LANE);
        grid(canvas, x, &y, base);
        canvas.bold([LEFT, top + HEADING - 6.0], 13.0, Anchor::Start, BLACK, &self.heading);
        self.front(canvas, x, &y);

        let mut labels =
            Labels::new([LEFT, y.rates.pixels[1] - 9.0, RIGHT, y.band[0] - 3.0], SMALL);
        if let Some((at, text)) = &self.line {
            let at = x.at(*at);
            canvas.line([at, top + HEADING - 2.0], [at, bottom - 2.0], PURPLE, 1.0, "5 4");
            let anchor = if at > WIDTH / 2.0 { Anchor::End } else { Anchor::Start };
            canvas.text([at, top + HEADING - 6.0], SMALL, anchor, PURPLE, text);
        }
        let mut places = Vec::new();
        for (dot, lane) in self.dots.iter().zip(&lane_of) {
            let (mark, color) = (dot.family.mark, dot.family.color);
            let [low, across, high] = dot.cost.map(|cost| x.at(cost).clamp(LEFT, RIGHT));
            if let Some(lane) = lane {
                let up = y.band[0] + (*lane as f64 + 0.5) * LANE;
                bar(canvas, [low, high], up, color);
                mark.draw(canvas, [across, up], 5.0, color, true);
                canvas.haloed([high.max(across) + 10.0, up + 4.0], SMALL, PALE, color, &dot.label);
                continue;
            }
            let (up, mean) = (y.at(dot.worst), y.at(dot.mean));
            bar(canvas, [low, high], up, color);
            canvas.line([across, up], [across, mean], color, 0.9, "");
            mark.draw(canvas, [across, mean], 3.8, color, false);
            mark.draw(canvas, [across, up], 5.0, color, true);
            labels.avoid([across, up], 6.0);
            labels.avoid([across, mean], 5.0);
            labels.avoid_area([across - 1.0, up, across + 1.0, mean]);
            labels.avoid_area([low, up - 3.0, high, up + 3.0]);
            places.push(Place { at: [across, up], text: dot.label.clone(), color });
        }
        places.sort_by(|a, b| a.at[0].total_cmp(&b.at[0]));
        places.iter().for_each(|place| labels.write(canvas, place));
    }

    /// The Pareto front by the worst set: a staircase with no mark below it on the left.
    fn front(&self, canvas: &mut Canvas, x: &Scale, y: &Zeroed) {
        let mut order: Vec<&Dot> = self.dots.iter().collect();
        order.sort_by(|a, b| a.cost[1].total_cmp(&b.cost[1]).then(a.worst.total_cmp(&b.worst)));
        let mut stair: Vec<[f64; 2]> = Vec::new();
        let (mut last, mut least) = (y.rates.pixels[1] - 6.0, f64::INFINITY);
        for dot in order {
            if dot.worst < least {
                let across = x.at(dot.cost[1]);
                stair.push([across, last]);
                (last, least) = (y.at(dot.worst), dot.worst);
                stair.push([across, last]);
            }
        }
        stair.push([RIGHT, last]);
        canvas.polyline(&stair, "#C4C4C4", 4.0, "");
    }
}

fn grid(canvas: &mut Canvas, x: &Scale, y: &Zeroed, base: f64) {
    let [from, to] = y.band;
    canvas.rect([LEFT, from], [RIGHT - LEFT, to - from], PALE);
    for tick in x.powers(base) {
        let (color, width) = if tick == 1.0 { (GREY, 1.2) } else { (LIGHT, 0.6) };
        canvas.line([x.at(tick), y.rates.pixels[1] - 6.0], [x.at(tick), to], color, width, "");
    }
    for rate in y.rates.powers(10.0) {
        canvas.line([LEFT, y.at(rate)], [RIGHT, y.at(rate)], LIGHT, 0.6, "");
        canvas.text([LEFT - 5.0, y.at(rate) + 3.5], 9.5, Anchor::End, BLACK, &grouped(rate));
    }
    canvas.bold([LEFT - 5.0, y.zero() + 4.5], 13.0, Anchor::End, BLACK, "0");
}

/// A bar over the middle half of the rounds.
fn bar(canvas: &mut Canvas, [low, high]: [f64; 2], y: f64, color: &str) {
    canvas.line([low, y], [high, y], color, 1.2, "");
    for end in [low, high] {
        canvas.line([end, y - 3.0], [end, y + 3.0], color, 1.2, "");
    }
}
