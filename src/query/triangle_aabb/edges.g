# How far an edge axis of a triangle and an axis-aligned box may be from the truth.
# constant: EDGE
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included; and nothing
# overflows. So it is with EDGE = 24, for which the case split is fine enough.
#
# All is divided by R, the greatest computed h + s, with h the half-extent of the box and s the
# extent of the triangle on an axis. These are rounded, so h + s is at most 1 + 4·U in truth, and so
# is |v|, for no face separates. X is above both. In the script s is the extent divided by X: on each
# axis an edge is at most X·s, h at most X·(1 − s), a vertex at most X. In the frame of a box by its
# corners a vertex is the mean of two differences. Their magnitudes add up to twice the greater of
# |v| and h, so it errs by U·X at most, of which it does the part m. Then it is rounded and, as
# half-extents are, halved.
#
# The magnitude of x, computed where X is true, is |X| + q·(x − X) for some |q| ≤ 1. What the edge's
# vertices and the opposite one project to is 2·X² at most each, and Far is the mean of both.

X = 1 + 8*U;

# Vertex, half-extents, two edges and one of the three, on each axis.
Vy = (X*cy + o) + o;  vy = fl(X*cy, X*U*my) + z1;
Hy = (X*(1 - sy)*gy + o) + o;  hy = fl(X*(1 - sy)*gy, 0) + z2;
Ey = X*sy*ey + o;  dey = fl(X*sy*ey, 0);
Fy = X*sy*fy + o;  dfy = fl(X*sy*fy, 0);
By = X*sy*by + o;  dby = fl(X*sy*by, 0);
Vz = (X*cz + o) + o;  vz = fl(X*cz, X*U*mz) + z3;
Hz = (X*(1 - sz)*gz + o) + o;  hz = fl(X*(1 - sz)*gz, 0) + z4;
Ez = X*sz*ez + o;  dez = fl(X*sz*ez, 0);
Fz = X*sz*fz + o;  dfz = fl(X*sz*fz, 0);
Bz = X*sz*bz + o;  dbz = fl(X*sz*bz, 0);

# The normal.
nx = fl(fl(dey*dfz, z5), -fl(dez*dfy, z6));
Nx = (Ey*Fz + o) + -(Ez*Fy + o);

# The edge axis across x: the other two differ by names.
p = fl(fl(dby*vz, z7), -fl(dbz*vy, z8));
P = (By*Vz + o) + -(Bz*Vy + o);
m = nx*0.5 + z9;  M = Nx*0.5 + o;
m_abs = |M| + q1*(m - M);  M_abs = |M| + o;
dby_abs = |By| + q2*(dby - By);  By_abs = |By| + o;
dbz_abs = |Bz| + q3*(dbz - Bz);  Bz_abs = |Bz| + o;
far = fl(p, m);  Far = P + M;
far_abs = |Far| + q4*(far - Far);  Far_abs = |Far| + o;
r = fl(fl(hy*dbz_abs, z10), fl(hz*dby_abs, z11));  R = (Hy*Bz_abs + o) + (Hz*By_abs + o);
rad = fl(m_abs, r);  Rad = M_abs + R;
excess = fl(far_abs, -rad);  Excess = Far_abs + -Rad;

bound = fl(EDGE*U*fl(1, z12), z13);

{ o in [0,0] /\ sy in [0,1] /\ gy in [0,1] /\ |cy| <= 1 /\ |my| <= 1 /\ |ey| <= 1 /\ |fy| <= 1
/\ |by| <= 1 /\ sz in [0,1] /\ gz in [0,1] /\ |cz| <= 1 /\ |mz| <= 1 /\ |ez| <= 1 /\ |fz| <= 1
/\ |bz| <= 1 /\ |z1| <= LOST1 /\ |z2| <= LOST1 /\ |z3| <= LOST1 /\ |z4| <= LOST1 /\ |z5| <= LOST2
/\ |z6| <= LOST2 /\ |z7| <= LOST2 /\ |z8| <= LOST2 /\ |z9| <= LOST2 /\ |z10| <= LOST2
/\ |z11| <= LOST2 /\ |z12| <= LOST2 /\ |z13| <= LOST2 /\ |q1| <= 1 /\ |q2| <= 1 /\ |q3| <= 1
/\ |q4| <= 1 /\ |Far| <= 2.00001
-> |excess - Excess| - bound <= 0 /\ |excess| <= ROOM2 }
$ sy in (0.5, 0.8, 0.95), sz in (0.5, 0.8, 0.95);
