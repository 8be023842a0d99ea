// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/star_box/sheet_separator.h: a polynomial that keeps the sheets of a box apart. Theory: docs/THEORY.md §4b.
#pragma once
#include <cstdint>
#include <vector>

#include "robust/base/sign.h"
#include "solids/pieces/piece_forest.h"

namespace veritope {

/// q(x): the sum of coefficient times y1^a y2^b y3^c, y = (x - origin) / unit, in the order a = 0..degree,
/// b = 0..degree - a, c = 0..degree - a - b (c fastest), as in the certificate.
struct SheetSeparator {
  static constexpr int kMostDegree = 3;
  static constexpr std::int64_t kCoefficientLimit = std::int64_t{1} << 53;

  int degree = 1;  ///< 1, 2 or 3
  Point3d origin{};
  double unit = 1;                         ///< a power of two
  std::vector<std::int64_t> coefficients;  ///< below kCoefficientLimit in absolute value

  static std::size_t num_coefficients(int degree) {
    const auto d = static_cast<std::size_t>(degree);
    return (d + 1) * (d + 2) * (d + 3) / 6;
  }
};

/// The sign that all Bernstein coefficients of W^degree q(F / W) have on the node; uncertain if they differ, or if the
/// bounds do not decide.
Sign3 separator_sign(PieceForest& forest, PieceForest::Id id, const SheetSeparator& separator);

}  // namespace veritope
