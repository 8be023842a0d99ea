// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/plain_matrix.h: matrices of three rows in binary64, for searches.
#pragma once
#include <array>
#include <optional>

namespace veritope::internal {

/// Row by row.
using PlainMatrix = std::array<double, 9>;

PlainMatrix multiplied(const PlainMatrix& a, const PlainMatrix& b);
PlainMatrix transposed(const PlainMatrix& m);
double determinant_of(const PlainMatrix& m);
/// The square root of the sum of all squares.
double norm_of(const PlainMatrix& m);
/// Nothing if the determinant is 0 or no number.
std::optional<PlainMatrix> inverse_of(const PlainMatrix& m);
/// The map of a regular tetrahedron with edges of length 1 that takes three edges at a corner to the columns.
PlainMatrix from_regular(const PlainMatrix& edges);

}  // namespace veritope::internal
