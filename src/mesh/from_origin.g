# How far the bounds of a squared distance may be from the truth.
# only: f64
# constant: BEYOND
# constant: AT
#
# Proved: 2·q·p − q·q as computed, less its error, is at most the true number; and a component of q
# is as far from a point of the triangle as is allowed, beside |s − 1|. Underflow is left to the term
# that the code adds.
#
# The vertices are divided by R, the greatest of all components, and q by its own greatest component,
# for the first. What is true of a vertex differs by up to U. The weights u, v, w lie in [0, 1], and so
# does |s − 1|, or else no bound is needed: q lies within R.

along = fl(fl(fl(q0*p0, o), fl(q1*p1, o)), fl(q2*p2, o));
Along = ((q0*p0t + o) + (q1*p1t + o)) + (q2*p2t + o);
square = fl(fl(fl(q0*q0, o), fl(q1*q1, o)), fl(q2*q2, o));
Square = ((q0*q0 + o) + (q1*q1 + o)) + (q2*q2 + o);
difference = fl(fl(along, along), -square);
Difference = (Along + Along) + -Square;
bound = fl(BEYOND*U*fl(1, o), o);

component = fl(fl(fl(u*p0, o), fl(v*p1, o)), fl(w*p2, o));
Component = ((u*p0t + o) + (v*p1t + o)) + (w*p2t + o);
sum = fl(fl(u, v), w);
Sum = (u + v) + w;
short = fl(sum, -1);
slack = fl(AT*U, o);
Short = sum + -1;

{ o in [0,0] /\ |q0| <= 1 /\ |q1| <= 1 /\ |q2| <= 1 /\ |p0| <= 1 /\ |p1| <= 1 /\ |p2| <= 1
/\ |p0 - p0t| <= U
/\ |p1 - p1t| <= U /\ |p2 - p2t| <= U /\ |p0t| <= UP1 /\ |p1t| <= UP1 /\ |p2t| <= UP1
/\ u in [0,1] /\ v in [0,1] /\ w in [0,1]
-> |difference - Difference| + (bound + 10)*U*UP1 - bound <= 0
/\ |component - Component| + UP1*(|sum - Sum| + |short - Short|) + (1 + slack)*2*U - slack <= 0 }
