# How far the axes of a line and an oriented box may be from the truth.
# constant: DIRECTION
# constant: FACE
# constant: LINE
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included; and nothing
# overflows. Besides, |t|·D of a point in the box is at most eight times R as computed.
#
# Axes are divided by A, which is 1 or more, the direction by D. On a face the way m is divided by
# T, half-extents by T/A and t by T/D; beside the line R is in the place of T. All three are in
# range. R, and so T, is the greatest of m and of h·A as computed, T that of D·t too: so h and t may
# be 1 + U, and what is true of a difference too, for rounding keeps order. What w·d loses to
# underflow is meant where it is most, divided by D.
#
# The magnitude of x, computed where X is true, is |X| + s·(x − X) for some |s| ≤ 1. Products with
# one are exact.

# The way from the centre to the origin, and the direction: differences.
mx = fl(mxp, -mxq); Mx = mxp + -mxq;
my = fl(myp, -myq); My = myp + -myq;
mz = fl(mzp, -mzq); Mz = mzp + -mzq;
dx = fl(dxp, -dxq); Dx = dxp + -dxq;
dy = fl(dyp, -dyq); Dy = dyp + -dyq;
dz = fl(dzp, -dzq); Dz = dzp + -dzq;

# A normal, and what makes two of them numbers along the line.
wx = fl(fl(by*cz, z1), -fl(bz*cy, z2));
Wx = (by*cz + o) + -(bz*cy + o);
wy = fl(fl(bz*cx, z3), -fl(bx*cz, z4));
Wy = (bz*cx + o) + -(bx*cz + o);
wz = fl(fl(bx*cy, z5), -fl(by*cx, z6));
Wz = (bx*cy + o) + -(by*cx + o);
vx = fl(fl(cy*az, z7), -fl(cz*ay, z8));
Vx = (cy*az + o) + -(cz*ay + o);
vy = fl(fl(cz*ax, z9), -fl(cx*az, z10));
Vy = (cz*ax + o) + -(cx*az + o);
vz = fl(fl(cx*ay, z11), -fl(cy*ax, z12));
Vz = (cx*ay + o) + -(cy*ax + o);
one = fl(fl(fl(wx*dx, z13), fl(wy*dy, z14)), fl(wz*dz, z15));
One = ((Wx*Dx + o) + (Wy*Dy + o)) + (Wz*Dz + o);
two = fl(fl(fl(vx*dx, z16), fl(vy*dy, z17)), fl(vz*dz, z18));
Two = ((Vx*Dx + o) + (Vy*Dy + o)) + (Vz*Dz + o);
one_abs = |One| + s1*(one - One); One_abs = |One| + o;
two_abs = |Two| + s2*(two - Two); Two_abs = |Two| + o;
volume = fl(fl(fl(ax*wx, z19), fl(ay*wy, z20)), fl(az*wz, z21));
Volume = ((ax*Wx + o) + (ay*Wy + o)) + (az*Wz + o);
volume_abs = |Volume| + s3*(volume - Volume); Volume_abs = |Volume| + o;

# A face: one end of the line, and the box.
middle = fl(fl(fl(wx*mx, z22), fl(wy*my, z23)), fl(wz*mz, z24));
Middle = ((Wx*Mx + o) + (Wy*My + o)) + (Wz*Mz + o);
at = fl(middle, fl(one*t, z25)); At = Middle + (One*t + o);
reach = fl(h*volume_abs, z26); Reach = h*Volume_abs + o;
face = fl(at, -reach); Face = At + -Reach;

# The line.
nx = fl(fl(my*dz, z27), -fl(mz*dy, z28));
Nx = (My*Dz + o) + -(Mz*Dy + o);
ny = fl(fl(mz*dx, z29), -fl(mx*dz, z30));
Ny = (Mz*Dx + o) + -(Mx*Dz + o);
nz = fl(fl(mx*dy, z31), -fl(my*dx, z32));
Nz = (Mx*Dy + o) + -(My*Dx + o);
beside = fl(fl(fl(nx*cx, z33), fl(ny*cy, z34)), fl(nz*cz, z35));
Beside = ((Nx*cx + o) + (Ny*cy + o)) + (Nz*cz + o);
beside_abs = |Beside| + s4*(beside - Beside); Beside_abs = |Beside| + o;
span = fl(fl(h*two_abs, z36), fl(k*one_abs, z37)); Span = (h*Two_abs + o) + (k*One_abs + o);
gap = fl(beside_abs, -span); Gap = Beside_abs + -Span;

# A point in the box, for an end of t that is far. All are divided by R: in truth |m| and h·A may be
# 1 + 4·U, and the point is nearer to the centre than the box reaches.
out = fl(way + 3*wide - nearer, z48);

direction_bound = fl(DIRECTION*U*fl(fl(1, z38), z39), z40);
face_bound = fl(FACE*U*fl(fl(1, z41), z42), z43);
line_bound = fl(LINE*U*fl(fl(fl(1, z44), z45), z46), z47);

{ o in [0,0] /\ |ax| <= 1 /\ |ay| <= 1 /\ |az| <= 1 /\ |bx| <= 1 /\ |by| <= 1 /\ |bz| <= 1
/\ |cx| <= 1 /\ |cy| <= 1 /\ |cz| <= 1 /\ |mx| <= 1 /\ |Mx| <= UP1 /\ |my| <= 1 /\ |My| <= UP1
/\ |mz| <= 1 /\ |Mz| <= UP1 /\ |dx| <= 1 /\ |Dx| <= UP1 /\ |dy| <= 1 /\ |Dy| <= UP1 /\ |dz| <= 1
/\ |Dz| <= UP1 /\ |h| <= UP1 /\ |k| <= UP1 /\ |t| <= UP1 /\ |s1| <= 1 /\ |s2| <= 1 /\ |s3| <= 1
/\ |s4| <= 1 /\ |z1| <= LOST0 /\ |z2| <= LOST0 /\ |z3| <= LOST0 /\ |z4| <= LOST0 /\ |z5| <= LOST0
/\ |z6| <= LOST0 /\ |z7| <= LOST0 /\ |z8| <= LOST0 /\ |z9| <= LOST0 /\ |z10| <= LOST0
/\ |z11| <= LOST0 /\ |z12| <= LOST0 /\ |z19| <= LOST0 /\ |z20| <= LOST0 /\ |z21| <= LOST0
/\ |z38| <= LOST0 /\ |z41| <= LOST0 /\ |z44| <= LOST0 /\ |z13| <= LOST1 /\ |z14| <= LOST1
/\ |z15| <= LOST1 /\ |z16| <= LOST1 /\ |z17| <= LOST1 /\ |z18| <= LOST1 /\ |z22| <= LOST1
/\ |z23| <= LOST1 /\ |z24| <= LOST1 /\ |z25| <= LOST1 /\ |z26| <= LOST1 /\ |z39| <= LOST1
/\ |z40| <= LOST1 /\ |z42| <= LOST1 /\ |z43| <= LOST1 /\ |z45| <= LOST1 /\ |z27| <= LOST2
/\ |z28| <= LOST2 /\ |z29| <= LOST2 /\ |z30| <= LOST2 /\ |z31| <= LOST2 /\ |z32| <= LOST2
/\ |z33| <= LOST2 /\ |z34| <= LOST2 /\ |z35| <= LOST2 /\ |z36| <= LOST2 /\ |z37| <= LOST2
/\ |z46| <= LOST2 /\ |z47| <= LOST2 /\ |z48| <= LOST2
/\ way in [0,UP4] /\ wide in [0,UP4] /\ nearer in [0,4]
-> |one - One| - direction_bound <= 0
/\ |face - Face| - face_bound <= 0
/\ |gap - Gap| - line_bound <= 0
/\ out <= 8
/\ |one| <= ROOM1 /\ |face| <= ROOM1 /\ |gap| <= ROOM2 }
