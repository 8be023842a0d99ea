// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/vmodel_cut_internal.h: the lengths of the numbers from which parts of cells are cut, the limits on
// them, and the units of cutting: docs/certificates/vmodel.md, B2 and section 7.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "robust/rational.h"
#include "splines/knot_axis.h"

namespace veritope::internal {

inline constexpr std::uint64_t kFreeVModelUnits = std::uint64_t{1} << 23, kVModelUnitsOfByte = 96;
inline constexpr std::uint64_t kMostBitsOfPiece = std::uint64_t{1} << 24;

/// An interval of an axis between knots, or a part of it.
struct KnotPiece {
  std::size_t first = 0;   ///< control point
  std::uint64_t bits = 1;  ///< t of the page, or more
  bool is_whole = false;   ///< its knots are the interval's ends: coefficients are control points

  /// The page's first row.
  std::uint64_t units(int degree) const;
};
/// Nothing if its knots are too long. If is_bound, the bits are an upper bound, and one that is too long counts.
std::optional<KnotPiece> interval_of(const KnotAxis<Rational>& axis, const Rational& a,
                                     const Rational& b, bool is_bound);

/// The bits of control points; nothing if they are too long. is_bound: as above.
std::optional<std::uint64_t> bits_of_points(const std::vector<Rational>& numbers, bool is_bound);

/// The page's second row for a part that is cut along axes with so many control points each, from control points of so
/// many bits; and an upper bound of the bits of its coefficients.
struct CutProducts {
  std::uint64_t units = 0, bits = 0;
};
CutProducts products_of(std::span<const std::uint64_t> sizes, std::span<const KnotPiece> axes,
                        std::uint64_t bits);

}  // namespace veritope::internal
