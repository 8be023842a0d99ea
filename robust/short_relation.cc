// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/short_relation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "robust/base/check.h"

namespace veritope {
namespace {

constexpr int kBitsAtATime =
    20;  // the basis stays so near to a reduced one that doubles orthogonalise it

// x / 2^bits, rounded to 60 bits or fewer.
double scaled(Integer x, std::int64_t bits) {
  const auto length = static_cast<std::int64_t>(x.bit_length());
  if (length > 60) {
    x.shift_right(static_cast<std::uint64_t>(length - 60));
    bits -= length - 60;
  }
  return std::ldexp(static_cast<double>(x.to_int64()), static_cast<int>(-bits));
}

// floor(x / 2^by + 1/2).
Integer rounded(Integer x, std::uint64_t by) {
  if (by == 0) return x;
  x += power_of_two(by - 1);
  return x.shift_right(by);
}

// Rows of n coefficients and, last, the sum of coefficients and values.
class Basis {
 public:
  explicit Basis(const std::vector<Integer>& values) : values_(values), n_(values.size()) {
    for (std::size_t i = 0; i < n_; ++i) {
      rows_.emplace_back(n_ + 1);
      rows_[i][i] = Integer(1);
    }
  }

  // Reduces the basis with the values divided by 2^by.
  void reduce(std::uint64_t by) {
    for (auto& row : rows_) {
      row[n_] = Integer();
      for (std::size_t i = 0; i < n_; ++i)
        if (!row[i].is_zero()) row[n_].add_product(row[i], values_[i]);
      row[n_] = rounded(std::move(row[n_]), by);
    }
    // A bound on the work: roundings could make it cycle.
    for (int steps = 0; steps < 2000; ++steps)
      if (!step()) return;
  }

  std::vector<Integer> first() const { return {rows_[0].begin(), rows_[0].end() - 1}; }

 private:
  using Vector = std::vector<double>;
  static double dot(const Vector& a, const Vector& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  }

  // Makes all rows short beside those before them, then exchanges the first two neighbours that break Lovasz'
  // condition. False if none does.
  bool step() {
    std::int64_t bits = 0;
    for (const auto& row : rows_)
      for (const Integer& x : row) bits = std::max(bits, static_cast<std::int64_t>(x.bit_length()));
    std::vector<Vector> exact(n_), orthogonal(n_);
    Vector norm(n_);
    for (std::size_t i = 0; i < n_; ++i) {
      for (const Integer& x : rows_[i]) exact[i].push_back(scaled(x, bits));
      orthogonal[i] = exact[i];
      for (std::size_t j = i; j-- > 0;) {
        if (!(norm[j] > 0)) continue;
        const double times = std::nearbyint(dot(exact[i], orthogonal[j]) / norm[j]);
        if (times == 0 || !(std::abs(times) < 0x1p62)) continue;
        const Integer t(static_cast<std::int64_t>(times));
        for (std::size_t k = 0; k <= n_; ++k) {
          rows_[i][k].subtract_product(t, rows_[j][k]);
          exact[i][k] -= times * exact[j][k];
        }
      }
      orthogonal[i] = exact[i];
      double before = 0;
      for (std::size_t j = 0; j < i; ++j) {
        if (!(norm[j] > 0)) continue;
        const double m = dot(exact[i], orthogonal[j]) / norm[j];
        for (std::size_t k = 0; k <= n_; ++k) orthogonal[i][k] -= m * orthogonal[j][k];
        if (j + 1 == i) before = m;
      }
      norm[i] = dot(orthogonal[i], orthogonal[i]);
      if (i > 0 && norm[i] < (0.75 - before * before) * norm[i - 1]) {
        std::swap(rows_[i], rows_[i - 1]);
        return true;
      }
    }
    return false;
  }

  const std::vector<Integer>& values_;
  std::size_t n_;
  std::vector<std::vector<Integer>> rows_;
};

}  // namespace

std::vector<Integer> short_relation(const std::vector<Integer>& values, int bits) {
  VT_CHECK(values.size() >= 2 && values.size() <= 12, "a relation is between 2 to 12 numbers");
  Basis basis(values);
  for (int left = bits; left > 0;) {
    left = std::max(left - kBitsAtATime, 0);
    basis.reduce(static_cast<std::uint64_t>(left));
  }
  return basis.first();
}

std::vector<Integer> plausible_polynomial(const Integer& x, int bits, int max_degree) {
  std::vector<Integer> powers{power_of_two(static_cast<std::uint64_t>(bits))};
  for (int degree = 1; degree <= max_degree; ++degree) {
    powers.push_back(rounded(powers.back() * x, static_cast<std::uint64_t>(bits)));
    std::vector<Integer> out = short_relation(powers, bits);
    std::uint64_t longest = 0;
    for (const Integer& c : out) longest = std::max(longest, c.bit_length());
    // Those of a number without a relation have bits / (degree + 1) bits each.
    if (4 * (longest + 8) * static_cast<std::uint64_t>(degree + 1) >
        3 * static_cast<std::uint64_t>(bits))
      continue;
    while (!out.empty() && out.back().is_zero()) out.pop_back();
    if (out.size() < 2) continue;
    Integer common;
    for (const Integer& c : out) common = gcd(common, c);
    if (out.back().sign() == Sign::kNegative) common.negate();
    for (Integer& c : out) c = divide_exactly(c, common);
    return out;
  }
  return {};
}

}  // namespace veritope
