//! Shapes from bytes, of kinds that are likely to fail: numbers of a small lattice, near the origin
//! or far from it; numbers of any magnitude, or at the ends of the type; earlier numbers and points
//! again, or an ulp away; points on a line or a plane through earlier points.

use septum::Ray;

use crate::bytes::Bytes;
use crate::told::is_float;
use septum_kit::lines::{Line, LineBox};
use septum_kit::rays::RayCase;
use septum_kit::{BoxNumbers, Sample};

/// A point or a vector.
pub(crate) type Point<S> = [S; 3];

/// The input, and the shapes made so far.
pub(crate) struct Shapes<'a, S> {
    pub(crate) bytes: Bytes<'a>,
    lattice: Lattice<S>,
    points: Vec<Point<S>>,
}

/// Whole multiples of a power of two, from some number on.
struct Lattice<S> {
    from: S,
    /// The exponent of the power; in fixed point, of the least unit.
    exponent: i32,
}

impl<S: Sample> Lattice<S> {
    /// Mostly quarters about zero.
    fn new(bytes: &mut Bytes<'_>) -> Self {
        let least = S::ZERO.moved(1).mantissa_exponent().1;
        let exponent = match (bytes.byte(), is_float::<S>()) {
            (0..128, true) => -2,
            (0..128, false) => (-2 - least).clamp(0, S::WHOLE_BITS as i32 - 4),
            (n, true) => {
                least + (S::GREATEST.mantissa_exponent().1 - least) * i32::from(n - 128) / 127
            }
            (n, false) => i32::from(n) % S::WHOLE_BITS as i32,
        };
        let mut this = Self { from: S::ZERO, exponent };
        let far = bytes.byte();
        if far >= 192 {
            this.from = this.at(1 << (far % 62));
        }
        this
    }

    fn at(&self, n: i64) -> S {
        if is_float::<S>() {
            // As two factors, because the power alone might overflow or underflow.
            let half = self.exponent / 2;
            let offset = n as f64 * 2_f64.powi(half) * 2_f64.powi(self.exponent - half);
            return S::nearest(self.from.approximate() + offset);
        }
        ordinal(i128::from(self.from.ordinal()) + (i128::from(n) << self.exponent))
    }
}

/// The value of number `n`, or the end of the type.
fn ordinal<S: Sample>(n: i128) -> S {
    S::from_ordinal(n.clamp(i64::MIN.into(), i64::MAX.into()) as i64)
}

/// x + (y − z)·n/m, to the nearest or nearly.
fn beyond<S: Sample>(x: S, y: S, z: S, (n, m): (i64, i64)) -> S {
    if is_float::<S>() {
        let [x, y, z] = [x, y, z].map(|x| x.approximate());
        let sum = x + (y - z) * n as f64 / m as f64;
        return if sum.is_nan() { S::ZERO } else { S::nearest(sum) };
    }
    let [x, y, z] = [x, y, z].map(|x| i128::from(x.ordinal()));
    ordinal(x + (y - z) * i128::from(n) / i128::from(m))
}

/// The number without its sign, or the greatest number.
pub(crate) fn magnitude<S: Sample>(x: S) -> S {
    if x < S::ZERO { S::from_ordinal(x.ordinal().saturating_neg()) } else { x }
}

impl<'a, S: Sample> Shapes<'a, S> {
    pub(crate) fn new(mut bytes: Bytes<'a>) -> Self {
        let lattice = Lattice::new(&mut bytes);
        let one = lattice.at(1);
        Self { bytes, lattice, points: vec![[S::ZERO; 3], [one; 3]] }
    }

    fn earlier(&mut self) -> Point<S> {
        let back = self.bytes.below(self.points.len());
        self.points[self.points.len() - 1 - back]
    }

    /// One number.
    pub(crate) fn number(&mut self) -> S {
        let choice = self.bytes.byte();
        // One byte is enough for a number of the lattice.
        let small = i64::from(choice >> 4) - 8;
        match choice % 16 {
            0..=6 => self.lattice.at(small),
            7 => self.lattice.at(small * 256 + i64::from(self.bytes.byte())),
            8 => S::nearest(-0.0),
            9 => self.earlier()[choice as usize / 16 % 3],
            10 => S::from_ordinal(self.earlier()[0].ordinal().saturating_neg()),
            11 => self.earlier()[choice as usize / 16 % 3].moved(self.bytes.about_zero(2)),
            12 => S::from_ordinal(self.bytes.word() >> self.bytes.below(64)),
            13 => {
                let (end, steps) = (choice >= 128, self.bytes.about_zero(2));
                if end { S::GREATEST } else { S::LEAST }.moved(steps)
            }
            // Any exponent, few digits.
            14 => {
                let top = i128::from(small) * i128::from(self.bytes.byte());
                ordinal(i128::from(S::GREATEST.ordinal()) * top / 2048)
            }
            _ => S::nearest(f64::from(self.bytes.byte() as i8) / 3.0).moved(small),
        }
    }

    fn numbers(&mut self) -> Point<S> {
        [(); 3].map(|()| self.number())
    }

    /// A fraction of small numbers.
    fn fraction(&mut self) -> (i64, i64) {
        let byte = i64::from(self.bytes.byte());
        ((byte >> 2) % 9 - 4, [1, 1, 2, 3][(byte & 3) as usize])
    }

    /// A point: three numbers, or a point related to earlier ones.
    pub(crate) fn point(&mut self) -> Point<S> {
        let choice = self.bytes.byte();
        let axis = usize::from(choice >> 4) % 3;
        let mut point = match choice % 8 {
            0..=2 => self.numbers(),
            3 => self.earlier(),
            4 => {
                let mut point = self.earlier();
                point[axis] = self.number();
                point
            }
            5 => {
                let (p, q, r, part) =
                    (self.earlier(), self.earlier(), self.earlier(), self.fraction());
                [0, 1, 2].map(|i| beyond(p[i], q[i], r[i], part))
            }
            // A point in the plane of three earlier points.
            6 => {
                let (p, q, r) = (self.earlier(), self.earlier(), self.earlier());
                let (u, v) = (self.fraction(), self.fraction());
                [0, 1, 2].map(|i| beyond(beyond(p[i], q[i], p[i], u), r[i], p[i], v))
            }
            _ => {
                let mut point = [S::ZERO; 3];
                point[axis] = self.number();
                point
            }
        };
        // Sometimes moved by an ulp.
        if choice & 8 != 0 {
            point[axis] = point[axis].moved(self.bytes.about_zero(2));
        }
        self.points.push(point);
        point
    }

    /// Three points.
    pub(crate) fn triangle(&mut self) -> [Point<S>; 3] {
        [(); 3].map(|()| self.point())
    }

    /// A box, in either form.
    pub(crate) fn aabb(&mut self) -> BoxNumbers<S> {
        let (p, q) = (self.point(), self.point());
        if self.bytes.one_in(2) {
            let half = q.map(magnitude);
            for sign in [-1, 1] {
                self.points.push([0, 1, 2].map(|i| beyond(p[i], half[i], S::ZERO, (sign, 1))));
            }
            return BoxNumbers::Center(p, half);
        }
        let sorted = |i: usize| if p[i] < q[i] { [p[i], q[i]] } else { [q[i], p[i]] };
        BoxNumbers::Corners([0, 1, 2].map(|i| sorted(i)[0]), [0, 1, 2].map(|i| sorted(i)[1]))
    }

    /// A direction from `origin`: any direction, or to a point, or to a point between two or three
    /// of `marks`. `None` if it is zero.
    pub(crate) fn direction(&mut self, origin: Point<S>, marks: &[Point<S>]) -> Option<Point<S>> {
        let choice = self.bytes.below(8);
        let mut target = if choice < 3 { self.point() } else { self.between(marks) };
        if choice == 7 {
            let axis = self.bytes.below(3);
            target[axis] = target[axis].moved(self.bytes.about_zero(2));
        }
        let to_target = [0, 1, 2].map(|i| beyond(S::ZERO, target[i], origin[i], (1, 1)));
        let direction = if choice == 0 { target } else { to_target };
        (direction != [S::ZERO; 3]).then_some(direction)
    }

    /// A point between three of `marks` (by halves, thirds and eighths), often a mark itself or
    /// between two.
    fn between(&mut self, marks: &[Point<S>]) -> Point<S> {
        let [p, q, r] = [(); 3].map(|()| marks[self.bytes.below(marks.len())]);
        let byte = i64::from(self.bytes.byte());
        let parts = [1, 2, 3, 8][(byte & 3) as usize];
        let u = (byte >> 2) % (parts + 1);
        let v = (byte >> 5) % (parts - u + 1);
        [0, 1, 2].map(|i| beyond(beyond(p[i], q[i], p[i], (u, parts)), r[i], p[i], (v, parts)))
    }

    /// A range of t, which often ends where the whole line meets the shape; `meeting` returns that
    /// t.
    pub(crate) fn range(&mut self, meeting: impl Fn() -> Option<S>) -> [Option<S>; 2] {
        let choice = self.bytes.below(9);
        if choice < 3 {
            return [Some(S::ZERO), None];
        }
        let mut end = || match self.bytes.one_in(2).then(&meeting).flatten() {
            Some(t) if t.is_finite() => t.moved(self.bytes.about_zero(1)),
            _ => self.number(),
        };
        let (a, b) = (end(), end());
        match choice {
            3 | 4 => [None, None],
            5 => [None, Some(a)],
            6 => [Some(a), None],
            7 => [Some(S::ZERO), Some(magnitude(a))],
            _ => [Some(if a < b { a } else { b }), Some(if a < b { b } else { a })],
        }
    }

    /// A ray and a triangle. `None` if the direction is zero.
    pub(crate) fn ray_case(&mut self) -> Option<RayCase<S>> {
        let vertices = self.triangle();
        let origin = self.point();
        let direction = self.direction(origin, &vertices)?;
        let mut case = RayCase::new(origin, direction, vertices).line();
        let line = case;
        [case.t_min, case.t_max] = self.range(|| line.ray().hit(&line.triangle()).map(|hit| hit.t));
        Some(case)
    }

    /// A ray and a box. `None` if the direction is zero.
    pub(crate) fn ray_box(&mut self) -> Option<LineBox<S>> {
        let (aabb, first) = (self.aabb(), self.points.len());
        let corners = self.points[first - 2..].to_vec();
        let origin = self.point();
        let direction = self.direction(origin, &corners)?;
        let later = self.bytes.one_in(2);
        let range = self.range(|| {
            let line = Ray::new(origin, direction).and_then(|ray| ray.with_range(None, None));
            let (enter, leave) = line.ok()?.t_range(&aabb.shape().ok()?)?;
            Some(if later { leave } else { enter })
        });
        Some(LineBox { line: Line::Ray(origin, direction, range), aabb })
    }
}
