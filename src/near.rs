//! Shapes near the origin: queries in 32-bit words alone, without the code for distant shapes.
//!
//! Use these in firmware that needs a small program and a known worst case. A query on an ordinary
//! shape of a 32-bit type links a second stage in wider words, for coordinates far from the origin.
//! A [`Near`] shape is checked once, when it is made, and its queries link only the first stage, so
//! the time of the second cannot occur. `docs/worst-case.md` lists the most instructions of each
//! query, with `near` and without.
//!
//! *Near* means less than 2¹⁷ units in the last place from zero on every axis: less than 2 in
//! `I16F16`, or 131 mm where a unit in the last place is a micrometre. Directions, axes and
//! half-extents may be longer, up to 2¹⁹ units. Types of 8 and 16 bits have no second stage, and
//! need no `near`.
//!
//! ```
//! use fixed::types::I16F16;
//! use septum::near::Near;
//! use septum::{Aabb, Ray, ShapeError, Triangle, Vec3};
//!
//! /// In sixteenths.
//! const fn at(x: i32, y: i32, z: i32) -> Vec3<I16F16> {
//!     let unit = 1 << 12;
//!     Vec3::new(
//!         I16F16::from_bits(x * unit),
//!         I16F16::from_bits(y * unit),
//!         I16F16::from_bits(z * unit),
//!     )
//! }
//! // In flash. It does not compile if the triangle is too far out.
//! static FLOOR: Near<Triangle<I16F16>> = {
//!     let floor = Triangle::<I16F16>::const_new(at(0, 0, 0), at(16, 0, 0), at(0, 16, 0));
//!     ShapeError::unwrap(ShapeError::unwrap(floor).near())
//! };
//!
//! let ray = Ray::new(at(2, 2, 16), at(0, 0, -16))?.near()?;
//! assert_eq!(ray.hit(&FLOOR).unwrap().t, 1);
//! let cell = Aabb::from_min_max(at(0, 0, 0), at(1, 1, 1))?.near()?;
//! assert!(FLOOR.overlaps(&cell));
//!
//! let far = Ray::new(at(2, 2, 90), at(0, 0, -16))?.near();
//! assert_eq!(far, Err(ShapeError::NotNear));
//! # Ok::<(), ShapeError>(())
//! ```
//!
//! | pair | |
//! | --- | --- |
//! | ray, triangle | `hit`, `hit_once`, `hit_with`, `is_hit`, `is_hit_with` |
//! | triangle, axis-aligned box | `overlaps`, `may_overlap` |
//! | triangle, oriented box | `overlaps`, `may_overlap` |
//!
//! The answers are bit for bit the answers of the ordinary shapes.

pub use crate::shape::Near;

#[cfg(test)]
mod tests {
    use fixed::types::I16F16;

    use crate::{Aabb, Obb, Ray, ShapeError, Triangle};

    const MOST: i32 = (1 << 17) - 1;
    const LONGEST: i32 = (1 << 19) - 1;

    fn at(x: i32, y: i32, z: i32) -> [I16F16; 3] {
        [x, y, z].map(I16F16::from_bits)
    }

    #[test]
    fn what_is_far_is_refused() {
        let triangle = |x| Triangle::new(at(0, 0, x), at(x, 0, 0), at(0, x, 0)).unwrap().near();
        assert!(triangle(MOST).is_ok() && triangle(-MOST - 1).is_ok());
        for x in [MOST + 1, -MOST - 2, i32::MAX, i32::MIN] {
            assert_eq!(triangle(x), Err(ShapeError::NotNear));
        }
        let ray = |x, d| Ray::new(at(0, x, 0), at(1, 0, d)).unwrap().near();
        assert!(ray(MOST, LONGEST).is_ok() && ray(-MOST - 1, -LONGEST - 1).is_ok());
        assert!(ray(MOST + 1, 0).is_err() && ray(0, LONGEST + 1).is_err());
        let corners = |x, y| Aabb::from_min_max(at(0, x, 0), at(1, y, 1)).unwrap().near();
        assert!(corners(-MOST - 1, MOST).is_ok());
        assert!(corners(-MOST - 2, 0).is_err() && corners(0, MOST + 1).is_err());
        let about = |c, h| Aabb::from_center_half_extents(at(c, 0, 0), at(h, 1, 1)).unwrap().near();
        assert!(about(MOST, 0).is_ok() && about(-1, MOST).is_ok());
        assert!(about(MOST, 1).is_err() && about(1, MOST).is_err() && about(0, i32::MAX).is_err());
        let obb = |c, u, h| {
            let axes = [at(u, 0, 0), at(0, 9, 0), at(0, 0, 9)];
            Obb::from_skewed_axes(at(0, c, 0), axes, at(0, 0, h)).unwrap().near()
        };
        assert!(obb(MOST, LONGEST, LONGEST).is_ok());
        assert!(obb(MOST + 1, 1, 1).is_err() && obb(0, LONGEST + 1, 1).is_err());
        assert!(obb(0, 1, LONGEST + 1).is_err());
    }

    /// Compares with the kernels for shapes anywhere, which are different code on 64-bit machines.
    /// The cases are shapes that reach the limit, and shapes in contact.
    #[test]
    fn answers_are_those_of_shapes_anywhere() {
        let mut seed = 7_u32;
        let mut below = |n: u32| {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            ((u64::from(seed) * u64::from(n)) >> 32) as i32
        };
        let mut yes = [0; 4];
        for case in 0..20_000 {
            let mut number = |most: i32| match case % 3 {
                0 => below(2 * most as u32) - most,
                1 => [-most - 1, most, 0, 1, -1][below(5) as usize],
                _ => (below(5) - 2) * (most >> 3),
            };
            let mut point = |most| at(number(most), number(most), number(most));
            let triangle = Triangle::new(point(MOST), point(MOST), point(MOST)).unwrap();
            let near = triangle.near().unwrap();
            if let Ok(ray) = Ray::new(point(MOST), point(LONGEST)) {
                let close = ray.near().unwrap();
                assert_eq!(close.hit(&near), ray.hit(&triangle));
                assert_eq!(close.hit_once(&near), ray.hit_once(&triangle));
                assert_eq!(close.is_hit(&near), ray.is_hit(&triangle));
                yes[0] += u32::from(ray.is_hit(&triangle));
                yes[1] += u32::from(ray.hit_once(&triangle).is_some());
            }
            let (p, q) = (point(MOST), point(MOST));
            let low = core::array::from_fn(|i| p[i].min(q[i]));
            let aabb = Aabb::from_min_max(low, core::array::from_fn(|i| p[i].max(q[i]))).unwrap();
            let overlap = triangle.overlaps(&aabb);
            assert_eq!(near.overlaps(&aabb.near().unwrap()), overlap);
            assert_eq!(aabb.near().unwrap().overlaps(&near), overlap);
            yes[2] += u32::from(overlap);
            let axes = [point(LONGEST), point(LONGEST), point(LONGEST)];
            let half = point(LONGEST).map(|x| x.saturating_abs() >> 4);
            if let Ok(obb) = Obb::from_skewed_axes(p, axes, half) {
                let Ok(close) = obb.near() else { continue };
                assert_eq!(near.overlaps(&close), triangle.overlaps(&obb));
                assert_eq!(close.overlaps(&near), triangle.overlaps(&obb));
                assert_eq!(close.may_overlap(&near), obb.may_overlap(&triangle));
                yes[3] += u32::from(triangle.overlaps(&obb));
            }
        }
        assert!(yes.iter().all(|&yes| yes > 300), "{yes:?}");
    }
}
