//! When the triangle meets the box, in machine words, given that it does.
//!
//! On each of the 13 axes only the side that the triangle moves toward can have a gap at the start. The
//! sign of the speed along the axis says which side that is, and which vertex leads.

use super::{Passing, Side, Swept, along};
use crate::arithmetic::{
    InWholeWord, Number, ProductSum, WholeWord, greatest, least, pick, three, turn,
};
use crate::query::Axis;
use crate::query::one_sided::{Closed, beyond_edge, beyond_plane, normals};
use crate::query::sweep::FirstContact;
use crate::query::sweep::latest::Latest;
use crate::scalar::Scalar;

impl<S: Scalar> Passing<'_, S> {
    /// The first contact, in words wide enough for shapes anywhere.
    #[inline(never)]
    pub(in crate::query::sweep) fn contact_in_any_words<W: WholeWord>(&self) -> FirstContact<S>
    where
        S: InWholeWord<W>,
    {
        self.swept().first_contact()
    }

    /// The first contact, in words wide enough for shapes and motions near each other; `None` if they
    /// are not.
    #[inline(never)]
    pub(in crate::query::sweep) fn contact_in_near_words<W: WholeWord>(
        &self,
    ) -> Option<FirstContact<S>>
    where
        S: InWholeWord<W>,
    {
        let swept = self.swept();
        let longest = swept.longest();
        // A difference of two lengths has one bit more.
        let is_near = longest.is_near() && longest.plus(longest).has_volumes();
        (self.is_central() && is_near).then(|| swept.first_contact())
    }
}

impl<W: WholeWord> Swept<W> {
    #[inline(always)]
    fn first_contact<S: Scalar + InWholeWord<W>>(&self) -> FirstContact<S> {
        let mut latest = Latest::NONE;
        for ((i, shapes), d) in (0..).zip(&self.start).zip(self.d) {
            let ([a, b, c], size) = (shapes.t, shapes.size);
            let (low, high) = (least(least(a, b), c), greatest(greatest(a, b), c));
            let gap = greatest(low - size, W::ZERO - high);
            if gap > W::ZERO {
                close(&mut latest, Axis::Face(i), gap.into(), d.into());
            }
        }
        self.add_slanted::<S, W::Sum>(&mut latest);
        latest.known().unwrap_or_default()
    }

    /// The normal, and the cross products of the edges with the coordinate axes.
    #[inline(always)]
    fn add_slanted<S, A>(&self, latest: &mut Latest<S>)
    where
        S: Scalar + InWholeWord<W>,
        A: ProductSum<W>,
        W: WholeWord<Sum = A>,
    {
        let n: [A; 3] = normals(&self.start);
        let along = along(&n, &self.d);
        let axes = three(|i| (n[i], self.start[i].t[0], self.start[i].size));
        let rest = beyond_plane::<W, A, Closed>(axes.into_iter(), !A::is_negative(along));
        if A::is_negative(rest) {
            close::<S, W>(latest, Axis::Normal, -W::whole(rest), W::whole(along));
        }
        let ([x, y, z], [dx, dy, dz]) = (&self.start, self.d);
        add_edges(latest, 0, &Side::new(n[0], [y, z], [dy, dz]));
        add_edges(latest, 1, &Side::new(n[1], [z, x], [dz, dx]));
        add_edges(latest, 2, &Side::new(n[2], [x, y], [dx, dy]));
    }
}

/// The axes that are perpendicular to coordinate axis `i`.
#[inline(never)]
fn add_edges<S: Scalar + InWholeWord<W>, W: WholeWord>(
    latest: &mut Latest<S>,
    i: u8,
    side: &Side<'_, W, W::Sum>,
) {
    let Side { n, q, jl: [j, l], .. } = side;
    for k in 0..3 {
        let (_, next, opposite) = turn(k);
        let q = *pick(q, next);
        let [vj, vl] = [*pick(&j.t, k), *pick(&l.t, k)];
        let (mut ej, mut el) = (vj - *pick(&j.t, next), *pick(&l.t, next) - vl);
        // The speed is −q. The triangle moves toward the side where e × x is greater, or lesser.
        if q.sign() < W::ZERO {
            (ej, el) = (W::ZERO - ej, W::ZERO - el);
        }
        let leads = if (q.sign() ^ n.sign()) < W::ZERO { opposite } else { k };
        let v = [*pick(&j.t, leads), *pick(&l.t, leads)];
        let rest = beyond_edge::<W, W::Sum, Closed>([j.size, l.size], v, [ej, el]);
        if rest.sign() < W::ZERO {
            let axis = Axis::Edge { axis: i, edge: k as u8 };
            close::<S, W>(latest, axis, -W::whole(rest.volume()), W::whole(q.volume()));
        }
    }
}

/// Adds an axis with a gap and a speed.
#[inline(never)]
fn close<S: Scalar + InWholeWord<W>, W: WholeWord>(
    latest: &mut Latest<S>,
    axis: Axis,
    gap: W::Whole,
    speed: W::Whole,
) {
    latest.set(axis, S::portion(gap, speed.magnitude()));
}

#[cfg(all(test, feature = "fixed"))]
mod tests {
    use crate::arithmetic::Each;
    use fixed::types::{I0F32, I4F4, I8F8, I16F16};

    use super::super::tests::{cases, clamped};
    use crate::arithmetic::{InWholeWord, WholeWord};
    use crate::query::Motion;
    use crate::query::sweep::Passing;
    use crate::query::sweep::time::Meets;
    use crate::robust::WordKernel;
    use crate::scalar::Scalar;
    use crate::shape::{Aabb, Triangle};

    fn check<S: Scalar + InWholeWord<W>, W: WholeWord>(bits: u32, of: impl Fn(i64) -> S) {
        let mut seen = [0; 2];
        cases(bits, of, |passing| {
            let exactly = passing.exactly();
            if exactly.misses::<S>() {
                return;
            }
            let expected = exactly.first_contact::<S>();
            let shapes = (passing.triangle, passing.aabb, passing.ends());
            let found = Meets { passing, last: None }.narrow_volumes::<W>();
            assert_eq!(found, Some(expected), "{shapes:?}");
            seen[usize::from(expected.axis.is_some())] += 1;
        });
        assert!(seen.iter().all(|&n| n > 1_000), "{seen:?}");
    }

    /// There is no answer for shapes whose volumes a word cannot hold.
    #[test]
    fn words_leave_what_is_far() {
        let at = |x: i32| [x, 0, 0].each(I16F16::from_bits);
        let is_known = |vertex: i32, half: i32| {
            let triangle = Triangle::new(at(vertex), at(0), at(0)).unwrap();
            let aabb = Aabb::from_center_half_extents(at(0), at(half)).unwrap();
            let motion = Motion::new(at(0), at(0)).unwrap();
            let passing = Passing::new(&triangle, &aabb, &motion);
            Meets { passing, last: None }.narrow_volumes::<i32>().is_some()
        };
        let most = (1 << 18) - 1;
        assert!(is_known(most, 0) && is_known(-most - 1, 0) && is_known(0, most / 2));
        // Twice the last extent is the end of the word, and four times it is zero.
        for (vertex, half) in [(most + 1, 0), (-most - 2, 0), (0, most), (0, 1 << 30)] {
            assert!(!is_known(vertex, half), "{vertex} {half}");
        }
    }

    #[test]
    fn words_agree_with_exact_sums() {
        check::<I4F4, i16>(7, |x| I4F4::from_bits(x.clamp(-128, 127) as i8));
        check::<I8F8, i32>(15, |x| I8F8::from_bits(x.clamp(-32768, 32767) as i16));
        check::<I16F16, i32>(16, |x| I16F16::from_bits(clamped(x)));
        check::<I16F16, i64>(31, |x| I16F16::from_bits(clamped(x)));
        check::<I0F32, i64>(31, |x| I0F32::from_bits(clamped(x)));
    }
}
