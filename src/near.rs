//! Shapes near the origin: queries without the code for distant shapes.
//!
//! Use these in firmware that needs a small program and a known worst case. A query on an ordinary
//! shape of a 32-bit type links later stages in wider numbers, for coordinates far from the origin.
//! A [`Near`] shape is checked once, when it is made, and its queries link only the first stage, so
//! the time of the others cannot occur. `f32` has a second stage in 64-bit integers, for contact.
//! `docs/worst-case.md` lists the most instructions of each query, with `near` and without.
//!
//! *Near* means in 32-bit fixed point less than 2¹⁷ units in the last place from zero on every axis:
//! less than 2 in `I16F16`, or 131 mm where a unit in the last place is a micrometre; −2¹⁷ itself is near. Directions,
//! axes and half-extents may be longer, up to 2¹⁹ units, and radii up to 2¹⁸. In `f32` it means less than 2¹⁰ from zero,
//! in multiples of 2⁻⁵⁰: every float between 2⁻²⁷ and 2¹⁰ is one. Types of 8 and 16 bits have no
//! second stage, and need no `near`.
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
//! In floats:
//!
//! ```
//! use septum::{Aabb, Triangle};
//!
//! let floor = Triangle::new([0.0_f32, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0])?.near()?;
//! let cell = Aabb::from_min_max([0.1, 0.1, 0.0], [0.3, 0.2, 0.5])?.near()?;
//! assert!(floor.overlaps(&cell)); // it stands on the floor
//! # Ok::<(), septum::ShapeError>(())
//! ```
//!
//! | pair | scalar | |
//! | --- | --- | --- |
//! | ray, triangle | fixed point | `hit`, `hit_once`, `hit_with`, `is_hit`, `is_hit_with` |
//! | triangle, axis-aligned box | fixed point, `f32` | `overlaps`, `may_overlap`; in fixed point [`relation`](crate::relation::Relate) |
//! | ray, axis-aligned box | fixed point | `overlaps`, in integers of 64 bits |
//! | segment, axis-aligned box | fixed point | `overlaps`, in integers of 64 bits |
//! | ray, oriented box | fixed point | `overlaps` |
//! | segment, oriented box | fixed point | `overlaps` |
//! | triangle and axis-aligned box, one of them moving (`Moving`) | fixed point | `meets`, `first_contact`; `relation_along`, `last_free`, in integers of 64 bits |
//! | triangle, oriented box | fixed point | `overlaps`, `may_overlap` |
//! | mesh, box, oriented box, sphere or capsule | fixed point | `overlapping` of its tree (`Tree::near`) |
//! | mesh, ray | fixed point | `first_hit`, `first_hit_where`, `is_hit`, `is_hit_with`, `hits_with` of its tree |
//! | mesh, moving box (`Moving`) | fixed point | `first_contact`, `first_contact_where`, `last_free` of its tree, in integers of 64 bits |
//! | triangle, sphere or capsule | fixed point | `overlaps`, in integers of up to 128 bits |
//!
//! The answers are bit for bit the answers of the ordinary shapes, except that `may_overlap` is exact of a ray
//! or a segment and an oriented box, and in `f32`.

#[cfg(feature = "fixed")]
pub use crate::query::Moving;
pub use crate::shape::Near;

#[cfg(test)]
mod floats {
    use crate::{Aabb, ShapeError, Triangle};

    #[test]
    fn sixty_bits_are_near() {
        let two_to = |e: i32| f32::from_bits(((127 + e) as u32) << 23);
        let most = two_to(10).next_down();
        let near = [0.0, -0.0, two_to(-50), 3.0 * two_to(-50), two_to(-27).next_up(), most];
        let far = [two_to(10), two_to(-51), 1.5 * two_to(-50), two_to(-28).next_up(), f32::MAX];
        let least = [f32::from_bits(1), f32::MIN_POSITIVE];
        let is_near = |x: f32| {
            let t = [[0.0, x, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -x]];
            let t = Triangle::new(t[0], t[1], t[2]).unwrap().near();
            let corners = Aabb::from_min_max([-x.abs(), 0.0, 0.0], [1e3, 0.0, 0.0]).unwrap();
            let size = Aabb::from_center_half_extents([0.0; 3], [0.0, x.abs(), 0.0]).unwrap();
            let all = [t.is_ok(), corners.near().is_ok(), size.near().is_ok()];
            assert!(all == [all[0]; 3] && t.is_ok_and(|_| true) == all[0]);
            assert!(all[0] || t == Err(ShapeError::NotNear));
            all[0]
        };
        assert!(near.into_iter().chain(near.map(|x| -x)).all(is_near));
        assert!(!far.into_iter().chain(least).any(is_near));
    }

    /// Shapes on a grid touch; the parts of a unit far below take the second stage.
    #[test]
    fn answers_are_those_of_shapes_anywhere() {
        let mut random = crate::random::Random(11);
        let mut below = |n: u64| (random.bits() % n) as f32;
        let mut count = [0; 2];
        for case in 0..20_000 {
            let mut number = || match case % 4 {
                0 => below(5) - 2.0,
                1 => (below(1 << 20) - 5e5) / 1024.0,
                2 => (below(5) - 2.0) * (1.0 + f32::EPSILON),
                _ => (below(3) - 1.0) * [1e3, 1e-8, 1.0][below(3) as usize],
            };
            let mut point = || [number(), number(), number()];
            let t = Triangle::new(point(), point(), point()).unwrap();
            let (p, q) = (point(), point());
            let of = |f: fn(f32, f32) -> f32| core::array::from_fn::<_, 3, _>(|i| f(p[i], q[i]));
            let corners = Aabb::from_min_max(of(f32::min), of(f32::max)).unwrap();
            let about = Aabb::from_center_half_extents(p, q.map(f32::abs)).unwrap();
            for aabb in [corners, about] {
                let (Ok(near), Ok(close)) = (t.near(), aabb.near()) else { continue };
                assert_eq!(near.overlaps(&close), t.overlaps(&aabb), "{t:?} {aabb:?}");
                assert_eq!(close.overlaps(&near), t.overlaps(&aabb));
                assert_eq!(near.may_overlap(&close), t.overlaps(&aabb));
                count[usize::from(t.overlaps(&aabb))] += 1;
            }
        }
        assert!(count.iter().all(|&n| n > 5000), "{count:?}");
    }
}

#[cfg(all(test, feature = "fixed"))]
mod tests {
    use crate::arithmetic::{Each, three};
    use fixed::types::I16F16;

    use crate::relation::{Relate, Relation};
    use crate::{Aabb, Capsule, Obb, Ray, Segment, ShapeError, Sphere, Triangle};

    const MOST: i32 = (1 << 17) - 1;
    const LONGEST: i32 = (1 << 19) - 1;
    const WIDEST: i32 = (1 << 18) - 1;

    fn at(x: i32, y: i32, z: i32) -> [I16F16; 3] {
        [x, y, z].each(I16F16::from_bits)
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
        let ends = |x| Segment::new(at(0, x, 0), at(1, 0, x)).unwrap().near();
        assert!(ends(MOST).is_ok() && ends(-MOST - 1).is_ok() && ends(MOST + 1).is_err());
        let about =
            |c, h| Segment::from_center_half_vector(at(c, 0, 0), at(h, 1, 1)).unwrap().near();
        assert!(about(0, MOST).is_ok() && about(0, -MOST).is_ok() && about(MOST, 0).is_ok());
        assert!(
            about(0, MOST + 2).is_err() && about(1, MOST).is_err() && about(1, -MOST - 3).is_err()
        );
        assert!(about(0, i32::MAX).is_err() && about(0, i32::MIN).is_err());
        let sphere = |c, r| Sphere::new(at(c, 0, 0), I16F16::from_bits(r)).unwrap().near();
        assert!(sphere(-MOST - 1, WIDEST).is_ok());
        assert!(sphere(MOST + 1, 0).is_err() && sphere(0, WIDEST + 1).is_err());
        let capsule =
            |b, r| Capsule::new(at(0, 0, 0), at(0, 0, b), I16F16::from_bits(r)).unwrap().near();
        assert!(capsule(MOST, WIDEST).is_ok());
        assert!(capsule(MOST + 1, 0).is_err() && capsule(0, WIDEST + 1).is_err());
    }

    /// The ray with ranges of every kind.
    fn ranged(
        ray: Ray<I16F16>,
        [from, to]: [I16F16; 2],
        far: I16F16,
    ) -> impl Iterator<Item = Ray<I16F16>> {
        let rays = [
            Ok(ray),
            ray.with_range(from, far),
            ray.with_range(None, from),
            ray.with_range(I16F16::MIN, I16F16::MIN + to.saturating_abs()),
        ];
        rays.into_iter().flatten()
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
        let mut yes = [0; 11];
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
            let relation = triangle.relation(&aabb);
            assert_eq!(near.relation(&aabb.near().unwrap()), relation);
            assert_eq!(aabb.near().unwrap().relation(&near), relation);
            yes[6] += u32::from(relation == Relation::Touching);
            yes[2] += u32::from(overlap);
            let about = q.each(|x| x >> 1).each(|x| if case % 2 == 0 { x } else { x >> 3 });
            let center = p.each(|x| x >> 1);
            for aabb in [
                aabb,
                Aabb::from_center_half_extents(center, about.each(I16F16::saturating_abs)).unwrap(),
            ] {
                let Ok(close) = aabb.near() else { continue };
                if let Ok(ray) = Ray::new(point(MOST), point(LONGEST)) {
                    let [from, to] = [point(MOST)[0], point(MOST)[0]];
                    let far = if case % 5 == 0 { I16F16::MAX } else { to.max(from) };
                    for ray in ranged(ray, [from, to], far) {
                        let near = ray.near().unwrap();
                        assert_eq!(near.overlaps(&close), ray.overlaps(&aabb), "{ray:?} {aabb:?}");
                        assert_eq!(close.overlaps(&near), ray.overlaps(&aabb));
                        yes[7] += u32::from(ray.overlaps(&aabb));
                    }
                }
                let half = point(MOST).each(|x| x >> 2);
                for segment in [
                    Segment::new(point(MOST), point(MOST)).unwrap(),
                    Segment::from_center_half_vector(center, half).unwrap(),
                ] {
                    let Ok(near) = segment.near() else { continue };
                    assert_eq!(near.overlaps(&close), segment.overlaps(&aabb));
                    assert_eq!(close.overlaps(&near), segment.overlaps(&aabb));
                    yes[8] += u32::from(segment.overlaps(&aabb));
                }
            }
            let axes = [point(LONGEST), point(LONGEST), point(LONGEST)];
            let half = point(LONGEST).each(|x| x.saturating_abs() >> 4);
            if let Ok(obb) = Obb::from_skewed_axes(p, axes, half) {
                let Ok(close) = obb.near() else { continue };
                assert_eq!(near.overlaps(&close), triangle.overlaps(&obb));
                assert_eq!(close.overlaps(&near), triangle.overlaps(&obb));
                assert_eq!(close.may_overlap(&near), obb.may_overlap(&triangle));
                yes[3] += u32::from(triangle.overlaps(&obb));
                let (from, d) = (point(MOST), point(LONGEST));
                let d = if case % 2 == 0 { d } else { three(|i| p[i] - q[i]) };
                let rays = Ray::new(q, d).map(|ray| ranged(ray, [from[0], from[1]], from[2]));
                for ray in rays.into_iter().flatten() {
                    let near = ray.near().unwrap();
                    assert_eq!(near.overlaps(&close), ray.overlaps(&obb), "{ray:?} {obb:?}");
                    assert_eq!(close.may_overlap(&near), ray.overlaps(&obb));
                    yes[10] += u32::from(ray.overlaps(&obb));
                }
                let by = q.each(|x| x >> 2);
                for segment in [
                    Segment::new(q, point(MOST)).unwrap(),
                    Segment::from_center_half_vector(center, by).unwrap(),
                ] {
                    let near = segment.near().unwrap();
                    assert_eq!(
                        near.overlaps(&close),
                        segment.overlaps(&obb),
                        "{segment:?} {obb:?}"
                    );
                    assert_eq!(close.may_overlap(&near), segment.overlaps(&obb));
                    yes[9] += u32::from(segment.overlaps(&obb));
                }
            }
            // Radii up to the greatest, which reach across the whole range.
            let radius = match case % 4 {
                0 => I16F16::from_bits(WIDEST - below(3) * (MOST >> 1)),
                n => half[0] + I16F16::DELTA * (n % 2),
            };
            let sphere = Sphere::new(p, radius).unwrap();
            let capsule = Capsule::new(p, q, radius).unwrap();
            let (meets, passes) = (sphere.overlaps(&triangle), capsule.overlaps(&triangle));
            assert_eq!(near.overlaps(&sphere.near().unwrap()), meets);
            assert_eq!(capsule.near().unwrap().overlaps(&near), passes);
            yes[4] += u32::from(meets);
            yes[5] += u32::from(passes && !meets);
        }
        assert!(yes.iter().all(|&yes| yes > 300), "{yes:?}");
    }
}
