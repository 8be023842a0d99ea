# SPDX-License-Identifier: LGPL-3.0-or-later
# orient2d: the program as it is, on numbers of [0, 1]: at most kRel 2 from the exact value. What that says: README.md.
# Made by tools/generate_predicates.py from docs/bounds/gappa/orient2d.formula: do not edit.
@rnd = float<ieee_64, ne>;
a_x = rnd(a_x_);
a_y = rnd(a_y_);
b_x = rnd(b_x_);
b_y = rnd(b_y_);
c_x = rnd(c_x_);
c_y = rnd(c_y_);
ux rnd= b_x - a_x;
vy rnd= c_y - a_y;
t2 rnd= ux * vy;
uy rnd= b_y - a_y;
vx rnd= c_x - a_x;
t5 rnd= uy * vx;
det rnd= t2 - t5;
ux_exact = b_x - a_x;
vy_exact = c_y - a_y;
t2_exact = ux_exact * vy_exact;
uy_exact = b_y - a_y;
vx_exact = c_x - a_x;
t5_exact = uy_exact * vx_exact;
det_exact = t2_exact - t5_exact;
{ a_x in [0, 1] /\
  a_y in [0, 1] /\
  b_x in [0, 1] /\
  b_y in [0, 1] /\
  c_x in [0, 1] /\
  c_y in [0, 1]
-> |det - det_exact| <= 0x1.8000000000007p-51 }
