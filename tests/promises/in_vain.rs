//! `may_overlap` of oriented boxes, rays and segments: `true` in vain for at most one in a thousand
//! random pairs, in every scalar.

use fixed::types::{I0F32, I0F64, I1F31, I2F30, I2F62, I16F48, I64F0};
use septum::{Aabb, Obb, Ray, Segment, Triangle, Vec3};
use septum_kit::{Each, Rng, Sample, for_every_scalar};

/// So many pairs of shapes of each kind.
const PAIRS: usize = 6_000;

/// Shapes whose size is a part of the range of the scalar, and axes that are rotated, as long as the
/// scalar allows.
struct Shapes {
    size: f64,
    length: f64,
}

impl Shapes {
    fn point<S: Sample>(&self, rng: &mut Rng) -> [S; 3] {
        rng.triple(|rng| S::nearest(rng.real(-self.size, self.size)))
    }

    fn half<S: Sample>(&self, rng: &mut Rng) -> [S; 3] {
        rng.triple(|rng| S::nearest(rng.real(0.0, self.size / 2.0)))
    }

    fn obb<S: Sample>(&self, rng: &mut Rng) -> Obb<S> {
        let mut frame = [[self.length, 0.0, 0.0], [0.0, self.length, 0.0], [0.0, 0.0, self.length]];
        for (i, j) in [(0, 1), (1, 2), (2, 0)] {
            let (sin, cos) = rng.real(0.0, 6.3).sin_cos();
            for row in &mut frame {
                (row[i], row[j]) = (cos * row[i] - sin * row[j], sin * row[i] + cos * row[j]);
            }
        }
        let axes = frame.each(|row| Vec3::from(row.each(S::nearest)));
        Obb::from_skewed_axes(self.point(rng), axes, self.half(rng)).expect("axes that span space")
    }
}

/// Counts pairs that are disjoint of which `may_overlap` says `true`.
fn check<S: Sample>() {
    let greatest = S::GREATEST.approximate();
    let length = if greatest < 1.1 { greatest * 0.9 } else { 1.0 };
    for part in [1e-2, 0.3] {
        let shapes = Shapes { size: (greatest * part).min(1e8), length };
        // Where a unit in the last place is a thousandth of the shapes they touch now and then.
        if shapes.size * length < 1e4 * S::ZERO.moved(1).approximate() {
            continue;
        }
        let mut rng = Rng::new(0x1a7a);
        let (mut in_vain, mut apart) = ([0; 6], 0);
        for _ in 0..PAIRS {
            let (first, second) = (shapes.obb::<S>(&mut rng), shapes.obb::<S>(&mut rng));
            let aabb =
                Aabb::from_center_half_extents(shapes.point(&mut rng), shapes.half(&mut rng));
            let aabb = aabb.unwrap();
            let [a, b, c] = [(); 3].each(|()| shapes.point::<S>(&mut rng));
            let segment = Segment::new(a, b).unwrap();
            let ray = Ray::new(a, c).unwrap();
            let t = S::nearest(rng.real(0.0, 2.0_f64.min(greatest)));
            let part = ray.with_range(S::ZERO, t).unwrap();
            let triangle = Triangle::new(a, b, c).unwrap();
            let answers = [
                (first.overlaps(&second), first.may_overlap(&second)),
                (aabb.overlaps(&second), aabb.may_overlap(&second)),
                (segment.overlaps(&second), segment.may_overlap(&second)),
                (ray.overlaps(&second), ray.may_overlap(&second)),
                (part.overlaps(&second), part.may_overlap(&second)),
                (triangle.overlaps(&second), triangle.may_overlap(&second)),
            ];
            for (count, (meets, may)) in in_vain.iter_mut().zip(answers) {
                assert!(may || !meets, "{first:?} {second:?} {ray:?} {segment:?}");
                *count += usize::from(may && !meets);
                apart += usize::from(!meets);
            }
        }
        println!("{} {}: {in_vain:?}, {apart} apart", S::name(), shapes.size);
        assert!(apart > PAIRS, "{apart}");
        assert!(in_vain.iter().all(|&n| n * 1_000 <= PAIRS), "{}: {in_vain:?}", S::name());
    }
}
for_every_scalar!(check);

#[test]
fn other_fractions() {
    check::<I0F32>();
    check::<I1F31>();
    check::<I2F30>();
    check::<I0F64>();
    check::<I2F62>();
    check::<I16F48>();
    check::<I64F0>();
}
