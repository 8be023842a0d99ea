# SPDX-License-Identifier: LGPL-3.0-or-later
# implicit_three_planes: kRel pays for the roundings of every monomial. What that proves: README.md.
# Made by tools/generate_predicates.py from docs/bounds/gappa/implicit_three_planes.formula: do not edit.
@up = float<ieee_64, up>;
@down = float<ieee_64, dn>;
@toward_zero = float<ieee_64, zr>;
kRel = 0x1.e600000000043p-40;
# 32 monomials, the first is ez v1z v2x v3y vx w1x w2y w3z wy
way1 = (1 + d1) * (1 + d2) * (1 + d3) * (1 + d4) * (1 + d5) * (1 + d6) * (1 + d7) * (1 + d8) * (1 + d9) * (1 + d10) * (1 + d11) * (1 + d12) * (1 + d13) * (1 + d14) * (1 + d15) * (1 + d16) * (1 + d17) * (1 + d18) * (1 + d19) * (1 + d20) * (1 + d21) * (1 + d22) * (1 + d23) * (1 + d24);
sum1 = (1 + s1) * (1 + s2) * (1 + s3) * (1 + s4) * (1 + s5) * (1 + s6) * (1 + s7) * (1 + s8) * (1 + s9) * (1 + s10) * (1 + s11) * (1 + s12) * (1 + s13) * (1 + s14) * (1 + s15) * (1 + s16) * (1 + s17) * (1 + s18) * (1 + s19);
# 192 monomials, the first is g2z v1z v2x v3y vx w1x w2y w3z wy
way2 = (1 + d1) * (1 + d2) * (1 + d3) * (1 + d4) * (1 + d5) * (1 + d6) * (1 + d7) * (1 + d8) * (1 + d9) * (1 + d10) * (1 + d11) * (1 + d12) * (1 + d13) * (1 + d14) * (1 + d15) * (1 + d16) * (1 + d17) * (1 + d18) * (1 + d19) * (1 + d20) * (1 + d21) * (1 + d22) * (1 + d23) * (1 + d24) * (1 + d25);
# 384 monomials, the first is g2z v1x v2x v3z vy w1y w2y w3x wz
way3 = (1 + d1) * (1 + d2) * (1 + d3) * (1 + d4) * (1 + d5) * (1 + d6) * (1 + d7) * (1 + d8) * (1 + d9) * (1 + d10) * (1 + d11) * (1 + d12) * (1 + d13) * (1 + d14) * (1 + d15) * (1 + d16) * (1 + d17) * (1 + d18) * (1 + d19) * (1 + d20) * (1 + d21) * (1 + d22) * (1 + d23) * (1 + d24) * (1 + d25) * (1 + d26);
# 256 monomials, the first is g2x v1x v2y v3z vy w1y w2z w3x wz
way4 = (1 + d1) * (1 + d2) * (1 + d3) * (1 + d4) * (1 + d5) * (1 + d6) * (1 + d7) * (1 + d8) * (1 + d9) * (1 + d10) * (1 + d11) * (1 + d12) * (1 + d13) * (1 + d14) * (1 + d15) * (1 + d16) * (1 + d17) * (1 + d18) * (1 + d19) * (1 + d20) * (1 + d21) * (1 + d22) * (1 + d23) * (1 + d24) * (1 + d25) * (1 + d26) * (1 + d27);
{ |x| in [1b-1021, 1b1023] /\ |y| <= 1b-1021 /\
  d1 in [-1b-52, 1b-52] /\
  d2 in [-1b-52, 1b-52] /\
  d3 in [-1b-52, 1b-52] /\
  d4 in [-1b-52, 1b-52] /\
  d5 in [-1b-52, 1b-52] /\
  d6 in [-1b-52, 1b-52] /\
  d7 in [-1b-52, 1b-52] /\
  d8 in [-1b-52, 1b-52] /\
  d9 in [-1b-52, 1b-52] /\
  d10 in [-1b-52, 1b-52] /\
  d11 in [-1b-52, 1b-52] /\
  d12 in [-1b-52, 1b-52] /\
  d13 in [-1b-52, 1b-52] /\
  d14 in [-1b-52, 1b-52] /\
  d15 in [-1b-52, 1b-52] /\
  d16 in [-1b-52, 1b-52] /\
  d17 in [-1b-52, 1b-52] /\
  d18 in [-1b-52, 1b-52] /\
  d19 in [-1b-52, 1b-52] /\
  d20 in [-1b-52, 1b-52] /\
  d21 in [-1b-52, 1b-52] /\
  d22 in [-1b-52, 1b-52] /\
  d23 in [-1b-52, 1b-52] /\
  d24 in [-1b-52, 1b-52] /\
  d25 in [-1b-52, 1b-52] /\
  d26 in [-1b-52, 1b-52] /\
  d27 in [-1b-52, 1b-52] /\
  s1 in [-1b-52, 1b-52] /\
  s2 in [-1b-52, 1b-52] /\
  s3 in [-1b-52, 1b-52] /\
  s4 in [-1b-52, 1b-52] /\
  s5 in [-1b-52, 1b-52] /\
  s6 in [-1b-52, 1b-52] /\
  s7 in [-1b-52, 1b-52] /\
  s8 in [-1b-52, 1b-52] /\
  s9 in [-1b-52, 1b-52] /\
  s10 in [-1b-52, 1b-52] /\
  s11 in [-1b-52, 1b-52] /\
  s12 in [-1b-52, 1b-52] /\
  s13 in [-1b-52, 1b-52] /\
  s14 in [-1b-52, 1b-52] /\
  s15 in [-1b-52, 1b-52] /\
  s16 in [-1b-52, 1b-52] /\
  s17 in [-1b-52, 1b-52] /\
  s18 in [-1b-52, 1b-52] /\
  s19 in [-1b-52, 1b-52] /\
  last in [-1b-52, 1b-52] /\
  e1 in [-1b-52, 1b-52] /\
  e2 in [-1b-52, 1b-52]
-> |up(x) -/ x| <= 1b-52 /\ |up(y) - y| <= 1b-1074 /\
   |down(x) -/ x| <= 1b-52 /\ |down(y) - y| <= 1b-1074 /\
   |toward_zero(x) -/ x| <= 1b-52 /\ |toward_zero(y) - y| <= 1b-1074 /\
   288 * |way1 - 1| * (1 + last) - kRel * (sum1 * (1 + e1) * (1 + e2)) <= 0 /\
   288 * |way2 - 1| * (1 + last) - kRel * (sum1 * (1 + e1) * (1 + e2)) <= 0 /\
   288 * |way3 - 1| * (1 + last) - kRel * (sum1 * (1 + e1) * (1 + e2)) <= 0 /\
   288 * |way4 - 1| * (1 + last) - kRel * (sum1 * (1 + e1) * (1 + e2)) <= 0 }
