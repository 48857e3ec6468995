//! Bounds on the overlap along each direction in half words: for cores where floats are functions, and
//! shapes whose numbers are integers of a few words. A product takes one instruction, and no sum a second word.

use core::cmp::Ordering;

use super::directions::{Apart, Axes};
use super::integers::Words;
use super::whole::Pair;
use crate::arithmetic::{Each, greatest, pick};

/// Two shapes, and their numbers rounded to half words.
pub(super) struct Cut<'a> {
    pair: &'a Pair<Words>,
    of: &'a Rounded,
}

/// The numbers of two shapes, rounded to half words: twice the places from the second shape's origin, and
/// what extends from them.
pub(super) struct Rounded {
    /// Each side over a power of two of its own, as 3·shape + k; two are none.
    sides: [[i32; 3]; 8],
    at: [[[i32; 3]; 3]; 2],
    reach: [[[i32; 3]; 3]; 2],
    /// The sum of the sizes of places and reaches.
    sum: i32,
}

/// The bits that are kept of a side and of a direction, and of a place.
const BITS: i32 = 15;
const PLACE: i32 = 14;

/// The least bits with which a cross product of rounded sides is a direction.
const LEAST: i32 = 28;

/// What rounded places and reaches add to the error of an overlap, in its unit.
///
/// An overlap is a sum of two places and at most four reaches, each with three products of a coordinate
/// of the direction and a number of at most 2^14. The coordinate is at most 2^15 in size and errs by less
/// than e and 2^-8; e is at most 9. A place errs by at most a half, and a reach by one, each and 2^-11. The
/// sum of the sizes of all numbers, at most 36·2^14, times e is counted apart. The unit is 2^3, to which
/// three products are cut: `cut.g`.
const ERROR: i32 = 61800;

/// The depths along a direction, in a unit of all directions: the least that each may be, against the
/// direction and along it, and the most that the lesser may be.
pub(super) struct Depths {
    pub(super) least: [i32; 2],
    pub(super) most: i32,
}

/// How far a depth may be off, in units of 2^-13 of itself, beside the error of the direction's coordinates.
///
/// Their greatest is at least 2^14, so e of each is √3·e/2 such units of the length. The inverse of the length
/// lacks up to two: `cut.g`.
const LACK: i32 = 2;

/// A lower bound of 2^30/√square, for a square from 2^28 to 2^32. Its relative error is below 2^-12.
///
/// The relative error of an estimate by two lines is below 2^-5. A step of Newton's method squares it, times 3/2.
/// Both steps are rounded down.
#[inline(always)]
fn inverse_root(square: u32) -> u32 {
    let is_upper = square >> 30 != 0;
    // In units of 2^-16, from 1/4 to one, and the inverse of its root in units of 2^-15.
    let x = if is_upper { square >> 16 } else { square >> 14 };
    let mut y = if x >> 15 == 1 { 0xe4d4 - ((x * 13) >> 5) } else { 0x14354 - ((x * 73) >> 6) };
    for _ in 0..2 {
        let of_one = (((y * y) >> 16) * (x + 1)) >> 16;
        y = (y * (3 * (1 << 14) - 2 - of_one)) >> 15;
    }
    if is_upper { y >> 1 } else { y }
}

/// x·y/2^16, rounded down.
#[inline(always)]
fn scaled(x: i32, y: u32) -> i32 {
    (x >> 16) * y as i32 + (((x as u32 & 0xffff) * y) >> 16) as i32
}

/// Three numbers over a power of two, which is above one where 31 bits do not hold them.
fn narrowed(v: &[i64; 3]) -> ([i32; 3], i32) {
    let is_narrow = v.iter().all(|&x| i64::from(x as i32) == x);
    let mut all = [0; 3];
    for (to, &x) in all.iter_mut().zip(v) {
        *to = if is_narrow { x as i32 } else { (x >> 4) as i32 };
    }
    (all, if is_narrow { 0 } else { 4 })
}

/// The least b so that all sizes are below 2^b; perhaps one more if 2^15 times a number is close to 2^b.
fn bits(v: &[i32; 3]) -> i32 {
    let size = v[0].unsigned_abs() | v[1].unsigned_abs() | v[2].unsigned_abs();
    32 - size.saturating_add(size >> BITS).leading_zeros() as i32
}

/// x·2^up, rounded down.
fn raised(x: i32, up: i32) -> i32 {
    if up < 0 { x >> up.unsigned_abs().min(31) } else { x << up.min(31) }
}

impl Rounded {
    pub(super) const NONE: Self =
        Self { sides: [[0; 3]; 8], at: [[[0; 3]; 3]; 2], reach: [[[0; 3]; 3]; 2], sum: 0 };

    /// In place, without a copy.
    #[inline(never)]
    fn fill(&mut self, pair: &Pair<Words>) {
        // The exponents of places and reaches.
        let (mut ups, mut of_reach) = ([[0; 3]; 2], [[0; 3]; 2]);
        let mut most = 0;
        // A box has one place.
        let has_place = |n: usize, k: usize| k == 0 || pair.are_triangles[n];
        for n in 0..2 {
            for k in 0..3 {
                if has_place(n, k) {
                    let (end, up) = narrowed(&pair.ends[n][k]);
                    (self.at[n][k], ups[n][k]) = (end, up + pair.up as i32);
                    most = greatest(most, bits(&end) + ups[n][k]);
                }
                let (side, up) = narrowed(&pair.sides[n][k]);
                // To 30 bits.
                let free = 30 - bits(&side);
                let side = side.each(|x| raised(x, free));
                self.sides[3 * n + k] = side.each(|x| (x + (1 << 14)) >> 15);
                let half = pair.halves[n][k] as u32;
                if half != 0 {
                    // To 16 bits.
                    let zeros = half.leading_zeros();
                    let half = (((half << zeros) >> 15) + 1) >> 1;
                    let reach = side.each(|x| scaled(x, half));
                    let up = up + pair.ups[n] as i32;
                    (self.reach[n][k], of_reach[n][k]) = (reach, up - free + 32 - zeros as i32);
                    most = greatest(most, bits(&reach) + of_reach[n][k]);
                }
            }
        }
        let down = most - PLACE;
        let mut round = |v: &mut [i32; 3], up: i32| {
            for x in v {
                // To the nearest.
                *x = (raised(*x, 1 + up - down) + 1) >> 1;
                self.sum += x.abs();
            }
        };
        for n in 0..2 {
            for k in 0..3 {
                if has_place(n, k) {
                    round(&mut self.at[n][k], ups[n][k]);
                }
                round(&mut self.reach[n][k], of_reach[n][k]);
            }
        }
    }
}

impl<'a> Cut<'a> {
    pub(super) fn new(pair: &'a Pair<Words>, of: &'a mut Rounded) -> Self {
        of.fill(pair);
        Self { pair, of }
    }

    /// The overlaps against a direction and along it, by all but the sides in `own`, as bits 3·shape + k.
    #[inline(always)]
    fn overlaps(&self, a: &[i32; 3], own: u32) -> [i32; 2] {
        let along = |v: &[i32; 3]| (a[0] * v[0] + a[1] * v[1] + a[2] * v[2]) >> 3;
        let are_triangles = self.pair.are_triangles;
        // A triangle has no reach, and the place of a box that is second is zero.
        let [first, second] = are_triangles.each(|is| if is { 7 } else { 0 });
        let (mut reach, without) = (0, own | first | second << 3);
        for (n, v) in self.of.reach.as_flattened().iter().enumerate() {
            if without >> n & 1 == 0 {
                reach += along(v).abs();
            }
        }
        let ends = |[p, q, r]: &[[i32; 3]; 3], is_triangle: bool| {
            let p = along(p);
            if !is_triangle {
                return [p, p];
            }
            let (q, r) = (along(q), along(r));
            [p.min(q).min(r), p.max(q).max(r)]
        };
        let [a0, a1] = ends(&self.of.at[0], are_triangles[0]);
        let [b0, b1] = if are_triangles[1] { ends(&self.of.at[1], true) } else { [0; 2] };
        [a1 - b0 + reach, b1 - a0 + reach]
    }

    pub(super) fn are_triangles(&self) -> [bool; 2] {
        self.pair.are_triangles
    }

    /// Which directions are superfluous.
    pub(super) fn axes(&self) -> Axes {
        Axes::new(self.pair.sides.each_ref(), self.pair.are_triangles, true)
    }

    /// Whether a coordinate of a direction is certainly not zero.
    pub(super) fn is_clear(&self, numbers: [u8; 2], axis: usize) -> bool {
        pick(&self.cross(numbers), axis).unsigned_abs() >> 17 != 0
    }

    /// The cross product of a direction's rounded sides. It errs by less than 2^16 and 2^5.
    fn cross(&self, numbers: [u8; 2]) -> [i32; 3] {
        let [x, y] = numbers.each(|n| &self.of.sides[usize::from(n % 8)]);
        [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]
    }

    /// The direction's leading bits, and how far they are off; `None` if it is zero.
    fn direction(&self, numbers: [u8; 2]) -> Option<([i32; 3], i32)> {
        let cross = self.cross(numbers);
        let size = cross.iter().fold(0, |all, x| all | x ^ x >> 31) as u32;
        if size >> (LEAST - 1) == 0 {
            return Some((self.pair.along(numbers).cut(BITS)?, 1));
        }
        // So that `BITS` are left. Cores may have no instruction that counts zeros; these are three bits.
        let more = (0x3333_2210_u32 >> (size >> LEAST << 2)) & 3;
        // 2^16 over that power, and one.
        let down = LEAST as u32 - BITS as u32 + more;
        Some((cross.each(|x| x >> down), (1 << (16 - down)) + 1))
    }

    /// The signs of the sides along a direction, where they are certain.
    ///
    /// With the errors that [`ERROR`] has, a product errs by less than 2^15·(e + 1/2) and 2^7 + 13; three,
    /// in units of 2^2 to which each is cut, by less than 3·2^12·(2·e + 1) and 110.
    pub(super) fn along(&self, numbers: [u8; 2]) -> [[Option<Ordering>; 3]; 2] {
        let mut along = [[None; 3]; 2];
        if let Some((a, error)) = self.direction(numbers) {
            let bound = 3 * (2 * error + 1) * (1 << 12) + 110;
            for (along, v) in along.as_flattened_mut().iter_mut().zip(&self.of.sides) {
                let sum = ((a[0] * v[0]) >> 2) + ((a[1] * v[1]) >> 2) + ((a[2] * v[2]) >> 2);
                *along = (sum.abs() > bound).then(|| sum.cmp(&0));
            }
        }
        along
    }

    /// The depths along a direction; `None` if it is zero, or if they are certainly above `bound`.
    ///
    /// A coordinate of the direction is at most 2^15, and the greatest at least 2^14. So its length is below
    /// four times that, and a depth, the overlap times 2^14 over the length, above a fourth of the overlap.
    #[inline(always)]
    pub(super) fn depths(&self, numbers: [u8; 2], bound: i32) -> Result<Option<Depths>, Apart> {
        let Some((a, error)) = self.direction(numbers) else { return Ok(None) };
        let overlaps = self.overlaps(&a, 1 << numbers[0] | 1 << numbers[1]);
        let lesser = overlaps[0].min(overlaps[1]);
        let of_overlap = ((self.of.sum * error) >> 3) + ERROR;
        if lesser < -of_overlap {
            return Err(Apart);
        }
        if (lesser - of_overlap) >> 2 > bound {
            return Ok(None);
        }
        let inverse = inverse_root(a.iter().map(|x| x.unsigned_abs().pow(2)).sum());
        let of_depth = |depth: i32| (depth >> 13) * (error + LACK) + error + LACK;
        let least = overlaps.each(|overlap| {
            let depth = scaled(overlap - of_overlap, inverse);
            depth - of_depth(depth)
        });
        let most = scaled(lesser + of_overlap, inverse) + 1;
        Ok(Some(Depths { least, most: most + of_depth(most) }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of all squares: a root depends on the leading 16 of 30 or 32 bits.
    #[test]
    fn inverse_roots_are_too_low_by_less_than_stated() {
        for x in 1_u32 << 14..1 << 16 {
            for down in [14, 16] {
                let (first, last) = (x << down, x << down | ((1 << down) - 1));
                if first >> 30 == 0 && down == 16 || first >> 30 != 0 && down == 14 {
                    continue;
                }
                let root = inverse_root(first);
                assert_eq!(root, inverse_root(last));
                let square = |square: u32| u128::from(root).pow(2) * u128::from(square);
                assert!(square(last) <= 1 << 60, "{first}");
                assert!(square(first) << 24 > 4095_u128.pow(2) << 60, "{first}");
            }
        }
    }
}
