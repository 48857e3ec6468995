# How far what is left over, and the volumes made of it, may be from the truth.
# constant: LEFT
# constant: LEFT_T
# constant: LOST
# only: f64
#
# Proved: what the lower parts of what is left over err, six times, as many terms there are in a
# volume, is at most LOST; what volumes of r err, with the rounding of r itself, is at most LEFT
# and LEFT_T. Underflow included.
#
# The lower parts, divided by 2^-25·R. b, c and s are what was cut off, br, cr and sr what a
# rounding took: none has an error. t·d is divided as a whole. u and v are at most 1, but for 2^-18.

bl = fl(b, br); Bl = b + br;
cl = fl(c, cr); Cl = c + cr;
sl = fl(s, sr); Sl = s + sr;
first = fl(sl, fl(td, u1)); First = Sl + (td + o);
second = fl(first, -fl(bl*u, u2)); Second = First + -(Bl*u + o);
low = fl(second, -fl(cl*v, u3)); Low = Second + -(Cl*v + o);

# Divided by D, E and the greatest of r, which is exact here. The edges are e and g.
ex = fl(exp, -exa); Ex = exp + -exa;
ey = fl(eyp, -eya); Ey = eyp + -eya;
ez = fl(ezp, -eza); Ez = ezp + -eza;
gx = fl(gxp, -gxa); Gx = gxp + -gxa;
gy = fl(gyp, -gya); Gy = gyp + -gya;
gz = fl(gzp, -gza); Gz = gzp + -gza;
px = fl(fl(dy*gz, w1), -fl(dz*gy, w2));
Px = (dy*Gz + o) + -(dz*Gy + o);
py = fl(fl(dz*gx, w3), -fl(dx*gz, w4));
Py = (dz*Gx + o) + -(dx*Gz + o);
pz = fl(fl(dx*gy, w5), -fl(dy*gx, w6));
Pz = (dx*Gy + o) + -(dy*Gx + o);
qx = fl(fl(ry*ez, w7), -fl(rz*ey, w8));
Qx = (ry*Ez + o) + -(rz*Ey + o);
qy = fl(fl(rz*ex, w9), -fl(rx*ez, w10));
Qy = (rz*Ex + o) + -(rx*Ez + o);
qz = fl(fl(rx*ey, w11), -fl(ry*ex, w12));
Qz = (rx*Ey + o) + -(ry*Ex + o);
side_u = fl(fl(fl(px*rx, w16), fl(py*ry, w17)), fl(pz*rz, w18));
Side_u = ((Px*rx + o) + (Py*ry + o)) + (Pz*rz + o);
side_v = fl(fl(fl(qx*dx, w19), fl(qy*dy, w20)), fl(qz*dz, w21));
Side_v = ((Qx*dx + o) + (Qy*dy + o)) + (Qz*dz + o);
t = fl(fl(fl(qx*gx, w22), fl(qy*gy, w23)), fl(qz*gz, w24));
True_t = ((Qx*Gx + o) + (Qy*Gy + o)) + (Qz*Gz + o);

{ o in [0,0]
/\ |b| <= 0.5 /\ |br| <= 1b-27 /\ |c| <= 0.5 /\ |cr| <= 1b-27 /\ |s| <= 0.5 /\ |sr| <= 1b-5
/\ |td| <= 1.05
/\ u in [0, 262145b-18] /\ v in [0, 262145b-18]
/\ |u1| <= LOST1 /\ |u2| <= LOST1 /\ |u3| <= LOST1
/\ |dx| <= 1 /\ |ex| <= 1 /\ |Ex| <= UP1 /\ |gx| <= 1 /\ |Gx| <= UP1 /\ |rx| <= 1
/\ |dy| <= 1 /\ |ey| <= 1 /\ |Ey| <= UP1 /\ |gy| <= 1 /\ |Gy| <= UP1 /\ |ry| <= 1
/\ |dz| <= 1 /\ |ez| <= 1 /\ |Ez| <= UP1 /\ |gz| <= 1 /\ |Gz| <= UP1 /\ |rz| <= 1
/\ |w1| <= LOST2 /\ |w2| <= LOST2 /\ |w3| <= LOST2 /\ |w4| <= LOST2 /\ |w5| <= LOST2
/\ |w6| <= LOST2 /\ |w7| <= LOST2 /\ |w8| <= LOST2 /\ |w9| <= LOST2 /\ |w10| <= LOST2
/\ |w11| <= LOST2 /\ |w12| <= LOST2 /\ |w16| <= LOST3 /\ |w17| <= LOST3 /\ |w18| <= LOST3
/\ |w19| <= LOST3 /\ |w20| <= LOST3 /\ |w21| <= LOST3 /\ |w22| <= LOST3 /\ |w23| <= LOST3
/\ |w24| <= LOST3
-> 6*|low - Low| - (LOST - 1)*U <= 0
/\ |side_u - Side_u| - (LEFT - 7)*U <= 0 /\ |side_v - Side_v| - (LEFT - 7)*U <= 0
/\ |t - True_t| - (LEFT_T - 7)*U <= 0 }
