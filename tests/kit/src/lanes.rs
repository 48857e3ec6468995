//! Lanes: the same verdicts and the same bits as single shapes.

use std::fmt::Debug;

use septum::lanes::{
    Aabbs, CellTriangle, Cells, Hits, NormalTriangles, Ranges, Rays, SlabRays, Triangles,
};
use septum::published;
use septum::published::slabs::SlabRay;
use septum::published::stored_normal::NormalTriangle;
use septum::published::watertight::ShearedRay;
use septum::{Aabb, Cull, Hit, Ray, Triangle};

use super::sample::Sample;

/// Shapes for each lane.
pub struct Lanes<S, const N: usize> {
    pub triangles: [Triangle<S>; N],
    pub rays: [Ray<S>; N],
    /// By their corners.
    pub boxes: [Aabb<S>; N],
    /// One more box, by its centre.
    pub centered: Option<Aabb<S>>,
}

impl<S: Sample, const N: usize> Lanes<S, N> {
    /// Compares every method on lanes with the method on single shapes; returns the number of hits.
    pub fn check(&self, cull: Cull) -> usize {
        self.check_overlaps();
        self.check_boxes();
        self.check_slab_rays();
        self.check_what_is_stored();
        self.check_rays(cull);
        self.check_triangles(cull)
    }

    fn check_boxes(&self) {
        let slabs = SlabRay::new(&self.rays[0]);
        let many = Aabbs::new(&self.boxes).expect("boxes by their corners");
        let ranges = many.t_range_rounded(&slabs);
        check_ranges("boxes", &ranges, &|k| slabs.t_range_rounded(&self.boxes[k]));
        for k in 0..N {
            assert_eq!(many.get(k), Some(self.boxes[k]));
            assert_eq!(ranges.mask[k], slabs.overlaps_rounded(&self.boxes[k]));
        }
    }

    fn check_overlaps(&self) {
        let boxes = Aabbs::new(&self.boxes).expect("boxes by their corners");
        let triangle = &self.triangles[0];
        assert_eq!(boxes.overlaps(triangle), self.boxes.map(|aabb| meets(triangle, &aabb)));
        for aabb in [Some(self.boxes[0]), self.centered].into_iter().flatten() {
            let found = Triangles::new(&self.triangles).overlaps(&aabb);
            assert_eq!(found, self.triangles.map(|t| meets(&t, &aabb)), "{aabb:?}");
        }
        // Of one size, about a vertex of each triangle.
        let Some((_, half)) = self.centered.and_then(|aabb| aabb.center_half_extents()) else {
            return;
        };
        let cells = self.triangles.map(|t| {
            Aabb::from_center_half_extents(t.vertices()[0], half).expect("half-extents that were")
        });
        let (many, expected) = (Cells::new(&cells), cells.map(|cell| meets(triangle, &cell)));
        let many = many.expect("boxes of one size");
        assert_eq!(many.overlaps(triangle), expected, "{cells:?}");
        assert_eq!(CellTriangle::new(triangle, &many).overlaps(&many), expected, "{cells:?}");
    }

    fn check_slab_rays(&self) {
        // Also directions without zeros, because a single zero sends all lanes the slow way.
        let steep = |ray: &Ray<S>| {
            let has_zero = ray.direction().to_array().contains(&S::ZERO);
            let one = [S::nearest(1.0); 3];
            if has_zero { Ray::new(ray.origin(), one).expect("a ray") } else { *ray }
        };
        for rays in [self.rays, self.rays.map(|ray| steep(&ray))] {
            let slabs: [SlabRay<S>; N] = rays.map(|ray| SlabRay::new(&ray));
            for aabb in [Some(self.boxes[0]), self.centered].into_iter().flatten() {
                let ranges = SlabRays::new(&slabs).t_range_rounded(&aabb);
                check_ranges("rays, slabs", &ranges, &|k| slabs[k].t_range_rounded(&aabb));
            }
        }
    }

    fn normals(&self) -> [NormalTriangle<S>; N] {
        self.triangles.map(|t| NormalTriangle::new(&t))
    }

    fn check_what_is_stored(&self) {
        let normals = self.normals();
        let (triangles, rays) = (Triangles::new(&self.triangles), Rays::new(&self.rays));
        let many_normals = NormalTriangles::new(&normals);
        for k in 0..N {
            assert_eq!(triangles.get(k), Some(self.triangles[k]));
            assert!(is_same(&many_normals.get(k), &Some(normals[k])));
            assert_eq!(rays.get(k), Some(self.rays[k]));
        }
    }

    fn check_rays(&self, cull: Cull) {
        let (triangle, normal) = (self.triangles[0], NormalTriangle::new(&self.triangles[0]));
        let (rays, many) = (&self.rays, Rays::new(&self.rays));
        check("rays, moller_trumbore", &many.hit_moller_trumbore(&triangle, cull), &|k| {
            published::moller_trumbore::hit(&rays[k], &triangle, cull)
        });
        check("rays, stored_normal", &many.hit_stored_normal(&normal, cull), &|k| {
            published::stored_normal::hit(&rays[k], &normal, cull)
        });
        check("rays, volumes", &many.hit_volumes(&triangle, cull), &|k| {
            published::volumes::hit(&rays[k], &triangle, cull)
        });
    }

    fn check_triangles(&self, cull: Cull) -> usize {
        let (ray, triangles, normals) = (self.rays[0], &self.triangles, self.normals());
        let (many, many_normals) = (Triangles::new(triangles), NormalTriangles::new(&normals));
        let found = many.hit_moller_trumbore(&ray, cull);
        check("triangles, moller_trumbore", &found, &|k| {
            published::moller_trumbore::hit(&ray, &triangles[k], cull)
        });
        check("triangles, stored_normal", &many_normals.hit(&ray, cull), &|k| {
            published::stored_normal::hit(&ray, &normals[k], cull)
        });
        check("triangles, volumes", &many.hit_volumes(&ray, cull), &|k| {
            published::volumes::hit(&ray, &triangles[k], cull)
        });
        check("triangles, sheared", &many.hit_watertight(&ShearedRay::new(&ray), cull), &|k| {
            ShearedRay::new(&ray).hit(&triangles[k], cull)
        });
        check("triangles, exact", &many.hit(&ray), &|k| first(&ray, &triangles[k]));
        found.mask.iter().filter(|&&hit| hit).count()
    }
}

/// One triangle and one box, compiled once for each scalar, not anew for each number of lanes.
#[inline(never)]
fn meets<S: Sample>(triangle: &Triangle<S>, aabb: &Aabb<S>) -> bool {
    triangle.overlaps(aabb)
}

/// One ray and one triangle, likewise.
#[inline(never)]
fn first<S: Sample>(ray: &Ray<S>, triangle: &Triangle<S>) -> Option<Hit<S>> {
    ray.hit(triangle)
}

/// Equal, or equal when printed: rounded methods may overflow to a NaN.
fn is_same<T: PartialEq + Debug>(a: &T, b: &T) -> bool {
    a == b || format!("{a:?}") == format!("{b:?}")
}

/// Signs of zeros count too: they differ when printed.
fn check<S: Sample, const N: usize>(
    method: &str,
    hits: &Hits<S, N>,
    one: &dyn Fn(usize) -> Option<Hit<S>>,
) {
    let (mut lanes, mut alone) = (Vec::new(), Vec::new());
    for k in 0..N {
        lanes.push((hits.mask[k], hits.get(k), (hits.t[k], hits.u[k], hits.v[k])));
        alone.push(one(k));
    }
    check_hits(method, &lanes, &alone, (hits.any(), hits.nearest()));
    assert_eq!(hits.get(N), None);
}

/// The contents of a lane: its mask, its hit, and t, u, v.
type Lane<S> = (bool, Option<Hit<S>>, (S, S, S));

/// For any number of lanes, so that it is compiled once for each scalar.
fn check_hits<S: Sample>(
    method: &str,
    lanes: &[Lane<S>],
    alone: &[Option<Hit<S>>],
    (any, nearest): (bool, Option<(usize, Hit<S>)>),
) {
    for (k, (&(mask, hit, lanes), &one)) in lanes.iter().zip(alone).enumerate() {
        assert!(is_same(&hit, &one), "{method}, lane {k}: {hit:?}, {one:?}");
        assert_eq!(mask, one.is_some(), "{method}, lane {k}");
        let scalar = one.map_or((S::ZERO, S::ZERO, S::ZERO), |hit| (hit.t, hit.u, hit.v));
        if lanes.0 == S::ZERO || lanes.1 == S::ZERO || lanes.2 == S::ZERO {
            assert_eq!(format!("{lanes:?}"), format!("{scalar:?}"), "{method}, lane {k}");
        }
    }
    assert_eq!(any, alone.iter().any(Option::is_some), "{method}");
    let expected = (alone.iter().enumerate())
        .filter_map(|(k, one)| Some((k, (*one)?)))
        .reduce(|best, next| if next.1.t < best.1.t { next } else { best });
    assert!(is_same(&nearest, &expected), "{method}: {expected:?}");
}

fn check_ranges<S: Sample, const N: usize>(
    method: &str,
    ranges: &Ranges<S, N>,
    one: &dyn Fn(usize) -> Option<(S, S)>,
) {
    for k in 0..N {
        check_range(&format!("{method}, lane {k}"), ranges.mask[k], ranges.get(k), one(k));
    }
    assert_eq!(ranges.get(N), None);
}

fn check_range<S: Sample>(lane: &str, mask: bool, range: Option<(S, S)>, one: Option<(S, S)>) {
    assert_eq!(mask, one.is_some(), "{lane}");
    assert_eq!(format!("{range:?}"), format!("{one:?}"), "{lane}");
}
