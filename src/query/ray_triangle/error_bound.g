# How far the volumes of a ray and a triangle may be from the truth.
# constant: VOLUME
# constant: T
# constant: SIDES
#
# Proved: |computed − true| is at most the bound as it is computed, for each volume, underflow
# included; and nothing overflows.
#
# The direction is divided by D, edges by E, and the way to the origin by R: the greatest computed
# magnitudes, all in range; E ≤ R. An edge as the third vector of the determinant is divided by R
# as well: f stands for it, which is 1 at most then too. What is true of a difference may be
# 1 + U, for rounding keeps order.

ex = fl(exp, -exa); Ex = exp + -exa;
ey = fl(eyp, -eya); Ey = eyp + -eya;
ez = fl(ezp, -eza); Ez = ezp + -eza;
gx = fl(gxp, -gxa); Gx = gxp + -gxa;
gy = fl(gyp, -gya); Gy = gyp + -gya;
gz = fl(gzp, -gza); Gz = gzp + -gza;
fx = fl(fxp, -fxa); Fx = fxp + -fxa;
fy = fl(fyp, -fya); Fy = fyp + -fya;
fz = fl(fzp, -fza); Fz = fzp + -fza;
sx = fl(sxp, -sxa); Sx = sxp + -sxa;
sy = fl(syp, -sya); Sy = syp + -sya;
sz = fl(szp, -sza); Sz = szp + -sza;

# The edges are e and g. d has no error: its truth is itself.
px = fl(fl(dy*gz, u1), -fl(dz*gy, u2));
Px = (dy*Gz + o) + -(dz*Gy + o);
py = fl(fl(dz*gx, u3), -fl(dx*gz, u4));
Py = (dz*Gx + o) + -(dx*Gz + o);
pz = fl(fl(dx*gy, u5), -fl(dy*gx, u6));
Pz = (dx*Gy + o) + -(dy*Gx + o);
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
Side_v = ((Qx*dx + o) + (Qy*dy + o)) + (Qz*dz + o);
t = fl(fl(fl(qx*gx, u22), fl(qy*gy, u23)), fl(qz*gz, u24));
True_t = ((Qx*Gx + o) + (Qy*Gy + o)) + (Qz*Gz + o);
w = fl(fl(det, -side_u), -side_v);
W = (Det + -Side_u) + -Side_v;

size = fl(fl(1, k), l);
volume_bound = fl(VOLUME*U*size, m);
t_bound = fl(T*U*size, m);
sides_bound = fl(SIDES*U*size, m);

{ o in [0,0] /\ |k| <= LOST2 /\ |l| <= LOST3 /\ |m| <= LOST3
/\ |dx| <= 1 /\ |ex| <= 1 /\ |Ex| <= UP1 /\ |gx| <= 1 /\ |Gx| <= UP1
/\ |fx| <= 1 /\ |Fx| <= UP1 /\ |sx| <= 1 /\ |Sx| <= UP1
/\ |dy| <= 1 /\ |ey| <= 1 /\ |Ey| <= UP1 /\ |gy| <= 1 /\ |Gy| <= UP1
/\ |fy| <= 1 /\ |Fy| <= UP1 /\ |sy| <= 1 /\ |Sy| <= UP1
/\ |dz| <= 1 /\ |ez| <= 1 /\ |Ez| <= UP1 /\ |gz| <= 1 /\ |Gz| <= UP1
/\ |fz| <= 1 /\ |Fz| <= UP1 /\ |sz| <= 1 /\ |Sz| <= UP1
/\ |u1| <= LOST2 /\ |u2| <= LOST2 /\ |u3| <= LOST2 /\ |u4| <= LOST2 /\ |u5| <= LOST2
/\ |u6| <= LOST2 /\ |u7| <= LOST2 /\ |u8| <= LOST2 /\ |u9| <= LOST2 /\ |u10| <= LOST2
/\ |u11| <= LOST2 /\ |u12| <= LOST2 /\ |u13| <= LOST3 /\ |u14| <= LOST3 /\ |u15| <= LOST3
/\ |u16| <= LOST3 /\ |u17| <= LOST3 /\ |u18| <= LOST3 /\ |u19| <= LOST3 /\ |u20| <= LOST3
/\ |u21| <= LOST3 /\ |u22| <= LOST3 /\ |u23| <= LOST3 /\ |u24| <= LOST3
-> |det - Det| - volume_bound <= 0 /\ |side_u - Side_u| - volume_bound <= 0
/\ |side_v - Side_v| - volume_bound <= 0 /\ |t - True_t| - t_bound <= 0
/\ |w - W| - sides_bound <= 0 /\ |w| <= ROOM3 }
