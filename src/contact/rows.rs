//! The directions of two boxes that may be the least, in vectors of `f32`: for hosts.
//!
//! Pairs of axes share the products of the face normals: (u_i × v_j)·u_k is v_j·(u_k × u_i). With a row
//! for the three axes of a box, no lane is gathered from several rows either. It takes six tenths of the instructions of
//! [`Ruler::overlaps`](super::filter::Ruler::overlaps).

use super::body::Rough;
use super::directions::Apart;
use crate::arithmetic::{
    Each, Float, OfFour, Quad, THREE, cross3, dot3, greatest, least, three, two,
};

type Row = <f32 as OfFour>::Quad;

/// Roundoffs in an overlap, per M²·R: the greatest coordinate of an axis, and the size.
const ROUNDOFFS: u16 = 512;

/// Roundoffs in the square of a direction, per M⁴.
const OF_SQUARE: u16 = 256;

/// The relative error of a square that is above [`NOISE`]·M⁴.
const MOST_SPREAD: f32 = 1.0 / 256.0;
const NOISE: f32 = 1.0 / (1 << 20) as f32;

/// The ranges of M, and of M·R.
const AXES: (f32, f32) = (1.0 / 512.0, 512.0);
const SIZES: (f32, f32) = (1.0 / (1 << 20) as f32, (1 << 20) as f32);

/// x, y and z of three vectors.
type Vectors = [Row; 3];

/// One vector three times.
#[inline(always)]
fn same(x: [f32; 3]) -> Vectors {
    x.each(Row::splat)
}

/// Vector n of three, three times.
#[inline(always)]
fn only(x: &Vectors, n: usize) -> Vectors {
    x.each(|x| Row::splat(x.to_array()[n]))
}

/// The face normals of a box with these axes: u_1 × u_2 first.
#[inline(always)]
fn normals(axes: &Vectors) -> Vectors {
    let next = axes.each(Quad::turned);
    cross3(&next, &next.each(Quad::turned))
}

/// The greatest of the first three lanes.
#[inline(always)]
fn most(x: Row) -> f32 {
    let next = x.turned();
    x.greatest(next).greatest(next.turned()).to_array()[0]
}

/// A search among directions, in groups of three.
struct Search {
    d: Vectors,
    error: Row,
    /// [`OF_SQUARE`], and the least square that is known.
    of_square: Row,
    noise: Row,
    /// Bounds on the lesser overlap along each direction, as squares of true lengths.
    lows: [Row; 5],
    bound: Row,
    /// The directions along which nothing is known, as bits, and those certain to separate the boxes.
    unknown: u16,
    apart: u16,
    /// How far the centres are apart along each.
    ways: [Row; 5],
}

impl Search {
    /// Takes three directions, and how far both boxes reach along them.
    #[inline(always)]
    fn take(&mut self, group: usize, directions: &Vectors, reach: Row) {
        let bits = |lanes: u32| (lanes & THREE) as u16;
        let (zero, one, error) = (Row::splat(0.0), Row::splat(1.0), self.error);
        let way = dot3(directions, &self.d);
        let overlap = reach - way.magnitude();
        let square = dot3(directions, directions);
        let inverse = one / square;
        let spread = (self.of_square * inverse).least(Row::splat(MOST_SPREAD));
        let (low, high) = ((overlap - error).greatest(zero), overlap + error);
        self.lows[group % 5] = low * low * ((one - spread) * inverse);
        let mut most = high * high * ((one + Row::splat(3.0) * spread) * inverse);
        let unknown = bits(!self.noise.is_at_most(square));
        if unknown != 0 {
            let most_of = most.to_array();
            let known = |n: usize| if unknown >> n & 1 == 0 { most_of[n] } else { f32::INFINITY };
            most = Row::of_three(three(known));
        }
        self.bound = self.bound.least(most);
        let below = zero - error;
        let at = 3 * group;
        self.unknown |= unknown << at;
        self.apart |= bits(below.exceeds(overlap)) << at;
        self.ways[group % 5] = way;
    }
}

/// The translations of two boxes that may be the least, of the directions in `needed`, against them and
/// along them. Out of range it leaves them all.
///
/// # The error
///
/// u is the unit roundoff, M the greatest coordinate of an axis, and R the greater of d and M·h: of a
/// coordinate of the way between the centres, and of a half-extent. Each number has a rounding, and one of
/// `f64` before.
///
/// * A coordinate of a direction a errs by 8·u·M²: 3·u·M² in each product, and 2·u·M² in their difference.
/// * The overlap is a·d and four terms h·|a·s|, for a half-extent and an axis. `rows.g` proves that it errs by
///   at most [`ROUNDOFFS`] times u·M²·R, underflow included, and a·d by less.
/// * The square of a errs by 2·√3·6.1·u·M²·|a| + 5·u·a², and with |a| ≤ 2·√3·M² by at most 134·u·M⁴. The
///   rest of [`OF_SQUARE`], 10·u·a² or more as a² is at most 12·M⁴, covers the 5 roundings of the bounds. If a² is above
///   [`NOISE`]·M⁴, the relative error is below (21.2·2^10 + 5)·u = 2^-9.6.
/// * The ranges of M and M·R keep a² and the squares of overlaps with their errors between 2^-100 and
///   2^100, and their quotients too.
#[inline(always)]
pub(super) fn wanted(needed: u16, shapes: &[Rough; 2]) -> Result<[u16; 2], Apart> {
    let [u, v] = two(|n| three(|i| Row::of_three(three(|k| shapes[n].sides[k][i] as f32))));
    let [h, k] = two(|n| shapes[n].half.each(|x| x as f32));
    let d = shapes[0].at[0].each(|x| x as f32);
    let axes = u.iter().chain(&v).fold(Row::splat(0.0), |most, x| most.greatest(x.magnitude()));
    let (axes, half) = (most(axes), most(Row::of_three(h).greatest(Row::of_three(k))));
    let size = greatest(axes * half, most(Row::of_three(d).magnitude()));
    let is_within = |x: f32, (low, high): (f32, f32)| (x > low) & (x < high);
    if !(is_within(axes, AXES) & is_within(axes * size, SIZES)) {
        return Ok([needed; 2]);
    }
    let area = axes * axes;
    let mut search = Search {
        d: same(d),
        error: Row::splat(f32::from(ROUNDOFFS) * f32::ROUNDOFF * (area * size)),
        of_square: Row::splat(f32::from(OF_SQUARE) * f32::ROUNDOFF * (area * area)),
        noise: Row::splat(NOISE * (area * area)),
        lows: [Row::splat(0.0); 5],
        bound: Row::splat(f32::INFINITY),
        unknown: 0,
        apart: 0,
        ways: [Row::splat(0.0); 5],
    };
    let (m, n) = (normals(&u), normals(&v));
    // Rows of products: of normals with the axes of the other box.
    let of_second = three(|i| dot3(&only(&m, i), &v).magnitude());
    let of_first = three(|i| dot3(&only(&u, i), &n).magnitude());
    let [a, b, c] = of_second.each(Quad::to_array);
    let columns = three(|j| Row::of_three([a[j], b[j], c[j]]));
    let times = |x: f32, row: Row| Row::splat(x) * row;
    let reach = Row::of_three(h) * dot3(&m, &u).magnitude()
        + (times(k[0], columns[0]) + times(k[1], columns[1]) + times(k[2], columns[2]));
    search.take(0, &m, reach);
    let reach = Row::of_three(k) * dot3(&n, &v).magnitude()
        + (times(h[0], of_first[0]) + times(h[1], of_first[1]) + times(h[2], of_first[2]));
    search.take(1, &n, reach);
    let next = Row::of_three(k).turned();
    for i in 0..3 {
        let (j, l) = ((i + 1) % 3, (i + 2) % 3);
        let own = of_first[i].turned();
        let reach = (times(h[j], of_second[l]) + times(h[l], of_second[j]))
            + (next * own.turned() + next.turned() * own);
        search.take(2 + i, &cross3(&only(&u, i), &v), reach);
    }
    let Search { lows, ways, bound, unknown, apart, .. } = search;
    if apart & !unknown != 0 {
        return Err(Apart);
    }
    let [x, y, z] = bound.three();
    let bound = Row::splat(least(x, least(y, z)));
    let is_least = |group: usize| ((lows[group].is_at_most(bound) & THREE) as u16) << (3 * group);
    let left = needed & (0..5).fold(unknown, |left, group| left | is_least(group));
    // One direction has one lesser overlap, if the centres are clearly apart along it.
    let n = left.trailing_zeros() as usize % 15;
    let (way, error) = (ways[n / 3].to_array()[n % 3], search.error.to_array()[0]);
    let is_single = left.is_power_of_two() && left & unknown == 0;
    Ok([way > error, way < -error].each(|is_not| if is_single && is_not { 0 } else { left }))
}
