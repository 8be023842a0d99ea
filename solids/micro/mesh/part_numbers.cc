// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>

#include "solids/micro/mesh/part_numbers_internal.h"

namespace veritope::internal {

PartNumbers::PartNumbers(const CapLinks& links, const std::vector<AnalysedTile>& tiles) {
  first_.push_back(0);
  for (const MeshKind& k : links.kinds)
    first_.push_back(first_.back() + tiles[k.tile].surface.num_patches());
  classes_ = DisjointSets<>(2 * num_patches());
  const auto of_side = [&](std::uint32_t kind, std::uint32_t side) {
    return element(number(kind, side / kTileSides), side % 2);
  };
  for (std::uint32_t k = 0; k < links.kinds.size(); ++k) {
    const std::vector<std::uint32_t>& mates = tiles[links.kinds[k].tile].surface.mates;
    for (std::uint32_t side = 0; side < mates.size(); ++side)
      if (mates[side] != TileSurface::kCollapsed)
        classes_.join(of_side(k, side), of_side(k, mates[side]));
  }
  for (const SharedRim& rim : links.rims)
    for (const SharedSide& s : rim.sides)
      classes_.join(of_side(rim.owner_kind, s.owner), of_side(rim.user_kind, s.user));
  parts_.assign(classes_.size(), 1);
  for (std::uint32_t k = 0; k < links.kinds.size(); ++k) {
    const TileSurface& surface = tiles[links.kinds[k].tile].surface;
    for (std::size_t p = 0; p < surface.num_patches(); ++p)
      for (const std::size_t axis : {std::size_t{0}, std::size_t{1}})
        if (surface.is_collapsed(p, axis) && surface.is_collapsed(p, axis + 2))
          parts_[classes_.find(element(number(k, p), 1 - axis))] = 2;
  }
}

void PartNumbers::raise(std::size_t number) {
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}})
    ++parts_[classes_.find(element(number, axis))];
}

bool PartNumbers::raise_for(const std::vector<PatchError>& errors, double chord) {
  for (std::size_t p = 0; p < errors.size(); ++p) {
    std::array<std::uint32_t*, 2> parts;
    for (std::size_t axis = 0; axis < 2; ++axis)
      parts[axis] = &parts_[classes_.find(element(p, axis))];
    for (;;) {
      const double m = *parts[0], n = *parts[1];
      const double along_u = errors[p].along[0] / (m * m), along_v = errors[p].along[1] / (n * n),
                   twist = errors[p].twist / (m * n);
      if (along_u + along_v + twist <= chord) break;
      const bool raises_v = along_v + (n < m ? twist : 0) > along_u + (n < m ? 0 : twist);
      std::uint32_t& part = *parts[raises_v ? 1 : 0];
      part += std::max(1u, part / 16);
      if (part > kMost) return false;
    }
  }
  return true;
}

}  // namespace veritope::internal
