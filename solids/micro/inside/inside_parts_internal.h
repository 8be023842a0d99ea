// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/inside/inside_parts_internal.h: what the conditions I1 to I4 share: maps of volumes by knot spans, and
// cells in them. Internal to solids/micro/inside.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "solids/micro/inside/grid_spans_internal.h"
#include "solids/micro/inside/inside_solid_internal.h"
#include "solids/micro/inside/part_net_internal.h"
#include "splines/knot_insertion.h"

namespace veritope::internal {

/// The maps of a volume between its knots.
class VolumeMaps {
 public:
  explicit VolumeMaps(const VVolume& volume);

  const std::vector<Rational>& knots(std::size_t axis) const { return pieces_.breaks[axis]; }
  /// REQUIRES numbers of spans.
  const PartNet& net(const std::array<std::size_t, 3>& spans) const {
    return nets_[pieces_.grid().at(spans)];
  }
  const BezierVolume<Rational>& exact(const std::array<std::size_t, 3>& spans) const {
    return pieces_.at(spans);
  }
  /// The greatest of all spans (part_net_internal.h).
  double checkers_error() const { return checkers_error_; }
  /// Exactly. REQUIRES a point of the domain.
  ExactPoint image(const TilePoint& x) const;

 private:
  BezierPieces<Rational, 3> pieces_;
  std::vector<PartNet> nets_;
  double checkers_error_ = 0;
};

/// The question, and what is prepared of it once.
struct InsideParts {
  const Microstructure& micro;
  const std::vector<AnalysedTile>& tiles;
  const InsideSolid& solid;
  const InsideLimits& limits;
  unsigned jobs;
  std::vector<VolumeMaps> volumes;

  /// The coefficients of a patch in a cell, in [0,1]^3.
  std::vector<TilePoint> exact_points(const CellPatch& at) const;
  /// "patch 3 of the tile of cell (1, 0, 2) of grid 0".
  std::string name(const CellPatch& at) const;
};

/// Each condition: nothing if it holds.
std::optional<InsideDefect> surface_defect(const InsideParts& parts);
std::optional<InsideDefect> shell_defect(const InsideParts& parts,
                                         const std::vector<CellPatch>& first_patches);
std::optional<InsideDefect> void_defect(const InsideParts& parts, std::vector<VoidPoint>* out);
std::optional<InsideDefect> skin_defect(const InsideParts& parts, std::optional<Rational>* out);

}  // namespace veritope::internal
