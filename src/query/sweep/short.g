# How far a vertex and the greatest corner of a box, cut to words, may be from the truth together at any time of the
# motion, relative to the least corner of the box.
# constant: ERROR
# only: f64
#
# Proved: |computed − true| of both add up to at most what `short.rs` grows the box by, for a box given by its
# centre and by its corners. There is no float in this.
#
# Names: a is a coordinate of a vertex, p and q are those of the box, f and g those of the motion; m is the time. A
# number of the truth is its name in capitals.
Time = (a - (p - q)) + m * (g - f);   TIME = (A - (P - Q)) + m * (G - F);
Corner = q + q;                       CORNER = Q + Q;

Time2 = (a - p) + m * (g - f);        TIME2 = (A - P) + m * (G - F);
Corner2 = q - p;                      CORNER2 = Q - P;

{ m in [0, 1] /\ |a - A| <= 1 /\ |p - P| <= 1 /\ |q - Q| <= 1 /\ |f - F| <= 1 /\ |g - G| <= 1 ->
  |Time - TIME| + |Corner - CORNER| <= ERROR /\ |Time2 - TIME2| + |Corner2 - CORNER2| <= ERROR }

Time - TIME -> ((a - A) - ((p - P) - (q - Q))) + m * ((g - G) - (f - F));
Time2 - TIME2 -> ((a - A) - (p - P)) + m * ((g - G) - (f - F));
