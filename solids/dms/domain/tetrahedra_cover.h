// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/domain/tetrahedra_cover.h: which of many tetrahedra contains a point, exactly.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "predicates/exact_point.h"
#include "solids/base/box_hierarchy.h"
#include "topology/tetrahedral_complex.h"

namespace veritope {

class TetrahedraCover {
 public:
  /// The points must outlive it. REQUIRES positive tetrahedra.
  TetrahedraCover(std::span<const ExactPoint3> points, std::vector<TetrahedronCorners> tetrahedra);

  /// The least number of a closed tetrahedron that contains p; nothing if none does.
  std::optional<std::uint32_t> find(const ExactPoint3& p) const;
  bool contains(const ExactPoint3& p) const { return find(p).has_value(); }

 private:
  bool is_in(std::uint32_t t, const ExactPoint3& p) const;

  std::span<const ExactPoint3> points_;
  std::vector<TetrahedronCorners> tetrahedra_;
  BoxHierarchy boxes_;
};

}  // namespace veritope
