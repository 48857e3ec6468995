//! A segment against an axis-aligned box: contacts by hand, and agreement of the forms. The sets of
//! `ray_box` contain segments too.

use septum::published;
use septum::{Aabb, Segment};
use septum_kit::{Rng, Sample, for_every_scalar, not_finite, three};

fn cubes() -> [Aabb<f64>; 2] {
    [
        Aabb::from_min_max([-1.0; 3], [1.0; 3]).unwrap(),
        Aabb::from_center_half_extents([0.0; 3], [1.0; 3]).unwrap(),
    ]
}

#[track_caller]
fn assert_meets(a: [f64; 3], b: [f64; 3], expected: bool) {
    for cube in cubes() {
        for (a, b) in [(a, b), (b, a)] {
            let segment = Segment::new(a, b).unwrap();
            assert_eq!(segment.overlaps(&cube), expected, "{segment:?}");
            assert!(segment.may_overlap(&cube) || !expected, "{segment:?}");
        }
    }
}

#[test]
fn what_anyone_can_see() {
    assert_meets([0.0; 3], [0.5; 3], true);
    assert_meets([-5.0, 0.0, 0.0], [5.0, 0.5, 0.0], true);
    assert_meets([2.0, 0.0, 0.0], [5.0, 0.0, 0.0], false);
    assert_meets([3.0, 0.0, 0.0], [0.0, 3.0, 0.0], false);
    assert_meets([-5.0, 0.0, 0.0], [-2.0, 0.0, 0.0], false);
}

#[test]
fn contact_counts() {
    assert_meets([1.0, 0.0, 0.0], [5.0, 0.0, 0.0], true);
    assert_meets([2.0, 0.0, 1.0], [0.0, 2.0, 1.0], true);
    assert_meets([1.0, 1.0, -3.0], [1.0, 1.0, 3.0], true);
    assert_meets([0.0, 2.0, 1.0], [2.0, 0.0, 1.0], true);
    assert_meets([0.0, 2.0, 0.0], [2.0, 0.0, 2.0], true);
    let off = 2.0_f64.next_up();
    assert_meets([off, 0.0, 1.0], [0.0, 2.0, 1.0], false);
    assert_meets([2.0, 0.0, 1.0], [0.0, off, 1.0], false);
    assert_meets([1.0_f64.next_up(), 0.0, 0.0], [5.0, 0.0, 0.0], false);
    assert_meets([1.0, 1.0_f64.next_up(), -3.0], [1.0, 1.0_f64.next_up(), 3.0], false);
}

#[test]
fn points_are_segments() {
    assert_meets([1.0; 3], [1.0; 3], true);
    assert_meets([1.0, 0.0, 1.5], [1.0, 0.0, 1.5], false);
    for cube in cubes() {
        let point = |c: [f64; 3]| Segment::from_center_half_vector(c, [0.0, -0.0, 0.0]).unwrap();
        assert!(point([1.0, -1.0, 0.0]).overlaps(&cube));
        assert!(!point([1.0, -1.0_f64.next_up(), 1.0_f64.next_up()]).overlaps(&cube));
        assert!(published::separating_axes::segment_overlaps(&point([1.0, -1.0, 0.0]), &cube));
    }
    assert_eq!(Segment::new([f64::NAN; 3], [0.0; 3]), Err(not_finite("a", None)));
}

/// Ends and centre, corners and half-extents: the same shapes in integers have the same verdict,
/// and so has their mirror image.
fn forms_agree<S: Sample>() {
    let rng = &mut Rng::new(0x5e6);
    for _ in 0..40_000 {
        let mut row = |low: i64| rng.triple(|rng| rng.whole(low, 7));
        let (c, w, p, h) = (row(-7), row(-7), row(-7), row(0));
        let whole = |of: &dyn Fn(usize) -> i64| three(|i| S::whole(of(i)));
        let of_ends = Segment::new(whole(&|i| c[i] - w[i]), whole(&|i| c[i] + w[i])).unwrap();
        let of_center = Segment::from_center_half_vector(whole(&|i| c[i]), whole(&|i| w[i]));
        let corners = Aabb::from_min_max(whole(&|i| p[i] - h[i]), whole(&|i| p[i] + h[i]));
        let half = Aabb::from_center_half_extents(whole(&|i| p[i]), whole(&|i| h[i]));
        let (of_center, corners, half) = (of_center.unwrap(), corners.unwrap(), half.unwrap());
        let expected = of_ends.overlaps(&corners);
        let mirrored = Segment::new(whole(&|i| -c[i] - w[i]), whole(&|i| w[i] - c[i])).unwrap();
        let opposite = Aabb::from_min_max(whole(&|i| -p[i] - h[i]), whole(&|i| h[i] - p[i]));
        assert_eq!(of_ends.overlaps(&half), expected, "{of_ends:?} {half:?}");
        assert_eq!(of_center.overlaps(&corners), expected, "{of_center:?} {corners:?}");
        assert_eq!(of_center.overlaps(&half), expected, "{of_center:?} {half:?}");
        assert_eq!(mirrored.overlaps(&opposite.unwrap()), expected, "{mirrored:?}");
    }
}
for_every_scalar!(forms_agree);
