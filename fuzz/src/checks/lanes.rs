//! Lanes: the same bits as single shapes.

use septum::{Aabb, Cull, Ray, Triangle};

use crate::scalars::{Check, run};
use crate::shapes::{Shapes, magnitude};
use crate::told::told;
use septum_kit::{Lanes, Sample};

/// Every method on lanes, with one, three and eight lanes. With `SHOW` in the environment it prints
/// the shapes first, because they would make the messages too long.
pub fn lanes(data: &[u8]) {
    run::<AllLanes>(data);
}

struct AllLanes;

impl Check for AllLanes {
    fn check<S: Sample>(shapes: &mut Shapes<'_, S>) {
        match shapes.bytes.below(4) {
            0 => check::<S, 1>(shapes),
            1 => check::<S, 3>(shapes),
            _ => check::<S, 8>(shapes),
        }
    }
}

fn check<S: Sample, const N: usize>(shapes: &mut Shapes<'_, S>) {
    let cull = [Cull::Nothing, Cull::Back, Cull::Front][shapes.bytes.below(3)];
    let triangles: [Triangle<S>; N] = core::array::from_fn(|_| {
        let [a, b, c] = shapes.triangle();
        Triangle::new(a, b, c).expect("finite vertices")
    });
    let rays: [Ray<S>; N] = core::array::from_fn(|k| ray(shapes, &triangles[k]));
    let boxes: [Aabb<S>; N] = core::array::from_fn(|_| {
        let (p, q) = (shapes.point(), shapes.point());
        let ends = |low: bool| [0, 1, 2].map(|i| if (p[i] < q[i]) == low { p[i] } else { q[i] });
        Aabb::from_min_max(ends(true), ends(false)).expect("corners in order")
    });
    let centered = Aabb::from_center_half_extents(shapes.point(), shapes.point().map(magnitude));
    if std::env::var_os("SHOW").is_some() {
        eprintln!("{}", told::<S>(&(cull, triangles, rays, boxes, centered)));
    }
    Lanes { triangles, rays, boxes, centered: centered.ok() }.check(cull);
}

fn ray<S: Sample>(shapes: &mut Shapes<'_, S>, triangle: &Triangle<S>) -> Ray<S> {
    let (origin, marks) = (shapes.point(), triangle.vertices().map(|v| v.to_array()));
    let direction = shapes.direction(origin, &marks).unwrap_or([S::ZERO.moved(1); 3]);
    let [from, to] = shapes.range(|| None);
    let ray = Ray::new(origin, direction).expect("a direction");
    ray.with_range(from, to).expect("a range")
}
