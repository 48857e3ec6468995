//! Sets bits: of a row, of a few voxels, of four rows side by side.

use super::Bits;
use crate::arithmetic::Each;
use crate::scalar::Scalar;
use crate::voxel::block::Block;
use crate::voxel::four_rows::FourRows;
use crate::voxel::place::Span;
use crate::voxel::word::Word;

impl<S: Scalar, W: Word> Bits<'_, S, W> {
    /// Sets the bits of some voxels of a block.
    #[inline(always)]
    pub(super) fn set_few(&mut self, block: &Block, mut met: u32) {
        let [x, y, z] = block.first.each(|first| first as u32);
        let [width, rows, layers] = block.widths;
        let (at, shift) = ((x / W::BITS) as usize, x % W::BITS);
        for z in z..z + layers {
            for y in y..y + rows {
                let bits = W::of(met & (u32::MAX >> (32 - width)));
                // After the last row the shift may be 32.
                met = met.checked_shr(width).unwrap_or(0);
                match self.row_mut(y, z).get_mut(at..) {
                    Some([word, next, ..]) => {
                        *word |= bits << shift;
                        // In two steps, for a shift by all bits of a word overflows.
                        *next |= bits >> (W::BITS - 1 - shift) >> 1;
                    }
                    Some([word]) => *word |= bits << shift,
                    _ => {}
                }
            }
        }
    }

    /// Sets the bits of a row of the grid.
    #[inline(always)]
    pub(super) fn set_span(&mut self, [y, z]: [i32; 2], Span { first, last }: Span) {
        self.set_row([y as u32, z as u32], [first as u32, last as u32]);
    }

    /// Sets the bits of a row from the first to the last.
    #[inline(always)]
    fn set_row(&mut self, [y, z]: [u32; 2], [first, last]: [u32; 2]) {
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
        // A row that is not met has no bits: no branch.
        let is_met = lanes(|k| if rows.met & 1 << k == 0 { 0 } else { u32::MAX });
        let count = lanes(|k| last[k].wrapping_sub(first[k]).wrapping_add(1) & is_met[k]);
        let (shift, at) = (lanes(|k| first[k] % W::BITS), lanes(|k| first[k] / W::BITS));
        let [a, b, c, d] = lanes(|k| count[k] + shift[k]);
        let (mut start, words) = (self.row_start(y, z), &mut *self.words);
        for k in 0..4 {
            if let Some(word) = words.get_mut(start + at[k] as usize) {
                // A row that continues in the next word gets only some of its bits here.
                *word |= W::first(count[k] % W::BITS) << shift[k];
            }
            start += self.row_words;
        }
        // Some row reaches the end of its word. `W::BITS` is a power of two, so that some of four
        // numbers reaches it exactly if their bits together do.
        if (a | b) | (c | d) >= W::BITS {
            self.set_long_rows(rows);
        }
    }

    /// Sets the bits of rows, one by one, if some row reaches the end of a word.
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

/// A number for each of four rows, written out because the compiler does not unroll a loop.
#[inline(always)]
fn lanes(f: impl Fn(usize) -> u32) -> [u32; 4] {
    [f(0), f(1), f(2), f(3)]
}
