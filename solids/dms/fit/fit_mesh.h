// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fit/fit_mesh.h: tetrahedra that are cut at the midpoints of edges. The domain stays the same set.
// Source: longest-edge bisection; all tetrahedra at an edge are cut at once, so no face is left unmatched.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "solids/dms/dms_model.h"

namespace veritope {

class FitMesh {
 public:
  /// REQUIRES the tetrahedra of a domain without defects.
  FitMesh(std::vector<DmsPoint> vertices, std::vector<TetrahedronCorners> tetrahedra);

  const std::vector<DmsPoint>& vertices() const { return vertices_; }
  const std::vector<TetrahedronCorners>& tetrahedra() const { return tetrahedra_; }

  /// Cuts the longest edge of the tetrahedron, after longer ones of the tetrahedra that share it. A tetrahedron keeps
  /// its number for one half. False, with some cuts made perhaps, if there would be more than `most` tetrahedra.
  bool refine(std::uint32_t tetrahedron, std::size_t most);

 private:
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  struct Length {
    double square = 0;
    Edge edge;  // a tie is broken by the vertices
    friend bool operator<(const Length& a, const Length& b) {
      return a.square != b.square ? a.square < b.square : a.edge < b.edge;
    }
  };
  Length length(std::uint32_t a, std::uint32_t b) const;
  Length longest(std::uint32_t tetrahedron) const;
  std::vector<std::uint32_t> tetrahedra_at(const Edge& edge) const;
  bool cut(const Length& edge, std::size_t most);
  void halve(const Edge& edge, const std::vector<std::uint32_t>& tetrahedra);

  std::vector<DmsPoint> vertices_;
  std::vector<std::array<double, 3>> rounded_;
  std::vector<TetrahedronCorners> tetrahedra_;
  std::vector<std::vector<std::uint32_t>> at_vertex_;
};

}  // namespace veritope
