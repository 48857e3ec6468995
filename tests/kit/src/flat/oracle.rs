//! The oracle. It clips, where the crate computes signs of volumes.
//!
//! A triangle is the intersection of half-spaces: both sides of its plane, and one for each edge. A
//! segment is the intersection of both sides of its line in three directions, and one half-space
//! for each end. The oracle clips the other shape by these, in barycentric coordinates: see
//! `crate::oracle`. The interiors meet if no barycentric coordinate and no half-space of an edge or
//! end is zero at all corners of the result; then the mean of the corners is inside both shapes.

use dashu_int::IBig;
use septum::relation::Relation;

use crate::exact::{Parts, least_exponent, whole};
use crate::oracle::{clip, uncut};
use crate::{Each, lattice::Ring, three};

use super::{Flat, axes};

/// The relation of two shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Truth {
    Apart,
    /// They have points in common, but their relative interiors are disjoint.
    Touching,
    Overlapping,
}

impl Truth {
    /// The crate's name for it.
    pub fn relation(self) -> Relation {
        match self {
            Self::Apart => Relation::Disjoint,
            Self::Touching => Relation::Touching,
            Self::Overlapping => Relation::Overlapping,
        }
    }
}

/// Three points, which may coincide.
pub(super) type Corners<I> = [[I; 3]; 3];

/// All x with normal·(x − point) ≥ 0.
struct HalfSpace<I> {
    normal: [I; 3],
    point: [I; 3],
    /// Whether its boundary bounds the shape within the shape's plane or line.
    is_edge: bool,
}

/// With coordinates of at most this many bits the results fit in 128 bits: differences have one
/// more, normals are below 2^(2b+3), normals of edges below 2^(3b+5), values of a form below
/// 2^(4b+7.6), corners below 2^(8b+16.2), and the value of a form at a corner below 2^(12b+25.4).
const NARROW: u32 = 8;

pub(super) fn truth(flat: Flat<Parts>, triangle: [[Parts; 3]; 3]) -> Truth {
    let rows = match flat {
        Flat::Triangle(t) => t,
        Flat::Ends([a, b]) => [a, b, b],
        Flat::Center(c, h) => [c, h, h],
        Flat::Point(p) => [p; 3],
    };
    let all = [rows, triangle].concat();
    let unit = least_exponent(all.as_flattened());
    let number = |x: Parts| whole(x, unit);
    let mut first = rows.each(|p| p.each(number));
    if let Flat::Center(..) = flat {
        let [c, h, _] = first;
        let sum = three(|i: usize| &c[i] + &h[i]);
        first = [IBig::difference(&c, &h), sum.clone(), sum];
    }
    let second = triangle.each(|p| p.each(number));
    // From one of the points, because most are near it.
    let origin = second[0].clone();
    let from = |p: &[IBig; 3]| IBig::difference(p, &origin);
    let (first, second) = (first.each_ref().each(from), second.each_ref().each(from));
    let narrow = |p: &[IBig; 3]| -> Option<[i128; 3]> {
        let [x, y, z] = p.each_ref().each(|x| i128::try_from(x).ok());
        [x?, y?, z?].into_iter().all(|x| x.unsigned_abs() >> NARROW == 0).then_some([x?, y?, z?])
    };
    let all = |corners: &Corners<IBig>| -> Option<Corners<i128>> {
        let [a, b, c] = corners;
        Some([narrow(a)?, narrow(b)?, narrow(c)?])
    };
    match (all(&first), all(&second)) {
        (Some(first), Some(second)) => truth_of_whole(&first, &second),
        _ => truth_of_whole(&first, &second),
    }
}

/// The relation of two triangles in integers; for `i128` these must be below 2^8.
///
/// # Panics
/// If the other oracle, separating axes, disagrees.
pub fn truth_of_whole<I: Ring>(first: &Corners<I>, second: &Corners<I>) -> Truth {
    let truth = by_clipping(first, second);
    if let Some(are_apart) = axes::separate(first, second) {
        assert_eq!(are_apart, truth == Truth::Apart, "the oracles differ");
    }
    truth
}

fn by_clipping<I: Ring>(first: &Corners<I>, second: &Corners<I>) -> Truth {
    let spaces = half_spaces(second);
    let form = |space: &HalfSpace<I>| -> [I; 3] {
        first.each_ref().each(|p| I::dot(&space.normal, &I::difference(p, &space.point)))
    };
    let forms: Vec<[I; 3]> = spaces.iter().map(form).collect();
    // An early exit: a half-space without a vertex.
    if forms.iter().any(|form| form.iter().all(|x| x.sign() < 0)) {
        return Truth::Apart;
    }
    let mut cycle = uncut();
    for form in &forms {
        cycle = clip(&cycle, form);
        if cycle.is_empty() {
            return Truth::Apart;
        }
    }
    let is_inside = |form: &[I; 3]| cycle.iter().any(|c| I::dot(&c.point, form).sign() > 0);
    let coordinate = |k: usize| cycle.iter().any(|c| c.point[k].sign() > 0);
    let edges = spaces.iter().zip(&forms).filter(|(space, _)| space.is_edge);
    if (0..3).all(coordinate) && edges.into_iter().all(|(_, form)| is_inside(form)) {
        Truth::Overlapping
    } else {
        Truth::Touching
    }
}

fn negated<I: Ring>(v: &[I; 3]) -> [I; 3] {
    let zero = [(); 3].each(|()| I::from_bit(false));
    I::difference(&zero, v)
}

/// Both sides of a plane through `point`.
fn both<I: Ring>(normal: [I; 3], point: &[I; 3]) -> [HalfSpace<I>; 2] {
    [negated(&normal), normal].each(|normal| HalfSpace {
        normal,
        point: point.clone(),
        is_edge: false,
    })
}

fn half_spaces<I: Ring>(corners: &Corners<I>) -> Vec<HalfSpace<I>> {
    let is_zero = |v: &[I; 3]| v.iter().all(|x| x.sign() == 0);
    let unit = |k: usize| core::array::from_fn(|i| I::from_bit(i == k));
    let edges = three(|k: usize| I::difference(&corners[(k + 1) % 3], &corners[k]));
    let normal = I::cross(&edges[0], &edges[1]);
    if !is_zero(&normal) {
        let mut spaces: Vec<_> = both(normal.clone(), &corners[0]).into();
        spaces.extend((0..3).map(|k| HalfSpace {
            normal: I::cross(&normal, &edges[k]),
            point: corners[k].clone(),
            is_edge: true,
        }));
        return spaces;
    }
    // The longest edge.
    let length = |k: usize| I::dot(&edges[k], &edges[k]);
    let longest = (1..3)
        .fold(0, |k, other| if length(other).minus(&length(k)).sign() > 0 { other } else { k });
    let (a, b, d) = (&corners[longest], &corners[(longest + 1) % 3], &edges[longest]);
    if is_zero(d) {
        return (0..3).flat_map(|k| both(unit(k), a)).collect();
    }
    let mut spaces: Vec<_> = (0..3).flat_map(|k| both(I::cross(d, &unit(k)), a)).collect();
    let end = |normal, point: &[I; 3]| HalfSpace { normal, point: point.clone(), is_edge: true };
    spaces.extend([end(d.clone(), a), end(negated(d), b)]);
    spaces
}
