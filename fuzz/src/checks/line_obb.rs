//! Ray or segment against oriented box.

use super::oriented_pairs::obb;
use crate::scalars::{Check, run};
use crate::shapes::{Point, Shapes};
use crate::told::{is_float, told};
use septum_kit::Sample;
use septum_kit::boxes::ObbNumbers;
use septum_kit::lines::{Line, LineObb};

/// `overlaps`, in either order, and `may_overlap`; for rays `t_range_obb`.
pub fn line_obb(data: &[u8]) {
    run::<LineWithObb>(data);
}

struct LineWithObb;

impl Check for LineWithObb {
    fn check<S: Sample>(shapes: &mut Shapes<'_, S>) {
        let obb = obb(shapes);
        // Axes that do not span space are refused: see `constructors`.
        let Ok(shape) = obb.shape() else { return };
        let corners = [-1.0, 0.0, 1.0].map(|sign| corner(&obb, sign));
        let origin = shapes.point();
        let line = match shapes.bytes.below(4) {
            0 => Line::Ends(origin, shapes.point()),
            1 => Line::Center(origin, shapes.point()),
            _ => {
                let Some(direction) = shapes.direction(origin, &corners) else { return };
                let later = shapes.bytes.one_in(2);
                let range = shapes.range(|| {
                    let line = Line::Ray(origin, direction, [None, None]);
                    let (enter, leave) = line.ray()?.t_range_obb(&shape)?;
                    Some(if later { leave } else { enter })
                });
                Line::Ray(origin, direction, range)
            }
        };
        let case = LineObb { line, obb };
        case.check();

        let Some(ray) = case.line.ray() else { return };
        let (found, clipped) = (ray.t_range_obb(&shape), case.clip());
        assert_eq!(found.is_some(), clipped.is_some(), "{}", told::<S>(&case));
        let (Some((enter, leave)), Some([Some(from), Some(to)])) = (found, clipped) else { return };
        assert!(enter <= leave, "{}", told::<S>(&case));
        for (t, truth) in [(enter, from), (leave, to)] {
            let told = || told::<S>(&(t, &case));
            if !is_float::<S>() {
                assert_eq!(t, truth.nearest_fixed(), "{}", told());
            } else if t.is_finite() && t.approximate().abs() > 1e-30 {
                assert!(truth.is_within(t, (51, 100)), "{}", told());
            }
        }
    }
}

/// A corner, or the centre, as near as rounding allows; zero if that is not a number.
fn corner<S: Sample>(obb: &ObbNumbers<S>, sign: f64) -> Point<S> {
    [0, 1, 2].map(|i: usize| {
        let along = |k: usize| sign * obb.half[k].approximate() * obb.axes[k][i].approximate();
        let x = obb.center[i].approximate() + along(0) + along(1) + along(2);
        if x.is_nan() { S::ZERO } else { S::nearest(x) }
    })
}
