# The ends of an interval around a quotient t, and around a + v·t.
# constant: ENDS
# constant: ENDS_ON_LINE
#
# Proved: what t, or a + v·t, may be off, and the rounding of an end, are together at most the error
# as it is computed.
#
# By hand: if num and den err by up to `error` and `other`, of which the second is at most den/4, the
# truth is at most 4/3 of (error + |t|·other)/den away from num/den. The bound m is twice that, rounded
# five times. So 3/4 of it suffices, and the rest is far above what t loses to underflow. t is
# rounded twice, in a row up to four times, as is allowed. A component of v errs by a roundoff of itself and `of_v`: n is |v|·m + of_v·(|t| + m),
# rounded up to six times. s is |v·t|, rounded three times and off by a roundoff of v as well, and b is
# |a + v·t|. An end is asked for only if it is a normal number, so each of up to six underflows
# loses less than U·b.
#
# What is rounded k times is (1 + k·U·r) times the truth, with |r| a little above 1. All are divided so
# that m + q = 1, with q = |t|, and n + s + b = 1.

q = 1 - m;
y = (m + q)*(1 + 3*U*r1);
error = (m + ENDS*U*y)*(1 + 2*U*r2);
left = m*0.75 + U*(4*q) + U*(q + error) - error;

b = 1 - n - s;
e = n*(1 + 6*U*r3); x = b*(1 + U*r4);
z = (e + s + x)*(1 + 6*U*r5);
error_on_line = (e + ENDS_ON_LINE*U*z)*(1 + 2*U*r6);
left_on_line = n + U*(5*s + 7*b) + U*(x + error_on_line) - error_on_line;

{ m in [0,1] /\ n in [0,1] /\ s in [0,1] /\ b in [0,1]
/\ |r1| <= 1.01 /\ |r2| <= 1.01 /\ |r3| <= 1.01 /\ |r4| <= 1.01 /\ |r5| <= 1.01 /\ |r6| <= 1.01
-> left <= 0 /\ left_on_line <= 0 }

m + q -> 1;
e + s + x -> 1 + 6*U*r3*n + U*r4*b;
left -> U*(5*q + error - 2*r2*m - ENDS*y*(1 + 2*U*r2)) - 0.25*m;
left_on_line -> U*(5*s + 7*b + x + error_on_line - 6*r3*n - 2*r6*e - ENDS_ON_LINE*z*(1 + 2*U*r6));
