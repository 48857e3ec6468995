# How far the values of t of a prepared ray may be from the truth.
# constant: CORNERS
# constant: CENTER
#
# Proved: by corners, where the computed f is not below n plus the bound, as that sum is computed,
# the true f is above the true n; likewise where it is nine roundoffs above n, which ten units in the
# last place are at least. By centre the errors of n and f, and the rounding of the sum with the
# bound, are together at most the bound as it is computed. Why no t underflows is in
# `error_bound.rs`; a bound that is subnormal errs by half the least number, which is at most U/2.
#
# A t takes four roundings at most, in 64-bit integers: of a difference, where the direction is
# converted, of a reciprocal and of a product.

# By corners: t is divided by |n|. The true n is at most |n|/(1 − U)⁴, and the true f at least
# f/(1 + U)⁴: that is more than f·(1 − U)⁴.
bound = fl(CORNERS*U*1, e*0.5*U);
down = (1 - U)*(1 - U)*(1 - U)*(1 - U);
sum = fl(1, bound);
units = 1 + (CORNERS - 1)*U;
less = fl(1, -bound);

# By centre: divided by the greatest |p·r| + h·|r|, as computed but for the last rounding. w is the
# magnitude of p·r as computed, and the rest that of h·|r|, or less.
v = 1 - w;
pi = fl(fl(fl(fl(a, 0), 0), 0), 0);
Pi = (((a + o) + o) + o) + o;
hi = fl(fl(fl(fl(b, 0), 0), 0), 0);
Hi = (((b + o) + o) + o) + o;
n = fl(w*pi, -(v*hi));
N = w*Pi + -(v*Hi);
x = 1 - y;
pj = fl(fl(fl(fl(c, 0), 0), 0), 0);
Pj = (((c + o) + o) + o) + o;
hj = fl(fl(fl(fl(d, 0), 0), 0), 0);
Hj = (((d + o) + o) + o) + o;
f = fl(y*pj, x*hj);
F = y*Pj + x*Hj;
error = fl(CENTER*U*fl(1, 0), e*0.5*U);

{ o in [0,0] /\ |e| <= 1.01 /\ w in [0,1] /\ y in [0,1]
/\ |pi| <= 1 /\ |hi| <= 1 /\ |pj| <= 1 /\ |hj| <= 1
/\ |a| <= 1.000001 /\ |b| <= 1.000001 /\ |c| <= 1.000001 /\ |d| <= 1.000001
-> sum*down*down - 1 >= 0 /\ units*down*down - 1 >= 0 /\ 1*down*down - less >= 0
/\ |n - N| + |f - F| + |fl(n, error) - (n + error)| - error <= 0
/\ |n - N| + |f - F| + |fl(n, -error) - (n + -error)| - error <= 0 }
$ w in 8, y in 8;
