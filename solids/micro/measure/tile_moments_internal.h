// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/measure/tile_moments_internal.h: integrals of products of Legendre polynomials over the solid that a
// tile bounds, for all numbers of its walls. Internal to solids/micro/measure.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "interval/interval.h"
#include "solids/micro/micro_tile.h"

namespace veritope::internal {

/// The number of triples (i, j, k) with i + j + k <= order.
constexpr std::size_t num_moments(std::size_t order) {
  return (order + 1) * (order + 2) * (order + 3) / 6;
}
/// The triples in the order of moments: by their sums, then ascending.
std::vector<std::array<std::size_t, 3>> moment_indices(std::size_t order);
/// The place of a triple in this order.
constexpr std::size_t moment_number(std::size_t i, std::size_t j, std::size_t k) {
  const std::size_t s = i + j + k;
  return (s == 0 ? 0 : num_moments(s - 1)) + i * (2 * s + 3 - i) / 2 + j;
}

/// The moments of order up to `order`: integrals of P_i(2x - 1) P_j(2y - 1) P_k(2z - 1) over the solid. They are sums
/// of polynomials in the numbers of the walls, one for each wall.
class TileMoments {
 public:
  /// @cost  for each patch of degrees p, q and r powers of the number: (order + 3)^3 p q (r - 1) / 4 values, times the
  ///        number of moments
  /// REQUIRES a closed surface in the unit cube, outward, and a live ScopedUpward.
  TileMoments(const MicroTile& tile, std::size_t order);

  bool depends_on_walls() const { return depends_on_walls_; }
  /// REQUIRES numbers in the range of the tile, and a live ScopedUpward.
  void at(const WallNumbers& numbers, std::vector<Interval>& out) const;

 private:
  // Legendre coefficients in the number of a wall, brought to [-1, 1]; first has one more than the moments.
  struct OfWall {
    std::vector<std::uint32_t> first;
    std::vector<Interval> coefficients;
    std::size_t most = 0;  // coefficients of a moment
  };
  void add_patches(const MicroTile& tile, int wall, const std::vector<std::size_t>& patches);

  std::size_t order_;
  bool depends_on_walls_ = false;
  std::array<std::int32_t, 2> range_{};
  std::vector<Interval> fixed_;  // what the patches add that depend on no wall
  std::array<OfWall, 6> walls_;
};

/// Moments of tiles, made when they are first asked for. May be used by several threads.
class MomentTables {
 public:
  explicit MomentTables(const std::vector<MicroTile>& tiles) : tiles_(tiles) {}
  /// REQUIRES a live ScopedUpward.
  const TileMoments& of(std::size_t tile, std::size_t order);

 private:
  const std::vector<MicroTile>& tiles_;
  std::mutex mutex_;
  std::map<std::pair<std::size_t, std::size_t>, TileMoments> tables_;
};

}  // namespace veritope::internal
