# How far the area and the volume of a point and a triangle may be from the truth.
# constant: TURN
# constant: VOLUME
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included.
#
# The area: each difference is divided by itself as computed, up to its sign. The products are
# multiplied by p and q, their sizes, divided by size = p + q. As in line_aabb/roundoffs.g: if
# size ≥ (least normal)/(8·U), what underflow takes is below 16·U²·size, and `turn_bound` is the
# bound without the least normal number that the code adds. If size is less than that, divide by
# (least normal)/(8·U) instead: the least normal number, `small`, is 8·U. An overflow makes the
# size infinite, or a NaN, and leaves the query in doubt.
#
# The volume: all corners seen from the point are divided by R.

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

ax = fl(axp, -axo); Ax = axp + -axo;
ay = fl(ayp, -ayo); Ay = ayp + -ayo;
az = fl(azp, -azo); Az = azp + -azo;
bx = fl(bxp, -bxo); Bx = bxp + -bxo;
by = fl(byp, -byo); By = byp + -byo;
bz = fl(bzp, -bzo); Bz = bzp + -bzo;
cx = fl(cxp, -cxo); Cx = cxp + -cxo;
cy = fl(cyp, -cyo); Cy = cyp + -cyo;
cz = fl(czp, -czo); Cz = czp + -czo;
mx = fl(fl(by*cz, u1), -fl(bz*cy, u2));
Mx = (By*Cz + o) + -(Bz*Cy + o);
my = fl(fl(bz*cx, u3), -fl(bx*cz, u4));
My = (Bz*Cx + o) + -(Bx*Cz + o);
mz = fl(fl(bx*cy, u5), -fl(by*cx, u6));
Mz = (Bx*Cy + o) + -(By*Cx + o);
volume = fl(fl(fl(mx*ax, u7), fl(my*ay, u8)), fl(mz*az, u9));
Volume = ((Mx*Ax + o) + (My*Ay + o)) + (Mz*Az + o);
cube = fl(fl(1, u10), u11);
volume_bound = fl(VOLUME*U*cube, u12);

{ p in [0,1] /\ o in [0,0]
/\ |vy| <= 1 /\ |vz| <= 1 /\ |py| <= 1 /\ |pz| <= 1
/\ |Vy| <= UP1 /\ |Vz| <= UP1 /\ |Py| <= UP1 /\ |Pz| <= UP1
/\ |e| <= 1 /\ |g| <= 1 /\ |k| <= 1 /\ |l| <= 1 /\ |n| <= 1
/\ |ax| <= 1 /\ |Ax| <= UP1 /\ |ay| <= 1 /\ |Ay| <= UP1 /\ |az| <= 1 /\ |Az| <= UP1
/\ |bx| <= 1 /\ |Bx| <= UP1 /\ |by| <= 1 /\ |By| <= UP1 /\ |bz| <= 1 /\ |Bz| <= UP1
/\ |cx| <= 1 /\ |Cx| <= UP1 /\ |cy| <= 1 /\ |Cy| <= UP1 /\ |cz| <= 1 /\ |Cz| <= UP1
/\ |u1| <= LOST2 /\ |u2| <= LOST2 /\ |u3| <= LOST2 /\ |u4| <= LOST2 /\ |u5| <= LOST2
/\ |u6| <= LOST2 /\ |u7| <= LOST3 /\ |u8| <= LOST3 /\ |u9| <= LOST3
/\ |u10| <= LOST2 /\ |u11| <= LOST3 /\ |u12| <= LOST3
-> |turn - Turn| - turn_bound <= 0 /\ |turn - Turn| - small <= 0
/\ |volume - Volume| - volume_bound <= 0 /\ |volume| <= ROOM3 }
$ p in 16;
