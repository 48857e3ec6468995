# How much farther than the radius the outline of a thin face must be, for the face to be farther than
# the radius.
# constant: THIN
#
# Proved: the wider radius as it is computed is at least the radius and half of the width of the face.
#
# All numbers are divided by the sum of the radius r and the greatest component of an edge, l. That is
# relative to l within 256 roundoffs of what is true, and its square and the sum of a component of the
# normal and its error are compared with rounding: together less than 300 roundoffs. Half of the width
# is then at most √3/2 < 0.867 of THIN roundoffs of l, times 1 + 300·U. l is at least 1/256 of a length in range.

l = 1 + -r;
W = 0.867*THIN*U*(1 + 300*U)*l;
wider = fl(r, fl(THIN*U*fl(l, r), k));

{ r in [0,1] /\ |k| <= LOST2 -> (r + W) - wider <= 0 }
