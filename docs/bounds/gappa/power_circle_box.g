# SPDX-License-Identifier: LGPL-3.0-or-later
# power_circle: the program as it is, on numbers of [0, 1]: at most kRel 18 from the exact value. What that says: README.md.
# Made by tools/generate_predicates.py from predicates/generated/power_circle.formula: do not edit.
@rnd = float<ieee_64, ne>;
a_x = rnd(a_x_);
a_y = rnd(a_y_);
wa = rnd(wa_);
b_x = rnd(b_x_);
b_y = rnd(b_y_);
wb = rnd(wb_);
c_x = rnd(c_x_);
c_y = rnd(c_y_);
wc = rnd(wc_);
d_x = rnd(d_x_);
d_y = rnd(d_y_);
wd = rnd(wd_);
px rnd= a_x - d_x;
t1 rnd= px * px;
py rnd= a_y - d_y;
t3 rnd= py * py;
t4 rnd= t1 + t3;
pw rnd= wa - wd;
p_lift rnd= t4 - pw;
qx rnd= b_x - d_x;
ry rnd= c_y - d_y;
t9 rnd= qx * ry;
qy rnd= b_y - d_y;
rx rnd= c_x - d_x;
t12 rnd= qy * rx;
t13 rnd= t9 - t12;
t14 rnd= p_lift * t13;
t15 rnd= qx * qx;
t16 rnd= qy * qy;
t17 rnd= t15 + t16;
qw rnd= wb - wd;
q_lift rnd= t17 - qw;
t20 rnd= rx * py;
t21 rnd= ry * px;
t22 rnd= t20 - t21;
t23 rnd= q_lift * t22;
t24 rnd= t14 + t23;
t25 rnd= rx * rx;
t26 rnd= ry * ry;
t27 rnd= t25 + t26;
rw rnd= wc - wd;
r_lift rnd= t27 - rw;
t30 rnd= px * qy;
t31 rnd= py * qx;
t32 rnd= t30 - t31;
t33 rnd= r_lift * t32;
det rnd= t24 + t33;
px_exact = a_x - d_x;
t1_exact = px_exact * px_exact;
py_exact = a_y - d_y;
t3_exact = py_exact * py_exact;
t4_exact = t1_exact + t3_exact;
pw_exact = wa - wd;
p_lift_exact = t4_exact - pw_exact;
qx_exact = b_x - d_x;
ry_exact = c_y - d_y;
t9_exact = qx_exact * ry_exact;
qy_exact = b_y - d_y;
rx_exact = c_x - d_x;
t12_exact = qy_exact * rx_exact;
t13_exact = t9_exact - t12_exact;
t14_exact = p_lift_exact * t13_exact;
t15_exact = qx_exact * qx_exact;
t16_exact = qy_exact * qy_exact;
t17_exact = t15_exact + t16_exact;
qw_exact = wb - wd;
q_lift_exact = t17_exact - qw_exact;
t20_exact = rx_exact * py_exact;
t21_exact = ry_exact * px_exact;
t22_exact = t20_exact - t21_exact;
t23_exact = q_lift_exact * t22_exact;
t24_exact = t14_exact + t23_exact;
t25_exact = rx_exact * rx_exact;
t26_exact = ry_exact * ry_exact;
t27_exact = t25_exact + t26_exact;
rw_exact = wc - wd;
r_lift_exact = t27_exact - rw_exact;
t30_exact = px_exact * qy_exact;
t31_exact = py_exact * qx_exact;
t32_exact = t30_exact - t31_exact;
t33_exact = r_lift_exact * t32_exact;
det_exact = t24_exact + t33_exact;
{ a_x in [0, 1] /\
  a_y in [0, 1] /\
  wa in [0, 1] /\
  b_x in [0, 1] /\
  b_y in [0, 1] /\
  wb in [0, 1] /\
  c_x in [0, 1] /\
  c_y in [0, 1] /\
  wc in [0, 1] /\
  d_x in [0, 1] /\
  d_y in [0, 1] /\
  wd in [0, 1]
-> |det - det_exact| <= 0x1.8c0000000000fp-46 }
