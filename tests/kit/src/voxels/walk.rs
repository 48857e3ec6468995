//! Walks along lines. The oracle tests every voxel of the grid, and computes the interval of t
//! inside it in fractions.

use dashu_int::IBig;
use septum::voxel::{Grid, Rule};
use septum::{Ray, Segment};

use super::oracle::planes;
use super::random::grid;
use crate::exact::{Parts, least_exponent, whole};
use crate::{Each, Rng, Sample, odd_mantissa, three};

/// A quotient with a positive divisor.
#[derive(Clone)]
struct Fraction(IBig, IBig);

impl Fraction {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        (&self.0 * &other.1).cmp(&(&other.0 * &self.1))
    }
}

/// The interval of t in a voxel, and whether its ends belong to it.
struct Stay {
    from: (Fraction, bool),
    to: (Fraction, bool),
}

/// Walks along random segments and rays in random grids, also through corners and along faces.
/// Panics if a walk violates its rule; returns the number of voxels met.
pub(super) fn walks_are_right<S: Sample>(seed: u64, grids: u32) -> u64 {
    let rng = &mut Rng::new(seed);
    let mut met = 0;
    for _ in 0..grids {
        let Some(grid) = grid::<S>(rng, 7) else { continue };
        for _ in 0..12 {
            met += one::<S>(rng, &grid);
        }
    }
    met
}

/// Two points in and about a grid, on its planes or not.
pub(super) fn line_ends<S: Sample>(rng: &mut Rng, grid: &Grid<S>) -> ([S; 3], [S; 3]) {
    let size = grid.resolution();
    let planes = planes(grid);
    let mut point = |on_planes: bool| -> [S; 3] {
        three(|i: usize| {
            let n = i64::from(size[i]);
            if on_planes {
                return planes[i][rng.whole(0, n) as usize];
            }
            let (low, high) = (planes[i][0].approximate(), planes[i][n as usize].approximate());
            S::nearest(low + rng.real(-0.4, 1.4) * (high - low))
        })
    };
    let (mut a, mut b) = (point(false), point(false));
    let (c, d) = (point(true), point(true));
    match rng.whole(0, 7) {
        0 => (a, b) = (c, d),
        1 => a = c,
        2 => b = d,
        // Along an axis, in a plane or not; along a face; a point.
        3 => (a[0], a[1], b[0], b[1]) = (c[0], d[1], c[0], d[1]),
        4 => (a[1], b[1]) = (c[1], c[1]),
        5 => (a[0], b[0]) = (b[0], b[0]),
        6 => b = a,
        _ => {}
    }
    (a, b)
}

fn one<S: Sample>(rng: &mut Rng, grid: &Grid<S>) -> u64 {
    let planes = planes(grid);
    let (a, b) = line_ends(rng, grid);
    let parts = |p: [S; 3]| -> [Parts; 3] { p.each(|x| odd_mantissa(x).unwrap_or((0, 0))) };
    let limits: [Vec<Parts>; 3] =
        planes.each(|p| p.into_iter().map(|x| odd_mantissa(x).unwrap_or((0, 0))).collect());
    let mut met = 0;
    let from_to = Segment::new(a, b).expect("finite ends");
    let ray = Ray::new(a, b);
    for rule in [Rule::Closed, Rule::HalfOpen, Rule::Thin] {
        let walk: Vec<_> = grid.walk_segment(&from_to, rule).collect();
        let what = format!("{rule:?} {from_to:?} in {grid:?}");
        met += check(&limits, parts(a), [parts(a), parts(b)], true, rule, &walk, &what);
        // The coordinates of b as a direction.
        let Ok(ray) = &ray else { continue };
        let walk: Vec<_> = grid.walk_ray(ray, rule).collect();
        let what = format!("{rule:?} {ray:?} in {grid:?}");
        met += check(&limits, parts(a), [[(0, 0); 3], parts(b)], false, rule, &walk, &what);
        // The whole line backward, and both ends of a segment about its centre.
        let line = ray.with_range(None, S::ZERO).expect("a range");
        let back: Vec<_> = grid.walk_ray(&line, rule).collect();
        let middle = Segment::from_center_half_vector(a, b).expect("finite");
        let about: Vec<_> = grid.walk_segment(&middle, rule).collect();
        if rule == Rule::HalfOpen {
            let ahead: Vec<_> = grid.walk_ray(ray, rule).collect();
            let whole: Vec<_> =
                grid.walk_ray(&ray.with_range(None, None).expect("a range"), rule).collect();
            let mut joined = back.clone();
            if joined.last() == ahead.first() {
                joined.pop();
            }
            joined.extend(&ahead);
            assert!(whole == joined, "{what}: {whole:?} {joined:?}");
            assert!(about.iter().all(|v| whole.contains(v)), "{what}");
            let pair = about.iter().filter(|v| back.contains(v) || ahead.contains(v)).count();
            assert!(pair == about.len(), "{what}");
        }
    }
    met
}

fn check(
    limits: &[Vec<Parts>; 3],
    anchor: [Parts; 3],
    [from, to]: [[Parts; 3]; 2],
    ends_at_one: bool,
    rule: Rule,
    walk: &[[u32; 3]],
    what: &str,
) -> u64 {
    let all = anchor.iter().chain(&from).chain(&to).chain(limits.iter().flatten());
    let unit = least_exponent(all);
    let number = |x: Parts| whole(x, unit);
    let a = anchor.each(number);
    let way: [IBig; 3] = std::array::from_fn(|i| number(to[i]) - number(from[i]));
    let limits = limits.each_ref().each(|p| p.iter().map(|&x| number(x)).collect::<Vec<_>>());
    let size = limits.each_ref().each(|p| p.len() as u32 - 1);
    let [nx, ny, nz] = size;
    let stay = |voxel: [u32; 3], rule: Rule| -> Option<Stay> {
        let (zero, one) = (Fraction(0.into(), 1.into()), Fraction(1.into(), 1.into()));
        let mut from = (zero, true);
        let mut to: Option<(Fraction, bool)> = ends_at_one.then_some((one, true));
        let closed = rule == Rule::Closed;
        for i in 0..3 {
            let [low, high] = [0, 1].each(|k| &limits[i][voxel[i] as usize + k] - &a[i]);
            let (enter, leave) = match way[i].cmp(&IBig::ZERO) {
                std::cmp::Ordering::Equal => {
                    let zero = IBig::ZERO;
                    if low > zero || high < zero || !closed && high == zero {
                        return None;
                    }
                    continue;
                }
                std::cmp::Ordering::Greater => ((low, true), (high, closed)),
                std::cmp::Ordering::Less => ((-high, closed), (-low, true)),
            };
            let by = if way[i] < IBig::ZERO { -&way[i] } else { way[i].clone() };
            let enter = (Fraction(enter.0, by.clone()), enter.1);
            let leave = (Fraction(leave.0, by), leave.1);
            match enter.0.cmp(&from.0) {
                std::cmp::Ordering::Greater => from = enter,
                std::cmp::Ordering::Equal => from.1 &= enter.1,
                std::cmp::Ordering::Less => {}
            }
            let order = to.as_ref().map(|to| leave.0.cmp(&to.0));
            match order {
                None | Some(std::cmp::Ordering::Less) => to = Some(leave),
                Some(std::cmp::Ordering::Equal) => {
                    to = to.map(|(t, is_in)| (t, is_in && leave.1));
                }
                Some(std::cmp::Ordering::Greater) => {}
            }
        }
        let to = to.unwrap_or((from.0.clone(), true));
        let is_there = match from.0.cmp(&to.0) {
            std::cmp::Ordering::Less => true,
            std::cmp::Ordering::Equal => from.1 && to.1,
            std::cmp::Ordering::Greater => false,
        };
        is_there.then_some(Stay { from, to })
    };
    let every = || (0..nx * ny * nz).map(|n| [n % nx, n / nx % ny, n / nx / ny]);
    let kind = if rule == Rule::Closed { Rule::Closed } else { Rule::HalfOpen };
    let mut stays: Vec<_> = every().filter_map(|v| Some((v, stay(v, kind)?))).collect();
    // In order of entry; a single point comes before an interval that begins there.
    stays.sort_by(|(_, a), (_, b)| a.from.0.cmp(&b.from.0).then(b.from.1.cmp(&a.from.1)));
    match rule {
        Rule::HalfOpen => {
            assert!(walk.iter().eq(stays.iter().map(|(v, _)| v)), "{what}: {walk:?}");
        }
        Rule::Closed => {
            let mut sorted = walk.to_vec();
            sorted.sort_unstable();
            let mut expected: Vec<_> = stays.iter().map(|(v, _)| *v).collect();
            expected.sort_unstable();
            assert!(sorted == expected, "{what}: {walk:?}, not {expected:?}");
            let in_order = walk.windows(2).all(|pair| {
                let [a, b] = [pair[0], pair[1]].each(|v| stay(v, kind).expect("met"));
                a.from.0.cmp(&b.from.0).is_le() && a.to.0.cmp(&a.from.0).is_ge()
            });
            assert!(in_order, "{what}: {walk:?}");
        }
        _ => {
            let thin = thin(&a, &way, &limits, ends_at_one);
            assert!(*walk == thin, "{what}: {walk:?}, not {thin:?}");
            let mut rest = walk.iter();
            let has_all = stays.iter().all(|(v, _)| rest.any(|w| w == v));
            assert!(has_all, "{what}: {walk:?}");
            assert!(walk.iter().all(|&v| stay(v, Rule::Closed).is_some()), "{what}: {walk:?}");
            for pair in walk.windows(2) {
                let apart: u32 = (0..3).map(|i| pair[0][i].abs_diff(pair[1][i])).sum();
                assert!(apart == 1, "{what}: {walk:?}");
            }
        }
    }
    stays.len() as u64
}

/// A thin walk by what it is: plane after plane in the order of t, of those at one t the rising
/// ones first, x before y before z, then the falling ones backwards; all of the grid's planes,
/// wherever the line is, and of the voxels those of the grid.
fn thin(
    a: &[IBig; 3],
    way: &[IBig; 3],
    limits: &[Vec<IBig>; 3],
    ends_at_one: bool,
) -> Vec<[u32; 3]> {
    let (zero, one) = (Fraction(0.into(), 1.into()), Fraction(1.into(), 1.into()));
    let mut steps = Vec::new();
    for i in 0..3 {
        let rises = way[i] > IBig::ZERO;
        if way[i] == IBig::ZERO {
            continue;
        }
        for limit in &limits[i] {
            let gap = limit - &a[i];
            let t = if rises { Fraction(gap, way[i].clone()) } else { Fraction(-gap, -&way[i]) };
            // A point on a plane is above it.
            let is_met = if rises {
                t.cmp(&zero).is_gt() && (!ends_at_one || t.cmp(&one).is_le())
            } else {
                t.cmp(&zero).is_ge() && (!ends_at_one || t.cmp(&one).is_lt())
            };
            if is_met {
                steps.push((t, if rises { i } else { 5 - i }));
            }
        }
    }
    steps.sort_by(|(t, i), (u, j)| t.cmp(u).then(i.cmp(j)));
    let below = |i: usize| limits[i].iter().filter(|&p| *p <= a[i]).count() as i64 - 1;
    let mut at = [below(0), below(1), below(2)];
    let mut walk = Vec::new();
    let mut visit = |at: [i64; 3]| {
        if (0..3).all(|i| at[i] >= 0 && at[i] < limits[i].len() as i64 - 1) {
            walk.push(at.each(|k| k as u32));
        }
    };
    visit(at);
    for (_, which) in steps {
        if which < 3 {
            at[which] += 1
        } else {
            at[5 - which] -= 1
        }
        visit(at);
    }
    walk
}
