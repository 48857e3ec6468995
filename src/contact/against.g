# How far half words of a face's normal, n, are off, and its products with a side, u, and a unit vector, v.
# constant: ALONG
# only: f64
#
# Two sides x and y are cut to half words, off by c to f. Their cross product w has 28 bits or more, and its
# coordinates lose at least 14 of them, and less than one of what is left, h. A unit vector is in units of 2^-15.
# The greatest coordinate of n is at least 2^13; the length of n in these units is l.

# (x1 + c)*(y2 + d) - (x2 + e)*(y1 + f) - (x1*y2 - x2*y1), in what is left of it
normal = (x1*d + y2*c + c*d - x2*f - y1*e - e*f)*s + h;

# Three of (n + m)*(u + g) - n*u
along = 3*(n*g + u*m + m*g);

# (n + m)*(v + g) - n*v over the lengths of n and v, l and 2^15: at most 1.7321*l for n*g, and
# 17.3206*(2^15 + 1.7321) for m*(v + g), for the sums of three squares are at most 3 and 300. Then half
# of it times l is rounded down, by b.
cosine = (1.7321*l + 17.3206*(1b15 + 1.7321))/(l*1b15) + b/l*2;

# One cosine, p, is 1.0323 times another, the root of 16/15 less what n*n has lost; each is off by k.
apart = p - p/1.0323 - 2*k;

{ |x1| <= 1b15 /\ |x2| <= 1b15 /\ |y1| <= 1b15 /\ |y2| <= 1b15 /\ |c| <= 1 /\ |d| <= 1 /\ |e| <= 1 /\ |f| <= 1
/\ s in [0,1b-14] /\ |h| <= 1 /\ |n| <= 1b14 /\ |m| <= 10 /\ |u| <= 1b15 /\ |g| <= 1 /\ l in [8192,28378]
/\ b in [0,1] /\ p in [0.5,1.01] /\ k in [0,0.0025]
-> |normal| <= 10 /\ |along| - ALONG <= 0 /\ cosine <= 0.0025 /\ apart >= 0.01 }
