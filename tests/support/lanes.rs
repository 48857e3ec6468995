//! Lanes: the same verdicts and the same bits as one by one.

use std::fmt::Debug;

use septum::{
    Aabb, Aabbs, Cull, Hit, Hits, NormalTriangle, NormalTriangles, Ranges, Ray, Rays, SlabRay,
    SlabRays, Triangle, Triangles,
};

use super::scalar::Sample;

/// Shapes for each lane.
pub(crate) struct Lanes<S, const N: usize> {
    pub(crate) triangles: [Triangle<S>; N],
    pub(crate) rays: [Ray<S>; N],
    /// By their corners.
    pub(crate) boxes: [Aabb<S>; N],
    /// One more box, by its centre.
    pub(crate) centered: Option<Aabb<S>>,
}

impl<S: Sample, const N: usize> Lanes<S, N> {
    /// Compares every method on lanes with the same one by one; returns how many lanes
    /// were hit.
    pub(crate) fn check(&self, cull: Cull) -> usize {
        self.check_boxes();
        self.check_slab_rays();
        self.check_what_is_stored();
        self.check_rays(cull);
        self.check_triangles(cull)
    }

    fn check_boxes(&self) {
        let slabs = self.rays[0].for_slabs();
        let many = Aabbs::new(&self.boxes).expect("boxes by their corners");
        let ranges = slabs.t_range_each_rounded(&many);
        check_ranges("boxes", &ranges, |k| slabs.t_range_rounded(&self.boxes[k]));
        for k in 0..N {
            assert_eq!(many.get(k), Some(self.boxes[k]));
            assert_eq!(ranges.mask[k], slabs.overlaps_rounded(&self.boxes[k]));
        }
    }

    fn check_slab_rays(&self) {
        // Directions without a nought too, lest one lane send all the slow way.
        let steep = |ray: &Ray<S>| {
            let has_nought = ray.direction().to_array().contains(&S::ZERO);
            let one = [S::nearest(1.0); 3];
            if has_nought { Ray::new(ray.origin(), one).expect("a ray") } else { *ray }
        };
        for rays in [self.rays, self.rays.map(|ray| steep(&ray))] {
            let slabs: [SlabRay<S>; N] = rays.map(|ray| ray.for_slabs());
            for aabb in [Some(self.boxes[0]), self.centered].into_iter().flatten() {
                let ranges = SlabRays::new(&slabs).t_range_rounded(&aabb);
                check_ranges("rays, slabs", &ranges, |k| slabs[k].t_range_rounded(&aabb));
            }
        }
    }

    fn normals(&self) -> [NormalTriangle<S>; N] {
        self.triangles.map(|t| t.with_normal())
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
        let (triangle, normal) = (self.triangles[0], self.triangles[0].with_normal());
        let (rays, many) = (&self.rays, Rays::new(&self.rays));
        check("rays, moller_trumbore", &many.hit_moller_trumbore(&triangle, cull), |k| {
            rays[k].hit_moller_trumbore(&triangle, cull)
        });
        check("rays, stored_normal", &many.hit_stored_normal(&normal, cull), |k| {
            rays[k].hit_stored_normal(&normal, cull)
        });
        check("rays, volumes", &many.hit_volumes(&triangle, cull), |k| {
            rays[k].hit_volumes(&triangle, cull)
        });
    }

    fn check_triangles(&self, cull: Cull) -> usize {
        let (ray, triangles, normals) = (self.rays[0], &self.triangles, self.normals());
        let (many, many_normals) = (Triangles::new(triangles), NormalTriangles::new(&normals));
        let found = ray.hit_each_moller_trumbore(&many, cull);
        check("triangles, moller_trumbore", &found, |k| {
            ray.hit_moller_trumbore(&triangles[k], cull)
        });
        check("triangles, stored_normal", &ray.hit_each_stored_normal(&many_normals, cull), |k| {
            ray.hit_stored_normal(&normals[k], cull)
        });
        check("triangles, volumes", &ray.hit_each_volumes(&many, cull), |k| {
            ray.hit_volumes(&triangles[k], cull)
        });
        check("triangles, sheared", &ray.sheared().hit_each(&many, cull), |k| {
            ray.sheared().hit(&triangles[k], cull)
        });
        check("triangles, exact", &ray.hit_each(&many), |k| ray.hit(&triangles[k]));
        found.mask.iter().filter(|&&hit| hit).count()
    }
}

/// Equal, or the same when written out: rounded methods may overflow to a NaN.
fn is_same<T: PartialEq + Debug>(a: &T, b: &T) -> bool {
    a == b || format!("{a:?}") == format!("{b:?}")
}

/// The signs of noughts are bits too: written out they differ.
fn check<S: Sample, const N: usize>(
    method: &str,
    hits: &Hits<S, N>,
    one: impl Fn(usize) -> Option<Hit<S>>,
) {
    for k in 0..N {
        let one = one(k);
        assert!(is_same(&hits.get(k), &one), "{method}, lane {k}: {:?}, {one:?}", hits.get(k));
        assert_eq!(hits.mask[k], one.is_some(), "{method}, lane {k}");
        let lanes = (hits.t[k], hits.u[k], hits.v[k]);
        let scalar = one.map_or((S::ZERO, S::ZERO, S::ZERO), |hit| (hit.t, hit.u, hit.v));
        if lanes.0 == S::ZERO || lanes.1 == S::ZERO || lanes.2 == S::ZERO {
            assert_eq!(format!("{lanes:?}"), format!("{scalar:?}"), "{method}, lane {k}");
        }
    }
    assert_eq!(hits.any(), (0..N).any(|k| one(k).is_some()), "{method}");
    assert_eq!(hits.get(N), None);
    let nearest = (0..N)
        .filter_map(|k| Some((k, one(k)?)))
        .reduce(|best, next| if next.1.t < best.1.t { next } else { best });
    assert!(is_same(&hits.nearest(), &nearest), "{method}: {nearest:?}");
}

fn check_ranges<S: Sample, const N: usize>(
    method: &str,
    ranges: &Ranges<S, N>,
    one: impl Fn(usize) -> Option<(S, S)>,
) {
    for k in 0..N {
        let one = one(k);
        assert_eq!(ranges.mask[k], one.is_some(), "{method}, lane {k}");
        assert_eq!(format!("{:?}", ranges.get(k)), format!("{one:?}"), "{method}, lane {k}");
    }
    assert_eq!(ranges.get(N), None);
}
