// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge/bridge_proposals_internal.h: shapes of bridges, proposed in floating point: algorithm 4 of
// [HPE22]. Internal to solids/micro/bridge.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "solids/micro/bridge/build_bridges.h"
#include "solids/micro/bridge/cage_space_internal.h"
#include "solids/micro/bridge/skin_projection_internal.h"
#include "solids/micro/bridge_front.h"

namespace veritope::internal {

inline constexpr int kBridgeTries = 16;
inline constexpr std::size_t kBridgeTargets = 6;

/// A cap to be bridged, and what is known of it. All numbers are approximate.
struct OpenCap {
  CapPlace cap;
  BridgeFront front;
  BezierSurface<Rational> surface{{1, 1}, 3, false};
  Point3d middle{};      ///< in parameters
  double arm = 0;        ///< the length of half a cell along the axis, in space
  double cell_size = 0;  ///< of the cell along the axis, in parameters
};

/// Proposes bridges for one cap: first that of algorithm 4, then others whose ends are moved.
class BridgeProposals {
 public:
  BridgeProposals(const SkinProjection& projection, const VolumeSpace& space,
                  const BridgeOptions& options, const OpenCap& cap);

  /// The distance of the cap's middle from the surface is under a twentieth of the arm.
  bool is_flat() const { return !(distance_ >= cap_.arm / 20); }
  /// Number `index` of kBridgeTries; nothing if no end of this kind was found in the volume.
  std::optional<MicroBridge> propose(int index);

 private:
  struct End {
    Point3d surface{};  ///< near it the bridge ends
    Point3d normal{};
    double reach = 0;  ///< the distance of the end from the cap
  };

  double distance_to(const Point3d& p) const;
  const std::optional<End>& end_of(std::size_t target);
  std::optional<End> find_end(std::size_t target) const;
  std::optional<Point3d> end_of_line() const;
  MicroBridge shape(const End& end, const ApproxPlace& place, double size, double turn,
                    double lead) const;

  const SkinProjection& projection_;
  const VolumeSpace& space_;
  const BridgeOptions& options_;
  const OpenCap& cap_;
  std::optional<ApproxPlace> start_;
  Point3d axis_{};    ///< the image of the axis's direction, beyond the front, in space
  Point3d normal_{};  ///< of the cap, of length 1
  double distance_ = 0;
  std::array<std::optional<std::optional<End>>, kBridgeTargets> ends_;
};

}  // namespace veritope::internal
