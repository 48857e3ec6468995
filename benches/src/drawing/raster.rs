//! PNG files that stay small: few colours, and a palette of them.

use std::collections::HashMap;
use std::error::Error;

use png::{BitDepth, ColorType, Compression, Encoder};
use resvg::tiny_skia::Pixmap;

/// An opaque picture as a file with a palette: sixteen levels of each channel, so that the
/// edges of letters have few shades, and fewer if those are too many still.
pub(super) fn encode(pixels: &Pixmap) -> Result<Vec<u8>, Box<dyn Error>> {
    let mut fewer = None;
    for levels in [15, 7, 5, 3] {
        fewer = with_palette(pixels, levels);
        if fewer.is_some() {
            break;
        }
    }
    let (palette, places) = fewer.ok_or("too many colours")?;
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, pixels.width(), pixels.height());
    encoder.set_color(ColorType::Indexed);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::High);
    encoder.set_palette(palette);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&places)?;
    writer.finish()?;
    Ok(file)
}

/// The palette, and each pixel's place in it, if that many places are enough.
fn with_palette(pixels: &Pixmap, levels: u16) -> Option<(Vec<u8>, Vec<u8>)> {
    let near = |c: u8| ((u16::from(c) * levels + 127) / 255 * 255 / levels) as u8;
    let (mut palette, mut known) = (Vec::new(), HashMap::new());
    let mut places = Vec::with_capacity(pixels.pixels().len());
    for pixel in pixels.pixels() {
        let color = [pixel.red(), pixel.green(), pixel.blue()].map(near);
        let next = known.len();
        let place = *known.entry(color).or_insert(next);
        if place == next {
            palette.extend(color);
        }
        places.push(u8::try_from(place).ok()?);
    }
    Some((palette, places))
}
