// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/net_internal.h: control nets of one piece in work space that is not allocated twice.
#pragma once
#include <cstddef>

#include "interval/ring_numbers.h"
#include "splines/de_casteljau.h"

namespace veritope::internal {

/// A net of `components` blocks of rows x columns numbers, the column (v) fastest.
struct NetShape {
  std::size_t rows, columns, components;
  std::size_t count() const { return rows * columns; }
  std::size_t size() const { return count() * components; }
};

template <typename OnLine>
void on_u_lines(Interval* net, const NetShape& shape, OnLine on_line) {
  for (std::size_t c = 0; c < shape.components; ++c)
    for (std::size_t j = 0; j < shape.columns; ++j)
      on_line(net + c * shape.count() + j, shape.columns);
}
template <typename OnLine>
void on_v_lines(Interval* net, const NetShape& shape, OnLine on_line) {
  for (std::size_t c = 0; c < shape.components; ++c)
    for (std::size_t i = 0; i < shape.rows; ++i)
      on_line(net + c * shape.count() + i * shape.columns, std::size_t{1});
}

/// A line of control points restricted to [t0, t1], any two numbers; both divisions stay away from zero.
struct Cut {
  Interval left, one_minus_left, right, one_minus_right;
  bool left_first;
  Cut(const Interval& t0, const Interval& t1) {
    const Interval one(1.0);
    left_first = t1.hi() > 0.5;
    if (left_first) {
      left = t1, right = t0 / t1;
    } else {
      right = t0, left = (t1 - t0) / (one - t0);
    }
    one_minus_left = one - left, one_minus_right = one - right;
  }
  void apply(Interval* line, std::size_t stride, std::size_t degree) const {
    const int d = static_cast<int>(degree);
    if (left_first) keep_left(line, stride, d, one_minus_left, left);
    keep_right(line, stride, d, one_minus_right, right);
    if (!left_first) keep_left(line, stride, d, one_minus_left, left);
  }
};

inline void restrict_net(Interval* net, const NetShape& shape, const Cut& u, const Cut& v) {
  on_u_lines(net, shape, [&](Interval* l, std::size_t s) { u.apply(l, s, shape.rows - 1); });
  on_v_lines(net, shape, [&](Interval* l, std::size_t s) { v.apply(l, s, shape.columns - 1); });
}

/// The least interval around n numbers.
inline Interval hull_of(const Interval* first, std::size_t n) {
  Interval out = first[0];
  for (std::size_t i = 1; i < n; ++i) out = hull(out, first[i]);
  return out;
}

}  // namespace veritope::internal
