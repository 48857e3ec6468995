//! The text that the advisor prints.

use crate::advice::{Row, percent, recommend, sig, what_would_help};
use crate::columns::{self, figure};
use crate::costs::Costs;
use crate::kind::Kind;
use crate::options::{Options, Target};
use crate::paste;
use crate::prediction::{CONFIDENCE, Prediction};
use crate::question::Question;
use crate::scene::Scene;
use crate::survey::Survey;
use septum_kit::jobs::grouped;

/// The columns of a terminal. No line is longer.
pub(crate) const WIDTH: usize = 80;

/// The whole report.
pub(crate) fn write(
    name: &str,
    options: &Options,
    scene: &Scene,
    survey: &Survey,
    costs: &Costs,
) -> String {
    let recommended = recommend(&survey.rows, scene, options.bits);
    let parts = [
        filled(&heading(name, options, scene, survey)),
        columns::effects(scene, survey, options.full),
        columns::costs(options, scene, survey),
        filled(&too_large(survey)),
        filled(&legend(options, scene, survey, costs)),
        filled(&refusals(options, scene, survey)),
        filled(&recommendation(recommended, options, scene, survey)),
        recommended.map_or(String::new(), |row| paste::lines(row.kind, scene)),
    ];
    let parts: Vec<_> = parts.iter().map(|p| p.trim_end()).filter(|p| !p.is_empty()).collect();
    parts.join("\n\n") + "\n"
}

/// Breaks lines that are too long. The rest of such a line is indented by four.
fn filled(text: &str) -> String {
    let mut out = String::new();
    for line in text.lines() {
        let start = line.len() - line.trim_start().len();
        let mut column = start;
        out.push_str(&line[..start]);
        for (i, word) in line.split_whitespace().enumerate() {
            let length = word.chars().count();
            if i > 0 && column + 1 + length > WIDTH {
                out.push_str("\n    ");
                column = 4;
            } else if i > 0 {
                out.push(' ');
                column += 1;
            }
            out.push_str(word);
            column += length;
        }
        out.push('\n');
    }
    out
}

fn heading(name: &str, options: &Options, scene: &Scene, survey: &Survey) -> String {
    let [x, y, z] = [0, 1, 2].map(|axis| {
        let [least, greatest] = scene.extent(axis);
        format!("[{}, {}]", sig(least), sig(greatest))
    });
    let chosen = |given: bool, how: &str| if given { String::new() } else { format!(" ({how})") };
    let all = scene.queries();
    let sample = if survey.asked == all {
        "all of them are asked in every type".into()
    } else {
        format!("{} drawn by chance are asked in every type", grouped(survey.asked))
    };
    format!(
        "{name} for {}: {} triangles; with the boxes they fill {x} × {y} × {z}
boxes of {}{}, corners at multiples of it
tolerance {}{}
{} queries: each triangle against the boxes {}within {} of its bounding box; {sample}",
        options.target.name(),
        grouped(scene.triangles.len() as u64),
        scene.cell,
        chosen(options.cell.is_some(), "64 to 128 to the longest side; --cell"),
        sig(scene.tolerance),
        chosen(options.tolerance.is_some(), "a hundredth of a box; --tolerance"),
        grouped(all),
        match scene.question {
            Question::Sweep([x, y, z]) => {
                format!("that move by ({x}, {y}, {z}) and come, box about box, ")
            }
            question if question.turns() => "turned about their middles, and ".into(),
            Question::Triangle => "or the triangles across them, ".into(),
            Question::Sphere => "or the spheres in them, ".into(),
            Question::Capsule => "or the capsules in them, ".into(),
            Question::Closest => "or the middles of those, ".into(),
            _ => String::new(),
        },
        sig(scene.question.slack() * scene.tolerance),
    )
}

/// The types that cannot hold the scene.
fn too_large(survey: &Survey) -> String {
    let name = |kind: &Kind| format!("{} (below {})", kind.name(), kind.end());
    let names: Vec<_> = survey.too_large.iter().map(name).collect();
    if names.is_empty() {
        return String::new();
    }
    format!("Too large for {}.", names.join(", "))
}

fn legend(options: &Options, scene: &Scene, survey: &Survey, costs: &Costs) -> String {
    let mut text = String::from(
        "moved by: how far rounding moves a vertex or a corner of a box at most, measured.\n\
         made flat: triangles that rounding makes segments or points, counted.\n\
         changed: verdicts that rounding changes, counted on the queries asked. Both verdicts \
         are exact, one on the rounded shapes and one on those of f64. Where nothing moves \
         none can change.\n",
    );
    if survey.asked < scene.queries() {
        let confidence = percent(CONFIDENCE);
        text += &format!(
            "of all, predicted: from the queries asked, with {confidence} confidence for all types \
             together.\n"
        );
    }
    if options.full {
        let predicted = survey.rows.iter().filter_map(|r| Some((r.prediction, r.counted?)));
        let (held, missed): (Vec<_>, Vec<_>) = predicted.partition(|(p, n)| p.allows(*n));
        text += &match (held.len(), missed.len()) {
            (n, 0) => format!("counted: on all queries; all {n} predictions hold.\n"),
            (n, m) => {
                format!("counted: on all queries; {m} of {} predictions do not hold.\n", n + m)
            }
        };
    }
    if let Some(number) = scene.question.number() {
        let how = match scene.question {
            Question::Sweep(_) => "down: it is the part of the way, early by the rounding alone",
            Question::Closest => "to the nearest",
            _ => "up",
        };
        text += &format!(
            "{number} off: how far the {number} is from that of f64, on the queries asked that \
             have one in both. The type rounds it {how}.\n"
        );
    }
    text += "exact in: the arithmetic that settles a query, and the share of the queries";
    text += match scene.question.is_staged_otherwise() {
        true => "; docs/scalars.md has that of fixed point.\n",
        false => ".\n",
    };
    match survey.each {
        Some(each) => {
            let nanoseconds = each.as_secs_f64() * 1e9;
            text += &format!(
                "time: of a query, measured by turns; f32 takes {nanoseconds:.1} ns. The median, and \
                 all but the upper and lower tenth of the rounds.\n"
            );
        }
        None if options.target == Target::Host => text += "Not timed: f32 cannot hold the scene.\n",
        None => text += &legend_of_tables(options, scene, survey, costs),
    }
    text + "table: bytes of the mesh, each vertex once.\n"
}

fn legend_of_tables(options: &Options, scene: &Scene, survey: &Survey, costs: &Costs) -> String {
    let mut text = format!(
        "instructions: {}. µs: the same, {}. code: of a \
         program that is the query. They come from tables, not from this scene. ≈ is an estimate, \
         from the type with as many bits and as exact.\n",
        scene.question.that_is_tabled().replace("{core}", options.target.name()),
        match options.target {
            Target::M0 if costs.has_cycles() => {
                "by Arm's table of cycles, multiplying in one, with memory that does not wait"
            }
            _ => "if each instruction took one cycle, which is a lower bound",
        },
    );
    for file in &costs.missing {
        text += &format!("{file} is not there: its figures are unknown.\n");
    }
    if survey.rows.iter().all(|row| row.instructions.is_none()) {
        text +=
            "Without instructions, the smallest counts as the cheapest, and floats come last.\n";
    }
    text
}

/// The reasons why no type of a width is good enough, for each such width.
fn refusals(options: &Options, scene: &Scene, survey: &Survey) -> String {
    let widths = [8, 16, 32, 64].into_iter().filter(|&bits| bits <= options.bits);
    widths.filter_map(|bits| Some(what_would_help(bits, &survey.rows, scene)? + "\n")).collect()
}

fn recommendation(
    recommended: Option<&Row>,
    options: &Options,
    scene: &Scene,
    survey: &Survey,
) -> String {
    let Some(row) = recommended else {
        return format!("Nothing of up to {} bits is good enough.", options.bits);
    };
    let Prediction { changed, least, most } = row.prediction;
    let (all, asked) = (grouped(scene.queries()), grouped(survey.asked));
    let predicted = match (least, most) {
        _ if row.effect.moved == 0.0 => format!("none of {all}, for nothing moves"),
        (least, most) if least == most => format!("{} of {all}, counted", grouped(most)),
        (least, most) => format!(
            "{} of {asked} asked, {} to {} of all {all} predicted",
            grouped(changed),
            grouped(least),
            grouped(most)
        ),
    };
    let counted = row.counted.map_or(String::new(), |n| format!(", {} counted", grouped(n)));
    let cost = match (&row.timing, &row.instructions) {
        (Some(timing), _) => format!("{:.2} times the time of f32, measured", timing.median),
        (None, None) => "unknown".into(),
        (None, cost) => format!(
            "{} instructions, {} µs at 48 MHz, from tables",
            figure(cost.as_ref()),
            figure(row.time.as_ref())
        ),
    };
    let off = match (scene.question.number(), row.off) {
        (Some(number), Some(off)) => format!(
            "\n  {number} off: 99 % by {} or less, {} at most, measured",
            sig(off.usual),
            sig(off.most)
        ),
        (Some(number), None) => format!("\n  {number} off: unknown, no query asked has one"),
        (None, _) => String::new(),
    };
    format!(
        "Recommended: {}\n  verdicts changed: {predicted}{counted}{off}\n  cost of a query: {cost}\n  \
         moved by: {} at most, measured; {} bytes of table",
        row.kind.name(),
        sig(row.effect.moved),
        grouped(row.effect.table),
    )
}
