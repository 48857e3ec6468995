# How far the face of the box around an oriented box may be from the truth.
# constant: SUMS
# only: f64
#
# Proved: the errors of three sums, and of adding or subtracting the margin, are together at most
# the margin as it is computed. Products of `f32` are exact in `f64`: nothing
# underflows.
#
# The extent a + b + d, as computed, is divided by itself and multiplied by p, the centre by itself
# and multiplied by q: p + q = 1.

q = 1 - p;
extent = fl(fl(a, b), d);
Extent = (a + b) + d;
middle = fl(p*extent, q*c);
Middle = p*Extent + q*c;
margin = fl(SUMS*U*fl(q, p), 0);

{ p in [0,1] /\ |c| <= 1 /\ |extent| <= 1 /\ |fl(a, b) + d| <= UP1 /\ |fl(a, b)| <= UP1
/\ |a + b| <= UP4
-> |middle - Middle| + |fl(middle, -margin) - (middle + -margin)| - margin <= 0
/\ |middle - Middle| + |fl(middle, margin) - (middle + margin)| - margin <= 0 }
$ p in 4;
