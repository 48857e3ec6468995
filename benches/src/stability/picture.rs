//! A picture of one regime: panels above each other, with a line for each method.

use std::collections::BTreeMap;
use std::error::Error;

use crate::accuracy::Tally;
use crate::drawing::{
    Anchor, BLACK, Canvas, GREY, LIGHT, PALE, WIDTH, Zeroed, grouped, power_of, width_of,
};

use super::lines::{Style, style};
use super::regimes::{Regime, Ticks};
use super::{Options, Step};

pub(super) const LEFT: f64 = 76.0;
pub(super) const RIGHT: f64 = WIDTH - 158.0;
const PANEL: f64 = 215.0;
const BAND: f64 = 44.0;
const HEADING: f64 = 26.0;

/// The points of a line: the index of a step in its panel, and a rate.
type Points = Vec<(usize, f64)>;

pub(super) fn draw(
    regime: &Regime,
    steps: &[Step],
    tallies: &[Vec<Tally>],
    options: &Options,
) -> Result<(), Box<dyn Error>> {
    let height = regime.panels.len() as f64 * (HEADING + PANEL + BAND);
    let mut canvas = Canvas::new(WIDTH, height + 260.0);
    canvas.bold([12.0, 26.0], 18.0, Anchor::Start, BLACK, regime.title);
    let mut y = canvas.paragraph([16.0, 48.0], WIDTH - 32.0, 12.5, regime.caption);
    let top = y;
    for panel in &regime.panels {
        let (across, lines) = gather(regime, panel, steps, tallies);
        self::panel(&mut canvas, regime, panel, &across, &lines, y);
        y += HEADING + PANEL + BAND + 20.0;
    }
    canvas.upright([12.0, (top + y) / 2.0], 12.0, BLACK, "wrong answers per million");
    let middle = (LEFT + RIGHT) / 2.0;
    canvas.text([middle, y + 14.0], 12.0, Anchor::Middle, BLACK, regime.axis);
    let how = format!(
        "The grey band is zero: not one of {} answers at that step was wrong. Lines in it are set \
         apart so that they can be told; the exact ones lie in it from end to end. Solid: f32, \
         dashed: f64, dotted: fixed point. Wrong: false “disjoint” or “miss” and false “overlap” or \
         “hit”, by an exact oracle, on the numbers as the scalar holds them. “cargo stability” \
         counts and draws; the figures are in stability.csv.",
        grouped(f64::from(options.cases))
    );
    y = canvas.paragraph([16.0, y + 38.0], WIDTH - 32.0, 12.0, &how);
    canvas.crop(y);
    canvas.save(&options.out.join(regime.stem))
}

/// The steps of a panel and its lines, in the order of styles.
fn gather(
    regime: &Regime,
    panel: &str,
    steps: &[Step],
    tallies: &[Vec<Tally>],
) -> (Vec<f64>, BTreeMap<usize, (Style, Points)>) {
    let here = |s: &Step| s.picture == regime.stem && s.panel == panel;
    let found = |at: &f64| steps.iter().any(|s| here(s) && s.at == *at);
    let across: Vec<f64> = regime.steps.iter().copied().filter(found).collect();
    let mut lines: BTreeMap<usize, (Style, Points)> = BTreeMap::new();
    for (step, tallies) in steps.iter().zip(tallies).filter(|(step, _)| here(step)) {
        let place = across.iter().position(|at| *at == step.at).expect("one of them");
        for tally in tallies.iter().filter(|t| t.cases > 0) {
            if let Some((k, style)) = style(tally) {
                let line = lines.entry(k).or_insert((style, Vec::new()));
                line.1.push((place, tally.per_million()));
            }
        }
    }
    (across, lines)
}

fn panel(
    canvas: &mut Canvas,
    regime: &Regime,
    name: &str,
    across: &[f64],
    lines: &BTreeMap<usize, (Style, Points)>,
    top: f64,
) {
    let y = Zeroed::new([10.0, 1e6], [top + HEADING, top + HEADING + PANEL + BAND], BAND);
    let last = (across.len() - 1).max(1) as f64;
    let x = |place: usize| LEFT + 8.0 + place as f64 / last * (RIGHT - LEFT - 16.0);
    canvas.bold([LEFT, top + HEADING - 8.0], 13.0, Anchor::Start, BLACK, name);
    canvas.rect([LEFT, y.band[0]], [RIGHT - LEFT, BAND], PALE);
    for rate in y.rates.powers(10.0) {
        canvas.line([LEFT, y.at(rate)], [RIGHT, y.at(rate)], LIGHT, 0.6, "");
        canvas.text([LEFT - 5.0, y.at(rate) + 3.5], 9.5, Anchor::End, BLACK, &grouped(rate));
    }
    canvas.bold([LEFT - 5.0, y.zero() + 4.5], 13.0, Anchor::End, BLACK, "0");
    for (place, at) in across.iter().enumerate() {
        if let Some(text) = regime.ticks.text(*at) {
            canvas.line([x(place), y.rates.pixels[1]], [x(place), y.band[1]], LIGHT, 0.6, "");
            canvas.text([x(place), y.band[1] + 14.0], 11.0, Anchor::Middle, BLACK, &text);
        }
    }

    // Each line has a height of its own in the band; the exact ones the lowest.
    let mut ends = Vec::new();
    for (rank, (style, points)) in lines.values().enumerate() {
        let zero = y.band[0] + 3.0 + (rank as f64 + 0.5) * (BAND - 6.0) / lines.len() as f64;
        let at =
            |&(place, rate): &(usize, f64)| [x(place), if rate == 0.0 { zero } else { y.at(rate) }];
        let path: Vec<[f64; 2]> = points.iter().map(at).collect();
        canvas.polyline(&path, style.color, 1.6, style.dash);
        // Different steps for different lines.
        let every = (points.len() / 7).max(1);
        for point in path.iter().skip(rank % every).step_by(every) {
            style.mark.draw(canvas, *point, 3.6, style.color, true);
        }
        if let Some(&end) = path.last() {
            ends.push((end, style.label, style.color));
        }
    }
    label(canvas, ends, [top + HEADING - 4.0, y.band[1]]);
}

/// Names on the right, as near to the ends of their lines as possible.
pub(super) fn label(
    canvas: &mut Canvas,
    mut ends: Vec<([f64; 2], &str, &'static str)>,
    [top, end]: [f64; 2],
) {
    const APART: f64 = 12.5;
    ends.sort_by(|a, b| a.0[1].total_cmp(&b.0[1]));
    let mut places: Vec<f64> = Vec::new();
    for (at, ..) in &ends {
        let least = places.last().map_or(top + 8.0, |last| last + APART);
        places.push((at[1] + 4.0).max(least));
    }
    // A name that is too low moves up, and pushes up the names above it.
    let mut most = end + 2.0;
    for place in places.iter_mut().rev() {
        *place = place.min(most);
        most = *place - APART;
    }
    for ((at, text, color), place) in ends.iter().zip(places) {
        let from = RIGHT + 24.0;
        canvas.line([at[0] + 4.0, at[1]], [from - 2.0, place - 4.0], GREY, 0.5, "");
        debug_assert!(width_of(text, 11.0) < WIDTH - from);
        canvas.text([from, place], 11.0, Anchor::Start, color, text);
    }
}

impl Ticks {
    /// The text at a step, if it has one.
    pub(super) fn text(self, at: f64) -> Option<String> {
        let power = |base: u32, every: usize| {
            let exponent = at.log(f64::from(base));
            let whole = exponent.round();
            let is_one = (exponent - whole).abs() < 1e-6 && (whole as i64) % every as i64 == 0;
            is_one.then(|| power_of(base, whole as i32))
        };
        match self {
            Self::Ten(every) => power(10, every),
            Self::Two(every) => power(2, every),
            Self::Whole(every) => ((at as usize).is_multiple_of(every)).then(|| at.to_string()),
            Self::Units if at == 0.0 => Some("0".into()),
            Self::Units => (at.log2() as usize).is_multiple_of(2).then(|| grouped(at)),
        }
    }
}
