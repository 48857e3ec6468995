//! PNG files that stay small: a palette of the commonest colours.

use std::cmp::Reverse;
use std::collections::HashMap;
use std::error::Error;

use png::{BitDepth, ColorType, Compression, Encoder};
use resvg::tiny_skia::Pixmap;

type Color = [u8; 3];

/// An opaque picture as a file with a palette.
pub(super) fn encode(pixels: &Pixmap) -> Result<Vec<u8>, Box<dyn Error>> {
    // Sixteen levels of each channel: the edges of letters have few shades then.
    let near = |c: u8| ((u16::from(c) * 15 + 127) / 255 * 17) as u8;
    let colors: Vec<Color> =
        pixels.pixels().iter().map(|p| [p.red(), p.green(), p.blue()].map(near)).collect();
    let mut counts: HashMap<Color, usize> = HashMap::new();
    for color in &colors {
        *counts.entry(*color).or_default() += 1;
    }
    let mut palette: Vec<(Color, usize)> = counts.into_iter().collect();
    palette.sort_by_key(|&(color, count)| (Reverse(count), color));
    let rare = palette.split_off(palette.len().min(256));

    let mut places: HashMap<Color, u8> = HashMap::new();
    places.extend(palette.iter().zip(0..=255).map(|((color, _), place)| (*color, place)));
    for (color, _) in rare {
        let nearest = palette.iter().min_by_key(|(known, _)| distance(&color, known));
        let (known, _) = nearest.expect("there are colours");
        places.insert(color, places[known]);
    }

    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, pixels.width(), pixels.height());
    encoder.set_color(ColorType::Indexed);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::High);
    encoder.set_palette(palette.iter().flat_map(|(color, _)| *color).collect::<Vec<u8>>());
    let data: Vec<u8> = colors.iter().map(|color| places[color]).collect();
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&data)?;
    writer.finish()?;
    Ok(file)
}

fn distance(a: &Color, b: &Color) -> u32 {
    a.iter().zip(b).map(|(a, b)| u32::from(a.abs_diff(*b)).pow(2)).sum()
}
