# How far the gaps of two tilted boxes are from those of the products that the filter takes.
# constant: FRAME
# only: f32
#
# Proved: the difference, divided by the tilt t and by R, is at most FRAME, on a face and on a pair
# of axes; nothing is rounded. `error_bound.rs` derives the forms: products of axes P, Q, R, S are
# P + t·p and so on, those of an axis and the difference of the centres V + t·v and W + t·w, and the
# ratio of the determinants is 1 + t·x. s and so on are the signs, or less, that magnitudes take.

face = s1*v + -(h*s2*q + k*s3*r + l*s4*s);
cross = (v*(P + t*p) + V*p) + -(w*(Q + t*q) + W*q);
reach = (h*s1*q + i*s2*p) + (k*s3*(s + x*(S + t*s)) + l*s4*(r + x*(R + t*r)));
pair = s5*cross + -reach;

{ t in [0,1b-6] /\ |s1| <= 1 /\ |s2| <= 1 /\ |s3| <= 1 /\ |s4| <= 1 /\ |s5| <= 1
/\ |h| <= 1.000001 /\ |i| <= 1.000001 /\ |k| <= 1.000001 /\ |l| <= 1.000001
/\ |P| <= 1.016 /\ |Q| <= 1.016 /\ |R| <= 1.016 /\ |S| <= 1.016 /\ |V| <= 1.76 /\ |W| <= 1.76
/\ |p| <= 1.9 /\ |q| <= 1.9 /\ |r| <= 1.9 /\ |s| <= 1.9 /\ |v| <= 3.24 /\ |w| <= 3.24 /\ |x| <= 3.2
-> |face| - FRAME <= 0 /\ |pair| - FRAME <= 0 }
