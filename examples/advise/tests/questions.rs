//! Sweeps and contacts.

use std::fs;

use clap::Parser;
use fixed::FixedI16;
use fixed::types::I4F4;
use fixed::types::extra::{U10, U16};
use septum::contact::contact;
use septum::polygon::Polygon;
use septum::sweep::{Motion, Sweep};
use septum::{Aabb, Scalar, Triangle, Vec3};

use crate::effect::Effect;
use crate::kind::Kind;
use crate::options::Options;
use crate::question::{Off, Question, across, around, capsule, middle, sphere, turned};
use crate::scene::{Query, Scene};

use super::{Advice, Triangles, folder, scaled, teapot};

const WAY: Question = Question::Sweep([0.75, -2.0, 0.3]);

/// The number in the answer, computed in the type itself.
fn said<S: Scalar>(scene: &Scene, query: Query, near: fn(f64) -> S) -> Option<S> {
    let held = |p: [f64; 3]| Vec3::from(p.map(near));
    let [a, b, c, min, max] = scene.points(query).map(held);
    let triangle = Triangle::new(a, b, c).unwrap();
    let aabb = Aabb::from_min_max(min, max).unwrap();
    if scene.question == Question::Contact {
        return contact(&aabb, &triangle).map(|found| found.translation.depth);
    }
    let [from, to] = scene.places(query).map(held);
    let first = aabb.first_contact(&Motion::new(from, to).unwrap(), &triangle);
    first.map(|first| first.t)
}

/// Times and depths rounded from `f64` are those that the type computes, also for types that end
/// below 1.
#[test]
fn numbers_are_those_of_the_type() {
    for question in [WAY, Question::Contact] {
        let scene = Scene::new(question, teapot(), None, None).unwrap();
        let small = Scene::new(question, scaled(1.0 / 128.0), Some(0.125), None).unwrap();
        let mut found = 0;
        for query in (0..scene.queries()).step_by(31).map(|n| scene.query(n)) {
            let by = |kind: Kind| kind.number(&scene, query);
            let of_16 = said(&scene, query, FixedI16::<U10>::from_num);
            let of_16 = of_16.map(|x| x.to_num::<f64>());
            assert_eq!(by(Kind::Fixed { bits: 16, frac: 10 }), of_16, "{query:?}");
            let of_32 = said(&scene, query, |x| x as f32).map(f64::from);
            assert_eq!(by(Kind::F32), of_32, "{query:?}");
            found += usize::from(of_16.is_some());
        }
        assert!(found > 300, "{found}");
        if question == Question::Contact {
            let mut ends = 0;
            for query in (0..small.queries()).map(|n| small.query(n)) {
                let of_16 = said(&small, query, FixedI16::<U16>::from_num);
                let of_16 = of_16.map(|x| x.to_num::<f64>());
                let kind = Kind::Fixed { bits: 16, frac: 16 };
                assert_eq!(kind.number(&small, query), of_16, "{query:?}");
                ends += usize::from(of_16.is_some());
            }
            assert!(ends > 300, "{ends}");
        }
    }
    let of_8 = Kind::Fixed { bits: 8, frac: 8 };
    assert_eq!(of_8.rounded_down(1.0), 127.0 / 256.0);
    assert_eq!(Kind::Fixed { bits: 8, frac: 4 }.greatest(), I4F4::MAX.to_num::<f64>());
}

/// As computed in the type itself; and motions below the tolerance change nothing.
#[test]
fn turned_boxes_and_triangles() {
    let questions = [
        (Question::Turned, 300),
        (Question::Triangle, 200),
        (Question::Polygon, 200),
        (Question::Boxes, 300),
        (Question::Sphere, 100),
        (Question::Capsule, 100),
    ];
    for (question, least) in questions {
        let scene = Scene::new(question, teapot(), None, None).unwrap();
        let kind = Kind::Fixed { bits: 16, frac: 10 };
        let near = FixedI16::<U10>::from_num::<f64>;
        let mut meet = 0;
        for query in (0..scene.queries()).step_by(31).map(|n| scene.query(n)) {
            let [a, b, c, ..] = scene.points(query).map(|p| p.map(near));
            let triangle = Triangle::new(a, b, c).unwrap();
            let meets = match question {
                Question::Turned => triangle.overlaps(&turned(&scene, query, near, near)),
                Question::Boxes => around(&triangle).overlaps(&turned(&scene, query, near, near)),
                Question::Sphere => sphere(&scene, query, near).overlaps(&triangle),
                Question::Capsule => capsule(&scene, query, near).overlaps(&triangle),
                Question::Polygon => {
                    let [.., min, max] = scene.points(query).map(|p| p.map(near));
                    let aabb = Aabb::from_min_max(min, max).unwrap();
                    Polygon::new(triangle.vertices()).unwrap().overlaps(&aabb)
                }
                _ => triangle.overlaps(&across(&scene, query, near)),
            };
            assert_eq!(kind.meets(&scene, query), meets, "{query:?}");
            meet += usize::from(meets);
        }
        assert!(meet > least, "{meet}");
        // The boxes next to the tested ones are disjoint from it.
        let [xs, ..] = scene.cells.clone();
        for n in (0..scene.queries()).step_by(97) {
            let query = scene.query(n);
            let next = Query { cell: [query.cell[0] - 1, query.cell[1], query.cell[2]], ..query };
            let is_asked = n > 0 && scene.query(n - 1).cell == next.cell;
            assert!(is_asked || !xs.contains(&next.cell[0]) || !Kind::F64.meets(&scene, next));
        }
    }
    // Axes are numbers too: a 16-bit type with 16 fraction bits has no 0.8.
    let small = Scene::new(Question::Turned, scaled(1.0 / 128.0), None, None).unwrap();
    assert!(!Kind::Fixed { bits: 16, frac: 16 }.holds(small.range()));
    let advice = Advice::on(teapot(), "--ask turned --full");
    let row = advice.survey.rows.iter().find(|row| row.kind.name() == "I16F16").unwrap();
    assert!(row.effect.moved > 1e-6 && row.effect.moved < 1e-4, "{}", row.effect.moved);
    assert!(advice.text.contains("predictions hold"), "{}", advice.text);
}

/// Rounding within the tolerance changes no verdict of a pair that is not tested.
#[test]
fn all_boxes_on_their_way_are_asked() {
    let triangles: Triangles = teapot().into_iter().step_by(40).collect();
    let way = Question::Sweep([1.9, -2.2, 0.3]);
    let scene = Scene::new(way, triangles.clone(), Some(1.5), Some(0.22)).unwrap();
    let kind = Kind::Fixed { bits: 8, frac: 2 };
    let mut changed = 0;
    for triangle in 0..triangles.len() {
        let asked = (0..scene.queries()).map(|n| scene.query(n));
        let asked: Vec<_> = asked.filter(|q| q.triangle == triangle).map(|q| q.cell).collect();
        let [xs, ys, zs] = scene.cells.clone();
        for (x, y) in xs.flat_map(|x| ys.clone().map(move |y| (x, y))) {
            for z in zs.clone() {
                let query = Query { triangle, cell: [x, y, z] };
                let verdicts = [kind, Kind::F64].map(|kind| kind.meets(&scene, query));
                assert!(verdicts == [false; 2] || asked.contains(&query.cell), "{query:?}");
                changed += u32::from(verdicts[0] != verdicts[1]);
            }
        }
    }
    assert!(changed > 20, "{changed}");
}

/// Both ends of the motion are in the range, and rounding moves them too.
#[test]
fn both_ends_are_held() {
    let of = |way| Scene::new(Question::Sweep(way), teapot(), None, None).unwrap();
    let [least, greatest] = of([100.0, 0.0, 0.0]).range();
    assert!(least < -100.0, "a box from there comes to the left end: {least}");
    assert!(greatest > 100.0, "a box at the right end goes there: {greatest}");
    // Everything except the end is on the grid.
    let corner = vec![[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]];
    let way = Question::Sweep([0.09375, 0.0, 0.0]);
    let scene = Scene::new(way, corner, Some(1.0), None).unwrap();
    let effect = |frac| Effect::of(Kind::Fixed { bits: 16, frac }, &scene);
    assert_eq!([effect(4), effect(5)].map(|effect| effect.moved), [0.03125, 0.0]);
}

#[test]
fn times_may_be_too_coarse() {
    let advice = Advice::on(teapot(), "--ask sweep --way 0,-16,0 --bits 16");
    assert!(advice.recommended().is_none(), "{}", advice.text);
    let says = "16 bits: coarse times: with 10 fraction bits a box goes up to 0.0156 between two";
    assert!(advice.text.contains(says), "{}", advice.text);
    // The suggested remedy works.
    let parts = advice.figure_after("a way of 1/");
    let arguments = format!("--ask sweep --way 0,-{},0 --bits 16", 16.0 / parts);
    let advice = Advice::on(teapot(), &arguments);
    assert_eq!(advice.recommended().unwrap().kind.bits(), 16, "{}", advice.text);
}

#[test]
fn what_is_printed_of_sweeps_and_contacts() {
    for (arguments, number) in [("sweep --way 0,-2,0", "time"), ("contact", "depth")] {
        let advice = Advice::on(teapot(), &format!("--ask {arguments} --full"));
        let row = advice.recommended().unwrap();
        assert_eq!(row.kind, Kind::Fixed { bits: 16, frac: 10 }, "{}", advice.text);
        let Off { usual, most } = row.off.unwrap();
        assert!(0.0 < usual && usual <= most && most < 0.005, "{usual} {most}");
        assert!(advice.text.contains(&format!("\n  {number} off: 99 % by ")), "{}", advice.text);
        assert!(advice.text.contains("predictions hold"), "{}", advice.text);
        let exact = advice.survey.rows.iter().find(|r| r.kind == Kind::F64).unwrap();
        assert_eq!(exact.off, Some(Off { usual: 0.0, most: 0.0 }));
    }
}

#[test]
fn costs_are_those_of_the_query() {
    let tables = folder("questions");
    let rows = "\
core,query,scalar,mode,path,instructions,stack
Cortex-M0,triangle/box,I8F8,exact,full,700,1
Cortex-M0,triangle/box sweep,I8F8,whether,hit,1,1
Cortex-M0,triangle/box sweep,I8F8,when,hit,4800,1
Cortex-M0,triangle/box sweep,I8F8,when,miss,2,1
Cortex-M0,triangle/box contact,I8F8,points too,full,9600,1
";
    fs::write(tables.join("target.csv"), rows).unwrap();
    let cycles = "query,scalar,mode,path,M0\ntriangle/box,I8F8,exact,full,960\n";
    fs::write(tables.join("cycles.csv"), cycles).unwrap();
    for (arguments, instructions) in [("sweep --way 0,1,0", 4800.0), ("contact", 9600.0)] {
        let arguments = format!("--target m0 --sample 300 --ask {arguments}");
        let advice = Advice::with_tables(teapot(), &arguments, &tables);
        let row = advice.survey.rows.iter().find(|r| r.kind.name() == "I8F8").unwrap();
        let (cost, time) = (row.instructions.as_ref().unwrap(), row.time.as_ref().unwrap());
        assert_eq!((cost.value, time.value), (instructions, instructions / 48.0));
        assert!(time.is_estimate && advice.text.contains("a lower bound"), "{}", advice.text);
    }
}

/// The squared distance is that of the type, but for a unit, because it is rounded twice.
#[test]
fn closest_points() {
    let scene = Scene::new(Question::Closest, teapot(), None, None).unwrap();
    let (kind, near) = (Kind::Fixed { bits: 16, frac: 10 }, FixedI16::<U10>::from_num::<f64>);
    for query in (0..scene.queries()).step_by(31).map(|n| scene.query(n)) {
        let [a, b, c, ..] = scene.points(query).map(|p| p.map(near));
        let squared = Triangle::new(a, b, c).unwrap().distance_squared(middle(&scene, query, near));
        let off = squared.unwrap().to_num::<f64>() - kind.number(&scene, query).unwrap();
        assert!(off.abs() <= 1.0 / 1024.0, "{query:?}: {off}");
    }
    let advice = Advice::on(teapot(), "--ask closest");
    assert!(advice.text.contains("squared distance off"), "{}", advice.text);
}

#[test]
fn ways_that_are_none() {
    let parse = |arguments: &str| Options::try_parse_from(arguments.split(' '));
    for bad in ["1,2", "1,2,3,4", "0,0,0", "1,nan,2", "1,inf,2", "a,b,c", "1;2;3"] {
        let error = parse(&format!("advise --ask sweep --way {bad}")).err().unwrap().to_string();
        assert!(error.contains("not three numbers with commas between"), "{error}");
    }
    let question = |arguments: &str| {
        let options = parse(arguments).unwrap();
        Question::new(options.ask, options.way)
    };
    assert!(question("advise --ask sweep").unwrap_err().contains("needs the way"));
    assert!(question("advise --way 1,0,0").unwrap_err().contains("--ask sweep"));
    assert!(question("advise --ask contact --way 1,0,0").unwrap_err().contains("--ask sweep"));
    assert_eq!(question("advise --ask sweep --way -1,0,2"), Ok(Question::Sweep([-1.0, 0.0, 2.0])));
}
