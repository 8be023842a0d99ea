// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_compose.h: the signs of separators on nodes, docs/certificates/star-box-2.md, section 4.
#pragma once
#include "star_node.h"

// x - o and w of each control point of a node, homogeneous, times the binomials of its place, and all divided by a
// common power of two.
struct LocalNet {
  Shape shape;
  Block numbers;
  int bits;  // of the longest number
};
LocalNet local_net(const Patch& p, const Node& node, const int64_t* o);

// The coefficients of W^d q(F / W) in Bernstein's basis times the binomials of their places. The net's o is that of q.
Block composed(const Separator& q, const LocalNet& net);
// The sign of all numbers; 0 if they differ or one is 0.
int sign_of(const Block& b);
