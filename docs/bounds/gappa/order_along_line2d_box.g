# SPDX-License-Identifier: LGPL-3.0-or-later
# order_along_line2d: the program as it is, on numbers of [0, 1]: at most kRel 2 from the exact value. What that says: README.md.
# Made by tools/generate_predicates.py from predicates/generated/order_along_line2d.formula: do not edit.
@rnd = float<ieee_64, ne>;
a_x = rnd(a_x_);
a_y = rnd(a_y_);
b_x = rnd(b_x_);
b_y = rnd(b_y_);
p_x = rnd(p_x_);
p_y = rnd(p_y_);
q_x = rnd(q_x_);
q_y = rnd(q_y_);
ux rnd= b_x - a_x;
vx rnd= p_x - q_x;
t2 rnd= ux * vx;
uy rnd= b_y - a_y;
vy rnd= p_y - q_y;
t5 rnd= uy * vy;
det rnd= t2 + t5;
ux_exact = b_x - a_x;
vx_exact = p_x - q_x;
t2_exact = ux_exact * vx_exact;
uy_exact = b_y - a_y;
vy_exact = p_y - q_y;
t5_exact = uy_exact * vy_exact;
det_exact = t2_exact + t5_exact;
{ a_x in [0, 1] /\
  a_y in [0, 1] /\
  b_x in [0, 1] /\
  b_y in [0, 1] /\
  p_x in [0, 1] /\
  p_y in [0, 1] /\
  q_x in [0, 1] /\
  q_y in [0, 1]
-> |det - det_exact| <= 0x1.8000000000007p-51 }
