%
(Faces the work between the jaws. The tilt comes too near to the back jaw, and the way)
(home is too low: it leads through the bolt of a toe clamp.)
G21 G90 G94
M3 S12000
N10 G0 X-55 Y-15 Z70
N20 G0 Z56
N30 G1 X55 F900
N40 G1 Y0
N50 G1 X-55
N60 G1 Y15
N70 G1 X55
N80 G1 A-25.5 Y38.2 ; tilted, along the back jaw
N90 G1 X-40
N100 G1 A0 Y0
N110 G0 Z40
N120 G0 X100
N130 G0 Z120
M5
M30
%
