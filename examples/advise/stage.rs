//! The stage of a scalar's cascade that decides a query: ARCHITECTURE.md, "How a question is
//! answered".

use std::collections::BTreeMap;

use crate::kind::Kind;
use crate::options::Target;
use crate::question::Question;
use crate::scene::{Query, Scene};

/// A stage, by the arithmetic that it runs in. The cheapest comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Stage {
    Float,
    Integers,
    I32,
    I64,
    I64AndI128,
    I128,
    Wide,
    ExactSums,
    Sums,
    Untold,
}

impl Stage {
    pub(crate) fn name(self, kind: Kind) -> &'static str {
        match self {
            Self::Float if kind == Kind::F32 => "f32/f64/integers",
            Self::Float => "f64/integers",
            Self::Integers => "f64, integers",
            Self::Sums => "f64, exact sums",
            Self::Untold => "see docs",
            Self::I32 => "i32",
            Self::I64 => "i64",
            Self::I64AndI128 => "i64 + i128",
            Self::I128 => "i128",
            Self::Wide => "256 bits",
            Self::ExactSums => "exact sums",
        }
    }

    /// The stage that decides one query.
    pub(crate) fn of(kind: Kind, target: Target, scene: &Scene, query: Query) -> Self {
        if scene.question == Question::Contact {
            return Self::of_contact(kind, target, scene, query);
        }
        let Kind::Fixed { bits, frac } = kind else { return Self::Float };
        if scene.question.is_staged_otherwise() {
            return Self::Untold;
        }
        let raw = |x: f64| Kind::raw(x, bits, frac).expect("a type that holds the scene");
        let points = scene.points(query).map(|p| p.map(raw));
        let places = scene.places(query).map(|p| p.map(raw));
        // On narrow registers a sweep has no kernel of its own.
        let target = match scene.question {
            Question::Sweep(_) => Target::Host,
            _ => target,
        };
        let below = |most: i32| {
            let end = f64::from(most).exp2();
            points.iter().chain(&places).flatten().all(|x| (-end..end).contains(x))
        };
        match (target, bits) {
            (Target::Host, ..=8) => Self::I32,
            (Target::Host, ..=16) => Self::I64,
            (Target::Host, ..=32) if below(18) => Self::I64,
            (Target::Host, ..=32) if below(28) => Self::I64AndI128,
            (Target::Host, ..=32) => Self::I128,
            (Target::Host, _) if !below(60) => Self::ExactSums,
            (Target::Host, _) if reach(&points, &places) < 41_f64.exp2() => Self::I128,
            (Target::Host, _) => Self::Wide,
            (_, ..=16) => Self::I32,
            (_, ..=32) if are_near(&points) => Self::I32,
            (_, ..=32) => Self::I64,
            _ => Self::I128,
        }
    }

    /// The stage of a contact, which begins in `f64` and takes its numbers from integers, if the
    /// machine has long words and these hold the input.
    fn of_contact(kind: Kind, target: Target, scene: &Scene, query: Query) -> Self {
        let nearest = |x: f64| kind.nearest(x).expect("a type that holds the scene");
        let points = scene.points(query).map(|p| p.map(nearest));
        match target {
            Target::Host if width(points.as_flattened().iter()) <= 60 => Self::Integers,
            Target::Host | Target::M0 | Target::M4f | Target::Rv32 => Self::Sums,
        }
    }

    /// The share of the queries that each stage decides.
    pub(crate) fn shares(
        kind: Kind,
        target: Target,
        scene: &Scene,
        queries: &[Query],
    ) -> BTreeMap<Self, f64> {
        let mut counts = BTreeMap::new();
        for &query in queries {
            *counts.entry(Self::of(kind, target, scene, query)).or_insert(0) += 1;
        }
        let share = |count: i32| f64::from(count) / queries.len() as f64;
        counts.into_iter().map(|(stage, count)| (stage, share(count))).collect()
    }
}

/// The number of bits between the highest and the lowest set bit of a query's numbers.
fn width<'a>(numbers: impl Iterator<Item = &'a f64>) -> i64 {
    let ends = |x: f64| {
        let exponent = ((x.to_bits() >> 52) & 0x7ff) as i64;
        let fraction = x.to_bits() & ((1 << 52) - 1);
        (exponent - i64::from(fraction.trailing_zeros().min(52)).abs_diff(52) as i64, exponent + 1)
    };
    let all = numbers.filter(|x| **x != 0.0).map(|&x| ends(x));
    let span = all.reduce(|(low, high), (l, h)| (low.min(l), high.max(h)));
    span.map_or(0, |(low, high)| high - low)
}

/// The greatest magnitude in the doubled frame of the box: a coordinate, the box's extent, or its
/// motion.
fn reach([a, b, c, min, max]: &[[f64; 3]; 5], [from, to]: &[[f64; 3]; 2]) -> f64 {
    let on_axis = |i: usize| {
        let from_middle = |v: &[f64; 3]| ((v[i] - min[i]) + (v[i] - max[i])).abs();
        from_middle(a)
            .max(from_middle(b))
            .max(from_middle(c))
            .max(max[i] - min[i])
            .max(2.0 * (to[i] - from[i]).abs())
    };
    on_axis(0).max(on_axis(1)).max(on_axis(2))
}

/// Whether all points lie within 2^18 units of the least corner of the box. The kernel
/// for narrow registers halves them first.
fn are_near([a, b, c, min, max]: &[[f64; 3]; 5]) -> bool {
    let half = |x: f64| (x / 2.0).floor();
    let reach = 17_f64.exp2();
    [a, b, c, max]
        .iter()
        .all(|p| (0..3).all(|i| (-reach..reach).contains(&(half(p[i]) - half(min[i])))))
}
