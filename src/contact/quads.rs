//! A face seen from another, four corners at a time: for hosts, whose vectors hold several floats. A
//! loop over corners takes three times as many instructions.

use super::body::Vec64;
use super::faces::{CORNERS, Face, Known, next, parts, transposed, within};
use super::view::{Four, View, flat};
use crate::arithmetic::{Each, Quad, minus3, three, two};

/// All corners, as bits.
const ALL: u32 = (1 << CORNERS) - 1;

/// The positions of a face's corners relative to another face. Sets of corners are bits.
pub(super) struct Quads {
    /// The signed distance of each corner from each edge, times the edge's length.
    sides: [[f64; CORNERS]; CORNERS],
    /// Four bits for each edge of the opposite face: the edges of this face that cross its line.
    crossing: u32,
    /// Four bits for each edge of the opposite face: the corners that certainly lie off its line.
    clear: u32,
    /// The corners certainly within the other face, and those certainly outside of it.
    within: (u32, u32),
    /// The last edge.
    last: usize,
    /// The corners that meet a point within the other face.
    met: u32,
    /// Those points.
    points: [[f64; CORNERS]; 3],
}

fn splat(x: f64) -> Four {
    Four::splat(x)
}

impl Quads {
    /// A corner is clear of an edge's line if its side is certain and it is off the line by more than the
    /// tolerance.
    ///
    /// # The error
    ///
    /// With the sizes of [`View`]. A corner errs by √(17² + 26²)·u·S across the normal, so an edge of length L
    /// and the way to a corner, at most 2·√3·S long, err by less than 67·u·S each. A side errs by less than
    /// 67·u·S·(L + 2·√3·S), and by 3·u·L·2·√3·S for its roundings. The line of a short edge turns by much, and
    /// a corner far along it may be on either side. The tolerance T is 256·u·S. A clear corner has a side above
    /// 2·T·√(L² + S²), at least √2·T·(L + S). Less the error that is above T·L. `view.g` proves it.
    #[inline(always)]
    pub(super) fn new(view: &View, from: &Face, face: &Face) -> Self {
        let to = two(|k| {
            let [a, b, c, d] = &face.corners;
            Four::new([a.flat[k], b.flat[k], c.flat[k], d.flat[k]])
        });
        let margin = 4.0 * (view.tolerance * view.tolerance);
        let square = view.size * view.size;
        let mut sides = [[0.0; CORNERS]; CORNERS];
        let (mut left, mut right, mut clear) = (0, 0, 0);
        // The last edge of a triangle occurs twice.
        for n in 0..CORNERS {
            let [p, q] = from.ends(n);
            let along = flat(&q.flat, &p.flat);
            let [x, y] = two(|k| to[k] - splat(p.flat[k]));
            let side = splat(along[0]) * y - splat(along[1]) * x;
            let margin = margin * (along[0] * along[0] + along[1] * along[1] + square);
            left |= side.exceeds(splat(0.0)) << (CORNERS * n);
            right |= splat(0.0).exceeds(side) << (CORNERS * n);
            clear |= (side * side).exceeds(splat(margin)) << (CORNERS * n);
            sides[n] = side.to_array();
        }
        let last = face.count - 1;
        let next = |bits| next(bits, last);
        let crossing = left & next(right) | right & next(left);
        let within = within(0xffff, left & clear, right & clear);
        let (met, points) =
            if within.1 == ALL { (0, [[0.0; CORNERS]; 3]) } else { points(view, from, &to) };
        Self { sides, crossing, clear, within, last, met, points }
    }

    /// Whether the other face is certainly around this one: none of its corners meets a point of this face, and
    /// no edges cross.
    ///
    /// # The error
    ///
    /// With the sizes of [`View`]. All corners are clear of the lines through each corner of the other face, in the
    /// coordinates as computed. Points between them err by less than 100·u·S: a parameter's product and its sums
    /// by 10·u·S in each coordinate, which is 18·u·S across the normal, and the coordinates across the normal,
    /// of the point and of its corners, by 6·u·S each. So all points are off the other face's corners by more than
    /// the tolerance. `view.g` proves it.
    pub(super) fn is_around(&self) -> bool {
        self.within.0 == ALL && self.crossing == 0
    }
}

impl Known for Quads {
    #[inline(always)]
    fn within(&self) -> (u32, u32) {
        self.within
    }

    #[inline(always)]
    fn point(&self, m: usize) -> Option<Vec64> {
        (self.met >> m & 1 == 1).then(|| three(|i| self.points[i][m % CORNERS]))
    }

    #[inline(always)]
    fn crossings(&self, back: &Self) -> [u32; 2] {
        [self.crossing & transposed(back.crossing), u32::MAX]
    }

    #[inline(always)]
    fn sides(&self, n: usize, m: usize) -> [f64; 2] {
        let next = if m < self.last { m + 1 } else { 0 };
        [m, next].each(|m| self.sides[n % CORNERS][m % CORNERS])
    }

    #[inline(always)]
    fn may_meet(&self, n: usize, m: usize) -> bool {
        self.clear >> (CORNERS * n + m) & 1 == 0
    }
}

/// The points of a face that meet others across the normal, and which of these they meet.
#[inline(always)]
fn points(view: &View, from: &Face, to: &[Four; 2]) -> (u32, [[f64; CORNERS]; 3]) {
    let [base, a, b] = from.frame();
    let c = two(|k| to[k] - splat(base.flat[k]));
    let [s, t] = parts(splat, [a, b].each(|x| flat(&x.flat, &base.flat)), c);
    let (zero, one) = (splat(0.0), splat(1.0));
    let is_below = if from.count == 3 {
        (s + t).is_at_most(one)
    } else {
        s.is_at_most(one) & t.is_at_most(one)
    };
    let [e, f] = [minus3(&a.at, &base.at), minus3(&b.at, &base.at)];
    let at = three(|i| splat(base.at[i]) + s * splat(e[i]) + t * splat(f[i]));
    let flats = view.flats(at);
    let [x, y] = two(|k| flats[k] - to[k]);
    let is_near = (x * x + y * y).is_at_most(splat(view.tolerance * view.tolerance));
    let met = zero.is_at_most(s) & zero.is_at_most(t) & is_below & is_near;
    (met, at.each(Quad::to_array))
}

#[cfg(test)]
mod tests {
    use super::super::body::Rough;
    use super::super::body::along;
    use super::super::sides::Unit;
    use super::super::solid::Solid;
    use super::super::view::Corner;
    use super::*;
    use crate::random::Random;

    /// A triangle in the plane z = 0, along whose normal it is seen. All numbers are small and whole, so that
    /// nothing is rounded.
    fn triangle(view: &View, random: &mut Random) -> Face {
        let at =
            [(); 3].each(|()| [0, 1, 2].each(|i| if i < 2 { coordinate(random) } else { 0.0 }));
        let rough = Rough { is_triangle: true, at, sides: [[0.0; 3]; 3], half: [0.0; 3] };
        Face::new(view, &Solid::new(&rough), 0)
    }

    /// The lower side of a box with the coordinate axes.
    fn rectangle(view: &View, random: &mut Random) -> Face {
        let sides = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let [x, y, w, h] = [(); 4].each(|()| coordinate(random));
        let half = [w.abs() + 1.0, h.abs() + 1.0, 1.0];
        let rough = Rough { is_triangle: false, at: [[x, y, 1.0]; 3], sides, half };
        Face::new(view, &Solid::new(&rough), 4)
    }

    fn coordinate(random: &mut Random) -> f64 {
        (random.bits() % 17) as f64 - 8.0
    }

    /// The sign of each corner's side of each edge, in whole numbers.
    fn signs(from: &Face, face: &Face) -> [[i64; CORNERS]; CORNERS] {
        let whole = |corner: &Corner| corner.flat.each(|x| x as i64);
        let mut signs = [[0; CORNERS]; CORNERS];
        for (n, signs) in signs.iter_mut().enumerate().take(from.count) {
            let [p, q] = from.ends(n).each(whole);
            for (m, sign) in signs.iter_mut().enumerate().take(face.count) {
                let to = whole(face.corner(m));
                let [a, b] = [q, to].each(|x| [x[0] - p[0], x[1] - p[1]]);
                *sign = (a[0] * b[1] - a[1] * b[0]).signum();
            }
        }
        signs
    }

    #[test]
    fn corners_and_crossings_are_those_of_whole_numbers() {
        let mut random = Random(0x9ad5);
        let view = View::new(&[0.0, 0.0, 1.0], 32.0, Unit::new::<f32>(32.0));
        let (mut within, mut crossed, mut around) = (0, 0, 0);
        for n in 0..20_000 {
            let face = |random: &mut Random, kind: bool| {
                if kind { triangle(&view, random) } else { rectangle(&view, random) }
            };
            let (from, face) = (face(&mut random, n % 2 == 0), face(&mut random, n % 4 < 2));
            let (quads, signs) = (Quads::new(&view, &from, &face), signs(&from, &face));
            let back = Quads::new(&view, &face, &from);
            let [crossings, _] = quads.crossings(&back);
            if quads.is_around() {
                assert_eq!((back.within.0, back.met, crossings), (0, 0, 0));
                around += 1;
            }
            let of = |m: usize| signs.iter().take(from.count).map(move |signs| signs[m]);
            for m in 0..face.count {
                let is_left = of(m).all(|sign| sign > 0) || of(m).all(|sign| sign < 0);
                let is_out = of(m).any(|sign| sign > 0) && of(m).any(|sign| sign < 0);
                let (inside, outside) = quads.within;
                assert_eq!([inside, outside].each(|x| x >> m & 1 == 1), [is_left, is_out]);
                if is_left {
                    let [x, y, _] = quads.point(m).unwrap();
                    let [to_x, to_y, _] = face.corner(m).at;
                    assert!((x - to_x).abs() < view.tolerance && (y - to_y).abs() < view.tolerance);
                    within += 1;
                }
                for n in 0..from.count {
                    let is_crossed = signs[n][m] * signs[n][face.next(m)] < 0;
                    assert_eq!(quads.crossing >> (CORNERS * n + m) & 1 == 1, is_crossed);
                    crossed += u32::from(is_crossed);
                    let both = is_crossed && back.crossing >> (CORNERS * m + n) & 1 == 1;
                    assert_eq!(crossings >> (CORNERS * n + m) & 1 == 1, both);
                }
            }
        }
        let counts = [within, crossed, around];
        assert!(within > 5_000 && crossed > 50_000 && around > 200, "{counts:?}");
    }

    /// The sides of a box are parallel to 10^-12 and less, one is up to 2^30 times as long as another, and
    /// the directions have roundings.
    #[test]
    fn what_lies_in_a_face_is_not_outside_of_it() {
        let mut random = Random(0x51e2);
        let mut number = || f64::from(random.bits() as i32) * 2_f64.powi(-31);
        let mut skewed = 0;
        for n in 0..20_000 {
            let [side, apart, normal] = [(); 3].each(|()| three(|_| number()));
            let sides = [1e-12, 1e-14, 0.0].each(|off| along(&side, off * number(), &apart));
            let half = [1.0, number().abs(), 2_f64.powi(n % 30)];
            let rough = Rough { is_triangle: false, at: [[0.0; 3]; 3], sides, half };
            let at = [(); 3].each(|()| {
                let [s, t] = two(|_| number());
                let reach = three(|k| sides[k].each(|x| x * half[k]));
                let at = along(&reach[0].each(|x| -x), s, &reach[1]);
                along(&at, t, &reach[2])
            });
            let none = [[0.0; 3]; 3];
            let triangle = Rough { is_triangle: true, at, sides: none, half: [0.0; 3] };
            let [solid, other] = [Solid::new(&rough), Solid::new(&triangle)];
            let length = (0..3).map(|i| normal[i] * normal[i]).sum::<f64>().sqrt();
            let view = View::new(&normal.each(|x| x / length), solid.size, None);
            let [from, face] = [Face::new(&view, &solid, 0), Face::new(&view, &other, 0)];
            let quads = Quads::new(&view, &from, &face);
            for m in 0..3 {
                let (inside, outside) = quads.within;
                assert_eq!(outside >> m & 1, 0, "{sides:?} {at:?}");
                skewed += 1 - (inside >> m & 1);
            }
        }
        assert!(skewed > 1_000, "{skewed}");
    }
}
