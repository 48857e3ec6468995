# How far a component of the vector from a corner of an oriented box to a point, and the gap on a
# coordinate, may be from the truth.
# constant: CORNER
# constant: APART
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included.
#
# d is a difference and each product one of a half-extent and an axis, divided by Z, the greatest of
# all as computed. Sixteen times Z has a square in range, so that the products lose less than LOST1.
# What is true of d may be 1 + U, for rounding keeps order, and of a product 1 + 4·U. The bound of the
# corner is a power of two times Z, and exact. The radius is r·Z; one above Z leaves no gap.

dc = fl(dp, -dq); Dc = dp + -dq;
x = fl(Xo, a); X = Xo + o;
y = fl(Yo, b); Y = Yo + o;
z = fl(Zo, c); Zz = Zo + o;

corner = fl(fl(fl(dc, -x), -y), -z);
Corner = ((Dc + -X) + -Y) + -Zz;
gap = fl(fl(dc, -fl(fl(x, y), z)), -r);
Gap = (Dc + -((X + Y) + Zz)) + -r;
gap_bound = fl(APART*U*fl(16, r), k);

{ o in [0,0] /\ |dc| <= 1 /\ |Dc| <= UP1 /\ |x| <= 1 /\ |X| <= UP4 /\ |y| <= 1 /\ |Y| <= UP4
/\ |z| <= 1 /\ |Zz| <= UP4 /\ |a| <= LOST1 /\ |b| <= LOST1 /\ |c| <= LOST1 /\ |k| <= LOST1
/\ r in [0,1]
-> |corner - Corner| - CORNER*U <= 0 /\ |gap - Gap| - gap_bound <= 0 }
