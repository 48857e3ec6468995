; A hole where the drawing was mirrored: into the back jaw.
G90 G21
G0 X10 Y55 Z80
G1 Z8 F200
M2
