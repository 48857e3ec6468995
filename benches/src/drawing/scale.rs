//! From numbers to pixels.

/// A logarithmic scale.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scale {
    pub(crate) values: [f64; 2],
    pub(crate) pixels: [f64; 2],
}

impl Scale {
    pub(crate) fn at(&self, x: f64) -> f64 {
        let [low, high] = self.values.map(f64::ln);
        let [from, to] = self.pixels;
        from + (x.ln() - low) / (high - low) * (to - from)
    }

    /// The powers of a base on it.
    pub(crate) fn powers(&self, base: f64) -> Vec<f64> {
        let [low, high] = self.values;
        let first = (low.log(base) - 1e-9).ceil() as i32;
        let last = (high.log(base) + 1e-9).floor() as i32;
        (first..=last).map(|n| base.powi(n)).collect()
    }
}

/// A logarithmic scale of rates per million, upwards, with a band for nought apart
/// from it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Zeroed {
    pub(crate) rates: Scale,
    /// Upper and lower end of the band.
    pub(crate) band: [f64; 2],
}

impl Zeroed {
    /// From `top` to `bottom`, with the band lowest. What lies between nought and the
    /// scale is drawn at its lower end.
    pub(crate) fn new(values: [f64; 2], [top, bottom]: [f64; 2], band: f64) -> Self {
        let rates = Scale { values, pixels: [bottom - band - 8.0, top] };
        Self { rates, band: [bottom - band, bottom] }
    }

    pub(crate) fn at(&self, rate: f64) -> f64 {
        if rate == 0.0 { self.zero() } else { self.rates.at(rate.max(self.rates.values[0])) }
    }

    /// The middle of the band.
    pub(crate) fn zero(&self) -> f64 {
        (self.band[0] + self.band[1]) / 2.0
    }
}

/// With a comma at every third digit.
pub(crate) fn grouped(n: f64) -> String {
    crate::shared::grouped(n.round() as u64)
}

/// A power as it is written.
pub(crate) fn power_of(base: u32, exponent: i32) -> String {
    format!("{base}{}", exponent.to_string().chars().map(raised).collect::<String>())
}

fn raised(c: char) -> char {
    match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        _ => c.to_digit(10).and_then(|d| char::from_u32(0x2070 + d)).unwrap_or(c),
    }
}

/// A factor in as few digits as it needs.
pub(crate) fn short(x: f64) -> String {
    if x >= 1.0 { format!("{x}") } else { format!("1/{}", (1.0 / x).round()) }
}
