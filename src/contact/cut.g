# What rounded numbers add to the error of an overlap along a direction, and how far depths may be off.
# constant: ERROR
# constant: LACK
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

# A length of one that is computed, the least and the greatest true one, both in units of it, and the inverse of
# the length that is computed, by less than 2^-12 of itself too low. 7095 is above 2^12 times the root of three.
off = (e + 1b-8)*7095b-26;
most = (1 - 1b-12)*(1 - off)*(1 + (e + LACK)*1b-13);
least = (1 + off)*(1 - (e + LACK)*1b-13);

{ |a| <= 1b15 /\ e in [1,9] /\ |d| <= 1b-8 /\ |f| <= 1025b-11 /\ |g| <= 2049b-11 /\ |h| <= 1 /\ s in [0,589824]
-> |overlap| <= ERROR /\ most >= 1 /\ least <= 1 }

$ e in 16;
