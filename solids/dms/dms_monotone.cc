// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_monotone.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "interval/upward.h"
#include "solids/dms/monotone_search.h"

namespace veritope {
namespace {

constexpr double kLargestEntry = 1 << 19;
constexpr int kLongBits = 40, kMostDenominator = 60;  // exponents of two

using Plain = internal::PlainMatrix;

template <typename R>
R determinant_of(const std::array<R, 9>& m) {
  return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
         m[2] * (m[3] * m[7] - m[4] * m[6]);
}

// R G + (R G)^T
template <typename R>
std::array<R, 9> symmetric_product(const std::array<R, 9>& r, const std::array<R, 9>& g) {
  std::array<R, 9> p, out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      p[3 * i + j] = r[3 * i] * g[j] + r[3 * i + 1] * g[3 + j] + r[3 * i + 2] * g[6 + j];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) out[3 * i + j] = p[3 * i + j] + p[3 * j + i];
  return out;
}
template <typename R>
std::array<R, 3> leading_minors(const std::array<R, 9>& s) {
  return {s[0], R(s[0] * s[4] - s[1] * s[3]), determinant_of(s)};
}

// -1 no, 0 unknown, 1 yes
int definite_by_intervals(const std::array<Interval, 9>& r, const std::array<Interval, 9>& g) {
  const ScopedUpward upward;
  int found = 1;
  for (const Interval& minor : leading_minors(symmetric_product(r, g))) {
    const Sign3 sign = minor.sign();
    if (sign == Sign3::kNegative || sign == Sign3::kZero) return -1;
    if (sign != Sign3::kPositive) found = 0;
  }
  return found;
}

Plain approximate(const EnclosedMatrix& m) {
  Plain out;
  for (std::size_t i = 0; i < 9; ++i) out[i] = m.bounds[i].lo() / 2 + m.bounds[i].hi() / 2;
  return out;
}

Plain divided(Plain m, double by) {
  for (double& x : m) x /= by;
  return m;
}
double largest_of(const Plain& m) {
  double most = 0;
  for (const double x : m) most = std::max(most, std::abs(x));
  return most;
}

// The edges of the tetrahedron as those of a regular one take them.
Plain frame_of(const std::array<DmsPoint, 4>& corners) {
  Plain edges;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t m = 0; m < 3; ++m)
      edges[3 * c + m] = nearest_double(corners[m + 1][c] - corners[0][c]);
  return internal::from_regular(edges);
}

DmsMatrix short_matrix(const Plain& r) {
  const double most = largest_of(r);
  DmsMatrix out;
  if (!(most > 0) || !std::isfinite(most)) return out;
  for (std::size_t i = 0; i < 9; ++i)
    out[i] = Rational(static_cast<std::int64_t>(std::round(r[i] / most * kLargestEntry)));
  return out;
}
// Forty bits of each entry that is not too small for that: the greatest one is below 2^20.
DmsMatrix long_matrix(const Plain& r) {
  const double most = largest_of(r);
  DmsMatrix out;
  if (!(most > 0) || !std::isfinite(most)) return out;
  for (std::size_t i = 0; i < 9; ++i) {
    int exponent = 0;
    const double x = std::frexp(r[i] / most * kLargestEntry, &exponent);
    const int bits = std::min(kLongBits, kMostDenominator + exponent);
    if (bits <= 0) continue;
    out[i] = Rational(static_cast<std::int64_t>(std::round(std::ldexp(x, bits)))) *
             Rational::power_of_two(exponent - bits);
  }
  return out;
}

bool is_monotone_with_all(const EnclosedMatrix& r, std::span<const EnclosedMatrix* const> all) {
  if (determinant_of(r.exact).sign() != Sign::kPositive) return false;
  return std::all_of(all.begin(), all.end(),
                     [&](const EnclosedMatrix* g) { return is_monotone(r, *g); });
}

}  // namespace

EnclosedMatrix::EnclosedMatrix(DmsMatrix m) : exact(std::move(m)) {
  for (std::size_t i = 0; i < 9; ++i) bounds[i] = enclose(exact[i]);
}

bool is_monotone(const EnclosedMatrix& r, const EnclosedMatrix& g) {
  if (const int known = definite_by_intervals(r.bounds, g.bounds); known != 0) return known > 0;
  for (const Rational& minor : leading_minors(symmetric_product(r.exact, g.exact)))
    if (minor.sign() != Sign::kPositive) return false;
  return true;
}

std::optional<DmsMatrix> find_monotone_matrix(std::span<const EnclosedMatrix* const> all,
                                              const std::array<DmsPoint, 4>& corners) {
  Plain frame = frame_of(corners);
  frame = divided(frame, largest_of(frame));
  const std::optional<Plain> back = internal::inverse_of(frame);
  if (!back) return std::nullopt;
  std::vector<Plain> k;
  double most = 0;
  for (const EnclosedMatrix* const g : all) {
    k.push_back(internal::multiplied(approximate(*g), frame));
    most = std::max(most, largest_of(k.back()));
  }
  if (!(most > 0) || !std::isfinite(most)) return std::nullopt;
  for (Plain& m : k) m = divided(m, most);
  // The second mean is that of matrices of one size.
  Plain to_space = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  for (int i = 0; i < 2; ++i) {
    Plain mean{};
    for (Plain& m : k) {
      const double norm = i == 0 ? static_cast<double>(k.size()) : internal::norm_of(m);
      if (!(norm > 0) || !std::isfinite(norm)) return std::nullopt;
      if (i == 1) m = divided(m, norm);
      for (std::size_t e = 0; e < 9; ++e) mean[e] += i == 0 ? m[e] / norm : m[e];
    }
    const std::optional<Plain> inverse = internal::inverse_of(mean);
    if (!inverse) return std::nullopt;
    for (Plain& m : k) m = internal::multiplied(*inverse, m);
    to_space = internal::multiplied(*inverse, to_space);
  }
  for (Plain& m : k) m = divided(m, internal::norm_of(m));
  const Plain from_frame = internal::transposed(*back);
  std::optional<DmsMatrix> out;
  internal::search_monotone(k, [&](const Plain& q) {
    const Plain r = internal::multiplied(internal::multiplied(from_frame, q), to_space);
    for (const DmsMatrix& rounded : {short_matrix(r), long_matrix(r)})
      if (const EnclosedMatrix candidate(rounded); is_monotone_with_all(candidate, all)) {
        out = candidate.exact;
        return true;
      }
    return false;
  });
  return out;
}

}  // namespace veritope
