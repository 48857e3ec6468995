//! Costs.

use std::fs;
use std::path::Path;

use crate::costs::Costs;
use crate::kind::Kind;
use crate::options;
use crate::question::Question;

use super::{Advice, folder, teapot};

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
    let cycles =
        "query,scalar,mode,path,M0\ntriangle/box,I8F8,exact,full,960\nray/box,I8F8,exact,full,7\n";
    fs::write(tables.join("cycles.csv"), cycles).unwrap();
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
    assert_eq!(row(fixed(16, 8)).time.as_ref().unwrap().value, 20.0);
    assert!(row(fixed(32, 13)).time.is_none(), "not in the table of cycles");
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
    let error =
        Costs::read(&tables, options::Target::M0, Question::Overlap).err().unwrap().to_string();
    assert!(error.contains("many"), "{error}");
    fs::write(tables.join("target.csv"), TARGET.replace("path", "way")).unwrap();
    let error =
        Costs::read(&tables, options::Target::M0, Question::Overlap).err().unwrap().to_string();
    assert!(error.contains("no column path"), "{error}");
}

/// The committed tables can be read, if they are there.
#[test]
fn the_tables_that_are_there() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    for target in [options::Target::M0, options::Target::M4f, options::Target::Rv32] {
        let costs = Costs::read(&docs, target, Question::Overlap).unwrap();
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
