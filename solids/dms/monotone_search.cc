// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/monotone_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace veritope::internal {
namespace {

constexpr double kFirstWeight = 1,
                 kWeightFactor = 8;  // of the shift beside the barrier, for each matrix
constexpr double kLeastGap = 1e-9;   // of shifts, at the end
constexpr int kNewtonSteps = 12, kHalvings = 40;
constexpr double kDamping = 1e-11;  // of the mean of the Hessian's diagonal

// Nine entries of Q and the shift s; behind them the multiplier of the equation for the trace.
constexpr std::size_t kUnknowns = 10, kSystem = 11;
using Unknowns = std::array<double, kUnknowns>;

// Q K + (Q K)^T + 2 s
PlainMatrix shifted(const Unknowns& x, const PlainMatrix& k) {
  PlainMatrix q;
  std::copy_n(x.begin(), 9, q.begin());
  const PlainMatrix p = multiplied(q, k);
  PlainMatrix out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      out[3 * i + j] = p[3 * i + j] + p[3 * j + i] + (i == j ? 2 * x[9] : 0);
  return out;
}
bool is_positive_definite(const PlainMatrix& s) {
  return s[0] > 0 && s[0] * s[4] - s[1] * s[3] > 0 && determinant_of(s) > 0;
}
PlainMatrix inverse_of_symmetric(const PlainMatrix& m) {
  const double d = determinant_of(m);
  const double a = (m[4] * m[8] - m[5] * m[5]) / d, b = (m[2] * m[5] - m[1] * m[8]) / d,
               c = (m[1] * m[5] - m[2] * m[4]) / d, e = (m[0] * m[8] - m[2] * m[2]) / d,
               f = (m[1] * m[2] - m[0] * m[5]) / d, g = (m[0] * m[4] - m[1] * m[1]) / d;
  return {a, b, c, b, e, f, c, f, g};
}

// By elimination with pivots; nothing for a singular system.
std::optional<Unknowns> solve(std::array<std::array<double, kSystem + 1>, kSystem> rows) {
  for (std::size_t c = 0; c < kSystem; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < kSystem; ++r)
      if (std::abs(rows[r][c]) > std::abs(rows[pivot][c])) pivot = r;
    std::swap(rows[c], rows[pivot]);
    if (!(std::abs(rows[c][c]) > 0)) return std::nullopt;
    for (std::size_t r = c + 1; r < kSystem; ++r) {
      const double factor = rows[r][c] / rows[c][c];
      for (std::size_t k = c; k <= kSystem; ++k) rows[r][k] -= factor * rows[c][k];
    }
  }
  std::array<double, kSystem> x{};
  for (std::size_t c = kSystem; c-- > 0;) {
    double sum = rows[c][kSystem];
    for (std::size_t k = c + 1; k < kSystem; ++k) sum -= rows[c][k] * x[k];
    x[c] = sum / rows[c][c];
    if (!std::isfinite(x[c])) return std::nullopt;
  }
  Unknowns out;
  std::copy_n(x.begin(), kUnknowns, out.begin());
  return out;
}

// Minimises weight s minus the logarithms of the determinants of all shifted products, with the sum of the traces of
// all Q K fixed. With s < 0 all products are positive definite.
class Barrier {
 public:
  explicit Barrier(std::span<const PlainMatrix> k) : k_(k) {
    double trace = 0;
    for (const PlainMatrix& m : k)
      for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b) {
          traces_[3 * a + b] += m[3 * b + a];
          if (a == b) trace += m[3 * a + b];
        }
    for (std::size_t a = 0; a < 3; ++a) x_[4 * a] = 1;
    // A shift that makes all of them positive definite: eigenvalues are at least minus twice the norm.
    x_[9] = 2;
    is_good_ = trace > 0;
  }
  bool is_good() const { return is_good_; }
  bool is_positive_without_shift() const {
    Unknowns unshifted = x_;
    unshifted[9] = 0;
    return std::all_of(k_.begin(), k_.end(), [&](const PlainMatrix& m) {
      return is_positive_definite(shifted(unshifted, m));
    });
  }
  double shift() const { return x_[9]; }
  PlainMatrix matrix() const {
    PlainMatrix q;
    std::copy_n(x_.begin(), 9, q.begin());
    return q;
  }

  // One step of Newton's method; false if it is the last one that pays.
  bool step(double weight) {
    std::array<std::array<double, kSystem + 1>, kSystem> rows{};
    Unknowns gradient{};
    gradient[9] = weight;
    for (const PlainMatrix& m : k_) add(m, gradient, rows);
    double diagonal = 0;
    for (std::size_t i = 0; i < kUnknowns; ++i) diagonal += rows[i][i] / kUnknowns;
    for (std::size_t i = 0; i < kUnknowns; ++i) {
      rows[i][i] += kDamping * diagonal;
      rows[i][kSystem] = -gradient[i];
      if (i < 9) rows[i][kUnknowns] = rows[kUnknowns][i] = traces_[i];
    }
    const auto change = solve(rows);
    if (!change) return false;
    double slope = 0;
    for (std::size_t i = 0; i < kUnknowns; ++i) slope += gradient[i] * (*change)[i];
    if (!(slope < 0)) return false;
    const double before = *value(x_, weight);
    double share = 1;
    for (int halving = 0; halving < kHalvings; ++halving, share /= 2) {
      Unknowns next = x_;
      for (std::size_t i = 0; i < kUnknowns; ++i) next[i] += share * (*change)[i];
      const auto after = value(next, weight);
      if (!after || *after > before + 0.1 * share * slope) continue;
      x_ = next;
      return -slope > 1e-3;
    }
    return false;
  }

 private:
  std::optional<double> value(const Unknowns& x, double weight) const {
    double out = weight * x[9];
    for (const PlainMatrix& m : k_) {
      const PlainMatrix s = shifted(x, m);
      if (!is_positive_definite(s)) return std::nullopt;
      out -= std::log(determinant_of(s));
    }
    return out;
  }
  // With W the inverse of the shifted product: the derivative by Q_ab is -2 (K W)_ba, the second one by Q_cd too is
  // 2 (K W)_bc (K W)_da + 2 (K W K^T)_bd W_ac.
  void add(const PlainMatrix& k, Unknowns& gradient,
           std::array<std::array<double, kSystem + 1>, kSystem>& rows) const {
    const PlainMatrix w = inverse_of_symmetric(shifted(x_, k)), kw = multiplied(k, w),
                      kww = multiplied(kw, w);
    PlainMatrix kwk{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t m = 0; m < 3; ++m) kwk[3 * i + j] += kw[3 * i + m] * k[3 * j + m];
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) {
        const std::size_t p = 3 * a + b;
        gradient[p] -= 2 * kw[3 * b + a];
        for (std::size_t c = 0; c < 3; ++c)
          for (std::size_t d = 0; d < 3; ++d)
            rows[p][3 * c + d] +=
                2 * (kw[3 * b + c] * kw[3 * d + a] + kwk[3 * b + d] * w[3 * a + c]);
        const double mixed = 4 * kww[3 * b + a];
        rows[p][9] += mixed;
        rows[9][p] += mixed;
      }
    gradient[9] -= 2 * (w[0] + w[4] + w[8]);
    double square = 0;
    for (const double x : w) square += x * x;
    rows[9][9] += 4 * square;
  }

  std::span<const PlainMatrix> k_;
  std::array<double, 9>
      traces_{};  // the sum of the traces is that of their products with Q's entries
  Unknowns x_{};
  bool is_good_ = false;
};

}  // namespace

bool search_monotone(std::span<const PlainMatrix> k,
                     const std::function<bool(const PlainMatrix&)>& accept) {
  Barrier barrier(k);
  if (!barrier.is_good()) return false;
  if (barrier.is_positive_without_shift() && accept(barrier.matrix())) return true;
  const auto count = static_cast<double>(k.size());
  // At the minimum for a weight the shift is above the least one by at most 3 matrices / weight.
  for (double weight = kFirstWeight * count; 3 * count / weight > kLeastGap;
       weight *= kWeightFactor) {
    for (int i = 0; i < kNewtonSteps; ++i) {
      const bool goes_on = barrier.step(weight);
      if (barrier.shift() < 0 && accept(barrier.matrix())) return true;
      if (!goes_on) break;
    }
    if (barrier.shift() > 3 * count / weight) return false;
  }
  return false;
}

}  // namespace veritope::internal
