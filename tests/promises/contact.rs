//! Touching is overlap; shapes one unit in the last place apart do not overlap. The contacts are
//! exact by construction, so no oracle is needed.

use septum_kit::{BoxNumbers, Case, Each, Rng, Sample, Touch, for_every_scalar};

const COUNT: usize = 20_000;

#[track_caller]
fn assert_overlap<S: Sample>(case: &Case<S>, expected: bool) {
    let (triangle, aabb) = case.shapes();
    assert_eq!(triangle.overlaps(&aabb), expected, "{case:?}");
}

/// −1, 0 or 1 for each axis: toward the triangle.
fn outward(touch: &Touch) -> [i64; 3] {
    touch.normal.each(i64::signum)
}

/// The properties of every kind of contact.
fn check<S: Sample>(touch: &Touch) {
    let [by_corners, by_center] = [false, true].each(|center| touch.case::<S>(center));
    assert_overlap(&by_corners, true);
    assert_overlap(&by_center, true);

    // The whole triangle, moved by one unit in the last place.
    let outward = outward(touch);
    let mut away = by_corners;
    for v in &mut away.vertices {
        *v = core::array::from_fn(|i| v[i].moved(outward[i]));
    }
    assert_overlap(&away, false);

    for i in (0..3).filter(|&i| outward[i] != 0) {
        box_by_corners(&by_corners, i, outward[i]);
        box_by_center(&by_center, i, outward[i]);
    }
}

/// Moves the touching face by one unit in the last place, inward or outward.
fn box_by_corners<S: Sample>(case: &Case<S>, i: usize, outward: i64) {
    let face = if outward > 0 { 12 + i } else { 9 + i };
    let moved = |steps: i64| case.with_number(face, case.numbers()[face].moved(steps));
    assert_overlap(&moved(outward).expect("a larger box"), true);
    // A flat box cannot shrink.
    if let Some(smaller) = moved(-outward) {
        assert_overlap(&smaller, false);
    }
}

/// Moves the centre by one unit in the last place; changes the half-extent by one.
fn box_by_center<S: Sample>(case: &Case<S>, i: usize, outward: i64) {
    let BoxNumbers::Center(center, half) = case.aabb else { panic!("a box by its corners") };
    let with = |number: usize, x: S| case.with_number(number, x);
    assert_overlap(&with(9 + i, center[i].moved(-outward)).expect("any centre"), false);
    assert_overlap(&with(12 + i, half[i].moved(1)).expect("a larger box"), true);
    if let Some(smaller) = with(12 + i, half[i].moved(-1)) {
        assert_overlap(&smaller, false);
    }
}

fn vertex_on_the_surface<S: Sample>() {
    let mut rng = Rng::new(41);
    for _ in 0..COUNT {
        check::<S>(&Touch::vertex(&mut rng, Touch::bits::<S>()));
    }
}

fn edge_across_edge<S: Sample>() {
    let mut rng = Rng::new(42);
    for _ in 0..COUNT {
        check::<S>(&Touch::edge(&mut rng, Touch::bits::<S>()));
    }
}

fn corner_on_the_inside<S: Sample>() {
    let mut rng = Rng::new(43);
    for _ in 0..COUNT {
        check::<S>(&Touch::corner(&mut rng, Touch::bits::<S>()));
    }
}

for_every_scalar!(vertex_on_the_surface, edge_across_edge, corner_on_the_inside);
