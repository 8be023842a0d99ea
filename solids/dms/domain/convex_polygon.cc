// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/domain/convex_polygon.h"

#include <numeric>

#include "predicates/implicit_predicates.h"
#include "robust/base/check.h"

namespace veritope {
namespace {

class Polygon {
 public:
  explicit Polygon(std::span<const AnyPoint3> corners) : corners_(corners) {
    left_.resize(corners.size());
    std::iota(left_.begin(), left_.end(), 0u);
    // An axis along which the polygon's shadow has an area.
    const auto has_area = [this] { return num_turns() > 0; };
    while (axis_ < 2 && !has_area()) ++axis_;
    VT_CHECK(has_area(), "the corners of a convex polygon are not on a line");
  }

  std::size_t size() const { return left_.size(); }
  std::uint32_t operator[](std::size_t i) const { return left_[i % size()]; }
  /// Whether the angle at place i is less than 180 degrees.
  bool turns(std::size_t i) const {
    const std::size_t n = size();
    return orient2d_projected(corners_[left_[(i + n - 1) % n]], corners_[left_[i % n]],
                              corners_[left_[(i + 1) % n]], axis_) != Sign::kZero;
  }
  std::size_t num_turns() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < size(); ++i) count += turns(i) ? 1 : 0;
    return count;
  }
  /// Whether no two other neighbouring corners are on a line with corner i.
  bool is_hub(std::size_t i) const { return turns(i + 1) && turns(i + size() - 1); }
  void remove(std::size_t i) { left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i)); }

 private:
  std::span<const AnyPoint3> corners_;
  std::vector<std::uint32_t> left_;
  int axis_ = 0;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate_convex(std::span<const AnyPoint3> corners,
                                                             std::span<const std::uint32_t> ranks) {
  std::vector<std::array<std::uint32_t, 3>> out;
  if (corners.size() == 3) return {{0, 1, 2}};
  Polygon polygon(corners);
  const std::size_t n = corners.size();
  std::size_t hub = n;
  for (std::size_t i = 0; i < n; ++i)
    if ((hub == n || ranks[i] < ranks[hub]) && polygon.is_hub(i)) hub = i;
  if (hub != n) {
    for (std::size_t i = 1; i + 1 < n; ++i)
      out.push_back({polygon[hub], polygon[hub + i], polygon[hub + i + 1]});
    return out;
  }
  while (polygon.size() > 3) {
    std::size_t ear = 0;
    for (;; ++ear) {
      VT_CHECK(ear < polygon.size(), "a convex polygon has an ear that leaves an area");
      if (!polygon.turns(ear)) continue;
      Polygon rest = polygon;
      rest.remove(ear);
      if (rest.num_turns() >= 3) break;
    }
    out.push_back({polygon[ear + polygon.size() - 1], polygon[ear], polygon[ear + 1]});
    polygon.remove(ear);
  }
  out.push_back({polygon[0], polygon[1], polygon[2]});
  return out;
}

}  // namespace veritope
