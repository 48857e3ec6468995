# How far the speed at which a triangle moves along an axis may be from the truth.
# constant: AREA_SPEED
# constant: VOLUME_SPEED
#
# Proved: |computed − true| is at most the bound as it is computed, underflow included.
#
# All is divided by R as in `edge.g`. An area is a component of the product of an edge E and the way
# D, a volume the product of the normal, that of the edges E and F, with D.

X = 1 + 8*U;

Ex = X*ex + o;  dex = fl(X*ex, 0);
Fx = X*fx + o;  dfx = fl(X*fx, 0);
Dx = X*dx + o;  ddx = fl(X*dx, 0);
Ey = X*ey + o;  dey = fl(X*ey, 0);
Fy = X*fy + o;  dfy = fl(X*fy, 0);
Dy = X*dy + o;  ddy = fl(X*dy, 0);
Ez = X*ez + o;  dez = fl(X*ez, 0);
Fz = X*fz + o;  dfz = fl(X*fz, 0);
Dz = X*dz + o;  ddz = fl(X*dz, 0);

area = fl(fl(dey*ddz, z1), -fl(dez*ddy, z2));  Area = (Ey*Dz + o) + -(Ez*Dy + o);
nx = fl(fl(dey*dfz, z3), -fl(dez*dfy, z4));  Nx = (Ey*Fz + o) + -(Ez*Fy + o);
ny = fl(fl(dez*dfx, z5), -fl(dex*dfz, z6));  Ny = (Ez*Fx + o) + -(Ex*Fz + o);
nz = fl(fl(dex*dfy, z7), -fl(dey*dfx, z8));  Nz = (Ex*Fy + o) + -(Ey*Fx + o);
volume = fl(fl(fl(nx*ddx, z9), fl(ny*ddy, z10)), fl(nz*ddz, z11));  Volume = ((Nx*Dx + o) + (Ny*Dy + o)) + (Nz*Dz + o);

area_bound = fl(AREA_SPEED*U*fl(1, z12), z13);
volume_bound = fl(VOLUME_SPEED*U*fl(fl(1, z14), z15), z16);

{ o in [0,0] /\ |ex| <= 1 /\ |fx| <= 1 /\ |dx| <= 1 /\ |ey| <= 1 /\ |fy| <= 1 /\ |dy| <= 1 /\ |ez|
<= 1 /\ |fz| <= 1 /\ |dz| <= 1 /\ |z1| <= LOST2 /\ |z2| <= LOST2 /\ |z3| <= LOST2 /\ |z4| <= LOST2
/\ |z5| <= LOST2 /\ |z6| <= LOST2 /\ |z7| <= LOST2 /\ |z8| <= LOST2 /\ |z9| <= LOST3 /\ |z10| <=
LOST3 /\ |z11| <= LOST3 /\ |z12| <= LOST2 /\ |z13| <= LOST2 /\ |z14| <= LOST2 /\ |z15| <= LOST3 /\
|z16| <= LOST3
-> |area - Area| - area_bound <= 0 /\ |volume - Volume| - volume_bound <= 0 }
