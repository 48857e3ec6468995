//! Triangles, segments and points against triangles: exact.

use septum::Triangle;
use septum_kit::flat::{Flat, FlatCase, FlatSet, Truth, every_pair_on_the_grid};
use septum_kit::{Each, Rng, Sample, VERTEX_ORDERS, for_every_scalar, with_every_scalar};

/// The number of cases of each set.
const CASES: usize = 1_500;

/// All sets; counts the disjoint, touching and overlapping cases of each.
fn agrees_with_the_oracle<S: Sample>() {
    for set in FlatSet::ALL {
        let mut rng = Rng::new(0xf1a7);
        let mut seen = [0; 3];
        for _ in 0..CASES {
            seen[set.case::<S>(&mut rng).check() as usize] += 1;
        }
        // These sets aim at contact.
        if matches!(set, FlatSet::Grid | FlatSet::Plane | FlatSet::Touch) {
            assert!(seen.iter().all(|&n| n > CASES / 100), "{set:?}: {seen:?}");
        }
    }
}
for_every_scalar!(agrees_with_the_oracle);

/// A hundred times as many cases: `cargo test --release --test promises flat_shapes -- --ignored`.
#[test]
#[ignore = "takes minutes"]
fn agrees_with_the_oracle_on_many() {
    fn many<S: Sample>() {
        for set in FlatSet::ALL {
            let mut rng = Rng::new(0x3a2);
            let mut seen = [0; 3];
            for _ in 0..200_000 {
                seen[set.case::<S>(&mut rng).check() as usize] += 1;
            }
            println!("{:8} {set:?}: {seen:?}", S::name());
        }
    }
    with_every_scalar!(many);
}

mod every_pair_on_a_grid {
    use super::*;

    /// Triangles, segments and points. By symmetry 136 of 3,654 suffice on one side.
    #[test]
    fn f32() {
        println!("{:?}", every_pair_on_the_grid::<f32>(false));
    }

    #[test]
    fn i8f8() {
        println!("{:?}", every_pair_on_the_grid::<septum_kit::fixed::types::I8F8>(false));
    }

    /// In all orders of vertices and triangles.
    #[test]
    #[ignore = "takes minutes"]
    fn in_all_orders() {
        println!("{:?}", every_pair_on_the_grid::<f32>(true));
        println!("{:?}", every_pair_on_the_grid::<f64>(true));
        println!("{:?}", every_pair_on_the_grid::<septum_kit::fixed::types::I8F8>(true));
        println!("{:?}", every_pair_on_the_grid::<septum_kit::fixed::types::I32F32>(true));
    }
}

/// With vertices in any order, and with the triangles exchanged.
fn orders_do_not_matter<S: Sample>() {
    let mut rng = Rng::new(0x0def);
    for n in 0..300 {
        let set = [FlatSet::Touch, FlatSet::Plane, FlatSet::Grid][n % 3];
        let case = set.case::<S>(&mut rng);
        let Flat::Triangle(other) = case.flat else { continue };
        let shape = |p: &[[S; 3]; 3], order: [usize; 3]| {
            let [a, b, c] = order.each(|k| p[k]);
            Triangle::new(a, b, c).unwrap()
        };
        let expected = case.truth() != Truth::Apart;
        for i in VERTEX_ORDERS {
            for k in VERTEX_ORDERS {
                let (t, u) = (shape(&case.triangle, i), shape(&other, k));
                assert_eq!(t.overlaps(&u), expected, "{t:?} {u:?}");
                assert_eq!(u.overlaps(&t), expected, "{u:?} {t:?}");
            }
        }
    }
}
for_every_scalar!(orders_do_not_matter);

#[test]
fn a_point_that_is_not_finite_is_in_no_triangle() {
    let t = Triangle::new([-9.0_f32, -9.0, 0.0], [9.0, -9.0, 0.0], [0.0, 9.0, 0.0]).unwrap();
    assert!(t.contains([0.0; 3]) && t.contains([-0.0; 3]));
    for x in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        assert!(!t.contains([x, 0.0, 0.0]) && !t.contains([0.0, x, 0.0]));
        assert!(!t.contains([0.0, 0.0, x]));
    }
}

/// The oracle on cases with obvious answers.
#[test]
fn the_oracle_knows_what_is_plain() {
    let triangle = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    for (flat, expected) in [
        (Flat::Point([1.0, 1.0, 0.0]), Truth::Overlapping),
        (Flat::Point([2.0, 2.0, 0.0]), Truth::Touching),
        (Flat::Point([2.0, 2.0000000000000004, 0.0]), Truth::Apart),
        (Flat::Point([1.0, 1.0, 5e-324]), Truth::Apart),
        (Flat::Ends([[1.0, 1.0, -1.0], [1.0, 1.0, 1.0]]), Truth::Overlapping),
        (Flat::Ends([[1.0, 1.0, 0.0], [1.0, 1.0, 1.0]]), Truth::Touching),
        (Flat::Ends([[1.0, 1.0, 0.0], [9.0, 9.0, 0.0]]), Truth::Overlapping),
        (Flat::Ends([[0.0, -1.0, 0.0], [0.0, 9.0, 0.0]]), Truth::Touching),
        (Flat::Center([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]), Truth::Touching),
        (Flat::Center([-1.0, -1.0, 0.0], [2.0, 2.0, 0.0]), Truth::Overlapping),
        (Flat::Triangle(triangle), Truth::Overlapping),
        (Flat::Triangle([[1.0, 1.0, 0.0], [1.0, 1.0, 1.0], [2.0, 1.0, 1.0]]), Truth::Touching),
        (Flat::Triangle([[1.0, 1.0, -1.0], [1.0, 1.0, 1.0], [2.0, 1.0, 1.0]]), Truth::Overlapping),
        (Flat::Triangle([[4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [4.0, 4.0, 0.0]]), Truth::Touching),
        (Flat::Triangle([[4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [4.0, 4.0, 1.0]]), Truth::Touching),
        (Flat::Triangle([[9.0, 9.0, 0.0], [5.0, 9.0, 0.0], [9.0, 5.0, 0.0]]), Truth::Apart),
    ] {
        assert_eq!(FlatCase { flat, triangle }.check(), expected, "{flat:?}");
    }
}
