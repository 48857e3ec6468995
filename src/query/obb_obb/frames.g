# How far a gap of two boxes, one in the frame of the other, may be from that of the exact products.
# constant: ROUNDING
# constant: TILT
# only: f32
#
# Proved: |computed − exact| of a product of two axes is at most 13, which is TILT, roundoffs, of an axis and the
# difference of the centres at most 22, and of the gap on a face and on a pair of axes one less than
# ROUNDING, underflow included. That one is for the bound: it loses less than four roundoffs of
# itself, and is below 1/4 because the tilt is below 2^-7.
#
# Lengths are divided by R, the greatest magnitude computed. Numbers of the shapes are rounded on
# the way in, by so many roundoffs: an axis by 1, which has components up to 1.008, a half-extent by
# 2, which includes an underflow, and the difference of the centres by 4. By Cauchy and Schwarz, sums
# of products of two axes are at most 1.017, and of an axis and the difference at most 1.76.
#
# The magnitude of x, computed where X is true, is |X| + s·(x − X) for some |s| ≤ 1.

# The product of two axes, and of an axis and the difference.
two = fl(fl(ax*ex, z1), fl(ay*ey, z2)); Two = (Ax*Ex + o) + (Ay*Ey + o);
product = fl(two, fl(az*ez, z3)); Product = Two + (Az*Ez + o);
both = fl(fl(ax*dx, z4), fl(ay*dy, z5)); Both = (Ax*Dx + o) + (Ay*Dy + o);
way = fl(both, fl(az*dz, z6)); Way = Both + (Az*Dz + o);

# Such products, with those errors; p, q, r and s of axes, v and w of the difference.
p_abs = |P| + s1*(p - P); P_abs = |P| + o;
q_abs = |Q| + s2*(q - Q); Q_abs = |Q| + o;
r_abs = |R| + s3*(r - R); R_abs = |R| + o;
s_abs = |S| + s4*(s - S); S_abs = |S| + o;
v_abs = |V| + s5*(v - V); V_abs = |V| + o;

# A face.
face = fl(v_abs, -fl(h, fl(fl(fl(k*q_abs, z7), fl(l*r_abs, z8)), fl(i*s_abs, z9))));
Face = V_abs + -(H + (((K*Q_abs + o) + (L*R_abs + o)) + (I*S_abs + o)));

# A pair of axes.
cross = fl(fl(v*p, z10), -fl(w*q, z11)); Cross = (V*P + o) + -(W*Q + o);
cross_abs = |Cross| + s6*(cross - Cross); Cross_abs = |Cross| + o;
reach = fl(fl(fl(h*q_abs, z12), fl(i*p_abs, z13)), fl(fl(k*s_abs, z14), fl(l*r_abs, z15)));
Reach = ((H*Q_abs + o) + (I*P_abs + o)) + ((K*S_abs + o) + (L*R_abs + o));
pair = fl(cross_abs, -reach); Pair = Cross_abs + -Reach;

{ o in [0,0]
/\ |Ax| <= 1.008 /\ |Ay| <= 1.008 /\ |Az| <= 1.008 /\ |Ex| <= 1.008 /\ |Ey| <= 1.008
/\ |Ez| <= 1.008 /\ |ax - Ax| <= 6.03e-8 /\ |ay - Ay| <= 6.03e-8 /\ |az - Az| <= 6.03e-8 /\ |ex - Ex| <= 6.03e-8
/\ |ey - Ey| <= 6.03e-8 /\ |ez - Ez| <= 6.03e-8 /\ |dx| <= 1 /\ |dy| <= 1 /\ |dz| <= 1 /\ |Dx| <= UP4 /\ |Dy| <= UP4
/\ |Dz| <= UP4 /\ |dx - Dx| <= 4b-24 /\ |dy - Dy| <= 4b-24 /\ |dz - Dz| <= 4b-24 /\ |Two| <= 1.017 /\ |Product| <= 1.017
/\ |Both| <= 1.76 /\ |Way| <= 1.76 /\ |z1| <= LOST0 /\ |z2| <= LOST0 /\ |z3| <= LOST0
/\ |z4| <= LOST1 /\ |z5| <= LOST1 /\ |z6| <= LOST1
/\ |P| <= 1.017 /\ |Q| <= 1.017 /\ |R| <= 1.017 /\ |S| <= 1.017 /\ |V| <= 1.76 /\ |W| <= 1.76
/\ |p - P| <= 13b-24 /\ |q - Q| <= 13b-24 /\ |r - R| <= 13b-24 /\ |s - S| <= 13b-24 /\ |v - V| <= 22b-24 /\ |w - W| <= 22b-24
/\ |h| <= 1 /\ |i| <= 1 /\ |k| <= 1 /\ |l| <= 1 /\ |h - H| <= 2b-24 /\ |i - I| <= 2b-24 /\ |k - K| <= 2b-24 /\ |l - L| <= 2b-24
/\ |s1| <= 1 /\ |s2| <= 1 /\ |s3| <= 1 /\ |s4| <= 1 /\ |s5| <= 1 /\ |s6| <= 1
/\ |z7| <= LOST1 /\ |z8| <= LOST1 /\ |z9| <= LOST1 /\ |z10| <= LOST1 /\ |z11| <= LOST1
/\ |z12| <= LOST1 /\ |z13| <= LOST1 /\ |z14| <= LOST1 /\ |z15| <= LOST1
-> |product - Product| - 13*U <= 0 /\ 13 - TILT <= 0
/\ |way - Way| - 22*U <= 0
/\ |face - Face| - (ROUNDING - 1)*U <= 0
/\ |pair - Pair| - (ROUNDING - 1)*U <= 0
/\ |pair| <= ROOM1 }
