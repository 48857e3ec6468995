# How far the volumes of a prepared ray and a prepared triangle may be from the truth.
# constant: SIDE
# constant: T
# constant: SIDES
# only: f32
#
# Proved: |computed − true| is at most the bound as it is computed, for u, t and w, underflow
# included; v is u of the other edge. And nothing overflows: M may be twice the upper end of the
# range, of which w + w takes account.
#
# Lengths are divided by M, edges by E, the direction by D. The normal is divided by E² for t, which
# is n, and by E·M for the determinant, which is p: E is 2·M at most. What `f64` has computed, and
# what underflow takes where it becomes `f32`, is k: below a thousandth of a roundoff.

sx = fl(fl(ox, k1), -fl(ax, k2)); Sx = (ox + o) + -(ax + o);
sy = fl(fl(oy, k3), -fl(ay, k4)); Sy = (oy + o) + -(ay + o);
sz = fl(fl(oz, k5), -fl(az, k6)); Sz = (oz + o) + -(az + o);
dx = fl(dxt, k7); Dx = dxt + o;
dy = fl(dyt, k8); Dy = dyt + o;
dz = fl(dzt, k9); Dz = dzt + o;
ex = fl(ext, k10); Ex = ext + o;
ey = fl(eyt, k11); Ey = eyt + o;
ez = fl(ezt, k12); Ez = ezt + o;
fx = fl(fxt, k13); Fx = fxt + o;
fy = fl(fyt, k14); Fy = fyt + o;
fz = fl(fzt, k15); Fz = fzt + o;
nx = fl(nxt, k16); Nx = nxt + o;
ny = fl(nyt, k17); Ny = nyt + o;
nz = fl(nzt, k18); Nz = nzt + o;
px = fl(pxt, k19); Px = pxt + o;
py = fl(pyt, k20); Py = pyt + o;
pz = fl(pzt, k21); Pz = pzt + o;

rx = fl(fl(sy*dz, u1), -fl(sz*dy, u2));
Rx = (Sy*Dz + o) + -(Sz*Dy + o);
ry = fl(fl(sz*dx, u3), -fl(sx*dz, u4));
Ry = (Sz*Dx + o) + -(Sx*Dz + o);
rz = fl(fl(sx*dy, u5), -fl(sy*dx, u6));
Rz = (Sx*Dy + o) + -(Sy*Dx + o);
side_u = fl(fl(fl(rx*ex, u7), fl(ry*ey, u8)), fl(rz*ez, u9));
Side_u = ((Rx*Ex + o) + (Ry*Ey + o)) + (Rz*Ez + o);
side_v = fl(fl(fl(rx*fx, u10), fl(ry*fy, u11)), fl(rz*fz, u12));
Side_v = ((Rx*Fx + o) + (Ry*Fy + o)) + (Rz*Fz + o);
t = fl(fl(fl(sx*nx, u13), fl(sy*ny, u14)), fl(sz*nz, u15));
True_t = ((Sx*Nx + o) + (Sy*Ny + o)) + (Sz*Nz + o);
det = fl(fl(fl(dx*px, u16), fl(dy*py, u17)), fl(dz*pz, u18));
Det = ((Dx*Px + o) + (Dy*Py + o)) + (Dz*Pz + o);
w = fl(fl(det, -side_u), -side_v);
W = (Det + -Side_u) + -Side_v;

# What a triangle contributes, what a ray contributes, their product, and that times M.
size = fl(fl(fl(1, 0), l), m);
side_bound = SIDE*U*size;
t_bound = T*U*size;
sides_bound = SIDES*U*size;

{ o in [0,0] /\ |l| <= LOST2 /\ |m| <= LOST3
/\ |ox| <= 1 /\ |ax| <= 1 /\ |sx| <= 1 /\ |Sx| <= 1
/\ |dx| <= 1 /\ |Dx| <= 1 /\ |ex| <= 1 /\ |Ex| <= 1 /\ |fx| <= 1 /\ |Fx| <= 1
/\ |nx| <= 2 /\ |Nx| <= 2 /\ |px| <= 4 /\ |Px| <= 4
/\ |oy| <= 1 /\ |ay| <= 1 /\ |sy| <= 1 /\ |Sy| <= 1
/\ |dy| <= 1 /\ |Dy| <= 1 /\ |ey| <= 1 /\ |Ey| <= 1 /\ |fy| <= 1 /\ |Fy| <= 1
/\ |ny| <= 2 /\ |Ny| <= 2 /\ |py| <= 4 /\ |Py| <= 4
/\ |oz| <= 1 /\ |az| <= 1 /\ |sz| <= 1 /\ |Sz| <= 1
/\ |dz| <= 1 /\ |Dz| <= 1 /\ |ez| <= 1 /\ |Ez| <= 1 /\ |fz| <= 1 /\ |Fz| <= 1
/\ |nz| <= 2 /\ |Nz| <= 2 /\ |pz| <= 4 /\ |Pz| <= 4
/\ |k1| <= 1b-34 /\ |k2| <= 1b-34 /\ |k3| <= 1b-34 /\ |k4| <= 1b-34 /\ |k5| <= 1b-34 /\ |k6| <= 1b-34
/\ |k7| <= 1b-34 /\ |k8| <= 1b-34 /\ |k9| <= 1b-34 /\ |k10| <= 1b-34 /\ |k11| <= 1b-34 /\ |k12| <= 1b-34
/\ |k13| <= 1b-34 /\ |k14| <= 1b-34 /\ |k15| <= 1b-34 /\ |k16| <= 1b-34 /\ |k17| <= 1b-34 /\ |k18| <= 1b-34
/\ |k19| <= 1b-34 /\ |k20| <= 1b-34 /\ |k21| <= 1b-34
/\ |u1| <= LOST2 /\ |u2| <= LOST2 /\ |u3| <= LOST2 /\ |u4| <= LOST2 /\ |u5| <= LOST2 /\ |u6| <= LOST2
/\ |u7| <= LOST3 /\ |u8| <= LOST3 /\ |u9| <= LOST3 /\ |u10| <= LOST3 /\ |u11| <= LOST3 /\ |u12| <= LOST3
/\ |u13| <= LOST3 /\ |u14| <= LOST3 /\ |u15| <= LOST3 /\ |u16| <= LOST3 /\ |u17| <= LOST3 /\ |u18| <= LOST3
-> |side_u - Side_u| - side_bound <= 0 /\ |side_v - Side_v| - side_bound <= 0
/\ |t - True_t| - t_bound <= 0 /\ |w - W| - sides_bound <= 0 /\ |w + w| <= ROOM3 }
