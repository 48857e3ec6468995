//! A bounded result reports every result that it drops.
#![cfg(feature = "heapless")]

use fixed::types::I16F16;
use septum::interop::{Bounded, touched};
use septum::{Aabb, Obb, Overlaps, Plane, Triangle, Vec3};
use septum_kit::Each;

fn wall(x: i32) -> Triangle<I16F16> {
    let p = |y: i32, z: i32| [x, y, z].each(I16F16::from_num);
    Triangle::new(p(0, 0), p(1, 0), p(0, 1)).unwrap()
}

/// Compares with an unbounded list of the same query.
fn agrees<Shape: Overlaps<Other>, Other, const N: usize>(shapes: &[Shape], other: &Other) {
    let all: Vec<usize> = (0..shapes.len()).filter(|&i| shapes[i].overlaps(other)).collect();
    let some: Bounded<usize, N> = touched(shapes, other);
    let kept = all.len().min(N);
    assert_eq!(some.kept(), &all[..kept]);
    assert_eq!(some.missed(), all.len() - kept);
    assert_eq!(some.total(), all.len());
    assert_eq!(some.is_complete(), all.len() <= N);
    assert_eq!(some.into_complete().is_ok(), all.len() <= N);
}

#[test]
fn what_is_touched_is_kept_or_counted() {
    let walls: Vec<_> = (0..20).map(wall).collect();
    let fx = I16F16::from_num::<i32>;
    for (low, high) in [(-3, -1), (0, 0), (2, 5), (3, 11), (-5, 30)] {
        let aabb = Aabb::from_min_max([fx(low), fx(0), fx(0)], [fx(high), fx(1), fx(1)]).unwrap();
        agrees::<_, _, 0>(&walls, &aabb);
        agrees::<_, _, 1>(&walls, &aabb);
        agrees::<_, _, 4>(&walls, &aabb);
        agrees::<_, _, 20>(&walls, &aabb);
    }
    let axes = [[fx(0), fx(1), fx(0)], [fx(0), fx(0), fx(1)], [fx(1), fx(0), fx(0)]];
    let tool = Obb::new([fx(6); 3], axes.each(Vec3::from), [fx(9), fx(9), fx(2)]).unwrap();
    agrees::<_, _, 3>(&walls, &tool);
    agrees::<_, _, 8>(&walls, &tool);
    let planes: Vec<_> =
        (0..9).map(|d| Plane::from_equation([fx(1), fx(0), fx(0)], fx(-d)).unwrap()).collect();
    let aabb = Aabb::from_min_max([fx(2); 3], [fx(6); 3]).unwrap();
    agrees::<_, _, 3>(&planes, &aabb);
}

#[test]
fn whatever_is_collected_is_counted() {
    let mut counted: Bounded<u8, 2> = Bounded::default();
    assert!(counted.is_complete() && counted.kept().is_empty());
    counted.push(7);
    counted.extend([8, 9, 10]);
    assert_eq!((counted.kept(), counted.missed(), counted.total()), (&[7, 8][..], 2, 4));
    let back = counted.clone().into_complete().unwrap_err();
    assert_eq!(back, counted);
}
