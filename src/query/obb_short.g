# How far the vectors of oriented boxes, segments and rays, cut down to words, may be from the truth
# together.
# constant: ERROR
# only: f64
#
# Proved: the errors of the way between the centres and of all half-vectors add up to at most ERROR
# on a coordinate axis, for two boxes, for a segment and a box, and for a ray and a box, also if they were
# floats. There is no float in this: int<dn> rounds down, int<ne> to the nearest, whose ties matter not.
#
# Names: h and u are the factors of a half-vector g, cut to 30 bits; t and e those of the end of a
# ray. 41 bits or more of a product are cut, and of a vector x that does not fit its word. Here it is
# 41, for which the error is greatest. The truth is in capitals.

g = int<ne>(h*u*1b-41);  G = H*U*1b-41;
x = int<ne>(y*1b-41);  X = Y*1b-41;
p = int<ne>(t*e*1b-41);  P = T*E*1b-41;
z = int<ne>(v*1b-41);  Z = V*1b-41;
q = int<ne>(s*f*1b-41);  Q = S*F*1b-41;

# A segment between x and z.
middle = int<dn>((x + z)*0.5);  Middle = (X + Z)*0.5;
half = int<dn>((z - x)*0.5);  Half = (Z - X)*0.5;

# A ray from x + p to x + q.
between = int<dn>((p + q)*0.5);  Between = (P + Q)*0.5;
part = int<dn>((q - p)*0.5);  Part = (Q - P)*0.5;
way = x + between;  Way = X + Between;

# Floats cut to words of 29 bits: k of a half-vector, l of a difference of two lengths, and i and j of the ends of a ray
# from there.
k = int<ne>(m);
l = int<ne>(n);
a = int<ne>(b);
centre = int<dn>((l + a)*0.5);  Centre = (N + B)*0.5;
span = int<dn>((a - l)*0.5);  Span = (B - N)*0.5;

i = int<ne>(c);
j = int<ne>(w);
middle_of_ray = l + int<dn>((i + j)*0.5);  Middle_of_ray = N + (C + W)*0.5;
half_of_ray = int<dn>((j - i)*0.5);  Half_of_ray = (W - C)*0.5;

{ |H| <= 1b31 /\ |U| <= 1b31 /\ |T| <= 1b31 /\ |E| <= 1b31 /\ |S| <= 1b31 /\ |F| <= 1b31
/\ |h| <= 1b30 /\ |h - H| <= 0.5 /\ |u| <= 1b30 /\ |u - U| <= 0.5
/\ |t| <= 1b30 /\ |t - T| <= 0.5 /\ |e| <= 1b30 /\ |e - E| <= 0.5
/\ |s| <= 1b30 /\ |s - S| <= 0.5 /\ |f| <= 1b30 /\ |f - F| <= 0.5
/\ |m| <= 1b19 /\ |m - M| <= 2177b-20 /\ |n| <= 1b19 /\ |n - N| <= 1b-12
/\ |b| <= 1b19 /\ |b - B| <= 1b-12
/\ |c| <= 1b19 /\ |c - C| <= 1b-8 /\ |w| <= 1b19 /\ |w - W| <= 1b-8
/\ |y| <= 1b63 /\ |y - Y| <= 1 /\ |v| <= 1b63 /\ |v - V| <= 1
-> |l - N| + 6*|k - M| - ERROR <= 0
/\ |centre - Centre| + |span - Span| + 3*|k - M| - ERROR <= 0
/\ |middle_of_ray - Middle_of_ray| + |half_of_ray - Half_of_ray| + 3*|k - M| - ERROR <= 0
/\ |x - X| + 6*|g - G| - ERROR <= 0
/\ |middle - Middle| + |half - Half| + 3*|g - G| - ERROR <= 0
/\ |way - Way| + |part - Part| + 3*|g - G| - ERROR <= 0 }
