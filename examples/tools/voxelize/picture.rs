//! The picture: an isometric view, shaded by sun and sky.

use std::io::Write;
use std::sync::Mutex;

use ahash::AHashMap;

use crate::camera::{Camera, HEIGHT, WIDTH};
use crate::color::{self, Color};
use crate::grid::Grid;
use crate::light::{Light, Probe};
use crate::march::{Hit, Scene};
use crate::progress::Progress;

/// The square root of the number of samples in each pixel.
const SAMPLES: usize = 4;
/// Rows of pixels that a thread takes at a time.
const BAND: usize = 35;
/// The colour of the ground, at the corners of the picture and in the middle.
const PAPER: [[u8; 3]; 2] = [[226, 232, 238], [250, 250, 248]];

/// Voxels that a method missed, and voxels that it set wrongly.
const MISSED: [u8; 3] = [214, 24, 32];
const EXTRA: [u8; 3] = [255, 150, 20];

/// Voxels to draw, and the voxels that a method missed or set wrongly.
pub(crate) struct View {
    pub(crate) all: Grid,
    pub(crate) missed: Grid,
    pub(crate) extra: Grid,
}

/// Renders the views side by side and writes a PNG.
pub(crate) fn write(views: &[View], to: &mut impl Write) -> Result<(), png::EncodingError> {
    let pictures: Vec<_> = views.iter().map(render).collect();
    let mut pixels = Vec::with_capacity(pictures.len() * 3 * WIDTH * HEIGHT);
    for y in 0..HEIGHT {
        for picture in &pictures {
            pixels.extend_from_slice(&picture[3 * WIDTH * y..3 * WIDTH * (y + 1)]);
        }
    }
    let mut encoder = png::Encoder::new(to, (pictures.len() * WIDTH) as u32, HEIGHT as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&pixels)?;
    writer.finish()
}

fn render(view: &View) -> Vec<u8> {
    let grid = &view.all;
    let scene = Scene::new(grid);
    let (camera, paint) = (Camera::new(grid), Paint::new(view));
    let near = camera.near_voxels(grid);
    let progress = Progress::new("Drawing", HEIGHT as u64);
    let mut pixels = vec![0; 3 * WIDTH * HEIGHT];
    let bands = Mutex::new(pixels.chunks_mut(3 * WIDTH * BAND).enumerate());
    let next = || bands.lock().ok()?.next();
    let work = || {
        while let Some((i, band)) = next() {
            let mut brush = Brush::new(&scene, &camera, &paint);
            for (j, row) in band.chunks_exact_mut(3 * WIDTH).enumerate() {
                for (x, pixel) in row.chunks_exact_mut(3).enumerate() {
                    let y = BAND * i + j;
                    let color = color::to_srgb(brush.pixel(x, y, near[WIDTH * y + x]));
                    // The last bit is invisible noise, and would be a fifth of the file.
                    pixel.copy_from_slice(&color.map(|c| c & !1));
                }
                progress.add(1);
            }
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

/// A square of the lattice, and the direction that it faces.
#[derive(Clone, Copy, PartialEq)]
struct Patch {
    axis: usize,
    /// The corner with the least coordinates, in steps.
    corner: [i32; 3],
}

/// The origin of a view ray, and its hit.
type Sample = ([f64; 3], Option<Hit>);

/// Colours that are constant over the picture.
struct Paint<'a> {
    /// The voxels with a colour of their own.
    view: &'a View,
    /// The surface, for each layer of voxels.
    layers: Vec<Color>,
    /// The ground at the edge of the picture and in the middle.
    paper: [Color; 2],
    /// The light that unobstructed ground reflects.
    open_ground: Color,
}

impl<'a> Paint<'a> {
    fn new(view: &'a View) -> Self {
        let layers = view.all.size()[1];
        let glaze = |y: usize| color::glaze((y as f64 + 0.5) / layers as f64);
        Self {
            view,
            layers: (0..layers).map(glaze).collect(),
            paper: PAPER.map(color::from_srgb),
            open_ground: Light::open(1).reflected(1),
        }
    }

    /// The colour of a voxel.
    fn surface(&self, voxel: [usize; 3]) -> Color {
        if self.view.missed.get(voxel) {
            color::from_srgb(MISSED)
        } else if self.view.extra.get(voxel) {
            color::from_srgb(EXTRA)
        } else {
            self.layers[voxel[1]]
        }
    }

    /// The bare ground, lighter in the middle of the picture.
    fn paper(&self, x: usize, y: usize) -> Color {
        let [dx, dy] = [x as f64 / WIDTH as f64 - 0.5, y as f64 / HEIGHT as f64 - 0.5];
        let [edge, middle] = self.paper;
        color::mix(middle, edge, (2.0 * (dx * dx + dy * dy)).min(1.0))
    }
}

/// Paints pixels, and remembers the light that it has looked up.
struct Brush<'a> {
    scene: &'a Scene<'a>,
    camera: &'a Camera,
    paint: &'a Paint<'a>,
    probe: Probe,
    ground_probe: Probe,
    /// The lattice of the ground is coarser where voxels are tiny.
    ground_step: i32,
    seen: AHashMap<(usize, [i32; 3]), Light>,
    last: Option<(Patch, [Light; 4])>,
}

impl<'a> Brush<'a> {
    fn new(scene: &'a Scene<'a>, camera: &'a Camera, paint: &'a Paint<'a>) -> Self {
        // Small voxels on the picture need fewer directions, and a shorter reach.
        let count = (2.0 * camera.scale * camera.scale).clamp(8.0, 64.0) as usize;
        let (count, reach) =
            if camera.is_fine() { (4, 40.0) } else { (count, 0.5 * camera.longest) };
        let probe = Probe::new(count, reach);
        let (ground_count, across) = if camera.is_fine() { (64, 80.0) } else { (128, 128.0) };
        let ground_probe = Probe::new(ground_count, 0.5 * camera.longest);
        let ground_step = (camera.longest / across).ceil() as i32;
        let (seen, last) = (AHashMap::new(), None);
        Self { scene, camera, paint, probe, ground_probe, ground_step, seen, last }
    }

    /// The mean of the samples. If the outermost samples all see the same face, or all different
    /// ones, only these are taken. In a pixel far from voxels every sample sees the ground.
    fn pixel(&mut self, x: usize, y: usize, is_near: bool) -> Color {
        let part = |i: usize| (i as f64 + 0.5) / SAMPLES as f64;
        let look = |i: usize, j: usize| {
            let origin = self.camera.origin(x as f64 + part(i), y as f64 + part(j));
            let march = || self.scene.march(origin, Camera::AWAY, f64::INFINITY);
            (origin, if is_near { march() } else { None })
        };
        let last = SAMPLES - 1;
        let outer = [look(0, 0), look(last, 0), look(0, last), look(last, last)];
        let same =
            |(_, hit): &Sample| hit.as_ref().map(Hit::face) == outer[0].1.as_ref().map(Hit::face);
        let samples: Vec<Sample> = if self.camera.is_fine() || outer.iter().all(same) {
            outer.into()
        } else {
            (0..SAMPLES * SAMPLES).map(|i| look(i % SAMPLES, i / SAMPLES)).collect()
        };
        let paper = self.paint.paper(x, y);
        let share = 1.0 / samples.len() as f64;
        let colors = samples.into_iter().map(|s| color::scaled(self.color(s, paper), share));
        colors.fold([0.0; 3], color::plus)
    }

    fn color(&mut self, (origin, hit): Sample, paper: Color) -> Color {
        let point = |t: f64| [0, 1, 2].map(|i| origin[i] + t * Camera::AWAY[i]);
        if let Some(hit) = hit {
            let mut corner = hit.voxel;
            corner[hit.axis] += 1;
            let light = self.light(Patch { axis: hit.axis, corner }, 1, point(hit.t));
            let surface = self.paint.surface(hit.voxel.map(|x| x as usize));
            return color::times(surface, light.reflected(hit.axis));
        }
        let ground = point(origin[1]);
        let step = self.ground_step;
        let corner = ground.map(|x| (x / f64::from(step)).floor() as i32);
        let patch = Patch { axis: 1, corner: [corner[0], 0, corner[2]] };
        let light = self.light(patch, step, ground).reflected(1);
        color::times(paper, [0, 1, 2].map(|i| light[i] / self.paint.open_ground[i]))
    }

    /// The light at a point of a patch, interpolated between its corners.
    fn light(&mut self, patch: Patch, step: i32, point: [f64; 3]) -> Light {
        let lights = match self.last {
            Some((last, lights)) if last == patch => lights,
            _ => [0, 1, 2, 3].map(|i| self.corner(patch, i, step)),
        };
        self.last = Some((patch, lights));
        let along = |i: usize| point[i] / f64::from(step) - f64::from(patch.corner[i]);
        let (u, v) = (along((patch.axis + 1) % 3), along((patch.axis + 2) % 3));
        let [a, b, c, d] = lights;
        Light::mix(Light::mix(a, b, u), Light::mix(c, d, u), v)
    }

    fn corner(&mut self, patch: Patch, i: i32, step: i32) -> Light {
        let mut corner = patch.corner;
        corner[(patch.axis + 1) % 3] += i & 1;
        corner[(patch.axis + 2) % 3] += i >> 1;
        let (at, on_ground) =
            (corner.map(|x| f64::from(x * step)), patch.axis == 1 && corner[1] == 0);
        let step = f64::from(step);
        let probe = if on_ground { &self.ground_probe } else { &self.probe };
        let look = || probe.look(self.scene, patch.axis, at, step);
        *self.seen.entry((patch.axis, corner)).or_insert_with(look)
    }
}
