# SPDX-License-Identifier: LGPL-3.0-or-later
# orient3d: the program as it is, on numbers of [0, 1]: at most kRel 6 from the exact value. What that says: README.md.
# Made by tools/generate_predicates.py from docs/bounds/gappa/orient3d.formula: do not edit.
@rnd = float<ieee_64, ne>;
a_x = rnd(a_x_);
a_y = rnd(a_y_);
a_z = rnd(a_z_);
b_x = rnd(b_x_);
b_y = rnd(b_y_);
b_z = rnd(b_z_);
c_x = rnd(c_x_);
c_y = rnd(c_y_);
c_z = rnd(c_z_);
d_x = rnd(d_x_);
d_y = rnd(d_y_);
d_z = rnd(d_z_);
wx rnd= d_x - a_x;
uy rnd= b_y - a_y;
vz rnd= c_z - a_z;
t3 rnd= uy * vz;
uz rnd= b_z - a_z;
vy rnd= c_y - a_y;
t6 rnd= uz * vy;
t7 rnd= t3 - t6;
t8 rnd= wx * t7;
wy rnd= d_y - a_y;
vx rnd= c_x - a_x;
t11 rnd= uz * vx;
ux rnd= b_x - a_x;
t13 rnd= ux * vz;
t14 rnd= t11 - t13;
t15 rnd= wy * t14;
t16 rnd= t8 + t15;
wz rnd= d_z - a_z;
t18 rnd= ux * vy;
t19 rnd= uy * vx;
t20 rnd= t18 - t19;
t21 rnd= wz * t20;
det rnd= t16 + t21;
wx_exact = d_x - a_x;
uy_exact = b_y - a_y;
vz_exact = c_z - a_z;
t3_exact = uy_exact * vz_exact;
uz_exact = b_z - a_z;
vy_exact = c_y - a_y;
t6_exact = uz_exact * vy_exact;
t7_exact = t3_exact - t6_exact;
t8_exact = wx_exact * t7_exact;
wy_exact = d_y - a_y;
vx_exact = c_x - a_x;
t11_exact = uz_exact * vx_exact;
ux_exact = b_x - a_x;
t13_exact = ux_exact * vz_exact;
t14_exact = t11_exact - t13_exact;
t15_exact = wy_exact * t14_exact;
t16_exact = t8_exact + t15_exact;
wz_exact = d_z - a_z;
t18_exact = ux_exact * vy_exact;
t19_exact = uy_exact * vx_exact;
t20_exact = t18_exact - t19_exact;
t21_exact = wz_exact * t20_exact;
det_exact = t16_exact + t21_exact;
{ a_x in [0, 1] /\
  a_y in [0, 1] /\
  a_z in [0, 1] /\
  b_x in [0, 1] /\
  b_y in [0, 1] /\
  b_z in [0, 1] /\
  c_x in [0, 1] /\
  c_y in [0, 1] /\
  c_z in [0, 1] /\
  d_x in [0, 1] /\
  d_y in [0, 1] /\
  d_z in [0, 1]
-> |det - det_exact| <= 0x1.5000000000009p-48 }
