# How far w·e, a component of e × w, and (D·n)·(e × w) may be from the truth, with w = m − t·d and
# n = e × d.
# constant: ALONG
# constant: MINOR
# constant: SIDE
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included; and nothing
# overflows.
#
# e is a difference, divided by R, its greatest component; d is divided by D, its own. m is a
# difference, divided by W, as are the products t·d: W is twice the greater of the two magnitudes, as
# computed. R² and D² are in range, and W is. So what a product of up to six loses to underflow is
# below LOST3 in this scale, t·d apart, and six have ROOM3. What is true of a difference may be 1 + U,
# and of the half 1 + U of that, for rounding keeps order.

ex = fl(axp, -axq); Ex = axp + -axq;
ey = fl(ayp, -ayq); Ey = ayp + -ayq;
ez = fl(azp, -azq); Ez = azp + -azq;
mx = fl(pxp, -pxq); Mx = pxp + -pxq; sx = fl(tx, l1); Sx = tx + o;
my = fl(pyp, -pyq); My = pyp + -pyq; sy = fl(ty, l2); Sy = ty + o;
mz = fl(pzp, -pzq); Mz = pzp + -pzq; sz = fl(tz, l3); Sz = tz + o;
wx = fl(mx, -sx); Wx = Mx + -Sx;
wy = fl(my, -sy); Wy = My + -Sy;
wz = fl(mz, -sz); Wz = Mz + -Sz;

along = fl(fl(fl(wx*ex, z1), fl(wy*ey, z2)), fl(wz*ez, z3));
Along = ((Wx*Ex + o) + (Wy*Ey + o)) + (Wz*Ez + o);
vx = fl(fl(wz*ey, z4), -fl(wy*ez, z5));
Vx = (Wz*Ey + o) + -(Wy*Ez + o);
vy = fl(fl(wx*ez, z6), -fl(wz*ex, z7));
Vy = (Wx*Ez + o) + -(Wz*Ex + o);
vz = fl(fl(wy*ex, z8), -fl(wx*ey, z9));
Vz = (Wy*Ex + o) + -(Wx*Ey + o);
nx = fl(fl(ey*dz, y1), -fl(ez*dy, y2));
Nx = (Ey*dz + o) + -(Ez*dy + o);
ny = fl(fl(ez*dx, y3), -fl(ex*dz, y4));
Ny = (Ez*dx + o) + -(Ex*dz + o);
nz = fl(fl(ex*dy, y5), -fl(ey*dx, y6));
Nz = (Ex*dy + o) + -(Ey*dx + o);
fx = fl(nx, y7); Fx = Nx + o;
fy = fl(ny, y8); Fy = Ny + o;
fz = fl(nz, y9); Fz = Nz + o;
side = fl(fl(fl(fx*vx, x1), fl(fy*vy, x2)), fl(fz*vz, x3));
Side = ((Fx*Vx + o) + (Fy*Vy + o)) + (Fz*Vz + o);

volume = fl(1, x4);
other = fl(fl(1, x5), x6);
along_bound = fl(ALONG*U*volume, x7);
minor_bound = fl(MINOR*U*volume, x8);
side_bound = fl(SIDE*U*fl(other*volume, x9), x10);

{ o in [0,0] /\ |ex| <= 1 /\ |Ex| <= UP1 /\ |ey| <= 1 /\ |Ey| <= UP1 /\ |ez| <= 1 /\ |Ez| <= UP1
/\ |mx| <= 0.5 /\ |Mx| <= 0.50001 /\ |sx| <= 0.5 /\ |Sx| <= 0.50001 /\ |dx| <= 1
/\ |my| <= 0.5 /\ |My| <= 0.50001 /\ |sy| <= 0.5 /\ |Sy| <= 0.50001 /\ |dy| <= 1
/\ |mz| <= 0.5 /\ |Mz| <= 0.50001 /\ |sz| <= 0.5 /\ |Sz| <= 0.50001 /\ |dz| <= 1
/\ |l1| <= LOST2 /\ |l2| <= LOST2 /\ |l3| <= LOST2
/\ |z1| <= LOST3 /\ |z2| <= LOST3 /\ |z3| <= LOST3 /\ |z4| <= LOST3 /\ |z5| <= LOST3
/\ |z6| <= LOST3 /\ |z7| <= LOST3 /\ |z8| <= LOST3 /\ |z9| <= LOST3 /\ |y1| <= LOST3
/\ |y2| <= LOST3 /\ |y3| <= LOST3 /\ |y4| <= LOST3 /\ |y5| <= LOST3 /\ |y6| <= LOST3
/\ |y7| <= LOST3 /\ |y8| <= LOST3 /\ |y9| <= LOST3 /\ |x1| <= LOST3 /\ |x2| <= LOST3
/\ |x3| <= LOST3 /\ |x4| <= LOST3 /\ |x5| <= LOST3 /\ |x6| <= LOST3 /\ |x7| <= LOST3
/\ |x8| <= LOST3 /\ |x9| <= LOST3 /\ |x10| <= LOST3
-> |along - Along| - along_bound <= 0 /\ |vx - Vx| - minor_bound <= 0
/\ |side - Side| - side_bound <= 0 /\ |side| <= ROOM3 }
