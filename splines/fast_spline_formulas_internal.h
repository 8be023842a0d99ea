// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/fast_spline_formulas_internal.h: the rounded operations of fast_spline.h, over any numbers: lanes of
// doubles, one double, or the counts of roundings that docs/bounds/fast_spline.md is tested with.
#pragma once
#include <cstddef>

namespace veritope::internal {
namespace {

/// The Bernstein polynomials of degree n at s in b[0..n], those of degree n - 1 in below[0..n - 1], t = 1 - s.
/// REQUIRES n >= 1. Uses only additions and products of numbers that are not negative.
template <typename T>
[[gnu::always_inline]] inline void bernstein_weights(int n, T s, T t, T one, T* b, T* below) {
  below[0] = one;
  b[0] = t, b[1] = s;
  for (int k = 2; k <= n; ++k) {
    for (int i = 0; i < k; ++i) below[i] = b[i];
    b[0] = t * below[0];
    for (int i = 1; i < k; ++i) b[i] = t * below[i] + s * below[i - 1];
    b[k] = s * below[k - 1];
  }
}
/// The derivatives of the Bernstein polynomials of degree n, divided by n. `below`: those of degree n - 1.
template <typename T>
[[gnu::always_inline]] inline void derivative_weights(int n, const T* below, T* d) {
  d[0] = -below[0];
  for (int i = 1; i < n; ++i) d[i] = below[i - 1] - below[i];
  d[n] = below[n - 1];
}

/// A value and its derivatives by the axes Axis, ..., N - 1.
template <typename T, std::size_t N>
struct Jet {
  T value, partial[N];
};

/// The sums over a tensor product of weights, the last axis first. Weights: value(axis, i), slope(axis, i),
/// degree(axis); Net: next(), coefficient after coefficient.
template <std::size_t N, typename T, typename Weights, typename Net>
struct Contraction {
  const Weights& w;
  Net& net;

  template <std::size_t Axis>
  [[gnu::always_inline]] T value() {
    if constexpr (Axis == N) {
      return net.next();
    } else {
      T sum = w.value(Axis, 0) * value<Axis + 1>();
      for (int i = 1; i <= w.degree(Axis); ++i) sum = sum + w.value(Axis, i) * value<Axis + 1>();
      return sum;
    }
  }
  template <std::size_t Axis>
  [[gnu::always_inline]] Jet<T, N> jet() {
    Jet<T, N> sum;
    if constexpr (Axis == N) {
      sum.value = net.next();
    } else {
      for (int i = 0; i <= w.degree(Axis); ++i) {
        const Jet<T, N> part = jet<Axis + 1>();
        const T b = w.value(Axis, i);
        const auto add = [i](T & to, T term) __attribute__((always_inline)) {
          to = i == 0 ? term : to + term;
        };
        add(sum.value, b * part.value);
        add(sum.partial[Axis], w.slope(Axis, i) * part.value);
        for (std::size_t k = Axis + 1; k < N; ++k) add(sum.partial[k], b * part.partial[k]);
      }
    }
    return sum;
  }
};

}  // namespace
}  // namespace veritope::internal
