# How far the gap between two boxes on an axis may be from the truth.
# constant: GAP
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included.
#
# The greater of two differences, d, is one of them. d and r are divided by themselves, as
# computed, and multiplied by p and q: their magnitudes, divided by size = p + q. Below twice the
# least normal number sums are exact, and any bound will do. So size is that at least, and
# underflow takes from the product in the bound no more than half the least number, U/2, divided
# by 1 − U. Where d overflows, its sign and the gap's are right.

q = 1 - p;
d = fl(a, -b);
r = fl(h, k);
gap = fl(p*d, -(q*r));
Gap = p*(a + -b) + -(q*(h + k));
bound = fl(GAP*U*fl(p, q), e*0.51*U);

{ p in [0,1] /\ |d| <= 1 /\ |r| <= 1 /\ |a + -b| <= UP1 /\ |h + k| <= UP1 /\ |e| <= 1
-> |gap - Gap| - bound <= 0 }
$ p in 16;
