# How far the numbers of a translation may be from the truth, beside the errors of the overlap and of
# a coordinate.
# constant: ROUNDOFFS
# only: f64
#
# The overlap o, the coordinate a and the length l that are computed are divided by themselves. Their
# truths are o·(1 + eo), a·(1 + ea) and l/(1 + er), with |er| below 2.67e-15, 24·U, as the comment derives, and
# |eo| and |ea| below 2^-20.
#
# Proved: the truth of a number is what is computed, plus eo or ea or their sum, plus `rest`. The rest
# is below the bound but for U/4, by which exact numbers err, and 2·U for the two ends; a hundredth of
# eo and ea in the code covers their product, and the roundings of the error itself.

# Each product and the quotient is rounded: a factor of 1 + d.
inverse = 1 + d1;
depth = inverse*(1 + d2);
size = (inverse*(1 + d3))*depth*(1 + d4);

# (1 + eo)·(1 + er), and (1 + ea)·(1 + er) likewise.
rest_of_one = er + e*er + (1 - depth);
# (1 + eo)·(1 + ea)·(1 + er)², without eo·ea.
rest_of_two = (1 + e)*(1 + f)*(er*(2 + er)) + (1 - size);

{ |er| <= 2.67e-15 /\ |e| <= 1b-20 /\ |f| <= 1b-20
/\ |d1| <= 1b-53 /\ |d2| <= 1b-53 /\ |d3| <= 1b-53 /\ |d4| <= 1b-53
-> |rest_of_one| - ROUNDOFFS*U <= -5b-54 /\ |rest_of_two| - ROUNDOFFS*U <= -5b-54 }
