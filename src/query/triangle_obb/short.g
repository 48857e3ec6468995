# How far a triangle and an oriented box, cut down to words, may be from the truth together.
# constant: ERROR
# constant: OF_AXES
# constant: OF_LENGTHS
# constant: OF_FLOATS
# only: f64
#
# Proved: |computed − true| of a vertex and of an extent are together at most what `short.rs` adds
# up, whether axes and lengths are cut or not. There is no float in this: int<dn> rounds down.
#
# Names: a, b and c are the axes, w is b × c, d a length, h a half-extent, v the volume, y the vertex
# and x the extent. The truth is in capitals. The last letter says what is cut: n nothing, a axes,
# l lengths, o both, f both of floats. Rows of other axes differ by names. |v| is |V| + s·(v − V) for some |s| ≤ 1,
# and o is zero, as in other scripts.
#
# That the true volume is at most 2^21 is Hadamard's bound: 4 where all numbers are up to 1.

# Nothing is cut.
wxn = int<dn>((byn*czn - bzn*cyn)*1b-19);
Wxn = (byn*czn - bzn*cyn)*1b-19;
wyn = int<dn>((bzn*cxn - bxn*czn)*1b-19);
Wyn = (bzn*cxn - bxn*czn)*1b-19;
wzn = int<dn>((bxn*cyn - byn*cxn)*1b-19);
Wzn = (bxn*cyn - byn*cxn)*1b-19;
yn = int<dn>((wxn*dxn + wyn*dyn + wzn*dzn)*1b-10);  Yn = (Wxn*dxn + Wyn*dyn + Wzn*dzn)*1b-10;
vn = int<dn>((wxn*axn + wyn*ayn + wzn*azn)*1b-19);  Vn = (Wxn*axn + Wyn*ayn + Wzn*azn)*1b-19;
pn = |Vn| + sn*(vn - Vn);  Pn = |Vn| + o;
xn = int<dn>(hn*pn*1b-10);  Xn = hn*Pn*1b-10;

# Axes are cut.
wxa = int<dn>((bya*cza - bza*cya)*1b-19);
Wxa = (BYa*CZa - BZa*CYa)*1b-19;
wya = int<dn>((bza*cxa - bxa*cza)*1b-19);
Wya = (BZa*CXa - BXa*CZa)*1b-19;
wza = int<dn>((bxa*cya - bya*cxa)*1b-19);
Wza = (BXa*CYa - BYa*CXa)*1b-19;
ya = int<dn>((wxa*dxa + wya*dya + wza*dza)*1b-10);  Ya = (Wxa*dxa + Wya*dya + Wza*dza)*1b-10;
va = int<dn>((wxa*axa + wya*aya + wza*aza)*1b-19);  Va = (Wxa*AXa + Wya*AYa + Wza*AZa)*1b-19;
pa = |Va| + sa*(va - Va);  Pa = |Va| + o;
xa = int<dn>(ha*pa*1b-10);  Xa = ha*Pa*1b-10;

# Lengths are cut.
wxl = int<dn>((byl*czl - bzl*cyl)*1b-19);
Wxl = (byl*czl - bzl*cyl)*1b-19;
wyl = int<dn>((bzl*cxl - bxl*czl)*1b-19);
Wyl = (bzl*cxl - bxl*czl)*1b-19;
wzl = int<dn>((bxl*cyl - byl*cxl)*1b-19);
Wzl = (bxl*cyl - byl*cxl)*1b-19;
yl = int<dn>((wxl*dxl + wyl*dyl + wzl*dzl)*1b-10);  Yl = (Wxl*DXl + Wyl*DYl + Wzl*DZl)*1b-10;
vl = int<dn>((wxl*axl + wyl*ayl + wzl*azl)*1b-19);  Vl = (Wxl*axl + Wyl*ayl + Wzl*azl)*1b-19;
pl = |Vl| + sl*(vl - Vl);  Pl = |Vl| + o;
xl = int<dn>(hl*pl*1b-10);  Xl = Hl*Pl*1b-10;

# Both are cut.
wxo = int<dn>((byo*czo - bzo*cyo)*1b-19);
Wxo = (BYo*CZo - BZo*CYo)*1b-19;
wyo = int<dn>((bzo*cxo - bxo*czo)*1b-19);
Wyo = (BZo*CXo - BXo*CZo)*1b-19;
wzo = int<dn>((bxo*cyo - byo*cxo)*1b-19);
Wzo = (BXo*CYo - BYo*CXo)*1b-19;
yo = int<dn>((wxo*dxo + wyo*dyo + wzo*dzo)*1b-10);  Yo = (Wxo*DXo + Wyo*DYo + Wzo*DZo)*1b-10;
vo = int<dn>((wxo*axo + wyo*ayo + wzo*azo)*1b-19);  Vo = (Wxo*AXo + Wyo*AYo + Wzo*AZo)*1b-19;
po = |Vo| + so*(vo - Vo);  Po = |Vo| + o;
xo = int<dn>(ho*po*1b-10);  Xo = Ho*Po*1b-10;

# Floats: both are cut, of numbers that were cut to words before.
wxf = int<dn>((byf*czf - bzf*cyf)*1b-19);
Wxf = (BYf*CZf - BZf*CYf)*1b-19;
wyf = int<dn>((bzf*cxf - bxf*czf)*1b-19);
Wyf = (BZf*CXf - BXf*CZf)*1b-19;
wzf = int<dn>((bxf*cyf - byf*cxf)*1b-19);
Wzf = (BXf*CYf - BYf*CXf)*1b-19;
yf = int<dn>((wxf*dxf + wyf*dyf + wzf*dzf)*1b-10);  Yf = (Wxf*DXf + Wyf*DYf + Wzf*DZf)*1b-10;
vf = int<dn>((wxf*axf + wyf*ayf + wzf*azf)*1b-19);  Vf = (Wxf*AXf + Wyf*AYf + Wzf*AZf)*1b-19;
pf = |Vf| + sf*(vf - Vf);  Pf = |Vf| + o;
xf = int<dn>(hf*pf*1b-10);  Xf = Hf*Pf*1b-10;

{ o in [0,0] /\ |axn| <= 524288 /\ |ayn| <= 524288 /\ |azn| <= 524288 /\ |bxn| <= 524288
/\ |byn| <= 524288 /\ |bzn| <= 524288 /\ |cxn| <= 524288 /\ |cyn| <= 524288 /\ |czn| <= 524288
/\ |dxn| <= 262144 /\ |dyn| <= 262144 /\ |dzn| <= 262144 /\ hn in [0,262144] /\ |sn| <= 1
/\ |Vn| <= 2097152 /\ |axa| <= 524288 /\ |AXa| <= 524288 /\ |axa - AXa| <= 0.5 /\ |aya| <= 524288
/\ |AYa| <= 524288 /\ |aya - AYa| <= 0.5 /\ |aza| <= 524288 /\ |AZa| <= 524288
/\ |aza - AZa| <= 0.5 /\ |bxa| <= 524288 /\ |BXa| <= 524288 /\ |bxa - BXa| <= 0.5
/\ |bya| <= 524288 /\ |BYa| <= 524288 /\ |bya - BYa| <= 0.5 /\ |bza| <= 524288 /\ |BZa| <= 524288
/\ |bza - BZa| <= 0.5 /\ |cxa| <= 524288 /\ |CXa| <= 524288 /\ |cxa - CXa| <= 0.5
/\ |cya| <= 524288 /\ |CYa| <= 524288 /\ |cya - CYa| <= 0.5 /\ |cza| <= 524288 /\ |CZa| <= 524288
/\ |cza - CZa| <= 0.5 /\ |dxa| <= 262144 /\ |dya| <= 262144 /\ |dza| <= 262144 /\ ha in [0,262144]
/\ |sa| <= 1 /\ |Va| <= 2097152 /\ |axl| <= 524288 /\ |ayl| <= 524288 /\ |azl| <= 524288
/\ |bxl| <= 524288 /\ |byl| <= 524288 /\ |bzl| <= 524288 /\ |cxl| <= 524288 /\ |cyl| <= 524288
/\ |czl| <= 524288 /\ |dxl| <= 262144 /\ |dxl - DXl| <= 2049b-12 /\ |dyl| <= 262144
/\ |dyl - DYl| <= 2049b-12 /\ |dzl| <= 262144 /\ |dzl - DZl| <= 2049b-12 /\ hl in [0,262144]
/\ |hl - Hl| <= 0.5 /\ |sl| <= 1 /\ |Vl| <= 2097152 /\ |axo| <= 524288 /\ |AXo| <= 524288
/\ |axo - AXo| <= 0.5 /\ |ayo| <= 524288 /\ |AYo| <= 524288 /\ |ayo - AYo| <= 0.5
/\ |azo| <= 524288 /\ |AZo| <= 524288 /\ |azo - AZo| <= 0.5 /\ |bxo| <= 524288 /\ |BXo| <= 524288
/\ |bxo - BXo| <= 0.5 /\ |byo| <= 524288 /\ |BYo| <= 524288 /\ |byo - BYo| <= 0.5
/\ |bzo| <= 524288 /\ |BZo| <= 524288 /\ |bzo - BZo| <= 0.5 /\ |cxo| <= 524288 /\ |CXo| <= 524288
/\ |cxo - CXo| <= 0.5 /\ |cyo| <= 524288 /\ |CYo| <= 524288 /\ |cyo - CYo| <= 0.5
/\ |czo| <= 524288 /\ |CZo| <= 524288 /\ |czo - CZo| <= 0.5 /\ |dxo| <= 262144
/\ |dxo - DXo| <= 2049b-12 /\ |dyo| <= 262144 /\ |dyo - DYo| <= 2049b-12 /\ |dzo| <= 262144
/\ |dzo - DZo| <= 2049b-12 /\ ho in [0,262144] /\ |ho - Ho| <= 0.5 /\ |so| <= 1 /\ |Vo| <= 2097152
/\ |axf| <= 524288 /\ |AXf| <= 524288
/\ |axf - AXf| <= 257b-9 /\ |ayf| <= 524288 /\ |AYf| <= 524288 /\ |ayf - AYf| <= 257b-9
/\ |azf| <= 524288 /\ |AZf| <= 524288 /\ |azf - AZf| <= 257b-9 /\ |bxf| <= 524288 /\ |BXf| <= 524288
/\ |bxf - BXf| <= 257b-9 /\ |byf| <= 524288 /\ |BYf| <= 524288 /\ |byf - BYf| <= 257b-9
/\ |bzf| <= 524288 /\ |BZf| <= 524288 /\ |bzf - BZf| <= 257b-9 /\ |cxf| <= 524288 /\ |CXf| <= 524288
/\ |cxf - CXf| <= 257b-9 /\ |cyf| <= 524288 /\ |CYf| <= 524288 /\ |cyf - CYf| <= 257b-9
/\ |czf| <= 524288 /\ |CZf| <= 524288 /\ |czf - CZf| <= 257b-9 /\ |dxf| <= 262144
/\ |dxf - DXf| <= 2049b-12 /\ |dyf| <= 262144 /\ |dyf - DYf| <= 2049b-12 /\ |dzf| <= 262144
/\ |dzf - DZf| <= 2049b-12 /\ hf in [0,262144] /\ |hf - Hf| <= 2049b-12 /\ |sf| <= 1 /\ |Vf| <= 2097152
-> |yn - Yn| + |xn - Xn| - (ERROR) <= 0
/\ |ya - Ya| + |xa - Xa| - (ERROR+OF_AXES) <= 0
/\ |yl - Yl| + |xl - Xl| - (ERROR+OF_LENGTHS) <= 0
/\ |yo - Yo| + |xo - Xo| - (ERROR+OF_AXES+OF_LENGTHS) <= 0
/\ |yf - Yf| + |xf - Xf| - (ERROR+OF_AXES+OF_LENGTHS+OF_FLOATS) <= 0 }
