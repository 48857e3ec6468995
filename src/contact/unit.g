# How far a coordinate of a unit vector in double words may be from the truth.
# constant: LOST
# only: f64
#
# The coordinate and the length are divided by themselves: their truths are one. The computed coordinate
# is 1 + ea, of which al is the second word, and the computed square 1 + es.
#
# Terms of first order cancel; what is left of them is written out.

# One over the length is 1 + f, and the first length 1 + e1.
inverse = 1 + f;

# The rest of the square; x is the difference of the second words, which is rounded.
t = es - 2*e1 - e1*e1;
D = (1 + f)*(1 + d3)*(1 + d4) - 1;
low = 0.5*(t + x*d2)*(1 + D);

# The length, less one: e1 + low.
el = 0.5*(es - e1*e1)*(1 + D) - e1*D + 0.5*x*d2*(1 + D);

# The quotient of the leading words, less one.
eh = (1 + ea - al)*inverse*(1 + d5) - 1;

# The residual of the coordinate, and its roundings; y is the second word of the product of the
# quotient and the root.
r = ea - eh - el - eh*el;
m = (1 + eh)*low*(1 + d6);
p = (y + m)*(1 + d7);
w = (al - p)*d8 - (y + m)*d7 - (1 + eh)*low*d6;

# The sum of the quotient and the residual over the root, less one.
of_length = (ea - el)/(1 + el);
of_root = r*(f + el + f*el)/(1 + el);
of_residual = inverse*(r*(d9 + d10 + d9*d10) + w*(1 + d9)*(1 + d10));
error = of_length + of_root + of_residual;

{ |ea| <= 1b-97 /\ |es| <= 1b-95 /\ |al| <= 1b-53 /\ |e1| <= 50b-53 /\ |f| <= 25b-53
/\ |x| <= 3b-53 /\ |y| <= 2b-53
/\ |d2| <= 1b-53 /\ |d3| <= 1b-53 /\ |d4| <= 1b-53 /\ |d5| <= 1b-53
/\ |d6| <= 1b-53 /\ |d7| <= 1b-53 /\ |d8| <= 1b-53 /\ |d9| <= 1b-53 /\ |d10| <= 1b-53
-> |error| - LOST*1b-106 <= 0 }
