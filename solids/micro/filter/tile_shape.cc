// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/filter/tile_shape.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "interval/upward.h"

namespace veritope {

namespace {

Error bad_tile_patch(std::size_t number, const std::string& why) {
  return bad_argument("patch " + std::to_string(number) + " of the tile " + why);
}

Status check_tile_patch(const TileShape::Surface& patch, std::size_t number, bool is_open) {
  if (patch.is_rational()) return bad_tile_patch(number, "is rational; tiles are polynomial");
  if (patch.num_components() != 3)
    return bad_tile_patch(number, "has " + std::to_string(patch.num_components()) +
                                      " coordinates; a tile lies in space");
  for (std::size_t a = 0; a < 2; ++a)
    if (const int degree = patch.degree(a);
        degree < (is_open && a == 1 ? 0 : 1) || degree > kMaxPatchDegree)
      return bad_tile_patch(number,
                            "has the degree " + std::to_string(degree) + "; 1 to 15 are admitted");
  for (const Rational& x : patch.coefficients())
    if (x.sign() == Sign::kNegative || x > Rational(1))
      return bad_tile_patch(number, "has a control point with the coordinate " + x.to_string() +
                                        ", which is not in the unit cube");
  return ok_status();
}

// A bound of the absolute values of the differences of the given order (1 or 2) along an axis, times the factor of the
// derivative. REQUIRES a live ScopedUpward.
double derivative_bound(const BezierSurface<Interval>& patch, int component, std::size_t axis,
                        int order) {
  const int n = patch.degree(axis);
  if (n < order) return 0;
  const auto c = patch.component(component);
  const Grid<2> grid = patch.grid();
  const std::size_t step = grid.stride(axis);
  const Interval factor(static_cast<double>(order == 1 ? n : n * (n - 1)));
  double most = 0;
  grid.for_each_line(axis, [&](std::size_t first) {
    for (std::size_t i = 0; i + static_cast<std::size_t>(order) < grid.size[axis]; ++i) {
      const Interval* const p = c.data() + first + i * step;
      const Interval d = order == 1 ? p[step] - p[0] : (p[2 * step] - p[step]) - (p[step] - p[0]);
      most = std::max(most, mag(factor * d));
    }
  });
  return most;
}

BezierSurface<Interval> enclosed_patch(const TileShape::Surface& patch) {
  std::vector<Interval> c;
  for (const Rational& x : patch.coefficients()) c.push_back(enclose(x));
  return {patch.degrees(), 3, false, std::move(c)};
}

}  // namespace

Result<TileShape> TileShape::make(std::vector<Surface> patches) {
  return make(std::move(patches), false);
}
Result<TileShape> TileShape::make_open(std::vector<Surface> patches) {
  return make(std::move(patches), true);
}

Result<TileShape> TileShape::make(std::vector<Surface> patches, bool is_open) {
  if (patches.empty()) return bad_argument("a tile without patches has no surface");
  for (std::size_t i = 0; i < patches.size(); ++i)
    if (Status status = check_tile_patch(patches[i], i, is_open); !status) return status.error();
  const ScopedUpward upward;
  TileShape out;
  out.is_open_ = is_open;
  std::map<PatchPoint, std::uint32_t> number_of;
  for (Surface& patch : patches) {
    Side side{std::move(patch), BezierSurface<Interval>({1, 1}, 3, false), {}, {}, {}};
    side.enclosed = enclosed_patch(side.exact);
    const Grid<2> grid = side.exact.grid();
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t at =
          grid.at({(i & 1) != 0 ? grid.size[0] - 1 : 0, (i & 2) != 0 ? grid.size[1] - 1 : 0});
      const PatchPoint p{side.exact.component(0)[at], side.exact.component(1)[at],
                         side.exact.component(2)[at]};
      const auto next = static_cast<std::uint32_t>(number_of.size());
      side.corners[i] = number_of.try_emplace(p, next).first->second;
      if (side.corners[i] < out.corners_.size()) continue;
      out.corners_.push_back(Box3(enclose(p[0]), enclose(p[1]), enclose(p[2])));
      out.exact_corners_.push_back(p);
    }
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (std::size_t c = 0; c < 3; ++c) {
        side.first[axis][c] = derivative_bound(side.enclosed, static_cast<int>(c), axis, 1);
        side.second[axis][c] = derivative_bound(side.enclosed, static_cast<int>(c), axis, 2);
      }
    out.patches_.push_back(std::move(side));
  }
  return out;
}

}  // namespace veritope
