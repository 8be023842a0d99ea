// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/plain_matrix.h"

#include <cmath>
#include <cstddef>

namespace veritope::internal {

PlainMatrix multiplied(const PlainMatrix& a, const PlainMatrix& b) {
  PlainMatrix out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) out[3 * i + j] += a[3 * i + k] * b[3 * k + j];
  return out;
}
PlainMatrix transposed(const PlainMatrix& m) {
  return {m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]};
}
double determinant_of(const PlainMatrix& m) {
  return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
         m[2] * (m[3] * m[7] - m[4] * m[6]);
}
double norm_of(const PlainMatrix& m) {
  double sum = 0;
  for (const double x : m) sum += x * x;
  return std::sqrt(sum);
}
std::optional<PlainMatrix> inverse_of(const PlainMatrix& m) {
  const double d = determinant_of(m);
  if (!(std::abs(d) > 0) || !std::isfinite(d)) return std::nullopt;
  const auto minor = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
    return (m[i] * m[j] - m[k] * m[l]) / d;
  };
  return PlainMatrix{minor(4, 8, 5, 7), minor(2, 7, 1, 8), minor(1, 5, 2, 4),
                     minor(5, 6, 3, 8), minor(0, 8, 2, 6), minor(2, 3, 0, 5),
                     minor(3, 7, 4, 6), minor(1, 6, 0, 7), minor(0, 4, 1, 3)};
}
PlainMatrix from_regular(const PlainMatrix& edges) {
  // The inverse of the edges (1, 0, 0), (1/2, sqrt(3)/2, 0), (1/2, sqrt(3)/6, sqrt(2/3)), columns of a matrix.
  const double a = std::sqrt(3.0), b = std::sqrt(1.5);
  return multiplied(edges, {1, -1 / a, -b / 3, 0, 2 / a, -b / 3, 0, 0, b});
}

}  // namespace veritope::internal
