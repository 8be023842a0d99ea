# SPDX-License-Identifier: LGPL-3.0-or-later
# implicit_three_planes: the program as it is, on numbers of [0, 1]: at most kRel 3 from the exact value. What that says: README.md.
# Made by tools/generate_predicates.py from docs/bounds/gappa/implicit_three_planes.formula: do not edit.
@rnd = float<ieee_64, ne>;
a0_x = rnd(a0_x_);
a0_y = rnd(a0_y_);
a0_z = rnd(a0_z_);
a1_x = rnd(a1_x_);
a1_y = rnd(a1_y_);
a1_z = rnd(a1_z_);
a2_x = rnd(a2_x_);
a2_y = rnd(a2_y_);
a2_z = rnd(a2_z_);
b0_x = rnd(b0_x_);
b0_y = rnd(b0_y_);
b0_z = rnd(b0_z_);
b1_x = rnd(b1_x_);
b1_y = rnd(b1_y_);
b1_z = rnd(b1_z_);
b2_x = rnd(b2_x_);
b2_y = rnd(b2_y_);
b2_z = rnd(b2_z_);
c0_x = rnd(c0_x_);
c0_y = rnd(c0_y_);
c0_z = rnd(c0_z_);
c1_x = rnd(c1_x_);
c1_y = rnd(c1_y_);
c1_z = rnd(c1_z_);
c2_x = rnd(c2_x_);
c2_y = rnd(c2_y_);
c2_z = rnd(c2_z_);
r_x = rnd(r_x_);
r_y = rnd(r_y_);
r_z = rnd(r_z_);
s_x = rnd(s_x_);
s_y = rnd(s_y_);
s_z = rnd(s_z_);
t_x = rnd(t_x_);
t_y = rnd(t_y_);
t_z = rnd(t_z_);
v2y rnd= b1_y - b0_y;
w2z rnd= b2_z - b0_z;
t2 rnd= v2y * w2z;
v2z rnd= b1_z - b0_z;
w2y rnd= b2_y - b0_y;
t5 rnd= v2z * w2y;
n2x rnd= t2 - t5;
g2x rnd= b0_x - a0_x;
t8 rnd= n2x * g2x;
w2x rnd= b2_x - b0_x;
t10 rnd= v2z * w2x;
v2x rnd= b1_x - b0_x;
t12 rnd= v2x * w2z;
n2y rnd= t10 - t12;
g2y rnd= b0_y - a0_y;
t15 rnd= n2y * g2y;
t16 rnd= t8 + t15;
t17 rnd= v2x * w2y;
t18 rnd= v2y * w2x;
n2z rnd= t17 - t18;
g2z rnd= b0_z - a0_z;
t21 rnd= n2z * g2z;
h2 rnd= t16 + t21;
v3z rnd= c1_z - c0_z;
w3x rnd= c2_x - c0_x;
t25 rnd= v3z * w3x;
v3x rnd= c1_x - c0_x;
w3z rnd= c2_z - c0_z;
t28 rnd= v3x * w3z;
n3y rnd= t25 - t28;
v1x rnd= a1_x - a0_x;
w1y rnd= a2_y - a0_y;
t32 rnd= v1x * w1y;
v1y rnd= a1_y - a0_y;
w1x rnd= a2_x - a0_x;
t35 rnd= v1y * w1x;
n1z rnd= t32 - t35;
t37 rnd= n3y * n1z;
w3y rnd= c2_y - c0_y;
t39 rnd= v3x * w3y;
v3y rnd= c1_y - c0_y;
t41 rnd= v3y * w3x;
n3z rnd= t39 - t41;
v1z rnd= a1_z - a0_z;
t44 rnd= v1z * w1x;
w1z rnd= a2_z - a0_z;
t46 rnd= v1x * w1z;
n1y rnd= t44 - t46;
t48 rnd= n3z * n1y;
c31x rnd= t37 - t48;
t50 rnd= h2 * c31x;
t51 rnd= v3y * w3z;
t52 rnd= v3z * w3y;
n3x rnd= t51 - t52;
g3x rnd= c0_x - a0_x;
t55 rnd= n3x * g3x;
g3y rnd= c0_y - a0_y;
t57 rnd= n3y * g3y;
t58 rnd= t55 + t57;
g3z rnd= c0_z - a0_z;
t60 rnd= n3z * g3z;
h3 rnd= t58 + t60;
t62 rnd= n1y * n2z;
t63 rnd= n1z * n2y;
c12x rnd= t62 - t63;
t65 rnd= h3 * c12x;
xn rnd= t50 + t65;
vy rnd= s_y - r_y;
wz rnd= t_z - r_z;
t69 rnd= vy * wz;
vz rnd= s_z - r_z;
wy rnd= t_y - r_y;
t72 rnd= vz * wy;
mx rnd= t69 - t72;
t74 rnd= xn * mx;
t75 rnd= v1y * w1z;
t76 rnd= v1z * w1y;
n1x rnd= t75 - t76;
t78 rnd= n3z * n1x;
t79 rnd= n3x * n1z;
c31y rnd= t78 - t79;
t81 rnd= h2 * c31y;
t82 rnd= n1z * n2x;
t83 rnd= n1x * n2z;
c12y rnd= t82 - t83;
t85 rnd= h3 * c12y;
yn rnd= t81 + t85;
wx rnd= t_x - r_x;
t88 rnd= vz * wx;
vx rnd= s_x - r_x;
t90 rnd= vx * wz;
my rnd= t88 - t90;
t92 rnd= yn * my;
t93 rnd= t74 + t92;
t94 rnd= n3x * n1y;
t95 rnd= n3y * n1x;
c31z rnd= t94 - t95;
t97 rnd= h2 * c31z;
t98 rnd= n1x * n2y;
t99 rnd= n1y * n2x;
c12z rnd= t98 - t99;
t101 rnd= h3 * c12z;
zn rnd= t97 + t101;
t103 rnd= vx * wy;
t104 rnd= vy * wx;
mz rnd= t103 - t104;
t106 rnd= zn * mz;
t107 rnd= t93 + t106;
t108 rnd= n2x * c31x;
t109 rnd= n2y * c31y;
t110 rnd= t108 + t109;
t111 rnd= n2z * c31z;
den rnd= t110 + t111;
ex rnd= a0_x - r_x;
t114 rnd= ex * mx;
ey rnd= a0_y - r_y;
t116 rnd= ey * my;
t117 rnd= t114 + t116;
ez rnd= a0_z - r_z;
t119 rnd= ez * mz;
t120 rnd= t117 + t119;
t121 rnd= den * t120;
det rnd= t107 + t121;
v2y_exact = b1_y - b0_y;
w2z_exact = b2_z - b0_z;
t2_exact = v2y_exact * w2z_exact;
v2z_exact = b1_z - b0_z;
w2y_exact = b2_y - b0_y;
t5_exact = v2z_exact * w2y_exact;
n2x_exact = t2_exact - t5_exact;
g2x_exact = b0_x - a0_x;
t8_exact = n2x_exact * g2x_exact;
w2x_exact = b2_x - b0_x;
t10_exact = v2z_exact * w2x_exact;
v2x_exact = b1_x - b0_x;
t12_exact = v2x_exact * w2z_exact;
n2y_exact = t10_exact - t12_exact;
g2y_exact = b0_y - a0_y;
t15_exact = n2y_exact * g2y_exact;
t16_exact = t8_exact + t15_exact;
t17_exact = v2x_exact * w2y_exact;
t18_exact = v2y_exact * w2x_exact;
n2z_exact = t17_exact - t18_exact;
g2z_exact = b0_z - a0_z;
t21_exact = n2z_exact * g2z_exact;
h2_exact = t16_exact + t21_exact;
v3z_exact = c1_z - c0_z;
w3x_exact = c2_x - c0_x;
t25_exact = v3z_exact * w3x_exact;
v3x_exact = c1_x - c0_x;
w3z_exact = c2_z - c0_z;
t28_exact = v3x_exact * w3z_exact;
n3y_exact = t25_exact - t28_exact;
v1x_exact = a1_x - a0_x;
w1y_exact = a2_y - a0_y;
t32_exact = v1x_exact * w1y_exact;
v1y_exact = a1_y - a0_y;
w1x_exact = a2_x - a0_x;
t35_exact = v1y_exact * w1x_exact;
n1z_exact = t32_exact - t35_exact;
t37_exact = n3y_exact * n1z_exact;
w3y_exact = c2_y - c0_y;
t39_exact = v3x_exact * w3y_exact;
v3y_exact = c1_y - c0_y;
t41_exact = v3y_exact * w3x_exact;
n3z_exact = t39_exact - t41_exact;
v1z_exact = a1_z - a0_z;
t44_exact = v1z_exact * w1x_exact;
w1z_exact = a2_z - a0_z;
t46_exact = v1x_exact * w1z_exact;
n1y_exact = t44_exact - t46_exact;
t48_exact = n3z_exact * n1y_exact;
c31x_exact = t37_exact - t48_exact;
t50_exact = h2_exact * c31x_exact;
t51_exact = v3y_exact * w3z_exact;
t52_exact = v3z_exact * w3y_exact;
n3x_exact = t51_exact - t52_exact;
g3x_exact = c0_x - a0_x;
t55_exact = n3x_exact * g3x_exact;
g3y_exact = c0_y - a0_y;
t57_exact = n3y_exact * g3y_exact;
t58_exact = t55_exact + t57_exact;
g3z_exact = c0_z - a0_z;
t60_exact = n3z_exact * g3z_exact;
h3_exact = t58_exact + t60_exact;
t62_exact = n1y_exact * n2z_exact;
t63_exact = n1z_exact * n2y_exact;
c12x_exact = t62_exact - t63_exact;
t65_exact = h3_exact * c12x_exact;
xn_exact = t50_exact + t65_exact;
vy_exact = s_y - r_y;
wz_exact = t_z - r_z;
t69_exact = vy_exact * wz_exact;
vz_exact = s_z - r_z;
wy_exact = t_y - r_y;
t72_exact = vz_exact * wy_exact;
mx_exact = t69_exact - t72_exact;
t74_exact = xn_exact * mx_exact;
t75_exact = v1y_exact * w1z_exact;
t76_exact = v1z_exact * w1y_exact;
n1x_exact = t75_exact - t76_exact;
t78_exact = n3z_exact * n1x_exact;
t79_exact = n3x_exact * n1z_exact;
c31y_exact = t78_exact - t79_exact;
t81_exact = h2_exact * c31y_exact;
t82_exact = n1z_exact * n2x_exact;
t83_exact = n1x_exact * n2z_exact;
c12y_exact = t82_exact - t83_exact;
t85_exact = h3_exact * c12y_exact;
yn_exact = t81_exact + t85_exact;
wx_exact = t_x - r_x;
t88_exact = vz_exact * wx_exact;
vx_exact = s_x - r_x;
t90_exact = vx_exact * wz_exact;
my_exact = t88_exact - t90_exact;
t92_exact = yn_exact * my_exact;
t93_exact = t74_exact + t92_exact;
t94_exact = n3x_exact * n1y_exact;
t95_exact = n3y_exact * n1x_exact;
c31z_exact = t94_exact - t95_exact;
t97_exact = h2_exact * c31z_exact;
t98_exact = n1x_exact * n2y_exact;
t99_exact = n1y_exact * n2x_exact;
c12z_exact = t98_exact - t99_exact;
t101_exact = h3_exact * c12z_exact;
zn_exact = t97_exact + t101_exact;
t103_exact = vx_exact * wy_exact;
t104_exact = vy_exact * wx_exact;
mz_exact = t103_exact - t104_exact;
t106_exact = zn_exact * mz_exact;
t107_exact = t93_exact + t106_exact;
t108_exact = n2x_exact * c31x_exact;
t109_exact = n2y_exact * c31y_exact;
t110_exact = t108_exact + t109_exact;
t111_exact = n2z_exact * c31z_exact;
den_exact = t110_exact + t111_exact;
ex_exact = a0_x - r_x;
t114_exact = ex_exact * mx_exact;
ey_exact = a0_y - r_y;
t116_exact = ey_exact * my_exact;
t117_exact = t114_exact + t116_exact;
ez_exact = a0_z - r_z;
t119_exact = ez_exact * mz_exact;
t120_exact = t117_exact + t119_exact;
t121_exact = den_exact * t120_exact;
det_exact = t107_exact + t121_exact;
{ a0_x in [0, 1] /\
  a0_y in [0, 1] /\
  a0_z in [0, 1] /\
  a1_x in [0, 1] /\
  a1_y in [0, 1] /\
  a1_z in [0, 1] /\
  a2_x in [0, 1] /\
  a2_y in [0, 1] /\
  a2_z in [0, 1] /\
  b0_x in [0, 1] /\
  b0_y in [0, 1] /\
  b0_z in [0, 1] /\
  b1_x in [0, 1] /\
  b1_y in [0, 1] /\
  b1_z in [0, 1] /\
  b2_x in [0, 1] /\
  b2_y in [0, 1] /\
  b2_z in [0, 1] /\
  c0_x in [0, 1] /\
  c0_y in [0, 1] /\
  c0_z in [0, 1] /\
  c1_x in [0, 1] /\
  c1_y in [0, 1] /\
  c1_z in [0, 1] /\
  c2_x in [0, 1] /\
  c2_y in [0, 1] /\
  c2_z in [0, 1] /\
  r_x in [0, 1] /\
  r_y in [0, 1] /\
  r_z in [0, 1] /\
  s_x in [0, 1] /\
  s_y in [0, 1] /\
  s_z in [0, 1] /\
  t_x in [0, 1] /\
  t_y in [0, 1] /\
  t_z in [0, 1]
-> |det - det_exact| <= 0x1.6c80000000032p-38 }
