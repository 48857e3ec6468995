//! The table: for each query and scalar, a hash over the answers to that query alone.

use fixed::types::{I4F4, I8F8, I16F16, I32F32};

use super::super::draw::Draw;
use super::super::stream::answers::{Answers, Hash};
use super::super::stream::queries::{Query, ROWS};
use super::super::stream::{CASES, ask};

/// A scalar's name, and its column if it is asked for.
pub(crate) type Scalar = (&'static str, Option<fn() -> Column>);

/// A hash for each query.
pub(crate) type Column = [Cell; ROWS.len()];

/// The scalars that are asked for, if not all: `ONLY_SCALARS="f32 I16F16" cargo run …`. A build for
/// development asks none by itself, because `cargo test` builds the example too, and asks all in the
/// tests.
const ONLY: Option<&str> = match option_env!("ONLY_SCALARS") {
    _ if cfg!(test) => None,
    None if cfg!(debug_assertions) => Some(""),
    only => only,
};

/// The scalars, in the order of the columns.
pub(crate) const SCALARS: [Scalar; 6] = [
    scalar::<f32>("f32"),
    scalar::<f64>("f64"),
    scalar::<I4F4>("I4F4"),
    scalar::<I8F8>("I8F8"),
    scalar::<I16F16>("I16F16"),
    scalar::<I32F32>("I32F32"),
];

/// Known to the compiler, so that a scalar that is not asked for is not compiled either: the questions
/// take most of a minute for each.
const fn scalar<S: Draw>(name: &'static str) -> Scalar {
    let is_asked = match ONLY {
        None => true,
        Some(only) => is_among(only.as_bytes(), name.as_bytes()),
    };
    (name, if is_asked { Some(column::<S>) } else { None })
}

/// Whether a list has a name. No name of a scalar is a part of another one's.
const fn is_among(list: &[u8], name: &[u8]) -> bool {
    let mut start = 0;
    while start + name.len() <= list.len() {
        let mut same = 0;
        while same < name.len() && list[start + same] == name[same] {
            same += 1;
        }
        if same == name.len() {
            return true;
        }
        start += 1;
    }
    false
}

/// A hash of 32 bits; zero if the scalar does not have the query.
pub(crate) type Cell = u32;

struct Hashes([Hash; ROWS.len()]);

impl Answers for Hashes {
    fn to(&mut self, query: Query) -> &mut Hash {
        &mut self.0[query as usize]
    }
}

/// The column of one scalar, from one run of all questions.
fn column<S: Draw>() -> Column {
    let mut hashes = Hashes([Hash::EMPTY; ROWS.len()]);
    ask::<S, _>(CASES, &mut hashes);
    hashes.0.map(|hash| match hash {
        Hash::EMPTY => 0,
        // Folded, as the authors of the hash do for fewer bits.
        Hash(bits) => ((bits >> 32) ^ bits) as u32,
    })
}
