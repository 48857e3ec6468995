//! The table: for each query and scalar, a hash over the answers to that query alone.

use fixed::types::{I4F4, I8F8, I16F16, I32F32};

use super::super::draw::Draw;
use super::super::stream::answers::{Answers, Hash};
use super::super::stream::queries::{Query, ROWS};
use super::super::stream::{CASES, ask};

/// A scalar's name, and its column.
pub(crate) type Scalar = (&'static str, fn() -> Column);

/// A hash for each query.
pub(crate) type Column = [Cell; ROWS.len()];

/// The scalars, in the order of the columns.
pub(crate) const SCALARS: [Scalar; 6] = [
    ("f32", column::<f32>),
    ("f64", column::<f64>),
    ("I4F4", column::<I4F4>),
    ("I8F8", column::<I8F8>),
    ("I16F16", column::<I16F16>),
    ("I32F32", column::<I32F32>),
];

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
