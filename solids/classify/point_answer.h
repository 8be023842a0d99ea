// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/point_answer.h: where a point lies with respect to a model.
#pragma once
#include <array>
#include <cstdint>

#include "robust/rational.h"

namespace veritope {

/// No facet, no shell.
inline constexpr std::uint32_t kNowhere = 0xffffffff;

struct PointAnswer {
  std::int32_t winding = 0;        ///< of the surface around the point; 0 for a point on it
  std::uint32_t facet = kNowhere;  ///< the least facet that contains the point; kNowhere: it is off
  /// For a point on the surface the shell of that facet, else the innermost shell around it; kNowhere if no shell is
  /// around it, or if shells were not requested.
  std::uint32_t shell = kNowhere;

  bool is_decided =
      true;  ///< false: whether the point is on the surface is open, and the rest says nothing

  bool is_on() const { return facet != kNowhere; }
  friend bool operator==(const PointAnswer&, const PointAnswer&) = default;
};

/// A point with any rational coordinates.
using ExactPoint = std::array<Rational, 3>;

}  // namespace veritope
