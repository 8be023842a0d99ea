// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/zero_search.h"

#include <algorithm>

#include "solids/star_box/star_zeros.h"
#include "verify/certify/grid_box.h"
#include "verify/certify/half_spaces.h"

namespace veritope {
namespace {

using Id = PieceForest::Id;

constexpr std::size_t kMostPiecesWithZeros = 512;
// The least depth of centres in the half-spaces that can be met with a margin, in sizes of the box.
constexpr double kLeastDepthAtZeros = 1e-3;
// Centres are rounded to units of boxes divided by these: coarse ones lie on planes of symmetry.
constexpr double kFiner[] = {1, 0x1p-4, 0x1p-8};

}  // namespace

bool ZeroSearch::try_piece(Id id) {
  const Box3d hull = forest_.node(id).hull;
  if (!(extent(hull) > 0) || !(extent(hull) < 8) || !touches_side(id)) return false;
  box_ = cube_around(approx_centre(hull), 0.5 * options_.growth * extent(hull));
  const Box3d& box = box_.star.box;
  if (!is_inside(hull, box)) return false;
  // The piece alone decides cheaply where it bends too much.
  if (!solve({id})) return false;
  near_.clear(), held_.clear();
  if (!find_pieces(forest_, box, 0.5 * extent(box), kMostPiecesWithZeros, &near_, &held_))
    return false;
  if (!solve(near_) || !has_zeros_) return false;
  const double unit = box_.unit;
  for (const double finer : kFiner)
    if (prove(unit * finer)) {
      held_.push_back(id);
      return true;
    }
  return false;
}

bool ZeroSearch::touches_side(Id id) const {
  const PieceForest::Node& node = forest_.node(id);
  const std::uint32_t n = forest_.form(node.patch).shape.is_triangle ? 3 : 4;
  for (std::uint32_t corner = 0; corner < n; ++corner)
    for (std::uint32_t side = 0; side < n; ++side)
      if (forest_.is_on_side(node, corner, side)) return true;
  return false;
}

// Centres that the pieces allow, if coefficients may be zero. A coefficient that does not depend on the centre is zero,
// or the proof fails.
bool ZeroSearch::solve(const std::vector<Id>& pieces) {
  const Box3d& box = box_.star.box;
  const Point3d m = approx_centre(box);
  Point3d scale;
  scale.fill(extent(box));
  Box3d room;
  for (std::size_t k = 0; k < 3; ++k) {
    room.lo[k] = (box.lo[k] + 2 * box_.unit - m[k]) / scale[k];
    room.hi[k] = (box.hi[k] - 2 * box_.unit - m[k]) / scale[k];
  }
  half_spaces_.clear();
  for (const Id id : pieces)
    append_half_spaces(forest_, id, {m, scale}, ~std::size_t{0}, &half_spaces_);
  has_zeros_ = std::erase_if(half_spaces_, [](const HalfSpace& h) {
                 return h.a[0] == 0 && h.a[1] == 0 && h.a[2] == 0;
               }) > 0;
  for (const bool is_outside : {false, true}) {
    const auto deepest = deepest_point_or_zeros(half_spaces_, room, kLeastDepthAtZeros);
    if (!deepest) return false;
    has_zeros_ = has_zeros_ || deepest->has_zeros;
    Point3d& c = is_outside ? outside_ : inside_;
    for (std::size_t k = 0; k < 3; ++k) c[k] = m[k] + scale[k] * deepest->point[k];
    for (HalfSpace& h : half_spaces_) h = {{-h.a[0], -h.a[1], -h.a[2]}, -h.b};
  }
  return true;
}

// S1 on all pieces near the box, and S2, for centres on this grid.
bool ZeroSearch::prove(double unit) {
  if (unit < options_.least_unit) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    box_.star.inside[k] = on_grid(inside_[k], unit);
    box_.star.outside[k] = on_grid(outside_[k], unit);
  }
  const CentreLine centres{box_.star.inside, box_.star.outside};
  if (centres.inside == centres.outside) return false;
  const auto has_signs = [&](Id id) { return has_star_signs_or_zeros(forest_, id, centres); };
  if (!std::all_of(near_.begin(), near_.end(), has_signs)) return false;
  if (crossing_number(forest_, near_, centres) != 1) return false;
  box_.unit = unit;
  box_.needs_version_2 = true;
  return true;
}

}  // namespace veritope
