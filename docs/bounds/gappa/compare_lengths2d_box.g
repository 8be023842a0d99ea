# SPDX-License-Identifier: LGPL-3.0-or-later
# compare_lengths2d: the program as it is, on numbers of [0, 1]: at most kRel 4 from the exact value. What that says: README.md.
# Made by tools/generate_predicates.py from predicates/generated/compare_lengths2d.formula: do not edit.
@rnd = float<ieee_64, ne>;
a_x = rnd(a_x_);
a_y = rnd(a_y_);
b_x = rnd(b_x_);
b_y = rnd(b_y_);
c_x = rnd(c_x_);
c_y = rnd(c_y_);
d_x = rnd(d_x_);
d_y = rnd(d_y_);
ux rnd= b_x - a_x;
t1 rnd= ux * ux;
uy rnd= b_y - a_y;
t3 rnd= uy * uy;
t4 rnd= t1 + t3;
vx rnd= d_x - c_x;
t6 rnd= vx * vx;
vy rnd= d_y - c_y;
t8 rnd= vy * vy;
t9 rnd= t6 + t8;
det rnd= t4 - t9;
ux_exact = b_x - a_x;
t1_exact = ux_exact * ux_exact;
uy_exact = b_y - a_y;
t3_exact = uy_exact * uy_exact;
t4_exact = t1_exact + t3_exact;
vx_exact = d_x - c_x;
t6_exact = vx_exact * vx_exact;
vy_exact = d_y - c_y;
t8_exact = vy_exact * vy_exact;
t9_exact = t6_exact + t8_exact;
det_exact = t4_exact - t9_exact;
{ a_x in [0, 1] /\
  a_y in [0, 1] /\
  b_x in [0, 1] /\
  b_y in [0, 1] /\
  c_x in [0, 1] /\
  c_y in [0, 1] /\
  d_x in [0, 1] /\
  d_y in [0, 1]
-> |det - det_exact| <= 0x1.0000000000005p-49 }
