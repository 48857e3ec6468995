//! Set (f): exact contact by construction, in integers.

use super::case::{BoxNumbers, Case};
use super::rng::Rng;
use super::sample::Sample;
use crate::Each;

/// A triangle and a box that touch and do not cross: a plane has one shape on its upper side and
/// the other on its lower side, and both have a point in it.
#[derive(Clone, Copy, Debug)]
pub struct Touch {
    pub vertices: [[i64; 3]; 3],
    pub least: [i64; 3],
    pub greatest: [i64; 3],
    /// The normal of that plane, from the box to the triangle.
    pub normal: [i64; 3],
}

impl Touch {
    /// The vertices, those in the plane first.
    pub(crate) fn lowest_first(&self) -> [[i64; 3]; 3] {
        let mut vertices = self.vertices;
        vertices.sort_by_key(|v| (0..3).map(|i| v[i] * self.normal[i]).sum::<i64>());
        vertices
    }

    /// A vertex on a face, an edge or a corner of the box.
    pub fn vertex(rng: &mut Rng, bits: u32) -> Self {
        let (least, greatest) = sides(rng, bits);
        let (i, up) = (rng.below(3), rng.one_in(2));
        let mut point = rng.triple(|_| 0);
        for k in 0..3 {
            point[k] = match rng.below(4) {
                0 => least[k],
                1 => greatest[k],
                _ => rng.whole(least[k], greatest[k]),
            };
        }
        point[i] = if up { greatest[i] } else { least[i] };
        let mut normal = [0; 3];
        normal[i] = if up { 1 } else { -1 };
        let away = |rng: &mut Rng| {
            let mut offset = rng.triple(|rng| rng.whole(-1 << (bits - 2), 1 << (bits - 2)));
            offset[i] = offset[i].abs() * normal[i];
            plus(point, offset)
        };
        let vertices = [point, away(rng), away(rng)];
        Self { vertices, least, greatest, normal }
    }

    /// An edge of the triangle across an edge of the box.
    pub fn edge(rng: &mut Rng, bits: u32) -> Self {
        let (least, greatest) = sides(rng, bits);
        let i = rng.below(3);
        let (j, l) = ((i + 1) % 3, (i + 2) % 3);
        let (up_j, up_l) = (rng.one_in(2), rng.one_in(2));
        let sign = |up: bool| if up { 1 } else { -1 };
        let mut point = greatest;
        point[i] = rng.whole(least[i], greatest[i]);
        point[j] = if up_j { greatest[j] } else { least[j] };
        point[l] = if up_l { greatest[l] } else { least[l] };

        // Along the edge one of the two coordinates leaves the range of the box, and the other
        // enters it.
        let small = 1 << (bits - 4);
        let (dj, dl) = (rng.whole(1, small), rng.whole(1, small));
        let mut step = [0; 3];
        step[i] = rng.whole(-small, small);
        step[j] = sign(up_j) * dj;
        step[l] = -sign(up_l) * dl;
        let mut normal = [0; 3];
        normal[j] = sign(up_j) * dl;
        normal[l] = sign(up_l) * dj;
        let mut outward = rng.triple(|rng| rng.whole(0, 1 << (bits - 3)));
        outward[j] *= sign(up_j);
        outward[l] *= sign(up_l);
        let (on, back) = (rng.whole(1, 3), -rng.whole(1, 3));
        let along = |times: i64| plus(point, step.each(|x| times * x));
        let vertices = [along(on), along(back), plus(point, outward)];
        Self { vertices, least, greatest, normal }
    }

    /// A corner of the box on the triangle's inside.
    pub fn corner(rng: &mut Rng, bits: u32) -> Self {
        let (least, greatest) = sides(rng, bits);
        let small = 1 << ((bits - 3) / 2).saturating_sub(1);
        let up = rng.triple(|rng| rng.one_in(2));
        let point = core::array::from_fn(|i| if up[i] { greatest[i] } else { least[i] });
        let normal = up.each(|up| rng.whole(1, small) * if up { 1 } else { -1 });
        // Two directions in the plane, chosen so that the corner is the centroid.
        let mut within = || cross(normal, rng.triple(|rng| rng.whole(-small / 2, small / 2)));
        let (u, v) = (within(), within());
        let back = core::array::from_fn(|i| -u[i] - v[i]);
        let vertices = [plus(point, u), plus(point, v), plus(point, back)];
        Self { vertices, least, greatest, normal }
    }

    /// The number of bits of a touch in the scalar; all coordinates stay below.
    pub fn bits<S: Sample>() -> u32 {
        S::WHOLE_BITS.min(40)
    }

    /// Any of the three kinds, with few bits or many.
    pub fn of_any_size<S: Sample>(rng: &mut Rng) -> Self {
        let bits = rng.whole(7, Self::bits::<S>().into()) as u32;
        match rng.below(3) {
            0 => Self::vertex(rng, bits),
            1 => Self::edge(rng, bits),
            _ => Self::corner(rng, bits),
        }
    }

    /// The same case in the scalar, with the box by its centre or its corners.
    pub fn case<S: Sample>(&self, by_center: bool) -> Case<S> {
        let each = |of: fn(i64, i64) -> i64| {
            core::array::from_fn(|i| S::whole(of(self.least[i], self.greatest[i])))
        };
        let aabb = if by_center {
            BoxNumbers::Center(each(|a, b| (a + b) / 2), each(|a, b| (b - a) / 2))
        } else {
            BoxNumbers::Corners(self.least.each(S::whole), self.greatest.each(S::whole))
        };
        Case { vertices: self.vertices.each(|v| v.each(S::whole)), aabb }
    }
}

/// A touch with one of its fifteen numbers moved by a unit in the last place, or not.
pub fn nudged_touch<S: Sample>(rng: &mut Rng) -> Case<S> {
    let touch = Touch::of_any_size::<S>(rng);
    let case: Case<S> = touch.case(rng.one_in(2));
    // In half of the cases along an axis on which it matters.
    let along = (0..3).find(|&i| touch.normal[i] != 0).expect("a normal");
    let number = if rng.one_in(2) { rng.below(15) } else { 3 * rng.below(5) + along };
    let steps = rng.whole(-1, 1);
    case.with_number(number, case.numbers()[number].moved(steps)).unwrap_or(case)
}

/// The least and the greatest corner, with an integer centre.
fn sides(rng: &mut Rng, bits: u32) -> ([i64; 3], [i64; 3]) {
    let most = 1 << (bits - 2);
    let (mut least, mut greatest) = ([0; 3], [0; 3]);
    for i in 0..3 {
        let (center, half) = (rng.whole(-most / 2, most / 2), rng.whole(0, most / 2));
        (least[i], greatest[i]) = (center - half, center + half);
    }
    (least, greatest)
}

fn plus(a: [i64; 3], b: [i64; 3]) -> [i64; 3] {
    core::array::from_fn(|i| a[i] + b[i])
}

fn cross(a: [i64; 3], b: [i64; 3]) -> [i64; 3] {
    [(1, 2), (2, 0), (0, 1)].each(|(j, k)| a[j] * b[k] - a[k] * b[j])
}
