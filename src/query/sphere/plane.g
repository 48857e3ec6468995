# How far n·x + d, which says on which side of a plane a point lies, may be from the truth.
# constant: FROM_PLANE
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included.
#
# The normal is divided by N and the vector x from the plane's point by R: the greatest computed
# magnitudes, or R by the radius if that is greater; both in range. What is true of a difference may
# be 1 + U, for rounding keeps order. Areas are divided by the greater of N·R and |d|; w is what that
# leaves of N·R. The sum of the two in the bound is taken for the greater alone: adding keeps order.
# Nothing overflows, because N, R and their bound are in range.

xx = fl(px, -qx); Xx = px + -qx;
xy = fl(py, -qy); Xy = py + -qy;
xz = fl(pz, -qz); Xz = pz + -qz;

from_plane = fl(fl(fl(fl(w*(nx*xx), w*ax), fl(w*(ny*xy), w*ay)), fl(w*(nz*xz), w*az)), d);
From_plane = (((w*(nx*Xx) + w*o) + (w*(ny*Xy) + w*o)) + (w*(nz*Xz) + w*o)) + d;

bound = fl(FROM_PLANE * U * fl(1, c), k);

{ w in [0,1] /\ o in [0,0] /\ |d| <= 1
/\ |nx| <= 1 /\ |xx| <= 1 /\ |Xx| <= UP1 /\ |ax| <= LOST2
/\ |ny| <= 1 /\ |xy| <= 1 /\ |Xy| <= UP1 /\ |ay| <= LOST2
/\ |nz| <= 1 /\ |xz| <= 1 /\ |Xz| <= UP1 /\ |az| <= LOST2
/\ |c| <= LOST2 /\ |k| <= LOST2
-> |from_plane - From_plane| - bound <= 0 }
