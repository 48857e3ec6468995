//! Marks that differ by shape, so that colour is not needed to tell them apart.

use super::Canvas;

/// A shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mark {
    Circle,
    Square,
    Diamond,
    Up,
    Down,
    Left,
    Right,
    Star,
    Pentagon,
    Hexagon,
    HourGlass,
    BowTie,
    Plus,
    Cross,
}

impl Mark {
    /// Draws it, filled or hollow.
    pub(crate) fn draw(self, canvas: &mut Canvas, at: [f64; 2], r: f64, color: &str, full: bool) {
        let fill = if full { color } else { "white" };
        match self {
            Self::Circle => canvas.circle(at, r, fill, color),
            _ => canvas.path(self.outline(at, r), fill, color, 1.3),
        }
    }

    /// Corners around the centre for the radius 1.
    fn corners(self) -> Vec<[f64; 2]> {
        let ring = |n: usize, r: f64, turn: f64| -> Vec<[f64; 2]> {
            let angle = |k: usize| (k as f64 / n as f64 + turn) * std::f64::consts::TAU;
            (0..n).map(|k| [r * angle(k).sin(), -r * angle(k).cos()]).collect()
        };
        let turned = |points: Vec<[f64; 2]>| points.into_iter().map(|[x, y]| [-y, x]).collect();
        match self {
            Self::Circle => ring(24, 1.0, 0.0),
            Self::Square => vec![[-0.9, -0.9], [0.9, -0.9], [0.9, 0.9], [-0.9, 0.9]],
            Self::Diamond => ring(4, 1.3, 0.0),
            Self::Up => ring(3, 1.3, 0.0),
            Self::Down => ring(3, 1.3, 0.5),
            Self::Left => ring(3, 1.3, 0.75),
            Self::Right => ring(3, 1.3, 0.25),
            Self::Pentagon => ring(5, 1.15, 0.0),
            Self::Hexagon => ring(6, 1.1, 0.0),
            Self::Star => {
                let (outer, inner) = (ring(5, 1.45, 0.0), ring(5, 0.62, 0.1));
                outer.into_iter().zip(inner).flat_map(|(a, b)| [a, b]).collect()
            }
            Self::HourGlass => vec![[-1.0, -1.1], [1.0, -1.1], [-1.0, 1.1], [1.0, 1.1]],
            Self::BowTie => turned(Self::HourGlass.corners()),
            Self::Plus => {
                let (a, b) = (0.36, 1.2);
                let quarter = [[-a, -b], [a, -b], [a, -a]];
                let turn = |[x, y]: [f64; 2], k| (0..k).fold([x, y], |[x, y], _| [-y, x]);
                (0..4).flat_map(|k| quarter.map(|p| turn(p, k))).collect()
            }
            Self::Cross => {
                let half = std::f64::consts::FRAC_1_SQRT_2;
                let eighth = |[x, y]: [f64; 2]| [half * (x - y), half * (x + y)];
                Self::Plus.corners().into_iter().map(eighth).collect()
            }
        }
    }

    fn outline(self, [x, y]: [f64; 2], r: f64) -> String {
        let points = self.corners().into_iter().map(|[dx, dy]| {
            let near = |x: f64| (x * 100.0).round() / 100.0;
            format!("{} {}", near(x + r * dx), near(y + r * dy))
        });
        format!("M{}Z", points.collect::<Vec<_>>().join("L"))
    }
}
