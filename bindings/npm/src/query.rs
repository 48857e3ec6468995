//! Questions about a mesh.

use core::ops::ControlFlow;

use septum::mesh::Probe;
use septum::sweep::Motion;
use septum::{Aabb, Cull, Facing, Hit, HitRules, Ray, ShapeError, Sphere};

use crate::memory::{LIST, lock, say};
use crate::mesh::{MESHES, State, with};
use crate::part::number_of_feature;

/// What is not an index of a triangle: none, and the reasons why there is no answer.
pub(crate) const NONE: i32 = -1;
pub(crate) const REFUSED: i32 = -2;

/// Culls back faces if 1, front faces if 2.
fn rules(cull: u32) -> HitRules {
    HitRules::new().culling(match cull {
        1 => Cull::Back,
        2 => Cull::Front,
        _ => Cull::Nothing,
    })
}

fn ray(origin: [f32; 3], along: [f32; 3], [near, far]: [f32; 2]) -> Result<Ray<f32>, ShapeError> {
    // An infinite end on its own side is no end.
    let end = |t: f32, none: f32| (t != none).then_some(t);
    Ray::new(origin, along)?.with_range(end(near, f32::NEG_INFINITY), end(far, f32::INFINITY))
}

/// The words of a hit: t, u, v and, for a back face, 1.
fn words(hit: &Hit<f32>) -> [u32; 4] {
    let is_back = hit.facing == Facing::Back;
    [hit.t.to_bits(), hit.u.to_bits(), hit.v.to_bits(), is_back.into()]
}

/// The index of the first triangle that a ray hits, or -1; -2 for what is no ray. The numbers are
/// then t, u, v and whether it is a back face.
#[unsafe(export_name = "first_hit")]
extern "C" fn first_hit(
    mesh: usize,
    ox: f32,
    oy: f32,
    oz: f32,
    dx: f32,
    dy: f32,
    dz: f32,
    near: f32,
    far: f32,
    cull: u32,
) -> i32 {
    let Ok(ray) = ray([ox, oy, oz], [dx, dy, dz], [near, far]) else { return REFUSED };
    with(mesh, NONE, |tree| {
        tree.as_tree().first_hit_with(&ray, rules(cull)).map_or(NONE, |(triangle, hit)| {
            say(0, &words(&hit));
            triangle as i32
        })
    })
}

/// Whether a ray hits any triangle; -2 for what is no ray.
#[unsafe(export_name = "any_hit")]
extern "C" fn any_hit(
    mesh: usize,
    ox: f32,
    oy: f32,
    oz: f32,
    dx: f32,
    dy: f32,
    dz: f32,
    near: f32,
    far: f32,
    cull: u32,
) -> i32 {
    let Ok(ray) = ray([ox, oy, oz], [dx, dy, dz], [near, far]) else { return REFUSED };
    with(mesh, 0, |tree| tree.as_tree().is_hit_with(&ray, rules(cull)).into())
}

/// Lists all hits, in the order of their triangles: five words each, the triangle first. Returns
/// how many there are; -2 for what is no ray.
#[unsafe(export_name = "all_hits")]
extern "C" fn all_hits(
    mesh: usize,
    ox: f32,
    oy: f32,
    oz: f32,
    dx: f32,
    dy: f32,
    dz: f32,
    near: f32,
    far: f32,
    cull: u32,
) -> i32 {
    let Ok(ray) = ray([ox, oy, oz], [dx, dy, dz], [near, far]) else { return REFUSED };
    with(mesh, 0, |tree| {
        let mut list = lock(&LIST);
        list.clear();
        for (triangle, hit) in tree.as_tree().hits_with(&ray, rules(cull)) {
            let [t, u, v, is_back] = words(&hit);
            list.extend([triangle as u32, t, u, v, is_back]);
        }
        (list.len() / 5) as i32
    })
}

/// The first hits of the rays of the list, six numbers each: the first five become those of
/// [`all_hits`], with -1 for no triangle and -2 for what is no ray.
#[unsafe(export_name = "first_hits")]
extern "C" fn first_hits(mesh: usize, near: f32, far: f32, cull: u32) {
    let rules = rules(cull);
    with(mesh, (), |tree| {
        let tree = tree.as_tree();
        for words in lock(&LIST).as_chunks_mut::<6>().0 {
            let [ox, oy, oz, dx, dy, dz] = words.map(f32::from_bits);
            *words = match ray([ox, oy, oz], [dx, dy, dz], [near, far]) {
                Err(_) => [REFUSED as u32, 0, 0, 0, 0, 0],
                Ok(ray) => match tree.first_hit_with(&ray, rules) {
                    None => [NONE as u32, 0, 0, 0, 0, 0],
                    Some((triangle, hit)) => {
                        let [t, u, v, is_back] = self::words(&hit);
                        [triangle as u32, t, u, v, is_back, 0]
                    }
                },
            };
        }
    });
}

/// Whether each ray of the list hits any triangle: the first of its six numbers becomes 0, 1, or -2
/// for what is no ray.
#[unsafe(export_name = "any_hits")]
extern "C" fn any_hits(mesh: usize, near: f32, far: f32, cull: u32) {
    let rules = rules(cull);
    with(mesh, (), |tree| {
        let tree = tree.as_tree();
        for words in lock(&LIST).as_chunks_mut::<6>().0 {
            let [ox, oy, oz, dx, dy, dz] = words.map(f32::from_bits);
            words[0] = match ray([ox, oy, oz], [dx, dy, dz], [near, far]) {
                Err(_) => REFUSED as u32,
                Ok(ray) => tree.is_hit_with(&ray, rules).into(),
            };
        }
    });
}

/// Whether a point is outside (0), inside (1) or on a triangle (2).
#[unsafe(export_name = "locate")]
extern "C" fn locate(mesh: usize, x: f32, y: f32, z: f32) -> u32 {
    with(mesh, 0, |tree| {
        tree.as_tree().winding([x, y, z]).map_or(2, |winding| (winding % 2 != 0).into())
    })
}

/// The same of the points of the list, three numbers each: the first becomes the answer, or 3 if a
/// coordinate is not finite.
#[unsafe(export_name = "locate_all")]
extern "C" fn locate_all(mesh: usize) {
    with(mesh, (), |tree| {
        let tree = tree.as_tree();
        for words in lock(&LIST).as_chunks_mut::<3>().0 {
            let point = words.map(f32::from_bits);
            words[0] = match tree.winding(point) {
                _ if point.iter().any(|x| !x.is_finite()) => 3,
                None => 2,
                Some(winding) => (winding % 2 != 0).into(),
            };
        }
    });
}

/// Whether a shape overlaps a triangle; -2 for what is no shape.
fn meets(mesh: usize, shape: Result<impl Probe<f32>, ShapeError>) -> i32 {
    let Ok(shape) = shape else { return REFUSED };
    with(mesh, 0, |tree| tree.as_tree().overlapping(&shape).next().is_some().into())
}

/// Lists the triangles that overlap a shape, and returns how many there are; -2 for what is no
/// shape.
fn list(mesh: usize, shape: Result<impl Probe<f32>, ShapeError>) -> i32 {
    let Ok(shape) = shape else { return REFUSED };
    with(mesh, 0, |tree| {
        let mut list = lock(&LIST);
        list.clear();
        list.extend(tree.as_tree().overlapping(&shape).map(|triangle| triangle as u32));
        list.len() as i32
    })
}

/// Whether a box overlaps a triangle.
#[unsafe(export_name = "meets_box")]
extern "C" fn meets_box(mesh: usize, ax: f32, ay: f32, az: f32, bx: f32, by: f32, bz: f32) -> i32 {
    meets(mesh, Aabb::from_min_max([ax, ay, az], [bx, by, bz]))
}

/// Lists the triangles that overlap a box.
#[unsafe(export_name = "in_box")]
extern "C" fn in_box(mesh: usize, ax: f32, ay: f32, az: f32, bx: f32, by: f32, bz: f32) -> i32 {
    list(mesh, Aabb::from_min_max([ax, ay, az], [bx, by, bz]))
}

/// Whether a sphere overlaps a triangle.
#[unsafe(export_name = "meets_sphere")]
extern "C" fn meets_sphere(mesh: usize, x: f32, y: f32, z: f32, radius: f32) -> i32 {
    meets(mesh, Sphere::new([x, y, z], radius))
}

/// Lists the triangles that overlap a sphere.
#[unsafe(export_name = "in_sphere")]
extern "C" fn in_sphere(mesh: usize, x: f32, y: f32, z: f32, radius: f32) -> i32 {
    list(mesh, Sphere::new([x, y, z], radius))
}

/// The index of the first triangle that a moving box meets, or -1; -2 for what is no box that
/// moves. The numbers are then the time, whether there is a normal, and the normal.
#[unsafe(export_name = "box_cast")]
extern "C" fn box_cast(
    mesh: usize,
    ax: f32,
    ay: f32,
    az: f32,
    bx: f32,
    by: f32,
    bz: f32,
    dx: f32,
    dy: f32,
    dz: f32,
) -> i32 {
    let aabb = Aabb::from_min_max([ax, ay, az], [bx, by, bz]);
    let (Ok(aabb), Ok(motion)) = (aabb, Motion::new([0.0; 3], [dx, dy, dz])) else {
        return REFUSED;
    };
    with(mesh, NONE, |tree| {
        let first = tree.as_tree().first_contact(&aabb, &motion);
        first.map_or(NONE, |(i, first)| {
            let normal = tree.mesh().triangle(i).and_then(|t| first.normal(&motion, &t));
            say(0, &[first.t.to_bits(), normal.is_some().into()]);
            if let Some(normal) = normal {
                say(2, &normal.to_array().map(f32::to_bits));
            }
            i as i32
        })
    })
}

/// The same of a sphere. The numbers are then the time and the part that it touches, or -1 at the
/// start.
#[unsafe(export_name = "sphere_cast")]
extern "C" fn sphere_cast(
    mesh: usize,
    x: f32,
    y: f32,
    z: f32,
    radius: f32,
    dx: f32,
    dy: f32,
    dz: f32,
) -> i32 {
    let motion = Motion::new([0.0; 3], [dx, dy, dz]);
    let (Ok(sphere), Ok(motion)) = (Sphere::new([x, y, z], radius), motion) else {
        return REFUSED;
    };
    with(mesh, NONE, |tree| {
        tree.as_tree().first_contact(&sphere, &motion).map_or(NONE, |(i, first)| {
            let part = first.part.map_or(NONE, |part| number_of_feature(part).into());
            say(0, &[first.t.to_bits(), part as u32]);
            i as i32
        })
    })
}

/// There is no memory for so many pairs.
const NO_ROOM: usize = usize::MAX;

/// Lists at most `limit` pairs of triangles of two meshes that overlap, and returns how many it
/// lists, or [`NO_ROOM`].
#[unsafe(export_name = "pairs")]
extern "C" fn pairs(first: usize, second: usize, limit: usize) -> usize {
    let meshes = lock(&MESHES);
    let (Some(State::Built(first, _)), Some(State::Built(second, _))) =
        (meshes.get(first), meshes.get(second))
    else {
        return 0;
    };
    let mut list = lock(&LIST);
    list.clear();
    let mut has_room = true;
    if limit > 0 {
        let _ = first.as_tree().overlapping_pairs(&second.as_tree(), |i, k| {
            has_room = list.try_reserve(2).is_ok();
            if !has_room {
                return ControlFlow::Break(());
            }
            list.extend([i as u32, k as u32]);
            if list.len() / 2 >= limit { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
    }
    if !has_room {
        list.clear();
        list.shrink_to_fit();
        return NO_ROOM;
    }
    list.len() / 2
}
