// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/sweep_start.h: caps from which sweeps start, and the maps of their cells, enclosed. Section 7b of
// docs/certificates/microstructure.md.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "interval/ring_numbers.h"
#include "solids/micro/microstructure.h"
#include "solids/micro/tile_analysis.h"
#include "splines/bezier.h"
#include "splines/knot_insertion.h"

namespace veritope {

/// Immutable: threads may share it. The microstructure and its analysed tiles must outlive it. All functions REQUIRE a
/// wall of a cell with a tile, and those that return intervals a live ScopedUpward.
class SweepStarts {
 public:
  /// @cost the pieces of all volumes that have grids
  SweepStarts(const Microstructure& micro, const std::vector<AnalysedTile>& tiles);

  /// The cap with the numbers of the cell, in the unit square of the wall's other two axes, ascending. Nothing unless
  /// all patches in the wall make one cap, which is one patch.
  std::optional<BezierSurface<Rational>> cap(const CapPlace& place) const;
  /// The volume's map on the wall, as a map of that square.
  BezierSurface<Interval> wall(const CapPlace& place) const;
  /// The volume's map on those parameters of the cell whose distance from the wall is at most `depth` times the cell's
  /// width, as a map of the unit cube. REQUIRES 0 < depth <= 1.
  BezierVolume<Interval> slab(const CapPlace& place, const Rational& depth) const;
  /// The cell's widths along the axes.
  std::array<Rational, 3> widths(const CapPlace& place) const;
  /// Where the wall lies along its axis, in the parameters of the volume.
  const Rational& position(const CapPlace& place) const;

 private:
  using Span = std::array<Rational, 2>;
  Span span(const CapPlace& place, std::size_t axis) const;

  const Microstructure& micro_;
  const std::vector<AnalysedTile>& tiles_;
  std::vector<BezierPieces<Interval, 3>> pieces_;  // by volumes
};

}  // namespace veritope
