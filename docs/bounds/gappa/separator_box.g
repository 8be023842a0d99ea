# SPDX-License-Identifier: LGPL-3.0-or-later
# separator: the program as it is, on numbers of [0, 1]: at most kRel 3 from the exact value. What that says: README.md.
# Made by tools/generate_predicates.py from docs/bounds/gappa/separator.formula: do not edit.
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
t2 rnd= d_x * q_x;
t5 rnd= d_y * q_y;
t6 rnd= t2 + t5;
t9 rnd= d_z * q_z;
t10 rnd= t6 + t9;
t12 rnd= d_x * p_x;
t14 rnd= d_y * p_y;
t15 rnd= t12 + t14;
t17 rnd= d_z * p_z;
t18 rnd= t15 + t17;
det rnd= t10 - t18;
t2_exact = d_x * q_x;
t5_exact = d_y * q_y;
t6_exact = t2_exact + t5_exact;
t9_exact = d_z * q_z;
t10_exact = t6_exact + t9_exact;
t12_exact = d_x * p_x;
t14_exact = d_y * p_y;
t15_exact = t12_exact + t14_exact;
t17_exact = d_z * p_z;
t18_exact = t15_exact + t17_exact;
det_exact = t10_exact - t18_exact;
{ d_x in [0, 1] /\
  d_y in [0, 1] /\
  d_z in [0, 1] /\
  p_x in [0, 1] /\
  p_y in [0, 1] /\
  p_z in [0, 1] /\
  q_x in [0, 1] /\
  q_y in [0, 1] /\
  q_z in [0, 1]
-> |det - det_exact| <= 0x1.2000000000003p-49 }
