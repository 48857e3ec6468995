# What rounded numbers add to the error of an overlap along a direction.
# constant: ERROR
# only: f64
#
# Two places x, off by f, and four reaches y, off by g, have three coordinates each. Each is multiplied by a
# coordinate of the direction, a, off by e and d. No error of a product is greater than the greatest, so 6
# and 12 times one bound their sums. e*x and e*y are counted apart, by the sizes of all numbers, and d by
# the greatest sum of these. Three products are cut to units of 2^3, by h, and so is the sum of all e*x.

# (a + e + d)*(x + f) - a*x - e*x - d*x
place = a*f + (e + d)*f;
reach = a*g + (e + d)*g;
overlap = 2*(3*place*1b-3 + h) + 4*(3*reach*1b-3 + h) + h + d*s*1b-3;

{ |a| <= 1b15 /\ |e| <= 9 /\ |d| <= 1b-8 /\ |f| <= 1025b-11 /\ |g| <= 2049b-11 /\ |h| <= 1 /\ s in [0,589824]
-> |overlap| <= ERROR }
