# SPDX-License-Identifier: LGPL-3.0-or-later
# power_edge2d: the program as it is, on numbers of [0, 1]: at most kRel 8 from the exact value. What that says: README.md.
# Made by tools/generate_predicates.py from predicates/generated/power_edge2d.formula: do not edit.
@rnd = float<ieee_64, ne>;
a_x = rnd(a_x_);
a_y = rnd(a_y_);
wa = rnd(wa_);
b_x = rnd(b_x_);
b_y = rnd(b_y_);
wb = rnd(wb_);
d_x = rnd(d_x_);
d_y = rnd(d_y_);
wd = rnd(wd_);
da rnd= wd - wa;
qx rnd= b_x - d_x;
ux rnd= b_x - a_x;
t3 rnd= qx * ux;
qy rnd= b_y - d_y;
uy rnd= b_y - a_y;
t6 rnd= qy * uy;
t7 rnd= t3 + t6;
t8 rnd= da * t7;
db rnd= wd - wb;
px rnd= a_x - d_x;
t11 rnd= px * ux;
py rnd= a_y - d_y;
t13 rnd= py * uy;
t14 rnd= t11 + t13;
t15 rnd= db * t14;
t16 rnd= t8 - t15;
t17 rnd= px * qx;
t18 rnd= py * qy;
t19 rnd= t17 + t18;
t20 rnd= ux * ux;
t21 rnd= uy * uy;
t22 rnd= t20 + t21;
t23 rnd= t19 * t22;
det rnd= t16 - t23;
da_exact = wd - wa;
qx_exact = b_x - d_x;
ux_exact = b_x - a_x;
t3_exact = qx_exact * ux_exact;
qy_exact = b_y - d_y;
uy_exact = b_y - a_y;
t6_exact = qy_exact * uy_exact;
t7_exact = t3_exact + t6_exact;
t8_exact = da_exact * t7_exact;
db_exact = wd - wb;
px_exact = a_x - d_x;
t11_exact = px_exact * ux_exact;
py_exact = a_y - d_y;
t13_exact = py_exact * uy_exact;
t14_exact = t11_exact + t13_exact;
t15_exact = db_exact * t14_exact;
t16_exact = t8_exact - t15_exact;
t17_exact = px_exact * qx_exact;
t18_exact = py_exact * qy_exact;
t19_exact = t17_exact + t18_exact;
t20_exact = ux_exact * ux_exact;
t21_exact = uy_exact * uy_exact;
t22_exact = t20_exact + t21_exact;
t23_exact = t19_exact * t22_exact;
det_exact = t16_exact - t23_exact;
{ a_x in [0, 1] /\
  a_y in [0, 1] /\
  wa in [0, 1] /\
  b_x in [0, 1] /\
  b_y in [0, 1] /\
  wb in [0, 1] /\
  d_x in [0, 1] /\
  d_y in [0, 1] /\
  wd in [0, 1]
-> |det - det_exact| <= 0x1.200000000000ap-47 }
