//! Frames in integers: by Hamilton's product q·e·q*, and by sines and cosines from Taylor series of
//! the whole angle, to 200 bits, one axis after the other.

use dashu_int::IBig;
use septum_kit::{Each, Parts, three};

/// Everything below is in units of 2^-UNIT.
pub(super) const UNIT: i32 = 200;

pub(super) fn one() -> IBig {
    IBig::ONE << UNIT as usize
}

pub(super) fn times(a: &IBig, b: &IBig) -> IBig {
    (a * b) >> UNIT as usize
}

pub(super) fn power_of_two(exponent: i32) -> IBig {
    IBig::ONE << (UNIT + exponent) as usize
}

/// The exact value.
pub(super) fn value((m, e): Parts) -> IBig {
    if m == 0 { IBig::ZERO } else { IBig::from(m) << (UNIT + e) as usize }
}

pub(super) type Frame<T> = [[T; 3]; 3];

/// q·e·q*, divided by the square of q, for each of the axes.
pub(super) fn by_hamilton(q: &[IBig; 4]) -> Frame<IBig> {
    let product = |a: &[IBig; 4], b: &[IBig; 4]| {
        let ([ax, ay, az, aw], [bx, by, bz, bw]) = (a, b);
        [
            aw * bx + ax * bw + ay * bz - az * by,
            aw * by + ay * bw + az * bx - ax * bz,
            aw * bz + az * bw + ax * by - ay * bx,
            aw * bw - ax * bx - ay * by - az * bz,
        ]
    };
    let conjugate = [-&q[0], -&q[1], -&q[2], q[3].clone()];
    let square: IBig = q.iter().map(|x| x * x).sum();
    three(|i| {
        let mut axis = [IBig::ZERO, IBig::ZERO, IBig::ZERO, IBig::ZERO];
        axis[i] = IBig::ONE;
        let [x, y, z, _] = product(&product(q, &axis), &conjugate);
        [x, y, z].each(|n| (n << UNIT as usize) / &square)
    })
}

/// π, by Machin's formula (1706).
pub(super) fn pi() -> IBig {
    let arctan = |over: i32| {
        let over = IBig::from(over);
        let (mut power, mut sum) = (one() / &over, IBig::ZERO);
        for k in 0..120 {
            let term = &power / IBig::from(2 * k + 1);
            sum += if k % 2 == 0 { term } else { -term };
            power /= &over * &over;
        }
        sum
    };
    IBig::from(4) * (IBig::from(4) * arctan(5) - arctan(239))
}

/// Cosine and sine of a number of turns.
pub(super) fn circle(turns: &IBig) -> (IBig, IBig) {
    let part = turns - ((turns >> UNIT as usize) << UNIT as usize);
    let angle = times(&part, &(IBig::from(2) * pi()));
    let (mut term, mut sums) = (one(), [IBig::ZERO, IBig::ZERO]);
    for k in 0..100_usize {
        let sign = if k % 4 < 2 { 1 } else { -1 };
        sums[k % 2] += IBig::from(sign) * &term;
        term = times(&term, &angle) / IBig::from(k + 1);
    }
    let [cos, sin] = sums;
    (cos, sin)
}

/// The coordinate axes rotated about x, then about y, then about z.
pub(super) fn by_steps(turns: &[IBig; 3]) -> Frame<IBig> {
    let mut axes = three(|i| three(|j| if i == j { one() } else { IBig::ZERO }));
    for (i, turns) in turns.iter().enumerate() {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let (cos, sin) = circle(turns);
        for axis in &mut axes {
            let (from_j, from_k) = (axis[j].clone(), axis[k].clone());
            axis[j] = times(&cos, &from_j) - times(&sin, &from_k);
            axis[k] = times(&sin, &from_j) + times(&cos, &from_k);
        }
    }
    axes
}
