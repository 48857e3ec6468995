# How far the area between a point and an edge may be from the truth.
# constant: TURN
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included.
#
# Each difference is divided by itself as computed, up to its sign. The products are
# multiplied by p and q, their sizes, divided by size = p + q. As in line_aabb/roundoffs.g: if
# size ≥ (least normal)/(8·U), what underflow takes is below 16·U²·size, and `turn_bound` is the
# bound without the least normal number that the code adds. If size is less than that, divide by
# (least normal)/(8·U) instead: the least normal number, `small`, is 8·U. An overflow makes the
# size infinite, or a NaN, and leaves the query in doubt.

vy = fl(vyp, -vyu); Vy = vyp + -vyu;
vz = fl(vzp, -vzu); Vz = vzp + -vzu;
py = fl(pyp, -pyu); Py = pyp + -pyu;
pz = fl(pzp, -pzu); Pz = pzp + -pzu;
q = 1 - p;
turn = fl(fl(p*(vy*pz), e*(16*U*U)), -fl(q*(vz*py), g*(16*U*U)));
Turn = (p*(Vy*Pz) + o) + -(q*(Vz*Py) + o);
size = fl(fl(p*fl(1,0), k*(16*U*U)), fl(q*fl(1,0), l*(16*U*U)));
turn_bound = fl(TURN*U*size, n*(16*U*U));
small = 8*U;

{ p in [0,1] /\ o in [0,0]
/\ |vy| <= 1 /\ |vz| <= 1 /\ |py| <= 1 /\ |pz| <= 1
/\ |Vy| <= UP1 /\ |Vz| <= UP1 /\ |Py| <= UP1 /\ |Pz| <= UP1
/\ |e| <= 1 /\ |g| <= 1 /\ |k| <= 1 /\ |l| <= 1 /\ |n| <= 1
-> |turn - Turn| - turn_bound <= 0 /\ |turn - Turn| - small <= 0 }
$ p in 16;
