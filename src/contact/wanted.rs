//! The translations that may be the least: of all directions a few, by floats or by words.

use super::body::Body;
use super::cut::Cut;
use super::directions::{Apart, Direction, all, sides_of_all};
use super::filter::{Filter, Ruler};
use super::lanes::Lanes;
use super::lanes::Measure;
use super::rows;
use crate::arithmetic::{Each, OfFour, REGISTERS_ARE_WIDE, SMALL_CODE, least as smaller, two};
use crate::scalar::Scalar;

/// Directions, and the translations that may be the least, as a bit for each direction: those against
/// it, and those along it.
pub(super) struct Wanted {
    all: &'static [Direction],
    against: u16,
    along: u16,
}

/// The normal of the first shape, if it is a triangle.
pub(super) const FACE: Direction = Direction::Face { is_second: false, k: 0 };

impl Wanted {
    /// Both translations along the normal of the first shape.
    pub(super) const FACE: Self = Self { all: &[FACE], against: 1, along: 1 };

    /// The translations whose overlap may be the least, by floats; nearly always a single one.
    #[inline(always)]
    pub(super) fn new<S: Scalar>(
        bodies: &[Body<'_, S>; 2],
        filter: &Filter<'_>,
    ) -> Result<Self, Apart> {
        let all = all(bodies);
        let [against, along] = by_floats(filter.needed(all), &filter.ruler)?;
        Ok(Self { all, against, along })
    }

    /// The translations whose overlap may be the least, by half words; mostly a single one.
    #[inline(never)]
    pub(super) fn in_words(all: &'static [Direction], cut: &Cut<'_>) -> Result<Self, Apart> {
        let mut wanted = Self { all, against: 0, along: 0 };
        let axes = cut.axes();
        // Others that are superfluous are left out where one of them may be the least: that is less work.
        let count = if axes.are_alike() { 3 } else { all.len() };
        // None is left where all are zero.
        let (mut least, mut bound) = ([[i32::MAX; 2]; 16], i32::MAX - 1);
        let all_sides = sides_of_all(cut.are_triangles());
        for (least, &sides) in least.iter_mut().zip(all_sides).take(count) {
            if let Some(depths) = cut.depths(sides, bound)? {
                (*least, bound) = (depths.least, bound.min(depths.most));
            }
        }
        for (n, &[against, along]) in least.iter().enumerate() {
            wanted.against |= u16::from(against <= bound) << n;
            wanted.along |= u16::from(along <= bound) << n;
        }
        if wanted.single().is_none() {
            let needed = axes.needed(all, |sides, axis| cut.is_clear(sides, axis));
            wanted.against &= needed;
            wanted.along &= needed;
        }
        Ok(wanted)
    }

    pub(super) fn direction(&self, n: usize) -> Direction {
        self.all.get(n).copied().unwrap_or(FACE)
    }

    /// The directions with a translation that is wanted, in their order, and whether it is wanted
    /// against the direction, and along it.
    pub(super) fn iter(&self) -> impl Iterator<Item = (Direction, [bool; 2])> {
        let mut left = self.against | self.along;
        core::iter::from_fn(move || {
            let n = left.trailing_zeros() as usize % 16;
            let wanted = [self.against, self.along].each(|bits| bits >> n & 1 == 1);
            let is_wanted = left != 0;
            left &= left.wrapping_sub(1);
            is_wanted.then(|| (self.direction(n), wanted))
        })
    }

    /// The translation that is wanted, if it is the only one: the number of its direction, and whether it
    /// is along it.
    #[inline]
    pub(super) fn single(&self) -> Option<(usize, bool)> {
        let all = self.against | self.along;
        let single = || (all.trailing_zeros() as usize % 16, self.along != 0);
        is_single([self.against, self.along]).then(single)
    }
}

/// Whether these are one translation.
fn is_single([against, along]: [u16; 2]) -> bool {
    (against | along).is_power_of_two() && against & along == 0
}

/// The translations whose overlap may be the least, of the directions in `needed`, against them and
/// along them; all as bits. Out of line and of no scalar, so that all scalars share it.
#[inline(never)]
fn by_floats(mut needed: u16, ruler: &Ruler<'_, f64>) -> Result<[u16; 2], Apart> {
    // Small cores too: functions of `f32` take half the instructions, and a machine's operations few.
    if (REGISTERS_ARE_WIDE || !SMALL_CODE) && needed.count_ones() > 4 {
        let wanted = if REGISTERS_ARE_WIDE && ruler.are_triangles == [false; 2] {
            rows::wanted(needed, ruler.shapes)?
        } else {
            let short = two(|n| ruler.shapes[n].short());
            let ruler = Ruler::new(&short);
            if REGISTERS_ARE_WIDE {
                of_lanes::<<f32 as OfFour>::Quad>(needed, &ruler)?
            } else {
                of_lanes::<f32>(needed, &ruler)?
            }
        };
        if is_single(wanted) {
            return Ok(wanted);
        }
        needed = wanted[0] | wanted[1];
    }
    if REGISTERS_ARE_WIDE {
        of_lanes::<<f64 as OfFour>::Quad>(needed, ruler)
    } else {
        of_lanes::<f64>(needed, ruler)
    }
}

/// The same in one kind of lanes.
#[inline(always)]
fn of_lanes<V: Lanes>(needed: u16, ruler: &Ruler<'_, V::Lane>) -> Result<[u16; 2], Apart> {
    let (all, mut some, mut places) = (sides_of_all(ruler.are_triangles), [[0; 2]; 16], [0_u8; 16]);
    let count = needed.count_ones() as usize;
    // The first directions, without a gap.
    let are_first = needed & needed.wrapping_add(1) == 0;
    if !are_first {
        let (mut left, mut last) = (needed, 0);
        // The last one again, for all lanes.
        for (to, place) in some.iter_mut().zip(&mut places).take(count.next_multiple_of(V::COUNT)) {
            last = if left == 0 { last } else { left.trailing_zeros() as u8 };
            left &= left.wrapping_sub(1);
            (*to, *place) = (all[usize::from(last % 16)], last);
        }
    }
    let sides = if are_first { all } else { &some };
    let infinity = V::same(V::Lane::INFINITY);
    let (mut least, mut bound) = (V::all([infinity; 2]), infinity);
    // As bits of the directions that are needed, in their order.
    let mut unknown = 0;
    for (group, least) in least.as_mut().iter_mut().enumerate() {
        let begin = group * V::COUNT;
        if begin >= count {
            break;
        }
        let found = ruler.overlaps::<V>(|n| sides[(begin + n) % 16]);
        if found.are_apart {
            return Err(Apart);
        }
        unknown |= found.unknown << begin;
        *least = found.least;
        bound = bound.least(found.most[0].least(found.most[1]));
    }
    let bound = (0..V::COUNT).map(|n| bound.lane(n)).fold(V::Lane::INFINITY, smaller);
    let may_be_least = |side: usize| {
        let mut left = unknown;
        for (group, least) in least.as_ref().iter().enumerate() {
            if group * V::COUNT >= count {
                break;
            }
            left |= least[side].is_within(V::same(bound)) << (group * V::COUNT);
        }
        if are_first { left as u16 & needed } else { placed(left & ((1 << count) - 1), &places) }
    };
    Ok(two(may_be_least))
}

/// Puts bit n at its place.
fn placed(mut bits: u32, places: &[u8; 16]) -> u16 {
    let mut placed = 0;
    while bits != 0 {
        placed |= 1 << (places[bits.trailing_zeros() as usize % 16] % 16);
        bits &= bits - 1;
    }
    placed
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arithmetic::three;
    use crate::contact::body::{Rough, Vec64};
    use crate::random::Random;

    /// `f32`, in rows or one by one, leaves all directions of two boxes that `f64` leaves, and mostly no other.
    /// The boxes are turned anyhow or nearly alike, and orthonormal, skewed or with axes not of unit length.
    #[test]
    fn f32_leaves_what_f64_leaves() {
        let mut random = Random(0x20e5);
        let mut number = || f64::from(random.bits() as i32) * 2_f64.powi(-31);
        let mut counts = [[0; 3]; 2];
        for n in 0..60_000_i32 {
            let by = if n % 7 == 0 { 2_f64.powi(n % 9 - 4) } else { 1.0 };
            let [mut first, mut second] = [(); 2].each(|()| three(|_| three(|_| by * number())));
            if n % 4 > 0 {
                let tilt = [1.0, 1e-2, 1e-5][n as usize % 3];
                let [p, q] = [three(|_| number()), three(|_| tilt * number())];
                first = turned([p[0], p[1], p[2]]);
                second = turned(three(|i| p[i] + q[i]));
            }
            let sides = [first, second];
            let half = two(|_| three(|_| 0.1 + number().abs()));
            let at = three(|_| by * number());
            let shapes = two(|k| Rough {
                is_triangle: false,
                at: [if k == 0 { at } else { [0.0; 3] }; 3],
                sides: sides[k],
                half: half[k],
            });
            let all = u16::MAX >> 1;
            let truth = of_lanes::<f64>(all, &Ruler::new(&shapes));
            let short = two(|k| shapes[k].short());
            let found = [rows::wanted(all, &shapes), of_lanes::<f32>(all, &Ruler::new(&short))];
            for (found, counts) in found.iter().zip(&mut counts) {
                match (found, &truth) {
                    (Err(Apart), Err(Apart)) => counts[0] += 1,
                    (Err(Apart), Ok(_)) => panic!("{n}"),
                    (Ok(_), Err(Apart)) => counts[1] += 1,
                    (Ok(found), Ok(truth)) => {
                        for side in 0..2 {
                            assert_eq!(truth[side] & !found[side], 0, "{found:?} {truth:?} {n}");
                        }
                        counts[2] += usize::from(is_single(*found));
                    }
                }
            }
        }
        for [apart, doubtful, single] in counts {
            assert!(apart > 1000 && doubtful < 1000 && single > 10_000, "{counts:?}");
        }
    }

    /// The frame of a vector, by Cayley's formula.
    fn turned([x, y, z]: Vec64) -> [Vec64; 3] {
        let s = 2.0 / (1.0 + x * x + y * y + z * z);
        [
            [1.0 - s * (y * y + z * z), s * (x * y + z), s * (x * z - y)],
            [s * (x * y - z), 1.0 - s * (x * x + z * z), s * (y * z + x)],
            [s * (x * z + y), s * (y * z - x), 1.0 - s * (x * x + y * y)],
        ]
    }
}
