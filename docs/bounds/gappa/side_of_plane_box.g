# SPDX-License-Identifier: LGPL-3.0-or-later
# side_of_plane: the program as it is, on numbers of [0, 1]: at most kRel 4 from the exact value. What that says: README.md.
# Made by tools/generate_predicates.py from docs/bounds/gappa/side_of_plane.formula: do not edit.
@rnd = float<ieee_64, ne>;
n_x = rnd(n_x_);
n_y = rnd(n_y_);
n_z = rnd(n_z_);
k = rnd(k_);
p_x = rnd(p_x_);
p_y = rnd(p_y_);
p_z = rnd(p_z_);
t2 rnd= n_x * p_x;
t5 rnd= n_y * p_y;
t6 rnd= t2 + t5;
t9 rnd= n_z * p_z;
t10 rnd= t6 + t9;
det rnd= t10 + k;
t2_exact = n_x * p_x;
t5_exact = n_y * p_y;
t6_exact = t2_exact + t5_exact;
t9_exact = n_z * p_z;
t10_exact = t6_exact + t9_exact;
det_exact = t10_exact + k;
{ n_x in [0, 1] /\
  n_y in [0, 1] /\
  n_z in [0, 1] /\
  k in [0, 1] /\
  p_x in [0, 1] /\
  p_y in [0, 1] /\
  p_z in [0, 1]
-> |det - det_exact| <= 0x1.8000000000007p-50 }
