//! A tree over moving boxes gives the answers of all boxes, one by one, whatever its history.

use septum::broad_phase::BoxTree;
use septum::mesh::{Mesh, MeshError, Node, Tree};
use septum::sweep::{FirstContact, Motion, Sweep};
use septum::{Aabb, Overlaps, Ray, Segment, Triangle, Vec3};
use septum_kit::{Each, Rng, Sample, for_every_scalar, three};

/// Where the boxes are, and how large: near the origin, on a small grid where many touch, far apart,
/// and at the end of the range, which some exceed.
#[derive(Clone, Copy, PartialEq)]
enum Scene {
    Near,
    Grid,
    Flat,
    End,
}

fn point<S: Sample>(scene: Scene, rng: &mut Rng) -> [S; 3] {
    match scene {
        Scene::Near => rng.triple(|rng| S::nearest(rng.real(-7.0, 7.0))),
        Scene::Grid => rng.triple(|rng| S::nearest(rng.whole(-4, 4) as f64)),
        Scene::Flat => {
            let [x, y, _] = rng.triple(|rng| S::nearest(rng.real(-7.0, 7.0)));
            [x, y, S::nearest(1.0)]
        }
        Scene::End => rng.triple(|rng| {
            let near = S::nearest(rng.real(-7.0, 7.0));
            [near, near, S::GREATEST.between(near), S::GREATEST, S::LEAST][rng.below(5)]
        }),
    }
}

fn aabb<S: Sample>(scene: Scene, rng: &mut Rng) -> Aabb<S> {
    let most = if scene == Scene::Grid { 1.0 } else { 0.5 * rng.real(0.0, 3.0) };
    let size = rng.triple(|rng| match scene {
        Scene::Grid => S::nearest(rng.whole(0, 1) as f64),
        Scene::End if rng.one_in(20) => S::GREATEST,
        _ => S::nearest(rng.real(0.0, most)),
    });
    let p = point(scene, rng);
    if rng.one_in(2) {
        return Aabb::from_center_half_extents(p, size).unwrap();
    }
    let q = three(|i| S::nearest(p[i].approximate() + size[i].approximate()));
    Aabb::from_min_max(p, three(|i| if q[i] > p[i] { q[i] } else { p[i] })).unwrap()
}

/// The indices of the boxes that satisfy `is`.
fn those<S>(boxes: &[Aabb<S>], is: impl Fn(&Aabb<S>) -> bool) -> Vec<u16> {
    (0..boxes.len()).filter(|&i| is(&boxes[i])).map(|i| i as u16).collect()
}

fn found_by<S: Sample, P: Overlaps<Aabb<S>>>(
    boxes: &[Aabb<S>],
    shape: &P,
    found: Result<&[u16], MeshError>,
) -> usize {
    let expected = those(boxes, |aabb| shape.overlaps(aabb));
    assert_eq!(found, Ok(&expected[..]), "{}", S::name());
    expected.len()
}

/// All answers of a tree against those of all boxes. Returns how many there were.
fn check<S: Sample>(tree: &BoxTree<'_, S, u16>, scene: Scene, rng: &mut Rng) -> [usize; 4] {
    let (boxes, name) = (tree.boxes(), S::name());
    let n = boxes.len();
    let mut pairs = Vec::new();
    for i in 0..n {
        let others = (i + 1..n).filter(|&j| boxes[i].overlaps(&boxes[j]));
        pairs.extend(others.map(|j| [i as u16, j as u16]));
    }
    let mut found = vec![[0; 2]; pairs.len()];
    assert_eq!(tree.pairs(&mut found), Ok(&pairs[..]), "{name}");
    if let Some(short) = pairs.len().checked_sub(1) {
        let needed = pairs.len();
        assert_eq!(tree.pairs(&mut found[..short]), Err(MeshError::Length { needed }), "{name}");
    }
    let mut counts = [pairs.len(), 0, 0, 0];
    let mut room = vec![0; n];
    for _ in 0..4 {
        let probe = aabb(scene, rng);
        counts[1] += found_by(boxes, &probe, tree.overlapping(&probe, &mut room));
        let [a, b, c] = [(); 3].each(|()| point::<S>(scene, rng));
        let triangle = Triangle::new(a, b, c).unwrap();
        counts[1] += found_by(boxes, &triangle, tree.overlapping(&triangle, &mut room));
        let segment = Segment::new(a, b).unwrap();
        counts[1] += found_by(boxes, &segment, tree.overlapping(&segment, &mut room));

        let skipped = rng.below(n.max(1));
        if let Ok(ray) = Ray::new(a, three(|i| b[i].minus(a[i]))) {
            let entered = |i: usize| ray.t_range(&boxes[i]).map(|(t, _)| (i, t));
            let sooner = |a: (usize, S), b: (usize, S)| if b.1 < a.1 { b } else { a };
            let first = (0..n).filter(|&i| i != skipped).filter_map(entered).reduce(sooner);
            assert_eq!(tree.first_hit(&ray, |i| i != skipped), first, "{name}: {ray:?}");
            counts[2] += usize::from(first.is_some());
        }
        let motion = Motion::new(a, if rng.one_in(4) { a } else { b }).unwrap();
        let met = |i: usize| Some((i, probe.first_contact(&motion, &boxes[i])?));
        type Found<S> = (usize, FirstContact<S>);
        let sooner = |a: Found<S>, b: Found<S>| if b.1.t < a.1.t { b } else { a };
        let first = (0..n).filter(|&i| i != skipped).filter_map(met).reduce(sooner);
        let by_tree = tree.first_contact(&probe, &motion, |i| i != skipped);
        assert_eq!(by_tree, first, "{name}: {probe:?} {motion:?}");
        counts[3] += usize::from(first.is_some());
    }
    counts
}

/// Trees that are built, refitted after their boxes moved a little, and refitted by an order that has
/// nothing to do with them.
fn all_boxes_one_by_one<S: Sample>() {
    let (mut rng, mut counts) = (Rng::new(61), [0; 4]);
    for n in (0..14).chain([16, 17, 33, 64, 65, 150]) {
        for scene in [Scene::Near, Scene::Grid, Scene::Flat, Scene::End] {
            let mut boxes: Vec<Aabb<S>> = (0..n).map(|_| aabb(scene, &mut rng)).collect();
            let mut nodes = vec![Node::EMPTY; Node::count_for(n)];
            let mut order = vec![0; n];
            let mut add = |more: [usize; 4]| (0..4).for_each(|i| counts[i] += more[i]);
            add(check(&BoxTree::build(&boxes, &mut nodes, &mut order).unwrap(), scene, &mut rng));
            for i in (0..n).step_by(3) {
                boxes[i] = aabb(scene, &mut rng);
            }
            add(check(&BoxTree::refit(&boxes, &mut nodes, &order).unwrap(), scene, &mut rng));
            for i in (1..n).rev() {
                order.swap(i, rng.below(i + 1));
            }
            add(check(&BoxTree::refit(&boxes, &mut nodes, &order).unwrap(), scene, &mut rng));
        }
    }
    assert!(counts.iter().zip([1_000, 1_000, 100, 100]).all(|(&n, least)| n > least), "{counts:?}");
}

/// A mesh whose vertices move: the refitted tree gives the answers of a new one.
fn a_refitted_mesh_is_a_new_one<S: Sample>() {
    let (mut rng, mut hits) = (Rng::new(62), 0);
    for round in 0..30 {
        let faces: Vec<[u16; 3]> =
            (0..60).map(|_| rng.triple(|rng| rng.below(40) as u16)).collect();
        let mut place =
            || -> Vec<Vec3<S>> { (0..40).map(|_| point(Scene::Near, &mut rng).into()).collect() };
        let (before, after) = (place(), place());
        let mut nodes = [(); 2].each(|()| vec![Node::EMPTY; Node::count_for(60)]);
        let mut orders = [[0; 60]; 2];
        let [old, new] = &mut nodes;
        Tree::build(Mesh::new(&before, &faces).unwrap(), old, &mut orders[0]).unwrap();
        let mesh = Mesh::new(&after, &faces).unwrap();
        let [kept, order] = &mut orders;
        let (refitted, built) =
            (Tree::refit(mesh, old, kept).unwrap(), Tree::build(mesh, new, order).unwrap());
        for _ in 0..20 {
            let probe = aabb::<S>(Scene::Near, &mut rng);
            let found = |tree: &Tree<'_, S, u16>| {
                let mut found: Vec<_> = tree.overlapping(&probe).collect();
                found.sort_unstable();
                found
            };
            assert_eq!(found(&refitted), found(&built), "{round}");
            let [a, b] = [(); 2].each(|()| point::<S>(Scene::Near, &mut rng));
            let Ok(ray) = Ray::new(a, three(|i| b[i].minus(a[i]))) else { continue };
            assert_eq!(refitted.first_hit(&ray), built.first_hit(&ray), "{round}");
            hits += usize::from(built.is_hit(&ray));
        }
    }
    assert!(hits > 100, "{hits}");
}

#[test]
fn an_order_is_checked() {
    let boxes = [0.0, 1.0, 2.0, 3.0, 4.0]
        .map(|x| Aabb::<f32>::from_center_half_extents([x; 3], [0.5; 3]).unwrap());
    let (mut nodes, mut order) = ([Node::EMPTY; Node::count_for(5)], [0_u16; 5]);
    BoxTree::build(&boxes, &mut nodes, &mut order).unwrap();
    for wrong in [[0, 1, 2, 3, 3], [1, 2, 3, 4, 5], [0, 1, 2, 3, u16::MAX], [4, 4, 4, 4, 4]] {
        let refused = BoxTree::refit(&boxes, &mut nodes, &wrong);
        assert_eq!(refused.unwrap_err(), MeshError::Order, "{wrong:?}");
    }
    let short = BoxTree::refit(&boxes, &mut nodes, &order[..4]);
    assert_eq!(short.unwrap_err(), MeshError::Length { needed: 5 });
    let few = BoxTree::refit(&boxes, &mut nodes[..0], &order);
    assert_eq!(few.unwrap_err(), MeshError::Length { needed: Node::count_for(5) });
}

for_every_scalar!(all_boxes_one_by_one, a_refitted_mesh_is_a_new_one);
