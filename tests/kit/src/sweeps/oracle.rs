//! The oracle for sweeps. It clips, where the crate looks for separating axes.
//!
//! A point of the triangle at some time is u·a + v·b + w·c + s·d, with u, v, w ≥ 0 and 0 ≤ s ≤ u +
//! v + w, up to a positive factor: a cone in four dimensions over a prism. The oracle clips it by
//! the six half-spaces of the box, as a list of extreme rays (the double description of T. S.
//! Motzkin, H. Raiffa, G. L. Thompson, R. M. Thrall, 1953). Two rays on opposite sides of a
//! half-space make a new ray if they are adjacent; they are adjacent if no other ray lies in all
//! planes that contain both. The least s/(u + v + w) of the remaining rays is the time of impact.

use dashu_int::IBig;
use dashu_int::ops::{BitTest, Gcd};
use septum::Axis;

use crate::exact::{Parts, least_exponent, whole};
use crate::flat::Truth;
use crate::lattice::Ring;
use crate::sample::Sample;
use crate::{Each, case::BoxNumbers, three};

type Point = [IBig; 3];

/// A quotient that is not negative.
#[derive(Clone, Debug)]
pub struct Quotient {
    num: IBig,
    den: IBig,
}

impl Quotient {
    fn is_below(&self, other: &Self) -> bool {
        &self.num * &other.den < &other.num * &self.den
    }

    fn is_above_one(&self) -> bool {
        self.num > self.den
    }

    fn is_at_least<S: Sample>(&self, t: S) -> bool {
        let (m, e) = t.mantissa_exponent();
        let up = |x: IBig, e: i32| x << e.max(0) as usize;
        up(IBig::from(m) * &self.den, e) <= up(self.num.clone(), -e)
    }

    /// Whether the quotient, rounded down, is `t`.
    pub fn rounds_down_to<S: Sample>(&self, t: S) -> bool {
        let next = t.moved(1);
        self.is_at_least(t) && (next == t || !self.is_at_least(next))
    }
}

/// The first contact.
#[derive(Clone, Debug)]
pub struct Contact {
    pub time: Quotient,
    /// The axes that separate at the start, each with the time at which it stops separating.
    pub axes: Vec<(Axis, Quotient)>,
}

impl Contact {
    /// The first axis whose time rounds down to this number.
    pub fn witness<S: Sample>(&self, t: S) -> Option<Axis> {
        self.axes.iter().find(|(_, time)| time.rounds_down_to(t)).map(|&(axis, _)| axis)
    }
}

/// The triangle, the box by its least and greatest corner, and the motion, in integers.
pub(super) struct Shapes {
    vertices: [Point; 3],
    corners: [Point; 2],
    d: Point,
}

fn corners(numbers: &BoxNumbers<IBig>) -> [Point; 2] {
    match numbers {
        BoxNumbers::Center(c, h) => [IBig::difference(c, h), three(|i: usize| &c[i] + &h[i])],
        BoxNumbers::Corners(min, max) => [min.clone(), max.clone()],
    }
}

fn numbers_of(numbers: &BoxNumbers<Parts>, unit: i32) -> BoxNumbers<IBig> {
    let of = |p: &[Parts; 3]| p.each(|x| whole(x, unit));
    match numbers {
        BoxNumbers::Center(c, h) => BoxNumbers::Center(of(c), of(h)),
        BoxNumbers::Corners(min, max) => BoxNumbers::Corners(of(min), of(max)),
    }
}

fn rows(numbers: &BoxNumbers<Parts>) -> [[Parts; 3]; 2] {
    match *numbers {
        BoxNumbers::Center(a, b) | BoxNumbers::Corners(a, b) => [a, b],
    }
}

impl Shapes {
    pub(super) fn new(
        vertices: [[Parts; 3]; 3],
        aabb: BoxNumbers<Parts>,
        way: [[Parts; 3]; 2],
    ) -> Self {
        let all = [&vertices[..], &rows(&aabb), &way].concat();
        let unit = least_exponent(all.as_flattened());
        let number = |x: Parts| whole(x, unit);
        let [from, to] = way.each(|p| p.each(number));
        Self {
            vertices: vertices.each(|p| p.each(number)),
            corners: corners(&numbers_of(&aabb, unit)),
            d: IBig::difference(&to, &from),
        }
    }

    pub(super) fn contact(&self) -> Option<Contact> {
        let time = self.first_time()?;
        let axes = Axis::ALL.iter().filter_map(|&axis| Some((axis, self.time_on(axis)?)));
        Some(Contact { time, axes: axes.collect() })
    }

    /// The nearest relation at any time of the motion. The relative interiors meet if the shapes
    /// still meet after shrinking a little: see `contact::truth`.
    pub(super) fn relation(&self) -> Truth {
        relation(|shapes| shapes.first_time().is_some(), self, &Self::shrunk(self))
    }

    fn shrunk(&self) -> Self {
        let all = self.vertices.iter().chain(&self.corners).chain([&self.d]);
        let one = IBig::ONE << (3 * longest(all) + 64);
        let sum = |i: usize| -> IBig { self.vertices.iter().map(|v| &v[i]).sum() };
        let less: IBig = (&one - IBig::ONE) * IBig::from(6);
        let vertex = |v: &Point| three(|i: usize| &v[i] * &less + sum(i) * IBig::from(2));
        Self {
            vertices: self.vertices.each_ref().each(vertex),
            corners: shrunk_box(&self.corners, &one),
            d: self.d.each_ref().each(|x| x * &one * IBig::from(6)),
        }
    }

    /// The six half-spaces as forms of u, v, w and s that are not negative inside.
    fn half_spaces(&self) -> Vec<[IBig; 4]> {
        let [min, max] = &self.corners;
        let mut forms = Vec::with_capacity(6);
        for i in 0..3 {
            let [a, b, c] = &self.vertices;
            forms.push([&a[i] - &min[i], &b[i] - &min[i], &c[i] - &min[i], self.d[i].clone()]);
            forms.push([&max[i] - &a[i], &max[i] - &b[i], &max[i] - &c[i], -&self.d[i]]);
        }
        forms
    }

    fn first_time(&self) -> Option<Quotient> {
        let mut rays = prism();
        for (plane, form) in self.half_spaces().iter().enumerate() {
            rays = cut(rays, form, 5 + plane);
        }
        let times = rays.into_iter().map(|Ray { x: [u, v, w, s], .. }| {
            let sum = u + v + w;
            Quotient { num: s, den: sum }
        });
        times.reduce(|a, b| if b.is_below(&a) { b } else { a })
    }

    /// By the definition: projects vertices and corners on the axis.
    fn time_on(&self, axis: Axis) -> Option<Quotient> {
        let unit = |k: u8| three(|i| IBig::from(i == usize::from(k)));
        let edge = |k: usize| IBig::difference(&self.vertices[(k + 1) % 3], &self.vertices[k]);
        let vector = match axis {
            Axis::Face(i) => unit(i),
            Axis::Normal => IBig::cross(&edge(0), &edge(1)),
            Axis::Edge { axis, edge: k } => IBig::cross(&unit(axis), &edge(k.into())),
        };
        let vertices = self.vertices.each_ref().each(|v| IBig::dot(&vector, v));
        let corners: Vec<IBig> = (0..8)
            .map(|k| {
                let corner = three(|i: usize| self.corners[k >> i & 1][i].clone());
                IBig::dot(&vector, &corner)
            })
            .collect();
        let way = IBig::dot(&vector, &self.d);
        let ends = |x: &[IBig]| {
            let (mut low, mut high) = (x[0].clone(), x[0].clone());
            for x in x {
                low = if *x < low { x.clone() } else { low };
                high = if *x > high { x.clone() } else { high };
            }
            [low, high]
        };
        let ([low, high], [least, greatest]) = (ends(&vertices), ends(&corners));
        let (above, below) = (low - greatest, least - high);
        if above > IBig::ZERO {
            Some(Quotient { num: above, den: -way })
        } else if below > IBig::ZERO {
            Some(Quotient { num: below, den: way })
        } else {
            None
        }
    }
}

/// An extreme ray of a cone, and a bit for each plane that contains it.
#[derive(Clone)]
struct Ray {
    x: [IBig; 4],
    planes: u32,
}

/// The whole triangle at all times. Planes 0 to 2 are u, v, w = 0, plane 3 is the start, plane 4
/// the end.
fn prism() -> Vec<Ray> {
    let ray = |k: usize, is_end: bool| {
        let x = [0, 1, 2, 3].each(|i: usize| IBig::from(i == k || i == 3 && is_end));
        Ray { x, planes: 0b111 & !(1 << k) | if is_end { 0b10000 } else { 0b01000 } }
    };
    (0..6).map(|n| ray(n % 3, n >= 3)).collect()
}

fn cut(mut rays: Vec<Ray>, form: &[IBig; 4], plane: usize) -> Vec<Ray> {
    let value = |ray: &Ray| -> IBig { (0..4).map(|i| &ray.x[i] * &form[i]).sum() };
    let values: Vec<IBig> = rays.iter().map(value).collect();
    let mut new = Vec::new();
    for (p, above) in values.iter().enumerate().filter(|(_, x)| **x > IBig::ZERO) {
        for (n, below) in values.iter().enumerate().filter(|(_, x)| **x < IBig::ZERO) {
            let common = rays[p].planes & rays[n].planes;
            let holds = |k: usize| k != p && k != n && rays[k].planes & common == common;
            if (0..rays.len()).any(holds) {
                continue;
            }
            let x = [0, 1, 2, 3].each(|i: usize| above * &rays[n].x[i] - below * &rays[p].x[i]);
            new.push(Ray { x: reduced(x), planes: common | 1 << plane });
        }
    }
    let mut k = 0;
    rays.retain_mut(|ray| {
        let sign = values[k].cmp(&IBig::ZERO);
        k += 1;
        if sign.is_eq() {
            ray.planes |= 1 << plane;
        }
        sign.is_ge()
    });
    rays.extend(new);
    rays
}

/// The same ray in the least integers.
fn reduced(x: [IBig; 4]) -> [IBig; 4] {
    let factor = x.iter().fold(IBig::ZERO, |g, x| match (&g, x) {
        (g, x) if *g == IBig::ZERO => x.clone(),
        (g, x) if *x == IBig::ZERO => g.clone(),
        (g, x) => IBig::from(g.gcd(x)),
    });
    let factor = if factor < IBig::ZERO { -factor } else { factor };
    x.each(|x| x / &factor)
}

fn longest<'a>(all: impl Iterator<Item = &'a Point>) -> usize {
    all.flatten().map(BitTest::bit_len).max().unwrap_or(0)
}

fn relation<T>(meet: impl Fn(&T) -> bool, shapes: &T, shrunk: &T) -> Truth {
    match (meet(shapes), meet(shrunk)) {
        (false, _) => Truth::Apart,
        (true, false) => Truth::Touching,
        (true, true) => Truth::Overlapping,
    }
}

/// A box shrunk about its centre by a factor of 1 − 1/`one`, in units of 1/(6·`one`).
fn shrunk_box([min, max]: &[Point; 2], one: &IBig) -> [Point; 2] {
    let whole = one * IBig::from(6);
    let less = |i: usize| (&max[i] - &min[i]) * IBig::from(3);
    let (min, max) = (|i: usize| &min[i] * &whole + less(i), |i: usize| &max[i] * &whole - less(i));
    [three(min), three(max)]
}

/// Two boxes, of which the first moves, and its motion, in integers.
pub(super) struct Boxes {
    a: [Point; 2],
    b: [Point; 2],
    d: Point,
}

impl Boxes {
    pub(super) fn new(boxes: [BoxNumbers<Parts>; 2], way: [[Parts; 3]; 2]) -> Self {
        let [a, b] = &boxes;
        let all = [&rows(a)[..], &rows(b), &way].concat();
        let unit = least_exponent(all.as_flattened());
        let [a, b] = [a, b].each(|numbers| corners(&numbers_of(numbers, unit)));
        let [from, to] = way.each(|p| p.each(|x| whole(x, unit)));
        Self { a, b, d: IBig::difference(&to, &from) }
    }

    /// As [`Shapes::relation`].
    pub(super) fn relation(&self) -> Truth {
        let one = IBig::ONE << (3 * longest(self.a.iter().chain(&self.b).chain([&self.d])) + 64);
        let [a, b] = [&self.a, &self.b].each(|corners| shrunk_box(corners, &one));
        let d = self.d.each_ref().each(|x| x * &one * IBig::from(6));
        relation(|boxes| boxes.contact().is_some(), self, &Self { a, b, d })
    }

    /// The first contact: on each coordinate axis the boxes meet during an interval of time.
    pub(super) fn contact(&self) -> Option<Contact> {
        contact(&self.a, &self.b, &self.d)
    }
}

fn contact(a: &[Point; 2], b: &[Point; 2], d: &Point) -> Option<Contact> {
    let mut axes = Vec::new();
    let mut ends = Vec::new();
    for i in 0..3 {
        let d = d[i].clone();
        let (to_meet, to_leave) = (&b[0][i] - &a[1][i], &b[1][i] - &a[0][i]);
        let (near, far, speed) =
            if d < IBig::ZERO { (-to_leave, -to_meet, -d) } else { (to_meet, to_leave, d) };
        if far < IBig::ZERO || speed == IBig::ZERO && near > IBig::ZERO {
            return None;
        }
        if near > IBig::ZERO {
            axes.push((Axis::Face(i as u8), Quotient { num: near, den: speed.clone() }));
        }
        if speed > IBig::ZERO {
            ends.push(Quotient { num: far, den: speed });
        }
    }
    let start = Quotient { num: IBig::ZERO, den: IBig::ONE };
    let later = |a: Quotient, b: &Quotient| if a.is_below(b) { b.clone() } else { a };
    let time = axes.iter().fold(start, |time, (_, entry)| later(time, entry));
    let is_over = time.is_above_one() || ends.iter().any(|end| end.is_below(&time));
    (!is_over).then_some(Contact { time, axes })
}
