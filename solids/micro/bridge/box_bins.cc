// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "solids/micro/bridge/box_bins.h"

namespace veritope::internal {
namespace {

constexpr double kMostBins = 512;  // of a box

std::uint64_t key_of_bin(const std::array<std::int64_t, 3>& at) {
  std::uint64_t key = 0;
  for (const std::int64_t x : at) {
    key ^= static_cast<std::uint64_t>(x) + 0x9e3779b97f4a7c15u + (key << 6) + (key >> 2);
    key *= 0xff51afd7ed558ccdu;
  }
  return key;
}

}  // namespace

bool BoxBins::is_large(const Box3d& box) const {
  double bins = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    bins *= 2 + (box.hi[a] - box.lo[a]) / size_[a];
    constexpr double kMostIndex = 0x1p60;
    if (!(std::abs(box.lo[a] / size_[a]) < kMostIndex)) return true;
  }
  return !(bins <= kMostBins);
}

template <typename Visit>
void BoxBins::for_each_bin(const Box3d& box, Visit visit) const {
  std::array<std::int64_t, 3> lo, hi;
  for (std::size_t a = 0; a < 3; ++a) {
    lo[a] = static_cast<std::int64_t>(std::floor(box.lo[a] / size_[a]));
    hi[a] = static_cast<std::int64_t>(std::floor(box.hi[a] / size_[a]));
  }
  for (std::int64_t i = lo[0]; i <= hi[0]; ++i)
    for (std::int64_t j = lo[1]; j <= hi[1]; ++j)
      for (std::int64_t k = lo[2]; k <= hi[2]; ++k) visit(key_of_bin({i, j, k}));
}

void BoxBins::add(std::uint32_t number, const Box3d& box) {
  all_.push_back(number);
  if (is_large(box))
    large_.push_back(number);
  else
    for_each_bin(box, [&](std::uint64_t key) { bins_[key].push_back(number); });
}

std::vector<std::uint32_t> BoxBins::near(const Box3d& box) const {
  if (is_large(box)) return all_;
  std::vector<std::uint32_t> out = large_;
  for_each_bin(box, [&](std::uint64_t key) {
    if (const auto bin = bins_.find(key); bin != bins_.end())
      out.insert(out.end(), bin->second.begin(), bin->second.end());
  });
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace veritope::internal
