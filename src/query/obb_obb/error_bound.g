# How far the axes of two oriented boxes may be from the truth.
# constant: COORDINATE
# constant: BOXES
#
# Proved: |computed − true| is at most the bound as it is computed, for a face and a pair of axes,
# underflow included; and nothing overflows.
#
# Axes are divided by A, which is 1 or more, the way d by R, and half-extents by R/A. R is the
# greatest magnitude computed, of h·A too, and in range. One box is axis-aligned and given by its
# corners p and q: what holds of that holds of other forms, which round less. Of the truth h may be
# 1 + U, for rounding keeps order, and d 1 + 4·U (see `plane_aabb`). The axes of both boxes are a,
# b, c and e, f, g; what loses most to underflow is meant where it is less.
#
# The magnitude of x, computed where X is true, is |X| + s·(x − X) for some |s| ≤ 1. Products with
# one are exact.

dx = fl(fl(xm, -xp), fl(xm, -xq)) * 0.5 + z1;
Dx = ((xm + -xp) + (xm + -xq)) * 0.5 + o;
dy = fl(fl(ym, -yp), fl(ym, -yq)) * 0.5 + z2;
Dy = ((ym + -yp) + (ym + -yq)) * 0.5 + o;
dz = fl(fl(zm, -zp), fl(zm, -zq)) * 0.5 + z3;
Dz = ((zm + -zp) + (zm + -zq)) * 0.5 + o;
h = fl(hq, -hp) * 0.5 + z4; H = (hq + -hp) * 0.5 + o;
i = fl(iq, -ip) * 0.5 + z5; I = (iq + -ip) * 0.5 + o;
j = fl(jq, -jp) * 0.5 + z6; J = (jq + -jp) * 0.5 + o;

# A coordinate.
dx_abs = |Dx| + s90*(dx - Dx); Dx_abs = |Dx| + o;
span = fl(fl(fl(fl(h*ax, z91), fl(i*bx, z92)), fl(j*cx, z93)), fl(fl(fl(k*ex, z94), fl(l*fx, z95)), fl(m*gx, z96)));
Span = (((H*ax + o) + (I*bx + o)) + (J*cx + o)) + (((k*ex + o) + (l*fx + o)) + (m*gx + o));
apart = fl(dx_abs, -span); Apart = Dx_abs + -Span;

# A face of the first box, and what both reach there.
wx = fl(fl(by*cz, z7), -fl(bz*cy, z8));
Wx = (by*cz + o) + -(bz*cy + o);
wy = fl(fl(bz*cx, z9), -fl(bx*cz, z10));
Wy = (bz*cx + o) + -(bx*cz + o);
wz = fl(fl(bx*cy, z11), -fl(by*cx, z12));
Wz = (bx*cy + o) + -(by*cx + o);
volume = fl(fl(fl(ax*wx, z13), fl(ay*wy, z14)), fl(az*wz, z15));
Volume = ((ax*Wx + o) + (ay*Wy + o)) + (az*Wz + o);
volume_abs = |Volume| + s1*(volume - Volume); Volume_abs = |Volume| + o;
one = fl(fl(fl(wx*ex, z16), fl(wy*ey, z17)), fl(wz*ez, z18));
One = ((Wx*ex + o) + (Wy*ey + o)) + (Wz*ez + o);
one_abs = |One| + s2*(one - One); One_abs = |One| + o;
two = fl(fl(fl(wx*fx, z19), fl(wy*fy, z20)), fl(wz*fz, z21));
Two = ((Wx*fx + o) + (Wy*fy + o)) + (Wz*fz + o);
two_abs = |Two| + s3*(two - Two); Two_abs = |Two| + o;
three = fl(fl(fl(wx*gx, z22), fl(wy*gy, z23)), fl(wz*gz, z24));
Three = ((Wx*gx + o) + (Wy*gy + o)) + (Wz*gz + o);
three_abs = |Three| + s4*(three - Three); Three_abs = |Three| + o;
way = fl(fl(fl(wx*dx, z25), fl(wy*dy, z26)), fl(wz*dz, z27));
Way = ((Wx*Dx + o) + (Wy*Dy + o)) + (Wz*Dz + o);
way_abs = |Way| + s5*(way - Way); Way_abs = |Way| + o;
reach = fl(fl(h*volume_abs, z28), fl(fl(fl(k*one_abs, z29), fl(l*two_abs, z30)), fl(m*three_abs, z31)));
Reach = (H*Volume_abs + o) + (((k*One_abs + o) + (l*Two_abs + o)) + (m*Three_abs + o));
beyond = fl(way_abs, -reach); Beyond = Way_abs + -Reach;

# The same of the second box: h, i and j are those with errors.
reach2 = fl(fl(k*volume_abs, z32), fl(fl(fl(h*one_abs, z33), fl(i*two_abs, z34)), fl(j*three_abs, z35)));
Reach2 = (k*Volume_abs + o) + (((H*One_abs + o) + (I*Two_abs + o)) + (J*Three_abs + o));
beyond2 = fl(way_abs, -reach2); Beyond2 = Way_abs + -Reach2;

# A pair of axes.
nx = fl(fl(dy*az, z36), -fl(dz*ay, z37));
Nx = (Dy*az + o) + -(Dz*ay + o);
ny = fl(fl(dz*ax, z38), -fl(dx*az, z39));
Ny = (Dz*ax + o) + -(Dx*az + o);
nz = fl(fl(dx*ay, z40), -fl(dy*ax, z41));
Nz = (Dx*ay + o) + -(Dy*ax + o);
pair = fl(fl(fl(nx*ex, z42), fl(ny*ey, z43)), fl(nz*ez, z44));
Pair = ((Nx*ex + o) + (Ny*ey + o)) + (Nz*ez + o);
pair_abs = |Pair| + s6*(pair - Pair); Pair_abs = |Pair| + o;
reach3 = fl(fl(fl(h*one_abs, z45), fl(i*two_abs, z46)), fl(fl(k*three_abs, z47), fl(l*volume_abs, z48)));
Reach3 = ((H*One_abs + o) + (I*Two_abs + o)) + ((k*Three_abs + o) + (l*Volume_abs + o));
beyond3 = fl(pair_abs, -reach3); Beyond3 = Pair_abs + -Reach3;

coordinate_bound = fl(COORDINATE*U, z97);
bound = fl(BOXES*U*fl(fl(1, z49), z50), z51);

{ o in [0,0] /\ |s90| <= 1 /\ |z91| <= LOST1 /\ |z92| <= LOST1 /\ |z93| <= LOST1 /\ |z94| <= LOST1
/\ |z95| <= LOST1 /\ |z96| <= LOST1 /\ |z97| <= LOST1
/\ |ax| <= 1 /\ |ay| <= 1 /\ |az| <= 1 /\ |bx| <= 1 /\ |by| <= 1 /\ |bz| <= 1
/\ |cx| <= 1 /\ |cy| <= 1 /\ |cz| <= 1 /\ |ex| <= 1 /\ |ey| <= 1 /\ |ez| <= 1 /\ |fx| <= 1
/\ |fy| <= 1 /\ |fz| <= 1 /\ |gx| <= 1 /\ |gy| <= 1 /\ |gz| <= 1 /\ |z1| <= LOST1 /\ |Dx| <= UP4
/\ |dx| <= 1 /\ |xm + -xp| <= 2.0000003 /\ |xm + -xq| <= 2.0000003 /\ |z2| <= LOST1 /\ |Dy| <= UP4
/\ |dy| <= 1 /\ |ym + -yp| <= 2.0000003 /\ |ym + -yq| <= 2.0000003 /\ |z3| <= LOST1 /\ |Dz| <= UP4
/\ |dz| <= 1 /\ |zm + -zp| <= 2.0000003 /\ |zm + -zq| <= 2.0000003 /\ |z4| <= LOST1 /\ |H| <= UP1
/\ |h| <= 1 /\ |z5| <= LOST1 /\ |I| <= UP1 /\ |i| <= 1 /\ |z6| <= LOST1 /\ |J| <= UP1 /\ |j| <= 1
/\ |k| <= 1 /\ |l| <= 1 /\ |m| <= 1 /\ |z7| <= LOST0 /\ |z8| <= LOST0 /\ |z9| <= LOST0
/\ |z10| <= LOST0 /\ |z11| <= LOST0 /\ |z12| <= LOST0 /\ |z13| <= LOST0 /\ |z14| <= LOST0
/\ |z15| <= LOST0 /\ |s1| <= 1 /\ |z16| <= LOST0 /\ |z17| <= LOST0 /\ |z18| <= LOST0 /\ |s2| <= 1
/\ |z19| <= LOST0 /\ |z20| <= LOST0 /\ |z21| <= LOST0 /\ |s3| <= 1 /\ |z22| <= LOST0
/\ |z23| <= LOST0 /\ |z24| <= LOST0 /\ |s4| <= 1 /\ |z25| <= LOST1 /\ |z26| <= LOST1
/\ |z27| <= LOST1 /\ |s5| <= 1 /\ |z28| <= LOST1 /\ |z29| <= LOST1 /\ |z30| <= LOST1
/\ |z31| <= LOST1 /\ |z32| <= LOST1 /\ |z33| <= LOST1 /\ |z34| <= LOST1 /\ |z35| <= LOST1
/\ |z36| <= LOST1 /\ |z37| <= LOST1 /\ |z38| <= LOST1 /\ |z39| <= LOST1 /\ |z40| <= LOST1
/\ |z41| <= LOST1 /\ |z42| <= LOST1 /\ |z43| <= LOST1 /\ |z44| <= LOST1 /\ |s6| <= 1
/\ |z45| <= LOST1 /\ |z46| <= LOST1 /\ |z47| <= LOST1 /\ |z48| <= LOST1 /\ |z49| <= LOST0
/\ |z50| <= LOST1 /\ |z51| <= LOST1
-> |apart - Apart| - coordinate_bound <= 0
/\ |beyond - Beyond| - bound <= 0
/\ |beyond2 - Beyond2| - bound <= 0
/\ |beyond3 - Beyond3| - bound <= 0
/\ |beyond| <= ROOM3 /\ |beyond2| <= ROOM3 /\ |beyond3| <= ROOM3 }
