//! The answers to a fixed stream of questions, hashed for each query and scalar: the same bits on
//! every machine, in every build, in every version.
//!
//! The example `determinism` computes the hashes, also on machines that cannot run tests; here it
//! is run in a build for development.

use std::sync::OnceLock;

use super::examples::run_as_it_is_now;

/// The rows that each version added, as `examples/determinism/golden.rs` reads them.
const KEPT: &str = include_str!("../../examples/determinism/golden/0.1.csv");

/// What the example prints: a header, a line for each query, a verdict.
fn printed() -> &'static [String] {
    static LINES: OnceLock<Vec<String>> = OnceLock::new();
    LINES.get_or_init(|| {
        let output = run_as_it_is_now("determinism");
        String::from_utf8(output.stdout).unwrap().lines().map(String::from).collect()
    })
}

/// The first words of the lines, and the hashes of each.
fn rows() -> impl Iterator<Item = (String, Vec<&'static str>)> {
    let lines = printed();
    lines[1..lines.len() - 1].iter().map(|line| {
        let (query, hashes) = line.split_at(31);
        (query.trim_end().to_string(), hashes.split_whitespace().collect())
    })
}

/// A later version may only add rows. A hash that is not kept has an exclamation mark: a new row
/// has to be added to the table of the coming version.
#[test]
fn every_row_is_as_it_is_kept() {
    let mut kept: Vec<&str> = KEPT.lines().skip(1).collect();
    for (query, hashes) in rows() {
        let line = format!("{query},{}", hashes.join(","));
        let same = kept.iter().position(|kept| *kept == line);
        kept.remove(same.unwrap_or_else(|| panic!("not kept, or kept otherwise: {line}")));
        assert!(hashes.iter().any(|hash| *hash != "-"), "{query} is never asked");
    }
    assert!(kept.is_empty(), "kept rows that are not printed, once each: {kept:?}");
}

#[test]
fn the_page_shows_rows_of_the_table() {
    let page = include_str!("../../DETERMINISM.md");
    let [header, rows @ .., verdict] = printed() else { panic!("a table") };
    let (_, below) = page.split_once(&format!("{header}\n")).expect("the page has the header");
    let shown: Vec<&str> = below.lines().take_while(|line| *line != "...").collect();
    assert!(shown.len() >= 5);
    for line in shown {
        assert!(rows.iter().any(|row| row == line), "DETERMINISM.md shows: {line}");
    }
    let counts: Vec<_> = page.matches(" queries, 6 scalars").collect();
    let right = format!("{} queries, 6 scalars", rows.len());
    assert_eq!(page.matches(&right).count(), counts.len(), "{right}");
    assert_eq!(*verdict, format!("{right}: as everywhere"));
}
