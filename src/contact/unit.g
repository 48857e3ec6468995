# How far a coordinate of a unit vector in two words may be from the truth.
# constant: LOST
# only: f64
#
# One over the length is computed as 1 + f of itself. First the sum of squares, whose truth is
# (1 + f)² but for `es`: what the coordinates err by, and the squares of the second words.

# A coordinate's share: t = (2·lead + tail)·tail, and q = 2·h·r. `d` is what its roundings add.
d1 = t1*(a1 + b1 + a1*b1) + q1*g1 + (t1*(1 + a1)*(1 + b1) + q1*(1 + g1))*k1;
d2 = t2*(a2 + b2 + a2*b2) + q2*g2 + (t2*(1 + a2)*(1 + b2) + q2*(1 + g2))*k2;
d3 = t3*(a3 + b3 + a3*b3) + q3*g3 + (t3*(1 + a3)*(1 + b3) + q3*(1 + g3))*k3;

# The first two, and all three: two more roundings, and one of the sum with that of the leads.
both = (t1 + q1 + d1) + (t2 + q2 + d2);
all = both*(1 + m2) + (t3 + q3 + d3);
of_sum = d1 + d2 + both*m2 + d3 + all*m3 + es;
of_off = 0.5*(of_sum + (f*(2 + f) + of_sum)*m4);
off = f + 0.5*f*f + of_off;

# The coordinate times the inverse is divided by itself, and its truth is one: h is 1 + eh, and r is
# ea - eh + er, for the error ea of the coordinate and the roundings of r. The unit vector's truth is
# 1/(1 + f). Terms of first order cancel; what is left of them is written out.
r = ea - eh + er;
product = (1 + eh)*off*(1 + e1);
of_product = (eh + e1 + eh*e1)*off;
error = ea + er - of_off - f*f*(1.5 + 0.5*f)/(1 + f) - of_product + (r - product)*e2;

{ |f| <= 25b-53 /\ |es| <= 1b-94 /\ |ea| <= 1b-97 /\ |eh| <= 3b-53 /\ |er| <= 4b-106
/\ |t1| <= 17b-30 /\ |t2| <= 17b-30 /\ |t3| <= 17b-30
/\ |q1| <= 7b-53 /\ |q2| <= 7b-53 /\ |q3| <= 7b-53
/\ |a1| <= 1b-53 /\ |b1| <= 1b-53 /\ |g1| <= 1b-53 /\ |k1| <= 1b-53
/\ |a2| <= 1b-53 /\ |b2| <= 1b-53 /\ |g2| <= 1b-53 /\ |k2| <= 1b-53
/\ |a3| <= 1b-53 /\ |b3| <= 1b-53 /\ |g3| <= 1b-53 /\ |k3| <= 1b-53
/\ |m2| <= 1b-53 /\ |m3| <= 1b-53 /\ |m4| <= 1b-53 /\ |e1| <= 1b-53 /\ |e2| <= 1b-53
-> |error| - LOST*1b-80 <= -1b-81 }
