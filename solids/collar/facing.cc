// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/collar/facing.h"

#include <array>
#include <cmath>

namespace veritope {
namespace {

constexpr double kLeastCosine = 0.02, kLongestPart = 0.5;

std::array<Point3d, 26> make_directions() {
  std::array<Point3d, 26> out{};
  std::size_t n = 0;
  for (int code = 0; code < 27; ++code) {
    const Point3d d{code % 3 - 1.0, code / 3 % 3 - 1.0, code / 9 - 1.0};
    const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    if (length > 0) out[n++] = {d[0] / length, d[1] / length, d[2] / length};
  }
  return out;
}

}  // namespace

Facing FacingOfPieces::of(PieceForest::Id id) {
  if (known_.size() <= id) known_.resize(forest_.num_nodes(), kUnknown);
  if (known_[id] == kUnknown) known_[id] = compute(id);
  return known_[id];
}

Facing FacingOfPieces::of_part(PieceForest::Id id, const Box3d& box) {
  const Box3d hull = forest_.node(id).hull;
  if (!meets(hull, box)) return kAllDirections;
  if (extent(hull) <= kLongestPart * extent(box) || !forest_.may_split(id)) return of(id);
  const PieceForest::Id first = forest_.children(id);
  Facing out = kAllDirections;
  for (PieceForest::Id k = 0; k < 4 && out != 0; ++k) out &= of_part(first + k, box);
  return out;
}

Facing FacingOfPieces::compute(PieceForest::Id id) {
  static const std::array<Point3d, 26> kDirections = make_directions();
  const PieceForest::Node node = forest_.node(id);
  const std::size_t n = forest_.form(node.patch).determinant.count();
  const double* const g = forest_.approx_determinants(id);
  Facing out = kAllDirections;
  forest_.for_each_kept(node, [&](std::size_t i) {
    // n·(S - c) = G0 + c·(G1, G2, G3): these are minus the normal.
    const Point3d normal{-g[n + i], -g[2 * n + i], -g[3 * n + i]};
    const double least = kLeastCosine * std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] +
                                                  normal[2] * normal[2]);
    for (unsigned d = 0; d < 26; ++d)
      if ((out >> d & 1) != 0 && !(normal[0] * kDirections[d][0] + normal[1] * kDirections[d][1] +
                                       normal[2] * kDirections[d][2] >
                                   least))
        out &= ~(Facing{1} << d);
  });
  return out;
}

}  // namespace veritope
