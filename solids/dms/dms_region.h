// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_region.h: which sets of knots may reach into a leaf or a tile: planes that part them, as
// docs/certificates/dms-solid.md has them.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "solids/dms/dms_knots.h"

namespace veritope {

/// vector . x = number
struct DmsPlane {
  DmsPoint vector;
  Rational number;
};

/// A closed tetrahedron or triangle, with the planes on one side of which it lies, not wholly inside of one.
class DmsRegion {
 public:
  static constexpr std::size_t kMaxPlanes = 58;  ///< further ones are left out

  /// Planes that do not have the region on one side are left out; those across the axes are always there.
  /// REQUIRES three corners, not on one line, or four, not in one plane.
  DmsRegion(const DmsKnotTable& knots, std::vector<DmsPoint> corners,
            const std::vector<DmsPlane>& planes);

  const std::vector<DmsPoint>& corners() const { return corners_; }
  /// Whether a plane parts the hull of the knots from the inside of the region. If the knots are on one side of the
  /// plane of a triangle, only those in that plane count.
  bool misses(std::span<const std::uint32_t> knots);
  /// misses(), or the plane of the three knots does it. REQUIRES knots that are not on one line.
  bool misses_triangle(const std::array<std::uint32_t, 3>& knots);
  /// The supports of |γ| = n - 1 that no plane parts from the region.
  std::vector<DmsSupport> supports();
  /// The first three knots of one of the supports, not on one line and, if the region is a triangle, not in its plane,
  /// that may meet the region; nothing if none do.
  std::optional<std::array<std::uint32_t, 3>> find_cut(std::span<const DmsSupport> supports);
  /// All of them, each once.
  std::vector<std::array<std::uint32_t, 3>> find_cuts(std::span<const DmsSupport> supports);

 private:
  struct Place {
    std::uint64_t sides = 0;  // bit i: on the other closed side of plane i
    int height = 0;           // the sign beside the plane of a triangle
  };
  // A plane with the nearest doubles of its numbers, NaN for those above 2^100.
  struct Wall {
    DmsPlane plane;
    std::array<double, 4> rounded{};
    Sign side_of(const DmsPoint& p, const std::array<double, 3>& rounded_p) const;
  };
  static Wall wall_of(DmsPlane plane);
  int side_of(const Wall& wall) const;  // as side_of_plane
  const Place& place(std::uint32_t knot);
  template <typename Visit>
  bool visit_cuts(std::span<const DmsSupport> supports, Visit visit);

  const DmsKnotTable& knots_;
  std::vector<DmsPoint> corners_;
  bool is_triangle_;
  DmsPoint low_, high_;
  std::array<double, 3> rounded_low_{}, rounded_high_{};
  std::vector<std::array<double, 3>> rounded_corners_;
  Wall base_;                // the plane of a triangle
  std::vector<Wall> walls_;  // the region is on the side of greater values
  std::unordered_map<std::uint32_t, Place> places_;
};

/// Those of the faces of a tetrahedron.
std::vector<DmsPlane> face_planes(std::span<const DmsPoint> corners);
/// Those that contain an edge of a triangle and its normal.
std::vector<DmsPlane> upright_planes(std::span<const DmsPoint> corners);
/// 1 or -1 if all corners are on one closed side of the plane, not all in it; else 0.
int side_of_plane(std::span<const DmsPoint> corners, const DmsPlane& plane);

}  // namespace veritope
