# How far the distance between the plane of a triangle and a corner of an axis-aligned box may be
# from the truth, by offsets.
# constant: OFFSET_PLANE
# only: f32
#
# Proved: |computed − true| is at most the bound as it is computed, less one roundoff of R³,
# underflow included; and nothing overflows. So much is left over for what `f64` has rounded before.
#
# All is divided by R as in `edges.g`, and named as there and in `plane.g`; what errs by how much is
# as in `offset_edges.g`. The determinant of the vertices is 4·X³ at most.

X = 1 + 16*U;
W = 3.001*U;

# Vertex, half-extents, an edge and the next, on each axis.
Vx = (X*cx + o) + o;  vx = (X*cx + X*W*mx) + z1;
Hx = X*(1 - sx)*gx + o;  hx = fl(X*(1 - sx)*gx, z2);
Ex = (X*sx*ex + o) + o;  dex = (X*sx*ex + X*W*ix) + z3;
Fx = (X*sx*fx + o) + o;  dfx = (X*sx*fx + X*W*jx) + z4;
Vy = (X*cy + o) + o;  vy = (X*cy + X*W*my) + z5;
Hy = X*(1 - sy)*gy + o;  hy = fl(X*(1 - sy)*gy, z6);
Ey = (X*sy*ey + o) + o;  dey = (X*sy*ey + X*W*iy) + z7;
Fy = (X*sy*fy + o) + o;  dfy = (X*sy*fy + X*W*jy) + z8;
Vz = (X*cz + o) + o;  vz = (X*cz + X*W*mz) + z9;
Hz = X*(1 - sz)*gz + o;  hz = fl(X*(1 - sz)*gz, z10);
Ez = (X*sz*ez + o) + o;  dez = (X*sz*ez + X*W*iz) + z11;
Fz = (X*sz*fz + o) + o;  dfz = (X*sz*fz + X*W*jz) + z12;

# The normal.
nx = fl(fl(dey*dfz, z13), -fl(dez*dfy, z14));
Nx = (Ey*Fz + o) + -(Ez*Fy + o);
ny = fl(fl(dez*dfx, z15), -fl(dex*dfz, z16));
Ny = (Ez*Fx + o) + -(Ex*Fz + o);
nz = fl(fl(dex*dfy, z17), -fl(dey*dfx, z18));
Nz = (Ex*Fy + o) + -(Ey*Fx + o);

# The plane.
d = fl(fl(fl(nx*vx, z19), fl(ny*vy, z20)), fl(nz*vz, z21));
D = ((Nx*Vx + o) + (Ny*Vy + o)) + (Nz*Vz + o);
d_abs = |D| + q1*(d - D);  D_abs = |D| + o;
nx_abs = |Nx| + q2*(nx - Nx);  Nx_abs = |Nx| + o;
ny_abs = |Ny| + q3*(ny - Ny);  Ny_abs = |Ny| + o;
nz_abs = |Nz| + q4*(nz - Nz);  Nz_abs = |Nz| + o;
w = fl(fl(fl(hx*nx_abs, z22), fl(hy*ny_abs, z23)), fl(hz*nz_abs, z24));
W1 = ((Hx*Nx_abs + o) + (Hy*Ny_abs + o)) + (Hz*Nz_abs + o);
beyond = fl(d_abs, -w);  Beyond = D_abs + -W1;

bound = fl(OFFSET_PLANE*U*fl(fl(1, z25), z26), z27) - U;

{ o in [0,0] /\ sx in [0,1] /\ gx in [0,1] /\ |cx| <= 1 /\ |mx| <= 1 /\ |ex| <= 1 /\ |ix| <= 1
/\ |fx| <= 1 /\ |jx| <= 1 /\ sy in [0,1] /\ gy in [0,1] /\ |cy| <= 1 /\ |my| <= 1 /\ |ey| <= 1
/\ |iy| <= 1 /\ |fy| <= 1 /\ |jy| <= 1 /\ sz in [0,1] /\ gz in [0,1] /\ |cz| <= 1 /\ |mz| <= 1
/\ |ez| <= 1 /\ |iz| <= 1 /\ |fz| <= 1 /\ |jz| <= 1 /\ |z1| <= LOST1 /\ |z2| <= LOST1
/\ |z3| <= LOST1 /\ |z4| <= LOST1 /\ |z5| <= LOST1 /\ |z6| <= LOST1 /\ |z7| <= LOST1
/\ |z8| <= LOST1 /\ |z9| <= LOST1 /\ |z10| <= LOST1 /\ |z11| <= LOST1 /\ |z12| <= LOST1
/\ |z13| <= LOST2 /\ |z14| <= LOST2 /\ |z15| <= LOST2 /\ |z16| <= LOST2 /\ |z17| <= LOST2
/\ |z18| <= LOST2 /\ |z19| <= LOST3 /\ |z20| <= LOST3 /\ |z21| <= LOST3 /\ |z22| <= LOST3
/\ |z23| <= LOST3 /\ |z24| <= LOST3 /\ |z25| <= LOST2 /\ |z26| <= LOST3 /\ |z27| <= LOST3
/\ |q1| <= 1 /\ |q2| <= 1 /\ |q3| <= 1 /\ |q4| <= 1 /\ |D| <= 4.00001
-> |beyond - Beyond| - bound <= 0 /\ |beyond| <= ROOM3 }
$ sx in (0.6, 0.85, 0.97), sy in (0.6, 0.85, 0.97), sz in (0.6, 0.85, 0.97);
