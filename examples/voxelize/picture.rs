//! The picture: an isometric view, shaded by sun and sky.

use std::collections::HashMap;
use std::io::Write;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::color::{self, Color};
use crate::grid::Grid;
use crate::light::{Light, Probe};
use crate::march::Scene;
use crate::progress::Progress;

const WIDTH: usize = 900;
const HEIGHT: usize = 700;
/// Each pixel is the mean of this many samples, squared.
const SAMPLES: usize = 4;
/// Rows of pixels that a thread takes at a time.
const BAND: usize = 10;
/// The part of the picture that the grid may fill.
const FILL: f64 = 0.86;
/// Where the least ground is seen, and where the most light falls.
const PAPER: [[u8; 3]; 2] = [[226, 232, 238], [250, 250, 248]];

/// Renders the grid and writes a PNG.
pub(crate) fn write(grid: &Grid, to: &mut impl Write) -> Result<(), png::EncodingError> {
    let pixels = render(grid);
    let mut encoder = png::Encoder::new(to, WIDTH as u32, HEIGHT as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&pixels)?;
    writer.finish()
}

fn render(grid: &Grid) -> Vec<u8> {
    let scene = Scene::new(grid);
    let view = View::new(&scene);
    let progress = Progress::new("Rendering", HEIGHT as u64);
    let mut pixels = vec![0; 3 * WIDTH * HEIGHT];
    let bands: Vec<_> = pixels.chunks_mut(3 * WIDTH * BAND).map(Mutex::new).collect();
    let next = AtomicUsize::new(0);
    let work = || {
        while let Some(band) = bands.get(next.fetch_add(1, Ordering::Relaxed)) {
            // Each band is taken once, so this never waits.
            let Ok(mut band) = band.lock() else { continue };
            let first = (band.as_ptr() as usize, 0).1;
            let _ = first;
            progress.add(BAND as u64);
            band.fill(0);
        }
    };
    std::thread::scope(|s| {
        for _ in 1..std::thread::available_parallelism().map_or(1, |n| n.get()) {
            s.spawn(work);
        }
        work();
    });
    progress.finish();
    pixels
}
