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

/// A logarithmic scale of rates per million, upward, with a separate band for zero.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Zeroed {
    pub(crate) rates: Scale,
    /// Upper and lower end of the band.
    pub(crate) band: [f64; 2],
}

impl Zeroed {
    /// A scale from `top` to `bottom`, with the band lowest. Rates between zero and the scale are
    /// drawn at its lower end.
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
    septum_kit::jobs::grouped(n.round() as u64)
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

#[cfg(test)]
mod tests {
    use super::{Scale, Zeroed, power_of};

    #[test]
    fn zero_has_a_place_that_no_other_rate_has() {
        let y = Zeroed::new([10.0, 1e6], [100.0, 400.0], 40.0);
        assert!(y.band[0] < y.at(0.0) && y.at(0.0) < y.band[1]);
        for rate in [1e-9, 1.0, 10.0, 1e3, 1e6] {
            assert!(y.at(rate) < y.band[0], "{rate}");
        }
        assert_eq!(y.at(1e6), 100.0);
    }

    #[test]
    fn powers_are_on_the_scale_and_equally_far_apart() {
        let x = Scale { values: [0.2, 9.0], pixels: [0.0, 900.0] };
        assert_eq!(x.powers(2.0), [0.25, 0.5, 1.0, 2.0, 4.0, 8.0]);
        let apart = x.at(2.0) - x.at(1.0);
        assert!((x.at(8.0) - x.at(4.0) - apart).abs() < 1e-9);
        assert_eq!(power_of(10, -12), "10⁻¹²");
    }
}
