//! Polygon against the unit cube around the origin, for triangles, in `f32`.
//!
//! D. Green, D. Hatch, "Fast Polygon-Cube Intersection Testing", *Graphics Gems V*, 1995.
//! Written from the description of the method: outcodes of the cube's faces, edges and
//! corners; each edge of the polygon against the cube; and the diagonal of the cube that is
//! nearest to the normal against the polygon.

type Point = [f32; 3];

pub(super) fn meets_unit_cube(t: &[Point; 3]) -> bool {
    let faces = t.map(|p| face_code(&p));
    if faces.contains(&0) {
        return true;
    }
    if faces[0] & faces[1] & faces[2] != 0 {
        return false;
    }
    let bevels = t.map(|p| bevel_code(&p));
    if bevels[0] & bevels[1] & bevels[2] != 0 {
        return false;
    }
    let ends = [(0, 1), (1, 2), (2, 0)];
    ends.iter().any(|&(a, b)| faces[a] & faces[b] == 0 && segment(&t[a], &t[b])) || diagonal(t)
}

/// Beyond which faces a point lies.
#[inline(always)]
fn face_code(p: &Point) -> u32 {
    let mut code = 0;
    for (i, x) in p.iter().enumerate() {
        code |= u32::from(*x > 0.5) << (2 * i) | u32::from(*x < -0.5) << (2 * i + 1);
    }
    code
}

/// Beyond which of the planes through the twelve edges and the eight corners.
#[inline(always)]
fn bevel_code(&[x, y, z]: &Point) -> u32 {
    let mut code = 0;
    let mut bit = 0;
    let mut add = |outside: bool| {
        code |= u32::from(outside) << bit;
        bit += 1;
    };
    for (a, b) in [(x, y), (y, z), (z, x)] {
        for sum in [a + b, a - b, b - a, -a - b] {
            add(sum > 1.0);
        }
    }
    for sum in [x + y + z, x + y - z, x - y + z, x - y - z] {
        add(sum > 1.5);
        add(sum < -1.5);
    }
    code
}

/// Whether the segment meets the cube: three faces, three cross products.
#[inline(always)]
fn segment(a: &Point, b: &Point) -> bool {
    let m = [0, 1, 2].map(|i| (a[i] + b[i]) * 0.5);
    let w = [0, 1, 2].map(|i| (b[i] - a[i]) * 0.5);
    let v = w.map(f32::abs);
    let is_beyond = |i: usize| m[i].abs() > 0.5 + v[i];
    let is_beside = |j: usize, k: usize| (m[j] * w[k] - m[k] * w[j]).abs() > 0.5 * (v[j] + v[k]);
    let is_apart = is_beyond(0) || is_beyond(1) || is_beyond(2);
    !(is_apart || is_beside(0, 1) || is_beside(1, 2) || is_beside(2, 0))
}

/// Whether the diagonal nearest to the normal crosses the triangle within the cube.
#[inline(always)]
fn diagonal([a, b, c]: &[Point; 3]) -> bool {
    let (e, f) = ([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
    let n = [(1, 2), (2, 0), (0, 1)].map(|(j, k)| e[j] * f[k] - e[k] * f[j]);
    let best = n.map(|x| if x < 0.0 { -1.0 } else { 1.0 });
    let t = dot(&n, a) / dot(&n, &best);
    // Not a number where the normal is zero: then there is nothing but edges.
    if !(-0.5..=0.5).contains(&t) {
        return false;
    }
    let point = best.map(|x| x * t);
    // Inside on the plane where the triangle is largest.
    let size = n.map(f32::abs);
    let long = if size[0] > size[1] { 0 } else { 1 };
    let long = if size[2] > size[long] { 2 } else { long };
    let (j, k) = ((long + 1) % 3, (long + 2) % 3);
    let side = |p: &Point, q: &Point| {
        (q[j] - p[j]) * (point[k] - p[k]) - (q[k] - p[k]) * (point[j] - p[j])
    };
    let sides = [side(a, b), side(b, c), side(c, a)];
    sides.iter().all(|s| *s >= 0.0) || sides.iter().all(|s| *s <= 0.0)
}

#[inline(always)]
fn dot(a: &Point, b: &Point) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    use fastrand::Rng;
    use septum::{Aabb, Triangle};

    use super::meets_unit_cube;

    /// Vertices in eighths, where `f32` holds every sum and product: no rounding, so that
    /// only a mistake can make a difference.
    #[test]
    fn agrees_with_the_exact_test_where_nothing_is_rounded() {
        let mut rng = Rng::with_seed(1);
        let mut number = || f32::from(rng.i8(-16..=16)) / 8.0;
        let cube = Aabb::from_center_half_extents([0.0; 3], [0.5; 3]).unwrap();
        let (mut met, mut by_the_diagonal) = (0, 0);
        for _ in 0..200_000 {
            let t = [(); 3].map(|()| [number(), number(), number()]);
            let triangle = Triangle::new(t[0], t[1], t[2]).unwrap();
            // The division of the diagonal does round: contact is left out.
            let grown = |h: f32| Aabb::from_center_half_extents([0.0; 3], [h; 3]).unwrap();
            if triangle.overlaps(&grown(0.499)) != triangle.overlaps(&grown(0.501)) {
                continue;
            }
            assert_eq!(meets_unit_cube(&t), triangle.overlaps(&cube), "{t:?}");
            met += usize::from(triangle.overlaps(&cube));
            let is_edge = |a: usize, b: usize| super::segment(&t[a], &t[b]);
            let by_edges = is_edge(0, 1) || is_edge(1, 2) || is_edge(2, 0);
            by_the_diagonal += usize::from(triangle.overlaps(&cube) && !by_edges);
        }
        assert!(met > 50_000 && by_the_diagonal > 1_000, "{met}, {by_the_diagonal}");
    }
}
