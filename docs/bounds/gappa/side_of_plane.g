# SPDX-License-Identifier: LGPL-3.0-or-later
# side_of_plane: kRel pays for the roundings of every monomial. What that proves: README.md.
# Made by tools/generate_predicates.py from docs/bounds/gappa/side_of_plane.formula: do not edit.
@rnd = float<ieee_64, ne>;
kRel = 0x1.8000000000007p-52;
# 1 monomial, the first is k
way1 = 1;
sum1 = (1 + s1);
# 1 monomial, the first is n_z p_z
way2 = (1 + d1) * (1 + d2);
sum2 = (1 + s1) * (1 + s2) * (1 + s3);
# 2 monomials, the first is n_x p_x
way3 = (1 + d1) * (1 + d2) * (1 + d3);
sum3 = (1 + s1) * (1 + s2) * (1 + s3) * (1 + s4);
{ |x| in [1b-1021, 1b1023] /\ |y| <= 1b-1021 /\
  d1 in [-1b-53, 1b-53] /\
  d2 in [-1b-53, 1b-53] /\
  d3 in [-1b-53, 1b-53] /\
  s1 in [-1b-53, 1b-53] /\
  s2 in [-1b-53, 1b-53] /\
  s3 in [-1b-53, 1b-53] /\
  s4 in [-1b-53, 1b-53] /\
  last in [-1b-53, 1b-53] /\
  e1 in [-1b-53, 1b-53] /\
  e2 in [-1b-53, 1b-53]
-> |rnd(x) -/ x| <= 1b-53 /\ |rnd(y) - y| <= 1b-1075 /\
   1 * |way1 - 1| * (1 + last) - kRel * (sum1 * (1 + e1) * (1 + e2)) <= 0 /\
   1 * |way2 - 1| * (1 + last) - kRel * (sum2 * (1 + e1) * (1 + e2)) <= 0 /\
   1 * |way3 - 1| * (1 + last) - kRel * (sum3 * (1 + e1) * (1 + e2)) <= 0 }
