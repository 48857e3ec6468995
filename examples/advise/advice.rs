//! The choice of the type, and the reasons against other types.

use crate::costs::Figure;
use crate::effect::Effect;
use crate::kind::{Kind, most_fraction_bits};
use crate::prediction::Prediction;
use crate::question::Off;
use crate::race::Timing;
use crate::scene::Scene;

/// The findings about a type that holds the scene.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    pub(crate) kind: Kind,
    pub(crate) effect: Effect,
    /// The error of the numbers in its answers.
    pub(crate) off: Option<Off>,
    /// The stages that decide the queries, a line for each.
    pub(crate) stages: String,
    pub(crate) prediction: Prediction,
    /// Verdicts that changed in the full run.
    pub(crate) counted: Option<u64>,
    pub(crate) timing: Option<Timing>,
    pub(crate) instructions: Option<Figure>,
    /// Microseconds of a query on a small core.
    pub(crate) time: Option<Figure>,
    pub(crate) code: Option<Figure>,
}

/// The times of the type are too coarse for the length of the motion.
const COARSE: &str = "coarse times";

/// Costs within this ratio count as the same.
const SAME: f64 = 1.05;

impl Row {
    /// The reason against the type, if there is one.
    pub(crate) fn refusal(&self, scene: &Scene) -> Option<&'static str> {
        let Effect { moved, flat, .. } = self.effect;
        if flat {
            Some("flat boxes")
        } else if moved > scene.tolerance {
            Some("moved too far")
        } else if self.stride(scene) > scene.tolerance {
            Some(COARSE)
        } else {
            None
        }
    }

    /// The distance that a box moves between two consecutive times of the type, or between its last
    /// time and 1. A rounded time of impact may stop the box that far before the contact.
    fn stride(&self, scene: &Scene) -> f64 {
        let [x, y, z] = scene.question.way();
        let unit = match self.kind {
            Kind::Fixed { frac, .. } => f64::from(frac).exp2().recip(),
            Kind::F32 => 2_f64.powi(-24),
            Kind::F64 => 2_f64.powi(-53),
        };
        x.hypot(y).hypot(z) * unit.max(1.0 - self.kind.rounded_down(1.0))
    }

    /// The time or the instructions of a query, whichever is known.
    fn cost(&self) -> Option<f64> {
        self.timing.map(|t| t.median).or(self.instructions.as_ref().map(|i| i.value))
    }
}

/// The cheapest type of at most `bits` bits that moves nothing too far. Among types of about the
/// same cost it prefers the smallest table, then the finest unit. Without known costs it takes the
/// narrowest type, and fixed point before floats.
pub(crate) fn recommend<'a>(rows: &'a [Row], scene: &Scene, bits: u32) -> Option<&'a Row> {
    let good = || rows.iter().filter(|row| row.refusal(scene).is_none() && row.kind.bits() <= bits);
    let least = good().filter_map(Row::cost).min_by(f64::total_cmp);
    let is_cheap = |row: &&Row| match least {
        Some(least) => row.cost().is_some_and(|cost| cost <= least * SAME),
        None => true,
    };
    good().filter(is_cheap).min_by(|a, b| {
        let size = |row: &Row| (least.is_none() && row.kind.is_float(), row.effect.table);
        size(a).cmp(&size(b)).then(a.effect.moved.total_cmp(&b.effect.moved))
    })
}

/// The reason why no type of `bits` bits is good enough, and possible remedies.
pub(crate) fn what_would_help(bits: u32, rows: &[Row], scene: &Scene) -> Option<String> {
    let of_width = || rows.iter().filter(|r| r.kind.bits() == bits && !r.kind.is_float());
    if of_width().any(|row| row.refusal(scene).is_none()) {
        return None;
    }
    let best = of_width().min_by(|a, b| a.effect.moved.total_cmp(&b.effect.moved));
    let (why, mut ways) = match best {
        None => too_large(bits, scene),
        Some(row) if row.refusal(scene) == Some(COARSE) => too_coarse(row, scene),
        Some(row) => too_fine(row, scene),
    };
    ways.extend(about_the_middle(bits, best, scene));
    let ways: String = ways.iter().map(|way| format!("\n  - {way}")).collect();
    Some(format!("{bits} bits: {why}.\nWhat would help:{ways}"))
}

fn too_large(bits: u32, scene: &Scene) -> (String, Vec<String>) {
    let range = scene.range();
    let [least, greatest] = range.map(sig);
    let most = (1_u64 << (bits - 1)) - 1;
    let fits = |k: &i32| {
        let shrunk = range.map(|x| x * f64::from(-k).exp2());
        most_fraction_bits(bits, bits, shrunk).is_some()
    };
    let halvings = (1..).find(fits).unwrap_or(1);
    let tolerance = up(worst(0) * f64::from(halvings).exp2());
    let why = format!(
        "too large: the scene reaches from {least} to {greatest}, and {bits} bits end at {most}"
    );
    let way = format!(
        "the scene at 1/2^{halvings} of its size, with a tolerance that is {tolerance} at today's"
    );
    (why, vec![way])
}

fn too_coarse(row: &Row, scene: &Scene) -> (String, Vec<String>) {
    let far = row.stride(scene);
    let frac = row.kind.fraction_bits();
    let why = format!(
        "coarse times: with {frac} fraction bits a box goes up to {} between two times, beyond {}",
        sig(far),
        sig(scene.tolerance)
    );
    let ways = vec![
        format!("--tolerance {} ({} of a box)", up(far), percent(far / scene.cell)),
        format!("a way of 1/{} or less at a time, more often", (far / scene.tolerance).ceil()),
    ];
    (why, ways)
}

fn too_fine(row: &Row, scene: &Scene) -> (String, Vec<String>) {
    let (bits, Effect { moved, flat, .. }) = (row.kind.bits(), row.effect);
    let frac = row.kind.fraction_bits();
    let range @ [least, greatest] = scene.range();
    let mut ways = Vec::new();
    if flat {
        let unit = f64::from(frac).exp2().recip();
        ways.push(format!("boxes of {} or more, so that none is flat", sig(unit)));
    }
    ways.push(format!("--tolerance {} ({} of a box)", up(moved), percent(moved / scene.cell)));
    let times = up(moved / scene.tolerance);
    ways.push(format!("boxes about {times} times as large, if the tolerance grows with them"));
    let spare = if frac == bits { spare_doublings(bits, range) } else { 0 };
    if spare > 0 {
        let enough = is_enough(moved / f64::from(spare).exp2(), scene);
        ways.push(format!("the scene at 2^{spare} times its size, to use all bits{enough}"));
    }
    let why = format!(
        "too fine: {frac} fraction bits beside ±{} move a corner by up to {}, beyond {}{}",
        sig(least.abs().max(greatest.abs())),
        sig(moved),
        sig(scene.tolerance),
        if flat { "; boxes become flat" } else { "" }
    );
    (why, ways)
}

/// The number of fraction bits with the origin in the middle of the scene.
fn about_the_middle(bits: u32, best: Option<&Row>, scene: &Scene) -> Option<String> {
    let mut offset = [0.0; 3];
    let mut range = [0.0_f64; 2];
    for (axis, offset) in offset.iter_mut().enumerate() {
        let [least, greatest] = scene.extent(axis);
        // The scene moves by whole boxes, so that the grid of boxes stays the same.
        *offset = 0.0 - ((least + greatest) / 2.0 / scene.cell).round() * scene.cell;
        range = [range[0].min(least + *offset), range[1].max(greatest + *offset)];
    }
    let now = best.map(|row| row.kind.fraction_bits());
    let then = most_fraction_bits(bits, bits, range)?;
    let [x, y, z] = offset;
    let enough = is_enough(worst(then), scene);
    now.is_none_or(|now| then > now).then(|| {
        format!("the scene moved by ({x}, {y}, {z}): room for {then} fraction bits{enough}")
    })
}

fn is_enough(moved: f64, scene: &Scene) -> &'static str {
    if moved <= scene.tolerance { ", which is enough" } else { ", not enough alone" }
}

/// The greatest distance by which rounding moves a point.
fn worst(frac: u32) -> f64 {
    3_f64.sqrt() / 2.0 / f64::from(frac).exp2()
}

/// The number of times that the scene could be doubled in size.
fn spare_doublings(bits: u32, range: [f64; 2]) -> u32 {
    let fits = |k: u32| {
        let grown = range.map(|x| x * f64::from(k).exp2());
        most_fraction_bits(bits, bits, grown) == Some(bits)
    };
    (1..1024).take_while(|&k| fits(k)).last().unwrap_or(0)
}

/// A number with three digits.
pub(crate) fn sig(x: f64) -> String {
    rounded(x, f64::round)
}

/// A number with three digits, rounded up.
fn up(x: f64) -> String {
    rounded(x, f64::ceil)
}

fn rounded(x: f64, round: fn(f64) -> f64) -> String {
    if x == 0.0 {
        return "0".into();
    }
    let digits = 2 - x.abs().log10().floor() as i32;
    let unit = 10_f64.powi(digits);
    let x = round(x * unit) / unit;
    if !(-3..=6).contains(&digits) {
        return format!("{x:.2e}");
    }
    let text = format!("{x:.*}", digits.max(0) as usize);
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').into(),
        false => text,
    }
}

pub(crate) fn percent(x: f64) -> String {
    format!("{} %", sig(100.0 * x))
}
