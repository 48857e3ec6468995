//! The overlap of two faces, seen along the normal of a contact.

use super::answer::Part;
use super::body::{Vec64, along, dot, minus};
use super::faces::{CORNERS, Face, Known, next, ones, parts, transposed, within};
use super::quads::Quads;
use super::sides::side;
use super::view::{Corner, Pair, Pairs, View, flat};
use crate::arithmetic::{Each, REGISTERS_ARE_WIDE};

/// The corners of a face as seen from another.
struct Seen<'a, T> {
    view: &'a View,
    from: &'a Face,
    face: &'a Face,
    known: &'a T,
}

impl<T: Known> Seen<'_, T> {
    /// Each corner with a point of the other face that it meets across the normal.
    #[inline(always)]
    fn meeting(&self, outward: &Vec64) -> impl Iterator<Item = (usize, Vec64)> {
        let (inside, outside) = self.known.within();
        // A processor foresees the end of a loop better than which corners lie outside.
        let left = !outside & ((1 << self.face.count) - 1);
        ones(left).filter_map(move |m| Some((m, self.meets(m, inside >> m & 1 == 1, outward)?)))
    }

    /// The point of the other face that meets corner m across the normal, if there is one. Edges come
    /// first, and of those the edge farthest against `outward`: a face seen edge-on has several such
    /// points. If that edge lies beyond the corner, a point within the face may not.
    #[inline(always)]
    fn meets(&self, m: usize, is_inside: bool, outward: &Vec64) -> Option<Vec64> {
        let at_edge = if is_inside { None } else { self.lowest(m, outward) };
        at_edge.or_else(|| self.known.point(m))
    }

    /// The point of the other face's edges, if it is not beyond the corner.
    #[inline(never)]
    fn lowest(&self, m: usize, outward: &Vec64) -> Option<Vec64> {
        let (view, to) = (self.view, self.face.corner(m));
        let mut lowest: Option<Corner> = None;
        for (n, edge) in self.from.edges().enumerate() {
            if !self.known.may_meet(n, m) {
                continue;
            }
            let at = edge.nearest(&to.flat);
            let is_lower = |other: &Corner| dot(&at.at, outward) < dot(&other.at, outward);
            if view.allows(&at, to) && lowest.as_ref().is_none_or(is_lower) {
                lowest = Some(at);
            }
        }
        let at = lowest?.at;
        (dot(&minus(&to.at, &at), outward) >= -view.tolerance).then_some(at)
    }
}

/// A loop over corners, in words: for cores that compute floats by functions.
struct Words<'a> {
    view: &'a View,
    from: &'a Face,
    face: &'a Face,
    /// Every pair of an edge and a corner. Bit 4·n + m stands for edge n and corner m.
    all: u32,
    /// The corners that certainly lie left of an edge, or right of it. All others may meet it.
    left: u32,
    right: u32,
}

impl<'a> Words<'a> {
    fn new(view: &'a View, from: &'a Face, face: &'a Face) -> Self {
        let (mut all, mut left, mut right) = (0, 0, 0);
        for n in 0..from.count {
            for m in 0..face.count {
                let bit = 1 << (CORNERS * n + m);
                all |= bit;
                let (Some(p), Some(to)) = (&from.words, &face.words) else { continue };
                let side = side(&p[n % CORNERS], &p[from.next(n) % CORNERS], &to[m % CORNERS]);
                if side > 0 {
                    left |= bit;
                } else if side < 0 {
                    right |= bit;
                }
            }
        }
        Self { view, from, face, all, left, right }
    }

    /// Which edges may cross the line of each edge, and which certainly do.
    fn crossing(&self) -> [u32; 2] {
        let [left, right] = [self.left, self.right].each(|bits| next(bits, self.face.count - 1));
        [self.all & !(self.left & left | self.right & right), self.left & right | self.right & left]
    }
}

impl Known for Words<'_> {
    fn within(&self) -> (u32, u32) {
        within(self.all, self.left, self.right)
    }

    fn point(&self, m: usize) -> Option<Vec64> {
        let Self { view, from, face, .. } = self;
        let to = face.corner(m);
        let [base, a, b] = from.frame();
        let [x, y, z] = [a, b, to].each(|x| flat(&x.flat, &base.flat));
        let [s, t] = parts(|x| x, [x, y], z);
        let is_within = s >= 0.0 && t >= 0.0;
        let is_within =
            is_within && if from.count == 3 { s + t <= 1.0 } else { s <= 1.0 && t <= 1.0 };
        if !is_within {
            return None;
        }
        let at = along(&base.at, s, &minus(&a.at, &base.at));
        let at = along(&at, t, &minus(&b.at, &base.at));
        // Certain where no float overflows: see `parts`.
        (view.unit.is_some() || view.allows(&view.corner(at), to)).then_some(at)
    }

    fn crossings(&self, back: &Self) -> [u32; 2] {
        let ([may, certain], [back, certain_back]) = (self.crossing(), back.crossing());
        [may & transposed(back), certain & transposed(certain_back)]
    }

    fn sides(&self, n: usize, m: usize) -> [f64; 2] {
        self.from.edge(n).sides(&self.face.edge(m))
    }

    fn may_meet(&self, n: usize, m: usize) -> bool {
        (self.left | self.right) >> (CORNERS * n + m) & 1 == 0
    }
}

/// The corners of the overlap of two faces seen along the normal: corners of one face within the
/// other, and crossings of edges. Points above the reference face are dropped.
pub(super) fn clip(view: &View, faces: [&Face; 2], outward: &Vec64, found: &mut Pairs) {
    let [reference, incident] = faces;
    if REGISTERS_ARE_WIDE {
        let known = Quads::new(view, reference, incident);
        let back = || (!known.is_around()).then(|| Quads::new(view, incident, reference));
        overlap(view, faces, &known, back, outward, found);
    } else {
        let known = Words::new(view, reference, incident);
        let back = || Some(Words::new(view, incident, reference));
        overlap(view, faces, &known, back, outward, found);
    }
}

/// Adds a pair of points that meet, and returns the place for their parts. As arguments these would be
/// read back in one word, which waits for the stores of their bytes. So would the points.
#[cfg_attr(target_pointer_width = "64", inline(always))]
fn add<'a>(
    found: &'a mut Pairs,
    view: &View,
    at: [Vec64; 2],
    outward: &Vec64,
) -> Option<&'a mut [Part; 2]> {
    let depth = dot(&minus(&at[0], &at[1]), outward);
    if depth >= -view.tolerance { found.add(Pair { at, depth }, view.tolerance) } else { None }
}

#[inline(always)]
fn overlap<T: Known>(
    view: &View,
    [reference, incident]: [&Face; 2],
    known: &T,
    back: impl FnOnce() -> Option<T>,
    outward: &Vec64,
    found: &mut Pairs,
) {
    let against = outward.each(|x| -x);
    let of_incident = Seen { view, from: reference, face: incident, known };
    for (m, below) in of_incident.meeting(&against) {
        if let Some(parts) = add(found, view, [below, incident.corner(m).at], outward) {
            *parts = [Part::Face(reference.number), Part::Vertex(incident.vertex(m))];
        }
    }
    let Some(back) = &back() else { return };
    let of_reference = Seen { view, from: incident, face: reference, known: back };
    for (n, at) in of_reference.meeting(outward) {
        if let Some(parts) = add(found, view, [reference.corner(n).at, at], outward) {
            *parts = [Part::Vertex(reference.vertex(n)), Part::Face(incident.number)];
        }
    }
    let [crossings, certain] = known.crossings(back);
    for pair in ones(crossings) {
        let (n, m) = (pair / CORNERS, pair % CORNERS);
        let (below, at) = (reference.edge(n), incident.edge(m));
        let sides = (certain >> pair & 1 == 1).then(|| known.sides(n, m));
        if let Some(places) = below.crossing(&at, view, sides) {
            if let Some(parts) = add(found, view, places, outward) {
                *parts = [Part::Edge(below.number), Part::Edge(at.number)];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::body::Rough;
    use super::super::sides::Unit;
    use super::super::solid::Solid;
    use super::*;
    use crate::arithmetic::{Each, greatest, three};
    use crate::random::Random;

    /// Also of thin faces, and of faces seen edge-on.
    #[test]
    fn what_words_find_meets_within_half_the_tolerance() {
        let mut random = Random(0x6c19);
        let (mut within, mut crossed) = (0, 0);
        for n in 0..20_000_u32 {
            let mut number = |bits: u64| {
                let down = (random.bits() % (bits + 1)) as i32;
                f64::from(random.bits() as i32) * 2_f64.powi(-31 - down)
            };
            let roughs = [0, 1].each(|k| {
                let at = [(); 3].each(|()| three(|_| number(1)));
                let sides = [(); 3].each(|()| three(|_| number(2)));
                let half = three(|_| number(if n % 2 == 0 { 0 } else { 30 }).abs());
                let is_triangle = (n >> (1 + k)) % 3 == 0;
                Rough {
                    is_triangle,
                    at: if is_triangle { at } else { [at[0]; 3] },
                    sides,
                    half: if is_triangle { [0.0; 3] } else { half },
                }
            });
            let normal = three(|_| number(if n % 8 == 0 { 30 } else { 1 }));
            let length = dot(&normal, &normal).sqrt();
            let normal = normal.each(|x| x / length);
            let solids = [Solid::new(&roughs[0]), Solid::new(&roughs[1])];
            let size = greatest(solids[0].size, solids[1].size);
            let view = View::new(&normal, size, Some(Unit::of(size)));
            let [from, face] =
                [&solids[0], &solids[1]].each(|solid| Face::new(&view, solid, n as u8 % 6));
            let known = Words::new(&view, &from, &face);
            let [_, certain] = known.crossings(&Words::new(&view, &face, &from));
            let apart = |a: Vec64, b: [f64; 2]| {
                let [x, y] = flat(&view.corner(a).flat, &b);
                (x * x + y * y).sqrt() / view.tolerance
            };
            for m in 0..face.count {
                if known.within().1 >> m & 1 == 0 {
                    if let Some(at) = known.point(m) {
                        assert!(apart(at, face.corner(m).flat) < 0.5);
                        within += 1;
                    }
                }
                for n in 0..from.count {
                    if certain >> (CORNERS * n + m) & 1 == 1 {
                        let sides = Some(known.sides(n, m));
                        let [a, b] =
                            from.edge(n).crossing(&face.edge(m), &view, sides).unwrap_or_default();
                        assert!(apart(a, view.corner(b).flat) < 0.5);
                        crossed += 1;
                    }
                }
            }
        }
        assert!(within > 2_000 && crossed > 5_000, "{within} {crossed}");
    }
}
