// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/patch_line_internal.h: whether a patch meets a half-line along the normal of its base, exactly. Internal
// to solids/chain.
#pragma once
#include "robust/integer.h"
#include "solids/chain/literal_facet_internal.h"

namespace veritope::internal {

/// kSome and kNone are proved, and stay true of all points near the given one. kTouches and kOn are proved, too, by
/// rational parameters of a point of the patch, beyond the given point or equal to it, and say nothing of others.
enum class Meets : std::uint8_t { kSome, kNone, kTouches, kOn, kOpen };

class PatchLine {
 public:
  /// REQUIRES facet.map, a base with an area, weights > 0.
  explicit PatchLine(const LiteralFacet& facet);

  /// The closed half-line from q along the base's normal, or against it. Not kSome or kNone: on the patch, below its
  /// boundary or an apparent contour, or within 2^-kMostLevels of these.
  Meets half_line(const LiteralFacet& facet, const ExactPoint& q, bool is_upward) const;
  /// The point q alone: kNone, kOn or kOpen.
  Meets point(const LiteralFacet& facet, const ExactPoint& q) const;
  static constexpr int kMostLevels = 48;

 private:
  BezierTriangle<Integer>
      net_;  // coordinates along the base, height, weight, times one positive integer
};

}  // namespace veritope::internal
