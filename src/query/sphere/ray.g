# How far m − t·d, from an end of a ray to a point, and its product with d may be from the truth.
# constant: END
# constant: ALONG
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included.
#
# m is a difference, divided by R, as are the products t·d: R is twice the greater of the two
# magnitudes, as computed, and in range. d is divided by its greatest component, whose square is in
# range too. What is true of a difference may be 1 + U of the half, for rounding keeps order.
# Nothing overflows, because R, its square and R times |d| do not.

mx = fl(px, -qx); Mx = px + -qx; sx = fl(tx, ax); Sx = tx + o;
my = fl(py, -qy); My = py + -qy; sy = fl(ty, ay); Sy = ty + o;
mz = fl(pz, -qz); Mz = pz + -qz; sz = fl(tz, az); Sz = tz + o;

ex = fl(mx, -sx); Ex = Mx + -Sx;
ey = fl(my, -sy); Ey = My + -Sy;
ez = fl(mz, -sz); Ez = Mz + -Sz;
along = fl(fl(fl(ex*dx, bx), fl(ey*dy, by)), fl(ez*dz, bz));
Along = ((Ex*dx + o) + (Ey*dy + o)) + (Ez*dz + o);

end_bound = fl(END*U*1, i);
along_bound = fl(ALONG*U*fl(1, j), k);

{ o in [0,0]
/\ |mx| <= 0.5 /\ |Mx| <= 0.50001 /\ |sx| <= 0.5 /\ |Sx| <= 0.50001 /\ |dx| <= 1
/\ |my| <= 0.5 /\ |My| <= 0.50001 /\ |sy| <= 0.5 /\ |Sy| <= 0.50001 /\ |dy| <= 1
/\ |mz| <= 0.5 /\ |Mz| <= 0.50001 /\ |sz| <= 0.5 /\ |Sz| <= 0.50001 /\ |dz| <= 1
/\ |ax| <= LOST2 /\ |ay| <= LOST2 /\ |az| <= LOST2 /\ |bx| <= LOST2 /\ |by| <= LOST2
/\ |bz| <= LOST2 /\ |i| <= LOST2 /\ |j| <= LOST2 /\ |k| <= LOST2
-> |ex - Ex| - end_bound <= 0 /\ |along - Along| - along_bound <= 0 }
