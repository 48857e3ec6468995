# How far a sum of cut numbers may be from the whole sum, scaled alike.
# constant: DOUBT
# only: f64
#
# Proved: |computed − true| of one product of a factor and a determinant, four times, is at most
# what `cut.rs` states. There is no float in this: int<dn> rounds down.
#
# Names: a, b and c are the vectors, w is a × b, d the determinant, f the factor, p the product. The
# truth is in capitals.

wx = int<dn>((ay*bz - az*by)*1b-19);  Wx = (AY*BZ - AZ*BY)*1b-19;
wy = int<dn>((az*bx - ax*bz)*1b-19);  Wy = (AZ*BX - AX*BZ)*1b-19;
wz = int<dn>((ax*by - ay*bx)*1b-19);  Wz = (AX*BY - AY*BX)*1b-19;
n = int<dn>((wx*cx + wy*cy + wz*cz)*1b-10);  N = (Wx*CX + Wy*CY + Wz*CZ)*1b-10;
d = int<dn>(n*1b-8);  D = N*1b-8;
p = int<dn>(d*f*1b-10);  P = D*F*1b-10;

{ |ax| <= 262144 /\ |AX| <= 262145 /\ |ax - AX| <= 0.502 /\ |ay| <= 262144 /\ |AY| <= 262145
/\ |ay - AY| <= 0.502 /\ |az| <= 262144 /\ |AZ| <= 262145 /\ |az - AZ| <= 0.502
/\ |bx| <= 262144 /\ |BX| <= 262145 /\ |bx - BX| <= 0.502 /\ |by| <= 262144 /\ |BY| <= 262145
/\ |by - BY| <= 0.502 /\ |bz| <= 262144 /\ |BZ| <= 262145 /\ |bz - BZ| <= 0.502
/\ |cx| <= 262144 /\ |CX| <= 262145 /\ |cx - CX| <= 0.502 /\ |cy| <= 262144 /\ |CY| <= 262145
/\ |cy - CY| <= 0.502 /\ |cz| <= 262144 /\ |CZ| <= 262145 /\ |cz - CZ| <= 0.502
/\ |f| <= 262144 /\ |F| <= 262145 /\ |f - F| <= 0.502
-> 4*|p - P| - (DOUBT) <= 0 }
