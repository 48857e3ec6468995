# How far the volumes of a ray and four triangles may be from the truth.
# constant: SIDES
# constant: T
# only: f32
#
# Proved: |computed − true| is at most the bound as it is computed, for u, v, w and t, underflow
# included; and nothing overflows.
#
# The direction is divided by D, edges by E, and the way to the origin by R: the greatest computed
# magnitudes, all in range; E ≤ R. An edge as the third vector of the determinant is divided by R
# as well: f stands for it, which is 1 at most then too. What `f64` has computed, and what underflow
# takes where it becomes `f32`, is k: below a thousandth of a roundoff. What is true of a vector may
# be 1 + 4·U, for rounding keeps order.

ex = fl(ext, k1); Ex = ext + o;
ey = fl(eyt, k2); Ey = eyt + o;
ez = fl(ezt, k3); Ez = ezt + o;
gx = fl(gxt, k4); Gx = gxt + o;
gy = fl(gyt, k5); Gy = gyt + o;
gz = fl(gzt, k6); Gz = gzt + o;
fx = fl(fxt, k7); Fx = fxt + o;
fy = fl(fyt, k8); Fy = fyt + o;
fz = fl(fzt, k9); Fz = fzt + o;
sx = fl(sxt, k10); Sx = sxt + o;
sy = fl(syt, k11); Sy = syt + o;
sz = fl(szt, k12); Sz = szt + o;
dx = fl(dxt, k13); Dx = dxt + o;
dy = fl(dyt, k14); Dy = dyt + o;
dz = fl(dzt, k15); Dz = dzt + o;

# The edges are e and g.
px = fl(fl(dy*gz, u1), -fl(dz*gy, u2));
Px = (Dy*Gz + o) + -(Dz*Gy + o);
py = fl(fl(dz*gx, u3), -fl(dx*gz, u4));
Py = (Dz*Gx + o) + -(Dx*Gz + o);
pz = fl(fl(dx*gy, u5), -fl(dy*gx, u6));
Pz = (Dx*Gy + o) + -(Dy*Gx + o);
qx = fl(fl(sy*ez, u7), -fl(sz*ey, u8));
Qx = (Sy*Ez + o) + -(Sz*Ey + o);
qy = fl(fl(sz*ex, u9), -fl(sx*ez, u10));
Qy = (Sz*Ex + o) + -(Sx*Ez + o);
qz = fl(fl(sx*ey, u11), -fl(sy*ex, u12));
Qz = (Sx*Ey + o) + -(Sy*Ex + o);
det = fl(fl(fl(px*fx, u13), fl(py*fy, u14)), fl(pz*fz, u15));
Det = ((Px*Fx + o) + (Py*Fy + o)) + (Pz*Fz + o);
side_u = fl(fl(fl(px*sx, u16), fl(py*sy, u17)), fl(pz*sz, u18));
Side_u = ((Px*Sx + o) + (Py*Sy + o)) + (Pz*Sz + o);
side_v = fl(fl(fl(qx*dx, u19), fl(qy*dy, u20)), fl(qz*dz, u21));
Side_v = ((Qx*Dx + o) + (Qy*Dy + o)) + (Qz*Dz + o);
t = fl(fl(fl(qx*gx, u22), fl(qy*gy, u23)), fl(qz*gz, u24));
True_t = ((Qx*Gx + o) + (Qy*Gy + o)) + (Qz*Gz + o);
w = fl(fl(det, -side_u), -side_v);
W = (Det + -Side_u) + -Side_v;

size = fl(1, k);
sides_bound = fl(size*fl(SIDES*U, l), m);
t_bound = fl(size*fl(T*U, l), m);

{ o in [0,0] /\ |k| <= LOST2 /\ |l| <= LOST1 /\ |m| <= LOST3
/\ |ex| <= 1 /\ |Ex| <= UP4 /\ |gx| <= 1 /\ |Gx| <= UP4 /\ |fx| <= 1 /\ |Fx| <= UP4 /\ |sx| <= 1 /\ |Sx| <= UP4 /\ |dx| <= 1 /\ |Dx| <= UP4
/\ |ey| <= 1 /\ |Ey| <= UP4 /\ |gy| <= 1 /\ |Gy| <= UP4 /\ |fy| <= 1 /\ |Fy| <= UP4 /\ |sy| <= 1 /\ |Sy| <= UP4 /\ |dy| <= 1 /\ |Dy| <= UP4
/\ |ez| <= 1 /\ |Ez| <= UP4 /\ |gz| <= 1 /\ |Gz| <= UP4 /\ |fz| <= 1 /\ |Fz| <= UP4 /\ |sz| <= 1 /\ |Sz| <= UP4 /\ |dz| <= 1 /\ |Dz| <= UP4
/\ |k1| <= 1b-34 /\ |k2| <= 1b-34 /\ |k3| <= 1b-34 /\ |k4| <= 1b-34 /\ |k5| <= 1b-34 /\ |k6| <= 1b-34 /\ |k7| <= 1b-34 /\ |k8| <= 1b-34
/\ |k9| <= 1b-34 /\ |k10| <= 1b-34 /\ |k11| <= 1b-34 /\ |k12| <= 1b-34 /\ |k13| <= 1b-34 /\ |k14| <= 1b-34 /\ |k15| <= 1b-34
/\ |u1| <= LOST2 /\ |u2| <= LOST2 /\ |u3| <= LOST2 /\ |u4| <= LOST2 /\ |u5| <= LOST2 /\ |u6| <= LOST2
/\ |u7| <= LOST2 /\ |u8| <= LOST2 /\ |u9| <= LOST2 /\ |u10| <= LOST2 /\ |u11| <= LOST2 /\ |u12| <= LOST2
/\ |u13| <= LOST3 /\ |u14| <= LOST3 /\ |u15| <= LOST3 /\ |u16| <= LOST3 /\ |u17| <= LOST3 /\ |u18| <= LOST3
/\ |u19| <= LOST3 /\ |u20| <= LOST3 /\ |u21| <= LOST3 /\ |u22| <= LOST3 /\ |u23| <= LOST3 /\ |u24| <= LOST3
-> |side_u - Side_u| - sides_bound <= 0 /\ |side_v - Side_v| - sides_bound <= 0
/\ |w - W| - sides_bound <= 0 /\ |t - True_t| - t_bound <= 0 /\ |w| <= ROOM3 }
