# How far what is left of a gap between a triangle and a face of an axis-aligned box may be from the
# truth when the triangle has moved.
# constant: FACE
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included.
#
# All is divided by the computed size, |g| + h + |d|. Of a box by its centre a is the way from the
# centre to a coordinate and h the half-extent; of one by its corners a is the gap and h zero there.
# Sums do not underflow. The product in the bound may lose half the least number; but below twice
# the least normal number, divided by the size at most 1, sums are exact, and any bound will do.

a = fl(x, -c);
g = fl(a, -h);
d = fl(t, -f);
left = fl(g, -d);
Left = ((x + -c) + -h) + -(t + -f);
bound = fl(FACE*U*1, e*0.51*U);

{ |a| <= 1 /\ |x + -c| <= UP4 /\ h in [0,1] /\ |g| <= 1 /\ |a + -h| <= UP4 /\ |d| <= 1
/\ |t + -f| <= UP4 /\ |left| <= UP4 /\ |g + -d| <= UP4 /\ |e| <= 1
-> |left - Left| - bound <= 0 }
