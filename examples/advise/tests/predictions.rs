//! Tests of the predictions.

use crate::effect;
use crate::kind::Kind;
use crate::prediction::{self, Prediction};
use crate::question::Question;
use crate::scene::{Query, Scene};

use super::{Advice, Triangles, teapot};

#[test]
fn full_runs_count_what_was_predicted() {
    for (arguments, least_changed) in [
        ("", 3),
        ("--cell 0.3", 3),
        ("--cell 2.7 --tolerance 0.3", 1),
        ("--sample 500", 3),
        ("--sample 1000000", 3),
    ] {
        let advice = Advice::on(teapot(), &format!("--full {arguments}"));
        let rows = &advice.survey.rows;
        let mut changed = 0;
        for row in rows {
            let (counted, name) = (row.counted.unwrap(), row.kind.name());
            assert!(row.prediction.allows(counted), "{arguments}: {name}\n{}", advice.text);
            changed += u64::from(counted > 0);
        }
        assert!(rows.len() >= 10 && changed >= least_changed, "{arguments}\n{}", advice.text);
        assert!(advice.text.contains(&format!("all {} predictions hold", rows.len())));
    }
}

/// Sums the probabilities of all outcomes.
#[test]
fn predictions_hold_as_often_as_they_say() {
    const ALL: u64 = 1_000_000;
    for asked in [1, 20, 400] {
        for share in [0.000001, 0.0004, 0.003, 0.02, 0.31, 0.5, 0.97, 0.999999] {
            let truth = (share * ALL as f64) as u64;
            // In logarithms, because some outcomes are very unlikely.
            let (mut held, mut probability) = (0.0, f64::ln(1.0 - share) * f64::from(asked));
            for k in 0..=asked {
                let prediction = Prediction::new(k as u64, asked as u64, ALL, 1);
                held += if prediction.allows(truth) { probability.exp() } else { 0.0 };
                let ways = f64::from(asked - k) / f64::from(k + 1);
                probability += (ways * share / (1.0 - share)).ln();
            }
            assert!(held >= prediction::CONFIDENCE, "{held} for {share} of {asked}");
        }
    }
    // The predictions are also tight: no change seen predicts almost none, most predicts most.
    let of = |k| Prediction::new(k, 20_000, ALL, 1);
    assert!(of(0).least == 0 && (150..190).contains(&of(0).most), "{:?}", of(0));
    assert!(of(10_000).least > 485_000 && of(10_000).most < 515_000, "{:?}", of(10_000));
    assert!(of(20_000).most == ALL && of(20_000).least > ALL - 190, "{:?}", of(20_000));
}

/// Rounding within the tolerance changes no verdict of a pair that is not tested.
#[test]
fn all_queries_that_matter_are_asked() {
    let triangles: Triangles = teapot().into_iter().step_by(20).collect();
    let scene = Scene::new(Question::Overlap, triangles, Some(1.5), Some(0.2)).unwrap();
    let asked: Vec<_> = (0..scene.queries()).map(|n| scene.query(n)).collect();
    let is_asked = |triangle, cell| asked.iter().any(|q| q.triangle == triangle && q.cell == cell);
    let kind = Kind::Fixed { bits: 8, frac: 2 };
    let moved = effect::Effect::of(kind, &scene).moved;
    assert!(moved > 0.2 && moved < 0.25, "{moved}: about as far as allowed");
    let [xs, ys, zs] = scene.cells.clone();
    let mut changed = 0;
    for triangle in 0..scene.triangles.len() {
        for (x, y) in xs.clone().flat_map(|x| ys.clone().map(move |y| (x, y))) {
            for z in zs.clone() {
                let query = Query { triangle, cell: [x, y, z] };
                if kind.overlaps(&scene, query) != Kind::F64.overlaps(&scene, query) {
                    changed += 1;
                    assert!(is_asked(triangle, [x, y, z]), "{query:?}");
                }
            }
        }
    }
    assert!(changed > 20, "{changed}");
}
