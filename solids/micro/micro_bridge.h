// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/micro_bridge.h: solids that continue caps of tiles to the skin of a model: bridges in the parameters
// of the cage, and sweeps, which are bridges in space. The format and its limits: docs/formats/micro-files.md.
// Source: [HPE22], algorithm 4.
#pragma once
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solids/micro/micro_tile.h"

namespace veritope {

inline constexpr std::size_t kMaxMicroBridges = std::size_t{1} << 22;
inline constexpr int kMaxBridgeBits = 2304;  ///< of a numerator or denominator
/// Along the third axis of a bridge, which starts at its cap.
inline constexpr int kBridgeAxisDegree = 2;

/// A wall of a cell of a grid, which holds a tile.
struct CapPlace {
  std::uint32_t grid = 0;
  std::uint64_t cell = 0;
  int wall = 0;  ///< 2 axis + end
  friend auto operator<=>(const CapPlace&, const CapPlace&) = default;
};

/// A polynomial map b of [0,1]^3 into the parameters of a volume; b(., ., 0) is the cap at `cap`.
struct MicroBridge {
  CapPlace cap;
  std::uint32_t volume = 0;
  std::array<int, 2> degrees{1, 1};
  /// (p + 1)(q + 1) 3 Bernstein coefficients, the last axis fastest.
  std::vector<TilePoint> points;

  std::size_t num_points() const {
    return static_cast<std::size_t>(degrees[0] + 1) * static_cast<std::size_t>(degrees[1] + 1) *
           (kBridgeAxisDegree + 1);
  }
  /// The index of a coefficient in `points`.
  std::size_t at(int i, int j, int k) const {
    return static_cast<std::size_t>((i * (degrees[1] + 1) + j) * (kBridgeAxisDegree + 1) + k);
  }
  friend bool operator==(const MicroBridge&, const MicroBridge&) = default;
};

/// The image of the cap at `cap` in space, moved along a curve: (u, v, w) -> T(F(u, v)) + 2 w (1 - w) e + w^2 f, where
/// F is the cap in the parameters of its cell's volume, T the map of that volume, and e and f are `axis`.
struct MicroSweep {
  CapPlace cap;
  std::array<TilePoint, 2> axis;
  friend bool operator==(const MicroSweep&, const MicroSweep&) = default;
};

}  // namespace veritope
