//! Each of the 13 axes alone: cases that only one axis separates. A kernel that forgets an axis, or
//! has a wrong sign in it, fails on these and perhaps on nothing else.

use septum::Axis;
use septum_kit::{BoxNumbers, Case, Each, Rng, Sample, for_every_scalar, meets, separates};

/// Cases for each axis.
const COUNT: usize = 15;

/// A triangle and a box on a small grid.
fn small<S: Sample>(rng: &mut Rng) -> Case<S> {
    let mut point = |most: i64| rng.triple(|rng| rng.whole(-most, most));
    let vertices = [point(7), point(7), point(7)].each(|v| v.each(S::whole));
    let (p, q) = (point(3), point(3));
    let aabb = if rng.one_in(2) {
        BoxNumbers::Center(p.each(S::whole), q.each(|x| S::whole(x.abs())))
    } else {
        let min = core::array::from_fn(|i| S::whole(p[i].min(q[i])));
        BoxNumbers::Corners(min, core::array::from_fn(|i| S::whole(p[i].max(q[i]))))
    };
    Case { vertices, aabb }
}

/// The axis that separates, if exactly one does.
fn only_axis<S: Sample>(case: &Case<S>) -> Option<Axis> {
    let mut axes = Axis::ALL.into_iter().filter(|&axis| separates(case, axis));
    axes.next().filter(|_| axes.next().is_none())
}

fn each_alone<S: Sample>() {
    let mut rng = Rng::new(61);
    let mut found = [0; Axis::ALL.len()];
    while found.iter().any(|&n| n < COUNT) {
        let case = small::<S>(&mut rng);
        let Some(only) = only_axis(&case) else { continue };
        let number = Axis::ALL.iter().position(|&axis| axis == only).expect("one of the 13");
        found[number] += 1;

        let (triangle, aabb) = case.shapes();
        assert!(!meets(&case), "{case:?}");
        assert!(!triangle.overlaps(&aabb), "only {only:?}: {case:?}");
        assert_eq!(triangle.separating_axis(&aabb), Some(only), "{case:?}");
        for axis in Axis::ALL {
            assert_eq!(triangle.is_separated_by(&aabb, axis), axis == only, "{axis:?}: {case:?}");
        }
    }
}

for_every_scalar!(each_alone);

/// Both sides of the box: the axis separates on whichever side the triangle lies.
#[test]
fn from_either_side() {
    let mut rng = Rng::new(62);
    let mut found = [[0; 2]; Axis::ALL.len()];
    while found.iter().flatten().any(|&n| n < COUNT) {
        let case = small::<f32>(&mut rng);
        let Some(only) = only_axis(&case) else { continue };
        let number = Axis::ALL.iter().position(|&axis| axis == only).expect("one of the 13");
        // Reflection through the origin changes the side, and nothing else.
        let opposite = |v: [f32; 3]| v.each(|x| -x);
        let mirrored = Case {
            vertices: case.vertices.each(opposite),
            aabb: match case.aabb {
                BoxNumbers::Center(c, h) => BoxNumbers::Center(opposite(c), h),
                BoxNumbers::Corners(min, max) => BoxNumbers::Corners(opposite(max), opposite(min)),
            },
        };
        for (side, case) in [case, mirrored].into_iter().enumerate() {
            let (triangle, aabb) = case.shapes();
            assert_eq!(triangle.separating_axis(&aabb), Some(only), "{case:?}");
            assert!(!triangle.may_overlap(&aabb), "{case:?}");
            found[number][side] += 1;
        }
    }
}
