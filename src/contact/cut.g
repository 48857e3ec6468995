# What rounded numbers add to the error of an overlap along a direction.
# constant: ERROR
# only: f64
#
# Two places and six reaches have three coordinates each: 24 products of a coordinate x, off by f, and
# of one of the direction, a, off by e. No error of a product is greater than the greatest, so 24 times
# one bounds their sum. e*x is counted apart, by the sizes of all x. Each product is cut to units of 2^4,
# by g, and so is the sum of all e*x, by h.

# (a + e)*(x + f) - a*x - e*x
product = a*f + e*f;
overlap = 24*(product*1b-4 + g) + h;

{ |a| <= 1b15 /\ |e| <= 9 /\ |f| <= 4097b-13 /\ |g| <= 1 /\ h in [0,1]
-> |overlap| <= ERROR }
