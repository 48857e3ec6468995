//! What the advisor says.

use std::fmt::Write;

use comfy_table::{CellAlignment, Table, presets};

use crate::advice::{Row, percent, recommend, sig, what_would_help};
use crate::costs::{Costs, Figure};
use crate::options::{Options, Target};
use crate::paste;
use crate::prediction::{CONFIDENCE, Prediction};
use crate::scene::Scene;
use crate::shared::grouped;
use crate::survey::Survey;

/// All of it.
pub(crate) fn write(
    name: &str,
    options: &Options,
    scene: &Scene,
    survey: &Survey,
    costs: &Costs,
) -> String {
    let parts = [
        heading(name, options, scene, survey),
        table(options, scene, survey).to_string(),
        legend(options, scene, survey, costs),
        refusals(options, scene, survey),
        recommendation(options, scene, survey),
    ];
    let parts: Vec<_> = parts.iter().map(|p| p.trim_end()).filter(|p| !p.is_empty()).collect();
    parts.join("\n\n") + "\n"
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
{} queries: each triangle against the boxes within {} of its bounding box; {sample}",
        options.target.name(),
        grouped(scene.triangles.len() as u64),
        scene.cell,
        chosen(options.cell.is_some(), "64 to 128 to the longest side; --cell"),
        sig(scene.tolerance),
        chosen(options.tolerance.is_some(), "a hundredth of a box; --tolerance"),
        grouped(all),
        sig(2.0 * scene.tolerance),
    )
}

fn table(options: &Options, scene: &Scene, survey: &Survey) -> Table {
    let host = options.target == Target::Host;
    let mut headers = vec!["type", "exact in", "moved by", "made flat", "changed"];
    if survey.asked < scene.queries() {
        headers.push("of all, predicted");
    }
    if options.full {
        headers.push("counted");
    }
    headers.extend(if host {
        ["time, f32 = 1", "table, bytes"]
    } else {
        ["instructions", "code + table, bytes"]
    });
    headers.push("good enough?");
    let mut table = Table::new();
    table.load_preset(presets::NOTHING).set_header(&headers);
    for row in &survey.rows {
        table.add_row(line(row, options, scene, survey));
    }
    for kind in &survey.too_large {
        let mut cells = vec!["–".to_owned(); headers.len()];
        cells[0] = kind.name();
        cells[headers.len() - 1] = format!("too large: it ends at {}", kind.greatest());
        table.add_row(cells);
    }
    for (i, column) in table.column_iter_mut().enumerate() {
        if i >= 2 && i + 1 < headers.len() {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table
}

fn line(row: &Row, options: &Options, scene: &Scene, survey: &Survey) -> Vec<String> {
    let (effect, prediction) = (row.effect, row.prediction);
    let mut cells = vec![
        row.kind.name(),
        row.rung.clone(),
        sig(effect.moved),
        grouped(effect.degenerate as u64),
        grouped(prediction.changed),
    ];
    if survey.asked < scene.queries() {
        cells.push(match (prediction.least, prediction.most) {
            (least, most) if least == most => grouped(least),
            (least, most) => format!("{} to {}", grouped(least), grouped(most)),
        });
    }
    cells.extend(row.counted.map(grouped));
    match options.target {
        Target::Host => {
            cells.push(row.timing.map_or("?".into(), |t| {
                format!("{:.2} ({:.2}–{:.2})", t.median, t.usual[0], t.usual[1])
            }));
            cells.push(grouped(effect.table));
        }
        Target::M0 | Target::M4f => {
            cells.push(figure(row.instructions.as_ref()));
            cells.push(format!("{} + {}", figure(row.code.as_ref()), grouped(effect.table)));
        }
    }
    cells.push(match row.refusal(scene) {
        Some(reason) => reason,
        None if row.kind.bits() > options.bits => format!("wider than {} bits", options.bits),
        None => "yes".into(),
    });
    cells
}

/// Estimates bear a sign.
fn figure(figure: Option<&Figure>) -> String {
    match figure {
        None => "?".into(),
        Some(Figure { value, is_estimate }) => {
            format!("{}{}", if *is_estimate { "≈" } else { "" }, grouped(value.round() as u64))
        }
    }
}

fn legend(options: &Options, scene: &Scene, survey: &Survey, costs: &Costs) -> String {
    let mut text = String::from(
        "Measured here: how far rounding moves a vertex or a corner of a box at most, triangles that it\n\
         makes segments or points, verdicts that it changes (exact on the rounded shapes, to exact\n\
         on those of f64), and bytes of a table of the mesh. Exact verdicts on shapes that did not\n\
         move cannot change.",
    );
    if survey.asked < scene.queries() {
        write!(
            text,
            "\nPredicted from the sample: verdicts changed of all, with {} confidence for all types \
             together.",
            percent(CONFIDENCE)
        )
        .expect("a string takes all");
    }
    if options.full {
        let predicted = survey.rows.iter().filter_map(|r| Some((r.prediction, r.counted?)));
        let (held, missed): (Vec<_>, Vec<_>) = predicted.partition(|(p, n)| p.allows(*n));
        text += &match (held.len(), missed.len()) {
            (n, 0) => format!("\nCounted in the full run: all {n} predictions hold."),
            (n, m) => {
                format!("\nCounted in the full run: {m} of {} predictions do not hold.", n + m)
            }
        };
    }
    match survey.each {
        Some(each) => {
            let nanoseconds = each.as_secs_f64() * 1e9;
            write!(
                text,
                "\nTimed here, by turns: a query to one in f32, which takes {nanoseconds:.1} ns; the \
                 median, and all\nbut the upper and lower tenth of the rounds."
            )
            .expect("a string takes all");
        }
        None if options.target == Target::Host => text += "\nNot timed: f32 cannot hold the scene.",
        None => {
            write!(
                text,
                "\nFrom tables, not from this scene: instructions on a {} where all 13 axes are tried, \
                 and bytes of\na program that is the query. ≈ is an estimate, from the type with as \
                 many bits and as exact.",
                options.target.name()
            )
            .expect("a string takes all");
            for file in &costs.missing {
                write!(text, "\n{file} is not there: its figures are unknown.").expect("it does");
            }
            if survey.rows.iter().all(|row| row.instructions.is_none()) {
                text += "\nWithout instructions, the smallest counts as the cheapest, and floats come last.";
            }
        }
    }
    text
}

/// Why narrow types will not do.
fn refusals(options: &Options, scene: &Scene, survey: &Survey) -> String {
    let widths = [8, 16, 32, 64].into_iter().filter(|&bits| bits <= options.bits);
    widths.filter_map(|bits| Some(what_would_help(bits, &survey.rows, scene)? + "\n")).collect()
}

fn recommendation(options: &Options, scene: &Scene, survey: &Survey) -> String {
    let Some(row) = recommend(&survey.rows, scene, options.bits) else {
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
        (None, cost) => format!("{} instructions, from the table", figure(cost.as_ref())),
    };
    format!(
        "Recommended: {}\n  verdicts changed: {predicted}{counted}\n  cost of a query: {cost}\n  \
         moved by: {} at most, measured; {} bytes of table\n\n{}",
        row.kind.name(),
        sig(row.effect.moved),
        grouped(row.effect.table),
        paste::lines(row.kind, scene)
    )
}
