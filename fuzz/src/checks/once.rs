//! The oracle for hits that count once: the ray's origin is moved by (ε, ε², ε³), with ε smaller
//! than any number. All quantities are linear in the origin, so a sign is the sign of the value, or
//! of the first nonzero derivative. The derivatives are differences of the formula between
//! neighbouring origins.

use dashu_int::IBig;

use septum_kit::rays::RayCase;
use septum_kit::{Ring, Sample, odd_mantissa};

type Big3 = [IBig; 3];

/// Whether a hit on the triangle counts, if a ray that meets several triangles at one point counts
/// only one of them.
pub(super) fn counts_once<S: Sample>(case: &RayCase<S>) -> bool {
    let [a, b, c] = case.vertices;
    let ends = [case.t_min, case.t_max].map(|end| end.unwrap_or(S::ZERO));
    let rows = [case.origin, case.direction, a, b, c, [ends[0], ends[1], S::ZERO]];
    let parts = rows.map(|row| row.map(odd_mantissa));
    let unit = parts.iter().flatten().flatten().map(|x| x.1).min().unwrap_or(0).min(0);
    let whole = |part: Option<(i64, i32)>| {
        part.map_or(IBig::ZERO, |(m, e)| IBig::from(m) << (e - unit) as usize)
    };
    let [o, d, a, b, c, ends] = parts.map(|row| row.map(whole));
    // t is in whole units of t times one.
    let one = IBig::ONE << (-unit) as usize;

    let (ab, ac) = (Ring::difference(&b, &a), Ring::difference(&c, &a));
    let n = Ring::cross(&ab, &ac);
    let det = Ring::dot(&n, &d);
    if det == IBig::ZERO {
        return false;
    }
    // Twice the area of the triangle of edge and origin, seen along the ray, times the ray's
    // length.
    let side = |p: &Big3, q: &Big3, o: &Big3| {
        let (p, q) = (Ring::difference(p, o), Ring::difference(q, o));
        Ring::dot(&d, &Ring::cross(&p, &q))
    };
    let within = [(&a, &b), (&b, &c), (&c, &a)]
        .iter()
        .all(|(p, q)| moved_sign(&o, |o| side(p, q, o)) == Ring::sign(&det));
    // Above zero where t is greater than the end.
    let past = |end: &IBig| {
        let sign = moved_sign(&o, |o| Ring::dot(&n, &Ring::difference(&a, o)) * &one - end * &det);
        sign * Ring::sign(&det)
    };
    within
        && (case.t_min.is_none() || past(&ends[0]) > 0)
        && (case.t_max.is_none() || past(&ends[1]) < 0)
}

/// The sign of a linear function at the moved origin.
fn moved_sign(o: &Big3, of: impl Fn(&Big3) -> IBig) -> i32 {
    let value = of(o);
    let signs = (0..3).map(|i| {
        let mut next = o.clone();
        next[i] += 1;
        Ring::sign(&(of(&next) - &value))
    });
    core::iter::once(Ring::sign(&value)).chain(signs).find(|&sign| sign != 0).unwrap_or(0)
}
