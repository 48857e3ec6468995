# How far a volume in two parts may be from the truth.
# constant: REFINED
# only: f64
#
# Proved: the lower part of a volume errs by at most REFINED − 24, in units of U·2^-25, and is at
# most 22·2^-25, so that what a sum with the higher part may lose leaves 2 to spare. Underflow
# included.
#
# Divided by the sizes of the three vectors a, b and c. h is the higher part of a component, k what
# was cut off, r what the rounding of a difference took: all without error; x is the difference, as
# rounded. n is the higher part of a component of the area, cut, and g what was cut off.

lax = fl(kax, rax); Lax = kax + rax;
xax = fl(xaxp, -xaxa); Xax = xaxp + -xaxa;
lay = fl(kay, ray); Lay = kay + ray;
xay = fl(xayp, -xaya); Xay = xayp + -xaya;
laz = fl(kaz, raz); Laz = kaz + raz;
xaz = fl(xazp, -xaza); Xaz = xazp + -xaza;
lbx = fl(kbx, rbx); Lbx = kbx + rbx;
xbx = fl(xbxp, -xbxa); Xbx = xbxp + -xbxa;
lby = fl(kby, rby); Lby = kby + rby;
xby = fl(xbyp, -xbya); Xby = xbyp + -xbya;
lbz = fl(kbz, rbz); Lbz = kbz + rbz;
xbz = fl(xbzp, -xbza); Xbz = xbzp + -xbza;
lcx = fl(kcx, rcx); Lcx = kcx + rcx;
xcx = fl(xcxp, -xcxa); Xcx = xcxp + -xcxa;
lcy = fl(kcy, rcy); Lcy = kcy + rcy;
xcy = fl(xcyp, -xcya); Xcy = xcyp + -xcya;
lcz = fl(kcz, rcz); Lcz = kcz + rcz;
xcz = fl(xczp, -xcza); Xcz = xczp + -xcza;
px = fl(fl(hay*lbz, w1), fl(lay*xbz, w2));
Px = (hay*Lbz + o) + (Lay*Xbz + o);
qx = fl(fl(haz*lby, w3), fl(laz*xby, w4));
Qx = (haz*Lby + o) + (Laz*Xby + o);
mx = fl(gx, fl(px, -qx)); Mx = gx + (Px + -Qx);
tx = fl(fl(mx*xcx, w5), fl(nx*lcx, w6));
Tx = (Mx*Xcx + o) + (nx*Lcx + o);
py = fl(fl(haz*lbx, w7), fl(laz*xbx, w8));
Py = (haz*Lbx + o) + (Laz*Xbx + o);
qy = fl(fl(hax*lbz, w9), fl(lax*xbz, w10));
Qy = (hax*Lbz + o) + (Lax*Xbz + o);
my = fl(gy, fl(py, -qy)); My = gy + (Py + -Qy);
ty = fl(fl(my*xcy, w11), fl(ny*lcy, w12));
Ty = (My*Xcy + o) + (ny*Lcy + o);
pz = fl(fl(hax*lby, w13), fl(lax*xby, w14));
Pz = (hax*Lby + o) + (Lax*Xby + o);
qz = fl(fl(hay*lbx, w15), fl(lay*xbx, w16));
Qz = (hay*Lbx + o) + (Lay*Xbx + o);
mz = fl(gz, fl(pz, -qz)); Mz = gz + (Pz + -Qz);
tz = fl(fl(mz*xcz, w17), fl(nz*lcz, w18));
Tz = (Mz*Xcz + o) + (nz*Lcz + o);
low = fl(fl(tx, ty), tz); Low = (Tx + Ty) + Tz;

{ o in [0,0] /\ |hax| <= 33554433b-25 /\ |kax| <= 33554433b-50 /\ |rax| <= U /\ |xax| <= 1
/\ |Xax| <= UP1 /\ |hay| <= 33554433b-25 /\ |kay| <= 33554433b-50 /\ |ray| <= U /\ |xay| <= 1
/\ |Xay| <= UP1 /\ |haz| <= 33554433b-25 /\ |kaz| <= 33554433b-50 /\ |raz| <= U /\ |xaz| <= 1
/\ |Xaz| <= UP1 /\ |hbx| <= 33554433b-25 /\ |kbx| <= 33554433b-50 /\ |rbx| <= U /\ |xbx| <= 1
/\ |Xbx| <= UP1 /\ |hby| <= 33554433b-25 /\ |kby| <= 33554433b-50 /\ |rby| <= U /\ |xby| <= 1
/\ |Xby| <= UP1 /\ |hbz| <= 33554433b-25 /\ |kbz| <= 33554433b-50 /\ |rbz| <= U /\ |xbz| <= 1
/\ |Xbz| <= UP1 /\ |hcx| <= 33554433b-25 /\ |kcx| <= 33554433b-50 /\ |rcx| <= U /\ |xcx| <= 1
/\ |Xcx| <= UP1 /\ |hcy| <= 33554433b-25 /\ |kcy| <= 33554433b-50 /\ |rcy| <= U /\ |xcy| <= 1
/\ |Xcy| <= UP1 /\ |hcz| <= 33554433b-25 /\ |kcz| <= 33554433b-50 /\ |rcz| <= U /\ |xcz| <= 1
/\ |Xcz| <= UP1 /\ |gx| <= 33554433b-50 /\ |nx| <= 67108867b-25 /\ |gy| <= 33554433b-50
/\ |ny| <= 67108867b-25 /\ |gz| <= 33554433b-50 /\ |nz| <= 67108867b-25 /\ |w1| <= LOST2
/\ |w2| <= LOST2 /\ |w3| <= LOST2 /\ |w4| <= LOST2 /\ |w5| <= LOST2 /\ |w6| <= LOST2
/\ |w7| <= LOST2 /\ |w8| <= LOST2 /\ |w9| <= LOST2 /\ |w10| <= LOST2 /\ |w11| <= LOST2
/\ |w12| <= LOST2 /\ |w13| <= LOST2 /\ |w14| <= LOST2 /\ |w15| <= LOST2 /\ |w16| <= LOST2
/\ |w17| <= LOST2 /\ |w18| <= LOST2
-> |low - Low| - (REFINED - 24)*1b-25*U <= 0
/\ |low| <= 22b-25 }
