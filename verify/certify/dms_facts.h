// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/dms_facts.h: what certify says of a simplex-spline solid beside its verdict.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "interval/interval.h"
#include "robust/rational.h"

namespace veritope {

/// What belongs to a finding of an invalid solid. Only what is known is set.
struct DmsDefectFacts {
  std::vector<std::uint32_t> tetrahedra;
  std::optional<std::array<int, 4>> beta;
  /// Points of the domain: where the determinant is not positive, common points; two that have one image.
  std::vector<std::array<Rational, 3>> parameters;
  std::optional<Rational> value;  ///< of the determinant at the first one
};

struct DmsFacts {
  std::uint64_t tetrahedra = 0, control_points = 0;
  int degree = 1;
  /// If the solid is valid.
  std::uint64_t leaves = 0, bodies = 0;
  std::uint64_t patches = 0;  ///< tiles of the boundary; 0 if it is proved by pairs of faces
  std::uint64_t faces = 0;    ///< of the boundary, if it is
  std::vector<std::uint64_t> genera;  ///< of the shells
  std::optional<Interval> volume;
  /// If it is invalid: one for each finding, in their order.
  std::vector<DmsDefectFacts> defects;
  std::uint64_t num_defects = 0;  ///< those that are not listed, too
};

}  // namespace veritope
