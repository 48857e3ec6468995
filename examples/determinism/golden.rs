//! The golden tables: the same on every machine, and in every later version.

use core::fmt;

#[path = "table.rs"]
pub(crate) mod table;

use table::{Cell, SCALARS};

/// The rows that each version added, oldest first. The table of a version has all rows down to its
/// own. A row of a released version never changes and is never removed.
const VERSIONS: [&str; 1] = [include_str!("golden/0.1.csv")];

/// Whether the hashes of a scalar are asked for.
pub(crate) fn is_asked(scalar: usize) -> bool {
    SCALARS[scalar].1.is_some()
}

/// The hashes of one query.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Row<'a> {
    pub(crate) query: &'a str,
    pub(crate) cells: [Cell; SCALARS.len()],
}

impl<'a> Row<'a> {
    /// A line of a golden table: the query, and for each scalar a hash in hexadecimal digits, or a
    /// dash. An unreadable number equals no computed one.
    fn read(line: &'a str) -> Self {
        let mut columns = line.trim_end().split(',');
        let query = columns.next().unwrap_or_default();
        let cells = [(); SCALARS.len()].map(|()| match columns.next() {
            Some("-") => 0,
            Some(hash) => Cell::from_str_radix(hash, 16).unwrap_or(Cell::MAX),
            None => Cell::MAX,
        });
        Self { query, cells }
    }

    /// Whether the cell of a scalar matches the golden table.
    fn is_kept(&self, scalar: usize) -> bool {
        kept().any(|kept| kept.query == self.query && kept.cells[scalar] == self.cells[scalar])
    }

    /// Whether the row matches the golden table, as far as it is asked for.
    pub(crate) fn is_as_everywhere(&self) -> bool {
        (0..SCALARS.len()).all(|scalar| !is_asked(scalar) || self.is_kept(scalar))
    }
}

/// The rows of all versions.
pub(crate) fn kept() -> impl Iterator<Item = Row<'static>> {
    VERSIONS.iter().flat_map(|table| table.lines().skip(1)).map(Row::read)
}

/// Prints the row, with an exclamation mark after each hash that differs from the golden table.
impl fmt::Display for Row<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:31}", self.query)?;
        for (scalar, &cell) in self.cells.iter().enumerate() {
            let mark = if !is_asked(scalar) || self.is_kept(scalar) { "" } else { "!" };
            match cell {
                0 => write!(f, " {:>8}{mark}", "-")?,
                _ => write!(f, " {cell:08x}{mark}")?,
            }
        }
        if self.is_as_everywhere() { Ok(()) } else { f.write_str(" DIFFERS") }
    }
}

/// The line over the rows.
pub(crate) struct Header;

impl fmt::Display for Header {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:31}", "query")?;
        SCALARS.iter().try_for_each(|(name, _)| write!(f, " {name:>8}"))
    }
}
