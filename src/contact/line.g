# How far the numbers of a line from a triangle to a point may be from the truth: a way across an
# edge, a normal, a volume, a scalar product, and the gap r² − d² in double words.
# constant: WAY
# constant: NORMAL
# constant: VOLUME
# constant: DOT
# constant: GAP
# constant: GAP_OF_FACE
# only: f64
#
# Proved: what is computed differs from the truth by the bound at most, with four roundings in what the
# bound is multiplied by.
#
# Vectors are rounded once. What is rounded k times is (1 + k·U·r) times the truth, with |r| a little
# above 1; k·U·r of a sum is of the sum of magnitudes. Nothing underflows, as the comment says.
#
# Way: |d| and |e| are one, Euclidean, and so |d·e| is at most one, and t = d·e. A term of it has
# three roundings and two of sums. Those of e, of e·e, of the quotient and of its product with e are 8.

way = (d*(1 + U*r3) - e*(T + 5*U*r1)*(1 + 8*U*r2))*(1 + U*r6);
Way = d - e*T;

# Normal: the greater product of each coordinate, as it is computed, is one, and so is dᵢ.
n = (x*(1 + 3*U*r7) - y*(1 + 3*U*r8))*(1 + U*r9);
N = x - y;
volume = (N + NORMAL*U*r10)*(1 + 4*U*r11);

# Scalar product with v; the error of a itself is added.
product = a*v*(1 + 4*U*r12);

# Gaps, in U². A product of double words errs by 5, and a sum by 3. Points: r² is exact, and one; d·d is
# at most r² where the gap is above zero.
points = 11.1*dd + 3*gap;
# An edge: (r² + d·d)·(e·e) is one. The first factor errs by `first` if e·e is one.
first = 11.1*s + 3*1;
edge = first + (11.1 + 5.01) + 2*11.1 + 5.01 + 3.01;
# A face: the products of the normal are one as above, and errors are relative to NORMAL² and VOLUME².
normal = 2*5.01 + 3*2.01;
nn = 2*2.01*normal + 11.1*4.02;
whole = nn + 5.01*4.02 + 3.01*4.02;
of_volume = normal + 11.1*2.01;
square = 2*2.01*of_volume + 5.01*4.05 + 3.01*4.05;

{ |T| <= 1.01 /\ |d| <= 1 /\ |e| <= 1 /\ |Way| <= 1.01 /\ |x| <= 1.0001 /\ |y| <= 1.0001 /\ |a| <= 1 /\ |v| <= 1
/\ |r1| <= 1.01 /\ |r2| <= 1.01 /\ |r3| <= 1.01 /\ |r6| <= 1.01 /\ |r7| <= 1.01 /\ |r8| <= 1.01
/\ |r9| <= 1.01 /\ |r10| <= 1 /\ |r11| <= 1.01 /\ |r12| <= 1.01
/\ dd in [0,1.01] /\ gap in [0,1.01] /\ s in [0,1]
-> |way - Way| - WAY*U*(1 - 4*U) <= 0
/\ |n - N| - NORMAL*U*(1 - 4*U) <= 0
/\ |volume - N| - VOLUME*U*(1 - 8*U) <= 0
/\ |product - a*v| - DOT*U*(1 - 8*U) <= 0
/\ points - 0.99*GAP <= 0 /\ edge - 0.99*GAP <= 0
/\ whole - 0.99*GAP_OF_FACE*NORMAL*NORMAL <= 0 /\ square - 0.99*GAP_OF_FACE*VOLUME*VOLUME <= 0 }

way - Way -> U*((d*r3 - e*(5*r1*(1 + 8*U*r2) + 8*T*r2))*(1 + U*r6) + Way*r6);
n - N -> U*(3*(x*r7 - y*r8)*(1 + U*r9) + N*r9);
volume - N -> U*(NORMAL*r10*(1 + 4*U*r11) + 4*N*r11);
product - a*v -> U*(4*a*v*r12);
