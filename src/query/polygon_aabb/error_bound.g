# How far the distance between the plane of three vertices of a polygon and a corner of an
# axis-aligned box may be from the truth, seen from any vertex.
# constant: PLANE
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included; and nothing
# overflows. So it is with PLANE = 64, for which the case split is fine enough.
#
# All is divided by R, and named, as in `triangle_aabb/plane.g`. What differs: the vertex V need
# not be one of those whose edges are E and F, so that its product with the normal is no determinant
# of three vertices, and up to six.

X = 1 + 8*U;

# Vertex, half-extents, two edges, on each axis.
Vx = (X*cx + o) + o;  vx = fl(X*cx, X*U*mx) + z1;
Hx = (X*(1 - sx)*gx + o) + o;  hx = fl(X*(1 - sx)*gx, 0) + z2;
Ex = X*sx*ex + o;  dex = fl(X*sx*ex, 0);
Fx = X*sx*fx + o;  dfx = fl(X*sx*fx, 0);
Vy = (X*cy + o) + o;  vy = fl(X*cy, X*U*my) + z3;
Hy = (X*(1 - sy)*gy + o) + o;  hy = fl(X*(1 - sy)*gy, 0) + z4;
Ey = X*sy*ey + o;  dey = fl(X*sy*ey, 0);
Fy = X*sy*fy + o;  dfy = fl(X*sy*fy, 0);
Vz = (X*cz + o) + o;  vz = fl(X*cz, X*U*mz) + z5;
Hz = (X*(1 - sz)*gz + o) + o;  hz = fl(X*(1 - sz)*gz, 0) + z6;
Ez = X*sz*ez + o;  dez = fl(X*sz*ez, 0);
Fz = X*sz*fz + o;  dfz = fl(X*sz*fz, 0);

# The normal.
nx = fl(fl(dey*dfz, z7), -fl(dez*dfy, z8));
Nx = (Ey*Fz + o) + -(Ez*Fy + o);
ny = fl(fl(dez*dfx, z9), -fl(dex*dfz, z10));
Ny = (Ez*Fx + o) + -(Ex*Fz + o);
nz = fl(fl(dex*dfy, z11), -fl(dey*dfx, z12));
Nz = (Ex*Fy + o) + -(Ey*Fx + o);

# The plane; on its other side all changes sign.
d = fl(fl(fl(nx*vx, z13), fl(ny*vy, z14)), fl(nz*vz, z15));  D = ((Nx*Vx + o) + (Ny*Vy + o)) + (Nz*Vz + o);
nx_abs = |Nx| + q2*(nx - Nx);  Nx_abs = |Nx| + o;
ny_abs = |Ny| + q3*(ny - Ny);  Ny_abs = |Ny| + o;
nz_abs = |Nz| + q4*(nz - Nz);  Nz_abs = |Nz| + o;
w = fl(fl(fl(hx*nx_abs, z16), fl(hy*ny_abs, z17)), fl(hz*nz_abs, z18));  W = ((Hx*Nx_abs + o) + (Hy*Ny_abs + o)) + (Hz*Nz_abs + o);
beyond = fl(d, -w);  Beyond = D + -W;

bound = fl(PLANE*U*fl(fl(1, z19), z20), z21);

{ o in [0,0] /\ sx in [0,1] /\ gx in [0,1] /\ |cx| <= 1 /\ |mx| <= 1 /\ |ex| <= 1 /\ |fx| <= 1
/\ sy in [0,1] /\ gy in [0,1] /\ |cy| <= 1 /\ |my| <= 1 /\ |ey| <= 1 /\ |fy| <= 1 /\ sz in [0,1]
/\ gz in [0,1] /\ |cz| <= 1 /\ |mz| <= 1 /\ |ez| <= 1 /\ |fz| <= 1 /\ |z1| <= LOST1
/\ |z2| <= LOST1 /\ |z3| <= LOST1 /\ |z4| <= LOST1 /\ |z5| <= LOST1 /\ |z6| <= LOST1
/\ |z7| <= LOST2 /\ |z8| <= LOST2 /\ |z9| <= LOST2 /\ |z10| <= LOST2 /\ |z11| <= LOST2
/\ |z12| <= LOST2 /\ |z13| <= LOST3 /\ |z14| <= LOST3 /\ |z15| <= LOST3 /\ |z16| <= LOST3
/\ |z17| <= LOST3 /\ |z18| <= LOST3 /\ |z19| <= LOST2 /\ |z20| <= LOST3 /\ |z21| <= LOST3
/\ |q2| <= 1 /\ |q3| <= 1 /\ |q4| <= 1
-> |beyond - Beyond| - bound <= 0 /\ |beyond| <= ROOM3 }
$ sx in (0.6, 0.85, 0.97), sy in (0.6, 0.85, 0.97), sz in (0.6, 0.85, 0.97);
