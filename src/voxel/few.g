# How far areas and volumes in a block of a few voxels may be from the truth.
# constant: AREA
# constant: VOLUME
# only: f32
#
# Proved: |computed − true| is at most the bound as it is computed.
#
# All lengths are divided by L, the greatest extent, and are at most one. A place errs by E,
# what is given divided by L: at least U, for the rounding to `f32` is in it, and at most 2^-7. It is
# computed by three roundings, and each bound by three more, which 1 - 8*U allows for. The true
# distances between planes and vertices are up to 2·E longer.

# Edges, and ways from a vertex to a crossing, on each axis.
Dx = dxt + o;  dx = fl(dxt, E*a1);  Dy = dyt + o;  dy = fl(dyt, E*a2);  Dz = dzt + o;  dz = fl(dzt, E*a3);
Ex = ext + o;  ex = fl(ext, E*a4);  Ey = eyt + o;  ey = fl(eyt, E*a5);  Ez = ezt + o;  ez = fl(ezt, E*a6);
Fx = fxt + o;  fx = fl(fxt, E*a7);  Fy = fyt + o;  fy = fl(fyt, E*a8);  Fz = fzt + o;  fz = fl(fzt, E*a9);

# The area of an edge and such a way, or of two edges: the components of the normal.
out = fl(fl(ey*fx, z1*(U*U)), -fl(ex*fy, z2*(U*U)));
Out = (Ey*Fx + o) + -(Ex*Fy + o);
nx = fl(fl(dy*ez, z3*(U*U)), -fl(dz*ey, z4*(U*U)));
Nx = (Dy*Ez + o) + -(Dz*Ey + o);
ny = fl(fl(dz*ex, z5*(U*U)), -fl(dx*ez, z6*(U*U)));
Ny = (Dz*Ex + o) + -(Dx*Ez + o);
nz = fl(fl(dx*ey, z7*(U*U)), -fl(dy*ex, z8*(U*U)));
Nz = (Dx*Ey + o) + -(Dy*Ex + o);

# The volume.
above = fl(fl(fl(nx*fx, z9*(U*U)), fl(ny*fy, z10*(U*U))), fl(nz*fz, z11*(U*U)));
Above = ((Nx*Fx + o) + (Ny*Fy + o)) + (Nz*Fz + o);

area = AREA*E*(1 - 8*U);
volume = VOLUME*E*(1 - 8*U);

{ o in [0,0] /\ E in [1b-24, 1b-7]
/\ |dxt| <= 1.016 /\ |dyt| <= 1.016 /\ |dzt| <= 1.016 /\ |ext| <= 1.016 /\ |eyt| <= 1.016 /\ |ezt| <= 1.016
/\ |fxt| <= 1.016 /\ |fyt| <= 1.016 /\ |fzt| <= 1.016
/\ |a1| <= 2.00001 /\ |a2| <= 2.00001 /\ |a3| <= 2.00001 /\ |a4| <= 2.00001 /\ |a5| <= 2.00001
/\ |a6| <= 2.00001 /\ |a7| <= 2.00001 /\ |a8| <= 2.00001 /\ |a9| <= 2.00001
/\ |z1| <= 1 /\ |z2| <= 1 /\ |z3| <= 1 /\ |z4| <= 1 /\ |z5| <= 1 /\ |z6| <= 1
/\ |z7| <= 1 /\ |z8| <= 1 /\ |z9| <= 1 /\ |z10| <= 1 /\ |z11| <= 1
-> |out - Out| - area <= 0 /\ |nx - Nx| - area <= 0 /\ |above - Above| - volume <= 0 }
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
  7.158e-4, 7.802e-4, 8.504e-4, 9.269e-4, 1.010e-3, 1.101e-3, 1.200e-3, 1.308e-3, 1.426e-3,
  1.555e-3, 1.694e-3, 1.847e-3, 2.013e-3, 2.194e-3, 2.392e-3, 2.607e-3, 2.842e-3, 3.098e-3,
  3.376e-3, 3.680e-3, 4.011e-3, 4.372e-3, 4.766e-3, 5.195e-3, 5.662e-3, 6.172e-3, 6.728e-3,
  7.333e-3);
