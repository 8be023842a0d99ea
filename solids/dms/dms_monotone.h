// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_monotone.h: matrices R for which R G + (R G)^T is positive definite for many G: then all G are
// regular, and so are their convex combinations.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "interval/interval.h"
#include "solids/dms/dms_knots.h"

namespace veritope {

/// A matrix with what its filter takes.
struct EnclosedMatrix {
  DmsMatrix exact;
  std::array<Interval, 9> bounds;
  explicit EnclosedMatrix(DmsMatrix m);
};

/// Whether R G + (R G)^T is positive definite: intervals, and where they do not decide, exact numbers.
bool is_monotone(const EnclosedMatrix& r, const EnclosedMatrix& g);

/// R with det R > 0, of integers below 2^20 in absolute value, which is monotone with all G; nothing if none is found.
/// It starts from the inverse of the mean of all G, and turns it where a G is against it.
std::optional<DmsMatrix> find_monotone_matrix(std::span<const EnclosedMatrix* const> all);

}  // namespace veritope
