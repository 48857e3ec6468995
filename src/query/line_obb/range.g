# How far a numerator and a divisor in two words may be from the truth.
# constant: PART
# only: f64
#
# Axes are at most one in size, and so are m, h and the direction, in units of R and D. First words add
# and multiply without loss, but for rests; second words are rounded.

# A coordinate of w: p is the difference of two second words, e the rest of that of the first words.
w1 = (e1 + p1*(1 + a1))*(1 + b1);  lost1 = p1*a1 + (e1 + p1*(1 + a1))*b1;
w2 = (e2 + p2*(1 + a2))*(1 + b2);  lost2 = p2*a2 + (e2 + p2*(1 + a2))*b2;
w3 = (e3 + p3*(1 + a3))*(1 + b3);  lost3 = p3*a3 + (e3 + p3*(1 + a3))*b3;

# Times a coordinate y + z of m. h is the first word of w, f the rest of h*y. w*z is left out.
g1 = w1*y1*(1 + c1) + h1*z1*(1 + d1);  m1 = (f1 + g1*(1 + i1))*(1 + j1);
g2 = w2*y2*(1 + c2) + h2*z2*(1 + d2);  m2 = (f2 + g2*(1 + i2))*(1 + j2);
g3 = w3*y3*(1 + c3) + h3*z3*(1 + d3);  m3 = (f3 + g3*(1 + i3))*(1 + j3);
of_m1 = w1*y1*c1 + h1*z1*d1 + g1*i1 + (f1 + g1*(1 + i1))*j1 - w1*z1 + lost1*(y1 + z1);
of_m2 = w2*y2*c2 + h2*z2*d2 + g2*i2 + (f2 + g2*(1 + i2))*j2 - w2*z2 + lost2*(y2 + z2);
of_m3 = w3*y3*c3 + h3*z3*d3 + g3*i3 + (f3 + g3*(1 + i3))*j3 - w3*z3 + lost3*(y3 + z3);

# Times a coordinate x of an axis or of the direction.
v1 = (n1 + w1*x1*(1 + o1))*(1 + q1);  of_v1 = w1*x1*o1 + (n1 + w1*x1*(1 + o1))*q1 + lost1*x1;
v2 = (n2 + w2*x2*(1 + o2))*(1 + q2);  of_v2 = w2*x2*o2 + (n2 + w2*x2*(1 + o2))*q2 + lost2*x2;
v3 = (n3 + w3*x3*(1 + o3))*(1 + q3);  of_v3 = w3*x3*o3 + (n3 + w3*x3*(1 + o3))*q3 + lost3*x3;

# Sums of three, with rests r and s of the first words.
m12 = (rm + (m1 + m2)*(1 + k1))*(1 + k2);   m123 = (sm + (m12 + m3)*(1 + k3))*(1 + k4);
of_m = of_m1 + of_m2 + of_m3 + (m1 + m2)*k1 + (rm + (m1 + m2)*(1 + k1))*k2
     + (m12 + m3)*k3 + (sm + (m12 + m3)*(1 + k3))*k4;
v12 = (rv + (v1 + v2)*(1 + l1))*(1 + l2);   v123 = (sv + (v12 + v3)*(1 + l3))*(1 + l4);
of_v = of_v1 + of_v2 + of_v3 + (v1 + v2)*l1 + (rv + (v1 + v2)*(1 + l1))*l2
     + (v12 + v3)*l3 + (sv + (v12 + v3)*(1 + l3))*l4;

# The volume times a half-extent t, and the numerator.
reach = (rt + v123*t*(1 + t1))*(1 + t2);
of_reach = of_v*t + v123*t*t1 + (rt + v123*t*(1 + t1))*t2;
of_num = of_m + of_reach + (m123 + reach)*t3 + (st + (m123 + reach)*(1 + t3))*t4;

{ |p1| <= 2b-53 /\ |p2| <= 2b-53 /\ |p3| <= 2b-53
/\ |e1| <= 3b-53 /\ |e2| <= 3b-53 /\ |e3| <= 3b-53
/\ |h1| <= 2.01 /\ |h2| <= 2.01 /\ |h3| <= 2.01
/\ |y1| <= 1 /\ |y2| <= 1 /\ |y3| <= 1 /\ |z1| <= 1b-53 /\ |z2| <= 1b-53 /\ |z3| <= 1b-53
/\ |f1| <= 3b-53 /\ |f2| <= 3b-53 /\ |f3| <= 3b-53
/\ |x1| <= 1 /\ |x2| <= 1 /\ |x3| <= 1 /\ |n1| <= 3b-53 /\ |n2| <= 3b-53 /\ |n3| <= 3b-53
/\ |rm| <= 5b-53 /\ |sm| <= 7b-53 /\ |rv| <= 5b-53 /\ |sv| <= 7b-53
/\ |t| <= 1 /\ |rt| <= 7b-53 /\ |st| <= 13b-53
/\ |a1| <= 1b-53 /\ |b1| <= 1b-53 /\ |a2| <= 1b-53 /\ |b2| <= 1b-53 /\ |a3| <= 1b-53 /\ |b3| <= 1b-53
/\ |c1| <= 1b-53 /\ |d1| <= 1b-53 /\ |i1| <= 1b-53 /\ |j1| <= 1b-53
/\ |c2| <= 1b-53 /\ |d2| <= 1b-53 /\ |i2| <= 1b-53 /\ |j2| <= 1b-53
/\ |c3| <= 1b-53 /\ |d3| <= 1b-53 /\ |i3| <= 1b-53 /\ |j3| <= 1b-53
/\ |o1| <= 1b-53 /\ |q1| <= 1b-53 /\ |o2| <= 1b-53 /\ |q2| <= 1b-53 /\ |o3| <= 1b-53 /\ |q3| <= 1b-53
/\ |k1| <= 1b-53 /\ |k2| <= 1b-53 /\ |k3| <= 1b-53 /\ |k4| <= 1b-53
/\ |l1| <= 1b-53 /\ |l2| <= 1b-53 /\ |l3| <= 1b-53 /\ |l4| <= 1b-53
/\ |t1| <= 1b-53 /\ |t2| <= 1b-53 /\ |t3| <= 1b-53 /\ |t4| <= 1b-53
-> |of_num| - PART*160b-106 <= 0 /\ |of_v| - PART*40b-106 <= 0 }
