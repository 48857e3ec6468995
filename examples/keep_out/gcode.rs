//! G-code for tool moves: G0 and G1 to X, Y, Z, tilted by A and B.
//!
//! Millimetres and degrees, absolute (G21, G90). Words that do not move the tool (feed, spindle,
//! coolant) are parsed and ignored. Anything unknown is an error with its line number, because a
//! check that skipped lines would be worthless.

use fixed::types::I16F16;

/// The position of the tool's tip in millimetres, and the tilt of the tool about x and y in
/// degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Position {
    pub(crate) tip: [I16F16; 3],
    pub(crate) tilt: [I16F16; 2],
}

/// A straight move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Move {
    pub(crate) line: u32,
    pub(crate) from: Position,
    pub(crate) to: Position,
}

/// The error in a line, and its letter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Fault {
    pub(crate) line: u32,
    pub(crate) at: char,
    pub(crate) what: &'static str,
}

/// The moves of a program. It ends at the first error.
pub(crate) struct Program<'a> {
    lines: core::str::Lines<'a>,
    line: u32,
    at: Position,
    is_over: bool,
}

impl<'a> Program<'a> {
    /// A program, with the tool at its first position.
    pub(crate) fn new(text: &'a str, start: Position) -> Self {
        Self { lines: text.lines(), line: 0, at: start, is_over: false }
    }
}

impl Iterator for Program<'_> {
    type Item = Result<Move, Fault>;

    fn next(&mut self) -> Option<Self::Item> {
        while !self.is_over {
            let text = self.lines.next()?;
            self.line += 1;
            let line = self.line;
            match Line::read(text) {
                Err((at, what)) => {
                    self.is_over = true;
                    return Some(Err(Fault { line, at, what }));
                }
                Ok(read) => {
                    self.is_over = read.is_last;
                    let from = self.at;
                    let [x, y, z, a, b] = read.to;
                    let [px, py, pz] = from.tip;
                    let [pa, pb] = from.tilt;
                    let to = Position {
                        tip: [x.unwrap_or(px), y.unwrap_or(py), z.unwrap_or(pz)],
                        tilt: [a.unwrap_or(pa), b.unwrap_or(pb)],
                    };
                    self.at = to;
                    if read.to.iter().any(Option::is_some) {
                        return Some(Ok(Move { line, from, to }));
                    }
                }
            }
        }
        None
    }
}

/// A line: its target in X, Y, Z, A and B, and whether it ends the program.
#[derive(Default)]
struct Line {
    to: [Option<I16F16>; 5],
    is_last: bool,
}

impl Line {
    fn read(text: &str) -> Result<Self, (char, &'static str)> {
        let mut line = Self::default();
        // `%` alone marks the beginning and the end of a program.
        let mut rest = if text.trim() == "%" { "" } else { text };
        while let Some(letter) = rest.chars().next() {
            rest = &rest[letter.len_utf8()..];
            match letter {
                ';' => break,
                '(' => match rest.find(')') {
                    Some(end) => rest = &rest[end + 1..],
                    None => return Err((letter, "the comment does not end")),
                },
                _ if letter.is_ascii_whitespace() => {}
                _ => {
                    let letter = letter.to_ascii_uppercase();
                    rest = rest.trim_start();
                    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.');
                    let end = rest.find(|c| !is_part(c)).unwrap_or(rest.len());
                    let (number, after) = rest.split_at(end);
                    line.take(letter, number).map_err(|what| (letter, what))?;
                    rest = after;
                }
            }
        }
        Ok(line)
    }

    fn take(&mut self, letter: char, number: &str) -> Result<(), &'static str> {
        if !letter.is_ascii_alphabetic() {
            return Err("a word begins with a letter");
        }
        if !number.contains(|c: char| c.is_ascii_digit()) {
            return Err("a number is missing");
        }
        let number: I16F16 =
            number.parse().map_err(|_| "that is no number, or one beyond 32,767")?;
        let code = (number.frac() == 0).then(|| number.to_num::<i32>());
        match letter {
            'X' | 'Y' | 'Z' | 'A' | 'B' => {
                let place = &mut self.to[match letter {
                    'X' => 0,
                    'Y' => 1,
                    'Z' => 2,
                    'A' => 3,
                    _ => 4,
                }];
                if place.replace(number).is_some() {
                    return Err("the letter is there twice");
                }
            }
            // Straight moves, and G0 counts as one. The plane of arcs, millimetres, absolute, feed.
            'G' if matches!(code, Some(0 | 1 | 17 | 21 | 90 | 94)) => {}
            'G' => return Err("this code is not understood: only G0 and G1, in G21 and G90"),
            'M' => self.is_last |= matches!(code, Some(2 | 30)),
            'F' | 'S' | 'T' | 'N' => {}
            _ => return Err("no word of a move begins so"),
        }
        Ok(())
    }
}
