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
struct MeshKind {  // what differs between bodies about solids
  std::string magic;
  bool as_indexed, has_reversed;  // has_reversed: mesh-reversed-1
};
// B1, except the number of nesting codes. Reverses the triangles of the model that the body lists.
ValidBody read_valid_body(const MeshKind& kind, Body body, Model* model);
// The rest of B1.
void check_nesting_codes(const std::vector<uint8_t>& nesting, uint32_t shells);

struct SolidMesh {
  std::vector<std::pair<const char*, uint64_t>> numbers;  // of V11, by the statement's keys
  std::string volume;
  std::vector<uint32_t> shell;  // of each triangle
  std::vector<uint64_t> depth;  // of each shell
};
// The conditions from B1 to V10, and R1, for a body about the model.
SolidMesh check_solid(const MeshKind& kind, Model* model, const Body& bytes);
