# How far apart a triangle that moves past an axis-aligned box and the box are at one time, on an axis
# with areas: how far that may be from the truth.
# constant: EDGE
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included; and nothing
# overflows.
#
# All is as in `edge.g`; t is the time. What the triangle is above the box is the gap; what it is
# below has the same form with the other sign. With t = 1 this is the least gap of all the way.

X = 1 + 8*U;

Vy = (X*cy + o) + o;  vy = fl(X*cy, X*U*my) + z1;
Hy = (X*gy + o) + o;  hy = fl(X*gy, 0) + z2;
Ey = X*ey + o;  dey = fl(X*ey, 0);
Fy = X*fy + o;  dfy = fl(X*fy, 0);
By = X*by + o;  dby = fl(X*by, 0);
Wy = X*wy + o;  dwy = fl(X*wy, 0);
Vz = (X*cz + o) + o;  vz = fl(X*cz, X*U*mz) + z3;
Hz = (X*gz + o) + o;  hz = fl(X*gz, 0) + z4;
Ez = X*ez + o;  dez = fl(X*ez, 0);
Fz = X*fz + o;  dfz = fl(X*fz, 0);
Bz = X*bz + o;  dbz = fl(X*bz, 0);
Wz = X*wz + o;  dwz = fl(X*wz, 0);

nx = fl(fl(dey*dfz, z5), -fl(dez*dfy, z6));  Nx = (Ey*Fz + o) + -(Ez*Fy + o);
qx = fl(fl(dby*dwz, z7), -fl(dbz*dwy, z8));  Qx = (By*Wz + o) + -(Bz*Wy + o);
p = fl(fl(dby*vz, z9), -fl(dbz*vy, z10));  P = (By*Vz + o) + -(Bz*Vy + o);
m = nx*0.5 + z11;  M = Nx*0.5 + o;
w = fl(qx*t, z12);  W = Qx*t + o;
m_abs = |M| + q1*(m - M);  M_abs = |M| + o;
dby_abs = |By| + q3*(dby - By);  By_abs = |By| + o;
dbz_abs = |Bz| + q4*(dbz - Bz);  Bz_abs = |Bz| + o;
r = fl(fl(hy*dbz_abs, z13), fl(hz*dby_abs, z14));  R = (Hy*Bz_abs + o) + (Hz*By_abs + o);
above = fl(fl(p, m), -fl(m_abs, r));  Above = (P + M) + -(M_abs + R);
gap = fl(above, w);  Gap = Above + W;

bound = fl(EDGE*U*fl(1, z15), z16);

{ o in [0,0] /\ t in [0,1] /\ gy in [0,1] /\ |cy| <= 1 /\ |my| <= 1 /\ |ey| <= 1 /\ |fy| <= 1 /\ |by| <= 1 /\ |wy|
<= 1 /\ gz in [0,1] /\ |cz| <= 1 /\ |mz| <= 1 /\ |ez| <= 1 /\ |fz| <= 1 /\ |bz| <= 1 /\ |wz| <= 1 /\
|z1| <= LOST1 /\ |z2| <= LOST1 /\ |z3| <= LOST1 /\ |z4| <= LOST1 /\ |z5| <= LOST2 /\ |z6| <= LOST2
/\ |z7| <= LOST2 /\ |z8| <= LOST2 /\ |z9| <= LOST2 /\ |z10| <= LOST2 /\ |z11| <= LOST2 /\ |z12| <=
LOST2 /\ |z13| <= LOST2 /\ |z14| <= LOST2 /\ |z15| <= LOST2 /\ |z16| <= LOST2 /\ |q1| <= 1 /\ |q3| <= 1 /\ |q4| <= 1
-> |gap - Gap| - bound <= 0 /\ |gap| <= ROOM2 }
