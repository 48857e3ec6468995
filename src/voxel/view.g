# How far from the truth it may be where an edge crosses a plane.
# constant: EDGE
# only: f32
#
# Proved: the side of a plane of the block on which an edge crosses another is the side that it seems if
# the distance, as computed, is more than the bound. Distances are times dv: areas.
#
# All lengths are divided by L, the greatest extent, and are at most one. A place errs by E, what is
# given divided by L: at least U, for the rounding to `f32` is in it, and at most 2^-10. The bound is
# computed by some roundings, which 1 - 8*U allows for.

# An edge, and the way from its vertex to where the lines u = k and v = C cross. Lines and vertices
# as computed are numbers; only the edge is rounded once more.
Du = dut + o;  du = fl(dut, E*a1);  Dv = dvt + o;  dv = fl(dvt, E*a2);
Wu = wut + o;  wu = wut + E*a3;     Wv = wvt + o;  wv = wvt + E*a4;

# The slope, times dv; then (1/2 - v0)*s, + u0, - 1/2, the half of |s|, the bound, q*s, and the sum
# of all: what is left of them is the way to C by the slope.
slope = du + z1*(U*1.04);
across = (dv*wu + -(slope*wv)) + ((z2*(U*1.09) + z3*(U*1.09)) +
         (((z4*(U*2.2) + z5*(U*2.8)) + (z6*(U*3.4) + z7*(U*3.5))) + (z8*(U*1.1) + z9*(U*4.7))));
Slope = Du + o;
Across = (Dv*Wu + -(Slope*Wv)) + o;
edge = EDGE*E*(1 - 8*U);

{ o in [0,0] /\ E in [1b-24, 1b-10]
/\ |dut| <= 1.016 /\ |dvt| <= 1.016 /\ |wut| <= 1.016 /\ |wvt| <= 1.016
/\ |a1| <= 2.00001 /\ |a2| <= 2.00001 /\ |a3| <= 2.00001 /\ |a4| <= 2.00001
/\ |z1| <= 1 /\ |z2| <= 1 /\ |z3| <= 1 /\ |z4| <= 1 /\ |z5| <= 1 /\ |z6| <= 1 /\ |z7| <= 1 /\ |z8| <= 1 /\ |z9| <= 1
-> |across - Across| - edge <= 0 }
$ E in (6.497e-8, 7.082e-8, 7.719e-8, 8.414e-8, 9.171e-8, 9.996e-8, 1.090e-7, 1.188e-7, 1.295e-7,
  1.411e-7, 1.538e-7, 1.676e-7, 1.827e-7, 1.992e-7, 2.171e-7, 2.366e-7, 2.579e-7, 2.812e-7,
  3.065e-7, 3.340e-7, 3.641e-7, 3.969e-7, 4.326e-7, 4.715e-7, 5.140e-7, 5.602e-7, 6.107e-7,
  6.656e-7, 7.255e-7, 7.908e-7, 8.620e-7, 9.396e-7, 1.024e-6, 1.116e-6, 1.217e-6, 1.326e-6,
  1.446e-6, 1.576e-6, 1.718e-6, 1.872e-6, 2.041e-6, 2.224e-6, 2.424e-6, 2.643e-6, 2.881e-6,
  3.140e-6, 3.422e-6, 3.730e-6, 4.066e-6, 4.432e-6, 4.831e-6, 5.266e-6, 5.740e-6, 6.256e-6,
  6.819e-6, 7.433e-6, 8.102e-6, 8.831e-6, 9.626e-6, 1.049e-5, 1.144e-5, 1.247e-5, 1.359e-5,
  1.481e-5, 1.614e-5, 1.760e-5, 1.918e-5, 2.091e-5, 2.279e-5, 2.484e-5, 2.707e-5, 2.951e-5,
  3.217e-5, 3.506e-5, 3.822e-5, 4.166e-5, 4.541e-5, 4.949e-5, 5.395e-5, 5.880e-5, 6.410e-5,
  6.986e-5, 7.615e-5, 8.301e-5, 9.048e-5, 9.862e-5, 1.075e-4, 1.172e-4, 1.277e-4, 1.392e-4,
  1.517e-4, 1.654e-4, 1.803e-4, 1.965e-4, 2.142e-4, 2.335e-4, 2.545e-4, 2.774e-4, 3.023e-4,
  3.296e-4, 3.592e-4, 3.915e-4, 4.268e-4, 4.652e-4, 5.071e-4, 5.527e-4, 6.024e-4, 6.567e-4,
  7.158e-4, 7.802e-4, 8.504e-4, 9.269e-4);
