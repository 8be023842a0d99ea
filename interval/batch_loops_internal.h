// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/batch_loops_internal.h: the entries of BatchKernels over a vector V of lanes.
#pragma once
#include <cstddef>

#include "interval/batch_kernels_internal.h"

namespace veritope {
namespace {

template <typename V>
struct Loops {
  using L = Lanes<V>;

  // out[i] = op(in[i]...); operands are read before out is written, index by index.
  template <typename Op, typename... In>
  [[gnu::always_inline]] static void each(BatchOut out, std::size_t n, Op op, In... in) {
    std::size_t i = 0;
    for (; i + V::kLanes <= n; i += V::kLanes) store(op(load<V>(in, i)...), out, i);
    if (i < n) store_part(op(load_part<V>(in, i, n - i)...), out, i, n - i);
  }

  static void neg(BatchIn a, BatchOut out, std::size_t n) {
    each(
        out, n, [](const L& x) { return minus(x); }, a);
  }
  static void add(BatchIn a, BatchIn b, BatchOut out, std::size_t n) {
    each(
        out, n, [](const L& x, const L& y) { return plus(x, y); }, a, b);
  }
  static void sub(BatchIn a, BatchIn b, BatchOut out, std::size_t n) {
    each(
        out, n, [](const L& x, const L& y) { return plus(x, minus(y)); }, a, b);
  }
  static void mul(BatchIn a, BatchIn b, BatchOut out, std::size_t n) {
    each(
        out, n, [](const L& x, const L& y) { return times(x, y); }, a, b);
  }
  static void div(BatchIn a, BatchIn b, BatchOut out, std::size_t n) {
    each(
        out, n, [](const L& x, const L& y) { return quotient(x, y); }, a, b);
  }
  static void sqr(BatchIn a, BatchOut out, std::size_t n) {
    each(
        out, n, [](const L& x) { return squared(x); }, a);
  }
  static void fma(BatchIn a, BatchIn b, BatchIn c, BatchOut out, std::size_t n) {
    each(
        out, n, [](const L& x, const L& y, const L& z) { return times_plus(x, y, z); }, a, b, c);
  }
  static void mul_add(BatchIn a, BatchIn b, BatchIn c, BatchOut out, std::size_t n) {
    each(
        out, n, [](const L& x, const L& y, const L& z) { return plus(times(x, y), z); }, a, b, c);
  }

  // There are eight sums whatever the number of lanes, so that every back end adds the same numbers in the same
  // order.
  static constexpr std::size_t kSums = 8, kVectors = kSums / V::kLanes;
  struct Sums {
    double neg_lo[kSums], hi[kSums];
  };
  template <typename Times>
  [[gnu::always_inline]] static bool dot_sums(BatchIn a, BatchIn b, std::size_t n, Sums& out) {
    const Times times{};
    L sum[kVectors];
    for (L& s : sum) s = {V::zero(), V::zero()};
    std::size_t i = 0;
    for (; i + kSums <= n; i += kSums) {
      for (std::size_t k = 0; k < kVectors; ++k) {
        const std::size_t at = i + k * V::kLanes;
        sum[k] = plus(sum[k], times(load<V>(a, at), load<V>(b, at)));
      }
    }
    for (std::size_t k = 0; i < n; ++k, i += V::kLanes) {
      const std::size_t count = n - i;
      const L x = count < V::kLanes ? load_part<V>(a, i, count) : load<V>(a, i);
      const L y = count < V::kLanes ? load_part<V>(b, i, count) : load<V>(b, i);
      sum[k] = plus(sum[k], times(x, y));
    }
    bool suspect = false;
    for (std::size_t k = 0; k < kVectors; ++k) {
      suspect |= is_suspect(sum[k]);
      store(sum[k], {out.neg_lo, out.hi}, k * V::kLanes);
    }
    return suspect;
  }
  static void dot(BatchIn a, BatchIn b, std::size_t n, double* neg_lo, double* hi) {
    Sums s;
    if (dot_sums<QuickTimes<V>>(a, b, n, s)) dot_sums<CarefulTimes<V>>(a, b, n, s);
    for (std::size_t half = kSums / 2; half > 0; half /= 2) {
      for (std::size_t k = 0; k < half; ++k) {
        const BatchIn sums{s.neg_lo, s.hi};
        store_part(plus(load_part<V>(sums, k, 1), load_part<V>(sums, k + half, 1)),
                   {s.neg_lo, s.hi}, k, 1);
      }
    }
    *neg_lo = s.neg_lo[0], *hi = s.hi[0];
  }

  struct Point {
    L x, y, z;
  };
  // The formula of predicates/formulas.h, Plane3.
  template <typename Times>
  [[gnu::always_inline]] static L determinant(const Point& a, const Point& b, const Point& c,
                                              const Point& d) {
    const Times times{};
    const auto minor = [&](const L& p, const L& q, const L& r, const L& s) {
      return plus(times(p, q), minus(times(r, s)));
    };
    const auto less = [](const L& p, const L& q) { return plus(p, minus(q)); };
    const L ux = less(b.x, a.x), uy = less(b.y, a.y), uz = less(b.z, a.z);
    const L vx = less(c.x, a.x), vy = less(c.y, a.y), vz = less(c.z, a.z);
    const L wx = less(d.x, a.x), wy = less(d.y, a.y), wz = less(d.z, a.z);
    const L x = times(wx, minor(uy, vz, uz, vy)), y = times(wy, minor(uz, vx, ux, vz));
    return plus(plus(x, y), times(wz, minor(ux, vy, uy, vx)));
  }
  [[gnu::noinline]] static L careful_determinant(const Point& a, const Point& b, const Point& c,
                                                 const Point& d) {
    return determinant<CarefulTimes<V>>(a, b, c, d);
  }
  [[gnu::always_inline]] static L quick_determinant(const Point& a, const Point& b, const Point& c,
                                                    const Point& d) {
    const L r = determinant<QuickTimes<V>>(a, b, c, d);
    if (is_suspect(r)) [[unlikely]]
      return careful_determinant(a, b, c, d);
    return r;
  }
  static void orient3d(const BatchIn* a, const BatchIn* b, const BatchIn* c, const BatchIn* d,
                       BatchOut out, std::size_t n) {
    std::size_t i = 0;
    const auto at = [&](const BatchIn* p) {
      return Point{load<V>(p[0], i), load<V>(p[1], i), load<V>(p[2], i)};
    };
    for (; i + V::kLanes <= n; i += V::kLanes)
      store(quick_determinant(at(a), at(b), at(c), at(d)), out, i);
    const std::size_t rest = n - i;
    const auto part = [&](const BatchIn* p) {
      return Point{load_part<V>(p[0], i, rest), load_part<V>(p[1], i, rest),
                   load_part<V>(p[2], i, rest)};
    };
    if (rest > 0) store_part(quick_determinant(part(a), part(b), part(c), part(d)), out, i, rest);
  }

  static void signs(BatchIn a, int* out, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
      const int above = a.neg_lo[i] < 0, below = a.hi[i] < 0;
      const int zero = static_cast<int>(a.neg_lo[i] == 0) & static_cast<int>(a.hi[i] == 0);
      out[i] = (above | below | zero) != 0 ? above - below : 2;
    }
  }
};

template <typename V>
constexpr BatchKernels kernels_of() {
  using K = Loops<V>;
  return {V::kUpward, K::neg, K::add,     K::sub, K::mul,      K::div,
          K::sqr,     K::fma, K::mul_add, K::dot, K::orient3d, K::signs};
}

}  // namespace
}  // namespace veritope
