# How far a computed volume (a × b)·c may be from the truth.
# constant: VOLUME
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included; and
# nothing overflows.
#
# Each vector is divided by its size, which is in range. It is made of a difference, and h, which
# is zero but for a segment given by its centre. What is true of the difference may be 1 + U, for
# rounding keeps order, and of the sum with h (1 + U)².

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
volume = fl(fl(fl(nx*cx, z7), fl(ny*cy, z8)), fl(nz*cz, z9));
Volume = ((Nx*Cx + o) + (Ny*Cy + o)) + (Nz*Cz + o);

bound = fl(VOLUME*U*fl(fl(1, z10), z11), z12);

{ o in [0,0] /\ |ax| <= 1 /\ |Ax| <= UP4 /\ |axp + -axq| <= UP1 /\ |axh| <= 1 /\ |ay| <= 1
/\ |Ay| <= UP4 /\ |ayp + -ayq| <= UP1 /\ |ayh| <= 1 /\ |az| <= 1 /\ |Az| <= UP4
/\ |azp + -azq| <= UP1 /\ |azh| <= 1 /\ |bx| <= 1 /\ |Bx| <= UP4 /\ |bxp + -bxq| <= UP1
/\ |bxh| <= 1 /\ |by| <= 1 /\ |By| <= UP4 /\ |byp + -byq| <= UP1 /\ |byh| <= 1 /\ |bz| <= 1
/\ |Bz| <= UP4 /\ |bzp + -bzq| <= UP1 /\ |bzh| <= 1 /\ |cx| <= 1 /\ |Cx| <= UP4
/\ |cxp + -cxq| <= UP1 /\ |cxh| <= 1 /\ |cy| <= 1 /\ |Cy| <= UP4 /\ |cyp + -cyq| <= UP1
/\ |cyh| <= 1 /\ |cz| <= 1 /\ |Cz| <= UP4 /\ |czp + -czq| <= UP1 /\ |czh| <= 1 /\ |z1| <= LOST2
/\ |z2| <= LOST2 /\ |z3| <= LOST2 /\ |z4| <= LOST2 /\ |z5| <= LOST2 /\ |z6| <= LOST2
/\ |z7| <= LOST3 /\ |z8| <= LOST3 /\ |z9| <= LOST3 /\ |z10| <= LOST2 /\ |z11| <= LOST3
/\ |z12| <= LOST3
-> |volume - Volume| - bound <= 0
/\ |volume| <= ROOM3 }
