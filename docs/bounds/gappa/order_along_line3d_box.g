# SPDX-License-Identifier: LGPL-3.0-or-later
# order_along_line3d: the program as it is, on numbers of [0, 1]: at most kRel 3 from the exact value. What that says: README.md.
# Made by tools/generate_predicates.py from predicates/generated/order_along_line3d.formula: do not edit.
@rnd = float<ieee_64, ne>;
a_x = rnd(a_x_);
a_y = rnd(a_y_);
a_z = rnd(a_z_);
b_x = rnd(b_x_);
b_y = rnd(b_y_);
b_z = rnd(b_z_);
p_x = rnd(p_x_);
p_y = rnd(p_y_);
p_z = rnd(p_z_);
q_x = rnd(q_x_);
q_y = rnd(q_y_);
q_z = rnd(q_z_);
ux rnd= b_x - a_x;
vx rnd= p_x - q_x;
t2 rnd= ux * vx;
uy rnd= b_y - a_y;
vy rnd= p_y - q_y;
t5 rnd= uy * vy;
t6 rnd= t2 + t5;
uz rnd= b_z - a_z;
vz rnd= p_z - q_z;
t9 rnd= uz * vz;
det rnd= t6 + t9;
ux_exact = b_x - a_x;
vx_exact = p_x - q_x;
t2_exact = ux_exact * vx_exact;
uy_exact = b_y - a_y;
vy_exact = p_y - q_y;
t5_exact = uy_exact * vy_exact;
t6_exact = t2_exact + t5_exact;
uz_exact = b_z - a_z;
vz_exact = p_z - q_z;
t9_exact = uz_exact * vz_exact;
det_exact = t6_exact + t9_exact;
{ a_x in [0, 1] /\
  a_y in [0, 1] /\
  a_z in [0, 1] /\
  b_x in [0, 1] /\
  b_y in [0, 1] /\
  b_z in [0, 1] /\
  p_x in [0, 1] /\
  p_y in [0, 1] /\
  p_z in [0, 1] /\
  q_x in [0, 1] /\
  q_y in [0, 1] /\
  q_z in [0, 1]
-> |det - det_exact| <= 0x1.8000000000007p-50 }
