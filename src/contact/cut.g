# The overlap along a direction, from numbers that are cut.
# constant: ERROR
# only: f64
#
# Two places and six reaches have three coordinates each: 24 products of a coordinate x, cut by f, and
# of one of the direction, a, cut by e. No error of a product is greater than the greatest, so 24 times
# one bounds their sum. The overlap is in units of 2^30, and cut once more, by g.

# (a - e)*(x - f) - a*x
product = e*f - a*f - e*x;
overlap = 24*product*1b-30 - g;

{ |a| <= 1b30 /\ |x| <= 1b26 /\ e in [0,1] /\ f in [0,1] /\ g in [0,1]
-> |overlap| <= ERROR }
