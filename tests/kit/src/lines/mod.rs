//! Lines against boxes. The oracle clips the range of t slab by slab, in fractions of integers (Y.
//! Liang, B. Barsky, *ACM TOG* 3(1), 1984); the crate compares slabs in pairs and forms no
//! fraction.

mod oriented;
mod sets;

use dashu_int::IBig;
use dashu_int::ops::Abs;
use septum::{Aabb, Ray, Segment};

use crate::exact::{Parts, least_exponent, whole};
use crate::lattice::Ring;
use crate::{BoxNumbers, Each, Sample, three};

pub use oriented::LineObb;
pub use sets::LineSet;

/// A line: origin and direction with a range of t, two ends, centre and half-vector.
#[derive(Clone, Copy, Debug)]
pub enum Line<S> {
    Ray([S; 3], [S; 3], [Option<S>; 2]),
    Ends([S; 3], [S; 3]),
    Center([S; 3], [S; 3]),
}

/// A line and a box.
#[derive(Clone, Copy, Debug)]
pub struct LineBox<S> {
    pub line: Line<S>,
    pub aabb: BoxNumbers<S>,
}

/// A fraction; the denominator is above zero.
#[derive(Clone, Debug)]
pub struct Fraction(pub IBig, pub IBig);

impl Fraction {
    fn new(num: IBig, den: IBig) -> Self {
        if den < IBig::ZERO { Self(-num, -den) } else { Self(num, den) }
    }
    fn exceeds(&self, other: &Self) -> bool {
        &self.0 * &other.1 > &other.0 * &self.1
    }
    /// Whether it is greater than the scalar.
    pub fn exceeds_number<S: Sample>(&self, x: S) -> bool {
        self.exceeds_parts(x.mantissa_exponent())
    }
    fn exceeds_parts(&self, (m, e): Parts) -> bool {
        let (up, down) = (e.max(0) as usize, (-e).max(0) as usize);
        (&self.0 << down) > ((IBig::from(m) * &self.1) << up)
    }
    /// Whether `x` is within n/d units in the last place, measured on the side of the true value.
    pub fn is_within<S: Sample>(&self, x: S, bound: (i64, i64)) -> bool {
        self.is_within_parts([-1, 0, 1].each(|steps| x.moved(steps).mantissa_exponent()), bound)
    }
    fn is_within_parts(&self, neighbours: [Parts; 3], (n, d): (i64, i64)) -> bool {
        let [below, x, above] = neighbours.each(|(m, e)| IBig::from(m) << (e + 1100) as usize);
        let gap = (&self.0 << 1100) - &x * &self.1;
        let beside = [(below - &x).abs(), (above - &x).abs()];
        let towards = usize::from(gap >= IBig::ZERO);
        // Beyond the greatest number there is no neighbour.
        let at_the_end = beside[towards] == IBig::ZERO;
        let unit = &beside[if at_the_end { 1 - towards } else { towards }];
        gap.abs() * IBig::from(d) <= unit * &self.1 * IBig::from(n)
    }
    /// The nearest value of a fixed-point type, the even one of two, or the extreme.
    pub fn nearest_fixed<S: Sample>(&self) -> S {
        let ends = [S::LEAST, S::GREATEST].each(S::ordinal);
        S::from_ordinal(self.nearest_ordinal(-S::ZERO.mantissa_exponent().1, ends))
    }
    fn nearest_ordinal(&self, places: i32, [least, greatest]: [i64; 2]) -> i64 {
        let double = (&self.0 << (places + 1) as usize) + &self.1;
        let den = &self.1 * IBig::from(2);
        let mut q = &double / &den;
        if &q * &den > double {
            q -= 1; // towards −∞, not zero
        }
        // A tie was rounded up.
        if &q * &den == double && &q % IBig::from(2) != IBig::ZERO {
            q -= 1;
        }
        i64::try_from(q.clamp(least.into(), greatest.into())).unwrap()
    }
}

impl<S: Sample> Line<S> {
    /// The ray, if the line is a valid ray.
    pub fn ray(&self) -> Option<Ray<S>> {
        let Self::Ray(o, d, [from, to]) = *self else { return None };
        Ray::new(o, d).ok()?.with_range(from, to).ok()
    }

    /// The segment, if the line is a valid segment.
    pub fn segment(&self) -> Option<Segment<S>> {
        match *self {
            Self::Ray(..) => None,
            Self::Ends(a, b) => Segment::new(a, b).ok(),
            Self::Center(c, w) => Segment::from_center_half_vector(c, w).ok(),
        }
    }

    fn parts(&self) -> Line<Parts> {
        let parts = |p: [S; 3]| p.each(S::mantissa_exponent);
        match *self {
            Self::Ray(o, d, t) => {
                Line::Ray(parts(o), parts(d), t.each(|t| t.map(S::mantissa_exponent)))
            }
            Self::Ends(a, b) => Line::Ends(parts(a), parts(b)),
            Self::Center(c, w) => Line::Center(parts(c), parts(w)),
        }
    }
}

/// Origin, direction and range of t.
type Whole = ([IBig; 3], [IBig; 3], [Option<Fraction>; 2]);

impl Line<Parts> {
    /// All of its numbers.
    fn numbers(&self) -> impl Iterator<Item = Parts> {
        let (Self::Ray(a, b, _) | Self::Ends(a, b) | Self::Center(a, b)) = *self;
        let ends = if let Self::Ray(.., ends) = *self { ends } else { [None; 2] };
        a.into_iter().chain(b).chain(ends.into_iter().flatten())
    }

    /// The line in units of 2^unit; t counts in ones.
    fn whole(&self, unit: i32) -> Whole {
        let vector = |p: [Parts; 3]| p.each(|x| whole(x, unit));
        let number = |n: i8| Some(Fraction(n.into(), IBig::ONE));
        match *self {
            Self::Ray(o, d, ends) => {
                let one = IBig::ONE << (-unit) as usize;
                let end = |t: Option<Parts>| t.map(|t| Fraction(whole(t, unit), one.clone()));
                (vector(o), vector(d), ends.each(end))
            }
            Self::Ends(a, b) => {
                let (a, b) = (vector(a), vector(b));
                let d = IBig::difference(&b, &a);
                (a, d, [number(0), number(1)])
            }
            Self::Center(c, w) => (vector(c), vector(w), [number(-1), number(1)]),
        }
    }
}

impl<S: Sample> LineBox<S> {
    pub fn aabb(&self) -> Aabb<S> {
        self.aabb.shape().expect("a valid box")
    }

    pub fn ray(&self) -> Option<Ray<S>> {
        matches!(self.line, Line::Ray(..)).then(|| self.line.ray().expect("a ray"))
    }

    pub fn segment(&self) -> Option<Segment<S>> {
        self.line.segment()
    }

    /// The crate's verdict.
    pub fn overlaps(&self) -> bool {
        let aabb = self.aabb();
        self.ray().map_or_else(|| self.segment().unwrap().overlaps(&aabb), |r| r.overlaps(&aabb))
    }

    pub fn may_overlap(&self) -> bool {
        let aabb = self.aabb();
        self.ray()
            .map_or_else(|| self.segment().unwrap().may_overlap(&aabb), |r| r.may_overlap(&aabb))
    }

    /// Both ends of the part of the line inside the box, if there is one; an end is `None` if it is
    /// unbounded.
    pub fn clip(&self) -> Option<[Option<Fraction>; 2]> {
        LineBox { line: self.line.parts(), aabb: self.aabb.map(S::mantissa_exponent) }
            .clip_in_parts()
    }

    pub fn meets(&self) -> bool {
        self.clip().is_some()
    }

    /// The faces on which both ends of the clipped line lie.
    pub fn faces(&self) -> Option<[Option<u8>; 2]> {
        let of = LineBox { line: self.line.parts(), aabb: self.aabb.map(S::mantissa_exponent) };
        faces(&of.frame())
    }
}

impl LineBox<Parts> {
    fn clip_in_parts(&self) -> Option<[Option<Fraction>; 2]> {
        clip(self.frame())
    }

    fn frame(&self) -> InFrame {
        let (BoxNumbers::Center(p, q) | BoxNumbers::Corners(p, q)) = self.aabb;
        let numbers: Vec<_> = self.line.numbers().chain(p).chain(q).collect();
        let unit = least_exponent(&numbers).min(0);
        let (origin, d, range) = self.line.whole(unit);
        let [p, q] = [p, q].each(|row| row.each(|x| whole(x, unit)));
        let faces = three(|i| match self.aabb {
            BoxNumbers::Center(..) => [&p[i] - &q[i], &p[i] + &q[i]],
            BoxNumbers::Corners(..) => [p[i].clone(), q[i].clone()],
        });
        InFrame { origin, d, faces, range }
    }
}

/// A line in the frame of a box, and the two faces of each axis.
#[derive(Clone)]
struct InFrame {
    origin: [IBig; 3],
    d: [IBig; 3],
    faces: [[IBig; 2]; 3],
    range: [Option<Fraction>; 2],
}

/// For each end of the clipped line the first face whose plane contains it, and through which the
/// line leads into the box or out of it.
fn faces(of: &InFrame) -> Option<[Option<u8>; 2]> {
    let ends = clip(of.clone())?;
    let face = |is_end: bool| {
        let Fraction(num, den) = ends[usize::from(is_end)].as_ref()?;
        let on = |i: usize| {
            let is_upper = (of.d[i] > IBig::ZERO) == is_end;
            let is_on =
                &of.origin[i] * den + num * &of.d[i] == &of.faces[i][usize::from(is_upper)] * den;
            (is_on && of.d[i] != IBig::ZERO).then_some(2 * i as u8 + u8::from(is_upper))
        };
        (0..3).find_map(on)
    };
    Some([face(false), face(true)])
}

/// Both ends of the part of a line's range between all pairs of faces.
fn clip(InFrame { origin, d, faces, mut range }: InFrame) -> Option<[Option<Fraction>; 2]> {
    for i in 0..3 {
        let [least, greatest] = &faces[i];
        if d[i] == IBig::ZERO {
            if &origin[i] < least || &origin[i] > greatest {
                return None;
            }
            continue;
        }
        let mut crossings = [least, greatest].each(|x| Fraction::new(x - &origin[i], d[i].clone()));
        if d[i] < IBig::ZERO {
            crossings.reverse();
        }
        let [enter, leave] = crossings;
        if range[0].as_ref().is_none_or(|from| enter.exceeds(from)) {
            range[0] = Some(enter);
        }
        if range[1].as_ref().is_none_or(|to| to.exceeds(&leave)) {
            range[1] = Some(leave);
        }
        if let [Some(from), Some(to)] = &range {
            if from.exceeds(to) {
                return None;
            }
        }
    }
    Some(range)
}
