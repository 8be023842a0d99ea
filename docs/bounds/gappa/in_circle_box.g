# SPDX-License-Identifier: LGPL-3.0-or-later
# in_circle: the program as it is, on numbers of [0, 1]: at most kRel 12 from the exact value. What that says: README.md.
# Made by tools/generate_predicates.py from docs/bounds/gappa/in_circle.formula: do not edit.
@rnd = float<ieee_64, ne>;
a_x = rnd(a_x_);
a_y = rnd(a_y_);
b_x = rnd(b_x_);
b_y = rnd(b_y_);
c_x = rnd(c_x_);
c_y = rnd(c_y_);
d_x = rnd(d_x_);
d_y = rnd(d_y_);
px rnd= a_x - d_x;
t1 rnd= px * px;
py rnd= a_y - d_y;
t3 rnd= py * py;
t4 rnd= t1 + t3;
qx rnd= b_x - d_x;
ry rnd= c_y - d_y;
t7 rnd= qx * ry;
rx rnd= c_x - d_x;
qy rnd= b_y - d_y;
t10 rnd= rx * qy;
t11 rnd= t7 - t10;
t12 rnd= t4 * t11;
t13 rnd= qx * qx;
t14 rnd= qy * qy;
t15 rnd= t13 + t14;
t16 rnd= rx * py;
t17 rnd= px * ry;
t18 rnd= t16 - t17;
t19 rnd= t15 * t18;
t20 rnd= t12 + t19;
t21 rnd= rx * rx;
t22 rnd= ry * ry;
t23 rnd= t21 + t22;
t24 rnd= px * qy;
t25 rnd= qx * py;
t26 rnd= t24 - t25;
t27 rnd= t23 * t26;
det rnd= t20 + t27;
px_exact = a_x - d_x;
t1_exact = px_exact * px_exact;
py_exact = a_y - d_y;
t3_exact = py_exact * py_exact;
t4_exact = t1_exact + t3_exact;
qx_exact = b_x - d_x;
ry_exact = c_y - d_y;
t7_exact = qx_exact * ry_exact;
rx_exact = c_x - d_x;
qy_exact = b_y - d_y;
t10_exact = rx_exact * qy_exact;
t11_exact = t7_exact - t10_exact;
t12_exact = t4_exact * t11_exact;
t13_exact = qx_exact * qx_exact;
t14_exact = qy_exact * qy_exact;
t15_exact = t13_exact + t14_exact;
t16_exact = rx_exact * py_exact;
t17_exact = px_exact * ry_exact;
t18_exact = t16_exact - t17_exact;
t19_exact = t15_exact * t18_exact;
t20_exact = t12_exact + t19_exact;
t21_exact = rx_exact * rx_exact;
t22_exact = ry_exact * ry_exact;
t23_exact = t21_exact + t22_exact;
t24_exact = px_exact * qy_exact;
t25_exact = qx_exact * py_exact;
t26_exact = t24_exact - t25_exact;
t27_exact = t23_exact * t26_exact;
det_exact = t20_exact + t27_exact;
{ a_x in [0, 1] /\
  a_y in [0, 1] /\
  b_x in [0, 1] /\
  b_y in [0, 1] /\
  c_x in [0, 1] /\
  c_y in [0, 1] /\
  d_x in [0, 1] /\
  d_y in [0, 1]
-> |det - det_exact| <= 0x1.e000000000012p-47 }
