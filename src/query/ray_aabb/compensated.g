# How far a compensated sum of three numbers may be from the truth.
# constant: LEFT
#
# Proved: where the result is not below the bound, what is unaccounted for, the rounding of what
# was lost, is at most 0.018·U of it. With its own rounding it is within 1.02·U of the truth.
#
# Divided by |along| + |h|. What two sums lost, e and f, are floats: at most U of the sums. If all
# is below twice the least normal number nothing is lost; so underflow takes from the product in
# the bound at most U/2, divided by 1 − U.

lost = fl(e*U, f*U);
bound = fl(LEFT*U*fl(1, 0), g*0.51*U);

{ |e| <= 1 /\ |f| <= UP1 /\ |g| <= 1
-> |lost - (e*U + f*U)| - 0.018*U*bound <= 0 }
