//! Products at the ends of 32 bits: short windows and long ones agree. Coordinates as integers.

use super::super::{Arithmetic, BigInt, Embeds, Int64OfFloats, Limbed, cross, dot};
use super::{Limbs2, Limbs4};
use super::{ShortWindow, Window, bits};
use crate::arithmetic::Each;
use crate::random::Random;

/// A number in more limbs.
fn long(x: &impl Limbed) -> BigInt<24> {
    let limbs = x.limbs();
    let fill = if limbs.last().is_some_and(|top| top >> 63 != 0) { u64::MAX } else { 0 };
    let mut all = [fill; 24];
    for (to, &limb) in all.iter_mut().zip(limbs) {
        *to = limb;
    }
    BigInt(all)
}

/// The greatest numbers of each degree that kernels make of three vectors.
fn products<N>([a, b, c]: [[N::Length; 3]; 3]) -> [BigInt<24>; 5]
where
    N: Arithmetic<Area: Limbed, Volume: Limbed, Quartic: Limbed, Sextic: Limbed>,
{
    let n = cross::<N>(&a, &b);
    let volume = dot::<N>(&n, &c);
    let square = |x| N::quartic(x, x);
    let quartic = square(n[0]) + square(n[1]) + square(n[2]);
    let squares = N::sextic(volume, volume) + N::sextic(volume, volume) + N::sextic(volume, volume);
    let sextic = N::sextic_of_areas(quartic, n[0]);
    [long(&n[0]), long(&volume), long(&quartic), long(&squares), long(&sextic)]
}

/// All vectors whose coordinates are minus the greatest length, the greatest, or one.
fn vectors() -> impl Iterator<Item = [[i8; 3]; 3]> {
    (0..19_683).map(|k: u32| {
        [0, 1, 2].each(|v| [0, 1, 2].each(|i| [-1, 1, 0][(k / 3_u32.pow(3 * v + i) % 3) as usize]))
    })
}

#[test]
fn short_windows_hold_the_products_of_32_bits() {
    // In the frame, differences are doubled.
    let of = |x: i8| if x == 0 { 1 } else { i64::from(x) << 33 };
    for edges in vectors().map(|all| all.each(|v| v.each(of))) {
        let long = products::<Window>(edges.each(|v| v.each(i128::from)));
        assert_eq!(products::<ShortWindow>(edges), long, "{edges:?}");
    }
}

#[test]
fn short_limbs_hold_the_products_of_areas() {
    // The corners of oriented boxes.
    let of = |x: i8| if x == 0 { 1 } else { i128::from(x) << 70 };
    for edges in vectors().map(|all| all.each(|v| v.each(of))) {
        let long = products::<Limbs4>(edges.each(|v| v.each(BigInt::from)));
        assert_eq!(products::<Limbs2>(edges.each(|v| v.each(BigInt::from))), long, "{edges:?}");
    }
}

/// Where loops are in vectors, too.
#[test]
fn numbers_side_by_side_are_those_of_each() {
    fn check<const K: usize>(random: &mut Random) {
        for n in 0..1_000 {
            let mut number = |_| {
                let bits = random.bits();
                let size = (bits >> (12 + n % 40)) as f64 / 64.0;
                if bits & 1 == 1 { size } else { -size }
            };
            let points = [(); K].map(|()| [0, 1, 2].each(&mut number));
            let all = <Window as Embeds<f64>>::embed(&points).unwrap();
            let short = <Int64OfFloats as Embeds<f64>>::embed(&points);
            let low = bits(&points).low;
            for (k, p) in points.iter().enumerate() {
                for i in 0..3 {
                    let expected = p[i] * 2_f64.powi(1074 - low);
                    assert_eq!(all[k][i] as f64, expected, "{K} {k} {i}");
                    assert!(
                        short.is_none_or(|short| short[k][i] as f64 == expected),
                        "{K} {k} {i}"
                    );
                }
            }
        }
    }
    let mut random = Random(0x519);
    check::<2>(&mut random);
    check::<3>(&mut random);
    check::<4>(&mut random);
    check::<5>(&mut random);
    check::<6>(&mut random);
    check::<8>(&mut random);
}
