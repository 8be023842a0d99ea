// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/predicates/triangle_triangle_oracle.h: the classification of triangle_triangle, read off
// the clipped polygon.
#pragma once
#include <cstdint>

#include "predicates/triangle_triangle.h"
#include "tests/predicates/clip_oracle.h"

namespace veritope::oracle {

using Ids = std::array<std::uint32_t, 3>;

inline TriangleContact classify(const ITriangle& t, const Ids& ti, const ITriangle& u,
                                const Ids& ui) {
  std::vector<IPoint> common;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (ti[i] == ui[j]) common.push_back(t[i]);
    }
  }
  if (common.size() == 3) return TriangleContact::kIdentical;
  const std::vector<HPoint> meet = intersection(t, u);
  bool outside = false;
  for (const HPoint& p : meet) {
    if (common.empty()) {
      outside = true;
    } else if (common.size() == 1) {
      outside = outside || !on_segment(p, common[0], common[0]);
    } else {
      outside = outside || !on_segment(p, common[0], common[1]);
    }
  }
  if (outside)
    return coplanar(t, u) ? TriangleContact::kCoplanarOverlap : TriangleContact::kImproper;
  return common.empty()
             ? TriangleContact::kDisjoint
             : (common.size() == 1 ? TriangleContact::kSharedVertex : TriangleContact::kSharedEdge);
}

inline IndexedTriangle indexed(const ITriangle& t, const Ids& ids) {
  IndexedTriangle out;
  for (int i = 0; i < 3; ++i) {
    out.point[i] = {static_cast<double>(t[i][0]), static_cast<double>(t[i][1]),
                    static_cast<double>(t[i][2])};
    out.id[i] = ids[i];
  }
  return out;
}

/// Every way to name the corners of u, given t with ids 0, 1, 2: a corner of u that has the place
/// of a corner of t gets its id or a new one. REQUIRES the corners of each triangle distinct.
template <typename Visit>
void for_all_names(const ITriangle& t, const ITriangle& u, Visit visit) {
  std::array<int, 3> match{-1, -1, -1};
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      if (u[j] == t[i]) match[j] = i;
    }
  }
  for (unsigned mask = 0; mask < 8; ++mask) {
    Ids ids{3, 4, 5};
    bool possible = true;
    for (int j = 0; j < 3; ++j) {
      if ((mask >> j & 1) == 0) continue;
      if (match[j] < 0) possible = false;
      ids[j] = static_cast<std::uint32_t>(match[j]);
    }
    if (possible) visit(ids);
  }
}

}  // namespace veritope::oracle
