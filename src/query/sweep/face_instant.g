# How far what is left of a gap between a triangle and a face of an axis-aligned box may be from the
# truth at one time of the way.
# constant: FACE
#
# Proved: |computed − true| is at most the bound as it is computed, but for underflow.
#
# All is as in `face.g`; t is the time. The product with it and that in the bound may each lose half
# the least number: z is what the former does. The bound has the least normal number besides, which is
# more; and is enough alone where the size is below 2^20 least numbers, so that |z| is at most 2^-20
# elsewhere.

a = fl(x, -c);
g = fl(a, -h);
d = fl(u, -f);
left = fl(g, -fl(d*t, z));
Left = ((x + -c) + -h) + -((u + -f)*t + z);
bound = fl(FACE*U*1, 0);

{ t in [0,1] /\ |a| <= 1 /\ |x + -c| <= UP4 /\ h in [0,1] /\ |g| <= 1 /\ |a + -h| <= UP4 /\ |d| <= 1
/\ |u + -f| <= UP4 /\ |left| <= UP4 /\ |z| <= 1b-20
-> |left - Left| - bound <= 0 }
