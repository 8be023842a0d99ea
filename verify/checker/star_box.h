// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_box.h: what is decided in one box, and the walks.
#pragma once
#include "star_forest.h"

struct Piece {  // a tested node
  const Patch* patch;
  Node* node;
};
// C3: REQUIRES that S1 holds on the pieces and that they are all that meet the box.
int64_t crossing_number(const std::vector<Piece>& pieces, const Box& b, Units* units);
// C4: the closed triangle and the closed box have no common point.
bool triangle_misses(const Patch& p, const Node& node, const Box& b);
// C4: no normal is 0, and any two triangles meet exactly in their common face in X.
bool meet_properly(const std::vector<Piece>& pieces, Units* units);
// W1 and W2; the number of bodies.
uint64_t check_walks(const StarBody& body, uint32_t components, Forest* forest, Units* units);
