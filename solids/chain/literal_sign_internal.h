// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/literal_sign_internal.h: whether a polynomial in Bernstein form is nowhere negative, exactly or open.
// Internal to solids/chain.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "splines/bezier_triangle.h"

namespace veritope::internal {

enum class Decision : std::uint8_t { kHolds, kViolated, kOpen };

/// f >= 0 on the closed domain: kHolds or kViolated is proved, and `where` holds parameters with f < 0. If it holds and
/// !is_zero, f > 0 at every inner point of the domain that is on no line between the pieces that were examined.
struct NowhereNegative {
  Decision decision = Decision::kOpen;
  bool is_zero = false;  ///< f = 0 everywhere
  std::optional<Barycentric<Rational>> where;
};
/// REQUIRES one component. At most kMostCoefficients coefficients are examined.
NowhereNegative nowhere_negative(const BezierTriangle<Rational>& f);
inline constexpr std::size_t kMostCoefficients = 4096;

/// Likewise for a polynomial of one variable.
struct NowhereNegativeCurve {
  Decision decision = Decision::kOpen;
  bool is_zero = false;
  std::optional<Rational> where;
};
NowhereNegativeCurve nowhere_negative(std::vector<Rational> f);

}  // namespace veritope::internal
