# SPDX-License-Identifier: LGPL-3.0-or-later
# compare_along: the program as it is, on numbers of [0, 1]: at most kRel 3 from the exact value. What that says: README.md.
# Made by tools/generate_predicates.py from docs/bounds/gappa/compare_along.formula: do not edit.
@rnd = float<ieee_64, ne>;
d_x = rnd(d_x_);
d_y = rnd(d_y_);
d_z = rnd(d_z_);
p_x = rnd(p_x_);
p_y = rnd(p_y_);
p_z = rnd(p_z_);
q_x = rnd(q_x_);
q_y = rnd(q_y_);
q_z = rnd(q_z_);
rx rnd= p_x - q_x;
t2 rnd= d_x * rx;
ry rnd= p_y - q_y;
t5 rnd= d_y * ry;
t6 rnd= t2 + t5;
rz rnd= p_z - q_z;
t9 rnd= d_z * rz;
det rnd= t6 + t9;
rx_exact = p_x - q_x;
t2_exact = d_x * rx_exact;
ry_exact = p_y - q_y;
t5_exact = d_y * ry_exact;
t6_exact = t2_exact + t5_exact;
rz_exact = p_z - q_z;
t9_exact = d_z * rz_exact;
det_exact = t6_exact + t9_exact;
{ d_x in [0, 1] /\
  d_y in [0, 1] /\
  d_z in [0, 1] /\
  p_x in [0, 1] /\
  p_y in [0, 1] /\
  p_z in [0, 1] /\
  q_x in [0, 1] /\
  q_y in [0, 1] /\
  q_z in [0, 1]
-> |det - det_exact| <= 0x1.2000000000005p-50 }
