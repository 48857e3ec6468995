//! The scene: a mesh, and the boxes that it is tested against.

use std::ops::Range;

use crate::advice::sig;
use crate::question::Question;

/// The most boxes along a side.
const LONGEST_SIDE: f64 = (1_u32 << 24) as f64;

/// A mesh among boxes. Box (i, j, k) has its least corner at (i, j, k) times the size
/// of a cell.
pub(crate) struct Scene {
    pub(crate) question: Question,
    pub(crate) triangles: Vec<[[f64; 3]; 3]>,
    pub(crate) cell: f64,
    pub(crate) tolerance: f64,
    /// The boxes in the scene, along each axis.
    pub(crate) cells: [Range<i64>; 3],
    /// The boxes for each triangle.
    around: Vec<[Range<i64>; 3]>,
    /// The number of queries before each triangle, and in all.
    before: Vec<u64>,
}

/// A triangle, by its index, and a box, by its place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Query {
    pub(crate) triangle: usize,
    pub(crate) cell: [i64; 3],
}

impl Scene {
    /// Each triangle is tested against the boxes that its bounding box touches, at rest or on their
    /// path, grown by the tolerances by which rounding may bring them nearer. If no box, triangle
    /// or path end moves farther than the tolerance, no other verdict can change.
    pub(crate) fn new(
        question: Question,
        triangles: Vec<[[f64; 3]; 3]>,
        cell: Option<f64>,
        tolerance: Option<f64>,
    ) -> Result<Self, String> {
        let cell = match cell {
            Some(cell) => cell,
            None => usual_cell(&triangles)?,
        };
        let tolerance = tolerance.unwrap_or(cell / 100.0);
        let slack = question.slack() * tolerance;
        let touched = |t: &[[f64; 3]; 3], i: usize| {
            let [least, greatest] = span(t.iter().map(|p| p[i]));
            let way = question.way()[i];
            let slack = slack + question.overhang(i) * cell;
            let first = ((least - way.max(0.0) - slack) / cell).ceil() - 1.0;
            let end = ((greatest - way.min(0.0) + slack) / cell).floor() + 1.0;
            let far = first.abs().max(end.abs()) >= (1_u64 << 53) as f64;
            if far || end - first > LONGEST_SIDE {
                return Err(format!(
                    "boxes of {} are too small for the mesh, the way and a tolerance of {}, or too \
                     far from the origin: a triangle would have {} along a side, from number {} on",
                    sig(cell),
                    sig(tolerance),
                    sig(end - first),
                    sig(first)
                ));
            }
            Ok(first as i64..end as i64)
        };
        let mut around: Vec<[Range<i64>; 3]> = Vec::with_capacity(triangles.len());
        for t in &triangles {
            around.push([touched(t, 0)?, touched(t, 1)?, touched(t, 2)?]);
        }
        let cells = [0, 1, 2].map(|i| {
            let least = around.iter().map(|r| r[i].start).min().unwrap_or(0);
            least..around.iter().map(|r| r[i].end).max().unwrap_or(0)
        });
        let mut sum = 0_u64;
        let mut before = vec![0];
        for ranges in &around {
            let count = ranges.iter().map(length).try_fold(1_u64, u64::checked_mul);
            sum = count.and_then(|n| sum.checked_add(n)).ok_or("too many boxes for one mesh")?;
            before.push(sum);
        }
        if let Some(side) = cells.iter().map(length).find(|&n| n as f64 > LONGEST_SIDE) {
            return Err(format!(
                "boxes of {} are too small: there would be {side} along a side",
                sig(cell)
            ));
        }
        Ok(Self { question, triangles, cell, tolerance, cells, around, before })
    }

    /// The number of queries.
    pub(crate) fn queries(&self) -> u64 {
        self.before.last().copied().unwrap_or(0)
    }

    /// The query with index `n`.
    pub(crate) fn query(&self, n: u64) -> Query {
        // Every triangle has queries, so `before` increases strictly.
        let triangle = self.before.partition_point(|&before| before <= n) - 1;
        let [x, y, z] = &self.around[triangle];
        let n = n - self.before[triangle];
        let (n, i) = (n / length(x), n % length(x));
        let (k, j) = (n / length(y), n % length(y));
        let cell = [x.start + i as i64, y.start + j as i64, z.start + k as i64];
        Query { triangle, cell }
    }

    /// The coordinate at which box `i` begins and box `i` − 1 ends.
    pub(crate) fn face(&self, i: i64) -> f64 {
        i as f64 * self.cell
    }

    /// The points of a query: the triangle's vertices, the least and the greatest corner
    /// of the box.
    pub(crate) fn points(&self, query: Query) -> [[f64; 3]; 5] {
        let [a, b, c] = self.triangles[query.triangle];
        [a, b, c, query.cell.map(|i| self.face(i)), query.cell.map(|i| self.face(i + 1))]
    }

    /// The position of the box's least corner before and after its motion.
    pub(crate) fn places(&self, query: Query) -> [[f64; 3]; 2] {
        let (from, way) = (query.cell.map(|i| self.face(i)), self.question.way());
        [from, [0, 1, 2].map(|i| from[i] + way[i])]
    }

    /// The least and the greatest coordinate along an axis, of triangles and boxes, before and
    /// after their motion.
    pub(crate) fn extent(&self, axis: usize) -> [f64; 2] {
        let Range { start, end } = self.cells[axis];
        let way = self.question.way()[axis];
        let faces = [start, end].map(|i| self.face(i));
        let faces = faces.into_iter().flat_map(|face| [face, face + way]);
        span(self.triangles.iter().flatten().map(|p| p[axis]).chain(faces))
    }

    /// The least and the greatest of the coordinates on all three axes, and of directions.
    pub(crate) fn range(&self) -> [f64; 2] {
        let places = [0, 1, 2].into_iter().flat_map(|axis| self.extent(axis));
        span(places.chain(self.question.directions().iter().copied()))
    }
}

fn length(range: &Range<i64>) -> u64 {
    range.start.abs_diff(range.end)
}

fn span(numbers: impl Iterator<Item = f64>) -> [f64; 2] {
    numbers.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)])
}

/// The usual size of a box: a power of two, which every fixed-point type can hold
/// exactly if it is fine enough.
fn usual_cell(triangles: &[[[f64; 3]; 3]]) -> Result<f64, String> {
    let side = |i: usize| {
        let [least, greatest] = span(triangles.iter().flatten().map(|p| p[i]));
        greatest - least
    };
    let longest = side(0).max(side(1)).max(side(2));
    if longest == 0.0 {
        return Err("the mesh is a single point: say how large the boxes are, by --cell".into());
    }
    if !longest.is_finite() {
        return Err("the mesh is too large: its longest side is beyond f64".into());
    }
    Ok((longest / 64.0).log2().floor().exp2())
}
