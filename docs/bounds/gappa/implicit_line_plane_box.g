# SPDX-License-Identifier: LGPL-3.0-or-later
# implicit_line_plane: the program as it is, on numbers of [0, 1]: at most kRel 2 from the exact value. What that says: README.md.
# Made by tools/generate_predicates.py from docs/bounds/gappa/implicit_line_plane.formula: do not edit.
@rnd = float<ieee_64, ne>;
p_x = rnd(p_x_);
p_y = rnd(p_y_);
p_z = rnd(p_z_);
q_x = rnd(q_x_);
q_y = rnd(q_y_);
q_z = rnd(q_z_);
a_x = rnd(a_x_);
a_y = rnd(a_y_);
a_z = rnd(a_z_);
b_x = rnd(b_x_);
b_y = rnd(b_y_);
b_z = rnd(b_z_);
c_x = rnd(c_x_);
c_y = rnd(c_y_);
c_z = rnd(c_z_);
r_x = rnd(r_x_);
r_y = rnd(r_y_);
r_z = rnd(r_z_);
s_x = rnd(s_x_);
s_y = rnd(s_y_);
s_z = rnd(s_z_);
t_x = rnd(t_x_);
t_y = rnd(t_y_);
t_z = rnd(t_z_);
vy rnd= b_y - a_y;
wz rnd= c_z - a_z;
t2 rnd= vy * wz;
vz rnd= b_z - a_z;
wy rnd= c_y - a_y;
t5 rnd= vz * wy;
nx rnd= t2 - t5;
gx rnd= a_x - p_x;
t8 rnd= nx * gx;
wx rnd= c_x - a_x;
t10 rnd= vz * wx;
vx rnd= b_x - a_x;
t12 rnd= vx * wz;
ny rnd= t10 - t12;
gy rnd= a_y - p_y;
t15 rnd= ny * gy;
t16 rnd= t8 + t15;
t17 rnd= vx * wy;
t18 rnd= vy * wx;
nz rnd= t17 - t18;
gz rnd= a_z - p_z;
t21 rnd= nz * gz;
ng rnd= t16 + t21;
ux rnd= q_x - p_x;
xn rnd= ng * ux;
v1y rnd= s_y - r_y;
w1z rnd= t_z - r_z;
t27 rnd= v1y * w1z;
v1z rnd= s_z - r_z;
w1y rnd= t_y - r_y;
t30 rnd= v1z * w1y;
mx rnd= t27 - t30;
t32 rnd= xn * mx;
uy rnd= q_y - p_y;
yn rnd= ng * uy;
w1x rnd= t_x - r_x;
t36 rnd= v1z * w1x;
v1x rnd= s_x - r_x;
t38 rnd= v1x * w1z;
my rnd= t36 - t38;
t40 rnd= yn * my;
t41 rnd= t32 + t40;
uz rnd= q_z - p_z;
zn rnd= ng * uz;
t44 rnd= v1x * w1y;
t45 rnd= v1y * w1x;
mz rnd= t44 - t45;
t47 rnd= zn * mz;
t48 rnd= t41 + t47;
t49 rnd= nx * ux;
t50 rnd= ny * uy;
t51 rnd= t49 + t50;
t52 rnd= nz * uz;
den rnd= t51 + t52;
ex rnd= p_x - r_x;
t55 rnd= ex * mx;
ey rnd= p_y - r_y;
t57 rnd= ey * my;
t58 rnd= t55 + t57;
ez rnd= p_z - r_z;
t60 rnd= ez * mz;
t61 rnd= t58 + t60;
t62 rnd= den * t61;
det rnd= t48 + t62;
vy_exact = b_y - a_y;
wz_exact = c_z - a_z;
t2_exact = vy_exact * wz_exact;
vz_exact = b_z - a_z;
wy_exact = c_y - a_y;
t5_exact = vz_exact * wy_exact;
nx_exact = t2_exact - t5_exact;
gx_exact = a_x - p_x;
t8_exact = nx_exact * gx_exact;
wx_exact = c_x - a_x;
t10_exact = vz_exact * wx_exact;
vx_exact = b_x - a_x;
t12_exact = vx_exact * wz_exact;
ny_exact = t10_exact - t12_exact;
gy_exact = a_y - p_y;
t15_exact = ny_exact * gy_exact;
t16_exact = t8_exact + t15_exact;
t17_exact = vx_exact * wy_exact;
t18_exact = vy_exact * wx_exact;
nz_exact = t17_exact - t18_exact;
gz_exact = a_z - p_z;
t21_exact = nz_exact * gz_exact;
ng_exact = t16_exact + t21_exact;
ux_exact = q_x - p_x;
xn_exact = ng_exact * ux_exact;
v1y_exact = s_y - r_y;
w1z_exact = t_z - r_z;
t27_exact = v1y_exact * w1z_exact;
v1z_exact = s_z - r_z;
w1y_exact = t_y - r_y;
t30_exact = v1z_exact * w1y_exact;
mx_exact = t27_exact - t30_exact;
t32_exact = xn_exact * mx_exact;
uy_exact = q_y - p_y;
yn_exact = ng_exact * uy_exact;
w1x_exact = t_x - r_x;
t36_exact = v1z_exact * w1x_exact;
v1x_exact = s_x - r_x;
t38_exact = v1x_exact * w1z_exact;
my_exact = t36_exact - t38_exact;
t40_exact = yn_exact * my_exact;
t41_exact = t32_exact + t40_exact;
uz_exact = q_z - p_z;
zn_exact = ng_exact * uz_exact;
t44_exact = v1x_exact * w1y_exact;
t45_exact = v1y_exact * w1x_exact;
mz_exact = t44_exact - t45_exact;
t47_exact = zn_exact * mz_exact;
t48_exact = t41_exact + t47_exact;
t49_exact = nx_exact * ux_exact;
t50_exact = ny_exact * uy_exact;
t51_exact = t49_exact + t50_exact;
t52_exact = nz_exact * uz_exact;
den_exact = t51_exact + t52_exact;
ex_exact = p_x - r_x;
t55_exact = ex_exact * mx_exact;
ey_exact = p_y - r_y;
t57_exact = ey_exact * my_exact;
t58_exact = t55_exact + t57_exact;
ez_exact = p_z - r_z;
t60_exact = ez_exact * mz_exact;
t61_exact = t58_exact + t60_exact;
t62_exact = den_exact * t61_exact;
det_exact = t48_exact + t62_exact;
{ p_x in [0, 1] /\
  p_y in [0, 1] /\
  p_z in [0, 1] /\
  q_x in [0, 1] /\
  q_y in [0, 1] /\
  q_z in [0, 1] /\
  a_x in [0, 1] /\
  a_y in [0, 1] /\
  a_z in [0, 1] /\
  b_x in [0, 1] /\
  b_y in [0, 1] /\
  b_z in [0, 1] /\
  c_x in [0, 1] /\
  c_y in [0, 1] /\
  c_z in [0, 1] /\
  r_x in [0, 1] /\
  r_y in [0, 1] /\
  r_z in [0, 1] /\
  s_x in [0, 1] /\
  s_y in [0, 1] /\
  s_z in [0, 1] /\
  t_x in [0, 1] /\
  t_y in [0, 1] /\
  t_z in [0, 1]
-> |det - det_exact| <= 0x1.320000000001cp-42 }
