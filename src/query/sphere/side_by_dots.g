# How far p·(q + r) + q·s, which says on which side of an edge a point lies, may be from the truth, if
# all four are dot products.
# constant: DOT
# constant: SIDE_BY_DOTS
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included; and nothing
# overflows.
#
# Each vector is divided by R, the greatest of all components. A dot product is then at most 3·(1 +
# U)², and so is q + r, which is one too. Each errs by DOT·U times the area as computed, at most:
# error_bound.g proves that.

dot = DOT*U*(1 + 4*U);
p = P + a*dot; q = Q + b*dot; r = R + c*dot; s = S + d*dot;
pqr = p*(q + r); qs = q*s;
sum = fl(q, r); first = fl(p*sum, z1); second = fl(qs, z2);
side = fl(first, second);
Side = P*(Q + R) + Q*S;

area = fl(1, z3);
bound = fl(SIDE_BY_DOTS*U*fl(area*area, z4), z5);

{ |P| <= 3.001 /\ |Q| <= 3.001 /\ |R| <= 3.001 /\ |S| <= 3.001 /\ |Q + R| <= 3.001
/\ |a| <= 1 /\ |b| <= 1 /\ |c| <= 1 /\ |d| <= 1
/\ |z1| <= LOST2 /\ |z2| <= LOST2 /\ |z3| <= LOST2 /\ |z4| <= LOST2 /\ |z5| <= LOST2
-> |side - Side| - bound <= 0 /\ |side| <= ROOM3 }

q + r -> (Q + R) + (b + c)*dot;
side - Side -> (side - (first + second)) + (first - pqr) + (second - qs) + (pqr - P*(Q + R)) + (qs - Q*S);
first - pqr -> (first - (p*sum + z1)) + p*(sum - (q + r)) + z1;
second - qs -> (second - (qs + z2)) + z2;
pqr - P*(Q + R) -> a*dot*(Q + R) + P*((b + c)*dot) + a*dot*((b + c)*dot);
qs - Q*S -> b*dot*S + Q*(d*dot) + b*dot*(d*dot);
