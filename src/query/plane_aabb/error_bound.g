# How far the distance between a plane and a corner of a box may be from the truth.
# constant: PLANE
#
# Proved: |computed − true| is at most the bound as it is computed, in every form of plane and
# box, underflow included.
#
# The normal is divided by N and the lengths by R: the greatest computed magnitudes, both in
# range. Of the truth h may be 1 + U, for rounding keeps order, and v 1 + 4·U: it errs by at most
# 2·U + U² of the greater of |v| and h. Areas are divided by the greater of N·R and |d|; w is
# what that leaves of N·R. The sum of the two in the bound is taken for the greater alone: adding
# keeps order.
#
# The box is given by its corners and the plane by point and offset. What holds of that holds of
# the other forms, which round less: their δ and e are zero. Nothing overflows: products of two
# lengths are below 2^80 (`f32`), and the greatest float does not change by so little.

# From the box to the plane's point p, and half-extents, of a box from l to g.
vx = fl(fl(px, -lx), fl(px, -gx)) * 0.5 + ix;
Vx = ((px + -lx) + (px + -gx)) * 0.5 + o;
hx = fl(gx, -lx) * 0.5 + jx;
Hx = (gx + -lx) * 0.5 + o;
vy = fl(fl(py, -ly), fl(py, -gy)) * 0.5 + iy;
Vy = ((py + -ly) + (py + -gy)) * 0.5 + o;
hy = fl(gy, -ly) * 0.5 + jy;
Hy = (gy + -ly) * 0.5 + o;
vz = fl(fl(pz, -lz), fl(pz, -gz)) * 0.5 + iz;
Vz = ((pz + -lz) + (pz + -gz)) * 0.5 + o;
hz = fl(gz, -lz) * 0.5 + jz;
Hz = (gz + -lz) * 0.5 + o;

from_center = fl(fl(fl(fl(w*(nx*vx), w*ax), fl(w*(ny*vy), w*ay)), fl(w*(nz*vz), w*az)), -d);
From_center = (((w*(nx*Vx) + w*o) + (w*(ny*Vy) + w*o)) + (w*(nz*Vz) + w*o)) + -d;
radius = fl(fl(fl(w*(mx*hx), w*bx), fl(w*(my*hy), w*by)), fl(w*(mz*hz), w*bz));
Radius = ((w*(mx*Hx) + w*o) + (w*(my*Hy) + w*o)) + (w*(mz*Hz) + w*o);
gap = fl(from_center, -radius);
Gap = From_center + -Radius;

bound = fl(PLANE * U * fl(1, c), k);

{ w in [0,1] /\ o in [0,0] /\ |d| <= 1
/\ |nx| <= 1 /\ |mx| <= 1 /\ |Vx| <= UP4 /\ |Hx| <= UP1
/\ |px + -lx| <= 2.0000003
/\ |px + -gx| <= 2.0000003
/\ |ix| <= LOST1 /\ |jx| <= LOST1 /\ |ax| <= LOST2 /\ |bx| <= LOST2
/\ |ny| <= 1 /\ |my| <= 1 /\ |Vy| <= UP4 /\ |Hy| <= UP1
/\ |py + -ly| <= 2.0000003
/\ |py + -gy| <= 2.0000003
/\ |iy| <= LOST1 /\ |jy| <= LOST1 /\ |ay| <= LOST2 /\ |by| <= LOST2
/\ |nz| <= 1 /\ |mz| <= 1 /\ |Vz| <= UP4 /\ |Hz| <= UP1
/\ |pz + -lz| <= 2.0000003
/\ |pz + -gz| <= 2.0000003
/\ |iz| <= LOST1 /\ |jz| <= LOST1 /\ |az| <= LOST2 /\ |bz| <= LOST2
/\ |c| <= LOST2 /\ |k| <= LOST2
-> |gap - Gap| - bound <= 0 }
