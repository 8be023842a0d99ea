// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/interval/batch_oracle.h: random intervals, and their operations in rationals with two infinities.
#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "interval/batch.h"
#include "robust/base/random.h"
#include "robust/binary64.h"

namespace veritope::test {

inline constexpr double kInf = std::numeric_limits<double>::infinity();
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kMax = std::numeric_limits<double>::max();

inline std::vector<BatchBackEnd> back_ends() {
  std::vector<BatchBackEnd> all;
  for (const BatchBackEnd b : {BatchBackEnd::kBaseline, BatchBackEnd::kAvx2, BatchBackEnd::kAvx512,
                               BatchBackEnd::kNearest}) {
    if (is_available(b)) all.push_back(b);
  }
  return all;
}

struct Bounds {
  double lo = 0, hi = 0;
  bool is_empty() const { return std::isnan(lo) || std::isnan(hi); }
};
inline const Bounds kEmpty{kNaN, kNaN};
inline std::string text(const Bounds& b) {
  char s[80];
  std::snprintf(s, sizeof s, "[%a, %a]", b.lo, b.hi);
  return s;
}

struct Array {
  std::vector<double> neg_lo, hi;
  explicit Array(std::size_t n = 0) : neg_lo(n), hi(n) {}
  explicit Array(const std::vector<Bounds>& v) {
    for (const Bounds& b : v) neg_lo.push_back(-b.lo), hi.push_back(b.hi);
  }
  std::size_t size() const { return hi.size(); }
  Bounds at(std::size_t i) const { return {-neg_lo[i], hi[i]}; }
  ConstIntervalSpan in(std::size_t from = 0) const {
    return {neg_lo.data() + from, hi.data() + from, size() - from};
  }
  IntervalSpan out(std::size_t from = 0) {
    return {neg_lo.data() + from, hi.data() + from, size() - from};
  }
};

// Numbers of all exponents, small integers, ties, subnormals, limits; infinities by `bounds`.
inline double number(Random& random) {
  constexpr double kSpecial[] = {0.0, -0.0, 1, -1, kMax, -kMax, 0x1p-1074, -0x1p-1074, 0x1p-1022};
  for (;;) {
    double v = std::bit_cast<double>(random.next());
    switch (random.below(6)) {
      case 0: v = static_cast<double>(random.between(-3, 3)); break;
      case 1:
        v = std::ldexp(2 * random.unit() - 1, static_cast<int>(random.between(-20, 20)));
        break;
      case 2: v = static_cast<double>(random.between(-9, 9)) * 0x1p-1074; break;
      case 3: v = kSpecial[random.below(std::size(kSpecial))]; break;
      default: break;
    }
    if (is_finite(v)) return v;
  }
}
inline Bounds bounds(Random& random) {
  Bounds b{number(random), number(random)};
  if (random.below(4) == 0) b.hi = b.lo;
  if (b.lo > b.hi) std::swap(b.lo, b.hi);
  switch (random.below(24)) {
    case 0: b.lo = -kInf; break;
    case 1: b.hi = kInf; break;
    case 2: b = {-kInf, kInf}; break;
    case 3: b = kEmpty; break;
    default: break;
  }
  return b;
}
inline std::vector<Bounds> many(Random& random, std::size_t n) {
  std::vector<Bounds> v;
  for (std::size_t i = 0; i < n; ++i) v.push_back(bounds(random));
  return v;
}
// Every interval with bounds among these.
inline std::vector<Bounds> special() {
  std::vector<double> v{-kInf, -kMax, -1, -0x1p-1074, -0.0, 0.0, 0x1p-1074, 1, kMax, kInf};
  std::vector<Bounds> all{kEmpty};
  for (const double lo : v) {
    for (const double hi : v) {
      if (lo <= hi && lo < kInf && hi > -kInf) all.push_back({lo, hi});
    }
  }
  return all;
}

// The oracle: rationals and two infinities, on which 0 * infinity is 0.
struct Extended {
  int infinite = 0;
  Rational v;
  Extended(double d) : infinite(d == kInf ? 1 : (d == -kInf ? -1 : 0)) {
    if (infinite == 0) v = Rational::from_double(d);
  }
  Extended(Rational r) : v(std::move(r)) {}
  int sign() const { return infinite != 0 ? infinite : to_int(v.sign()); }
  double down() const { return infinite != 0 ? infinite * kInf : round_down(v); }
  double up() const { return infinite != 0 ? infinite * kInf : round_up(v); }
};
inline Extended operator*(const Extended& x, const Extended& y) {
  if (x.sign() == 0 || y.sign() == 0) return Rational(0);
  if (x.infinite != 0 || y.infinite != 0) return x.sign() * y.sign() * kInf;
  return x.v * y.v;
}
inline Extended operator+(const Extended& x,
                          const Extended& y) {  // never of two opposite infinities
  if (x.infinite != 0) return x;
  return y.infinite != 0 ? y : Extended(x.v + y.v);
}
inline Extended operator/(const Extended& x, const Extended& y) {  // y != 0
  if (y.infinite != 0) return Rational(0);
  return x.infinite != 0 ? Extended(x.sign() * y.sign() * kInf) : Extended(x.v / y.v);
}
inline bool less(const Extended& x, const Extended& y) {
  if (x.infinite != 0 || y.infinite != 0) return x.infinite < y.infinite;
  return x.v < y.v;
}
struct Hull {
  std::vector<Extended> all;
  Bounds rounded() const {
    const auto [lo, hi] = std::minmax_element(all.begin(), all.end(), less);
    return {lo->down(), hi->up()};
  }
};

inline Bounds exact_add(const Bounds& a, const Bounds& b) {
  return {(Extended(a.lo) + b.lo).down(), (Extended(a.hi) + b.hi).up()};
}
inline Bounds exact_mul(const Bounds& a, const Bounds& b) {
  return Hull{
      {Extended(a.lo) * b.lo, Extended(a.lo) * b.hi, Extended(a.hi) * b.lo, Extended(a.hi) * b.hi}}
      .rounded();
}
inline Bounds exact_fma(const Bounds& a, const Bounds& b, const Bounds& c) {
  const Hull p{
      {Extended(a.lo) * b.lo, Extended(a.lo) * b.hi, Extended(a.hi) * b.lo, Extended(a.hi) * b.hi}};
  const auto [lo, hi] = std::minmax_element(p.all.begin(), p.all.end(), less);
  return {(*lo + c.lo).down(), (*hi + c.hi).up()};
}
inline Bounds exact_sqr(const Bounds& a) {
  const Extended lo(a.lo), hi(a.hi), p = lo * lo, q = hi * hi;
  if (lo.sign() * hi.sign() <= 0) return {0, (less(p, q) ? q : p).up()};
  return Hull{{p, q}}.rounded();
}
inline Bounds exact_div(const Bounds& a, const Bounds& b) {
  if (b.lo == 0 && b.hi == 0) return kEmpty;
  if (a.lo == 0 && a.hi == 0) return {0, 0};
  if (b.lo < 0 && b.hi > 0) return {-kInf, kInf};
  Hull h;
  for (const double x : {a.lo, a.hi}) {
    for (const double y : {b.lo, b.hi}) {
      if (y != 0) {
        h.all.push_back(Extended(x) / y);
      } else if (x != 0) {
        h.all.push_back((x > 0 ? 1 : -1) * (b.hi > 0 ? 1 : -1) * kInf);
      } else {
        h.all.push_back(Rational(0));
      }
    }
  }
  return h.rounded();
}

}  // namespace veritope::test
