// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fast/fast_region_internal.h: what is evaluated at the points inside of one tetrahedron: the units of all
// tetrahedra whose sets of knots may reach into it.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "solids/dms/fast/fast_tables_internal.h"
#include "topology/tetrahedral_complex.h"

namespace veritope::internal {

/// The barycentric coordinates of a tetrahedron's corners, in the place of its box.
struct FastCell {
  FastPlace place;
  FastFrame frame;
  std::array<Point3d, 4> corners;  ///< rounded
  Box3d box;                       ///< around the corners, the least one with binary64 bounds
  FastSide side{};                 ///< the same for the kernels
};

/// Not copied or moved: `unit` has pointers into the other members and into the tables.
struct FastRegionUnit {
  std::vector<std::uint32_t> leaf_ids, frame_ids;
  std::vector<FastNode> nodes;
  std::vector<FastTop> tops;
  FastUnit unit{};
  const FastTables* tables = nullptr;
  std::array<double, 4>
      high{};  ///< no point with a greater barycentric coordinate is in the hull of its knots
  Box3d box;   ///< nor any point outside of this box
  bool is_own = false;
};

struct FastRegion {
  std::vector<std::unique_ptr<FastRegionUnit>>
      units;                 ///< that of the tetrahedron itself is the first one
  std::size_t num_tops = 0;  ///< of all units
  std::size_t scratch = 0;   ///< the most that a unit needs
  std::size_t bytes() const;
};

/// The unit of the tables' tetrahedron on the inside of a cell, which has the corners `of_cell`; null if no set of
/// knots reaches into it. The tables must outlive it.
std::unique_ptr<FastRegionUnit> make_fast_unit(const FastTables& tables,
                                               const TetrahedronCorners& corners,
                                               const FastCell& cell,
                                               const TetrahedronCorners& of_cell,
                                               std::size_t components);

}  // namespace veritope::internal
