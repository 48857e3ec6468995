# How far the axes of a triangle and an oriented box may be from the truth.
# constant: FACE
# constant: EDGE
# constant: PLANE
#
# Proved: |computed − true| is at most the bound as it is computed, for a face, an edge and the
# plane, underflow included; and nothing overflows. On a face r is compared after the bound has
# been added or subtracted: that rounding is part of the sum proved. `point` takes their
# difference, and the same bound.
#
# Axes are divided by A, which is 1 or more, lengths by R, and half-extents by R/A. R is the
# greatest magnitude computed, of h·A too, and in range. What is true of a difference may be
# 1 + U, for rounding keeps order; h too, for h·A is rounded.
#
# The magnitude of x, computed where X is true, is |X| + s·(x − X) for some |s| ≤ 1. Products
# with one are exact, and so is doubling.

# From the centre to a vertex, two edges, and one of the three: differences, each with its truth.
tx = fl(txp, -txq); Tx = txp + -txq;
ty = fl(typ, -tyq); Ty = typ + -tyq;
tz = fl(tzp, -tzq); Tz = tzp + -tzq;
ex = fl(exp, -exq); Ex = exp + -exq;
ey = fl(eyp, -eyq); Ey = eyp + -eyq;
ez = fl(ezp, -ezq); Ez = ezp + -ezq;
gx = fl(gxp, -gxq); Gx = gxp + -gxq;
gy = fl(gyp, -gyq); Gy = gyp + -gyq;
gz = fl(gzp, -gzq); Gz = gzp + -gzq;
dx = fl(dxp, -dxq); Dx = dxp + -dxq;
dy = fl(dyp, -dyq); Dy = dyp + -dyq;
dz = fl(dzp, -dzq); Dz = dzp + -dzq;

# The cross products of the axes a, b and c, and what makes them one.
w0x = fl(fl(by*cz, z1), -fl(bz*cy, z2));
W0x = (by*cz + o) + -(bz*cy + o);
w0y = fl(fl(bz*cx, z3), -fl(bx*cz, z4));
W0y = (bz*cx + o) + -(bx*cz + o);
w0z = fl(fl(bx*cy, z5), -fl(by*cx, z6));
W0z = (bx*cy + o) + -(by*cx + o);
w1x = fl(fl(cy*az, z7), -fl(cz*ay, z8));
W1x = (cy*az + o) + -(cz*ay + o);
w1y = fl(fl(cz*ax, z9), -fl(cx*az, z10));
W1y = (cz*ax + o) + -(cx*az + o);
w1z = fl(fl(cx*ay, z11), -fl(cy*ax, z12));
W1z = (cx*ay + o) + -(cy*ax + o);
w2x = fl(fl(ay*bz, z13), -fl(az*by, z14));
W2x = (ay*bz + o) + -(az*by + o);
w2y = fl(fl(az*bx, z15), -fl(ax*bz, z16));
W2y = (az*bx + o) + -(ax*bz + o);
w2z = fl(fl(ax*by, z17), -fl(ay*bx, z18));
W2z = (ax*by + o) + -(ay*bx + o);
volume = fl(fl(fl(ax*w0x, z19), fl(ay*w0y, z20)), fl(az*w0z, z21));
Volume = ((ax*W0x + o) + (ay*W0y + o)) + (az*W0z + o);
volume_abs = |Volume| + s1*(volume - Volume); Volume_abs = |Volume| + o;

# A face.
on = fl(fl(fl(w0x*tx, z22), fl(w0y*ty, z23)), fl(w0z*tz, z24));
On = ((W0x*Tx + o) + (W0y*Ty + o)) + (W0z*Tz + o);
on_abs = |On| + s2*(on - On); On_abs = |On| + o;
r = fl(h*volume_abs, z25); R = h*Volume_abs + o;

# The same of a point.
outside = fl(on_abs, -r); Outside = On_abs + -R;

# The plane.
nx = fl(fl(ey*gz, z26), -fl(ez*gy, z27));
Nx = (Ey*Gz + o) + -(Ez*Gy + o);
ny = fl(fl(ez*gx, z28), -fl(ex*gz, z29));
Ny = (Ez*Gx + o) + -(Ex*Gz + o);
nz = fl(fl(ex*gy, z30), -fl(ey*gx, z31));
Nz = (Ex*Gy + o) + -(Ey*Gx + o);
un0 = fl(fl(fl(ax*nx, z32), fl(ay*ny, z33)), fl(az*nz, z34));
Un0 = ((ax*Nx + o) + (ay*Ny + o)) + (az*Nz + o);
un0_abs = |Un0| + s3*(un0 - Un0); Un0_abs = |Un0| + o;
un1 = fl(fl(fl(bx*nx, z35), fl(by*ny, z36)), fl(bz*nz, z37));
Un1 = ((bx*Nx + o) + (by*Ny + o)) + (bz*Nz + o);
un1_abs = |Un1| + s4*(un1 - Un1); Un1_abs = |Un1| + o;
un2 = fl(fl(fl(cx*nx, z38), fl(cy*ny, z39)), fl(cz*nz, z40));
Un2 = ((cx*Nx + o) + (cy*Ny + o)) + (cz*Nz + o);
un2_abs = |Un2| + s5*(un2 - Un2); Un2_abs = |Un2| + o;
nt = fl(fl(fl(nx*tx, z41), fl(ny*ty, z42)), fl(nz*tz, z43));
Nt = ((Nx*Tx + o) + (Ny*Ty + o)) + (Nz*Tz + o);
nt_abs = |Nt| + s6*(nt - Nt); Nt_abs = |Nt| + o;
nr = fl(fl(fl(un0_abs*h, z44), fl(un1_abs*k, z45)), fl(un2_abs*l, z46));
Nr = ((Un0_abs*h + o) + (Un1_abs*k + o)) + (Un2_abs*l + o);
over = fl(nt_abs, -nr); Over = Nt_abs + -Nr;

# An edge: d × a. The other eight differ by names.
mx = fl(fl(dy*tz, z47), -fl(dz*ty, z48));
Mx = (Dy*Tz + o) + -(Dz*Ty + o);
my = fl(fl(dz*tx, z49), -fl(dx*tz, z50));
My = (Dz*Tx + o) + -(Dx*Tz + o);
mz = fl(fl(dx*ty, z51), -fl(dy*tx, z52));
Mz = (Dx*Ty + o) + -(Dy*Tx + o);
p = fl(fl(fl(ax*mx, z53), fl(ay*my, z54)), fl(az*mz, z55));
P = ((ax*Mx + o) + (ay*My + o)) + (az*Mz + o);
along1 = fl(fl(fl(w1x*dx, z56), fl(w1y*dy, z57)), fl(w1z*dz, z58));
Along1 = ((W1x*Dx + o) + (W1y*Dy + o)) + (W1z*Dz + o);
along1_abs = |Along1| + s7*(along1 - Along1); Along1_abs = |Along1| + o;
along2 = fl(fl(fl(w2x*dx, z59), fl(w2y*dy, z60)), fl(w2z*dz, z61));
Along2 = ((W2x*Dx + o) + (W2y*Dy + o)) + (W2z*Dz + o);
along2_abs = |Along2| + s8*(along2 - Along2); Along2_abs = |Along2| + o;
er = fl(fl(along2_abs*k, z62), fl(along1_abs*l, z63)); Er = (Along2_abs*k + o) + (Along1_abs*l + o);
far = fl(2*p, un0); Far = 2*P + Un0;
far_abs = |Far| + s9*(far - Far); Far_abs = |Far| + o;
beyond = fl(far_abs, -fl(un0_abs, 2*er)); Beyond = Far_abs + -(Un0_abs + 2*Er);

# The bounds.
face_bound = fl(FACE*U*fl(fl(1, z64), z65), z66);
edge_bound = fl(EDGE*U*fl(fl(1, z67), z68), z69);
plane_bound = fl(PLANE*U*fl(fl(1, z70), z71), z72);

{ o in [0,0] /\ |h| <= UP1 /\ |k| <= UP1 /\ |l| <= UP1 /\ |tx| <= 1 /\ |Tx| <= UP1
/\ |ty| <= 1 /\ |Ty| <= UP1 /\ |tz| <= 1 /\ |Tz| <= UP1 /\ |ex| <= 1 /\ |Ex| <= UP1
/\ |ey| <= 1 /\ |Ey| <= UP1 /\ |ez| <= 1 /\ |Ez| <= UP1 /\ |gx| <= 1 /\ |Gx| <= UP1
/\ |gy| <= 1 /\ |Gy| <= UP1 /\ |gz| <= 1 /\ |Gz| <= UP1 /\ |dx| <= 1 /\ |Dx| <= UP1
/\ |dy| <= 1 /\ |Dy| <= UP1 /\ |dz| <= 1 /\ |Dz| <= UP1 /\ |ax| <= 1 /\ |ay| <= 1 /\ |az| <= 1
/\ |bx| <= 1 /\ |by| <= 1 /\ |bz| <= 1 /\ |cx| <= 1 /\ |cy| <= 1 /\ |cz| <= 1 /\ |z1| <= LOST0
/\ |z2| <= LOST0 /\ |z3| <= LOST0 /\ |z4| <= LOST0 /\ |z5| <= LOST0 /\ |z6| <= LOST0
/\ |z7| <= LOST0 /\ |z8| <= LOST0 /\ |z9| <= LOST0 /\ |z10| <= LOST0 /\ |z11| <= LOST0
/\ |z12| <= LOST0 /\ |z13| <= LOST0 /\ |z14| <= LOST0 /\ |z15| <= LOST0 /\ |z16| <= LOST0
/\ |z17| <= LOST0 /\ |z18| <= LOST0 /\ |z19| <= LOST0 /\ |z20| <= LOST0 /\ |z21| <= LOST0
/\ |z22| <= LOST1 /\ |z23| <= LOST1 /\ |z24| <= LOST1 /\ |z25| <= LOST1 /\ |z26| <= LOST2
/\ |z27| <= LOST2 /\ |z28| <= LOST2 /\ |z29| <= LOST2 /\ |z30| <= LOST2 /\ |z31| <= LOST2
/\ |z32| <= LOST2 /\ |z33| <= LOST2 /\ |z34| <= LOST2 /\ |z35| <= LOST2 /\ |z36| <= LOST2
/\ |z37| <= LOST2 /\ |z38| <= LOST2 /\ |z39| <= LOST2 /\ |z40| <= LOST2 /\ |z41| <= LOST3
/\ |z42| <= LOST3 /\ |z43| <= LOST3 /\ |z44| <= LOST3 /\ |z45| <= LOST3 /\ |z46| <= LOST3
/\ |z47| <= LOST2 /\ |z48| <= LOST2 /\ |z49| <= LOST2 /\ |z50| <= LOST2 /\ |z51| <= LOST2
/\ |z52| <= LOST2 /\ |z53| <= LOST2 /\ |z54| <= LOST2 /\ |z55| <= LOST2 /\ |z56| <= LOST1
/\ |z57| <= LOST1 /\ |z58| <= LOST1 /\ |z59| <= LOST1 /\ |z60| <= LOST1 /\ |z61| <= LOST1
/\ |z62| <= LOST2 /\ |z63| <= LOST2 /\ |z64| <= LOST0 /\ |z65| <= LOST1 /\ |z66| <= LOST1
/\ |z67| <= LOST2 /\ |z68| <= LOST2 /\ |z69| <= LOST2 /\ |z70| <= LOST2 /\ |z71| <= LOST3
/\ |z72| <= LOST3 /\ |s1| <= 1 /\ |s2| <= 1 /\ |s3| <= 1 /\ |s4| <= 1 /\ |s5| <= 1 /\ |s6| <= 1
/\ |s7| <= 1 /\ |s8| <= 1 /\ |s9| <= 1
-> |on - On| + |r - R| + |fl(r, face_bound) - (r + face_bound)| - face_bound <= 0
/\ |on - On| + |r - R| + |fl(r, -face_bound) - (r + -face_bound)| - face_bound <= 0
/\ |outside - Outside| - face_bound <= 0
/\ |beyond - Beyond| - edge_bound <= 0
/\ |over - Over| - plane_bound <= 0
/\ |beyond| <= ROOM2 /\ |over| <= ROOM3 }
