//! A mesh of 90,000 triangles and its tree beside the peers' trees, in `f32`: rays, boxes and
//! points. Every answer is compared with the exact one, computed without a tree.

use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

use clap::Parser;
use obvhs::ray::Ray as ObvhsRay;
use parry3d::query::details::intersection_test_aabb_triangle;
use parry3d::query::{PointQuery, Ray as ParryRay, RayCast};
use septum::mesh::Mesh;
use septum::{Aabb, Ray, Vec3};
use septum_benches::ray_tree::{self, Aim, Obvhs, Point, knot, parry_mesh, rays};
use septum_benches::turns::{Method, race};
use septum_kit::Rng;

/// Times trees over a generated mesh, and counts their wrong answers.
#[derive(Parser)]
#[command(version)]
struct Options {
    /// Rounds in which all take turns; the best of each counts
    #[arg(long, default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..))]
    rounds: u32,
    /// Steps along the knot; each has 100 triangles
    #[arg(long, default_value_t = 900, value_parser = clap::value_parser!(u32).range(3..))]
    steps: u32,
}

fn main() -> Result<(), Box<dyn Error>> {
    let options = Options::parse();
    let (points, faces) = knot(options.steps);
    let vertices: Vec<_> = points.iter().copied().map(Vec3::from).collect();
    let mesh = Mesh::new(&vertices, &faces)?;
    mesh.check_closed(&mut vec![[0; 2]; 3 * faces.len()])?;
    println!("A torus knot of {} triangles in f32; wrong answers per million.", faces.len());

    // In the tree's order, as peers advise for their trees, and as tables are.
    let (tree, _) = ray_tree::tree(vertices, &faces)?;
    for steps in [800, 3000, 9800] {
        let [ours, parry] = ray_tree::builds(steps, options.rounds.min(5))?;
        let [ours, parry] = [ours, parry].map(|time| time.as_secs_f64() * 1e3);
        println!("{} triangles built in ms: septum {ours:.0}, parry3d {parry:.0}", 100 * steps);
    }
    let mesh = tree.mesh();

    let parry = parry_mesh(mesh)?;
    let (bvh2, cwbvh) = (Obvhs::bvh2(mesh), Obvhs::cwbvh(mesh));

    let mut rng = Rng::new(7);
    for (title, aim) in [
        ("random rays, the first hit", Aim::Anywhere),
        ("rays at vertices, the first hit", Aim::Vertex),
    ] {
        let rays: Vec<(Point, Point)> = rays(&points, aim, 4000, &mut rng)
            .into_iter()
            .map(|[o, to]| (o, [0, 1, 2].map(|i| to[i] - o[i])))
            .collect();
        let ours: Vec<_> = rays.iter().map(|&(o, d)| Ray::new(o, d)).collect::<Result<_, _>>()?;
        let of_parry: Vec<_> =
            rays.iter().map(|&(o, d)| ParryRay::new(o.into(), d.into())).collect();
        let of_obvhs: Vec<_> =
            rays.iter().map(|&(o, d)| ObvhsRay::new_inf(o.into(), d.into())).collect();
        // Compares only whether there is a hit: at a vertex, methods may choose different
        // triangles.
        let truth: Vec<_> = ours
            .iter()
            .take(400)
            .map(|ray| u64::from(mesh.iter().any(|t| ray.is_hit(&t))))
            .collect();
        let methods = [
            Method {
                name: "septum first_hit",
                ask: Box::new(|i| u64::from(tree.first_hit(&ours[i]).is_some())),
            },
            Method { name: "septum is_hit", ask: Box::new(|i| tree.is_hit(&ours[i]).into()) },
            Method {
                name: "parry3d TriMesh::cast_local_ray",
                ask: Box::new(|i| {
                    parry.cast_local_ray(&of_parry[i], f32::MAX, false).is_some().into()
                }),
            },
            Method {
                name: "obvhs Bvh2, slowest build",
                ask: Box::new(|i| bvh2.is_hit(&of_obvhs[i]).into()),
            },
            Method {
                name: "obvhs CwBvh, slowest build",
                ask: Box::new(|i| cwbvh.is_hit(&of_obvhs[i]).into()),
            },
        ];
        race(title, options.rounds, ours.len(), &truth, &methods);
    }

    for (title, size) in [("boxes of a hundredth", 0.03), ("boxes of a tenth", 0.3)] {
        let boxes: Vec<_> = (0..1000)
            .map(|_| {
                let center = points[rng.below(points.len())];
                let half = [(); 3].map(|()| (size * rng.real(0.3, 1.0)) as f32);
                ([0, 1, 2].map(|i| center[i] - half[i]), [0, 1, 2].map(|i| center[i] + half[i]))
            })
            .collect();
        let ours: Vec<_> =
            boxes.iter().map(|&(a, b)| Aabb::from_min_max(a, b)).collect::<Result<_, _>>()?;
        let of_parry: Vec<_> = boxes
            .iter()
            .map(|&(a, b)| parry3d::bounding_volume::Aabb::new(a.into(), b.into()))
            .collect();
        // A checksum of the indices, independent of their order.
        let tell = |found: &mut dyn Iterator<Item = u64>| {
            found
                .fold(0_u64, |sum, i| sum.wrapping_add((i + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15)))
        };
        let truth: Vec<_> = ours
            .iter()
            .take(200)
            .map(|b| {
                tell(&mut (0..).zip(mesh.iter()).filter(|(_, t)| t.overlaps(b)).map(|(i, _)| i))
            })
            .collect();
        let methods = [
            Method {
                name: "septum overlapping",
                ask: Box::new(|i| tell(&mut tree.overlapping(&ours[i]).map(|i| i as u64))),
            },
            Method {
                name: "parry3d Bvh, aabb/triangle",
                ask: Box::new(|i| {
                    let aabb = &of_parry[i];
                    let meets =
                        |&k: &u32| intersection_test_aabb_triangle(aabb, &parry.triangle(k));
                    tell(&mut parry.bvh().intersect_aabb(aabb).filter(meets).map(u64::from))
                }),
            },
            Method {
                name: "parry3d Bvh, boxes alone",
                ask: Box::new(|i| {
                    tell(&mut parry.bvh().intersect_aabb(&of_parry[i]).map(u64::from))
                }),
            },
        ];
        race(title, options.rounds, ours.len(), &truth, &methods);
    }

    let places: Vec<Point> = (0..2000)
        .map(|k| {
            let p = points[rng.below(points.len())];
            // At a vertex, and near it.
            let by = [0.0, 1e-6, 0.1, 1.0][k % 4];
            p.map(|x| x + (rng.real(-1.0, 1.0) * by) as f32)
        })
        .collect();
    let without = |p: Point| {
        let ray = Ray::new(p, [1.0, 0.0, 0.0]).expect("a ray");
        let point = Aabb::from_min_max(p, p).expect("a box");
        let crossings = mesh.iter().filter(|t| ray.is_hit_with(t, septum::HitRules::new().once()));
        crossings.count() % 2 == 1 || mesh.iter().any(|t| t.overlaps(&point))
    };
    let truth: Vec<_> = places.iter().take(200).map(|&p| without(p).into()).collect();
    let methods = [
        Method { name: "septum contains", ask: Box::new(|i| tree.contains(places[i]).into()) },
        Method {
            name: "parry3d contains, by projection",
            ask: Box::new(|i| parry.contains_local_point(places[i].into()).into()),
        },
    ];
    race("points", options.rounds, places.len(), &truth, &methods);

    for (title, by) in [("closest points, near", 0.1), ("closest points, anywhere", 2.0)] {
        let places: Vec<Point> = (0..2000)
            .map(|_| {
                let p = points[rng.below(points.len())];
                p.map(|x| x + (rng.real(-1.0, 1.0) * by) as f32)
            })
            .collect();
        // The distance in `f64` from the point that a method returns, and whether that is more than a
        // millionth above the least.
        let root = |p: Point, q: Point| {
            let d = [0, 1, 2].map(|i: usize| f64::from(p[i]) - f64::from(q[i]));
            (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt()
        };
        let least = |p: Point| {
            let all = mesh.iter().filter_map(|t| t.closest_point(p).ok());
            all.map(|closest| root(p, closest.point.to_array())).fold(f64::MAX, f64::min)
        };
        let all: Vec<_> = places.iter().take(200).map(|&p| least(p)).collect();
        let truth = vec![0; all.len()];
        let is_far = |i: usize, q: Point| {
            u64::from(all.get(i).is_some_and(|least| root(places[i], q) > least * 1.000_001 + 1e-6))
        };
        let methods = [
            Method {
                name: "septum closest_point",
                ask: Box::new(|i| {
                    let (_, closest) = tree.closest_point(places[i]).expect("triangles");
                    is_far(i, closest.point.to_array())
                }),
            },
            Method {
                name: "parry3d TriMesh::project_local_point",
                ask: Box::new(|i| {
                    let found = parry.project_local_point(places[i].into(), false).point;
                    is_far(i, [found.x, found.y, found.z])
                }),
            },
        ];
        race(title, options.rounds, places.len(), &truth, &methods);
    }
    let start = Instant::now();
    places.iter().take(20).for_each(|&p| _ = black_box(without(p)));
    println!("{:34} {:9.0}", "septum, all triangles", start.elapsed().as_nanos() as f64 / 20.0);
    Ok(())
}
