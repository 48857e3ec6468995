# A sum of numbers with errors.
# constant: ROUNDED
# constant: RAISED
# only: f64
#
# Errors are divided by what they should add up to: the errors of both numbers, a and b, and one
# roundoff of the sum that has been rounded, r. The last counts twice, ROUNDED.
# Without underflow; sums are exact there, and a product has LOST.

sum = ((a + b)*(1 + d1) + ROUNDED*r*(1 + d2))*(1 + d3);
error = sum*(1 + RAISED*U)*(1 + d4);

{ a in [0,1] /\ b in [0,1] /\ r in [0,1] /\ a + b + r in [1,1]
/\ |d1| <= U /\ |d2| <= U /\ |d3| <= U /\ |d4| <= U
-> error >= 1 }
