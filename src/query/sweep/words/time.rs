//! When the triangle meets the box, in machine words, given that it does.
//!
//! On each of the 13 axes only the side that the triangle moves toward can have a gap at the start. The
//! sign of the speed along the axis says which side that is, and which vertex leads.

use super::{Passing, Side, Swept, along};
use crate::arithmetic::{
    InRaw, ProductSum, WholeVolume, WholeWord, greatest, least, pick, three, turn,
};
use crate::query::Axis;
use crate::query::one_sided::{Closed, beyond_edge, beyond_plane, normals};
use crate::query::sweep::FirstContact;
use crate::query::sweep::latest::Latest;
use crate::scalar::Scalar;

impl<S: Scalar + InRaw> Passing<'_, S> {
    /// The first contact, in words wide enough for shapes anywhere.
    #[inline(never)]
    pub(in crate::query::sweep) fn contact_in_any_words<W: WholeWord>(&self) -> FirstContact<S> {
        self.swept::<W>().first_contact()
    }

    /// The first contact, in words wide enough for shapes and motions near each other; `None` if they
    /// are not.
    #[inline(never)]
    pub(in crate::query::sweep) fn contact_in_near_words<W: WholeWord>(
        &self,
    ) -> Option<FirstContact<S>> {
        let swept = self.swept::<W>();
        let longest = swept.longest();
        // A difference of two lengths has one bit more.
        let is_near = longest.is_near() && longest.plus(longest).has_volumes();
        (self.is_central::<W>() && is_near).then(|| swept.first_contact())
    }
}

impl<W: WholeWord> Swept<W> {
    #[inline(always)]
    fn first_contact<S: Scalar + InRaw>(&self) -> FirstContact<S> {
        let mut latest = Latest::NONE;
        for ((i, shapes), d) in (0..).zip(&self.start).zip(self.d) {
            let ([a, b, c], size) = (shapes.t, shapes.size);
            let (low, high) = (least(least(a, b), c), greatest(greatest(a, b), c));
            let gap = greatest(low - size, W::ZERO - high);
            if gap > W::ZERO {
                close::<_, W::Whole>(&mut latest, Axis::Face(i), gap.into(), d.into());
            }
        }
        self.add_slanted::<S, W::Sum>(&mut latest);
        latest.known().unwrap_or_default()
    }

    /// The normal, and the cross products of the edges with the coordinate axes.
    #[inline(always)]
    fn add_slanted<S, A>(&self, latest: &mut Latest<S>)
    where
        S: Scalar + InRaw,
        A: ProductSum<W>,
        W: WholeWord<Sum = A>,
    {
        let n: [A; 3] = normals(&self.start);
        let along = along(&n, &self.d);
        let axes = three(|i| (n[i], self.start[i].t[0], self.start[i].size));
        let rest = beyond_plane::<W, A, Closed>(axes.into_iter(), !A::is_negative(along));
        if A::is_negative(rest) {
            close(latest, Axis::Normal, -W::whole(rest), W::whole(along));
        }
        let ([x, y, z], [dx, dy, dz]) = (&self.start, self.d);
        add_edges(latest, 0, &Side::new(n[0], [y, z], [dy, dz]));
        add_edges(latest, 1, &Side::new(n[1], [z, x], [dz, dx]));
        add_edges(latest, 2, &Side::new(n[2], [x, y], [dx, dy]));
    }
}

/// The axes that are perpendicular to coordinate axis `i`.
#[inline(never)]
fn add_edges<S: Scalar + InRaw, W: WholeWord>(
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
            close(latest, axis, -W::whole(rest.volume()), W::whole(q.volume()));
        }
    }
}

/// Adds an axis with a gap and a speed.
#[inline(never)]
fn close<S: Scalar + InRaw, V: WholeVolume>(latest: &mut Latest<S>, axis: Axis, gap: V, speed: V) {
    latest.set(axis, S::portion(gap, speed.magnitude()));
}
