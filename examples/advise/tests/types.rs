//! The number types.

use fixed::FixedI16;
use fixed::types::extra::{U0, U8, U10, U14};
use fixed::types::{I4F4, I16F16, I32F32};
use septum::{Aabb, Triangle};
use septum_kit::Rng;

use crate::kind::{Candidates, Kind, most_fraction_bits};
use crate::question::Question;
use crate::scene::{Query, Scene};
use crate::stage::Stage;
use crate::{options, paste};

use super::teapot;

/// Numbers are rounded, refused and compared as the `fixed` crate does it.
#[test]
fn types_are_what_they_are_called() {
    let mut rng = Rng::new(1);
    for _ in 0..100_000 {
        let x = (rng.real(-40_000.0, 40_000.0) * 1024.0).round() / rng.whole(1, 1 << 20) as f64;
        let raw = |bits, frac| Kind::raw(x, bits, frac).map(|raw| raw as i64);
        assert_eq!(raw(8, 4), I4F4::checked_from_num(x).map(|n| n.to_bits().into()), "{x}");
        let of_16 = FixedI16::<U10>::checked_from_num(x);
        assert_eq!(raw(16, 10), of_16.map(|n| n.to_bits().into()), "{x}");
        assert_eq!(raw(32, 16), I16F16::checked_from_num(x).map(|n| n.to_bits().into()), "{x}");
        assert_eq!(raw(64, 32), I32F32::checked_from_num(x).map(|n| n.to_bits()), "{x}");
        let nearest = Kind::Fixed { bits: 16, frac: 10 }.nearest(x);
        assert_eq!(nearest, of_16.map(|n| n.to_num()), "{x}");
        assert_eq!(Kind::F32.nearest(x), Some(f64::from(x as f32)));
    }
    let scene = Scene::new(Question::Overlap, teapot(), None, None).unwrap();
    let num = FixedI16::<U10>::from_num::<f64>;
    let mut overlapping = 0;
    for query in (0..scene.queries()).step_by(11).map(|n| scene.query(n)) {
        let [a, b, c, min, max] = scene.points(query).map(|p| p.map(num));
        let aabb = Aabb::from_min_max(min, max).unwrap();
        let overlaps = Triangle::new(a, b, c).unwrap().overlaps(&aabb);
        assert_eq!(Kind::Fixed { bits: 16, frac: 10 }.overlaps(&scene, query), overlaps);
        overlapping += u32::from(overlaps);
    }
    assert!(overlapping > 500, "{overlapping}");
    let names = [(16, 8, "I8F8"), (16, 9, "FixedI16<U9>"), (64, 32, "I32F32")];
    for (bits, frac, name) in names {
        assert_eq!(Kind::Fixed { bits, frac }.name(), name);
    }
    let end = FixedI16::<U8>::MAX.to_num::<f64>() + FixedI16::<U8>::DELTA.to_num::<f64>();
    assert_eq!(Kind::Fixed { bits: 16, frac: 8 }.end(), end);
}

/// One more fraction bit would not do.
#[test]
fn the_most_fraction_bits() {
    let scene = Scene::new(Question::Overlap, teapot(), None, None).unwrap();
    let held = Candidates::of(&scene).held;
    for bits in [8, 16, 32, 64] {
        let most = held.iter().filter(|k| k.bits() == bits).map(|k| k.fraction_bits()).max();
        let frac = most.unwrap();
        assert!(Kind::Fixed { bits, frac }.holds(scene.range()));
        assert!(!Kind::Fixed { bits, frac: frac + 1 }.holds(scene.range()), "{bits}: {frac}");
    }
    // 16 is not below 16.
    assert_eq!(most_fraction_bits(16, 16, [-16.0, 15.9]), Some(11));
    assert_eq!(most_fraction_bits(16, 16, [-16.0, 16.0]), Some(10));
    let unit = FixedI16::<U14>::DELTA.to_num::<f64>();
    assert_eq!(most_fraction_bits(16, 16, [-2.0, 2.0 - unit]), Some(14));
    assert_eq!(FixedI16::<U0>::FRAC_NBITS, 0);
}

/// The thresholds of ARCHITECTURE.md.
#[test]
fn stages() {
    let stage = |bits, frac, x: f64, target| {
        let scene =
            Scene::new(Question::Overlap, vec![[[x, 0.0, 0.0]; 3]], Some(1.0), Some(0.0)).unwrap();
        let cell = [x as i64 - 1, -1, -1];
        let query = Query { triangle: 0, cell };
        Stage::of(Kind::Fixed { bits, frac }, target, &scene, query)
    };
    use options::Target::{Host, M0};
    for (bits, frac, x, on_host, on_m0) in [
        (8, 1, 3.0, Stage::I32, Stage::I32),
        (16, 1, 3.0, Stage::I64, Stage::I32),
        (32, 16, 3.0, Stage::I64, Stage::I32),
        (32, 16, 5.0, Stage::I64AndI128, Stage::I32),
        (32, 16, 4097.0, Stage::I128, Stage::I32),
        (32, 18, 3.0, Stage::I64AndI128, Stage::I64),
        (64, 32, 3.0, Stage::I128, Stage::I128),
        (64, 41, 3.0, Stage::Wide, Stage::I128),
        (64, 60, 3.0, Stage::ExactSums, Stage::I128),
    ] {
        assert_eq!(stage(bits, frac, x, Host), on_host, "{bits} {frac} {x}");
        assert_eq!(stage(bits, frac, x, M0), on_m0, "{bits} {frac} {x}");
    }
}

/// The lines to paste, pasted.
mod pasted {
    pub(crate) const LINES: &str = include_str!("pasted.in");
    include!("pasted.in");
    pub(crate) fn overlap() -> bool {
        TRIANGLE.overlaps(&CELL)
    }
}

#[test]
fn lines_to_paste_compile() {
    let scene = Scene::new(Question::Overlap, teapot(), None, None).unwrap();
    let kind = Kind::Fixed { bits: 16, frac: 10 };
    assert_eq!(paste::lines(kind, &scene), pasted::LINES);
    assert_eq!(pasted::overlap(), kind.overlaps(&scene, scene.query(0)));
}
