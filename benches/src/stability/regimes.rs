//! The regimes: the quantity that varies, its range, and the methods that are tested.

use fixed::types::{I16F16, I32F32};

use crate::accuracy::{
    Exam, contacts, ray_triangle, ray_triangle_peers, sweeps, triangle_box, triangle_box_peers,
};
use septum_kit::boxes::ObbNumbers;
use septum_kit::rays::RayCase;
use septum_kit::sweeps::SweepCase;
use septum_kit::{Case, Rng, Sample};

use super::{Step, boxes, contacts as sunk, rays, sweeps as ways};

/// The format of the varying quantity on the axis.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Ticks {
    /// Powers of ten with exponents divisible by this number.
    Ten(usize),
    /// Powers of two with exponents divisible by this number.
    Two(usize),
    /// Integers divisible by this number.
    Whole(usize),
    /// Zero and powers of four.
    Units,
}

/// One picture.
pub(super) struct Regime {
    pub(super) stem: &'static str,
    pub(super) title: &'static str,
    pub(super) axis: &'static str,
    pub(super) caption: &'static str,
    pub(super) ticks: Ticks,
    pub(super) steps: Vec<f64>,
    pub(super) panels: Vec<&'static str>,
    pub(super) exams: Vec<Exam<Step>>,
}

pub(super) const BOX: &str = "triangle and box";
pub(super) const RAY: &str = "ray and triangle";
pub(super) const SWEEP: &str = "box that moves past a triangle";
pub(super) const CONTACT: &str = "oriented boxes in each other";
pub(super) const BOX_WIDE: &str = "triangle and box, I32F32";
pub(super) const RAY_WIDE: &str = "ray and triangle, I32F32";

type Boxes<S> = fn(&mut Rng, f64) -> Option<Case<S>>;
type Sweeps<S> = fn(&mut Rng, f64) -> Option<SweepCase<S>>;
type Contacts<S> = fn(&mut Rng, f64) -> Option<[ObbNumbers<S>; 2]>;
type Rays<S> = fn(&mut Rng, f64) -> Option<RayCase<S>>;

impl Regime {
    pub(super) fn new(
        stem: &'static str,
        title: &'static str,
        axis: &'static str,
        ticks: Ticks,
        steps: Vec<f64>,
        caption: &'static str,
    ) -> Self {
        let (panels, exams) = (Vec::new(), Vec::new());
        Self { stem, title, axis, caption, ticks, steps, panels, exams }
    }

    /// Tests triangles and boxes at every step in the range of the scalar.
    fn boxes<S: Sample>(
        mut self,
        panel: &'static str,
        scalar: &'static str,
        make: Boxes<S>,
    ) -> Self {
        for step in self.steps_in(panel, |rng, at| make(rng, at).is_some()) {
            let ask = move |seed: u64, count: usize| {
                let rng = &mut seeded(seed, step.at);
                let cases: Vec<_> =
                    std::iter::repeat_with(|| make(rng, step.at)).take(count).collect();
                let cases: Vec<_> = cases.into_iter().flatten().collect();
                let mut all = triangle_box(scalar, &cases);
                all.extend(triangle_box_peers(scalar, &cases));
                all
            };
            self.exams.push(Exam { label: step, ask: Box::new(ask) });
        }
        self
    }

    /// The same for rays and triangles.
    fn rays<S: Sample>(mut self, panel: &'static str, scalar: &'static str, make: Rays<S>) -> Self {
        for step in self.steps_in(panel, |rng, at| make(rng, at).is_some()) {
            let ask = move |seed: u64, count: usize| {
                let rng = &mut seeded(seed, step.at);
                let cases: Vec<_> =
                    std::iter::repeat_with(|| make(rng, step.at)).take(count).collect();
                let cases: Vec<_> = cases.into_iter().flatten().collect();
                let mut all = ray_triangle(scalar, &cases);
                all.extend(ray_triangle_peers(scalar, &cases));
                all
            };
            self.exams.push(Exam { label: step, ask: Box::new(ask) });
        }
        self
    }

    /// The same for boxes that move past triangles.
    fn sweeps<S: Sample>(
        mut self,
        panel: &'static str,
        scalar: &'static str,
        make: Sweeps<S>,
    ) -> Self {
        for step in self.steps_in(panel, |rng, at| make(rng, at).is_some()) {
            let ask = move |seed: u64, count: usize| {
                let rng = &mut seeded(seed, step.at);
                let cases = std::iter::repeat_with(|| make(rng, step.at)).take(count);
                sweeps(scalar, &cases.flatten().collect::<Vec<_>>())
            };
            self.exams.push(Exam { label: step, ask: Box::new(ask) });
        }
        self
    }

    /// The same for overlapping oriented boxes.
    fn contacts<S: Sample>(mut self, scalar: &'static str, make: Contacts<S>) -> Self {
        for step in self.steps_in(CONTACT, |rng, at| make(rng, at).is_some()) {
            let ask = move |seed: u64, count: usize| {
                let rng = &mut seeded(seed, step.at);
                let cases = std::iter::repeat_with(|| make(rng, step.at)).take(count);
                contacts(scalar, &cases.flatten().collect::<Vec<_>>())
            };
            self.exams.push(Exam { label: step, ask: Box::new(ask) });
        }
        self
    }

    /// The steps that have cases.
    pub(super) fn steps_in(
        &mut self,
        panel: &'static str,
        is_held: impl Fn(&mut Rng, f64) -> bool,
    ) -> Vec<Step> {
        if !self.panels.contains(&panel) {
            self.panels.push(panel);
        }
        let held = |at: &f64| (0..20).any(|seed| is_held(&mut seeded(seed, *at), *at));
        let steps = self.steps.iter().copied().filter(held);
        steps.map(|at| Step { picture: self.stem, panel, at }).collect()
    }
}

/// A generator whose cases depend on the seed and the step.
pub(super) fn seeded(seed: u64, at: f64) -> Rng {
    Rng::new(seed ^ at.to_bits().rotate_left(17))
}

pub(super) fn tens(from: i32, to: i32, each: i32) -> Vec<f64> {
    let count = (to - from).abs() * each;
    let sign = f64::from((to - from).signum());
    let at = |k: i32| f64::from(from) + sign * f64::from(k) / f64::from(each);
    (0..=count).map(|k| 10_f64.powf(at(k))).collect()
}

/// All of them.
pub(super) fn all() -> Vec<Regime> {
    let regime = Regime::new;
    let in_floats_and_fixed = [
        regime(
            "sliver",
            "Slivers",
            "width of the triangle to its length",
            Ticks::Ten(1),
            tens(0, -12, 2),
            "Triangles get thinner from left to right, until their three vertices lie on a line \
             but for rounding.",
        )
        .boxes(BOX, "f32", boxes::sliver::<f32>)
        .boxes(BOX, "f64", boxes::sliver::<f64>)
        .boxes(BOX, "I16F16", boxes::sliver::<I16F16>)
        .rays(RAY, "f32", rays::sliver::<f32>)
        .rays(RAY, "f64", rays::sliver::<f64>)
        .rays(RAY, "I16F16", rays::sliver::<I16F16>),
        regime(
            "area",
            "Small triangles",
            "size of the triangle, where the box or the distance of the ray is about 1",
            Ticks::Ten(1),
            tens(0, -12, 2),
            "Triangles shrink from left to right, at the surface of a box, or on the way of a ray \
             that is aimed at them; in the end only a few numbers of the scalar lie between their \
             vertices.",
        )
        .boxes(BOX, "f32", boxes::small::<f32>)
        .boxes(BOX, "f64", boxes::small::<f64>)
        .boxes(BOX, "I16F16", boxes::small::<I16F16>)
        .rays(RAY, "f32", rays::small::<f32>)
        .rays(RAY, "f64", rays::small::<f64>)
        .rays(RAY, "I16F16", rays::small::<I16F16>),
        regime(
            "distance",
            "Far from the origin",
            "distance from the origin, where shapes are of a size of about 1",
            Ticks::Ten(1),
            tens(0, 8, 3),
            "The same random shapes, farther and farther away: their coordinates have ever fewer \
             places behind the point. I16F16 ends at 32,768.",
        )
        .boxes(BOX, "f32", boxes::far::<f32>)
        .boxes(BOX, "f64", boxes::far::<f64>)
        .boxes(BOX, "I16F16", boxes::far::<I16F16>)
        .rays(RAY, "f32", rays::far::<f32>)
        .rays(RAY, "f64", rays::far::<f64>)
        .rays(RAY, "I16F16", rays::far::<I16F16>),
        regime(
            "scale",
            "Scale",
            "size of everything",
            Ticks::Two(8),
            (-20..=20).map(|n| 4_f64.powi(n)).collect(),
            "The same random shapes at another scale. Rounding alone is the same at all scales: \
             what fails here has a fixed epsilon in it, overflows, or, in I16F16, runs out of \
             places.",
        )
        .boxes(BOX, "f32", boxes::scaled::<f32>)
        .boxes(BOX, "f64", boxes::scaled::<f64>)
        .boxes(BOX, "I16F16", boxes::scaled::<I16F16>)
        .rays(RAY, "f32", rays::scaled::<f32>)
        .rays(RAY, "f64", rays::scaled::<f64>)
        .rays(RAY, "I16F16", rays::scaled::<I16F16>),
        regime(
            "angle",
            "Nearly parallel",
            "sine of the angle between the ray and the plane of the triangle",
            Ticks::Ten(1),
            tens(0, -12, 2),
            "Rays come closer to the plane of the triangle from left to right, until only the \
             rounding of their own numbers keeps them out of it.",
        )
        .rays(RAY, "f32", rays::parallel::<f32>)
        .rays(RAY, "f64", rays::parallel::<f64>)
        .rays(RAY, "I16F16", rays::parallel::<I16F16>),
        regime(
            "graze",
            "Nearly grazing",
            "sine of the angle between the way and the plane of the triangle",
            Ticks::Ten(1),
            tens(0, -7, 2),
            "A box of a size of about 1 moves by 1 towards a wall, more and more along it from left \
             to right. A time that is late by more than one place of the scalar counts as a miss; \
             f64 is asked only whether. box3d-rust stops 0.005 before it touches, by design: its \
             false hits come of that.",
        )
        .sweeps(SWEEP, "f32", ways::graze::<f32>)
        .sweeps(SWEEP, "f64", ways::graze::<f64>)
        .sweeps(SWEEP, "I16F16", ways::graze::<I16F16>),
        regime(
            "sunk",
            "Hardly in each other",
            "how deep a box of a size of about 1 is in another",
            Ticks::Ten(1),
            tens(-1, -7, 2),
            "A box stands on a face of another, less and less deep in it from left to right. A depth that \
             is off by a thousandth, and more than a place, is wrong. The peer takes axes as a \
             quaternion, and so turns the boxes by a rounding.",
        )
        .contacts("f32", sunk::sunk::<f32>)
        .contacts("f64", sunk::sunk::<f64>)
        .contacts("I16F16", sunk::sunk::<I16F16>),
        regime(
            "touch",
            "Contact",
            "units from contact, on one side or the other; 0 is exact contact",
            Ticks::Units,
            std::iter::once(0.0).chain((0..=20).map(|n| 2_f64.powi(n))).collect(),
            "Shapes in whole numbers, of up to 24 bits in f32, 40 in f64 and 31 in I16F16, touch \
             exactly, at the left; then one of them is moved by whole numbers into the other or \
             away from it.",
        )
        .boxes(BOX, "f32", boxes::touch::<f32>)
        .boxes(BOX, "f64", boxes::touch::<f64>)
        .boxes(BOX, "I16F16", boxes::touch::<I16F16>)
        .rays(RAY, "f32", rays::edge::<f32>)
        .rays(RAY, "f64", rays::edge::<f64>)
        .rays(RAY, "I16F16", rays::edge::<I16F16>),
    ];
    let bits = regime(
        "bits",
        "Fixed point, from few bits to all",
        "bits of the coordinates, the sign not counted",
        Ticks::Whole(4),
        (1..=63).map(f64::from).collect(),
        "Random shapes with coordinates of so many bits, in units of the last place. Few: products \
         are rounded to nothing. Many: they wrap. The rounded methods are usable in between.",
    )
    .boxes(BOX, "I16F16", boxes::bits::<I16F16>)
    .boxes(BOX_WIDE, "I32F32", boxes::bits::<I32F32>)
    .rays(RAY, "I16F16", rays::bits::<I16F16>)
    .rays(RAY_WIDE, "I32F32", rays::bits::<I32F32>);
    in_floats_and_fixed.into_iter().chain([bits]).collect()
}
