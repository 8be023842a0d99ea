// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/enclosure/bernstein_product_internal.h: products and differences of polynomials of two variables in Bernstein form with
// interval coefficients. Scaled coefficients (times their binomials) turn products into sums without further factors.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "interval/interval.h"
#include "interval/ring_numbers.h"
#include "robust/base/check.h"
#include "splines/bezier.h"

namespace veritope::internal {

/// REQUIRES of all operations a live ScopedUpward. The signs of the scaled coefficients are those of the coefficients, and
/// what a convex cone says of the ones it says of the others.
class ScaledBernstein2 {
 public:
  ScaledBernstein2() = default;
  ScaledBernstein2(const Bezier<Interval, 2>& map, int component) : degrees_(map.degrees()) {
    const auto u = binomials(degrees_[0]), v = binomials(degrees_[1]);
    std::size_t i = 0;
    for (const Interval& a : u)
      for (const Interval& b : v) scaled_.push_back(map.component(component)[i++] * (a * b));
  }
  std::size_t size() const { return scaled_.size(); }
  const Interval& scaled(std::size_t i) const { return scaled_[i]; }

  friend ScaledBernstein2 operator*(const ScaledBernstein2& a, const ScaledBernstein2& b) {
    ScaledBernstein2 out;
    out.degrees_ = {a.degrees_[0] + b.degrees_[0], a.degrees_[1] + b.degrees_[1]};
    const std::size_t na = a.width(), nb = b.width(), n = out.width();
    out.scaled_.assign(n * (static_cast<std::size_t>(out.degrees_[0]) + 1), Interval());
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t j = 0; j < b.size(); ++j)
        out.scaled_[(i / na + j / nb) * n + i % na + j % nb] += a.scaled_[i] * b.scaled_[j];
    return out;
  }
  friend ScaledBernstein2 operator-(ScaledBernstein2 a, const ScaledBernstein2& b) {
    a.raise_to(b.degrees_);
    ScaledBernstein2 c = b;
    c.raise_to(a.degrees_);
    for (std::size_t i = 0; i < a.size(); ++i) a.scaled_[i] -= c.scaled_[i];
    return a;
  }

 private:
  std::size_t width() const { return static_cast<std::size_t>(degrees_[1]) + 1; }
  /// Rows of Pascal's triangle; exact below 2^53, enclosed beyond.
  static std::vector<Interval> binomials(int n) {
    std::vector<Interval> row{Interval(1.0)};
    for (int k = 1; k <= n; ++k) {
      row.push_back(Interval(1.0));
      for (int i = k - 1; i > 0; --i)
        row[static_cast<std::size_t>(i)] += row[static_cast<std::size_t>(i) - 1];
    }
    return row;
  }
  // At least those degrees: a product with 1 = (s + t)^k.
  void raise_to(const std::array<int, 2>& degrees) {
    std::array<int, 2> more{};
    for (std::size_t a = 0; a < 2; ++a) more[a] = std::max(0, degrees[a] - degrees_[a]);
    if (more == std::array<int, 2>{}) return;
    const auto count = static_cast<std::size_t>((more[0] + 1) * (more[1] + 1));
    const Bezier<Interval, 2> one(more, 1, false, std::vector<Interval>(count, Interval(1.0)));
    *this = *this * ScaledBernstein2(one, 0);
  }
  std::array<int, 2> degrees_{};
  std::vector<Interval> scaled_;
};

}  // namespace veritope::internal
