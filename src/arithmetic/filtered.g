# How the quotient of two numbers that err compares with t.
# constant: CLEARANCE
#
# Proved: where num/den is t or less, num − t·den as computed is at most the error allowed, and
# likewise on the other side. For what numerator and denominator err, U·(a + b), and what the
# product t·den errs, rounded once more with the gap, are together at most that error. Underflow
# included.
#
# U·a is the error of the numerator, U·b that of the denominator times |t|, and c is |t·den|: all
# divided so that a + b + c = 1, with w = a + b. The error of a volume is above U times the cube of
# the lower end of `Float::RANGE`: U·2^-96 (`f32`) or U·2^-960. So the least number, 2^-149 or
# 2^-1074, divided by that sum is far below 16·U².

b = w - a;
c = 1 - w;
product = fl(c, e*(16*U*U));
den_error = fl(U*b, f*(16*U*U));
num_error = U*a;
error = fl(CLEARANCE*fl(num_error, den_error), fl(CLEARANCE*U*product, g*(16*U*U)));

{ o in [0,0] /\ w in [0,1] /\ a in [0,1] /\ b in [0,1] /\ |e| <= 1 /\ |f| <= 1 /\ |g| <= 1
-> (U*w + |product - (c + o)|)*(1 + U) - error <= 0 }
$ w in 16, a in 16;
