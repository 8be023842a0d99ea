// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/vmodel_cut_internal.h: the lengths of the numbers from which parts of cells are cut, and the limits on
// them: docs/certificates/vmodel.md, B2 and section 7.
#pragma once
#include <cstddef>
#include <cstdint>

#include "robust/common_bits.h"
#include "robust/rational.h"
#include "splines/knot_axis.h"

namespace veritope::internal {

inline constexpr std::uint64_t kFreeVModelUnits = std::uint64_t{1} << 23, kVModelUnitsOfByte = 96;
inline constexpr std::uint64_t kMostBitsOfKnots = 2048, kMostBitsOfPoints = 8192;
inline constexpr std::uint64_t kMostBitsOfPiece = std::uint64_t{1} << 24;

/// An interval of an axis between knots, or a part of it.
struct KnotPiece {
  std::size_t first = 0;   // control point
  std::uint64_t bits = 1;  // t of the page, or more
  bool is_whole = false;   // its knots are the interval's ends: coefficients are control points
};

inline KnotPiece interval_of(const KnotAxis<Rational>& axis, const Rational& a, const Rational& b) {
  const auto p = static_cast<std::size_t>(axis.degree);
  std::size_t k = p;
  while (axis.knots[k + 1] <= a) ++k;
  KnotPiece out;
  out.first = k - p;
  CommonBits bits(kMostBitsOfKnots);
  out.is_whole = true;
  for (std::size_t i = k - p + 1; i <= k + p; ++i) {
    bits.add(axis.knots[i] - a);
    out.is_whole = out.is_whole && axis.knots[i] == (i <= k ? a : b);
  }
  bits.add(b - a);
  out.bits = out.is_whole ? 1 : bits.bits();
  return out;
}

}  // namespace veritope::internal
