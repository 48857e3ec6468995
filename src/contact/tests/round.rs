//! Spheres and capsules: what floats know has the bits of exact numbers.

use std::format;

use super::{Draw, std};
use crate::arithmetic::{Each, REGISTERS_ARE_WIDE, root};
use crate::contact::body::{Flat, Round};
use crate::contact::mesh::InteriorEdges;
use crate::contact::round;
use crate::scalar::Scalar;
use crate::shape::{Aabb, Triangle, Vec3};

/// How many of these contacts floats know, and how many they leave in doubt. What they know has the
/// bits of exact numbers.
fn known<S: Scalar>(flat: Flat<'_, S>, ends: [[S; 3]; 2], radius: S) -> [usize; 2] {
    let (round, mut seen) = (Round { ends: ends.each(Vec3::from), radius }, [0; 2]);
    for bits in 0..16 {
        let bits = if let Flat::Aabb(_) = flat { bits & 1 } else { bits };
        let interior = InteriorEdges::new([1, 2, 4].each(|bit| bits & (bit * 2) != 0));
        let found = round::in_floats(flat, &round, bits % 2 == 1, interior);
        seen[usize::from(found.is_none())] += 1;
        if let Some(found) = found {
            let exact = round::exactly(flat, &round, bits % 2 == 1, interior);
            // Zeros have signs.
            assert_eq!(
                format!("{found:?}"),
                format!("{exact:?}"),
                "{flat:?} {round:?} {interior:?}"
            );
        }
    }
    seen
}

/// Spheres and capsules near triangles and boxes. Each number is drawn by `of`, and radii are larger
/// than the distance or next to it.
fn known_of<S: Scalar>(mut of: impl FnMut(&mut Draw) -> S, ulp: f64) -> [usize; 2] {
    let (mut draw, mut seen) = (Draw(11), [0; 2]);
    for n in 0..3000 {
        let [a, b, c, p, q] = [(); 5].map(|()| [(); 3].each(|()| of(&mut draw)));
        let triangle = Triangle::new(a, b, c).unwrap();
        let order = |i: usize| if a[i] < b[i] { [a[i], b[i]] } else { [b[i], a[i]] };
        let [low, high] = [0, 1].each(|end| [0, 1, 2].each(|i| order(i)[end]));
        let half = q.each(|x| if x < S::ZERO { S::ZERO } else { x });
        let aabb = match n % 4 {
            1 => Aabb::from_min_max(low, high).unwrap(),
            _ => Aabb::from_center_half_extents(a, half).unwrap(),
        };
        let (flat, point) = if n % 4 < 2 {
            (Flat::Aabb(&aabb), aabb.closest_point(p).unwrap())
        } else {
            (Flat::Triangle(&triangle), triangle.closest_point(p).unwrap().point)
        };
        let square = |x: f64| x * x;
        let [x, y, z] =
            [0, 1, 2].each(|i: usize| square(p[i].beyond_in_double(point.to_array()[i])));
        let distance = root(x + y + z + f64::MIN_POSITIVE);
        let more = [ulp, -ulp, 0.125, 0.5][n % 7 % 4];
        let radius = S::ZERO.plus_double(distance * (1.0 + more));
        if distance < 1e30 && !(S::ZERO..=S::ZERO).contains(&radius) {
            let known = known(flat, [p, if n % 3 == 0 { q } else { p }], radius);
            seen = [seen[0] + known[0], seen[1] + known[1]];
        }
    }
    seen
}

/// Floats know most contacts of spheres, and about each what exact numbers know.
#[test]
fn contacts_of_spheres_in_floats_have_the_bits_of_exact_numbers() {
    if !REGISTERS_ARE_WIDE {
        return;
    }
    let ulp = 2_f64.powi(-24);
    let mut seen = [[0; 2]; 4];
    seen[0] = known_of::<f32>(|draw| draw.number(24) as f32, ulp);
    // On a grid, slivers far from the origin, and of any size.
    seen[1] = known_of::<f32>(|draw| draw.number(2) as f32, ulp);
    seen[2] = known_of::<f32>(|draw| (draw.number(3) + draw.number(24) * 1e-6 + 9.0) as f32, ulp);
    let power = |draw: &mut Draw| 2_f64.powi((draw.number(20) * 120.0) as i32);
    seen[3] = known_of::<f32>(|draw| (draw.number(24) * power(draw)) as f32, ulp);
    #[cfg(feature = "fixed")]
    {
        use fixed::types::{I4F28, I8F8, I16F16};
        known_of::<I16F16>(|draw| I16F16::from_num(draw.number(20)), ulp);
        known_of::<I4F28>(|draw| I4F28::from_num(draw.number(28)), ulp);
        known_of::<I8F8>(|draw| I8F8::from_num(draw.number(8) * 60.0), ulp);
    }
    let least = [20_000, 15_000, 18_000, 6_000];
    assert!((0..4).all(|k| seen[k][0] > least[k]), "{seen:?}");
}

/// Capsules along a level floor, an end a little above the other or none: of how many floats know the
/// contact, of those that lie level above it, and whose ends are not over its edges.
fn known_along_a_floor<S: Scalar>(of: fn(f64) -> S) -> [usize; 2] {
    let (mut draw, mut seen) = (Draw(7), [0; 2]);
    for n in 0..400 {
        let (axis, width, rise) = (n % 3, [0.4, 2.0][n / 3 % 2], [0.0, 0.0, 1.0, -1.0][n / 6 % 4]);
        let at = |p: [f64; 3]| [0, 1, 2].each(|i: usize| of(p[(i + 3 - axis) % 3]));
        let mut end = |z: f64| at([z, draw.number(4) * width, draw.number(5) * width]);
        let ends = [end(0.5), end(0.5 + rise / 256.0)];
        let floor = [[0.25, -1.0, -1.0], [0.25, 2.0, -1.0], [0.25, -1.0, 2.0]].map(at);
        let triangle = Triangle::new(floor[0], floor[1], floor[2]).unwrap();
        let low = at([-1.0; 3]);
        let aabb = Aabb::from_min_max(low, at([0.25, 1.0, 1.0])).unwrap();
        for flat in [Flat::Triangle(&triangle), Flat::Aabb(&aabb)] {
            let [floats, _] = known(flat, ends, of(0.375));
            if rise == 0.0 && width < 1.0 {
                seen = [seen[0] + floats, seen[1] + 16];
            }
        }
    }
    seen
}

/// Of ends as near to a floor the first counts, and else the nearer one.
#[test]
fn capsules_along_a_floor_in_floats_have_the_bits_of_exact_numbers() {
    if !REGISTERS_ARE_WIDE {
        return;
    }
    let known = known_along_a_floor::<f32>(|x| x as f32);
    assert_eq!(known[0], known[1]);
    #[cfg(feature = "fixed")]
    {
        use fixed::types::{I4F28, I8F8, I16F16};
        for known in [
            known_along_a_floor::<I16F16>(I16F16::from_num),
            known_along_a_floor::<I4F28>(I4F28::from_num),
            known_along_a_floor::<I8F8>(I8F8::from_num),
        ] {
            assert_eq!(known[0], known[1]);
        }
    }
}
