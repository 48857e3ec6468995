# How far a comparison of two products in `line_aabb` may be from the truth.
# constant: ROUNDOFFS
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included.
#
# Of near_i·m_j − far_j·m_i: lengths of each axis are divided by what cannot be exceeded there,
# s = |along| + half as computed but for the last rounding; magnitudes by themselves, as
# computed. Products are multiplied by p = s_i·m_j and q = s_j·m_i, all divided by size = p + q.
# A box by its corners is one with half = 0, whose sums round nothing; a line along a given
# direction one with magnitudes as given; a comparison of t·m with a face has fewer products.
#
# What underflow takes from a product is below the least number, 2·U times the least normal
# number. So, if size ≥ (least normal)/(8·U), it is below 16·U²·size: `bound` is the one relative
# to size, without the least normal number that the code adds. If size is less than that, divide
# by (least normal)/(8·U) instead: p and q are less, and the least normal number, `small`, is 8·U.
# An overflow makes the size infinite, or a NaN, and leaves the query in doubt.

ni = fl(fl(ci, -oi), -hi);
Ni = (ci + -oi) + -hi;
mj = fl(bj, -aj);
Mj = bj + -aj;
fj = fl(fl(cj, -oj), hj);
Fj = (cj + -oj) + hj;
mi = fl(bi, -ai);
Mi = bi + -ai;
q = 1 - p;
gap = fl(fl(p*(ni*mj), e*(16*U*U)), -fl(q*(fj*mi), g*(16*U*U)));
Gap = (p*(Ni*Mj) + o) + -(q*(Fj*Mi) + o);
size = fl(fl(p*fl(1,0), k*(16*U*U)), fl(q*fl(1,0), l*(16*U*U)));
bound = fl(ROUNDOFFS*U*size, n*(16*U*U));
small = 8*U;

# Whether a box lies at t < −1 or t > 1, in one dimension: sums only, and the product in the
# bound, where s + m is 1. If s + m is below twice the least normal number, sums are exact and
# any bound will do. If not, underflow takes at most U of it.
r = 1 - s;
gap_of_one = fl(s*ni, -(r*mi));
Gap_of_one = s*Ni + -(r*Mi);
bound_of_one = fl(ROUNDOFFS*U*fl(s*fl(1,0), r), f*U);

{ p in [0,1] /\ s in [0,1] /\ o in [0,0]
/\ |fl(ci, -oi)| <= 1 /\ |ci + -oi| <= UP1 /\ |fl(ci, -oi) + -hi| <= 1 /\ |Ni| <= UP1
/\ |fl(cj, -oj)| <= 1 /\ |cj + -oj| <= UP1 /\ |fl(cj, -oj) + hj| <= 1 /\ |Fj| <= UP1
/\ mi in [1,1] /\ mj in [1,1] /\ |Mi| <= UP1 /\ |Mj| <= UP1
/\ |e| <= 1 /\ |f| <= 1 /\ |g| <= 1 /\ |k| <= 1 /\ |l| <= 1 /\ |n| <= 1
-> |gap - Gap| - bound <= 0 /\ |gap - Gap| - small <= 0
/\ |gap_of_one - Gap_of_one| - bound_of_one <= 0 }
$ p in 16, s in 16;
