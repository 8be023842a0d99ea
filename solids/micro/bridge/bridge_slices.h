// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge/bridge_slices.h: boxes around slices of bridges, which keep away from cells with tiles and from
// other bridges: the conditions R3 and R4 of docs/certificates/microstructure.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "interval/box.h"
#include "robust/base/box3d.h"
#include "solids/micro/bridge/box_bins.h"
#include "solids/micro/bridge_front.h"

namespace veritope {

/// The part [index, index + 1] / 2^level of a bridge's third axis.
struct BridgeSlice {
  int level = 0;
  std::uint32_t index = 0;
  Box3d box;  ///< contains the box around the coefficients
};

/// A bridge cut into slices. The box of a half lies in that of the whole, up to rounding.
class BridgeSlices {
 public:
  static constexpr int kMaxLevel = 7;  ///< so there are at most 128 slices

  explicit BridgeSlices(const MicroBridge& bridge);

  std::uint32_t volume() const { return volume_; }
  /// Around the whole bridge.
  const Box3d& box() const { return box_; }
  const std::vector<BridgeSlice>& slices() const { return slices_; }
  /// Replaces a slice by its halves; false if it may not be cut any more.
  bool halve(std::size_t slice);
  /// Where the slices meet, strictly between 0 and 1.
  std::vector<Rational> cuts() const;

 private:
  BridgeSlice slice(int level, std::uint32_t index) const;

  std::uint32_t volume_;
  std::vector<std::array<Box3, 3>> lines_;  // the lists, by points
  Box3d box_;
  std::vector<BridgeSlice> slices_;  // ascending
};

/// The closed cells that hold a tile.
class TileCells {
 public:
  /// The microstructure must outlive it.
  explicit TileCells(const Microstructure& micro);

  /// Whether the box may meet a closed cell with a tile other than `own`.
  bool meets(std::uint32_t volume, const Box3d& box, const CapPlace* own) const;

 private:
  struct Lines {
    std::array<std::vector<double>, 3> lo, hi;  // bounds of the breaks
  };
  bool meets_grid(std::uint32_t grid, const Box3d& box, const CapPlace* own) const;

  const Microstructure& micro_;
  std::vector<Lines> lines_;                          // by grids
  std::vector<std::vector<std::uint32_t>> grids_of_;  // by volumes
};

/// Whether the lists 1 and 2 of the bridge lie in the open box of its volume's parameters, strictly beyond the front.
bool is_in_open_box(const MicroBridge& bridge, const VVolume& volume, const BridgeFront& front);

/// Cuts the bridge until no slice meets a cell with a tile, but for the first one and the bridge's own cell; false if
/// that does not succeed.
bool cut_off_tiles(const TileCells& cells, const CapPlace& cap, const BridgeFront& front,
                   BridgeSlices& slices);

/// Bridges with slices that are proved disjoint.
class DisjointBridges {
 public:
  /// The boxes of bridges are looked up in a grid of approximately the size of the cells.
  explicit DisjointBridges(const Microstructure& micro);

  /// Adds the bridge if it is proved disjoint from all others, which may need more cuts of both; else returns the
  /// number of one that it may meet.  @cost the bridges near it
  std::optional<std::size_t> add(BridgeSlices bridge);
  const BridgeSlices& operator[](std::size_t i) const { return bridges_[i]; }
  std::size_t size() const { return bridges_.size(); }

 private:
  std::vector<internal::BoxBins> bins_;  // by volumes
  std::vector<BridgeSlices> bridges_;
};

}  // namespace veritope
