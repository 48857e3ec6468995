//! Refusals, and the recommendations in their place.

use clap::Parser;

use crate::kind::{Kind, most_fraction_bits};
use crate::options::Options;
use crate::question::Question;
use crate::scene::Scene;

use super::{Advice, Triangles, scaled, teapot};

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
    // 32 bits have room.
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

#[test]
fn bad_scenes_and_options() {
    let parse = |arguments: &str| Options::try_parse_from(arguments.split(' '));
    for bad in ["--cell 0", "--cell -1", "--cell nan", "--cell inf", "--tolerance -1", "--sample 0"]
    {
        let error = parse(&format!("advise {bad}")).err().unwrap().to_string();
        assert!(error.contains(bad.split(' ').next().unwrap()), "{error}");
    }
    let error =
        |triangles, cell| Scene::new(Question::Overlap, triangles, cell, None).err().unwrap();
    assert!(error(vec![[[1.0; 3]; 3]], None).contains("single point"));
    assert!(error(teapot(), Some(1e-300)).contains("too small"));
    assert!(error(teapot(), Some(1e-7)).contains("too small"));
    assert!(error(vec![[[1e30; 3]; 3]], Some(1.0)).contains("too far from the origin"));
    // A point among boxes is a scene.
    assert_eq!(
        Scene::new(Question::Overlap, vec![[[1.0; 3]; 3]], Some(1.0), Some(0.0)).unwrap().queries(),
        8
    );
}
