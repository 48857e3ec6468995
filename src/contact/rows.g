# How far the overlap of two boxes along a direction, and a term of it, may be from the truth.
# constant: ROUNDOFFS
# only: f32
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included.
#
# Axes are divided by their greatest coordinate M, the way between the centres by the size R, and
# half-extents by R/M. All are below one then, and their truths below 1 + 2·U. Each has a rounding,
# and roundings of `f64` before, which take less than r·U.
#
# There is a way and there are four terms t = h·|a·s|. A coordinate of a is at most 2 in truth, so
# that a term is at most 6, and a sum of terms with the way at most 30, but for errors.
#
# LOST: numbers are within `AXES` and `SIZES`, so that underflow takes less from a product than 2^-80.

X = 1 + 8*U;
# The products of two coordinates of axes, which are rounded before.
Ax = (((X*c1 + o) + o) + o) + -(((X*d1 + o) + o) + o);  ax = fl(fl(fl(fl(X*c1, r1), r2), z1), -fl(fl(fl(X*d1, r3), r4), z2));
Ay = (((X*c2 + o) + o) + o) + -(((X*d2 + o) + o) + o);  ay = fl(fl(fl(fl(X*c2, r5), r6), z3), -fl(fl(fl(X*d2, r7), r8), z4));
Az = (((X*c3 + o) + o) + o) + -(((X*d3 + o) + o) + o);  az = fl(fl(fl(fl(X*c3, r9), r10), z5), -fl(fl(fl(X*d3, r11), r12), z6));

# The way.
Px = X*ex + o;  px = fl(X*ex, r13);
Py = X*ey + o;  py = fl(X*ey, r14);
Pz = X*ez + o;  pz = fl(X*ez, r15);
p = fl(fl(fl(ax*px, z7), fl(ay*py, z8)), fl(az*pz, z9));
P = ((Ax*Px + o) + (Ay*Py + o)) + (Az*Pz + o);

# How far a half-extent reaches.
Sx = X*fx + o;  sx = fl(X*fx, r16);
Sy = X*fy + o;  sy = fl(X*fy, r17);
Sz = X*fz + o;  sz = fl(X*fz, r18);
s = fl(fl(fl(ax*sx, z10), fl(ay*sy, z11)), fl(az*sz, z12));
S = ((Ax*Sx + o) + (Ay*Sy + o)) + (Az*Sz + o);
H = X*g + o;  h = fl(X*g, r19);
s_abs = |S| + q*(s - S);  S_abs = |S| + o;
t = fl(h*s_abs, z13);  T = H*S_abs + o;

# The sum of four terms, in the order with the most roundings, and the way.
sum = fl(fl(t0, fl(fl(t1, t2), t3)), -w);
Sum = (t0 + ((t1 + t2) + t3)) + -w;

# M²·R has two roundings, the factor one.
bound = fl(fl(ROUNDOFFS*U*fl(fl(1, z14), z15), z16), z17);

{ o in [0,0] /\ |c1| <= 1 /\ |c2| <= 1 /\ |c3| <= 1 /\ |d1| <= 1 /\ |d2| <= 1 /\ |d3| <= 1 /\ |ex| <= 1
/\ |ey| <= 1 /\ |ez| <= 1 /\ |fx| <= 1 /\ |fy| <= 1 /\ |fz| <= 1 /\ g in [0,1] /\ |q| <= 1
/\ |r1| <= 1b-45 /\ |r2| <= 1b-45 /\ |r3| <= 1b-45 /\ |r4| <= 1b-45 /\ |r5| <= 1b-45 /\ |r6| <= 1b-45
/\ |r7| <= 1b-45 /\ |r8| <= 1b-45 /\ |r9| <= 1b-45 /\ |r10| <= 1b-45 /\ |r11| <= 1b-45 /\ |r12| <= 1b-45
/\ |r13| <= 1b-45 /\ |r14| <= 1b-45 /\ |r15| <= 1b-45 /\ |r16| <= 1b-45 /\ |r17| <= 1b-45
/\ |r18| <= 1b-45 /\ |r19| <= 1b-45
/\ |z1| <= 1b-80 /\ |z2| <= 1b-80 /\ |z3| <= 1b-80 /\ |z4| <= 1b-80 /\ |z5| <= 1b-80 /\ |z6| <= 1b-80
/\ |z7| <= 1b-80 /\ |z8| <= 1b-80 /\ |z9| <= 1b-80 /\ |z10| <= 1b-80 /\ |z11| <= 1b-80 /\ |z12| <= 1b-80
/\ |z13| <= 1b-80 /\ |z14| <= 1b-80 /\ |z15| <= 1b-80 /\ |z16| <= 1b-80 /\ |z17| <= 1b-80
/\ |fl(t1, t2)| <= 12.01 /\ |fl(fl(t1, t2), t3)| <= 18.01 /\ |fl(t0, fl(fl(t1, t2), t3))| <= 24.01
/\ |sum| <= 30.01
-> |p - P| - 60*U <= 0 /\ |t - T| - 75*U <= 0 /\ |sum - Sum| - 90*U <= 0
/\ 4*75*U + 60*U + 90*U - bound <= 0 }
