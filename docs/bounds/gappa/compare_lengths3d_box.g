# SPDX-License-Identifier: LGPL-3.0-or-later
# compare_lengths3d: the program as it is, on numbers of [0, 1]: at most kRel 6 from the exact value. What that says: README.md.
# Made by tools/generate_predicates.py from predicates/generated/compare_lengths3d.formula: do not edit.
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
ux rnd= b_x - a_x;
t1 rnd= ux * ux;
uy rnd= b_y - a_y;
t3 rnd= uy * uy;
t4 rnd= t1 + t3;
uz rnd= b_z - a_z;
t6 rnd= uz * uz;
t7 rnd= t4 + t6;
vx rnd= d_x - c_x;
t9 rnd= vx * vx;
vy rnd= d_y - c_y;
t11 rnd= vy * vy;
t12 rnd= t9 + t11;
vz rnd= d_z - c_z;
t14 rnd= vz * vz;
t15 rnd= t12 + t14;
det rnd= t7 - t15;
ux_exact = b_x - a_x;
t1_exact = ux_exact * ux_exact;
uy_exact = b_y - a_y;
t3_exact = uy_exact * uy_exact;
t4_exact = t1_exact + t3_exact;
uz_exact = b_z - a_z;
t6_exact = uz_exact * uz_exact;
t7_exact = t4_exact + t6_exact;
vx_exact = d_x - c_x;
t9_exact = vx_exact * vx_exact;
vy_exact = d_y - c_y;
t11_exact = vy_exact * vy_exact;
t12_exact = t9_exact + t11_exact;
vz_exact = d_z - c_z;
t14_exact = vz_exact * vz_exact;
t15_exact = t12_exact + t14_exact;
det_exact = t7_exact - t15_exact;
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
-> |det - det_exact| <= 0x1.e00000000000ap-49 }
