//! The last free place: a body stops there without overlapping, and the next place is not free. A
//! body in touch is free to slide and to leave.
//!
//! `SHOTS=1000000 cargo test --release --test promises stops -- --nocapture` prints the counts of a
//! million shots.

use septum::mesh::{Mesh, Node, Tree};
use septum::relation::{Relate, Relation};
use septum::sweep::{FirstContact, Motion, Sweep};
use septum::{Aabb, Triangle, Vec3};
use septum_kit::sweeps::{BoxSweep, SweepCase};
use septum_kit::{BoxNumbers, Case, Each, Rng, Sample, for_every_scalar};

/// The number of shots for one scalar.
fn shots() -> usize {
    let all = std::env::var("SHOTS").ok().and_then(|n| n.parse::<usize>().ok());
    all.map_or(4_000, |n| n / 6)
}

/// What became of the shots.
#[derive(Debug, Default)]
struct Counts {
    /// In the obstacle from the start.
    stuck: usize,
    /// The whole motion is free.
    free: usize,
    /// The next place overlaps.
    next_overlaps: usize,
    /// The next place is behind an obstacle: the way to it is not free.
    next_is_behind: usize,
    /// At the rounded place of its first contact the body overlaps.
    rounded_overlaps: usize,
}

/// A body at a place, and what it may hit.
trait Scene<S: Sample> {
    /// The relation of the body at a place, at rest.
    fn at(&self, place: Vec3<S>) -> Relation;
    fn is_free(&self, way: &Motion<S>) -> bool;
    fn last_free(&self, motion: &Motion<S>) -> Option<Vec3<S>>;
    fn first_time(&self, motion: &Motion<S>) -> Option<S>;
}

/// A body that stands at the place of its centre, and an obstacle.
struct One<S, T> {
    half: [S; 3],
    obstacle: T,
}

impl<S: Sample, T> Scene<S> for One<S, T>
where
    Aabb<S>: Sweep<T, Scalar = S, Contact = FirstContact<S>> + Relate<T>,
{
    fn at(&self, place: Vec3<S>) -> Relation {
        body(place, self.half).relation(&self.obstacle)
    }
    fn is_free(&self, way: &Motion<S>) -> bool {
        let body = body(way.from(), self.half);
        body.relation_along(way, &self.obstacle) < Relation::Overlapping
    }
    fn last_free(&self, motion: &Motion<S>) -> Option<Vec3<S>> {
        body(motion.from(), self.half).last_free(motion, &self.obstacle)
    }
    fn first_time(&self, motion: &Motion<S>) -> Option<S> {
        Some(body(motion.from(), self.half).first_contact(motion, &self.obstacle)?.t)
    }
}

struct InMesh<'a, S: Sample> {
    half: [S; 3],
    tree: Tree<'a, S, u16>,
}

impl<S: Sample> Scene<S> for InMesh<'_, S> {
    fn at(&self, place: Vec3<S>) -> Relation {
        let body = body(place, self.half);
        let each = self.tree.mesh().iter().map(|t| body.relation(&t));
        each.max().unwrap_or_default()
    }
    fn is_free(&self, way: &Motion<S>) -> bool {
        let body = body(way.from(), self.half);
        self.tree.mesh().iter().all(|t| body.relation_along(way, &t) < Relation::Overlapping)
    }
    fn last_free(&self, motion: &Motion<S>) -> Option<Vec3<S>> {
        let body = body(motion.from(), self.half);
        let (place, triangle) = self.tree.last_free(&body, motion)?;
        // The triangle named is one that blocks the next step.
        if let Some(i) = triangle {
            let next = Motion::new(motion.from(), motion.place(step(motion, place) + 1)).unwrap();
            let triangle = self.tree.mesh().triangle(i).unwrap();
            assert_eq!(body.relation_along(&next, &triangle), Relation::Overlapping);
        } else {
            assert_eq!(place, motion.to());
        }
        Some(place)
    }
    fn first_time(&self, motion: &Motion<S>) -> Option<S> {
        let (_, first) = self.tree.first_contact(&body(motion.from(), self.half), motion)?;
        Some(first.t)
    }
}

fn body<S: Sample>(center: Vec3<S>, half: [S; 3]) -> Aabb<S> {
    Aabb::from_center_half_extents(center, half).unwrap()
}

/// How many steps of the motion lead to this place: from the ordinals of the axis with most.
fn step<S: Sample>(motion: &Motion<S>, place: Vec3<S>) -> u64 {
    let [from, to, place] = [motion.from(), motion.to(), place].each(Vec3::to_array);
    let apart = |a: S, b: S| a.ordinal().abs_diff(b.ordinal());
    let first = (0..3).rev().max_by_key(|&i| apart(from[i], to[i])).unwrap();
    apart(from[first], place[first])
}

/// Shoots, and checks the stop by relations at rest and on the straight ways to it and to the next
/// place.
fn shoot<S: Sample>(scene: &impl Scene<S>, motion: &Motion<S>, counts: &mut Counts) {
    let Some(stop) = scene.last_free(motion) else {
        assert_eq!(scene.at(motion.from()), Relation::Overlapping, "{motion:?}");
        counts.stuck += 1;
        return;
    };
    assert_ne!(scene.at(motion.from()), Relation::Overlapping, "{motion:?}");
    assert_ne!(scene.at(stop), Relation::Overlapping, "{motion:?} {stop:?}");
    let way = |to| Motion::new(motion.from(), to).unwrap();
    assert!(scene.is_free(&way(stop)), "{motion:?} {stop:?}");
    if scene.is_free(motion) {
        assert_eq!(stop, motion.to());
        counts.free += 1;
        return;
    }
    let rounded = scene.first_time(motion).map(|t| scene.at(motion.at(t)));
    counts.rounded_overlaps += usize::from(rounded == Some(Relation::Overlapping));
    let k = step(motion, stop);
    assert_eq!(motion.place(k), stop, "{motion:?}");
    let next = motion.place(k + 1);
    assert!(!scene.is_free(&way(next)), "{motion:?} {stop:?} {next:?}");
    if scene.at(next) == Relation::Overlapping {
        counts.next_overlaps += 1;
    } else {
        counts.next_is_behind += 1;
    }
}

/// A number of about this size.
fn near<S: Sample>(rng: &mut Rng, size: f64) -> S {
    S::nearest(rng.real(-size, size))
}

fn half<S: Sample>(rng: &mut Rng) -> [S; 3] {
    let size = 2_f64.powf(rng.real(-5.0, 0.0));
    rng.triple(|rng| S::nearest(if rng.one_in(9) { 0.0 } else { size * rng.real(0.5, 1.0) }))
}

fn no_stop_overlaps<S: Sample>() {
    let (mut rng, n) = (Rng::new(0x5704), shots() / 4);
    let motion = |rng: &mut Rng| {
        let (from, mut to) =
            (rng.triple(|rng| near::<S>(rng, 4.0)), rng.triple(|rng| near(rng, 4.0)));
        // Half of the shots are aimed at the middle, and some others keep a number.
        if rng.one_in(2) {
            to = from.each(|x| S::nearest(rng.real(-0.3, 0.3) - x.approximate()));
        } else if rng.one_in(4) {
            to[rng.below(3)] = from[0];
        }
        Motion::new(from, to).unwrap()
    };
    let mut counts = [const {
        Counts { stuck: 0, free: 0, next_overlaps: 0, next_is_behind: 0, rounded_overlaps: 0 }
    }; 4];
    for _ in 0..n {
        // The case of the report: a wall whose top is at 0.1, or thereabouts.
        let top = S::nearest(rng.real(-0.5, 0.5));
        let [low, high] = [-7.5, 7.5].each(S::nearest);
        let wall = Aabb::from_min_max([low, low, S::nearest(-1.0)], [high, high, top]).unwrap();
        let (from, to) = (near::<S>(&mut rng, 0.5), S::nearest(-4.5));
        let fall = [
            [from, near(&mut rng, 4.0), S::nearest(rng.real(3.0, 5.0))],
            [from, near(&mut rng, 4.0), to],
        ];
        let fall = Motion::new(fall[0], fall[1]).unwrap();
        shoot(&One { half: half(&mut rng), obstacle: wall }, &fall, &mut counts[0]);

        let obstacle = body(rng.triple(|rng| near(rng, 1.5)).into(), half(&mut rng));
        shoot(&One { half: half(&mut rng), obstacle }, &motion(&mut rng), &mut counts[1]);

        let [a, b, c] = rng.triple(|rng| rng.triple(|rng| near::<S>(rng, 3.0)));
        let obstacle = Triangle::new(a, b, c).unwrap();
        shoot(&One { half: half(&mut rng), obstacle }, &motion(&mut rng), &mut counts[2]);
    }
    let mut left = n;
    while left > 0 {
        let vertices: Vec<Vec3<S>> =
            (0..9).map(|_| rng.triple(|rng| near(rng, 3.0)).into()).collect();
        let faces: Vec<[u16; 3]> = (0..12).map(|_| rng.triple(|rng| rng.below(9) as u16)).collect();
        let mesh = Mesh::new(&vertices, &faces).unwrap();
        let (mut nodes, mut order) = ([Node::EMPTY; Node::count_for(12)], [0; 12]);
        let tree = Tree::build(mesh, &mut nodes, &mut order).unwrap();
        // No answer depends on the order of the tree.
        let (mut other_nodes, mut other_order) = ([Node::EMPTY; Node::count_for(12)], [0_u16; 12]);
        for (place, i) in other_order.iter_mut().zip(tree.order()) {
            *place = 11 - i as u16;
        }
        let turned = Tree::refit(mesh, &mut other_nodes, &other_order).unwrap();
        let shots = left.min(20);
        for _ in 0..shots {
            // Small, so that it fits between the triangles.
            let half = half::<S>(&mut rng).each(|h| S::nearest(h.approximate() / 8.0));
            let motion = motion(&mut rng);
            shoot(&InMesh { half, tree }, &motion, &mut counts[3]);
            let start = body(motion.from(), half);
            assert_eq!(tree.last_free(&start, &motion), turned.last_free(&start, &motion));
        }
        left -= shots;
    }
    println!("{:8} walls, boxes, triangles, meshes: {counts:?}", S::name());
    for count in &counts {
        assert!(count.next_overlaps > n / 20, "{counts:?}");
        // Behind are points behind a triangle, and thin bodies in eight bits.
        let is_coarse = S::WHOLE_BITS < 8;
        assert!(count.next_is_behind * 9 < count.next_overlaps || is_coarse, "{counts:?}");
    }
    let is_float = S::LEAST.mantissa_exponent().1 > 0;
    assert!(counts[0].rounded_overlaps > 0 || !is_float, "{counts:?}");
    assert!(counts[1].free > n / 9 && counts[2].free > n / 9, "{counts:?}");
}

/// The stop and the next place by the oracle, in rational arithmetic, also for triangles that move.
fn stops_agree_with_the_oracle<S: Sample>() {
    let mut rng = Rng::new(0x5705);
    let mut seen = 0;
    for _ in 0..shots() / 20 {
        let way = [rng.triple(|rng| near::<S>(rng, 4.0)), rng.triple(|rng| near(rng, 4.0))];
        let motion = Motion::new(way[0], way[1]).unwrap();
        let numbers = BoxNumbers::Center(rng.triple(|rng| near(rng, 1.5)), half(&mut rng));
        let aabb = numbers.shape().unwrap();
        // The triangle is anywhere: it is moved by exactly the difference of places.
        let case =
            Case { vertices: rng.triple(|rng| rng.triple(|rng| near(rng, 3.0))), aabb: numbers };
        let relation = |to: Vec3<S>| SweepCase { case, way: [way[0], to.into()] }.relation();
        if let Some(stop) = case.shapes().0.last_free(&motion, &aabb) {
            assert!(relation(stop) < Relation::Overlapping, "{case:?} {motion:?}");
            if stop != motion.to() {
                let next = motion.place(step(&motion, stop) + 1);
                assert_eq!(relation(next), Relation::Overlapping, "{case:?} {motion:?}");
                seen += 1;
            }
        } else {
            assert_eq!(relation(motion.from()), Relation::Overlapping, "{case:?}");
        }
        let boxes = [BoxNumbers::Center(way[0], half(&mut rng)), numbers];
        let relation = |to: Vec3<S>| BoxSweep { boxes, way: [way[0], to.into()] }.relation();
        let moving = boxes[0].shape().unwrap();
        if let Some(stop) = moving.last_free(&motion, &aabb) {
            assert!(relation(stop) < Relation::Overlapping, "{boxes:?} {motion:?}");
            if stop != motion.to() {
                let next = motion.place(step(&motion, stop) + 1);
                assert_eq!(relation(next), Relation::Overlapping, "{boxes:?} {motion:?}");
                seen += 1;
            }
        }
    }
    assert!(seen > shots() / 200, "{seen}");
}

/// Places are on the way, each axis within a unit in the last place, or of the longest step.
fn places_are_on_the_way<S: Sample>() {
    let mut rng = Rng::new(0x5706);
    let most = S::nearest(7.5);
    let unit = most.approximate() - most.moved(-1).approximate();
    for _ in 0..500 {
        let [from, to] = [0; 2].each(|_| rng.triple(|rng| near::<S>(rng, 7.0)));
        let motion = Motion::new(from, to).unwrap();
        assert_eq!((motion.place(0), motion.place(motion.steps())), (from.into(), to.into()));
        let k = rng.bits() % motion.steps().max(1);
        let (a, b) = (motion.place(k).to_array(), motion.place(k + 1).to_array());
        assert_eq!(step(&motion, a.into()), k);
        let t = S::nearest(rng.real(0.0, 1.0));
        let (at, part) = (motion.at(t).to_array(), t.approximate());
        let longest = (0..3).rev().max_by_key(|&i| from[i].ordinal().abs_diff(to[i].ordinal()));
        let i = longest.unwrap();
        let [p, q] = [from[i], to[i]].each(S::approximate);
        let on_axis = if p == q { 0.0 } else { (a[i].approximate() - p) / (q - p) };
        for j in 0..3 {
            let [p, q] = [from[j], to[j]].each(S::approximate);
            for (found, part) in [(a[j], on_axis), (at[j], part)] {
                let off = found.approximate() - (p + (q - p) * part);
                assert!(off.abs() <= 4.0 * unit, "{motion:?} {k} {t:?}: {off}");
            }
            let is_between = |x: S| (from[j] <= x && x <= to[j]) || (to[j] <= x && x <= from[j]);
            assert!(is_between(a[j]) && is_between(b[j]) && is_between(at[j]), "{motion:?} {k}");
        }
        assert_eq!((motion.at(S::ZERO), motion.at(S::LEAST)), (from.into(), from.into()));
    }
}

/// Bodies that begin in touch with a wall, with a slanted triangle, and with a floor of triangles:
/// they slide, they leave, and they do not enter.
fn bodies_in_touch_are_free<S: Sample>() {
    let (mut rng, n) = (Rng::new(0x5707), shots() / 4);
    // Whole eighths, which every scalar has, within the range of eight bits.
    let at = |p: [i64; 3]| p.each(|x| S::nearest(x as f64 / 8.0));
    let floor: Vec<Vec3<S>> = [[-60, -60, 0], [60, -60, 0], [-60, 60, 0], [60, 60, 0], [0, 0, 0]]
        .map(|p| at(p).into())
        .to_vec();
    let mesh = Mesh::new(&floor, &[[0_u16, 1, 4], [1, 3, 4], [3, 2, 4], [2, 0, 4]]).unwrap();
    let (mut nodes, mut order) = ([Node::EMPTY], [0; 4]);
    let tree = Tree::build(mesh, &mut nodes, &mut order).unwrap();
    let wall = Aabb::from_min_max(at([-60, -60, -9]), at([60, 60, 0])).unwrap();
    // x + y + z = 0.
    let slope = Triangle::new(at([30, -15, -15]), at([-15, 30, -15]), at([-15, -15, 30])).unwrap();
    let (mut entered, mut counts) = ([0; 3], Counts::default());
    for _ in 0..n {
        let [a, b, h] = [rng.whole(-20, 20), rng.whole(-20, 20), rng.whole(0, 9)];
        let [c, d, up] = [rng.whole(-20, 20), rng.whole(-20, 20), rng.whole(-2, 2).max(-1)];
        let half = at([rng.whole(1, 9), rng.whole(1, 9), h]);
        let slide = Motion::new(at([a, b, h]), at([c, d, h + up])).unwrap();
        let enters = up < 0;
        // A body that enters goes on until its height is rounded to less.
        let is_right =
            |stop: Vec3<S>| if enters { stop.z == slide.from().z } else { stop == slide.to() };
        let on_wall = One { half, obstacle: wall };
        assert!(on_wall.last_free(&slide).is_some_and(is_right), "{half:?} {slide:?}");
        shoot(&on_wall, &slide, &mut counts);
        // A flat body lies in the floor, and overlaps it.
        let on_floor = InMesh { half, tree };
        assert_eq!(on_floor.last_free(&slide).map(is_right), (h > 0).then_some(true), "{slide:?}");
        shoot(&on_floor, &slide, &mut counts);
        entered[0] += usize::from(enters);

        // The corner of a cube on the slope; the way is in the plane, or off it.
        let h = rng.whole(1, 3);
        let [x, y] = [rng.whole(-4, 4), rng.whole(-4, 4)];
        let [dx, dy] = [rng.whole(-4, 4), rng.whole(-4, 4)];
        let corner = [x, y, -x - y];
        let to = [x + dx, y + dy, -x - y - dx - dy + up];
        let way = Motion::new(at(corner.each(|x| x + h)), at(to.each(|x| x + h))).unwrap();
        let on_slope = One { half: at([h; 3]), obstacle: slope };
        assert_eq!(on_slope.last_free(&way).map(|stop| stop == way.to()), Some(!enters), "{way:?}");
        shoot(&on_slope, &way, &mut counts);
        entered[1] += usize::from(!enters && up == 0 && (dx, dy) != (0, 0));
        entered[2] += usize::from(up > 0);
    }
    assert!(entered.iter().all(|&count| count > n / 9), "{entered:?}");
}
for_every_scalar!(
    no_stop_overlaps,
    stops_agree_with_the_oracle,
    places_are_on_the_way,
    bodies_in_touch_are_free,
);
