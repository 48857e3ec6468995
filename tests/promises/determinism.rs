//! The answers to a fixed stream of questions, hashed for each query and scalar: the same bits on
//! every machine, in every build, in every version.
//!
//! `cargo run --release --example determinism` computes the same hashes, also on machines that
//! cannot run tests.

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
    let columns = COLUMNS.get_or_init(|| SCALARS.map(|(_, column)| column()));
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

/// A later version may only add rows.
#[test]
fn every_kept_row_is_what_it_was() {
    for kept in kept() {
        let row = rows().find(|row| row.query == kept.query);
        let row = row.unwrap_or_else(|| panic!("{}: a kept row is never removed", kept.query));
        assert_eq!(csv(&row), csv(&kept));
    }
}

#[test]
fn every_query_has_one_row_that_is_kept() {
    for row in rows() {
        let same = kept().filter(|kept| kept.query == row.query).count();
        assert_eq!(same, 1, "kept rows; add to the table of the coming version: {}", csv(&row));
        assert_eq!(ROWS.iter().filter(|&&query| query == row.query).count(), 1, "{}", row.query);
        assert!(row.cells.iter().any(|&cell| cell != 0), "{} is never asked", row.query);
    }
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
