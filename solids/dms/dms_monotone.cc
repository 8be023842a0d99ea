// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_monotone.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "interval/upward.h"

namespace veritope {
namespace {

constexpr int kMaxTurns = 60;
constexpr double kLargestEntry = 1 << 19;

using Plain = std::array<double, 9>;

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
std::optional<Plain> inverse_of(const Plain& m) {
  const double d = determinant_of(m);
  if (!(std::abs(d) > 0) || !std::isfinite(d)) return std::nullopt;
  const auto minor = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
    return (m[i] * m[j] - m[k] * m[l]) / d;
  };
  return Plain{minor(4, 8, 5, 7), minor(2, 7, 1, 8), minor(1, 5, 2, 4),
               minor(5, 6, 3, 8), minor(0, 8, 2, 6), minor(2, 3, 0, 5),
               minor(3, 7, 4, 6), minor(1, 6, 0, 7), minor(0, 4, 1, 3)};
}

// The least eigenvalue of a symmetric matrix and its direction, by Jacobi's rotations.
std::pair<double, std::array<double, 3>> least_eigenvalue(Plain s) {
  Plain v = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  for (int sweep = 0; sweep < 12; ++sweep)
    for (const auto& [p, q] : {std::pair{0u, 1u}, {0u, 2u}, {1u, 2u}}) {
      const double off = s[3 * p + q];
      if (off == 0) continue;
      const double angle = 0.5 * std::atan2(2 * off, s[4 * q] - s[4 * p]);
      const double c = std::cos(angle), t = std::sin(angle);
      for (unsigned k = 0; k < 3; ++k) {
        const double a = s[3 * k + p], b = s[3 * k + q];
        s[3 * k + p] = c * a - t * b, s[3 * k + q] = t * a + c * b;
      }
      for (unsigned k = 0; k < 3; ++k) {
        const double a = s[3 * p + k], b = s[3 * q + k];
        s[3 * p + k] = c * a - t * b, s[3 * q + k] = t * a + c * b;
        const double x = v[3 * k + p], y = v[3 * k + q];
        v[3 * k + p] = c * x - t * y, v[3 * k + q] = t * x + c * y;
      }
    }
  const unsigned m = s[0] <= s[4] && s[0] <= s[8] ? 0 : s[4] <= s[8] ? 1 : 2;
  return {s[4 * m], {v[m], v[3 + m], v[6 + m]}};
}

double norm_of(const Plain& m) {
  double sum = 0;
  for (const double x : m) sum += x * x;
  return std::sqrt(sum);
}

DmsMatrix short_matrix(const Plain& r) {
  double most = 0;
  for (const double x : r) most = std::max(most, std::abs(x));
  DmsMatrix out;
  if (!(most > 0) || !std::isfinite(most)) return out;
  for (std::size_t i = 0; i < 9; ++i)
    out[i] = Rational(static_cast<std::int64_t>(std::round(r[i] / most * kLargestEntry)));
  return out;
}

// The worst G for R: its place, the least eigenvalue over the norm of G, and the direction.
struct Worst {
  std::size_t at = 0;
  double value = 0;
  std::array<double, 3> direction{};
};
Worst worst_of(const Plain& r, const std::vector<Plain>& all) {
  Worst out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto [value, direction] = least_eigenvalue(symmetric_product(r, all[i]));
    if (i == 0 || value < out.value) out = {i, value, direction};
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

std::optional<DmsMatrix> find_monotone_matrix(std::span<const EnclosedMatrix* const> all) {
  std::vector<Plain> plain;
  Plain mean{};
  for (const EnclosedMatrix* const g : all) {
    Plain p = approximate(*g);
    const double norm = norm_of(p);
    if (!(norm > 0) || !std::isfinite(norm)) return std::nullopt;
    for (double& x : p) x /= norm;
    plain.push_back(p);
    for (std::size_t i = 0; i < 9; ++i) mean[i] += p[i];
  }
  std::optional<Plain> r = inverse_of(mean);
  if (!r) return std::nullopt;
  const double size = norm_of(*r);
  for (double& x : *r) x /= size;
  // A turn raises the least eigenvalue of the worst product: its derivative by R is 2 x (G x)^T, x its direction.
  for (int turn = 0; turn <= kMaxTurns; ++turn) {
    const Worst worst = worst_of(*r, plain);
    if (worst.value > 0) {
      const EnclosedMatrix candidate(short_matrix(*r));
      if (is_monotone_with_all(candidate, all)) return candidate.exact;
    }
    const Plain& g = plain[worst.at];
    const auto& x = worst.direction;
    const double step = 0.25 / (1 + turn);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        (*r)[3 * i + j] +=
            step * x[i] * (g[3 * j] * x[0] + g[3 * j + 1] * x[1] + g[3 * j + 2] * x[2]);
  }
  return std::nullopt;
}

}  // namespace veritope
