# SPDX-License-Identifier: LGPL-3.0-or-later
# separator_ray: the program as it is, on numbers of [0, 1]: at most kRel 3 from the exact value. What that says: README.md.
# Made by tools/generate_predicates.py from docs/bounds/gappa/separator_ray.formula: do not edit.
@rnd = float<ieee_64, ne>;
d_x = rnd(d_x_);
d_y = rnd(d_y_);
d_z = rnd(d_z_);
v_x = rnd(v_x_);
v_y = rnd(v_y_);
v_z = rnd(v_z_);
q_x = rnd(q_x_);
q_y = rnd(q_y_);
q_z = rnd(q_z_);
rx rnd= q_x - v_x;
t2 rnd= d_x * rx;
ry rnd= q_y - v_y;
t5 rnd= d_y * ry;
t6 rnd= t2 + t5;
rz rnd= q_z - v_z;
t9 rnd= d_z * rz;
det rnd= t6 + t9;
rx_exact = q_x - v_x;
t2_exact = d_x * rx_exact;
ry_exact = q_y - v_y;
t5_exact = d_y * ry_exact;
t6_exact = t2_exact + t5_exact;
rz_exact = q_z - v_z;
t9_exact = d_z * rz_exact;
det_exact = t6_exact + t9_exact;
{ d_x in [0, 1] /\
  d_y in [0, 1] /\
  d_z in [0, 1] /\
  v_x in [0, 1] /\
  v_y in [0, 1] /\
  v_z in [0, 1] /\
  q_x in [0, 1] /\
  q_y in [0, 1] /\
  q_z in [0, 1]
-> |det - det_exact| <= 0x1.2000000000005p-50 }
