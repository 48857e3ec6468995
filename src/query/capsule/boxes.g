# How far a coordinate of the vector from a point to a corner of a box around a centre may be from the
# truth.
# constant: APART
#
# Proved: |computed − true| is at most the bound as it is computed.
#
# All numbers are divided by S, the greatest of the half-extent and of the difference to the centre as
# computed; what is true of that may be 1 + U, for rounding keeps order. The bound may underflow: that
# is a roundoff of S at most if S is a normal number, and else the differences are exact.

d = fl(p, -a); D = p + -a;
low = fl(d, -q); Low = D + -q;
bound = fl(APART*U, k);

{ |d| <= 1 /\ |D| <= UP1 /\ |q| <= 1 /\ |k| <= U -> |low - Low| - bound <= 0 }
