//! The first look at two boxes with orthonormal axes, in vectors of `f32` for every scalar: one box in
//! the frame of the other (Gottschalk, Lin and Manocha, 1996). Face normals are then coordinate axes,
//! and each product has an axis of one box and an axis of the other: half as many operations as in the
//! kernel of `rows.rs`. The distance of the axes from orthonormal is measured, and part of the error
//! bound. `rows.rs` decides skewed boxes, and short fixed point, whose axes are too coarse.
//!
//! A pair of axes that are nearly parallel is decided by four others (see `kernel.rs`).

use super::error_bound::in_frames as error_bound;
use super::{First, Lie};
use crate::arithmetic::{Each, Float, InFloat, OfFour, Quad, SMALL_CODE, THREE, three};
use crate::query::obb_rows::holds_one;
use crate::query::relation::{Asked, Relation};
use crate::scalar::Scalar;
use crate::shape::{Aabb, Obb};

/// Four numbers of this stage, in every scalar.
type Row = <f32 as OfFour>::Quad;

/// The second box in the frame of the first.
struct Frames {
    /// R: a row for each axis of the first box, with its products with the axes of the second.
    rows: [Row; 3],
    /// The same, a row for each axis of the second.
    columns: [Row; 3],
    /// The products of the axes with the difference of the centres.
    on_first: Row,
    on_second: Row,
    /// How far products of two axes of one box are from zero or one, in each of three lanes; of two boxes the
    /// greatest, and the sum of the squares.
    tilt: Tilt,
}

/// The squares of three vectors, which are never NaN, and how far their dot products are from zero or one.
struct Tilt {
    squares: Row,
    most: Row,
}

/// No relation is certain.
pub(super) struct InDoubt;

/// The relation of two boxes, or doubt; `None` if this kernel does not apply.
#[inline(always)]
pub(super) fn relation<S: Scalar + InFloat<F>, F: Float>(
    question: &Lie<'_, S>,
) -> Option<Result<Relation, InDoubt>> {
    let Lie { first, second, asked } = *question;
    // `f32` asks again in `f64`. `may_overlap` must not decide more here than on other machines.
    let is_first = size_of::<F>() == size_of::<S::SeptumFirst>();
    let is_fine = <S as InFloat<F>>::PLACE * F::from(1 << 11) <= F::from(1);
    // So must the type itself: axes are counted in units of its one.
    let is_held = holds_one::<S, F>() && S::plain_one().in_double() == 1.0;
    let applies = Row::IS_VECTOR && !SMALL_CODE && is_first && is_fine && is_held;
    if !applies || asked == Asked::MayOverlap {
        return None;
    }
    match first {
        First::Obb(first) => two(first, second),
        First::Aabb(first) => upright(first, second),
    }
}

#[inline(never)]
fn two<S: Scalar>(first: &Obb<S>, second: &Obb<S>) -> Option<Result<Relation, InDoubt>> {
    let ([u0, u1, u2], [v0, v1, v2]) = (first.axes_as_arrays(), second.axes_as_arrays());
    let (a, h) = (first.center().to_array(), first.half_extents().to_array());
    let (b, k) = (second.center().to_array(), second.half_extents().to_array());
    let lengths = [u0, u1, u2, v0, v1, v2, h, k];
    if is_skewed(v0, v1) || !(S::have_offsets(&[a, b]) && S::have_offsets_to_zero(&lengths)) {
        return None;
    }
    let d = three(|i| b[i].offset(a[i]));
    let [u, v] = [[u0, u1, u2].each(in_units), [v0, v1, v2].each(in_units)];
    Frames::of_two(u, v, d).relation(d, plain(h), plain(k))
}

#[inline(never)]
fn upright<S: Scalar>(first: &Aabb<S>, second: &Obb<S>) -> Option<Result<Relation, InDoubt>> {
    let [b, v0, v1, v2, k] = second.numbers();
    let (p, q, is_by_center) = first.numbers();
    let lengths = [v0, v1, v2, k];
    if is_skewed(v0, v1) || !(S::have_offsets(&[b, p, q]) && S::have_offsets_to_zero(&lengths)) {
        return None;
    }
    let (d, h) = if is_by_center {
        (three(|i| b[i].offset(p[i])), plain(q))
    } else {
        let d = three(|i| b[i].offset_of_two(p[i], q[i]) * 0.5);
        // Two infinities may add up to NaN, which the greatest of lanes may miss.
        if Row::of_three(d).is_at_most(Row::of_three(d)) & THREE != THREE {
            return None;
        }
        (d, three(|i| q[i].offset(p[i]) * 0.5))
    };
    Frames::of_second([v0, v1, v2].each(in_units), d).relation(d, h, plain(k))
}

/// Whether two axes of a box are clearly not at right angles, which rejects most skewed boxes early.
/// No answer depends on it.
#[inline(always)]
fn is_skewed<S: Scalar>(u: [S; 3], v: [S; 3]) -> bool {
    let ([a, b, c], [x, y, z], one) = (plain(u), plain(v), S::plain_one().offset(S::ZERO));
    (a * x + b * y + c * z).abs() >= one * one * (1.0 / 64.0)
}

#[inline(always)]
fn plain<S: Scalar>(x: [S; 3]) -> [f32; 3] {
    x.each(|x| x.offset(S::ZERO))
}

/// A vector in units of one.
#[inline(always)]
fn in_units<S: Scalar>(x: [S; 3]) -> [f32; 3] {
    let one = S::plain_one().offset(S::ZERO);
    plain(x).each(|x| x * (1.0 / one))
}

#[inline(always)]
fn sum(times: [f32; 3], [a, b, c]: [Row; 3]) -> Row {
    Row::splat(times[0]) * a + Row::splat(times[1]) * b + Row::splat(times[2]) * c
}

/// x, y and z of three vectors and of a fourth.
#[inline(always)]
fn transposed([a, b, c]: [[f32; 3]; 3], d: [f32; 3]) -> [Row; 3] {
    three(|i| Row::new([a[i], b[i], c[i], d[i]]))
}

/// The rows are x, y and z of all three vectors.
#[inline(always)]
fn tilt(rows: [Row; 3]) -> Tilt {
    let squares = rows[0] * rows[0] + rows[1] * rows[1] + rows[2] * rows[2];
    let [x, y, z] = rows.each(|row| row * row.turned());
    let most = (squares - Row::splat(1.0)).magnitude().greatest((x + y + z).magnitude());
    Tilt { squares, most }
}

/// The greatest of three lanes, in each of them.
#[inline(always)]
fn most(x: Row) -> Row {
    let next = x.turned();
    x.greatest(next).greatest(next.turned())
}

impl Frames {
    #[inline(always)]
    fn of_two(u: [[f32; 3]; 3], v: [[f32; 3]; 3], d: [f32; 3]) -> Self {
        let side_by_side = transposed(v, d);
        let rows: [Row; 3] =
            [sum(u[0], side_by_side), sum(u[1], side_by_side), sum(u[2], side_by_side)];
        let [r0, r1, r2] = [rows[0].to_array(), rows[1].to_array(), rows[2].to_array()];
        let column = |j: usize| Row::new([r0[j], r1[j], r2[j], r2[j]]);
        let (p, q) = (tilt(side_by_side), tilt(transposed(u, u[2])));
        Self {
            rows,
            columns: [column(0), column(1), column(2)],
            on_first: column(3),
            on_second: sum(d, side_by_side),
            tilt: Tilt { squares: p.squares + q.squares, most: p.most.greatest(q.most) },
        }
    }

    #[inline(always)]
    fn of_second(v: [[f32; 3]; 3], d: [f32; 3]) -> Self {
        let rows = transposed(v, d);
        let [v0, v1, v2] = v;
        Self {
            rows,
            columns: [Row::of_three(v0), Row::of_three(v1), Row::of_three(v2)],
            on_first: Row::of_three(d),
            on_second: sum(d, rows),
            tilt: tilt(rows),
        }
    }

    /// The relation or doubt, given the difference of the centres and the half-extents; `None` if
    /// they, or the tilt, are out of range.
    #[inline(always)]
    fn relation(&self, d: [f32; 3], h: [f32; 3], k: [f32; 3]) -> Option<Result<Relation, InDoubt>> {
        let Self { rows, columns, on_first: t, on_second, tilt } = self;
        let three = |x: [f32; 3]| Row::of_three(x);
        let size = most(three(d).magnitude().greatest(three(h)).greatest(three(k)));
        // Numbers of long axes may be NaN, which the greatest of lanes may miss.
        let are_short = tilt.squares.is_at_most(Row::splat(4.0)) & THREE == THREE;
        let error = error_bound(size, most(tilt.most), are_short)?;
        let (r, c) = (rows.each(Row::magnitude), columns.each(Row::magnitude));

        let of_first = t.magnitude() - (three(h) + sum(k, c));
        let of_second = on_second.magnitude() - (three(k) + sum(h, r));
        let faces = of_first.greatest(of_second);
        if faces.exceeds(error) & THREE != 0 {
            return Some(Ok(Relation::Disjoint));
        }

        let (next, last) = (three(k).turned(), three(k).turned().turned());
        let on = t.three();
        // The products of axis i of the first with all of the second, and those of axes l and m.
        let pair = |i: usize, l: usize, m: usize| {
            let distance = Row::splat(on[m]) * rows[l] - Row::splat(on[l]) * rows[m];
            let of_first = Row::splat(h[l]) * r[m] + Row::splat(h[m]) * r[l];
            let of_second = next * r[i].turned().turned() + last * r[i].turned();
            distance.magnitude() - (of_first + of_second)
        };
        let pairs = [pair(0, 1, 2), pair(1, 2, 0), pair(2, 0, 1)];
        let edges = pairs[0].greatest(pairs[1]).greatest(pairs[2]);
        let below = Row::splat(0.0) - error;
        let is_disjoint = edges.exceeds(error) & THREE != 0;
        let is_clear = below.exceeds(faces.greatest(edges)) & THREE == THREE;
        // One branch, on doubt.
        Some(if is_disjoint | is_clear {
            Ok(if is_disjoint { Relation::Disjoint } else { Relation::Overlapping })
        } else {
            beside_near_axes(faces, pairs, r, size, error)
        })
    }
}

/// Overlapping, if all axes are clear except cross products of nearly parallel axes.
///
/// u_i and v_j are nearly parallel if their products with the other axes are at most 2^-10: then
/// flattening the second box by k_j = 0 moves the gaps on the four deciding axes by at most 2^-10 of
/// the size, and their margin of 2^-9 also covers rounding. None of the four is left out itself: a
/// row, and a column, has one product near 1.
#[cold]
#[inline(never)]
fn beside_near_axes(
    faces: Row,
    pairs: [Row; 3],
    products: [Row; 3],
    size: Row,
    error: Row,
) -> Result<Relation, InDoubt> {
    let below = Row::splat(0.0) - (error + size * Row::splat(1.0 / 512.0));
    let limit = Row::splat(1.0 / 1024.0);
    let small = products.each(|row| limit.exceeds(row) & THREE);
    let is_settled = |i: usize| {
        let others_in_row = (small[i] >> 1 | small[i] << 2) & (small[i] >> 2 | small[i] << 1);
        let near = others_in_row & small[(i + 1) % 3] & small[(i + 2) % 3];
        !below.exceeds(pairs[i]) & THREE & !near == 0
    };
    let are_clear = below.exceeds(faces) & THREE == THREE && (0..3).all(is_settled);
    if are_clear { Ok(Relation::Overlapping) } else { Err(InDoubt) }
}

#[cfg(all(test, not(feature = "small")))]
mod tests {
    use super::*;
    use crate::query::obb_rows::tests::Numbers;
    use crate::random::Random;
    use crate::robust::Predicate;

    /// The frame of a quaternion, rounded.
    fn turned(numbers: &mut Numbers, tilt: f64) -> [[f64; 3]; 3] {
        let [x, y, z] = numbers.point().map(|x| f64::from(x) * tilt);
        let s = 2.0 / (1.0 + x * x + y * y + z * z);
        [
            [1.0 - s * (y * y + z * z), s * (x * y + z), s * (x * z - y)],
            [s * (x * y - z), 1.0 - s * (x * x + z * z), s * (y * z + x)],
            [s * (x * z + y), s * (y * z - x), 1.0 - s * (x * x + y * y)],
        ]
    }

    /// Boxes of about this size are moved into contact by bisection, and then by steps of up to 4 %. Counts
    /// doubts, and boxes that are disjoint and that overlap.
    fn check<S: Scalar>(near: impl Fn(f64) -> S, size: f64) -> [usize; 3] {
        let mut numbers = Numbers(17);
        let mut counts = [0; 3];
        for n in 0..128_i32 {
            let tilt = [1.0, 1e-3, 1e-7, 1e-12, 1e-15, 6.1e-17, 1e-30, 0.0][n as usize % 8];
            let mut obb = |at: f64| {
                let axes = turned(&mut numbers, tilt).map(|u| u.map(&near));
                let half = numbers.point().map(|x| near((f64::from(x).abs() + 0.1) * size));
                let center = numbers.point().map(|x| near(f64::from(x) * at * size));
                Obb::from_skewed_axes(center, axes, half).unwrap()
            };
            let (a, b) = (obb(0.5), obb(0.5));
            let way = numbers.point().map(f64::from);
            let moved = |by: f64| {
                let to = three(|i| near(way[i] * by * size));
                Obb::from_skewed_axes(to, *b.axes(), b.half_extents()).unwrap()
            };
            let meet = |by: f64| {
                let question =
                    Lie { first: First::Obb(&a), second: &moved(by), asked: Asked::Relation };
                question.exact()
            };
            let (mut low, mut high) = (0.0, 1_000.0);
            for _ in 0..40 {
                let middle = (low + high) / 2.0;
                if meet(middle) == Relation::Disjoint { high = middle } else { low = middle }
            }
            for step in -20..=20 {
                let b = moved(low * (1.0 + f64::from(step * step * step) * 5e-6));
                let question = Lie { first: First::Obb(&a), second: &b, asked: Asked::Relation };
                match two(&a, &b) {
                    None | Some(Err(InDoubt)) => counts[0] += 1,
                    Some(Ok(found)) => {
                        assert_eq!(found, question.exact(), "{a:?} {b:?}");
                        counts[1 + usize::from(found == Relation::Overlapping)] += 1;
                    }
                }
            }
        }
        counts
    }

    #[test]
    fn frames_say_what_is_exact() {
        let all_occur = |counts: [usize; 3], least: usize| {
            assert!(counts.iter().all(|&n| n > least), "{counts:?}");
        };
        all_occur(check(|x| x as f32, 1.0), 300);
        all_occur(check(|x| x, 1.0), 300);
        #[cfg(feature = "fixed")]
        {
            use fixed::types::{I16F16, I32F32};
            all_occur(check(I16F16::saturating_from_num::<f64>, 1.0), 300);
            all_occur(check(I32F32::saturating_from_num::<f64>, 1.0), 300);
            // Half-extents beyond the limit of offsets, which 32 bits ask of centres alone.
            all_occur(check(I16F16::saturating_from_num::<f64>, 20_000.0), 20);
            let beyond = check(I32F32::saturating_from_num::<f64>, 500_000.0);
            assert_eq!(beyond[1..], [0, 0]);
        }
    }

    /// The greatest number of these types is not one: I0F16 ends at a half.
    #[cfg(feature = "fixed")]
    #[test]
    fn types_without_one_have_no_frames() {
        use fixed::FixedI16;
        use fixed::types::extra::{LeEqU16, U15, U16};
        fn meet<Frac: LeEqU16>(
            [center, other]: [[i16; 3]; 2],
            axes: [[[i16; 3]; 3]; 2],
            half: [[i16; 3]; 2],
        ) -> bool
        where
            FixedI16<Frac>: Scalar,
        {
            let of = |x: [i16; 3]| x.each(FixedI16::<Frac>::from_bits);
            let boxed = |center: [i16; 3], k: usize| {
                Obb::from_skewed_axes(of(center), axes[k].each(of), of(half[k])).unwrap()
            };
            boxed(center, 0).overlaps(&boxed(other, 1))
        }
        // Half as long as their numbers say, and apart by 5,000 last places.
        let upright = [[32_767, 0, 0], [0, 32_767, 0], [0, 0, 32_767]];
        let places = [[0; 3], [25_000, 0, 0]];
        assert!(!meet::<U16>(places, [upright; 2], [[20_000; 3]; 2]));
        // Apart by a quarter of the last place.
        let axes = [
            [[14_798, 19_026, 22_197], [-28_539, 14_798, 6_342], [-6_342, -22_197, 23_254]],
            [[9_362, 14_043, 28_086], [14_043, -28_086, 9_362], [28_086, 9_362, -14_043]],
        ];
        let half = [[25_577, 28_965, 28_965], [18_117, 17_364, 17_737]];
        assert!(!meet::<U15>([[0; 3], [28_965; 3]], axes, half));
    }

    /// Products of long axes are infinite or NaN, while the first box has a frame: this kernel leaves them to
    /// the others.
    #[test]
    fn long_axes_are_not_taken_for_a_frame() {
        let mut random = Random(0x10f6);
        let upright = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let mut asked = 0;
        for _ in 0..4_000 {
            let mut long =
                || [0.0, 0.5, 1.0, 1e20, -1e20, 1e30, -5e29, 1e39][random.below(8) as usize];
            let axes = [(); 3].map(|()| [(); 3].map(|()| long()));
            let mut short = || random.below(7) as f64 - 3.0;
            let [center, half, k] = [(); 3].map(|()| [(); 3].map(|()| short()));
            let first = Obb::new([0.0; 3], upright, half.each(f64::abs)).unwrap();
            let Ok(second) = Obb::from_skewed_axes(center, axes, k.each(f64::abs)) else {
                continue;
            };
            if let Some(Ok(found)) = two(&first, &second) {
                let question =
                    Lie { first: First::Obb(&first), second: &second, asked: Asked::Relation };
                assert_eq!(found, question.exact(), "{first:?} {second:?}");
            }
            asked += 1;
        }
        assert!(asked > 2_000, "{asked}");
        // Of `f32`, as they came.
        let first = Obb::new([0.0_f32; 3], upright.map(|u| u.map(|x| x as f32)), [3.0, 0.0, 0.0]);
        let long = [[-1e20, 1e20, 1e20], [-1e20, 0.0, -1e30], [-1e20, -1e20, 1e20]];
        let second = Obb::from_skewed_axes([-1.0, 2.0, 0.0], long, [1.0, 0.5, 1.0]);
        assert!(first.unwrap().overlaps(&second.unwrap()));
    }
}
