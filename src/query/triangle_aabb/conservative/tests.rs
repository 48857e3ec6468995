//! Compares the first look by vectors with the truncated test.

use fixed::types::I32F32;

use super::*;
use crate::random::Random;

/// Whether the first look decided; checks its answer against the truncated test.
fn check(rows: &[[i64; 3]; 5], by_center: bool) -> bool {
    let [a, b, c, p, q] = rows.map(|row| row.map(I32F32::from_bits));
    let triangle = Triangle::new(a, b, c).unwrap();
    let short = cut_down(&differences(rows, by_center));
    let far = cut_down_anywhere(&triangle, &Vec3::from(p), &Vec3::from(q), by_center);
    assert_eq!(short, far, "{rows:?}");
    let aabb = if by_center {
        Aabb::from_center_half_extents(p, q).unwrap()
    } else {
        Aabb::from_min_max(p, q).unwrap()
    };
    let clear = offsets::pair::<_, true>(&triangle, &aabb);
    if let Ok(apart) = clear {
        assert_eq!(apart, is_disjoint(short, by_center), "{rows:?}");
    }
    clear.is_ok()
}

/// Checks the box in both forms; returns how often the first look decided.
fn check_both(mut rows: [[i64; 3]; 5]) -> u32 {
    let by_center = check(&rows, true);
    let [.., p, q] = &mut rows;
    for i in 0..3 {
        (p[i], q[i]) = (p[i] - q[i], p[i] + q[i]);
    }
    u32::from(by_center) + u32::from(check(&rows, false))
}

/// Shapes of any size, with half-extents down to a quarter of the triangle's size.
fn rows(state: &mut Random, case: usize) -> ([[i64; 3]; 5], i64) {
    let bits = 3 + state.bits() % 44;
    let mut number = || (state.bits() & ((1 << bits) - 1)) as i64 - (1 << (bits - 1));
    let mut rows = [(); 5].map(|()| [(); 3].map(|()| number()));
    for half in &mut rows[4] {
        *half = half.abs() >> (case % 3);
    }
    (rows, number())
}

#[test]
fn what_is_clear_is_so_when_all_is_cut_down() {
    if !<I32F32 as crate::scalar::Backend>::IN_QUADS {
        return;
    }
    let (state, mut clear) = (&mut Random(1), 0);
    for case in 0..200_000 {
        // Boxes that are just apart from the triangle, or not.
        let (mut rows, number) = rows(state, case);
        let nudge = number >> (7 + case % 8);
        let [a, b, c, p, q] = &mut rows;
        if case % 2 == 0 {
            let axis = case % 3;
            p[axis] = a[axis].max(b[axis]).max(c[axis]) + q[axis] + nudge;
        } else {
            // From the triangle's centroid, along one axis by all half-extents and a nudge.
            for i in 0..3 {
                p[i] = (a[i] + b[i] + c[i]) / 3;
            }
            p[case % 3] += q[0] + q[1] + q[2] + nudge;
        }
        clear += check_both(rows);
    }
    // The first look decides nearly always, but not always.
    assert!((200_000..398_000).contains(&clear), "{clear}");
}

/// Boxes at a small distance from the plane, or from an edge: 2^-9 to 2^-17 of the size.
#[test]
fn what_is_clear_by_a_plane_or_an_edge_is_so_when_all_is_cut_down() {
    if !<I32F32 as crate::scalar::Backend>::IN_QUADS {
        return;
    }
    type Vector = [f64; 3];
    let minus = |p: Vector, q: Vector| [0, 1, 2].map(|i| p[i] - q[i]);
    let dot = |p: Vector, q: Vector| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let cross =
        |p: Vector, q: Vector| [(1, 2), (2, 0), (0, 1)].map(|(j, k)| p[j] * q[k] - p[k] * q[j]);
    let (state, mut clear) = (&mut Random(2), 0);
    for case in 0..200_000 {
        // Vertices at the corners of a cube have the longest normal for their size.
        let side = 1_i64 << (20 + state.bits() % 26);
        let mut corner = || {
            let signs = state.bits();
            [0, 1, 2]
                .map(|i| (if signs >> i & 1 == 0 { side } else { -side }) - (signs >> 44) as i64)
        };
        let vertices = [corner(), corner(), corner()];
        let half = [(); 3].map(|()| (state.bits() as i64 & (side - 1)) >> (case % 5 + 2));
        let [a, b, c, q] =
            [vertices[0], vertices[1], vertices[2], half].map(|row| row.map(|x| x as f64));
        let along = [minus(b, a), minus(c, a)];
        let (axis, from) = if case % 2 == 0 {
            (cross(along[0], along[1]), [0, 1, 2].map(|i| (a[i] + b[i] + c[i]) / 3.0))
        } else {
            let unit = [0, 1, 2].map(|i| f64::from(i == case % 3));
            (cross(along[0], unit), [0, 1, 2].map(|i| (a[i] + b[i]) / 2.0))
        };
        // Away from the third vertex.
        let length = dot(axis, axis).sqrt().copysign(-dot(axis, along[1]));
        if length == 0.0 {
            continue;
        }
        let axis = axis.map(|x| x / length);
        let gap = side as f64 / (256 + state.bits() % (1 << (9 + case % 8))) as f64;
        let off = dot(axis.map(f64::abs), q) + gap;
        let center = [0, 1, 2].map(|i| (from[i] + axis[i] * off) as i64);
        let [a, b, c] = vertices;
        clear += check_both([a, b, c, center, half]);
    }
    assert!((40_000..360_000).contains(&clear), "{clear}");
}
