//! A closed mesh: rays through it hit each wall once, whatever its shape.

use dashu_int::IBig;
use septum::{Facing, Ray, Triangle};

use crate::scalars::{Check, run};
use crate::shapes::{Point, Shapes};
use crate::told::told;
use septum_kit::{Ring, Sample};

/// `hit_once` on the faces of a tetrahedron or an octahedron, however flat or crossed: a line
/// leaves as often as it enters. It enters a convex mesh at most once, and a ray that starts inside
/// leaves it once.
pub fn closed_mesh(data: &[u8]) {
    run::<ClosedMesh>(data);
}

struct ClosedMesh;

/// Faces, counterclockwise as seen from outside, if vertex 3 lies behind 0, 1, 2.
const TETRAHEDRON: [[usize; 3]; 4] = [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]];
/// 0 and 5 are the tips.
const OCTAHEDRON: [[usize; 3]; 8] =
    [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1], [5, 2, 1], [5, 3, 2], [5, 4, 3], [5, 1, 4]];

impl Check for ClosedMesh {
    fn check<S: Sample>(shapes: &mut Shapes<'_, S>) {
        let is_tetrahedron = shapes.bytes.one_in(2);
        let count = if is_tetrahedron { 4 } else { 6 };
        let vertices: Vec<Point<S>> = (0..count).map(|_| shapes.point()).collect();
        let faces = if is_tetrahedron { &TETRAHEDRON[..] } else { &OCTAHEDRON[..] };
        let origin = shapes.point();
        let Some(direction) = shapes.direction(origin, &vertices) else { return };
        let ray = Ray::new(origin, direction).expect("a ray");
        let line = ray.with_range(None, None).expect("a line");

        let case = || told::<S>(&(ray, &vertices));
        let triangles = faces.iter().map(|face| {
            let [a, b, c] = face.map(|v| vertices[v]);
            Triangle::new(a, b, c).expect("finite vertices")
        });
        let (mut through, mut ahead) = ([0; 2], [0; 2]);
        for triangle in triangles {
            for (ray, count) in [(&line, &mut through), (&ray, &mut ahead)] {
                match ray.hit_once(&triangle).map(|hit| hit.facing) {
                    Some(Facing::Front) => count[0] += 1,
                    Some(Facing::Back) => count[1] += 1,
                    None => {}
                }
            }
        }
        assert_eq!(through[0], through[1], "entries and exits, {}", case());
        if is_tetrahedron {
            assert!(through[0] <= 1, "{through:?}, {}", case());
            check_inside(&vertices, origin, ahead, &case);
        }
    }
}

/// A tetrahedron, for which the inside is known: checks whether the ray starts inside.
fn check_inside<S: Sample>(
    vertices: &[Point<S>],
    origin: Point<S>,
    [entries, exits]: [i32; 2],
    case: &dyn Fn() -> String,
) {
    let signs = TETRAHEDRON.map(|face| {
        let [a, b, c] = face.map(|v| vertices[v]);
        side(a, b, c, origin)
    });
    let volume = side(vertices[0], vertices[1], vertices[2], vertices[3]);
    if volume == 0 || signs.contains(&0) {
        return;
    }
    let is_inside = signs.iter().all(|&sign| sign == volume);
    // In a mesh turned inside out, entries are exits.
    let expected = if is_inside { -volume } else { 0 };
    assert_eq!(exits - entries, expected, "inside is {is_inside}, {}", case());
}

/// The side of the plane of a, b, c on which the point lies: 1 if the vertices go counterclockwise
/// seen from there.
fn side<S: Sample>(a: Point<S>, b: Point<S>, c: Point<S>, p: Point<S>) -> i32 {
    let parts = [a, b, c, p].map(|row| row.map(S::mantissa_exponent));
    let unit = parts.iter().flatten().filter(|x| x.0 != 0).map(|x| x.1).min().unwrap_or(0);
    let [a, b, c, p] = parts.map(|row| {
        row.map(|(m, e)| if m == 0 { IBig::ZERO } else { IBig::from(m) << (e - unit) as usize })
    });
    let from = |q: &[IBig; 3]| IBig::difference(q, &a);
    let normal = IBig::cross(&from(&b), &from(&c));
    Ring::sign(&IBig::dot(&normal, &from(&p)))
}
