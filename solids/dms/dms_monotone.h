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

/// R with det R > 0 which is monotone with all G; nothing if none is found: integers below 2^20 in absolute value, or
/// if these are too short, numerators below 2^40 and denominators that are powers of two up to 2^60. Sought is a Q that
/// makes Q K monotone (solids/dms/monotone_search.h), K = M^-1 G F, where F takes a regular tetrahedron to that of the
/// corners and M is the mean of all G F; then R = F^-T Q M^-1. Affine maps of the domain and of space leave all K as
/// they are, but for rounding.
/// REQUIRES corners that are not in one plane.
std::optional<DmsMatrix> find_monotone_matrix(std::span<const EnclosedMatrix* const> all,
                                              const std::array<DmsPoint, 4>& corners);

}  // namespace veritope
