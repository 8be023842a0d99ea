// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/de_casteljau_line.h: de Casteljau's scheme on one line of Bernstein coefficients, for any numbers and any
// way to blend two neighbours. Evaluation, subdivision and restriction in all layers call these loops. Design:
// docs/design/0023-one-toolbox-of-splines.md.
#pragma once
#include <cstddef>

namespace veritope::internal {

// A blend combines two neighbours a, b, and stores the result in the place of one of them:
//   into_first(a, b)    a <- blend of a and b
//   into_second(a, b)   b <- blend of a and b

/// s a + t b. With s = 1 - t the scheme cuts at t. With other s and t, s + t not 0, it cuts at t / (s + t), and the
/// result of n blends one after the other is (s + t)^n times as large: integers avoid a division this way.
template <typename R>
struct AffineBlend {
  R s, t;

  void into_first(R& a, const R& b) const { combine(a, s, b, t); }
  void into_second(const R& a, R& b) const {
    if constexpr (kInPlace) {
      combine(b, t, a, s);
    } else {
      b = s * a + t * b;
    }
  }

 private:
  static constexpr bool kInPlace = requires(R x, const R& y) { x.add_product(y, y); };
  /// x <- p x + q y
  static void combine(R& x, const R& p, const R& y, const R& q) {
    if constexpr (kInPlace) {
      x *= p;
      x.add_product(q, y);
    } else {
      x = p * x + q * y;
    }
  }
};

/// half (a + b), the cut at 1/2.
template <typename R>
struct HalfBlend {
  R half;  // 1/2 as a number of the ring

  void into_first(R& a, const R& b) const { a = half * (a + b); }
  void into_second(const R& a, R& b) const { b = half * (a + b); }
};

// The entries of a line of degree n are first[0], first[stride], ..., first[n stride].

/// One step towards the front: entry i becomes the blend of i and i + 1, for i = 0 .. n - 1. Entry n stays.
template <typename R, typename Blend>
void blend_forward(R* first, std::size_t stride, int n, const Blend& blend) {
  for (int i = 0; i < n; ++i) {
    R* const p = first + static_cast<std::size_t>(i) * stride;
    blend.into_first(p[0], p[stride]);
  }
}
/// One step towards the back: entry i becomes the blend of i - 1 and i, for i = n .. 1. Entry 0 stays.
template <typename R, typename Blend>
void blend_backward(R* first, std::size_t stride, int n, const Blend& blend) {
  for (int i = n; i > 0; --i) {
    R* const p = first + static_cast<std::size_t>(i - 1) * stride;
    blend.into_second(p[0], p[stride]);
  }
}

/// The coefficients on the part [t, 1], where t is the blend's cut. The first one is the value at t.
template <typename R, typename Blend>
void keep_right(R* first, std::size_t stride, int degree, const Blend& blend) {
  for (int left = degree; left > 0; --left) blend_forward(first, stride, left, blend);
}
/// The coefficients on the part [0, t]. The last one is the value at t.
template <typename R, typename Blend>
void keep_left(R* first, std::size_t stride, int degree, const Blend& blend) {
  for (int level = 0; level < degree; ++level)
    blend_backward(first + static_cast<std::size_t>(level) * stride, stride, degree - level, blend);
}

/// Both parts at the cost of one: the right part stays in the line, the left part goes to `left`, with its own stride.
template <typename R, typename Blend>
void split_keeping_right(R* first, std::size_t stride, int degree, R* left, std::size_t left_stride,
                         const Blend& blend) {
  for (int level = 0; level <= degree; ++level) {
    left[static_cast<std::size_t>(level) * left_stride] = first[0];
    blend_forward(first, stride, degree - level, blend);
  }
}
/// Both parts at the cost of one: the left part stays in the line, the right part goes to `right`, with its own stride.
template <typename R, typename Blend>
void split_keeping_left(R* first, std::size_t stride, int degree, R* right,
                        std::size_t right_stride, const Blend& blend) {
  for (int level = 0; level <= degree; ++level) {
    right[static_cast<std::size_t>(degree - level) * right_stride] =
        first[static_cast<std::size_t>(degree) * stride];
    blend_backward(first + static_cast<std::size_t>(level) * stride, stride, degree - level, blend);
  }
}

}  // namespace veritope::internal
