// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/cage_support.h: what the tests of cages share: small contents, and what certify says of cells.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "io/read_model.h"
#include "io/splines/write_splines.h"
#include "io/trees/build_tree.h"
#include "solids/micro/cage/cage_content.h"
#include "solids/vmodel/v_model.h"
#include "splines/de_boor.h"
#include "verify/certify/certify.h"

namespace veritope::cage_test {

inline Rational q(std::int64_t p, std::int64_t r = 1) { return Rational(Integer(p), Integer(r)); }
inline CellPoint at(Rational x, Rational y, Rational z) {
  return {std::move(x), std::move(y), std::move(z)};
}

/// One part with these corners.
inline CageContent hull_of(std::vector<CellPoint> points) {
  CageContent out;
  for (std::uint32_t i = 0; i < points.size(); ++i) out.corners.push_back(i);
  out.ends = {points.size()};
  out.points = std::move(points);
  return out;
}

/// The box as twelve triangles, normals outwards.
inline TriangleMesh box_mesh(Vec3d lo, Vec3d hi) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back(
        {(i & 1) != 0 ? hi.x : lo.x, (i & 2) != 0 ? hi.y : lo.y, (i & 4) != 0 ? hi.z : lo.z});
  mesh.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// Both meshes in one.
inline TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
  const auto first = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const auto& f : b.faces) a.faces.push_back({f[0] + first, f[1] + first, f[2] + first});
  return a;
}

inline CellPoint image(const CellVolume& cell, const std::array<Rational, 3>& parameters) {
  const auto p = point(cell, parameters).value();
  return {p[0], p[1], p[2]};
}

inline VModel model_of(std::vector<CellVolume> cells) {
  return make_v_model(std::move(cells), VOrientation::kKeep).value();
}

inline Certified certified(const std::vector<CellVolume>& cells) {
  const std::string bytes = spline_json_bytes(model_of_cells(cells));
  return certify(
             read_model_bytes({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()},
                              "cage.vjson", {})
                 .value())
      .value();
}

}  // namespace veritope::cage_test
