//! The mesh in the coordinates of the grid.

use std::error::Error;
use std::ops::RangeInclusive;

/// The most voxels that are kept at a time. They take a gibibyte, at a bit for each voxel.
pub(crate) const MOST_VOXELS: f64 = (1_u64 << 33) as f64;

/// The most voxels along a side.
const LONGEST_SIDE: u32 = 1 << 16;

/// More voxels than rounding to a scalar moves a coordinate.
const ROUNDED: f64 = 1.0 / 128.0;

/// A mesh in grid coordinates. A voxel has edges of length one and corners at whole
/// numbers. The origin is a corner in the middle of the grid, so that all coordinates
/// are as small as possible.
pub(crate) struct Placed {
    /// Voxels along each axis.
    pub(crate) size: [usize; 3],
    pub(crate) triangles: Vec<[[f64; 3]; 3]>,
    /// The grid's least corner and the edge of a voxel, in the units of the mesh.
    pub(crate) origin: [f64; 3],
    pub(crate) edge: f64,
}

/// Scales the mesh so that its longest side spans `resolution` voxels, and centres it in the
/// smallest grid that holds it.
///
/// On axes along which the mesh fills the grid, `layers_beyond` are added at the end.
///
/// Multiplication comes before division, so that a coordinate that is a whole number of voxels
/// becomes exactly that number.
pub(crate) fn place(
    triangles: &[[[f64; 3]; 3]],
    resolution: u32,
    layers_beyond: u32,
) -> Result<Placed, Box<dyn Error>> {
    let points = || triangles.iter().flatten();
    let least: [f64; 3] = [0, 1, 2].map(|i| points().map(|p| p[i]).fold(f64::INFINITY, f64::min));
    let greatest = [0, 1, 2].map(|i| points().map(|p| p[i]).fold(f64::NEG_INFINITY, f64::max));
    let extent = [0, 1, 2].map(|i| greatest[i] - least[i]);
    let longest = extent.into_iter().fold(0.0, f64::max);
    if longest == 0.0 {
        return Err("the mesh is a single point: it has no size to scale to a grid".into());
    }

    if !(longest * f64::from(resolution)).is_finite() {
        return Err(
            "the mesh is too large: --resolution times its longest side is beyond f64".into()
        );
    }
    if resolution > LONGEST_SIDE {
        return Err(format!("--resolution {resolution}: at most {LONGEST_SIDE} is allowed").into());
    }
    // The quotient may be a little more.
    let scaled = |x: f64| (x * f64::from(resolution) / longest).min(f64::from(resolution));
    // A flat mesh lies in one layer of voxels.
    let size = extent.map(|e| scaled(e).ceil().max(1.0));
    let margin = [0, 1, 2].map(|i| (size[i] - scaled(extent[i])) / 2.0);
    let beyond = margin.map(|m| if m < ROUNDED { f64::from(layers_beyond) } else { 0.0 });
    let size = [0, 1, 2].map(|i| size[i] + beyond[i]);
    let middle = size.map(|n| (n / 2.0).ceil());
    let placed = |p: [f64; 3]| [0, 1, 2].map(|i| scaled(p[i] - least[i]) + margin[i] - middle[i]);
    let edge = longest / f64::from(resolution);
    Ok(Placed {
        size: size.map(|n| n as usize),
        origin: [0, 1, 2].map(|i| least[i] - margin[i] * edge),
        edge,
        triangles: triangles.iter().map(|t| t.map(placed)).collect(),
    })
}

/// Refuses a grid that is too large to be kept.
pub(crate) fn check_memory(size: [usize; 3]) -> Result<(), String> {
    let [x, y, z] = size;
    let voxels: f64 = size.into_iter().map(|n| n as f64).product();
    if voxels <= MOST_VOXELS {
        return Ok(());
    }
    Err(format!(
        "a grid of {x} × {y} × {z} voxels would take {:.1} GiB of memory, more than the 1 GiB \
         allowed; choose a lower --resolution, or count the voxels alone by --no-picture",
        voxels / MOST_VOXELS
    ))
}

impl Placed {
    /// The voxels along an axis that the interval of these coordinates touches. Both are closed
    /// sets, so a coordinate on an integer touches both neighbours.
    pub(crate) fn touched(&self, axis: usize, [a, b, c]: [f64; 3]) -> RangeInclusive<usize> {
        let last = (self.size[axis] - 1) as f64;
        let first_touched = a.min(b).min(c).ceil() - 1.0 - self.start(axis);
        let last_touched = a.max(b).max(c).floor() - self.start(axis);
        let index = |x: f64| x.clamp(0.0, last) as usize;
        index(first_touched)..=index(last_touched)
    }

    /// The coordinate of the grid's least corner on this axis, an integer.
    pub(crate) fn start(&self, axis: usize) -> f64 {
        -(self.size[axis].div_ceil(2) as f64)
    }
}
