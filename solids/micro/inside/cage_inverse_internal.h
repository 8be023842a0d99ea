// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/inside/cage_inverse_internal.h: parameters of points of space in the volumes of a cage, approximately.
// Internal to solids/micro/inside.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "robust/base/box3d.h"
#include "solids/micro/inside/inside_parts_internal.h"
#include "splines/bezier.h"

namespace veritope::internal {

/// Parameters of a volume, and for each axis a power of two near the length of its domain.
struct CageParameters {
  std::uint32_t volume = 0;
  Point3d x{}, scale{};
};

/// Approximate: nothing is proved of the parameters.
class CageInverse {
 public:
  explicit CageInverse(const InsideParts& parts);
  /// Parameters whose images are near the point: by Newton's iteration from a few places of each knot span whose
  /// control points lie around it.
  std::vector<CageParameters> all(const Point3d& point) const;

 private:
  struct Span {
    std::uint32_t volume = 0;
    std::array<std::size_t, 3> at{};
    BezierVolume<double> map;
    Box3d box;
  };
  std::vector<Span> spans_;
  const InsideParts& parts_;
};

}  // namespace veritope::internal
