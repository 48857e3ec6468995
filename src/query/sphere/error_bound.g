# How far the numbers that say where a point lies may be from the truth: a component of a cross
# product, a dot product, and a volume.
# constant: MINOR
# constant: DOT
# constant: VOLUME
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included; and the square
# of a volume does not overflow.
#
# Each vector is divided by R, the greatest of all components. R lies where R² is in range, so that
# what a product of up to four lengths loses to underflow is below LOST2 in this scale, and six
# lengths have ROOM3. A vector is made of a difference, and h, which is zero but for a segment given
# by its centre. What is true of the difference may be 1 + U, for rounding keeps order, and of the
# sum with h (1 + U)².

ax = fl(fl(axp, -axq), axh); Ax = (axp + -axq) + axh;
ay = fl(fl(ayp, -ayq), ayh); Ay = (ayp + -ayq) + ayh;
az = fl(fl(azp, -azq), azh); Az = (azp + -azq) + azh;
bx = fl(fl(bxp, -bxq), bxh); Bx = (bxp + -bxq) + bxh;
by = fl(fl(byp, -byq), byh); By = (byp + -byq) + byh;
bz = fl(fl(bzp, -bzq), bzh); Bz = (bzp + -bzq) + bzh;
cx = fl(fl(cxp, -cxq), cxh); Cx = (cxp + -cxq) + cxh;
cy = fl(fl(cyp, -cyq), cyh); Cy = (cyp + -cyq) + cyh;
cz = fl(fl(czp, -czq), czh); Cz = (czp + -czq) + czh;

nx = fl(fl(ay*bz, z1), -fl(az*by, z2));
Nx = (Ay*Bz + o) + -(Az*By + o);
ny = fl(fl(az*bx, z3), -fl(ax*bz, z4));
Ny = (Az*Bx + o) + -(Ax*Bz + o);
nz = fl(fl(ax*by, z5), -fl(ay*bx, z6));
Nz = (Ax*By + o) + -(Ay*Bx + o);
dot = fl(fl(fl(ax*bx, z7), fl(ay*by, z8)), fl(az*bz, z9));
Dot = ((Ax*Bx + o) + (Ay*By + o)) + (Az*Bz + o);
volume = fl(fl(fl(nx*cx, z10), fl(ny*cy, z11)), fl(nz*cz, z12));
Volume = ((Nx*Cx + o) + (Ny*Cy + o)) + (Nz*Cz + o);

area = fl(1, z13);
minor_bound = fl(MINOR*U*area, z14);
dot_bound = fl(DOT*U*area, z15);
volume_bound = fl(VOLUME*U*fl(area, z16), z17);

{ o in [0,0] /\ |ax| <= 1 /\ |Ax| <= UP4 /\ |axp + -axq| <= UP1 /\ |axh| <= 1 /\ |ay| <= 1
/\ |Ay| <= UP4 /\ |ayp + -ayq| <= UP1 /\ |ayh| <= 1 /\ |az| <= 1 /\ |Az| <= UP4
/\ |azp + -azq| <= UP1 /\ |azh| <= 1 /\ |bx| <= 1 /\ |Bx| <= UP4 /\ |bxp + -bxq| <= UP1
/\ |bxh| <= 1 /\ |by| <= 1 /\ |By| <= UP4 /\ |byp + -byq| <= UP1 /\ |byh| <= 1 /\ |bz| <= 1
/\ |Bz| <= UP4 /\ |bzp + -bzq| <= UP1 /\ |bzh| <= 1 /\ |cx| <= 1 /\ |Cx| <= UP4
/\ |cxp + -cxq| <= UP1 /\ |cxh| <= 1 /\ |cy| <= 1 /\ |Cy| <= UP4 /\ |cyp + -cyq| <= UP1
/\ |cyh| <= 1 /\ |cz| <= 1 /\ |Cz| <= UP4 /\ |czp + -czq| <= UP1 /\ |czh| <= 1 /\ |z1| <= LOST2
/\ |z2| <= LOST2 /\ |z3| <= LOST2 /\ |z4| <= LOST2 /\ |z5| <= LOST2 /\ |z6| <= LOST2
/\ |z7| <= LOST2 /\ |z8| <= LOST2 /\ |z9| <= LOST2 /\ |z10| <= LOST2 /\ |z11| <= LOST2
/\ |z12| <= LOST2 /\ |z13| <= LOST2 /\ |z14| <= LOST2 /\ |z15| <= LOST2 /\ |z16| <= LOST2
/\ |z17| <= LOST2
-> |nx - Nx| - minor_bound <= 0 /\ |dot - Dot| - dot_bound <= 0
/\ |volume - Volume| - volume_bound <= 0 /\ |volume * volume| <= ROOM3 }
