# How far the volumes of a prepared triangle and a ray may be from the truth.
# constant: VOLUME
# constant: T
# constant: SIDES
#
# Proved: |computed − true| is at most the bound as it is computed, for each volume, underflow
# included; and nothing overflows.
#
# The direction is divided by D, edges by E, and the way to the origin by R, as in error_bound.g.
# The determinant has no way: there an edge divided by R, which is 1 at most then too, stands for
# the second edge in the normal. So it is made anew: f for the second edge, k for the normal.

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
nx = fl(fl(ey*gz, u1), -fl(ez*gy, u2));
Nx = (Ey*Gz + o) + -(Ez*Gy + o);
ny = fl(fl(ez*gx, u3), -fl(ex*gz, u4));
Ny = (Ez*Gx + o) + -(Ex*Gz + o);
nz = fl(fl(ex*gy, u5), -fl(ey*gx, u6));
Nz = (Ex*Gy + o) + -(Ey*Gx + o);
kx = fl(fl(ey*fz, v1), -fl(ez*fy, v2));
Kx = (Ey*Fz + o) + -(Ez*Fy + o);
ky = fl(fl(ez*fx, v3), -fl(ex*fz, v4));
Ky = (Ez*Fx + o) + -(Ex*Fz + o);
kz = fl(fl(ex*fy, v5), -fl(ey*fx, v6));
Kz = (Ex*Fy + o) + -(Ey*Fx + o);
mx = fl(fl(sy*dz, u7), -fl(sz*dy, u8));
Mx = (Sy*dz + o) + -(Sz*dy + o);
my = fl(fl(sz*dx, u9), -fl(sx*dz, u10));
My = (Sz*dx + o) + -(Sx*dz + o);
mz = fl(fl(sx*dy, u11), -fl(sy*dx, u12));
Mz = (Sx*dy + o) + -(Sy*dx + o);
det = fl(fl(fl(kx*dx, u13), fl(ky*dy, u14)), fl(kz*dz, u15));
Det = ((Kx*dx + o) + (Ky*dy + o)) + (Kz*dz + o);
side_u = fl(fl(fl(mx*gx, u16), fl(my*gy, u17)), fl(mz*gz, u18));
Side_u = ((Mx*Gx + o) + (My*Gy + o)) + (Mz*Gz + o);
side_v = fl(fl(fl(mx*ex, u19), fl(my*ey, u20)), fl(mz*ez, u21));
Side_v = ((Mx*Ex + o) + (My*Ey + o)) + (Mz*Ez + o);
t = fl(fl(fl(nx*sx, u22), fl(ny*sy, u23)), fl(nz*sz, u24));
True_t = ((Nx*Sx + o) + (Ny*Sy + o)) + (Nz*Sz + o);
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
/\ |v1| <= LOST2 /\ |v2| <= LOST2 /\ |v3| <= LOST2 /\ |v4| <= LOST2 /\ |v5| <= LOST2 /\ |v6| <= LOST2
/\ |u21| <= LOST3 /\ |u22| <= LOST3 /\ |u23| <= LOST3 /\ |u24| <= LOST3
-> |det - Det| - volume_bound <= 0 /\ |side_u - Side_u| - volume_bound <= 0
/\ |side_v - Side_v| - volume_bound <= 0 /\ |t - True_t| - t_bound <= 0
/\ |w - W| - sides_bound <= 0 /\ |w| <= ROOM3 }
