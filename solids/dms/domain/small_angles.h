// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/domain/small_angles.h: where facets and segments of a domain's boundary enclose less than 60 degrees: no
// refinement makes tetrahedra there as round as elsewhere.
// Source: [She98].
#pragma once
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "solids/dms/domain/refine_mesh.h"

namespace veritope {

struct SmallAngle {
  bool is_dihedral = false;
  /// Two segments: an end, the vertex in which they meet, an end. Two facets: the ends of their segment.
  std::vector<std::uint32_t> vertices;
  double degrees = 0;  ///< rounded
};

/// Decided exactly, once, at the segments of a mesh into which nothing was inserted yet.
class SmallAngles {
 public:
  explicit SmallAngles(const RefineMesh& mesh);

  /// Those of two segments at a vertex, then those of two facets inside of the domain.
  const std::vector<SmallAngle>& list() const { return list_; }
  /// Whether two segments enclose a small angle at the vertex.
  bool is_apex(std::uint32_t v) const { return apexes_.contains(v); }
  /// Whether the vertices lie on two segments, or on two facets, that enclose a small angle: then the edge between them
  /// is as short as the angle makes it. @param mesh  the one of the constructor, with what was inserted since
  bool is_between(const RefineMesh& mesh, std::uint32_t v, std::uint32_t w) const;

 private:
  using Line = FacetPair;
  void add_segments(const RefineMesh& mesh);
  void add_facets(const RefineMesh& mesh);

  std::vector<SmallAngle> list_;
  std::set<std::uint32_t> apexes_;
  std::set<std::pair<Line, Line>> lines_;
  std::set<FacetPair> facets_;
};

}  // namespace veritope
