//! The answers to a fixed stream of questions, hashed for each query and scalar: the same bits on
//! every machine, in every build, in every version.
//!
//! The example `determinism` computes the same hashes, also on machines that cannot run tests. Its
//! questions are compiled here with those of the other promises, whose code they share.

use std::fmt::Write;
use std::sync::OnceLock;

#[path = "../../examples/determinism/draw.rs"]
mod draw;
#[path = "../../examples/determinism/golden.rs"]
mod golden;
#[path = "../../examples/determinism/stream.rs"]
mod stream;

use golden::table::{Column, SCALARS};
use golden::{Header, Row, kept};
use stream::queries::ROWS;

/// The rows as computed here.
fn rows() -> impl Iterator<Item = Row<'static>> {
    static COLUMNS: OnceLock<[Column; SCALARS.len()]> = OnceLock::new();
    let all = || SCALARS.map(|(name, column)| column.expect(name)());
    let columns = COLUMNS.get_or_init(all);
    let cells = |k: usize| columns.map(|column| column[k]);
    ROWS.iter().enumerate().map(move |(k, query)| Row { query, cells: cells(k) })
}

/// The row's name in a golden table, and its hashes.
fn csv(row: &Row<'_>) -> String {
    let mut line = row.query.to_string();
    for cell in row.cells {
        let _ = if cell == 0 { write!(line, ",-") } else { write!(line, ",{cell:08x}") };
    }
    line
}

/// A later version may only add rows. A row that is not kept has to be added to the table of the
/// coming version.
#[test]
fn every_row_is_as_it_is_kept() {
    let mut kept: Vec<String> = kept().map(|row| csv(&row)).collect();
    for row in rows() {
        let line = csv(&row);
        let same = kept.iter().position(|kept| *kept == line);
        kept.remove(same.unwrap_or_else(|| panic!("not kept, or kept otherwise: {line}")));
        assert!(row.is_as_everywhere(), "{row}");
        assert!(row.cells.iter().any(|&cell| cell != 0), "{} is never asked", row.query);
    }
    assert!(kept.is_empty(), "kept rows that are not computed, once each: {kept:?}");
}

#[test]
fn the_page_shows_rows_of_the_table() {
    let page = include_str!("../../DETERMINISM.md");
    let printed: Vec<String> = rows().map(|row| row.to_string()).collect();
    let (_, below) = page.split_once(&format!("{Header}\n")).expect("the page has the header");
    let shown: Vec<&str> = below.lines().take_while(|line| *line != "...").collect();
    assert!(shown.len() >= 5);
    for line in shown {
        assert!(printed.iter().any(|row| row == line), "DETERMINISM.md shows: {line}");
    }
    let counts: Vec<_> = page.matches(" queries, 6 scalars").collect();
    let right = format!("{} queries, 6 scalars", ROWS.len());
    assert_eq!(page.matches(&right).count(), counts.len(), "{right}");
}
