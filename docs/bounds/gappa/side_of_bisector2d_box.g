# SPDX-License-Identifier: LGPL-3.0-or-later
# side_of_bisector2d: the program as it is, on numbers of [0, 1]: at most kRel 4 from the exact value. What that says: README.md.
# Made by tools/generate_predicates.py from predicates/generated/side_of_bisector2d.formula: do not edit.
@rnd = float<ieee_64, ne>;
a_x = rnd(a_x_);
a_y = rnd(a_y_);
b_x = rnd(b_x_);
b_y = rnd(b_y_);
p_x = rnd(p_x_);
p_y = rnd(p_y_);
ux rnd= b_x - a_x;
vx rnd= a_x - p_x;
wx rnd= b_x - p_x;
sumx rnd= vx + wx;
t4 rnd= ux * sumx;
uy rnd= b_y - a_y;
vy rnd= a_y - p_y;
wy rnd= b_y - p_y;
sumy rnd= vy + wy;
t9 rnd= uy * sumy;
det rnd= t4 + t9;
ux_exact = b_x - a_x;
vx_exact = a_x - p_x;
wx_exact = b_x - p_x;
sumx_exact = vx_exact + wx_exact;
t4_exact = ux_exact * sumx_exact;
uy_exact = b_y - a_y;
vy_exact = a_y - p_y;
wy_exact = b_y - p_y;
sumy_exact = vy_exact + wy_exact;
t9_exact = uy_exact * sumy_exact;
det_exact = t4_exact + t9_exact;
{ a_x in [0, 1] /\
  a_y in [0, 1] /\
  b_x in [0, 1] /\
  b_y in [0, 1] /\
  p_x in [0, 1] /\
  p_y in [0, 1]
-> |det - det_exact| <= 0x1.0000000000005p-49 }
