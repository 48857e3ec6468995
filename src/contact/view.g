# How far apart places are that are not compared: a corner and the solution of two equations (`parts` in
# known.rs), and two places at a crossing (`Edge::crossing`). By how much the exact depth and the overlap of
# two shapes differ (`is_deep` in points.rs). When a corner is certainly off a line (`Quads::new` in quads.rs).
# constant: ROUNDOFFS
# only: f64
#
# Proved: places are closer than half the tolerance, and a depth that is compared with the exact depth less
# three tolerances passes as the overlap less four.
#
# All lengths are divided by the size S. A rounding is 1 + U·r, with |r| a little above 1 where it is inverted
# or stands for several. k·U·r of a sum is of the sum of magnitudes, and of a vector it is of its length. The
# roots of three and twelve are below 1.7321 and 3.4642. Directions across the normal are at most one long,
# so an error of x in three coordinates is at most 1.7321·x across it. Where places are not compared,
# scalars have up to 32 bits and S is above 2^-300, so underflow takes less than U·U.

# Two equations. The pivot is a0 and the factor f is a1/a0, rounded; s and t are those computed. A dividend
# is written as quotient times divisor, so a1, c0 and c1 follow from the others.
a1 = f*a0*(1 + U*r1);
fb = f*b0*(1 + U*r2);
d = (b1 - fb)*(1 + U*r3);
c0 = s*a0*(1 + U*r4)*(1 + U*r5) + t*b0*(1 + U*r6);
c1 = t*d*(1 + U*r7)*(1 + U*r8) + f*c0*(1 + U*r9);
first = s*a0 + t*b0 - c0;
second = s*a1 + t*b1 - c1;

# A coordinate of the place, from the corner B and the sides to A and C.
One = B + s*(A - B);
one = (B + s*((A - B)*(1 + U*p1))*(1 + U*p2))*(1 + U*p3);
Two = One + t*(C - B);
two = (one + t*((C - B)*(1 + U*p4))*(1 + U*p5))*(1 + U*p6);

# The sides and the point as differences of coordinates, each with a rounding; the coordinates of
# the place across the normal, and of the three corners, with three.
of_sides = 1.01*U*(3.4642 + 3.4642 + 3.4642);
of_place = 1.7321*|two - Two| + 4*3.01*U*1.7321;
x = |first| + of_sides + of_place;
y = |second| + of_sides + of_place;

# A crossing. The computed distances a and b have opposite signs, and t = a/(a − b) has two roundings. They
# move the place by as much as two roundings of a. A distance errs by 4·U times the length of a way, and a
# mean of two distances by no more.
of_line = a*(U*q1 + U*q2 + U*q1*U*q2) + 4.01*U*3.4642*q3;
# A place between the ends of an edge, from a parameter.
At = P + t*L;
at = (P + t*(L*(1 + U*q4))*(1 + U*q5))*(1 + U*q6);
# The parameter of the nearest place times the length of the edge is v if nothing is rounded, and w is the
# length of the way d. The product d·e errs by 4·U, and the square e·e and the quotient by 5·U.
along = (v + 4.01*U*w*q7)*(1 + 5.01*U*q8);
of_place_there = |of_line| + |at - At|;
apart = of_place_there + 2*(|along - v| + |at - At|);

# The side of a corner of a face, along an edge of length L (`Quads::new` in quads.rs). The square of a clear
# side is above `square`. `at_least` is below its root, and is above the error and the tolerance.
square = 4*(L2*L2 + 1)*(1 - 10*U);
at_least = 1.4142*(L2 + 1);
of_root = at_least*at_least - square;
of_side = 67*(L2 + 3.4642) + 3.01*L2*3.4642;
is_clear = at_least*ROUNDOFFS - of_side - L2*ROUNDOFFS;
# A clear corner in the coordinates that were computed, so that the side has its own roundings alone. It is off
# the line by more than the tolerance and 100·U (`Quads::is_around`).
is_around = at_least*ROUNDOFFS - 3.01*L2*3.4642 - L2*(ROUNDOFFS + 100);

# Depths. Eleven roundings in a term of an overlap: three of a half-edge, one of the normal, three of the
# product, three of the sum of terms, and one of the two shapes. A place errs by 3·U in each coordinate.
overlap = depth + 2*(11.1 + 3)*U*1.7321*k1;
exact = depth*(1 + 3*U*k2);
T = ROUNDOFFS*U;
asked = (overlap - 4*T)*(1 + U*k3);
known = (exact - 3*T)*(1 + U*k4);

{ |a0| <= 3.4642 /\ |b0| <= 3.4642 /\ |b1| <= 3.4642 /\ |c0| <= 3.4642 /\ |f| <= 1 /\ s in [0,1] /\ t in [0,1]
/\ |r1| <= 1.01 /\ |r2| <= 1 /\ |r3| <= 1 /\ |r4| <= 1.01 /\ |r5| <= 1.01 /\ |r6| <= 1 /\ |r7| <= 1.01
/\ |r8| <= 1.01 /\ |r9| <= 1
/\ |A| <= 1 /\ |B| <= 1 /\ |C| <= 1 /\ |One| <= 1.01 /\ |Two| <= 1.01
/\ |p1| <= 1 /\ |p2| <= 1 /\ |p3| <= 1 /\ |p4| <= 1 /\ |p5| <= 1 /\ |p6| <= 1
/\ |a| <= 3.4643 /\ |P| <= 1.7321 /\ |L| <= 3.4642 /\ |At| <= 1.7322 /\ |v| <= 3.4643 /\ |w| <= 3.4643
/\ |q1| <= 1 /\ |q2| <= 1 /\ |q3| <= 1 /\ |q4| <= 1 /\ |q5| <= 1 /\ |q6| <= 1 /\ |q7| <= 1 /\ |q8| <= 1
/\ L2 in [0,3.4643]
/\ depth in [0,3.4643] /\ |k1| <= 1 /\ |k2| <= 1 /\ |k3| <= 1 /\ |k4| <= 1
-> x*x + y*y - 0.25*ROUNDOFFS*ROUNDOFFS*U*U <= 0
/\ of_place_there <= 1b-28 /\ apart - 0.5*ROUNDOFFS*U <= 0
/\ asked - known <= 0
/\ of_root <= 0 /\ is_clear >= 0 /\ is_around >= 0 }

first -> -U*(s*a0*(r4 + r5 + U*r4*r5) + t*b0*r6);
second -> f*first + U*(s*(f*a0)*r1 - f*c0*r9 + t*(f*b0)*r2 - t*(b1 - fb)*r3 - t*d*(r7 + r8 + U*r7*r8));
one - One -> U*(s*(A - B)*(p1 + p2 + U*p1*p2)*(1 + U*p3) + One*p3);
two - Two -> (one - One)*(1 + U*p6) + U*(t*(C - B)*(p4 + p5 + U*p4*p5)*(1 + U*p6) + Two*p6);
at - At -> U*(t*L*(q4 + q5 + U*q4*q5)*(1 + U*q6) + At*q6);
along - v -> U*(4.01*w*q7*(1 + 5.01*U*q8) + 5.01*v*q8);
asked - known -> U*(28.2*1.7321*k1 + overlap*k3 - 3*depth*k2 - exact*k4 - ROUNDOFFS*(1 + 4*U*k3 - 3*U*k4));
of_root -> -2*((L2 - 1)*(L2 - 1)) - 0.00003836*((L2 + 1)*(L2 + 1)) + 40*U*(L2*L2 + 1);
is_clear -> L2*(0.4142*ROUNDOFFS - 67 - 3.01*3.4642) + 1.4142*ROUNDOFFS - 67*3.4642;
is_around -> L2*(0.4142*ROUNDOFFS - 100 - 3.01*3.4642) + 1.4142*ROUNDOFFS;
