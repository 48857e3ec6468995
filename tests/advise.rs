//! The example `advise`: what it predicts comes true, what it refuses would not do, and
//! what it recommends does.
#![cfg(feature = "fixed")]

#[path = "../examples/advise/advice.rs"]
mod advice;
#[path = "../examples/advise/costs.rs"]
mod costs;
#[path = "../examples/advise/effect.rs"]
mod effect;
#[path = "../examples/advise/kind.rs"]
mod kind;
#[path = "../examples/voxelize/mesh.rs"]
mod mesh;
#[path = "../examples/advise/options.rs"]
mod options;
#[path = "../examples/advise/paste.rs"]
mod paste;
#[path = "../examples/advise/prediction.rs"]
mod prediction;
#[path = "../examples/advise/race.rs"]
mod race;
#[path = "../examples/advise/report.rs"]
mod report;
#[allow(dead_code)]
#[path = "support/rng.rs"]
mod rng;
#[path = "../examples/advise/rung.rs"]
mod rung;
#[path = "../examples/advise/scene.rs"]
mod scene;
#[allow(dead_code)]
#[path = "../examples/shared/mod.rs"]
mod shared;
#[path = "../examples/advise/survey.rs"]
mod survey;
#[path = "../examples/advise/verdict.rs"]
mod verdict;

use std::fs;
use std::path::{Path, PathBuf};

use clap::Parser;
use fixed::FixedI16;
use fixed::types::extra::{U0, U8, U10, U14};
use fixed::types::{I4F4, I16F16, I32F32};
use septum::{Aabb, Triangle};

use advice::{Row, recommend};
use costs::Costs;
use kind::{Candidates, Kind, most_fraction_bits};
use mesh::Mesh;
use options::{Options, Up};
use prediction::Prediction;
use rng::Rng;
use rung::Rung;
use scene::{Query, Scene};
use survey::{Plan, Survey};

type Triangles = Vec<[[f64; 3]; 3]>;

fn teapot() -> Triangles {
    let mesh = Mesh::load(None, Some(Up::Y)).unwrap();
    assert_eq!(mesh.name, "teapot");
    mesh.triangles
}

fn scaled(by: f64) -> Triangles {
    teapot().into_iter().map(|t| t.map(|p| p.map(|x| x * by))).collect()
}

/// A consultation, with what it was about and what it said.
struct Advice {
    options: Options,
    scene: Scene,
    survey: Survey,
    text: String,
}

impl Advice {
    /// On these triangles, with tables of costs from a folder.
    fn with_tables(triangles: Triangles, arguments: &str, tables: &Path) -> Self {
        let words = ["advise"].into_iter().chain(arguments.split_whitespace());
        let options = Options::try_parse_from(words).unwrap();
        let scene = Scene::new(triangles, options.cell, options.tolerance).unwrap();
        let costs = Costs::read(tables, options.target).unwrap();
        let sample = options.sample.get() as usize;
        let (target, full) = (options.target, options.full);
        let survey = Survey::of(&scene, &Plan { target, sample, full, costs: &costs });
        let text = report::write("mesh", &options, &scene, &survey, &costs);
        Self { options, scene, survey, text }
    }

    /// For a small core, so that no clock has a say, and without tables.
    fn on(triangles: Triangles, arguments: &str) -> Self {
        let arguments = format!("--target m0 {arguments}");
        Self::with_tables(triangles, &arguments, Path::new("no such folder"))
    }

    fn recommended(&self) -> Option<&Row> {
        recommend(&self.survey.rows, &self.scene, self.options.bits)
    }

    /// What follows these words in the text, up to a space.
    fn figure_after(&self, words: &str) -> f64 {
        let (_, rest) = self.text.split_once(words).unwrap_or_else(|| panic!("{}", self.text));
        rest.split([' ', ',', '\n']).next().unwrap().parse().unwrap()
    }
}

#[test]
fn full_runs_count_what_was_predicted() {
    for (arguments, least_changed) in [
        ("", 3),
        ("--cell 0.3", 3),
        ("--cell 2.7 --tolerance 0.3", 1),
        ("--sample 500", 3),
        ("--sample 1000000", 3),
    ] {
        let advice = Advice::on(teapot(), &format!("--full {arguments}"));
        let rows = &advice.survey.rows;
        let mut changed = 0;
        for row in rows {
            let (counted, name) = (row.counted.unwrap(), row.kind.name());
            assert!(row.prediction.allows(counted), "{arguments}: {name}\n{}", advice.text);
            changed += u64::from(counted > 0);
        }
        assert!(rows.len() >= 10 && changed >= least_changed, "{arguments}\n{}", advice.text);
        assert!(advice.text.contains(&format!("all {} predictions hold", rows.len())));
    }
}

/// By the probability of every outcome.
#[test]
fn predictions_hold_as_often_as_they_say() {
    const ALL: u64 = 1_000_000;
    for asked in [1, 20, 400] {
        for share in [0.000001, 0.0004, 0.003, 0.02, 0.31, 0.5, 0.97, 0.999999] {
            let truth = (share * ALL as f64) as u64;
            // By logarithms: some of the outcomes are very unlikely.
            let (mut held, mut probability) = (0.0, f64::ln(1.0 - share) * f64::from(asked));
            for k in 0..=asked {
                let prediction = Prediction::new(k as u64, asked as u64, ALL, 1);
                held += if prediction.allows(truth) { probability.exp() } else { 0.0 };
                let ways = f64::from(asked - k) / f64::from(k + 1);
                probability += (ways * share / (1.0 - share)).ln();
            }
            assert!(held >= prediction::CONFIDENCE, "{held} for {share} of {asked}");
        }
    }
    // And they say something: nothing seen is nearly nothing, most is most.
    let of = |k| Prediction::new(k, 20_000, ALL, 1);
    assert!(of(0).least == 0 && (150..190).contains(&of(0).most), "{:?}", of(0));
    assert!(of(10_000).least > 485_000 && of(10_000).most < 515_000, "{:?}", of(10_000));
    assert!(of(20_000).most == ALL && of(20_000).least > ALL - 190, "{:?}", of(20_000));
}

/// What moves no farther than the tolerance changes no verdict that is not asked for.
#[test]
fn all_queries_that_matter_are_asked() {
    let triangles: Triangles = teapot().into_iter().step_by(20).collect();
    let scene = Scene::new(triangles, Some(1.5), Some(0.2)).unwrap();
    let asked: Vec<_> = (0..scene.queries()).map(|n| scene.query(n)).collect();
    let is_asked = |triangle, cell| asked.iter().any(|q| q.triangle == triangle && q.cell == cell);
    let kind = Kind::Fixed { bits: 8, frac: 2 };
    let moved = effect::Effect::of(kind, &scene).moved;
    assert!(moved > 0.2 && moved < 0.25, "{moved}: about as far as allowed");
    let [xs, ys, zs] = scene.cells.clone();
    let mut changed = 0;
    for triangle in 0..scene.triangles.len() {
        for (x, y) in xs.clone().flat_map(|x| ys.clone().map(move |y| (x, y))) {
            for z in zs.clone() {
                let query = Query { triangle, cell: [x, y, z] };
                if kind.overlaps(&scene, query) != Kind::F64.overlaps(&scene, query) {
                    changed += 1;
                    assert!(is_asked(triangle, [x, y, z]), "{query:?}");
                }
            }
        }
    }
    assert!(changed > 20, "{changed}");
}

#[test]
fn too_large_for_16_bits() {
    // 33 units times 4000.
    let advice = Advice::on(scaled(4000.0), "--bits 16");
    assert!(advice.recommended().is_none());
    let says =
        ["16 bits: too large", "and 16 bits end at 32767", "of up to 16 bits is good enough"];
    for part in says {
        assert!(advice.text.contains(part), "{part}\n{}", advice.text);
    }
    let halvings =
        advice.figure_after("16 bits end at 32767.\nWhat would help:\n  - the scene at 1/2^");
    let range = |k: f64| advice.scene.range().map(|x| x / k.exp2());
    assert!(most_fraction_bits(16, 16, range(halvings)).is_some(), "enough");
    assert!(most_fraction_bits(16, 16, range(halvings - 1.0)).is_none(), "and not too much");
    // In 32 bits there is room.
    let advice = Advice::on(scaled(4000.0), "");
    assert_eq!(advice.recommended().unwrap().kind.bits(), 32, "{}", advice.text);
    assert!(advice.text.contains("16 bits: too large"), "{}", advice.text);
}

#[test]
fn too_fine_for_16_bits() {
    let advice = Advice::on(teapot(), "--tolerance 0.0002 --bits 16");
    assert!(advice.recommended().is_none());
    assert!(advice.text.contains("16 bits: too fine: 10 fraction bits"), "{}", advice.text);
    let (_, of_16) = advice.text.split_once("16 bits: too fine").unwrap();
    let (_, rest) = of_16.split_once("--tolerance ").unwrap();
    let wanted = rest.split(' ').next().unwrap();
    let advice = Advice::on(teapot(), &format!("--tolerance {wanted} --bits 16"));
    let fraction = advice.recommended().unwrap().kind;
    assert_eq!(fraction, Kind::Fixed { bits: 16, frac: 10 }, "{}", advice.text);

    // Boxes smaller than its unit.
    let advice = Advice::on(teapot(), "--cell 0.0005 --tolerance 1 --bits 8 --sample 100");
    assert!(advice.text.contains("boxes become flat"), "{}", advice.text);
    assert!(advice.recommended().is_none());
}

/// The origin in the middle, or a scene grown to fill the type, gives bits.
#[test]
fn scenes_in_the_wrong_place() {
    let aside: Triangles =
        teapot().into_iter().map(|t| t.map(|[x, y, z]| [x + 100.0, y, z])).collect();
    let advice = Advice::on(aside, "--bits 16 --tolerance 0.002");
    let says = "the scene moved by (-100, 0, 0): room for 10 fraction bits, which is enough";
    assert!(advice.recommended().is_none() && advice.text.contains(says), "{}", advice.text);

    let tiny = Advice::on(scaled(1.0 / 4096.0), "--bits 16");
    let says = "the scene at 2^6 times its size, to use all bits, which is enough";
    assert!(tiny.recommended().is_none() && tiny.text.contains(says), "{}", tiny.text);
    let grown = Advice::on(scaled(64.0 / 4096.0), "--bits 16");
    assert!(grown.recommended().is_some(), "{}", grown.text);
}

#[test]
fn what_is_recommended_holds_every_vertex() {
    for (by, arguments) in [
        (1.0, ""),
        (1.0, "--tolerance 0.3"),
        (1e-3, ""),
        (77.7, "--cell 3"),
        (1e6, ""),
        (1.0, "--tolerance 0"),
    ] {
        let advice = Advice::on(scaled(by), arguments);
        let row = advice.recommended().unwrap();
        for query in (0..advice.scene.queries()).step_by(7).map(|n| advice.scene.query(n)) {
            for p in advice.scene.points(query) {
                let far = p.map(|x| x - row.kind.nearest(x).unwrap());
                let far = far.iter().map(|d| d * d).sum::<f64>().sqrt();
                assert!(far <= advice.scene.tolerance * (1.0 + 1e-12), "{by} {arguments}: {p:?}");
            }
        }
        let narrower = advice.survey.rows.iter().filter(|r| r.kind.bits() < row.kind.bits());
        let narrower = narrower.filter(|r| !r.kind.is_float());
        for other in narrower {
            assert!(other.refusal(&advice.scene).is_some(), "{by}: {}", other.kind.name());
        }
    }
}

/// Numbers are rounded, refused and compared as the `fixed` crate does it.
#[test]
fn types_are_what_they_are_called() {
    let mut rng = Rng::new(1);
    for _ in 0..100_000 {
        let x = (rng.real(-40_000.0, 40_000.0) * 1024.0).round() / rng.whole(1, 1 << 20) as f64;
        let raw = |bits, frac| Kind::raw(x, bits, frac).map(|raw| raw as i64);
        assert_eq!(raw(8, 4), I4F4::checked_from_num(x).map(|n| n.to_bits().into()), "{x}");
        let of_16 = FixedI16::<U10>::checked_from_num(x);
        assert_eq!(raw(16, 10), of_16.map(|n| n.to_bits().into()), "{x}");
        assert_eq!(raw(32, 16), I16F16::checked_from_num(x).map(|n| n.to_bits().into()), "{x}");
        assert_eq!(raw(64, 32), I32F32::checked_from_num(x).map(|n| n.to_bits()), "{x}");
        let nearest = Kind::Fixed { bits: 16, frac: 10 }.nearest(x);
        assert_eq!(nearest, of_16.map(|n| n.to_num()), "{x}");
        assert_eq!(Kind::F32.nearest(x), Some(f64::from(x as f32)));
    }
    let scene = Scene::new(teapot(), None, None).unwrap();
    let num = FixedI16::<U10>::from_num::<f64>;
    let mut overlapping = 0;
    for query in (0..scene.queries()).step_by(11).map(|n| scene.query(n)) {
        let [a, b, c, min, max] = scene.points(query).map(|p| p.map(num));
        let aabb = Aabb::from_min_max(min, max).unwrap();
        let overlaps = Triangle::new(a, b, c).unwrap().overlaps(&aabb);
        assert_eq!(Kind::Fixed { bits: 16, frac: 10 }.overlaps(&scene, query), overlaps);
        overlapping += u32::from(overlaps);
    }
    assert!(overlapping > 500, "{overlapping}");
    let names = [(16, 8, "I8F8"), (16, 9, "FixedI16<U9>"), (64, 32, "I32F32")];
    for (bits, frac, name) in names {
        assert_eq!(Kind::Fixed { bits, frac }.name(), name);
    }
    assert_eq!(Kind::Fixed { bits: 16, frac: 8 }.greatest(), FixedI16::<U8>::MAX.to_num::<f64>());
}

/// One more fraction bit would not do.
#[test]
fn the_most_fraction_bits() {
    let scene = Scene::new(teapot(), None, None).unwrap();
    let held = Candidates::of(&scene).held;
    for bits in [8, 16, 32, 64] {
        let most = held.iter().filter(|k| k.bits() == bits).map(|k| k.fraction_bits()).max();
        let frac = most.unwrap();
        assert!(Kind::Fixed { bits, frac }.holds(scene.range()));
        assert!(!Kind::Fixed { bits, frac: frac + 1 }.holds(scene.range()), "{bits}: {frac}");
    }
    // 16 is not below 16.
    assert_eq!(most_fraction_bits(16, 16, [-16.0, 15.9]), Some(11));
    assert_eq!(most_fraction_bits(16, 16, [-16.0, 16.0]), Some(10));
    let unit = FixedI16::<U14>::DELTA.to_num::<f64>();
    assert_eq!(most_fraction_bits(16, 16, [-2.0, 2.0 - unit]), Some(14));
    assert_eq!(FixedI16::<U0>::FRAC_NBITS, 0);
}

/// The thresholds of ARCHITECTURE.md.
#[test]
fn rungs() {
    let rung = |bits, frac, x: f64, target| {
        let scene = Scene::new(vec![[[x, 0.0, 0.0]; 3]], Some(1.0), Some(0.0)).unwrap();
        let cell = [x as i64 - 1, -1, -1];
        let query = Query { triangle: 0, cell };
        Rung::of(Kind::Fixed { bits, frac }, target, &scene, query)
    };
    use options::Target::{Host, M0};
    for (bits, frac, x, on_host, on_m0) in [
        (8, 1, 3.0, Rung::I32, Rung::I32),
        (16, 1, 3.0, Rung::I64, Rung::I32),
        (32, 16, 3.0, Rung::I64, Rung::I32),
        (32, 16, 5.0, Rung::I64AndI128, Rung::I32),
        (32, 16, 4097.0, Rung::I128, Rung::I32),
        (32, 18, 3.0, Rung::I64AndI128, Rung::I64),
        (64, 32, 3.0, Rung::I128, Rung::I128),
        (64, 41, 3.0, Rung::Wide, Rung::I128),
        (64, 60, 3.0, Rung::ExactSums, Rung::I128),
    ] {
        assert_eq!(rung(bits, frac, x, Host), on_host, "{bits} {frac} {x}");
        assert_eq!(rung(bits, frac, x, M0), on_m0, "{bits} {frac} {x}");
    }
}

/// A folder for one test, empty at its start.
fn folder(test: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("advise").join(test);
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).unwrap();
    path
}

const TARGET: &str = "\
core,query,scalar,mode,path,instructions,stack
Cortex-M0,triangle/box,I8F8,conservative,full,1,1
Cortex-M0,triangle/box,I8F8,exact,full,700,100
Cortex-M0,ray/box,I8F8,exact,full,2,2
Cortex-M4F,triangle/box,I8F8,exact,full,3,3
Cortex-M0,triangle/box,I16F16,exact,full,800,100
Cortex-M0,triangle/box,I16F16,exact,whole range,3000,100
Cortex-M0,triangle/box,f32,exact,full,650,100
";

#[test]
fn costs_of_small_cores_come_from_tables() {
    let tables = folder("costs");
    fs::write(tables.join("target.csv"), TARGET).unwrap();
    let flash = "target,program,text\nCortex-M0,triangle/box exact f32,23674\n";
    fs::write(tables.join("flash.csv"), flash).unwrap();
    let advice = Advice::with_tables(teapot(), "--target m0", &tables);
    let row = |kind: Kind| advice.survey.rows.iter().find(|row| row.kind == kind).unwrap();
    let instructions = |kind| row(kind).instructions.as_ref().map(|f| (f.value, f.is_estimate));
    let fixed = |bits, frac| Kind::Fixed { bits, frac };
    assert_eq!(instructions(fixed(16, 8)), Some((700.0, false)));
    assert_eq!(instructions(fixed(16, 10)), Some((700.0, true)));
    assert_eq!(instructions(fixed(32, 13)), Some((800.0, true)));
    assert_eq!(instructions(fixed(32, 26)), Some((3000.0, true)));
    let mixed = instructions(fixed(32, 16)).unwrap();
    assert!(mixed.0 > 800.0 && mixed.0 < 1000.0 && mixed.1, "some of both: {mixed:?}");
    assert_eq!(instructions(Kind::F64), None, "not in the table");
    assert_eq!(row(Kind::F32).code.as_ref().unwrap().value, 23674.0);
    assert_eq!(advice.recommended().unwrap().kind, Kind::F32, "the cheapest, if by little");

    fs::write(tables.join("target.csv"), TARGET.replace("650", "690")).unwrap();
    let advice = Advice::with_tables(teapot(), "--target m0", &tables);
    let frac = advice.recommended().unwrap().kind.fraction_bits();
    assert_eq!(frac, 10, "as cheap as f32, and smaller: {}", advice.text);

    fs::remove_file(tables.join("target.csv")).unwrap();
    let advice = Advice::with_tables(teapot(), "--target m0", &tables);
    assert!(advice.text.contains("docs/target.csv is not there"), "{}", advice.text);
    assert!(!advice.text.contains("docs/flash.csv is not"), "{}", advice.text);
    assert_eq!(advice.recommended().unwrap().kind, fixed(16, 10));

    fs::write(tables.join("target.csv"), TARGET.replace("700", "many")).unwrap();
    let error = Costs::read(&tables, options::Target::M0).err().unwrap().to_string();
    assert!(error.contains("many"), "{error}");
    fs::write(tables.join("target.csv"), TARGET.replace("path", "way")).unwrap();
    let error = Costs::read(&tables, options::Target::M0).err().unwrap().to_string();
    assert!(error.contains("no column path"), "{error}");
}

/// The committed tables can be read, if they are there.
#[test]
fn the_tables_that_are_there() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs");
    for target in [options::Target::M0, options::Target::M4f] {
        let costs = Costs::read(&docs, target).unwrap();
        assert!(costs.code(Kind::Fixed { bits: 32, frac: 16 }).is_some_and(|f| f.value > 500.0));
    }
}

#[test]
fn on_the_host_all_is_timed() {
    let triangles = teapot().into_iter().take(20).collect();
    let advice = Advice::with_tables(triangles, "--sample 200", Path::new("docs"));
    for row in &advice.survey.rows {
        let timing = row.timing.unwrap();
        assert!(timing.median > 0.0 && timing.usual[0] <= timing.median, "{timing:?}");
        assert!(timing.median <= timing.usual[1], "{timing:?}");
    }
    assert!(advice.text.contains("Recommended: "), "{}", advice.text);
}

/// The lines to paste, pasted.
mod pasted {
    pub(crate) const LINES: &str = include_str!("support/pasted.in");
    include!("support/pasted.in");
    pub(crate) fn overlap() -> bool {
        TRIANGLE.overlaps(&CELL)
    }
}

#[test]
fn lines_to_paste_compile() {
    let scene = Scene::new(teapot(), None, None).unwrap();
    let kind = Kind::Fixed { bits: 16, frac: 10 };
    assert_eq!(paste::lines(kind, &scene), pasted::LINES);
    assert_eq!(pasted::overlap(), kind.overlaps(&scene, scene.query(0)));
}

#[test]
fn bad_scenes_and_options() {
    let parse = |arguments: &str| Options::try_parse_from(arguments.split(' '));
    for bad in ["--cell 0", "--cell -1", "--cell nan", "--cell inf", "--tolerance -1", "--sample 0"]
    {
        let error = parse(&format!("advise {bad}")).err().unwrap().to_string();
        assert!(error.contains(bad.split(' ').next().unwrap()), "{error}");
    }
    let error = |triangles, cell| Scene::new(triangles, cell, None).err().unwrap();
    assert!(error(vec![[[1.0; 3]; 3]], None).contains("single point"));
    assert!(error(teapot(), Some(1e-300)).contains("too small"));
    assert!(error(teapot(), Some(1e-7)).contains("too small"));
    assert!(error(vec![[[1e30; 3]; 3]], Some(1.0)).contains("too far from the origin"));
    // A point among boxes is a scene.
    assert_eq!(Scene::new(vec![[[1.0; 3]; 3]], Some(1.0), Some(0.0)).unwrap().queries(), 8);
}
