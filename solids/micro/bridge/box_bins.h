// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge/box_bins.h: numbered boxes, to be found by boxes that they may meet, while more are
// added.
#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "robust/base/box3d.h"

namespace veritope::internal {

class BoxBins {
 public:
  /// @param size  of a bin, along each axis; boxes that are much larger are slow to find
  explicit BoxBins(const Point3d& size) : size_(size) {}

  /// REQUIRES numbers in ascending order.
  void add(std::uint32_t number, const Box3d& box);
  /// The numbers of all boxes that may meet the box, and maybe others, ascending.
  std::vector<std::uint32_t> near(const Box3d& box) const;

 private:
  bool is_large(const Box3d& box) const;
  template <typename Visit>
  void for_each_bin(const Box3d& box, Visit visit) const;

  Point3d size_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> bins_;
  std::vector<std::uint32_t> all_, large_;  // large_: those in no bin
};

}  // namespace veritope::internal
