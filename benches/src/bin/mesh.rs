//! A mesh of 90,000 triangles and its tree beside the peers' trees: rays, boxes and points, in
//! `f32`. Every answer is compared with the exact one, which comes from asking without a tree.

use std::error::Error;
use std::hint::black_box;
use std::time::{Duration, Instant};

use clap::Parser;
use obvhs::BvhBuildParams;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use obvhs::cwbvh::builder::build_cwbvh_from_tris;
use obvhs::ray::{Ray as ObvhsRay, RayHit};
use obvhs::triangle::Triangle as ObvhsTriangle;
use parry3d::math::Vector;
use parry3d::query::details::intersection_test_aabb_triangle;
use parry3d::query::{PointQuery, Ray as ParryRay, RayCast};
use parry3d::shape::{TriMesh, TriMeshFlags};
use septum::mesh::{Mesh, Node, Tree};
use septum::{Aabb, Ray, Vec3};
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

type Point = [f32; 3];

/// A closed tube along a torus knot.
fn knot(steps: u32) -> (Vec<Point>, Vec<[u32; 3]>) {
    const AROUND: u32 = 50;
    let center = |s: f64| {
        let (r, h) = (2.0 + (3.0 * s).cos(), (3.0 * s).sin());
        [r * (2.0 * s).cos(), r * (2.0 * s).sin(), h]
    };
    let unit = |v: [f64; 3]| {
        let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        v.map(|x| x / length)
    };
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let mut vertices = Vec::new();
    for i in 0..steps {
        let s = f64::from(i) / f64::from(steps) * std::f64::consts::TAU;
        let (c, ahead) = (center(s), center(s + 1e-5));
        let along = unit([0, 1, 2].map(|k| ahead[k] - c[k]));
        let side = unit(cross(along, [0.0, 0.0, 1.0]));
        let up = cross(along, side);
        for j in 0..AROUND {
            let a = f64::from(j) / f64::from(AROUND) * std::f64::consts::TAU;
            let p = |k: usize| c[k] + 0.4 * (side[k] * a.cos() + up[k] * a.sin());
            vertices.push([0, 1, 2].map(|k| p(k) as f32));
        }
    }
    let at = |i: u32, j: u32| (i % steps) * AROUND + j % AROUND;
    let cell = |i, j| {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[a, c, b], [a, d, c]]
    };
    let faces = (0..steps).flat_map(|i| (0..AROUND).flat_map(move |j| cell(i, j))).collect();
    (vertices, faces)
}

/// One way to answer all questions of a scene: by answers in numbers.
struct Method<'a> {
    name: &'static str,
    ask: Box<dyn Fn(usize) -> u64 + 'a>,
}

/// Times the methods in turns, on `count` questions, and counts answers that differ from `truth`.
fn race(title: &str, rounds: u32, count: usize, truth: &[u64], methods: &[Method<'_>]) {
    let mut best = vec![Duration::MAX; methods.len()];
    for _ in 0..rounds {
        for (method, best) in methods.iter().zip(&mut best) {
            let start = Instant::now();
            for i in 0..count {
                black_box((method.ask)(black_box(i)));
            }
            *best = start.elapsed().min(*best);
        }
    }
    println!("\n{title}");
    println!("{:34} {:>9} {:>9} {:>8}", "", "ns", "of ours", "wrong");
    for (method, time) in methods.iter().zip(&best) {
        let wrong = truth.iter().enumerate().filter(|(i, t)| (method.ask)(*i) != **t).count();
        let per_million = wrong as f64 * 1e6 / truth.len() as f64;
        println!(
            "{:34} {:9.0} {:9.2} {per_million:8.0}",
            method.name,
            time.as_nanos() as f64 / count as f64,
            time.as_secs_f64() / best[0].as_secs_f64(),
        );
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let options = Options::parse();
    let (points, faces) = knot(options.steps);
    let vertices: Vec<_> = points.iter().copied().map(Vec3::from).collect();
    let mesh = Mesh::new(&vertices, &faces)?;
    mesh.check_closed(&mut vec![[0; 2]; 3 * faces.len()])?;
    println!("A torus knot of {} triangles in f32; wrong answers per million.", faces.len());

    let mut nodes = vec![Node::EMPTY; Node::count_for(faces.len())];
    let mut order = vec![0; faces.len()];
    let start = Instant::now();
    let tree = Tree::build(mesh, &mut nodes, &mut order)?;
    println!("built in ms: septum {}", start.elapsed().as_millis());
    // As the peers are advised to do, and as tables are.
    let sorted: Vec<_> = tree.order().map(|i| faces[i]).collect();
    let nodes = tree.nodes();
    let mesh = Mesh::new(&vertices, &sorted)?;
    let tree = Tree::new(mesh, nodes)?;
    let faces = &sorted;

    let flags = TriMeshFlags::ORIENTED;
    let corners = points.iter().map(|&p| Vector::from(p)).collect();
    let parry = TriMesh::with_flags(corners, faces.to_vec(), flags)?;
    let triangles: Vec<_> = faces
        .iter()
        .map(|f| f.map(|v| points[v as usize].into()))
        .map(|[v0, v1, v2]| ObvhsTriangle { v0, v1, v2 })
        .collect();
    let mut took = Duration::ZERO;
    let bvh2 = build_bvh2_from_tris(&triangles, BvhBuildParams::very_slow_build(), &mut took);
    let cwbvh = build_cwbvh_from_tris(&triangles, BvhBuildParams::very_slow_build(), &mut took);
    let in_order =
        |indices: &[u32]| -> Vec<_> { indices.iter().map(|&i| triangles[i as usize]).collect() };
    let (of_bvh2, of_cwbvh) =
        (in_order(&bvh2.primitive_indices), in_order(&cwbvh.primitive_indices));

    let mut rng = Rng::new(7);
    let anywhere =
        |rng: &mut Rng, reach: f64| [3.4, 3.4, 1.4].map(|x| (rng.real(-x, x) * reach) as f32);
    for (title, aimed) in
        [("random rays, the first hit", false), ("rays at vertices, the first hit", true)]
    {
        let rays: Vec<(Point, Point)> = (0..4000)
            .map(|_| {
                let o = anywhere(&mut rng, 2.0);
                let to =
                    if aimed { points[rng.below(points.len())] } else { anywhere(&mut rng, 1.0) };
                (o, [0, 1, 2].map(|i| to[i] - o[i]))
            })
            .collect();
        let ours: Vec<_> = rays.iter().map(|&(o, d)| Ray::new(o, d)).collect::<Result<_, _>>()?;
        let of_parry: Vec<_> =
            rays.iter().map(|&(o, d)| ParryRay::new(o.into(), d.into())).collect();
        let of_obvhs: Vec<_> =
            rays.iter().map(|&(o, d)| ObvhsRay::new_inf(o.into(), d.into())).collect();
        // Whether there is a hit; the triangle may be another of the same vertex.
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
                ask: Box::new(|i| {
                    let mut hit = RayHit::none();
                    bvh2.ray_traverse(of_obvhs[i], &mut hit, |ray, id| of_bvh2[id].intersect(ray))
                        .into()
                }),
            },
            Method {
                name: "obvhs CwBvh, slowest build",
                ask: Box::new(|i| {
                    let mut hit = RayHit::none();
                    cwbvh
                        .ray_traverse(of_obvhs[i], &mut hit, |ray, id| of_cwbvh[id].intersect(ray))
                        .into()
                }),
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
        // How many, and which, by a sum that is the same in any order.
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
            // On a vertex, and beside it.
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
    let start = Instant::now();
    places.iter().take(20).for_each(|&p| _ = black_box(without(p)));
    println!("{:34} {:9.0}", "septum, all triangles", start.elapsed().as_nanos() as f64 / 20.0);
    Ok(())
}
