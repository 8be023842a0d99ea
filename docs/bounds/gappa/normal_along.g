# SPDX-License-Identifier: LGPL-3.0-or-later
# normal_along: kRel pays for the roundings of every monomial. What that proves: README.md.
# Made by tools/generate_predicates.py from docs/bounds/gappa/normal_along.formula: do not edit.
@rnd = float<ieee_64, ne>;
kRel = 0x1.800000000000ap-51;
# 2 monomials, the first is d_z ux vy
way1 = (1 + d1) * (1 + d2) * (1 + d3) * (1 + d4) * (1 + d5);
sum1 = (1 + s1) * (1 + s2) * (1 + s3) * (1 + s4) * (1 + s5) * (1 + s6);
# 4 monomials, the first is d_x uy vz
way2 = (1 + d1) * (1 + d2) * (1 + d3) * (1 + d4) * (1 + d5) * (1 + d6);
sum2 = (1 + s1) * (1 + s2) * (1 + s3) * (1 + s4) * (1 + s5) * (1 + s6) * (1 + s7);
{ |x| in [1b-1021, 1b1023] /\ |y| <= 1b-1021 /\
  d1 in [-1b-53, 1b-53] /\
  d2 in [-1b-53, 1b-53] /\
  d3 in [-1b-53, 1b-53] /\
  d4 in [-1b-53, 1b-53] /\
  d5 in [-1b-53, 1b-53] /\
  d6 in [-1b-53, 1b-53] /\
  s1 in [-1b-53, 1b-53] /\
  s2 in [-1b-53, 1b-53] /\
  s3 in [-1b-53, 1b-53] /\
  s4 in [-1b-53, 1b-53] /\
  s5 in [-1b-53, 1b-53] /\
  s6 in [-1b-53, 1b-53] /\
  s7 in [-1b-53, 1b-53] /\
  last in [-1b-53, 1b-53] /\
  e1 in [-1b-53, 1b-53] /\
  e2 in [-1b-53, 1b-53]
-> |rnd(x) -/ x| <= 1b-53 /\ |rnd(y) - y| <= 1b-1075 /\
   1 * |way1 - 1| * (1 + last) - kRel * (sum1 * (1 + e1) * (1 + e2)) <= 0 /\
   1 * |way2 - 1| * (1 + last) - kRel * (sum2 * (1 + e1) * (1 + e2)) <= 0 }
