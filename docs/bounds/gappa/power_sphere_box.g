# SPDX-License-Identifier: LGPL-3.0-or-later
# power_sphere: the program as it is, on numbers of [0, 1]: at most kRel 96 from the exact value. What that says: README.md.
# Made by tools/generate_predicates.py from predicates/generated/power_sphere.formula: do not edit.
@rnd = float<ieee_64, ne>;
a_x = rnd(a_x_);
a_y = rnd(a_y_);
a_z = rnd(a_z_);
wa = rnd(wa_);
b_x = rnd(b_x_);
b_y = rnd(b_y_);
b_z = rnd(b_z_);
wb = rnd(wb_);
c_x = rnd(c_x_);
c_y = rnd(c_y_);
c_z = rnd(c_z_);
wc = rnd(wc_);
d_x = rnd(d_x_);
d_y = rnd(d_y_);
d_z = rnd(d_z_);
wd = rnd(wd_);
e_x = rnd(e_x_);
e_y = rnd(e_y_);
e_z = rnd(e_z_);
we = rnd(we_);
px rnd= a_x - e_x;
t1 rnd= px * px;
py rnd= a_y - e_y;
t3 rnd= py * py;
t4 rnd= t1 + t3;
pz rnd= a_z - e_z;
t6 rnd= pz * pz;
t7 rnd= t4 + t6;
pw rnd= wa - we;
p_lift rnd= t7 - pw;
qz rnd= b_z - e_z;
rx rnd= c_x - e_x;
sy rnd= d_y - e_y;
t13 rnd= rx * sy;
sx rnd= d_x - e_x;
ry rnd= c_y - e_y;
t16 rnd= sx * ry;
rs rnd= t13 - t16;
t18 rnd= qz * rs;
rz rnd= c_z - e_z;
qx rnd= b_x - e_x;
t21 rnd= qx * sy;
qy rnd= b_y - e_y;
t23 rnd= sx * qy;
qs rnd= t21 - t23;
t25 rnd= rz * qs;
t26 rnd= t18 - t25;
sz rnd= d_z - e_z;
t28 rnd= qx * ry;
t29 rnd= rx * qy;
qr rnd= t28 - t29;
t31 rnd= sz * qr;
qrs rnd= t26 + t31;
t33 rnd= p_lift * qrs;
t34 rnd= qx * qx;
t35 rnd= qy * qy;
t36 rnd= t34 + t35;
t37 rnd= qz * qz;
t38 rnd= t36 + t37;
qw rnd= wb - we;
q_lift rnd= t38 - qw;
t41 rnd= sx * py;
t42 rnd= px * sy;
sp rnd= t41 - t42;
t44 rnd= rz * sp;
t45 rnd= px * ry;
t46 rnd= rx * py;
pr rnd= t45 - t46;
t48 rnd= sz * pr;
t49 rnd= t44 + t48;
t50 rnd= pz * rs;
rsp rnd= t49 + t50;
t52 rnd= q_lift * rsp;
t53 rnd= t33 - t52;
t54 rnd= rx * rx;
t55 rnd= ry * ry;
t56 rnd= t54 + t55;
t57 rnd= rz * rz;
t58 rnd= t56 + t57;
rw rnd= wc - we;
r_lift rnd= t58 - rw;
t61 rnd= px * qy;
t62 rnd= qx * py;
pq rnd= t61 - t62;
t64 rnd= sz * pq;
t65 rnd= pz * qs;
t66 rnd= t64 + t65;
t67 rnd= qz * sp;
spq rnd= t66 + t67;
t69 rnd= r_lift * spq;
t70 rnd= sx * sx;
t71 rnd= sy * sy;
t72 rnd= t70 + t71;
t73 rnd= sz * sz;
t74 rnd= t72 + t73;
sw rnd= wd - we;
s_lift rnd= t74 - sw;
t77 rnd= pz * qr;
t78 rnd= qz * pr;
t79 rnd= t77 - t78;
t80 rnd= rz * pq;
pqr rnd= t79 + t80;
t82 rnd= s_lift * pqr;
t83 rnd= t69 - t82;
det rnd= t53 + t83;
px_exact = a_x - e_x;
t1_exact = px_exact * px_exact;
py_exact = a_y - e_y;
t3_exact = py_exact * py_exact;
t4_exact = t1_exact + t3_exact;
pz_exact = a_z - e_z;
t6_exact = pz_exact * pz_exact;
t7_exact = t4_exact + t6_exact;
pw_exact = wa - we;
p_lift_exact = t7_exact - pw_exact;
qz_exact = b_z - e_z;
rx_exact = c_x - e_x;
sy_exact = d_y - e_y;
t13_exact = rx_exact * sy_exact;
sx_exact = d_x - e_x;
ry_exact = c_y - e_y;
t16_exact = sx_exact * ry_exact;
rs_exact = t13_exact - t16_exact;
t18_exact = qz_exact * rs_exact;
rz_exact = c_z - e_z;
qx_exact = b_x - e_x;
t21_exact = qx_exact * sy_exact;
qy_exact = b_y - e_y;
t23_exact = sx_exact * qy_exact;
qs_exact = t21_exact - t23_exact;
t25_exact = rz_exact * qs_exact;
t26_exact = t18_exact - t25_exact;
sz_exact = d_z - e_z;
t28_exact = qx_exact * ry_exact;
t29_exact = rx_exact * qy_exact;
qr_exact = t28_exact - t29_exact;
t31_exact = sz_exact * qr_exact;
qrs_exact = t26_exact + t31_exact;
t33_exact = p_lift_exact * qrs_exact;
t34_exact = qx_exact * qx_exact;
t35_exact = qy_exact * qy_exact;
t36_exact = t34_exact + t35_exact;
t37_exact = qz_exact * qz_exact;
t38_exact = t36_exact + t37_exact;
qw_exact = wb - we;
q_lift_exact = t38_exact - qw_exact;
t41_exact = sx_exact * py_exact;
t42_exact = px_exact * sy_exact;
sp_exact = t41_exact - t42_exact;
t44_exact = rz_exact * sp_exact;
t45_exact = px_exact * ry_exact;
t46_exact = rx_exact * py_exact;
pr_exact = t45_exact - t46_exact;
t48_exact = sz_exact * pr_exact;
t49_exact = t44_exact + t48_exact;
t50_exact = pz_exact * rs_exact;
rsp_exact = t49_exact + t50_exact;
t52_exact = q_lift_exact * rsp_exact;
t53_exact = t33_exact - t52_exact;
t54_exact = rx_exact * rx_exact;
t55_exact = ry_exact * ry_exact;
t56_exact = t54_exact + t55_exact;
t57_exact = rz_exact * rz_exact;
t58_exact = t56_exact + t57_exact;
rw_exact = wc - we;
r_lift_exact = t58_exact - rw_exact;
t61_exact = px_exact * qy_exact;
t62_exact = qx_exact * py_exact;
pq_exact = t61_exact - t62_exact;
t64_exact = sz_exact * pq_exact;
t65_exact = pz_exact * qs_exact;
t66_exact = t64_exact + t65_exact;
t67_exact = qz_exact * sp_exact;
spq_exact = t66_exact + t67_exact;
t69_exact = r_lift_exact * spq_exact;
t70_exact = sx_exact * sx_exact;
t71_exact = sy_exact * sy_exact;
t72_exact = t70_exact + t71_exact;
t73_exact = sz_exact * sz_exact;
t74_exact = t72_exact + t73_exact;
sw_exact = wd - we;
s_lift_exact = t74_exact - sw_exact;
t77_exact = pz_exact * qr_exact;
t78_exact = qz_exact * pr_exact;
t79_exact = t77_exact - t78_exact;
t80_exact = rz_exact * pq_exact;
pqr_exact = t79_exact + t80_exact;
t82_exact = s_lift_exact * pqr_exact;
t83_exact = t69_exact - t82_exact;
det_exact = t53_exact + t83_exact;
{ a_x in [0, 1] /\
  a_y in [0, 1] /\
  a_z in [0, 1] /\
  wa in [0, 1] /\
  b_x in [0, 1] /\
  b_y in [0, 1] /\
  b_z in [0, 1] /\
  wb in [0, 1] /\
  c_x in [0, 1] /\
  c_y in [0, 1] /\
  c_z in [0, 1] /\
  wc in [0, 1] /\
  d_x in [0, 1] /\
  d_y in [0, 1] /\
  d_z in [0, 1] /\
  wd in [0, 1] /\
  e_x in [0, 1] /\
  e_y in [0, 1] /\
  e_z in [0, 1] /\
  we in [0, 1]
-> |det - det_exact| <= 0x1.8000000000015p-43 }
