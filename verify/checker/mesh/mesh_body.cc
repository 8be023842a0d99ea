// SPDX-License-Identifier: Apache-2.0 OR MIT
// mesh_body.cc: B1 of docs/certificates/mesh.md, section 3, and of docs/certificates/mesh-reversed.md.
#include "mesh_body.h"

namespace {

std::vector<bool> reversed_triangles(uint32_t faces, Body* body) {
  const uint64_t bytes = (uint64_t(faces) + 7) / 8;
  require(bytes <= body->left(), "B1", "too few bytes for the reversed triangles, bytes", bytes);
  std::vector<bool> r;
  for (uint64_t i = 0; i < bytes; ++i) {
    const uint64_t bits = body->natural(1);
    for (int k = 0; k < 8; ++k) {
      const bool is_set = (bits >> k & 1) != 0;
      if (r.size() < faces)
        r.push_back(is_set);
      else
        require(!is_set, "B1", "there is no triangle to reverse,", 8 * i + uint64_t(k));
    }
  }
  return r;
}

}  // namespace

ValidBody read_valid_body(const MeshKind& kind, Body body, Model* model) {
  ValidBody r;
  const uint32_t faces = model->faces(), vertices = model->vertices();
  require(body.begins_with(kind.magic.c_str()), "B1",
          ("the body does not start with " + kind.magic).c_str());
  require(body.natural(4) == faces, "B1", "the model's number of triangles is", faces);
  require(body.natural(4) == vertices, "B1", "the model's number of vertices is", vertices);
  if (kind.has_reversed) r.reversed = reversed_triangles(faces, &body);
  for (uint32_t i = 0; i < faces; ++i) r.order.push_back(uint32_t(body.natural(4)));
  for (uint32_t v = 0; v < vertices; ++v) {
    r.star.push_back(uint8_t(body.natural(1)));
    require(r.star[v] <= 14, "B1", "unknown star code at vertex", v);
  }
  const uint64_t vectors = body.count(12);
  require(vectors == uint64_t(std::count(r.star.begin(), r.star.end(), 14)), "B1",
          "not one star vector for each code 14, but", vectors);
  for (uint64_t i = 0; i < vectors; ++i) {
    int32_t d[3];
    for (int32_t& x : d) x = int32_t(body.natural(4));
    r.vector.push_back(direction(d[0], d[1], d[2]));
  }
  const uint64_t separators = body.count(4);
  for (uint64_t i = 0; i < separators; ++i) {
    const uint64_t gap = body.varint();
    int64_t d[3];
    for (int64_t& x : d) {
      const uint64_t z = body.varint();
      require(z < 0xffffffff, "B1", "a component is not below 2^31: separator", i);
      x = z % 2 == 0 ? int64_t(z / 2) : -int64_t(z / 2) - 1;
    }
    r.separator.push_back(PairSeparator{gap, direction(d[0], d[1], d[2])});
  }
  const uint64_t codes = body.count(1);
  r.code.assign(body.p, body.p + codes);
  r.nesting.assign(body.p + codes, body.end);
  for (size_t f = 0; f < r.reversed.size(); ++f)
    if (r.reversed[f]) std::swap(model->tri[3 * f + 1], model->tri[3 * f + 2]);
  return r;
}

void check_nesting_codes(const std::vector<uint8_t>& nesting, uint32_t shells) {
  require(nesting.size() == (shells > 1 ? shells : 0), "B1",
          "not one byte a shell behind the axis codes, but", nesting.size());
  for (uint8_t code : nesting) require(code <= 5, "B1", "unknown nesting code", code);
}
