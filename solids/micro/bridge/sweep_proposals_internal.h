// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge/sweep_proposals_internal.h: curves of sweeps, proposed in floating point: algorithm 4 of [HPE22].
// Internal to solids/micro/bridge.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "solids/micro/bridge/build_bridges.h"
#include "solids/micro/bridge/plain_vectors_internal.h"
#include "solids/micro/bridge/skin_projection_internal.h"

namespace veritope::internal {

inline constexpr int kSweepTries = 16;

/// A cap in space. All numbers are approximate.
struct SpaceCap {
  CapPlace cap;
  Point3d middle{}, normal{}, axis{};  ///< normal and the image of the axis, outward, of length 1
  double arm = 0;                      ///< the length of half a cell along the axis
  std::vector<Point3d> samples;        ///< points of the cap
};

/// Proposes sweeps for one cap: first that of algorithm 4, then others. Each ends inside of the solid, if all goes
/// well: its curve is cut off where the samples of the cap would leave it.
class SweepProposals {
 public:
  SweepProposals(const SkinProjection& skin, const BridgeOptions& options, const SpaceCap& cap);

  /// The distance of the cap's middle from the surface is under a twentieth of the arm.
  bool is_flat() const { return !(distance_ >= cap_.arm / 20); }
  /// Number `index` of kSweepTries; nothing if no curve of this kind was found.
  std::optional<MicroSweep> propose(int index);

 private:
  /// The Bezier points of a curve, less its first one.
  struct Curve {
    Point3d middle{}, end{};
  };
  std::optional<Point3d> hit_along(const Point3d& direction) const;
  double tilt(const Point3d& normal) const;
  const std::vector<Point3d>& hits();
  std::optional<Point3d> end_of(std::size_t aim, double ahead);
  std::optional<Curve> curve(int index);
  std::optional<Curve> drawn_back(const Curve& curve, double depth) const;
  std::array<double, 2> depths(const Point3d& offset) const;

  const SkinProjection& skin_;
  const BridgeOptions& options_;
  const SpaceCap& cap_;
  double distance_ = 0;
  std::optional<std::vector<Point3d>> hits_;
};

}  // namespace veritope::internal
