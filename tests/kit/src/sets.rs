//! The sets of cases on which accuracy is measured, each from a seed. Half of the cases give the
//! box by centre and half-extents, and half by its corners.

use super::case::{BoxNumbers, Case};
use super::flip::flip;
use super::rng::Rng;
use super::sample::Sample;
use super::touch::nudged_touch;
use crate::Each;

/// A kind of case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Set {
    /// Vertices uniform in a cube of side 4, boxes of any size up to 2.
    Random,
    /// Integers from −4 to 4.
    Grid,
    /// One vertex within three units in the last place of the line through the other two; the box
    /// is near that line.
    Slivers,
    /// As random, 10⁴ to 10⁶ from the origin.
    Far,
    /// Segments and points; some boxes are flat or points too.
    Degenerate,
    /// In exact contact, then one number is moved by one unit in the last place, or not.
    Touch,
    /// As random, times 2⁻¹⁴.
    Small,
    /// At the ends of the scalar's range, the extremes themselves included.
    Huge,
    /// One coordinate on either side of the point where the exact verdict flips.
    Flip,
}

impl Set {
    /// All sets.
    pub const ALL: [Self; 9] = [
        Self::Random,
        Self::Grid,
        Self::Slivers,
        Self::Far,
        Self::Degenerate,
        Self::Touch,
        Self::Small,
        Self::Huge,
        Self::Flip,
    ];

    /// The name of the set.
    pub fn name(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::Grid => "grid",
            Self::Slivers => "slivers",
            Self::Far => "far",
            Self::Degenerate => "degenerate",
            Self::Touch => "touch",
            Self::Small => "small",
            Self::Huge => "huge",
            Self::Flip => "flip",
        }
    }

    /// The reason why the scalar cannot hold this set, if it cannot.
    pub fn misfit<S: Sample>(self) -> Option<&'static str> {
        match self {
            Self::Far if S::nearest(2e4).approximate() != 2e4 => Some("ends before 10⁴"),
            Self::Small if S::nearest(SMALL) == S::ZERO => Some("rounds 2⁻¹⁴ to zero"),
            _ => None,
        }
    }

    /// `count` cases, the same for the same seed.
    pub fn cases<S: Sample>(self, seed: u64, count: usize) -> Vec<Case<S>> {
        let rng = &mut Rng::new(seed ^ (self as u64) << 56);
        let mut cases = Vec::with_capacity(count + 1);
        while cases.len() < count {
            match self {
                Self::Random => cases.push(random(rng, [0.0; 3], 1.0)),
                Self::Grid => cases.push(grid(rng)),
                Self::Slivers => cases.push(sliver(rng)),
                Self::Far => cases.push(far(rng)),
                Self::Degenerate => cases.push(degenerate(rng)),
                Self::Touch => cases.push(nudged_touch(rng)),
                Self::Small => cases.push(random(rng, [0.0; 3], SMALL)),
                Self::Huge => cases.push(huge(rng)),
                Self::Flip => {
                    let base = if rng.one_in(2) { sliver(rng) } else { random(rng, [0.0; 3], 1.0) };
                    if let Some(both) = flip(rng, base) {
                        cases.extend(both);
                    }
                }
            }
        }
        cases.truncate(count);
        cases
    }
}

const SMALL: f64 = 1.0 / 16384.0;

/// The box around `center`, in one form or the other, rounded to the scalar.
fn aabb<S: Sample>(rng: &mut Rng, center: [f64; 3], half: [f64; 3]) -> BoxNumbers<S> {
    if rng.one_in(2) {
        return BoxNumbers::Center(center.each(S::nearest), half.each(S::nearest));
    }
    let corner = |sign: f64| core::array::from_fn(|i| S::nearest(center[i] + sign * half[i]));
    BoxNumbers::Corners(corner(-1.0), corner(1.0))
}

fn random_box<S: Sample>(rng: &mut Rng, origin: [f64; 3], scale: f64) -> BoxNumbers<S> {
    let offset = rng.triple(|rng| rng.real(-1.0, 1.0) * scale);
    let half = rng.triple(|rng| rng.real(0.0, 1.0) * scale);
    aabb(rng, core::array::from_fn(|i| origin[i] + offset[i]), half)
}

fn random<S: Sample>(rng: &mut Rng, origin: [f64; 3], scale: f64) -> Case<S> {
    let vertices = [(); 3].each(|()| {
        let offset = rng.triple(|rng| rng.real(-2.0, 2.0) * scale);
        core::array::from_fn(|i| S::nearest(origin[i] + offset[i]))
    });
    Case { vertices, aabb: random_box(rng, origin, scale) }
}

fn grid<S: Sample>(rng: &mut Rng) -> Case<S> {
    let mut point = || rng.triple(|rng| rng.whole(-4, 4) as f64);
    let vertices = [point(), point(), point()].each(|v| v.each(S::nearest));
    let (p, q) = (point(), point());
    let aabb = if rng.one_in(2) {
        BoxNumbers::Center(p.each(S::nearest), q.each(|x| S::nearest(x.abs())))
    } else {
        let corner = |of: fn(f64, f64) -> f64| core::array::from_fn(|i| S::nearest(of(p[i], q[i])));
        BoxNumbers::Corners(corner(f64::min), corner(f64::max))
    };
    Case { vertices, aabb }
}

fn sliver<S: Sample>(rng: &mut Rng) -> Case<S> {
    let mut point = || rng.triple(|rng| rng.real(-2.0, 2.0));
    let (a, b) = (point(), point());
    let mut on_line = || {
        let along = rng.real(-0.5, 1.5);
        core::array::from_fn(|i| a[i] + along * (b[i] - a[i]))
    };
    let (c, near) = (on_line(), on_line());
    let width = rng.whole(0, 3);
    let c = c.each(|x| S::nearest(x).moved(rng.whole(-width, width)));
    let mut vertices = [a.each(S::nearest), b.each(S::nearest), c];
    vertices.rotate_left(rng.below(3));
    Case { vertices, aabb: random_box(rng, near, 0.25) }
}

fn far<S: Sample>(rng: &mut Rng) -> Case<S> {
    let most = (S::GREATEST.approximate() - 4.0).min(1e6);
    let origin = rng.triple(|rng| {
        let distance = 10_f64.powf(rng.real(4.0, most.log10()));
        if rng.one_in(2) { -distance } else { distance }
    });
    random(rng, origin, 1.0)
}

fn degenerate<S: Sample>(rng: &mut Rng) -> Case<S> {
    let Case { mut vertices, aabb } = random(rng, [0.0; 3], 1.0);
    match rng.below(4) {
        0 => vertices = [vertices[0]; 3],
        1 => vertices[1] = vertices[0],
        2 => vertices[2] = vertices[1],
        // Three different points of a line: multiples of one short step, exact.
        _ => {
            let bits = S::WHOLE_BITS.min(20);
            let start = rng.triple(|rng| rng.whole(-1 << (bits - 2), 1 << (bits - 2)));
            let step = rng.triple(|rng| rng.whole(-1 << (bits - 4), 1 << (bits - 4)));
            vertices = [(); 3].each(|()| {
                let times = rng.whole(-4, 4);
                core::array::from_fn(|i| S::whole(start[i] + times * step[i]))
            });
            // A box around one of the points, because others would seldom meet it.
            let (at, size) = (rng.below(3), rng.whole(0, 1 << (bits - 2)));
            let center = vertices[at].each(|x| x.moved(rng.whole(-size, size)));
            let half = rng.triple(|rng| S::whole(rng.whole(0, size)));
            return Case { vertices, aabb: BoxNumbers::Center(center, half) };
        }
    }
    let mut flat = Case { vertices, aabb };
    while rng.one_in(3) {
        let i = rng.below(3);
        flat.aabb = match flat.aabb {
            BoxNumbers::Center(c, mut h) => {
                h[i] = S::ZERO;
                BoxNumbers::Center(c, h)
            }
            BoxNumbers::Corners(min, mut max) => {
                max[i] = min[i];
                BoxNumbers::Corners(min, max)
            }
        };
    }
    flat
}

fn huge<S: Sample>(rng: &mut Rng) -> Case<S> {
    // Over the whole range, or close together in one of its corners.
    let corner = rng.one_in(4).then(|| rng.triple(|rng| rng.one_in(2)));
    let number = |rng: &mut Rng, i: usize| {
        let up = corner.map_or_else(|| rng.one_in(2), |corner| corner[i]);
        let end = if up { S::GREATEST } else { S::LEAST };
        match (rng.below(8), corner) {
            (0, _) => end,
            (_, Some(_)) => end.moved(if up { -1 } else { 1 } * rng.whole(0, 64)),
            (1, _) => S::ZERO,
            (2, _) => end.moved(if up { -1 } else { 1 } * rng.whole(0, 2)),
            _ => S::nearest(end.approximate() * rng.real(0.0, 1.0)),
        }
    };
    let point = |rng: &mut Rng| [number(rng, 0), number(rng, 1), number(rng, 2)];
    let vertices = [point(rng), point(rng), point(rng)];
    let (p, q) = (point(rng), point(rng));
    let aabb = if rng.one_in(2) {
        let magnitude = |x: S| if x < S::ZERO { S::from_ordinal(-x.moved(1).ordinal()) } else { x };
        let few = corner.map(|_| rng.triple(|rng| S::ZERO.moved(rng.whole(0, 64))));
        BoxNumbers::Center(p, few.unwrap_or(q.each(magnitude)))
    } else {
        let least = core::array::from_fn(|i| if p[i] < q[i] { p[i] } else { q[i] });
        let greatest = core::array::from_fn(|i| if p[i] < q[i] { q[i] } else { p[i] });
        BoxNumbers::Corners(least, greatest)
    };
    Case { vertices, aabb }
}
