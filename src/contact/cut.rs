//! Bounds on the overlap along each direction in half words: for cores where floats are functions, and
//! scalars that are integers of a few words. A product takes one instruction, and no sum a second word.

use core::cmp::Ordering;

use super::directions::{Axes, Direction};
use super::integers::Words;
use super::whole::Pair;
use crate::arithmetic::{Each, greatest, pick};

/// The numbers of two shapes, rounded to half words: twice the places from the second shape's origin, and
/// what extends from them.
pub(super) struct Cut<'a> {
    pair: &'a Pair<Words>,
    /// Each side over a power of two of its own.
    sides: [[[i32; 3]; 3]; 2],
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

/// Bounds along a direction.
pub(super) struct Measured {
    /// The overlaps against the direction and along it, in units of its length.
    overlaps: [i32; 2],
    /// How far each may be off.
    error: i32,
    /// Its square over 2^20. The true square less this number is in (-2, 3).
    ///
    /// The greatest coordinate is at least 2^14 in size and at most 2^15. A coordinate errs by less
    /// than 9, and the square by less than 2·9·3·2^15 + 3·9², below 2^20·2.
    square: u32,
}

/// A square of a depth, as m/square, in a unit that is chosen for all.
#[derive(Clone, Copy)]
pub(super) struct Depth {
    m: u32,
    square: u32,
}

impl Depth {
    pub(super) fn is_at_most(&self, other: &Self) -> bool {
        // At most 2^20·3075 each.
        self.m * other.square <= other.m * self.square
    }
}

impl Measured {
    /// Whether the shapes are certainly apart.
    pub(super) fn are_apart(&self) -> bool {
        self.overlaps.iter().any(|&overlap| overlap < -self.error)
    }

    /// The most that the overlap may be on the side where it is less.
    pub(super) fn most(&self) -> i32 {
        let [against, along] = self.overlaps;
        against.min(along) + self.error
    }

    /// The most that the depth may be, if that overlap is at most four times the least of all: no length is
    /// four times another. Ten bits hold four times the least in units of 2^`down`.
    pub(super) fn bound(&self, least: i32, down: u32) -> Option<Depth> {
        let most = self.most();
        let m = (most >> down) as u32 + 1;
        (most >> 2 <= least).then(|| Depth { m: m * m, square: self.square - 2 })
    }

    /// Whether the depth on one side may be at most a bound.
    pub(super) fn is_within(&self, is_along: bool, bound: &Depth, least: i32, down: u32) -> bool {
        let overlap = greatest(self.overlaps[usize::from(is_along)] - self.error, 0);
        let m = (overlap >> down) as u32;
        overlap >> 2 <= least && Depth { m: m * m, square: self.square + 3 }.is_at_most(bound)
    }
}

/// How far overlaps are shifted down so that ten bits hold four times the least.
pub(super) fn places_beyond(least: i32) -> u32 {
    24_u32.saturating_sub(least.leading_zeros())
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

/// The numbers over 2^down, rounded to the nearest.
fn rounded(v: &[i32; 3], down: i32) -> [i32; 3] {
    v.each(|x| (raised(x, 1 - down) + 1) >> 1)
}

impl<'a> Cut<'a> {
    #[inline(never)]
    pub(super) fn new(pair: &'a Pair<Words>) -> Self {
        let none = [[[0; 3]; 3]; 2];
        let mut new = Self { pair, sides: none, at: none, reach: none, sum: 0 };
        // The exponents of places and reaches.
        let (mut ups, mut of_reach) = ([[0; 3]; 2], [[0; 3]; 2]);
        let mut most = 0;
        for n in 0..2 {
            for k in 0..3 {
                // A box has one place.
                if k == 0 || pair.are_triangles[n] {
                    let (end, up) = narrowed(&pair.ends[n][k]);
                    (new.at[n][k], ups[n][k]) = (end, up + pair.up as i32);
                    most = greatest(most, bits(&end) + ups[n][k]);
                }
                let (side, up) = narrowed(&pair.sides[n][k]);
                // To 30 bits.
                let free = 30 - bits(&side);
                let side = side.each(|x| raised(x, free));
                new.sides[n][k] = side.each(|x| (x + (1 << 14)) >> 15);
                let half = pair.halves[n][k] as u32;
                if half != 0 {
                    // To 16 bits.
                    let zeros = half.leading_zeros();
                    let half = (((half << zeros) >> 15) + 1) >> 1;
                    let times = |x: i32| {
                        (x >> 16) * half as i32 + (((x as u32 & 0xffff) * half) >> 16) as i32
                    };
                    let reach = side.each(times);
                    (new.reach[n][k], of_reach[n][k]) = (reach, up - free + 32 - zeros as i32);
                    most = greatest(most, bits(&reach) + of_reach[n][k]);
                }
            }
        }
        let down = most - PLACE;
        for n in 0..2 {
            for k in 0..3 {
                new.at[n][k] = rounded(&new.at[n][k], down - ups[n][k]);
                new.reach[n][k] = rounded(&new.reach[n][k], down - of_reach[n][k]);
            }
        }
        let sizes = |all: &[[[i32; 3]; 3]; 2]| -> i32 {
            all.as_flattened().as_flattened().iter().map(|x| x.abs()).sum()
        };
        new.sum = sizes(&new.at) + sizes(&new.reach);
        new
    }

    /// Where a shape begins and ends along a direction, without the sides in `own`, as bits 3·shape + k.
    fn ends(&self, shape: usize, a: &[i32; 3], own: u32) -> [i32; 2] {
        let along = |v: &[i32; 3]| (a[0] * v[0] + a[1] * v[1] + a[2] * v[2]) >> 3;
        let [p, q, r] = &self.at[shape % 2];
        let p = along(p);
        if self.pair.are_triangles[shape % 2] {
            let (q, r) = (along(q), along(r));
            return [p.min(q).min(r), p.max(q).max(r)];
        }
        let (mut reach, own) = (0, own >> (3 * shape));
        for (k, v) in self.reach[shape % 2].iter().enumerate() {
            if own >> k & 1 == 0 {
                reach += along(v).abs();
            }
        }
        [p - reach, p + reach]
    }

    /// The directions that are not certainly zero or equal to an earlier one, as bits.
    pub(super) fn needed(&self, all: &[Direction]) -> u16 {
        let sides = &self.pair.sides;
        Axes::new(sides.each_ref(), self.pair.are_triangles, true).needed(all, |direction, axis| {
            pick(&self.cross(direction), axis).unsigned_abs() >> 17 != 0
        })
    }

    /// The cross product of a direction's rounded sides. It errs by less than 2^16 and 2^5.
    fn cross(&self, direction: Direction) -> [i32; 3] {
        let own = direction.sides(self.pair.are_triangles);
        let [x, y] = own.each(|(shape, k)| pick(&self.sides[shape % 2], k));
        [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]
    }

    /// The direction's leading bits, and how far they are off; `None` if it is zero.
    fn direction(&self, direction: Direction) -> Option<([i32; 3], i32)> {
        let cross = self.cross(direction);
        let width = 32 - cross.iter().fold(0, |all, x| all | x ^ x >> 31).leading_zeros() as i32;
        if width >= LEAST {
            // 2^16 over that power, and one.
            return Some((cross.each(|x| x >> (width - BITS)), (1 << (31 - width)) + 1));
        }
        Some((self.pair.along(direction).cut(BITS)?, 1))
    }

    /// The signs of the sides along a direction, where they are certain.
    ///
    /// With the errors that [`ERROR`] has, a product errs by less than 2^15·(e + 1/2) and 2^7 + 13; three,
    /// in units of 2^2 to which each is cut, by less than 3·2^12·(2·e + 1) and 110.
    pub(super) fn along(&self, direction: Direction) -> [[Option<Ordering>; 3]; 2] {
        let mut along = [[None; 3]; 2];
        if let Some((a, error)) = self.direction(direction) {
            let bound = 3 * (2 * error + 1) * (1 << 12) + 110;
            for (along, v) in along.as_flattened_mut().iter_mut().zip(self.sides.as_flattened()) {
                let sum = ((a[0] * v[0]) >> 2) + ((a[1] * v[1]) >> 2) + ((a[2] * v[2]) >> 2);
                *along = (sum.abs() > bound).then(|| sum.cmp(&0));
            }
        }
        along
    }

    /// Bounds along a direction; `None` if it is zero.
    pub(super) fn measured(&self, direction: Direction) -> Option<Measured> {
        let (a, error) = self.direction(direction)?;
        let [x, y] = direction.numbers(self.pair.are_triangles);
        let own = 1 << x | 1 << y;
        let ([a0, a1], [b0, b1]) = (self.ends(0, &a, own), self.ends(1, &a, own));
        let square = a.iter().map(|x| x.unsigned_abs().pow(2)).sum::<u32>();
        let error = ((self.sum * error) >> 3) + ERROR;
        Some(Measured { overlaps: [a1 - b0, b1 - a0], error, square: square >> 20 })
    }
}
