# How far the numbers that say where a point lies may be from the truth, with vectors from the corners of
# an oriented box: a component of a cross product, a dot product, a volume, and the side of an edge.
# constant: CORNER_MINOR
# constant: CORNER_DOT
# constant: CORNER_VOLUME
# constant: CORNER_SIDE
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included; and nothing
# overflows.
#
# Each vector is divided by R, which is sixteen times the greatest number of which corners are made
# (`obb.rs`). So a vector is a quarter long, but for its rounding, and errs by up to a roundoff of R, as
# `obb.g` proves; edges and differences of points err by less. R lies where R² is in range, so that what
# a product of up to four lengths loses to underflow is below LOST2 in this scale, and six lengths have
# ROOM3.

nx = fl(fl(ay*bz, z1), -fl(az*by, z2));
Nx = (Ay*Bz + o) + -(Az*By + o);
ny = fl(fl(az*bx, z3), -fl(ax*bz, z4));
Ny = (Az*Bx + o) + -(Ax*Bz + o);
nz = fl(fl(ax*by, z5), -fl(ay*bx, z6));
Nz = (Ax*By + o) + -(Ay*Bx + o);
mx = fl(fl(cy*dz, y1), -fl(cz*dy, y2));
Mx = (Cy*Dz + o) + -(Cz*Dy + o);
my = fl(fl(cz*dx, y3), -fl(cx*dz, y4));
My = (Cz*Dx + o) + -(Cx*Dz + o);
mz = fl(fl(cx*dy, y5), -fl(cy*dx, y6));
Mz = (Cx*Dy + o) + -(Cy*Dx + o);
dot = fl(fl(fl(ax*bx, z7), fl(ay*by, z8)), fl(az*bz, z9));
Dot = ((Ax*Bx + o) + (Ay*By + o)) + (Az*Bz + o);
volume = fl(fl(fl(nx*cx, z10), fl(ny*cy, z11)), fl(nz*cz, z12));
Volume = ((Nx*Cx + o) + (Ny*Cy + o)) + (Nz*Cz + o);
side = fl(fl(fl(nx*mx, y7), fl(ny*my, y8)), fl(nz*mz, y9));
Side = ((Nx*Mx + o) + (Ny*My + o)) + (Nz*Mz + o);

area = fl(1, z13);
minor_bound = fl(CORNER_MINOR*U*area, z14);
dot_bound = fl(CORNER_DOT*U*area, z15);
volume_bound = fl(CORNER_VOLUME*U*fl(area, z16), z17);
side_bound = fl(CORNER_SIDE*U*fl(area*area, y10), y11);

{ o in [0,0]
/\ |ax| <= 0.26 /\ |Ax - ax| <= U /\ |Ax| <= 0.26 /\ |ay| <= 0.26 /\ |Ay - ay| <= U
/\ |Ay| <= 0.26 /\ |az| <= 0.26 /\ |Az - az| <= U /\ |Az| <= 0.26 /\ |bx| <= 0.26
/\ |Bx - bx| <= U /\ |Bx| <= 0.26 /\ |by| <= 0.26 /\ |By - by| <= U /\ |By| <= 0.26
/\ |bz| <= 0.26 /\ |Bz - bz| <= U /\ |Bz| <= 0.26 /\ |cx| <= 0.26 /\ |Cx - cx| <= U
/\ |Cx| <= 0.26 /\ |cy| <= 0.26 /\ |Cy - cy| <= U /\ |Cy| <= 0.26 /\ |cz| <= 0.26
/\ |Cz - cz| <= U /\ |Cz| <= 0.26 /\ |dx| <= 0.26 /\ |Dx - dx| <= U /\ |Dx| <= 0.26
/\ |dy| <= 0.26 /\ |Dy - dy| <= U /\ |Dy| <= 0.26 /\ |dz| <= 0.26 /\ |Dz - dz| <= U
/\ |Dz| <= 0.26 /\ |z1| <= LOST2 /\ |z2| <= LOST2 /\ |z3| <= LOST2 /\ |z4| <= LOST2
/\ |z5| <= LOST2 /\ |z6| <= LOST2 /\ |z7| <= LOST2 /\ |z8| <= LOST2 /\ |z9| <= LOST2
/\ |z10| <= LOST2 /\ |z11| <= LOST2 /\ |z12| <= LOST2 /\ |z13| <= LOST2 /\ |z14| <= LOST2
/\ |z15| <= LOST2 /\ |z16| <= LOST2 /\ |z17| <= LOST2 /\ |y1| <= LOST2 /\ |y2| <= LOST2
/\ |y3| <= LOST2 /\ |y4| <= LOST2 /\ |y5| <= LOST2 /\ |y6| <= LOST2 /\ |y7| <= LOST2
/\ |y8| <= LOST2 /\ |y9| <= LOST2 /\ |y10| <= LOST2 /\ |y11| <= LOST2
-> |nx - Nx| - minor_bound <= 0 /\ |dot - Dot| - dot_bound <= 0 /\ |volume - Volume| - volume_bound <= 0
/\ |side - Side| - side_bound <= 0 /\ |volume * volume| <= ROOM3 /\ |side| <= ROOM3 }
