// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/collar/octree_root.h"

#include <cmath>

namespace veritope {
namespace {

// Offsets as parts of an eighth of the edge, in units of 2^-17 of that eighth: approximately 1/3, 2/3 and 1/5, and odd.
// Their binary digits have short periods, so that at every level the grid lies at 1/3 or 2/3 of a cell, on the last
// axis at 1/5, 2/5, 3/5 or 4/5.
constexpr double kOffsets[3] = {43691, 87381, 26215};
constexpr double kStep = 1u << 17;

}  // namespace

Result<OctreeRoot> root_around(const Box3d& inner) {
  const double longest = extent(inner);
  const Error refused{Code::kOverLimit,
                      {},
                      "a grid of 2^20 steps around the model does not fit binary64: it is too "
                      "small, or too far from the origin"};
  if (!(longest > 0) || !std::isfinite(longest)) return refused;
  OctreeRoot root;
  // Seven eighths of the edge have room for it: the corner lies up to an eighth below.
  const double edge =
      std::exp2(std::floor(std::log2(longest)) +
                (longest < 0.875 * std::exp2(std::floor(std::log2(longest)) + 1) ? 1 : 2));
  root.unit = edge / OctreeKey::kGrid;
  const double eighth = edge / 8;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(std::abs(inner.lo[k]) + edge < 0x1p51 * root.unit)) return refused;
    const double offset = kOffsets[k] / kStep;
    root.corner[k] = (std::floor(inner.lo[k] / eighth - offset) + offset) * eighth;
    if (root.corner[k] >= inner.lo[k]) root.corner[k] -= eighth;
  }
  if (!(root.unit > 0x1p-1000)) return refused;
  const Box3d box = root.box();
  for (std::size_t k = 0; k < 3; ++k)
    VT_CHECK(box.lo[k] < inner.lo[k] && inner.hi[k] < box.hi[k],
             "the root cube misses a part of the model");
  return root;
}

}  // namespace veritope
