# How far apart a triangle that moves past an axis-aligned box and the box are at one time, on the
# normal of the triangle: how far that may be from the truth.
# constant: VOLUME
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included; and nothing
# overflows.
#
# All is as in `volume.g`; t is the time. Q is the normal. That A and B are E and F is not used.

X = 1 + 8*U;

Vx = (X*cx + o) + o;  vx = fl(X*cx, X*U*mx) + z1;
Hx = (X*gx + o) + o;  hx = fl(X*gx, 0) + z2;
Ax = X*ax + o;  dax = fl(X*ax, 0);
Bx = X*bx + o;  dbx = fl(X*bx, 0);
Ex = X*ex + o;  dex = fl(X*ex, 0);
Fx = X*fx + o;  dfx = fl(X*fx, 0);
Dx = X*dx + o;  ddx = fl(X*dx, 0);
Vy = (X*cy + o) + o;  vy = fl(X*cy, X*U*my) + z3;
Hy = (X*gy + o) + o;  hy = fl(X*gy, 0) + z4;
Ay = X*ay + o;  day = fl(X*ay, 0);
By = X*by + o;  dby = fl(X*by, 0);
Ey = X*ey + o;  dey = fl(X*ey, 0);
Fy = X*fy + o;  dfy = fl(X*fy, 0);
Dy = X*dy + o;  ddy = fl(X*dy, 0);
Vz = (X*cz + o) + o;  vz = fl(X*cz, X*U*mz) + z5;
Hz = (X*gz + o) + o;  hz = fl(X*gz, 0) + z6;
Az = X*az + o;  daz = fl(X*az, 0);
Bz = X*bz + o;  dbz = fl(X*bz, 0);
Ez = X*ez + o;  dez = fl(X*ez, 0);
Fz = X*fz + o;  dfz = fl(X*fz, 0);
Dz = X*dz + o;  ddz = fl(X*dz, 0);

qx = fl(fl(day*dbz, z7), -fl(daz*dby, z8));  Qx = (Ay*Bz + o) + -(Az*By + o);
qy = fl(fl(daz*dbx, z9), -fl(dax*dbz, z10));  Qy = (Az*Bx + o) + -(Ax*Bz + o);
qz = fl(fl(dax*dby, z11), -fl(day*dbx, z12));  Qz = (Ax*By + o) + -(Ay*Bx + o);
nx = fl(fl(dey*dfz, z13), -fl(dez*dfy, z14));  Nx = (Ey*Fz + o) + -(Ez*Fy + o);
ny = fl(fl(dez*dfx, z15), -fl(dex*dfz, z16));  Ny = (Ez*Fx + o) + -(Ex*Fz + o);
nz = fl(fl(dex*dfy, z17), -fl(dey*dfx, z18));  Nz = (Ex*Fy + o) + -(Ey*Fx + o);
p = fl(fl(fl(qx*vx, z19), fl(qy*vy, z20)), fl(qz*vz, z21));  P = ((Qx*Vx + o) + (Qy*Vy + o)) + (Qz*Vz + o);
s = fl(fl(fl(nx*ddx, z22), fl(ny*ddy, z23)), fl(nz*ddz, z24));  S = ((Nx*Dx + o) + (Ny*Dy + o)) + (Nz*Dz + o);
w = fl(s*t, z25);  W = S*t + o;
qx_abs = |Qx| + q2*(qx - Qx);  Qx_abs = |Qx| + o;
qy_abs = |Qy| + q3*(qy - Qy);  Qy_abs = |Qy| + o;
qz_abs = |Qz| + q4*(qz - Qz);  Qz_abs = |Qz| + o;
reach = fl(fl(fl(qx_abs*hx, z26), fl(qy_abs*hy, z27)), fl(qz_abs*hz, z28));
Reach = ((Qx_abs*Hx + o) + (Qy_abs*Hy + o)) + (Qz_abs*Hz + o);
above = fl(p, -reach);  Above = P + -Reach;
gap = fl(above, w);  Gap = Above + W;

bound = fl(VOLUME*U*fl(fl(1, z29), z30), z31);

{ o in [0,0] /\ t in [0,1] /\ gx in [0,1] /\ |cx| <= 1 /\ |mx| <= 1 /\ |ax| <= 1 /\ |bx| <= 1 /\ |ex| <= 1 /\ |fx|
<= 1 /\ |dx| <= 1 /\ gy in [0,1] /\ |cy| <= 1 /\ |my| <= 1 /\ |ay| <= 1 /\ |by| <= 1 /\ |ey| <= 1 /\
|fy| <= 1 /\ |dy| <= 1 /\ gz in [0,1] /\ |cz| <= 1 /\ |mz| <= 1 /\ |az| <= 1 /\ |bz| <= 1 /\ |ez| <=
1 /\ |fz| <= 1 /\ |dz| <= 1 /\ |z1| <= LOST1 /\ |z2| <= LOST1 /\ |z3| <= LOST1 /\ |z4| <= LOST1 /\
|z5| <= LOST1 /\ |z6| <= LOST1 /\ |z7| <= LOST2 /\ |z8| <= LOST2 /\ |z9| <= LOST2 /\ |z10| <= LOST2
/\ |z11| <= LOST2 /\ |z12| <= LOST2 /\ |z13| <= LOST2 /\ |z14| <= LOST2 /\ |z15| <= LOST2 /\ |z16|
<= LOST2 /\ |z17| <= LOST2 /\ |z18| <= LOST2 /\ |z19| <= LOST3 /\ |z20| <= LOST3 /\ |z21| <= LOST3
/\ |z22| <= LOST3 /\ |z23| <= LOST3 /\ |z24| <= LOST3 /\ |z25| <= LOST3 /\ |z26| <= LOST3 /\ |z27|
<= LOST3 /\ |z28| <= LOST3 /\ |z29| <= LOST2 /\ |z30| <= LOST3 /\ |z31| <= LOST3 /\
|q2| <= 1 /\ |q3| <= 1 /\ |q4| <= 1
-> |gap - Gap| - bound <= 0 /\ |gap| <= ROOM3 }
