//! Colours: linear light inside, sRGB in files.

/// Red, green and blue in linear light.
pub(crate) type Color = [f64; 3];

/// The colour of the surface, from foot (0) to top (1).
pub(crate) fn glaze(height: f64) -> Color {
    const STOPS: [[u8; 3]; 5] =
        [[38, 70, 120], [38, 128, 150], [96, 176, 140], [236, 190, 108], [232, 112, 84]];
    let at = height.clamp(0.0, 1.0) * (STOPS.len() - 1) as f64;
    let i = (at as usize).min(STOPS.len() - 2);
    mix(from_srgb(STOPS[i]), from_srgb(STOPS[i + 1]), at - i as f64)
}

pub(crate) fn mix(a: Color, b: Color, t: f64) -> Color {
    [0, 1, 2].map(|i| a[i] + (b[i] - a[i]) * t)
}

pub(crate) fn times(a: Color, b: Color) -> Color {
    [0, 1, 2].map(|i| a[i] * b[i])
}

pub(crate) fn scaled(a: Color, by: f64) -> Color {
    a.map(|x| x * by)
}

pub(crate) fn plus(a: Color, b: Color) -> Color {
    [0, 1, 2].map(|i| a[i] + b[i])
}

/// A colour from the bytes of a picture. IEC 61966-2-1.
pub(crate) fn from_srgb(bytes: [u8; 3]) -> Color {
    bytes.map(|b| {
        let x = f64::from(b) / 255.0;
        if x <= 0.04045 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) }
    })
}

/// The bytes of a picture from a colour.
pub(crate) fn to_srgb(color: Color) -> [u8; 3] {
    color.map(|x| {
        let x = x.clamp(0.0, 1.0);
        let x = if x <= 0.0031308 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 };
        (255.0 * x).round() as u8
    })
}
