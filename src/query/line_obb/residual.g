# How far n, the residual of a crossing, may be from the truth.
# constant: RESIDUAL
# only: f64
#
# Lengths are divided by P, the direction by E, and t by P/E: P and E cover them. Axes are divided by A, which
# is one or more. Grids are absolute, so what is cut off an axis is at most 2^-26 of A. h is the sum
# of what is on the grid, which is exact; it may be any number, for only the sum r, which is small, is rounded.

# A component of r: what is cut off m has the rounding error of the difference too.
q0 = fl(k0, l0);                Q0 = k0 + l0;
a0 = fl(q0, fl(t*d0, z1));      A0 = Q0 + (t*d0 + o);
b0 = fl(a0, -fl(cx*x0, z2));    B0 = A0 + -(cx*x0 + o);
e0 = fl(b0, -fl(cy*y0, z3));    E0 = B0 + -(cy*y0 + o);
f0 = fl(e0, -fl(cz*g0, z4));    F0 = E0 + -(cz*g0 + o);
r0 = fl(h0, f0);                R0 = h0 + F0;
q1 = fl(k1, l1);                Q1 = k1 + l1;
a1 = fl(q1, fl(t*d1, z5));      A1 = Q1 + (t*d1 + o);
b1 = fl(a1, -fl(cx*x1, z6));    B1 = A1 + -(cx*x1 + o);
e1 = fl(b1, -fl(cy*y1, z7));    E1 = B1 + -(cy*y1 + o);
f1 = fl(e1, -fl(cz*g1, z8));    F1 = E1 + -(cz*g1 + o);
r1 = fl(h1, f1);                R1 = h1 + F1;
q2 = fl(k2, l2);                Q2 = k2 + l2;
a2 = fl(q2, fl(t*d2, z9));      A2 = Q2 + (t*d2 + o);
b2 = fl(a2, -fl(cx*x2, z10));   B2 = A2 + -(cx*x2 + o);
e2 = fl(b2, -fl(cy*y2, z11));   E2 = B2 + -(cy*y2 + o);
f2 = fl(e2, -fl(cz*g2, z12));   F2 = E2 + -(cz*g2 + o);
r2 = fl(h2, f2);                R2 = h2 + F2;

# A normal, and the volume.
wx = fl(fl(by*cz_, z13), -fl(bz*cy_, z14));   Wx = (by*cz_ + o) + -(bz*cy_ + o);
wy = fl(fl(bz*cx_, z15), -fl(bx*cz_, z16));   Wy = (bz*cx_ + o) + -(bx*cz_ + o);
wz = fl(fl(bx*cy_, z17), -fl(by*cx_, z18));   Wz = (bx*cy_ + o) + -(by*cx_ + o);
volume = fl(fl(fl(ax*wx, z19), fl(ay*wy, z20)), fl(az*wz, z21));
Volume = ((ax*Wx + o) + (ay*Wy + o)) + (az*Wz + o);

# How far the coordinate in the box is from the face, and n.
off = fl(c, -s);  Off = c + -s;
n = fl(fl(fl(fl(wx*r0, z22), fl(wy*r1, z23)), fl(wz*r2, z24)), fl(off*volume, z25));
N = (((Wx*R0 + o) + (Wy*R1 + o)) + (Wz*R2 + o)) + (Off*Volume + o);

bound = fl(fl(RESIDUAL*U*fl(fl(fl(1, z26), z27), z28), z29)*1b-22, z30);

{ o in [0,0] /\ |k0| <= 1b-26 /\ |k1| <= 1b-26 /\ |k2| <= 1b-26
/\ |l0| <= 1b-53 /\ |l1| <= 1b-53 /\ |l2| <= 1b-53
/\ |t| <= 2 /\ |d0| <= 1b-26 /\ |d1| <= 1b-26 /\ |d2| <= 1b-26
/\ |cx| <= 1 /\ |cy| <= 1 /\ |cz| <= 1
/\ |x0| <= 1b-26 /\ |y0| <= 1b-26 /\ |g0| <= 1b-26 /\ |x1| <= 1b-26 /\ |y1| <= 1b-26 /\ |g1| <= 1b-26
/\ |x2| <= 1b-26 /\ |y2| <= 1b-26 /\ |g2| <= 1b-26
/\ |r0| <= 1b-22 /\ |r1| <= 1b-22 /\ |r2| <= 1b-22 /\ |off| <= 1b-22
/\ |ax| <= 1 /\ |ay| <= 1 /\ |az| <= 1 /\ |bx| <= 1 /\ |by| <= 1 /\ |bz| <= 1
/\ |cx_| <= 1 /\ |cy_| <= 1 /\ |cz_| <= 1
/\ |z1| <= LOST1 /\ |z2| <= LOST1 /\ |z3| <= LOST1 /\ |z4| <= LOST1 /\ |z5| <= LOST1 /\ |z6| <= LOST1
/\ |z7| <= LOST1 /\ |z8| <= LOST1 /\ |z9| <= LOST1 /\ |z10| <= LOST1 /\ |z11| <= LOST1 /\ |z12| <= LOST1
/\ |z13| <= LOST0 /\ |z14| <= LOST0 /\ |z15| <= LOST0 /\ |z16| <= LOST0 /\ |z17| <= LOST0 /\ |z18| <= LOST0
/\ |z19| <= LOST0 /\ |z20| <= LOST0 /\ |z21| <= LOST0
/\ |z22| <= LOST1 /\ |z23| <= LOST1 /\ |z24| <= LOST1 /\ |z25| <= LOST1
/\ |z26| <= LOST0 /\ |z27| <= LOST0 /\ |z28| <= LOST1 /\ |z29| <= LOST1 /\ |z30| <= LOST1
-> |n - N| - bound <= 0 }

R0 -> r0 + -(r0 - R0);
R1 -> r1 + -(r1 - R1);
R2 -> r2 + -(r2 - R2);
Off -> off + -(off - Off);
