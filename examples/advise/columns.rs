//! The tables that the advisor prints: what rounding does, and what queries cost.

use comfy_table::{CellAlignment, ColumnConstraint, ContentArrangement, Table, presets};

use crate::advice::{Row, sig};
use crate::costs::Figure;
use crate::options::{Options, Target};
use crate::report::WIDTH;
use crate::scene::Scene;
use crate::survey::Survey;
use septum_kit::jobs::grouped;

/// The effects of rounding to each type on the scene.
pub(crate) fn effects(scene: &Scene, survey: &Survey, full: bool) -> String {
    let is_predicted = survey.asked < scene.queries();
    let mut headers = vec!["type", "moved by", "made flat", "changed"];
    headers.extend(is_predicted.then_some("of all, predicted"));
    headers.extend(full.then_some("counted"));
    let off =
        scene.question.number().map(|number| [format!("{number} off,\n99 %"), "at most".into()]);
    headers.extend(off.iter().flatten().map(|header: &String| header.as_str()));
    let line = |row: &Row| {
        let prediction = row.prediction;
        let mut cells = vec![
            row.kind.name(),
            sig(row.effect.moved),
            grouped(row.effect.degenerate as u64),
            grouped(prediction.changed),
        ];
        cells.extend(is_predicted.then(|| match (prediction.least, prediction.most) {
            (least, most) if least == most => grouped(least),
            (least, most) => format!("{} to {}", grouped(least), grouped(most)),
        }));
        cells.extend(row.counted.map(grouped));
        if off.is_some() {
            let figures = row.off.map(|off| [sig(off.usual), sig(off.most)]);
            cells.extend(figures.unwrap_or_else(|| ["?", "?"].map(String::from)));
        }
        cells
    };
    text(&headers, survey.rows.iter().map(line), 1..headers.len())
}

/// The cost of a query in each type, and whether the type is good enough.
pub(crate) fn costs(options: &Options, scene: &Scene, survey: &Survey) -> String {
    let headers = if options.target == Target::Host {
        vec!["type", "exact in", "time, f32 = 1", "table,\nbytes", "good enough?"]
    } else {
        let [code, table] = ["code,\nbytes", "table,\nbytes"];
        vec!["type", "exact in", "instructions", "µs at\n48 MHz", code, table, "good enough?"]
    };
    let line = |row: &Row| {
        let mut cells = vec![row.kind.name(), row.stages.clone()];
        match options.target {
            Target::Host => cells.push(row.timing.map_or("?".into(), |t| {
                format!("{:.2} ({:.2}–{:.2})", t.median, t.usual[0], t.usual[1])
            })),
            Target::M0 | Target::M4f | Target::Rv32 => {
                cells.push(figure(row.instructions.as_ref()));
                cells.push(figure(row.time.as_ref()));
                cells.push(figure(row.code.as_ref()));
            }
        }
        cells.push(grouped(row.effect.table));
        cells.push(match row.refusal(scene) {
            Some(reason) => reason.into(),
            None if row.kind.bits() > options.bits => format!("over {} bits", options.bits),
            None => "yes".into(),
        });
        cells
    };
    text(&headers, survey.rows.iter().map(line), 2..headers.len() - 1)
}

/// A figure of a table. Estimates bear a sign.
pub(crate) fn figure(figure: Option<&Figure>) -> String {
    match figure {
        None => "?".into(),
        Some(Figure { value, is_estimate }) => {
            format!("{}{}", if *is_estimate { "≈" } else { "" }, grouped(value.round() as u64))
        }
    }
}

/// A table, the numbers in columns aligned to the right. Cells too long for its
/// width are broken.
fn text(
    headers: &[&str],
    rows: impl Iterator<Item = Vec<String>>,
    numbers: std::ops::Range<usize>,
) -> String {
    let mut table = Table::new();
    table.load_preset(presets::NOTHING).set_header(headers.iter().copied()).add_rows(rows);
    table.set_content_arrangement(ContentArrangement::Dynamic).set_width(WIDTH as u16);
    for (i, column) in table.column_iter_mut().enumerate() {
        column.set_padding((0, 2));
        if i == 0 {
            column.set_constraint(ColumnConstraint::ContentWidth);
        }
        if numbers.contains(&i) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table.trim_fmt()
}
