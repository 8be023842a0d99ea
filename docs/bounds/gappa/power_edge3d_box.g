# SPDX-License-Identifier: LGPL-3.0-or-later
# power_edge3d: the program as it is, on numbers of [0, 1]: at most kRel 15 from the exact value. What that says: README.md.
# Made by tools/generate_predicates.py from predicates/generated/power_edge3d.formula: do not edit.
@rnd = float<ieee_64, ne>;
a_x = rnd(a_x_);
a_y = rnd(a_y_);
a_z = rnd(a_z_);
wa = rnd(wa_);
b_x = rnd(b_x_);
b_y = rnd(b_y_);
b_z = rnd(b_z_);
wb = rnd(wb_);
d_x = rnd(d_x_);
d_y = rnd(d_y_);
d_z = rnd(d_z_);
wd = rnd(wd_);
da rnd= wd - wa;
qx rnd= b_x - d_x;
ux rnd= b_x - a_x;
t3 rnd= qx * ux;
qy rnd= b_y - d_y;
uy rnd= b_y - a_y;
t6 rnd= qy * uy;
t7 rnd= t3 + t6;
qz rnd= b_z - d_z;
uz rnd= b_z - a_z;
t10 rnd= qz * uz;
t11 rnd= t7 + t10;
t12 rnd= da * t11;
db rnd= wd - wb;
px rnd= a_x - d_x;
t15 rnd= px * ux;
py rnd= a_y - d_y;
t17 rnd= py * uy;
t18 rnd= t15 + t17;
pz rnd= a_z - d_z;
t20 rnd= pz * uz;
t21 rnd= t18 + t20;
t22 rnd= db * t21;
t23 rnd= t12 - t22;
t24 rnd= px * qx;
t25 rnd= py * qy;
t26 rnd= t24 + t25;
t27 rnd= pz * qz;
t28 rnd= t26 + t27;
t29 rnd= ux * ux;
t30 rnd= uy * uy;
t31 rnd= t29 + t30;
t32 rnd= uz * uz;
t33 rnd= t31 + t32;
t34 rnd= t28 * t33;
det rnd= t23 - t34;
da_exact = wd - wa;
qx_exact = b_x - d_x;
ux_exact = b_x - a_x;
t3_exact = qx_exact * ux_exact;
qy_exact = b_y - d_y;
uy_exact = b_y - a_y;
t6_exact = qy_exact * uy_exact;
t7_exact = t3_exact + t6_exact;
qz_exact = b_z - d_z;
uz_exact = b_z - a_z;
t10_exact = qz_exact * uz_exact;
t11_exact = t7_exact + t10_exact;
t12_exact = da_exact * t11_exact;
db_exact = wd - wb;
px_exact = a_x - d_x;
t15_exact = px_exact * ux_exact;
py_exact = a_y - d_y;
t17_exact = py_exact * uy_exact;
t18_exact = t15_exact + t17_exact;
pz_exact = a_z - d_z;
t20_exact = pz_exact * uz_exact;
t21_exact = t18_exact + t20_exact;
t22_exact = db_exact * t21_exact;
t23_exact = t12_exact - t22_exact;
t24_exact = px_exact * qx_exact;
t25_exact = py_exact * qy_exact;
t26_exact = t24_exact + t25_exact;
t27_exact = pz_exact * qz_exact;
t28_exact = t26_exact + t27_exact;
t29_exact = ux_exact * ux_exact;
t30_exact = uy_exact * uy_exact;
t31_exact = t29_exact + t30_exact;
t32_exact = uz_exact * uz_exact;
t33_exact = t31_exact + t32_exact;
t34_exact = t28_exact * t33_exact;
det_exact = t23_exact - t34_exact;
{ a_x in [0, 1] /\
  a_y in [0, 1] /\
  a_z in [0, 1] /\
  wa in [0, 1] /\
  b_x in [0, 1] /\
  b_y in [0, 1] /\
  b_z in [0, 1] /\
  wb in [0, 1] /\
  d_x in [0, 1] /\
  d_y in [0, 1] /\
  d_z in [0, 1] /\
  wd in [0, 1]
-> |det - det_exact| <= 0x1.4a0000000000dp-46 }
