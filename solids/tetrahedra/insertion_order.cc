// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/tetrahedra/insertion_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "robust/base/random.h"

namespace veritope {
namespace {

constexpr int kHilbertBits = 20;  // along each axis
constexpr int kRounds = 16;

// Bit i goes to bit 3 i.
std::uint64_t spread(std::uint64_t v) {
  v = (v | v << 32) & 0x1f00000000ffffu;
  v = (v | v << 16) & 0x1f0000ff0000ffu;
  v = (v | v << 8) & 0x100f00f00f00f00fu;
  v = (v | v << 4) & 0x10c30c30c30c30c3u;
  return (v | v << 2) & 0x1249249249249249u;
}

// Cells of the points along an axis. Half the coordinates, so that no difference overflows.
class HilbertScale {
 public:
  HilbertScale(double low, double high) : low_(low / 2) {
    const double width = high / 2 - low_;
    if (width > 0) factor_ = std::min(kCells / width, 0x1p1000);
  }
  std::uint32_t cell(double x) const {
    return static_cast<std::uint32_t>(std::clamp((x / 2 - low_) * factor_, 0.0, kCells - 1));
  }

 private:
  static constexpr double kCells = 1 << kHilbertBits;
  double low_, factor_ = 0;
};

}  // namespace

std::uint64_t hilbert_number(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  std::array<std::uint32_t, 3> at{x, y, z};
  for (int bit = kHilbertBits - 1; bit > 0; --bit) {
    const std::uint32_t below = (1u << bit) - 1;
    for (std::uint32_t& a : at) {
      const std::uint32_t is_set = 0u - ((a >> bit) & 1u);  // all bits or none
      const std::uint32_t exchange = (at[0] ^ a) & below & ~is_set;
      at[0] ^= exchange | (below & is_set);
      a ^= exchange;
    }
  }
  at[1] ^= at[0];
  at[2] ^= at[1];
  std::uint32_t flip = 0;
  for (int bit = kHilbertBits - 1; bit > 0; --bit)
    flip ^= ((1u << bit) - 1) & (0u - ((at[2] >> bit) & 1u));
  return spread(at[0] ^ flip) << 2 | spread(at[1] ^ flip) << 1 | spread(at[2] ^ flip);
}

std::vector<std::uint32_t> insertion_order(std::span<const Vec3d> points) {
  if (points.empty()) return {};
  Vec3d low = points[0], high = points[0];
  for (const Vec3d& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const HilbertScale x(low.x, high.x), y(low.y, high.y), z(low.z, high.z);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
  keys.reserve(points.size());
  Random random(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Vec3d& p = points[i];
    // Three quarters of the points come in the last round, three quarters of the rest in the one before, and so on.
    const int earlier = std::min(std::countr_zero(random.next()) / 2, kRounds - 1);
    const auto round = static_cast<std::uint64_t>(kRounds - 1 - earlier);
    keys.emplace_back(
        round << (3 * kHilbertBits) | hilbert_number(x.cell(p.x), y.cell(p.y), z.cell(p.z)), i);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order;
  order.reserve(points.size());
  for (const auto& key : keys) order.push_back(key.second);
  return order;
}

}  // namespace veritope
