# A component of a vector to the end of a way, less the radius.
# constant: ASIDE
#
# All is divided by the slack, the sum of the sizes of all vectors, plus the radius. It bounds the
# parts of the component, a vector a - b or a - b + h and the way, and the radius. It and the bound
# are rounded, and therefore up to a hundredth too small.

from = fl(a, minus_b);
start = fl(from, h);
way = fl(to, minus_s);
end = fl(start, way);
gap = fl(end, minus_r);

From = a + minus_b;
Start = From + h;
Way = to + minus_s;
End = Start + Way;
Gap = End + minus_r;

{ |from| <= UP4 /\ |start| <= UP4 /\ |way| <= UP4 /\ |end| <= UP4 /\ |minus_r| <= 1 /\ |gap| <= 2
/\ size in [0.99,1]
-> |gap - Gap| - ASIDE*U*size <= 0 }
