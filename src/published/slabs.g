# That slabs never miss: how far the values of t may be from the truth.
# constant: PADDING
#
# Proved: if the line enters slab i no later than it leaves slab j, then n, the computed t of
# entry, is at most f + margin as it is computed, f being that of exit: for the errors of both and
# the rounding of the sum together are at most the margin. And a box by its centre, padded, has no
# face within the truth. Underflow included.
#
# The way to a face and the reciprocal are divided by themselves, as computed, and products
# multiplied by p and q: the magnitudes of n and f but for their last rounding, divided by size = p
# + q. A reciprocal, s in truth, does not underflow, for components beyond `invertible` are ignored.
# What underflow takes from a product is below the least number, 2·U times the least normal number.
# So, if size ≥ (least normal)/(8·U), it is below 16·U²·size: `margin` is the one relative to size,
# without the least normal number that the code adds. If size is less, divide by (least
# normal)/(8·U) instead: p and q are less, and the least normal number, `small`, is 8·U.

ri = fl(si, 0);
rj = fl(sj, 0);
q = 1 - p;
n = fl(p*(fl(ai, -oi)*ri), e*(16*U*U));
N = p*((ai + -oi)*(si + o)) + o;
f = fl(q*(fl(aj, -oj)*rj), g*(16*U*U));
F = q*((aj + -oj)*(sj + o)) + o;
margin = fl(PADDING*U*fl(p*fl(1, k*U), q*fl(1, l*U)), m*(16*U*U));
small = 8*U;

# A box by its centre: w is the magnitude of the way to it as computed, h the half-extent, both
# divided by their sum. If that is below the least normal number, sums are exact and any padding
# will do. If not, underflow takes from the product at most half the least number, divided by
# 1 − U.
h = 1 - w;
way = fl(c, -b);
padding = fl(PADDING*0.5*U*fl(w, h), r*1.01*U);
grown = fl(h, padding);
face = fl(w*way, -grown);

{ p in [0,1] /\ w in [0,1] /\ o in [0,0]
/\ |fl(ai, -oi)| <= 1 /\ |ai + -oi| <= UP1 /\ ri in [1,1] /\ |si| <= UP1
/\ |fl(aj, -oj)| <= 1 /\ |aj + -oj| <= UP1 /\ rj in [1,1] /\ |sj| <= UP1
/\ |e| <= 1 /\ |g| <= 1 /\ |m| <= 1 /\ |k| <= 1 /\ |l| <= 1
/\ |way| <= 1 /\ |c + -b| <= UP1 /\ |r| <= 1
-> |n - N| + |f - F| + |fl(f, margin) - (f + margin)| - margin <= 0
/\ |n - N| + |f - F| + |fl(f, small) - (f + small)| - small <= 0
/\ |w*way - w*(c + -b)| + |grown - (h + padding)| + |face - (w*way + -grown)| - padding <= 0 }
$ p in 8, w in 8;
