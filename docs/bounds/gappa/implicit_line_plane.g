# SPDX-License-Identifier: LGPL-3.0-or-later
# implicit_line_plane: kRel pays for the roundings of every monomial. What that proves: README.md.
# Made by tools/generate_predicates.py from docs/bounds/gappa/implicit_line_plane.formula: do not edit.
@up = float<ieee_64, up>;
@down = float<ieee_64, dn>;
@toward_zero = float<ieee_64, zr>;
kRel = 0x1.320000000001cp-43;
# 8 monomials, the first is gz uz v1x vx w1y wy
way1 = (1 + d1) * (1 + d2) * (1 + d3) * (1 + d4) * (1 + d5) * (1 + d6) * (1 + d7) * (1 + d8) * (1 + d9) * (1 + d10) * (1 + d11) * (1 + d12) * (1 + d13) * (1 + d14) * (1 + d15);
sum1 = (1 + s1) * (1 + s2) * (1 + s3) * (1 + s4) * (1 + s5) * (1 + s6) * (1 + s7) * (1 + s8) * (1 + s9) * (1 + s10) * (1 + s11) * (1 + s12);
# 32 monomials, the first is gz ux v1y vx w1z wy
way2 = (1 + d1) * (1 + d2) * (1 + d3) * (1 + d4) * (1 + d5) * (1 + d6) * (1 + d7) * (1 + d8) * (1 + d9) * (1 + d10) * (1 + d11) * (1 + d12) * (1 + d13) * (1 + d14) * (1 + d15) * (1 + d16);
# 32 monomials, the first is gx ux v1y vy w1z wz
way3 = (1 + d1) * (1 + d2) * (1 + d3) * (1 + d4) * (1 + d5) * (1 + d6) * (1 + d7) * (1 + d8) * (1 + d9) * (1 + d10) * (1 + d11) * (1 + d12) * (1 + d13) * (1 + d14) * (1 + d15) * (1 + d16) * (1 + d17);
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
  last in [-1b-52, 1b-52] /\
  e1 in [-1b-52, 1b-52] /\
  e2 in [-1b-52, 1b-52]
-> |up(x) -/ x| <= 1b-52 /\ |up(y) - y| <= 1b-1074 /\
   |down(x) -/ x| <= 1b-52 /\ |down(y) - y| <= 1b-1074 /\
   |toward_zero(x) -/ x| <= 1b-52 /\ |toward_zero(y) - y| <= 1b-1074 /\
   36 * |way1 - 1| * (1 + last) - kRel * (sum1 * (1 + e1) * (1 + e2)) <= 0 /\
   36 * |way2 - 1| * (1 + last) - kRel * (sum1 * (1 + e1) * (1 + e2)) <= 0 /\
   36 * |way3 - 1| * (1 + last) - kRel * (sum1 * (1 + e1) * (1 + e2)) <= 0 }
