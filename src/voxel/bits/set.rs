//! How bits are set: of the voxels of a row, of a few voxels, of four rows side by side.

use super::Bits;
use crate::arithmetic::each;
use crate::scalar::Scalar;
use crate::voxel::block::Block;
use crate::voxel::four_rows::FourRows;
use crate::voxel::word::Word;

impl<S: Scalar, W: Word> Bits<'_, S, W> {
    /// Sets the bits of some voxels of a block.
    #[inline(always)]
    pub(super) fn set_few(&mut self, block: &Block, mut met: u32) {
        let [x, y, z] = each(block.first, |first| first as u32);
        let [width, rows, layers] = block.widths;
        let (at, shift) = ((x / W::BITS) as usize, x % W::BITS);
        for z in z..z + layers {
            for y in y..y + rows {
                let bits = W::of(met & (u32::MAX >> (32 - width)));
                // The last row may leave none.
                met = met.checked_shr(width).unwrap_or(0);
                match self.row_mut(y, z).get_mut(at..) {
                    Some([word, next, ..]) => {
                        *word |= bits << shift;
                        // In two steps: by all of its bits a word cannot be shifted.
                        *next |= bits >> (W::BITS - 1 - shift) >> 1;
                    }
                    Some([word]) => *word |= bits << shift,
                    _ => {}
                }
            }
        }
    }

    /// Sets the bits of a row from the first to the last.
    #[inline(always)]
    pub(super) fn set_row(&mut self, [y, z]: [u32; 2], [first, last]: [u32; 2]) {
        let (from, to) = ((first / W::BITS) as usize, (last / W::BITS) as usize);
        let head = W::ALL << (first % W::BITS);
        let tail = W::ALL >> (W::BITS - 1 - last % W::BITS);
        match self.row_mut(y, z).get_mut(from..=to) {
            Some([word]) => *word |= head & tail,
            Some([start, middle @ .., end]) => {
                *start |= head;
                middle.fill(W::ALL);
                *end |= tail;
            }
            _ => {}
        }
    }

    /// Sets the bits of four rows, in steps that the compiler can keep in vectors.
    #[inline(always)]
    pub(super) fn set_rows(&mut self, rows: &FourRows) {
        let ([y, z], [first, last]) = (rows.at, &rows.x);
        // A row that is not met is one of no bits, and is not branched on.
        let is_met = lanes(|k| if rows.met & 1 << k == 0 { 0 } else { u32::MAX });
        let count = lanes(|k| last[k].wrapping_sub(first[k]).wrapping_add(1) & is_met[k]);
        let (shift, at) = (lanes(|k| first[k] % W::BITS), lanes(|k| first[k] / W::BITS));
        let [a, b, c, d] = lanes(|k| count[k] + shift[k]);
        let (mut start, words) = (self.row_start(y, z), &mut *self.words);
        for k in 0..4 {
            if let Some(word) = words.get_mut(start + at[k] as usize) {
                // Of a row that goes on in the next word, only some of its bits.
                *word |= W::first(count[k] % W::BITS) << shift[k];
            }
            start += self.row_words;
        }
        // Some row reaches the end of its word: a power of two, so that one of four is as great if
        // their bits together are.
        if (a | b) | (c | d) >= W::BITS {
            self.set_long_rows(rows);
        }
    }

    /// Sets the bits of rows of which some reach the end of a word.
    #[inline(never)]
    fn set_long_rows(&mut self, rows: &FourRows) {
        let [y, z] = rows.at;
        for k in 0..4_usize {
            if rows.met >> k & 1 == 1 {
                self.set_row([y + k as u32, z], [rows.x[0][k], rows.x[1][k]]);
            }
        }
    }
}

/// A number for each of four rows. Written out, that it be unrolled.
#[inline(always)]
fn lanes(f: impl Fn(usize) -> u32) -> [u32; 4] {
    [f(0), f(1), f(2), f(3)]
}
