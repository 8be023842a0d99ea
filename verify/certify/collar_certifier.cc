// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/collar_certifier.h"

#include <cmath>
#include <utility>

#include "robust/base/check.h"
#include "verify/certify/file_order.h"

namespace veritope {
namespace {

using certificate::CollarBody;
using certificate::WalkPoint;
using Id = PieceForest::Id;

class CollarBodyWriter {
 public:
  CollarBodyWriter(const PieceForest& forest, const StarCover& cover, const PatchCollar& collar,
                   const std::vector<StarBoxEntity>& entities)
      : forest_(forest), cover_(cover), collar_(collar), entities_(entities) {}

  CollarBody write(const ShellWalks& walks) {
    const int unit = std::ilogb(collar_.root.unit);
    body_.star = make_star_box_body(forest_, cover_, walks, entities_, unit);
    body_.shift = static_cast<std::uint64_t>(unit - forest_.scale() - body_.star.exponent);
    // Multiples of the unit of less than 2^52 units: exact.
    for (std::size_t k = 0; k < 3; ++k)
      body_.corner[k] = static_cast<std::int64_t>(collar_.root.corner[k] / collar_.root.unit);
    for (const OctreeKey key : collar_.complex.cells().keys()) body_.cells.push_back(key.code());
    const ComplexBoundary& boundary = collar_.collar.boundary;
    for (std::uint32_t k = 0; k < boundary.components.size(); ++k)
      body_.sides.push_back(collar_.collar.bodies[boundary.components[k].body].d_plus == k ? 1 : 0);
    for (const Collapse& step : collar_.collar.collapses.cells)
      body_.collapses.push_back(step.face);
    VT_CHECK(body_.collapses.size() == body_.cells.size(), "every cell of a collar is collapsed");
    write_leaves();
    for (const Shore& shore : collar_.shores) write_shore(shore);
    return std::move(body_);
  }

 private:
  void write_leaves() {
    const std::vector<bool> is_reversed = reversed_patches(entities_, forest_.num_patches());
    for (std::uint32_t p = 0; p < forest_.num_patches(); ++p)
      FileOrder(forest_).for_each_root(
          p, is_reversed[p], [](const auto&) {},
          [&](Id root) { visit(root, false, is_reversed[p]); });
  }
  void visit(Id id, bool is_below_leaf, bool is_reversed) {
    is_below_leaf = is_below_leaf || cover_.box_of_node[id] != StarCover::kNone;
    const bool is_leaf = is_below_leaf && collar_.place.is_leaf[id];
    if (is_below_leaf) body_.leaves.push_back(is_leaf ? 1 : 0);
    if (!is_leaf)
      FileOrder(forest_).for_each_child(
          id, is_reversed, [&](Id child) { visit(child, is_below_leaf, is_reversed); });
  }
  void write_shore(const Shore& shore) {
    certificate::WalkPath out{{}, shore.direction, shore.end_box, shore.ends_outside};
    for (const std::uint32_t v : shore.vertices) {
      WalkPoint point{body_.shift, body_.corner};
      const auto at = collar_.complex.point(v);
      for (std::size_t k = 0; k < 3; ++k) point.at[k] += at[k];
      out.points.push_back(point);
    }
    body_.shores.push_back(std::move(out));
  }

  const PieceForest& forest_;
  const StarCover& cover_;
  const PatchCollar& collar_;
  const std::vector<StarBoxEntity>& entities_;
  CollarBody body_;
};

}  // namespace

bool fits_certificate(const PieceForest& forest, const StarCover& cover,
                      const PatchCollar& collar) {
  const double unit = least_unit_of_boxes(forest, cover, collar.root.unit);
  const double most = std::ldexp(unit, 60);  // the C++ checker's 2^61, minus one bit for sums
  for (const double corner : collar.root.corner)
    if (!(std::abs(corner) < most && std::abs(corner + collar.root.edge()) < most)) return false;
  return true;
}

certificate::Bytes make_collar_certificate(const PieceForest& forest, const StarCover& cover,
                                           const ShellWalks& walks, const PatchCollar& collar,
                                           const std::vector<StarBoxEntity>& entities,
                                           const certificate::Subject& subject) {
  return certificate::encode(subject, star_box_quantities(forest.complex(), walks),
                             CollarBodyWriter(forest, cover, collar, entities).write(walks));
}

}  // namespace veritope
