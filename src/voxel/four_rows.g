# How far from the truth it may be where the plane of the triangle crosses a row.
# constant: PLANE
# only: f32
#
# Proved: the side of the triangle's plane on which a corner of the block lies is the side that it seems
# if the distance along x, as computed, is more than the bound. Distances are times the normal's x:
# volumes.
#
# All lengths are divided by L, the greatest extent, and are at most one. A place errs by E, what is
# given divided by L: at least U, for the rounding to `f32` is in it, and at most 2^-10. The bound is
# computed by some roundings, which 1 - 8*U allows for.

# The normal, as in few.g, and the way from a vertex to a corner.
Dx = dxt + o;  dx = fl(dxt, E*b1);  Dy = dyt + o;  dy = fl(dyt, E*b2);  Dz = dzt + o;  dz = fl(dzt, E*b3);
Ex = ext + o;  ex = fl(ext, E*b4);  Ey = eyt + o;  ey = fl(eyt, E*b5);  Ez = ezt + o;  ez = fl(ezt, E*b6);
Fx = fxt + o;  fx = fxt + E*b7;     Fy = fyt + o;  fy = fyt + E*b8;     Fz = fzt + o;  fz = fzt + E*b9;
nx = fl(fl(dy*ez, y3*(U*U)), -fl(dz*ey, y4*(U*U)));
Nx = (Dy*Ez + o) + -(Dz*Ey + o);
ny = fl(fl(dz*ex, y5*(U*U)), -fl(dx*ez, y6*(U*U)));
Ny = (Dz*Ex + o) + -(Dx*Ez + o);
nz = fl(fl(dx*ey, y7*(U*U)), -fl(dy*ex, y8*(U*U)));
Nz = (Dx*Ey + o) + -(Dy*Ex + o);

# The slopes times nx: a quotient and a product each. Then 1/2 - b and 1/2 - c, the products with
# the slopes, the sums with a, and - 1/2; the layer's product and sum, the row's; the sum of the
# slopes' sizes, that and the bound, and the sum of all.
sy = ny + r1*(U*4.3);
sz = nz + r2*(U*4.3);
off = ((nx*fx + sy*fy) + sz*fz) +
      ((((r3*(U*2.2) + r4*(U*2.2)) + (r5*(U*2.2) + r6*(U*2.2))) + ((r7*(U*4.4) + r8*(U*6.6)) + r9*(U*7.7))) +
       (((r10*(U*2.2) + r11*(U*9.9)) + (r12*(U*2.2) + r13*(U*12.1))) + ((r14*(U*2.2) + r15*(U*2.7)) + r16*(U*15))));
Sy = Ny + o;
Sz = Nz + o;
Off = ((Nx*Fx + Sy*Fy) + Sz*Fz) + o;
plane = PLANE*E*(1 - 8*U);

{ o in [0,0] /\ E in [1b-24, 1b-10]
/\ |dxt| <= 1.016 /\ |dyt| <= 1.016 /\ |dzt| <= 1.016 /\ |ext| <= 1.016 /\ |eyt| <= 1.016 /\ |ezt| <= 1.016
/\ |fxt| <= 1.016 /\ |fyt| <= 1.016 /\ |fzt| <= 1.016
/\ |b1| <= 2.00001 /\ |b2| <= 2.00001 /\ |b3| <= 2.00001 /\ |b4| <= 2.00001 /\ |b5| <= 2.00001
/\ |b6| <= 2.00001 /\ |b7| <= 2.00001 /\ |b8| <= 2.00001 /\ |b9| <= 2.00001
/\ |y3| <= 1 /\ |y4| <= 1 /\ |y5| <= 1 /\ |y6| <= 1 /\ |y7| <= 1 /\ |y8| <= 1
/\ |r1| <= 1 /\ |r2| <= 1 /\ |r3| <= 1 /\ |r4| <= 1 /\ |r5| <= 1 /\ |r6| <= 1 /\ |r7| <= 1 /\ |r8| <= 1
/\ |r9| <= 1 /\ |r10| <= 1 /\ |r11| <= 1 /\ |r12| <= 1 /\ |r13| <= 1 /\ |r14| <= 1 /\ |r15| <= 1 /\ |r16| <= 1
-> |off - Off| - plane <= 0 }
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
