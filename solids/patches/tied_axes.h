// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/patches/tied_axes.h: classes of axes that must be cut at the same places, in the same direction or reversed.
#pragma once
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace veritope::internal {

/// Axes that must have the same breaks, some of them reversed relative to their class.
class TiedAxes {
 public:
  explicit TiedAxes(std::size_t n) : parent_(n), flips_(n, false), is_symmetric_(n, false) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }
  struct Root {
    std::uint32_t axis;
    bool flips;  // the axis against its root
  };
  Root find(std::uint32_t axis) {
    Root root{axis, false};
    for (; parent_[root.axis] != root.axis; root.axis = parent_[root.axis])
      root.flips = root.flips != flips_[root.axis];
    bool flips = root.flips;
    while (axis != root.axis) {  // points the path at the root
      const bool own = flips_[axis];
      flips_[axis] = flips;
      flips = flips != own;
      axis = std::exchange(parent_[axis], root.axis);
    }
    return root;
  }
  void tie(std::uint32_t a, std::uint32_t b, bool flips) {
    const Root x = find(a), y = find(b);
    const bool between = (x.flips != y.flips) != flips;
    if (x.axis == y.axis) {
      is_symmetric_[x.axis] = is_symmetric_[x.axis] || between;
      return;
    }
    parent_[y.axis] = x.axis;
    flips_[y.axis] = between;
    is_symmetric_[x.axis] = is_symmetric_[x.axis] || is_symmetric_[y.axis];
  }
  bool is_symmetric(std::uint32_t root) const { return is_symmetric_[root]; }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<bool> flips_, is_symmetric_;
};

}  // namespace veritope::internal
