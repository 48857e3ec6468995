//! The voxels that were set: one bit for each, in the layout of `septum::voxel::Bits`.

/// Voxels in a box, x fastest; each row begins with a word of its own.
#[derive(Clone)]
pub(crate) struct Grid {
    size: [usize; 3],
    words: Vec<u64>,
}

impl Grid {
    /// A grid with no voxel set.
    pub(crate) fn new(size: [usize; 3]) -> Self {
        let [nx, ny, nz] = size;
        Self { size, words: vec![0; nx.div_ceil(64) * ny * nz] }
    }

    /// Voxels along each axis.
    pub(crate) fn size(&self) -> [usize; 3] {
        self.size
    }

    /// The words, layer by layer.
    pub(crate) fn words_mut(&mut self) -> &mut [u64] {
        &mut self.words
    }

    /// The words of a row.
    pub(crate) fn row(&self, y: usize, z: usize) -> &[u64] {
        let [nx, ny, _] = self.size;
        let words = nx.div_ceil(64);
        &self.words[words * (y + ny * z)..][..words]
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
        count(&self.words)
    }

    /// Combines the words of two grids with `of`.
    pub(crate) fn with(&self, other: &Self, of: impl Fn(u64, u64) -> u64) -> Self {
        let words = self.words.iter().zip(&other.words).map(|(&a, &b)| of(a, b)).collect();
        Self { size: self.size, words }
    }

    /// Removes the half that is nearer to a viewer looking along z.
    pub(crate) fn cut(mut self) -> Self {
        let [nx, ny, nz] = self.size;
        self.words[nx.div_ceil(64) * ny * nz.div_ceil(2)..].fill(0);
        self
    }

    /// The voxels that are set, in order of memory.
    pub(crate) fn voxels(&self) -> impl Iterator<Item = [usize; 3]> {
        let [nx, ny, _] = self.size;
        let row = nx.div_ceil(64);
        let set = |w: &u64| {
            let w = *w;
            (0..64).filter(move |i| w >> i & 1 == 1)
        };
        self.words
            .iter()
            .enumerate()
            .flat_map(move |(i, w)| set(w).map(move |b| (i, b)))
            .map(move |(i, b)| [i % row * 64 + b, i / row % ny, i / row / ny])
    }

    fn bit(&self, [x, y, z]: [usize; 3]) -> usize {
        let [nx, ny, nz] = self.size;
        debug_assert!(x < nx && y < ny && z < nz);
        x + 64 * nx.div_ceil(64) * (y + ny * z)
    }
}

/// How many bits are set.
pub(crate) fn count(words: &[u64]) -> u64 {
    words.iter().map(|w| u64::from(w.count_ones())).sum()
}
