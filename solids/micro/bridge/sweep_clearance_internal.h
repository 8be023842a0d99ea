// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge/sweep_clearance_internal.h: sweeps, in space, that miss the surfaces of tiles and each other: the
// conditions Q3 and Q4 of docs/certificates/microstructure.md. Internal to solids/micro/bridge.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "solids/base/box_hierarchy.h"
#include "solids/micro/bridge/box_bins.h"
#include "solids/micro/bridge/cage_space_internal.h"
#include "solids/micro/bridge/sweep_matrix.h"
#include "solids/micro/sweep_nodes.h"

namespace veritope::internal {

/// How many pairs of nodes were compared, whose boxes meet, and how many may be.
struct PairBudget {
  std::uint64_t most = 0, spent = 0;
  bool is_spent() const { return spent > most; }
};

/// A sweep with its witness. Not for several threads.
struct PlacedSweep {
  /// REQUIRES a cap of one patch, and a live ScopedUpward.
  PlacedSweep(const SweepStarts& starts, const MicroSweep& sweep, const SweepWitness& witness);

  CapPlace cap;
  Rational depth;
  std::array<Box3, 3> rows;  // of the matrix
  SweepNodes nodes;
  Box3d box;
};

/// The tiles of a microstructure in space. Immutable: threads may share it. The microstructure and the spaces of its
/// volumes must outlive it.
class TilesInSpace {
 public:
  TilesInSpace(const Microstructure& micro, const std::vector<VolumeSpace>& spaces, unsigned jobs);

  /// True only if Q3 holds of the sweep.
  bool are_missed_by(PlacedSweep& sweep, PairBudget& budget) const;

 private:
  struct Block {
    std::uint32_t grid = 0;
    std::array<std::uint32_t, 3> first{};  // cells of it, kBlockSide along each axis or fewer
  };
  static constexpr std::uint32_t kBlockSide = 2;

  void add_blocks(std::uint32_t grid);
  Box3d parameters_of(std::uint32_t grid, const std::array<std::size_t, 3>& first,
                      const std::array<std::size_t, 3>& past) const;
  /// Around the image; everything if the map has no bounds there.
  Box3d image_of(std::uint32_t grid, const Box3d& parameters) const;

  const Microstructure& micro_;
  const std::vector<VolumeSpace>& spaces_;
  std::vector<Block> blocks_;
  BoxHierarchy tree_;
};

/// Sweeps that are proved disjoint: Q4.
class DisjointSweeps {
 public:
  /// Adds the sweep if it is proved disjoint from all others; else returns the number of one that it may meet, or
  /// with which the budget was spent. REQUIRES a live ScopedUpward.
  std::optional<std::size_t> add(PlacedSweep sweep, PairBudget& budget);

 private:
  std::vector<PlacedSweep> sweeps_;
  std::optional<BoxBins> bins_;
};

}  // namespace veritope::internal
