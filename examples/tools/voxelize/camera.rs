//! The camera: an isometric view of the voxels.

use std::f64::consts::FRAC_1_SQRT_2;

use crate::grid::Grid;

/// Of the picture, in pixels.
pub(crate) const WIDTH: usize = 900;
pub(crate) const HEIGHT: usize = 700;
/// The part of the picture that the voxels may fill, and their offset to the left of its middle.
const FILL: f64 = 0.68;
const ASIDE: f64 = 0.06;

/// Parallel rays along the diagonal of a voxel. All visible faces look in one of three
/// directions, and look equally large.
pub(crate) struct Camera {
    /// The length of a voxel's edge in the plane of the picture, in pixels.
    pub(crate) scale: f64,
    /// The point of the scene in the middle of the picture, moved towards the viewer
    /// until it is in front of all voxels.
    middle: [f64; 3],
    /// Voxels along the longest side.
    pub(crate) longest: f64,
}

impl Camera {
    const RIGHT: [f64; 3] = [FRAC_1_SQRT_2, 0.0, -FRAC_1_SQRT_2];
    const UP: [f64; 3] = [-0.408_248_290_463_863, 0.816_496_580_927_726, -0.408_248_290_463_863];
    pub(crate) const AWAY: [f64; 3] = [-1.0; 3];

    /// A view in which the voxels that are set fill the picture.
    pub(crate) fn new(grid: &Grid) -> Self {
        let (mut least, mut greatest) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for voxel in grid.voxels() {
            let [x, y, z] = voxel.map(|i| i as f64 + 0.5);
            let seen = [Self::RIGHT, Self::UP].map(|d| d[0] * x + d[1] * y + d[2] * z);
            least = [0, 1].map(|i| seen[i].min(least[i]));
            greatest = [0, 1].map(|i| seen[i].max(greatest[i]));
        }
        if least[0] > greatest[0] {
            // A method that misses voxels may miss every one.
            (least, greatest) = ([0.0; 2], [0.0; 2]);
        }
        // Room for the voxels around the outermost centres.
        let [wide, high] = [0, 1].map(|i| greatest[i] - least[i] + 2.0);
        let scale = FILL * (WIDTH as f64 / wide).min(HEIGHT as f64 / high);
        // Shadows fall to the right, so that the voxels stand left of the middle.
        let [right, up] = [0, 1].map(|i| (greatest[i] + least[i]) / 2.0);
        let right = right + ASIDE * WIDTH as f64 / scale;
        let size = grid.size().map(|n| n as f64);
        let longest = size.into_iter().fold(0.0, f64::max);
        let far = 4.0 * longest;
        let middle = [0, 1, 2].map(|i| right * Self::RIGHT[i] + up * Self::UP[i] + far);
        Self { scale, middle, longest }
    }

    /// Whether voxels are about as small as pixels.
    pub(crate) fn is_fine(&self) -> bool {
        self.scale < 3.0
    }

    /// For each pixel, whether a voxel may be visible there. Most of a picture is ground, whose
    /// rays would cross the whole grid.
    pub(crate) fn near_voxels(&self, grid: &Grid) -> Vec<bool> {
        let mut near = vec![false; WIDTH * HEIGHT];
        // A voxel extends from its centre to a corner: √(2/3) of its edge, seen along the diagonal.
        let reach = 0.82 * self.scale + 1.0;
        let span = |middle: f64, end: usize| {
            let clamped = |x: f64| x.clamp(0.0, end as f64) as usize;
            clamped(middle - reach)..clamped(middle + reach + 1.0)
        };
        for voxel in grid.voxels() {
            let from = [0, 1, 2].map(|i| voxel[i] as f64 + 0.5 - self.middle[i]);
            let [right, up] =
                [Self::RIGHT, Self::UP].map(|d| from[0] * d[0] + from[1] * d[1] + from[2] * d[2]);
            let across = span(WIDTH as f64 / 2.0 + right * self.scale, WIDTH);
            for y in span(HEIGHT as f64 / 2.0 - up * self.scale, HEIGHT) {
                near[WIDTH * y..][across.clone()].fill(true);
            }
        }
        near
    }

    /// Where the ray through a point of the picture starts.
    pub(crate) fn origin(&self, x: f64, y: f64) -> [f64; 3] {
        let right = (x - WIDTH as f64 / 2.0) / self.scale;
        let up = (HEIGHT as f64 / 2.0 - y) / self.scale;
        [0, 1, 2].map(|i| self.middle[i] + right * Self::RIGHT[i] + up * Self::UP[i])
    }
}
