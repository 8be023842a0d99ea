// SPDX-License-Identifier: Apache-2.0 OR MIT
// mesh_body.h: the bodies of mesh-valid-1 and mesh-reversed-1.
#pragma once
#include "geometry.h"

inline Vec<1> direction(int64_t x, int64_t y, int64_t z) {
  return Vec<1>{{fixed<1>(x), fixed<1>(y), fixed<1>(z)}};
}

struct PairSeparator {
  uint64_t gap;
  Vec<1> d;
};
struct ValidBody {
  std::vector<bool> reversed;  // for each triangle; empty in mesh-valid-1
  std::vector<uint32_t> order;
  std::vector<uint8_t> star, code, nesting;
  std::vector<Vec<1>> vector;
  std::vector<PairSeparator> separator;

  uint64_t num_reversed() const {
    return uint64_t(std::count(reversed.begin(), reversed.end(), true));
  }
};
// B1, except the number of nesting codes. Reverses the triangles of the model that the body lists.
ValidBody read_valid_body(const Statement& statement, Body body, Model* model);
// The rest of B1.
void check_nesting_codes(const std::vector<uint8_t>& nesting, uint32_t shells);
