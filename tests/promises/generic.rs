//! Generic code sees the public items of a scalar alone: a trait of the user's own may have an item
//! of any other name.

use septum::{Aabb, Scalar};

/// Named like items that the kernels need of a scalar.
trait Mine {
    type Sum: Default + Into<u8>;
    type Span: Default + Into<u8>;
    type Anchor: Default + Into<u8>;
    type First: Default + Into<u8>;
    type Steps: Default + Into<u8>;
    type Window: Default + Into<u8>;
    type Full: Default + Into<u8>;

    const FLOAT: u8 = 1;
    const ONE: u8 = 2;
    const IN_QUADS: u8 = 3;
    const IS_FAST: u8 = 4;
    const HAS_PLACES: u8 = 5;
    const KEEPS_FRAMES: u8 = 6;
    const IS_IN_DOUBLE: u8 = 7;
    const FIRST_LIMIT: u8 = 8;

    fn parts(&self) -> u8 {
        9
    }
    fn offset(&self) -> u8 {
        10
    }
    fn span(&self) -> u8 {
        11
    }
    fn first(&self) -> u8 {
        12
    }
    fn length(&self) -> u8 {
        13
    }
    fn opposite(&self) -> u8 {
        14
    }
    fn plain_half(&self) -> u8 {
        15
    }
    fn plane() -> u8 {
        16
    }
    fn evaluate() -> u8 {
        17
    }
    fn by_turns() -> u8 {
        18
    }
    fn are_orthonormal() -> u8 {
        19
    }
}

impl Mine for f32 {
    type Sum = u8;
    type Span = u8;
    type Anchor = u8;
    type First = u8;
    type Steps = u8;
    type Window = u8;
    type Full = u8;
}

fn mine<S: Scalar + Mine>(x: S) -> Vec<u8> {
    // The crate's own questions are asked as ever.
    let point = Aabb::from_min_max([x; 3], [x; 3]).expect("a number");
    assert!(point.overlaps(&point));
    let constants = [S::FLOAT, S::ONE, S::IN_QUADS, S::IS_FAST, S::HAS_PLACES, S::KEEPS_FRAMES];
    let more = [S::IS_IN_DOUBLE, S::FIRST_LIMIT];
    let methods = [x.parts(), x.offset(), x.span(), x.first(), x.length(), x.opposite()];
    let functions =
        [x.plain_half(), S::plane(), S::evaluate(), S::by_turns(), S::are_orthonormal()];
    [&constants[..], &more, &methods, &functions].concat()
}

/// Names the associated types alone, with no path to the trait.
fn types_of_mine<S: Scalar + Mine>() -> [u8; 7] {
    [
        S::Sum::default().into(),
        S::Span::default().into(),
        S::Anchor::default().into(),
        S::First::default().into(),
        S::Steps::default().into(),
        S::Window::default().into(),
        S::Full::default().into(),
    ]
}

#[test]
fn items_of_the_back_end_are_invisible() {
    assert_eq!(mine(1.0_f32), (1..=19).collect::<Vec<u8>>());
    assert_eq!(types_of_mine::<f32>(), [0; 7]);
}
