# How far an edge axis of a triangle and an axis-aligned box may be from the truth, by offsets.
# constant: OFFSET_EDGE
# only: f32
#
# Proved: |computed − true| is at most the bound as it is computed, less one roundoff of R²,
# underflow included; and nothing overflows. So much is left over for what `f64` has rounded before.
#
# All is divided by R as in `edges.g`, and named as there. Vertices and edges err by 3·U·X each, of
# which they do the part m, and half-extents are rounded once; W is 3·U and what `f64` has rounded.
# In all a span is at most 1 + 16·U in truth, and so is |v|, for no face separates.

X = 1 + 16*U;
W = 3.001*U;

# Vertex, half-extents, two edges and one of the three, on each axis.
Vy = (X*cy + o) + o;  vy = (X*cy + X*W*my) + z1;
Hy = X*(1 - sy)*gy + o;  hy = fl(X*(1 - sy)*gy, z2);
Ey = (X*sy*ey + o) + o;  dey = (X*sy*ey + X*W*ny) + z3;
Fy = (X*sy*fy + o) + o;  dfy = (X*sy*fy + X*W*oy) + z4;
By = (X*sy*by + o) + o;  dby = (X*sy*by + X*W*py) + z5;
Vz = (X*cz + o) + o;  vz = (X*cz + X*W*mz) + z6;
Hz = X*(1 - sz)*gz + o;  hz = fl(X*(1 - sz)*gz, z7);
Ez = (X*sz*ez + o) + o;  dez = (X*sz*ez + X*W*nz) + z8;
Fz = (X*sz*fz + o) + o;  dfz = (X*sz*fz + X*W*oz) + z9;
Bz = (X*sz*bz + o) + o;  dbz = (X*sz*bz + X*W*pz) + z10;

# The normal.
nx = fl(fl(dey*dfz, z11), -fl(dez*dfy, z12));
Nx = (Ey*Fz + o) + -(Ez*Fy + o);

# The edge axis across x: the other two differ by names.
p = fl(fl(dby*vz, z13), -fl(dbz*vy, z14));
P = (By*Vz + o) + -(Bz*Vy + o);
m = nx*0.5 + z15;  M = Nx*0.5 + o;
m_abs = |M| + q1*(m - M);  M_abs = |M| + o;
dby_abs = |By| + q2*(dby - By);  By_abs = |By| + o;
dbz_abs = |Bz| + q3*(dbz - Bz);  Bz_abs = |Bz| + o;
far = fl(p, m);  Far = P + M;
far_abs = |Far| + q4*(far - Far);  Far_abs = |Far| + o;
r = fl(fl(hy*dbz_abs, z16), fl(hz*dby_abs, z17));  R = (Hy*Bz_abs + o) + (Hz*By_abs + o);
rad = fl(m_abs, r);  Rad = M_abs + R;
excess = fl(far_abs, -rad);  Excess = Far_abs + -Rad;

bound = fl(OFFSET_EDGE*U*fl(1, z18), z19) - U;

{ o in [0,0] /\ sy in [0,1] /\ gy in [0,1] /\ |cy| <= 1 /\ |my| <= 1 /\ |ey| <= 1 /\ |fy| <= 1
/\ |by| <= 1 /\ |ny| <= 1 /\ |oy| <= 1 /\ |py| <= 1
/\ sz in [0,1] /\ gz in [0,1] /\ |cz| <= 1 /\ |mz| <= 1 /\ |ez| <= 1 /\ |fz| <= 1
/\ |bz| <= 1 /\ |nz| <= 1 /\ |oz| <= 1 /\ |pz| <= 1
/\ |z1| <= LOST1 /\ |z2| <= LOST1 /\ |z3| <= LOST1 /\ |z4| <= LOST1 /\ |z5| <= LOST1
/\ |z6| <= LOST1 /\ |z7| <= LOST1 /\ |z8| <= LOST1 /\ |z9| <= LOST1 /\ |z10| <= LOST1
/\ |z11| <= LOST2 /\ |z12| <= LOST2 /\ |z13| <= LOST2 /\ |z14| <= LOST2 /\ |z15| <= LOST2
/\ |z16| <= LOST2 /\ |z17| <= LOST2 /\ |z18| <= LOST2 /\ |z19| <= LOST2
/\ |q1| <= 1 /\ |q2| <= 1 /\ |q3| <= 1 /\ |q4| <= 1 /\ |Far| <= 2.00001
-> |excess - Excess| - bound <= 0 /\ |excess| <= ROOM2 }
$ sy in (0.5, 0.8, 0.95), sz in (0.5, 0.8, 0.95);
