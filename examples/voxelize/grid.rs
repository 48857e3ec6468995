//! The grid: one bit for each voxel.

/// Voxels in a box, x fastest.
pub(crate) struct Grid {
    size: [usize; 3],
    words: Vec<u64>,
}

impl Grid {
    /// A grid with no voxel set.
    pub(crate) fn new(size: [usize; 3]) -> Self {
        let bits: usize = size.iter().product();
        Self { size, words: vec![0; bits.div_ceil(64)] }
    }

    /// Voxels along each axis.
    pub(crate) fn size(&self) -> [usize; 3] {
        self.size
    }

    pub(crate) fn set(&mut self, voxel: [usize; 3]) {
        let bit = self.bit(voxel);
        self.words[bit / 64] |= 1 << (bit % 64);
    }

    pub(crate) fn get(&self, voxel: [usize; 3]) -> bool {
        let bit = self.bit(voxel);
        self.words[bit / 64] >> (bit % 64) & 1 == 1
    }

    /// How many voxels are set.
    pub(crate) fn count(&self) -> u64 {
        self.words.iter().map(|w| u64::from(w.count_ones())).sum()
    }

    /// The voxels that are set, in order of memory.
    pub(crate) fn voxels(&self) -> impl Iterator<Item = [usize; 3]> {
        let [nx, ny, _] = self.size;
        let set = |w: &u64| {
            let w = *w;
            (0..64).filter(move |i| w >> i & 1 == 1)
        };
        self.words
            .iter()
            .enumerate()
            .flat_map(move |(i, w)| set(w).map(move |b| 64 * i + b))
            .map(move |bit| [bit % nx, bit / nx % ny, bit / nx / ny])
    }

    fn bit(&self, [x, y, z]: [usize; 3]) -> usize {
        let [nx, ny, nz] = self.size;
        debug_assert!(x < nx && y < ny && z < nz);
        x + nx * (y + ny * z)
    }
}
