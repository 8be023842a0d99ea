// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge/matrix_search_internal.h: a matrix K for which all K J + (K J)^T are positive definite, for
// given matrices J. Internal to solids/micro/bridge.
#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <vector>

#include "interval/interval.h"
#include "robust/rational.h"

namespace veritope::internal {

template <typename R>
using Matrix3 = std::array<R, 9>;  // row by row

template <typename R>
R determinant(const Matrix3<R>& m) {
  return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
         m[2] * (m[3] * m[7] - m[4] * m[6]);
}
template <typename R>
Matrix3<R> product(const Matrix3<R>& a, const Matrix3<R>& b) {
  Matrix3<R> out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      out[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
  return out;
}
template <typename R>
Matrix3<R> symmetric_part(const Matrix3<R>& m) {
  Matrix3<R> out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) out[3 * i + j] = m[3 * i + j] + m[3 * j + i];
  return out;
}
// Positive only if all three leading minors are; zero or uncertain never counts as positive.
template <typename R>
bool is_positive(const R& x) {
  if constexpr (std::is_same_v<R, Interval>)
    return x.sign() == Sign3::kPositive;
  else
    return x.sign() == Sign::kPositive;
}
template <typename R>
bool is_positive_definite(const Matrix3<R>& s) {
  return is_positive(s[0]) && is_positive(R(s[0] * s[4] - s[1] * s[3])) &&
         is_positive(determinant(s));
}
template <typename R>
bool is_definite_product(const Matrix3<R>& k, const Matrix3<R>& j) {
  return is_positive_definite(symmetric_part(product(k, j)));
}

/// Looks for a matrix of integers below 2^40 that `accepts` confirms. It starts from the inverse of the mean of all J,
/// with the row `axis` scaled, and turns it where a J is against it, at most `most_turns` times. Approximate but for
/// what `accepts` decides. REQUIRES a matrix.
std::optional<Matrix3<Rational>> find_definite_matrix(
    std::vector<Matrix3<double>> jacobians, std::size_t axis, int most_turns,
    const std::function<bool(const Matrix3<Rational>&)>& accepts);

}  // namespace veritope::internal
