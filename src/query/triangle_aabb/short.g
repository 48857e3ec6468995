# How far a vertex and the greatest corner of a box, cut to words, may be from the truth together, relative to the
# least corner of the box.
# constant: ERROR
# only: f64
#
# Proved: |computed − true| of both add up to at most what `short.rs` grows the box by, for a box given by its
# centre and by its corners. There is no float in this: int<zr> rounds toward zero.
#
# Names: a is a coordinate of a vertex, p and q are those of the box; t is the vertex relative to the least corner, and
# s the greatest corner. The truth is in capitals.
a = int<zr>(A);
p = int<zr>(P);
q = int<zr>(Q);

# Centre and half-extents.
t = a - (p - q);  T = A - (P - Q);
s = q + q;        S = Q + Q;

# Corners.
v = a - p;  V = A - P;
w = q - p;  W = Q - P;

{ |A| <= 1b29 /\ |P| <= 1b29 /\ |Q| <= 1b29 ->
  |t - T| + |s - S| <= ERROR /\ |v - V| + |w - W| <= ERROR }
