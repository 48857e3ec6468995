# How far the overlap of two shapes along a direction may be from the truth.
# constant: ROUNDOFFS
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included.
#
# The six products of coordinates of the sides x and y are divided by the greatest that is computed.
# What is a place or the product of a half-extent with a side is divided by R, the computed size, a sum
# of eighteen such numbers. The truth of each is below 1 + 32·U then. Sides and half-extents are rounded
# once. A place p is the mean of two differences, each at most R and rounded once, so that it errs by
# U·R at most, of which it does the part m; and is rounded then.
#
# For the sign of a side, the six terms of a·s are divided by the greatest that is computed: in each
# coordinate, a is multiplied by a factor that s is divided by.
#
# There are two places and six terms t = h·|a·s|. Of these all numbers h·s add up to R at most, so
# that a bound on the error of one which is relative to h·s holds for their sum. Sums of terms are at
# most 6 in truth, for a coordinate of a is at most 2: so are those that are computed, but for their
# errors. Four roundings are the most that come after a term.
#
# LOST: products of lengths that are within `RANGE` lose less than that to underflow, and those of
# `LEAST_PRODUCT` with a length.

X = 1 + 32*U;
# Two sides rounded, and their product.
Ax = (((X*c1 + o) + o) + o) + -(((X*d1 + o) + o) + o);  ax = fl(fl(fl(fl(X*c1, 0), 0), z1), -fl(fl(fl(X*d1, 0), 0), z2));
Ay = (((X*c2 + o) + o) + o) + -(((X*d2 + o) + o) + o);  ay = fl(fl(fl(fl(X*c2, 0), 0), z3), -fl(fl(fl(X*d2, 0), 0), z4));
Az = (((X*c3 + o) + o) + o) + -(((X*d3 + o) + o) + o);  az = fl(fl(fl(fl(X*c3, 0), 0), z5), -fl(fl(fl(X*d3, 0), 0), z6));

# A place.
Px = X*ex + o;  px = fl(X*ex, X*U*mx);
Py = X*ey + o;  py = fl(X*ey, X*U*my);
Pz = X*ez + o;  pz = fl(X*ez, X*U*mz);
p = fl(fl(fl(ax*px, z7), fl(ay*py, z8)), fl(az*pz, z9));
P = ((Ax*Px + o) + (Ay*Py + o)) + (Az*Pz + o);

# How a side lies, and how far a half-extent reaches.
Sx = X*fx + o;  sx = fl(X*fx, 0);
Sy = X*fy + o;  sy = fl(X*fy, 0);
Sz = X*fz + o;  sz = fl(X*fz, 0);
s = fl(fl(fl(ax*sx, z10), fl(ay*sy, z11)), fl(az*sz, z12));
S = ((Ax*Sx + o) + (Ay*Sy + o)) + (Az*Sz + o);
H = X*g + o;  h = fl(X*g, 0);
s_abs = |S| + q*(s - S);  S_abs = |S| + o;
t = fl(h*s_abs, z13);  T = H*S_abs + o;

# The sum of two places and of terms: Gappa sees one of each as they are added.
sum = fl(fl(fl(fl(t0, t1), t2), p1), -end);
Sum = (((t0 + t1) + t2) + p1) + -end;

bound = fl(ROUNDOFFS*U*fl(fl(1, z14), z15), z16);
side_bound = fl(ROUNDOFFS*0.25*U*fl(fl(1, z17), z18), z19);

{ o in [0,0] /\ |c1| <= 1 /\ |c2| <= 1 /\ |c3| <= 1 /\ |d1| <= 1 /\ |d2| <= 1 /\ |d3| <= 1 /\ |ex| <= 1
/\ |ey| <= 1 /\ |ez| <= 1 /\ |mx| <= 1 /\ |my| <= 1 /\ |mz| <= 1 /\ |fx| <= 1 /\ |fy| <= 1 /\ |fz| <= 1
/\ g in [0,1] /\ |q| <= 1 /\ |z1| <= 1b-80 /\ |z2| <= 1b-80 /\ |z3| <= 1b-80 /\ |z4| <= 1b-80
/\ |z5| <= 1b-80 /\ |z6| <= 1b-80 /\ |z7| <= 1b-80 /\ |z8| <= 1b-80 /\ |z9| <= 1b-80
/\ |z10| <= 1b-80 /\ |z11| <= 1b-80 /\ |z12| <= 1b-80 /\ |z13| <= 1b-80 /\ |z14| <= 1b-80
/\ |z15| <= 1b-80 /\ |z16| <= 1b-80 /\ |z17| <= 1b-80 /\ |z18| <= 1b-80 /\ |z19| <= 1b-80
/\ |fl(t0, t1)| <= 6.01 /\ |fl(fl(t0, t1), t2)| <= 6.01 /\ |fl(fl(fl(t0, t1), t2), p1)| <= 6.01
/\ |sum| <= 6.01
-> |p - P| - 70*U <= 0 /\ |t - T| - 70*U <= 0 /\ |sum - Sum| - 30*U <= 0 /\ 2*70*U + 70*U + 30*U - bound <= 0
/\ |s - S| - side_bound <= 0 }
