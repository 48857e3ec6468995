# How far a component of a normal, computed in pairs of floats, may be from the truth.
# constant: PLACES
# only: f64
#
# Proved: what the pairs leave out is at most 0.009·U of a component that cancellation took no more
# than PLACES places from. With its own rounding it is within 1.01·U of the truth.
#
# A difference is a float, divided by itself, and a second one of at most U. Products of the two
# floats are multiplied by w and by 1 − w, so that the magnitudes of both, p and q, add up to 1: the
# size. What is lost of them is known exactly, in `rest` and `rest2`, and so is `low`, what is lost
# of their difference `high`. Nothing underflows in the range of the code. The component is the
# rounded high + `less`, and the sum proved is how far that is from P − Q at most.

v = 1 - w;
cross = fl(fl(w*(e*(U*y)), 0), fl(w*((U*x)*f), 0));
p1 = fl(rest, cross);
cross2 = fl(fl(v*(g*(U*j)), 0), fl(v*((U*i)*h), 0));
q1 = fl(rest2, cross2);
less = fl(low, fl(p1, -q1));

{ w in [0,1] /\ o in [0,0] /\ |e| <= 1 /\ |f| <= 1 /\ |g| <= 1 /\ |h| <= 1
/\ |x| <= 1 /\ |y| <= 1 /\ |i| <= 1 /\ |j| <= 1
/\ |rest| <= U /\ |rest2| <= U /\ |low| <= U
-> |p1 - (rest + cross)| + |cross - ((w*(e*(U*y)) + o) + (w*((U*x)*f) + o))| + |w*((U*x)*(U*y))|
+ |q1 - (rest2 + cross2)| + |cross2 - ((v*(g*(U*j)) + o) + (v*((U*i)*h) + o))| + |v*((U*i)*(U*j))|
+ |less - (low + (p1 + -q1))| - 0.009*U*1b-PLACES <= 0 }
