# How far the gap between a prepared triangle and an axis-aligned box on a coordinate axis may be from
# the truth, by offsets.
# constant: OFFSET_FACE
# only: f32
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included.
#
# All is divided by R as in `edges.g`. A vertex errs by 3·U·X as in `offset_edges.g`, and a half-extent
# is rounded once.

X = 1 + 16*U;
W = 3.001*U;

V = (X*c + o) + o;  v = (X*c + X*W*m) + z1;
H = X*g + o;  h = fl(X*g, z2);
gap = fl(v, -h);  Gap = V + -H;

bound = fl(OFFSET_FACE*U, z3);

{ o in [0,0] /\ |c| <= 1 /\ |m| <= 1 /\ g in [0,1] /\ |z1| <= LOST1 /\ |z2| <= LOST1
/\ |z3| <= LOST1
-> |gap - Gap| - bound <= 0 }
