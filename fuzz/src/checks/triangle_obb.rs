//! Triangle against oriented box.

use septum::published;
use septum::{Obb, Vec3};

use crate::scalars::{Check, run};
use crate::shapes::{Point, Shapes, magnitude};
use septum_kit::{Oriented, Sample};

/// `overlaps`, `may_overlap` and `relation`; and that the rounded method terminates.
pub fn triangle_obb(data: &[u8]) {
    run::<TriangleObb>(data);
}

struct TriangleObb;

impl Check for TriangleObb {
    fn check<S: Sample>(shapes: &mut Shapes<'_, S>) {
        let axes = axes(shapes);
        let (center, half) = (shapes.point(), shapes.point().map(magnitude));
        let case = Oriented { t: shapes.triangle(), center, axes, half };
        // Axes that do not span space are refused: see `constructors`.
        if case.check().is_none() {
            return;
        }
        let (triangle, obb) = (case.triangle(), case.obb().expect("a box"));
        let _ = published::akenine_moller::overlaps_obb(&triangle, &obb);
        if let Ok(frame) = Obb::new(center, axes.map(Vec3::from), half) {
            assert_eq!(frame, obb);
        }
    }
}

/// A rotation, rounded; coordinate axes in some order; or any three vectors.
pub(super) fn axes<S: Sample>(shapes: &mut Shapes<'_, S>) -> [Point<S>; 3] {
    let mut frame = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    match shapes.bytes.below(4) {
        0 => return [(); 3].map(|()| shapes.point()),
        1 => {
            // In half of the cases one axis is slanted.
            frame.rotate_left(shapes.bytes.below(3));
            if shapes.bytes.one_in(2) {
                frame[0][shapes.bytes.below(3)] += 1.0;
            }
        }
        _ => {
            for (j, k) in [(0, 1), (1, 2), (2, 0)] {
                let (sin, cos) = f64::from(shapes.bytes.byte()).sin_cos();
                for row in &mut frame {
                    (row[j], row[k]) = (cos * row[j] - sin * row[k], sin * row[j] + cos * row[k]);
                }
            }
        }
    }
    frame.map(|row| row.map(S::nearest))
}
