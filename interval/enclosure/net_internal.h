// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/enclosure/net_internal.h: control nets of one piece in work space that is not allocated twice.
#pragma once
#include <cstddef>

#include "interval/relations.h"
#include "interval/ring_numbers.h"
#include "splines/de_casteljau.h"

namespace veritope::internal {

/// t a for t >= 0 and finite operands: of the four products of bounds two will do.
inline Interval times_nonnegative(const Interval& t, const Interval& a) {
  return Interval::nonnegative_multiple(a, t);
}

// De Casteljau's scheme as in splines/, with factors in [0, 1] or any.
inline void keep_left_inside(Interval* first, std::size_t stride, std::size_t degree,
                             const Interval& s, const Interval& t) {
  for (std::size_t level = 1; level <= degree; ++level)
    for (std::size_t i = degree; i >= level; --i) {
      Interval& p = first[i * stride];
      p = times_nonnegative(s, first[(i - 1) * stride]) + times_nonnegative(t, p);
    }
}
inline void keep_right_inside(Interval* first, std::size_t stride, std::size_t degree,
                              const Interval& s, const Interval& t) {
  for (std::size_t level = 1; level <= degree; ++level)
    for (std::size_t i = 0; i + level <= degree; ++i) {
      Interval& p = first[i * stride];
      p = times_nonnegative(s, p) + times_nonnegative(t, first[(i + 1) * stride]);
    }
}
inline void keep_left_anywhere(Interval* first, std::size_t stride, std::size_t degree,
                               const Interval& s, const Interval& t) {
  keep_left(first, stride, static_cast<int>(degree), s, t);
}
inline void keep_right_anywhere(Interval* first, std::size_t stride, std::size_t degree,
                                const Interval& s, const Interval& t) {
  keep_right(first, stride, static_cast<int>(degree), s, t);
}

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
  bool left_first, is_inside;
  Cut(const Interval& t0, const Interval& t1) {
    const Interval one(1.0);
    left_first = t1.hi() > 0.5;
    if (left_first) {
      left = t1, right = t0 / t1;
    } else {
      right = t0, left = (t1 - t0) / (one - t0);
    }
    one_minus_left = one - left, one_minus_right = one - right;
    // Rounding may take a factor beyond 0; a number below it is then no factor of the exact cut.
    is_inside = t0.lo() >= 0 && t1.hi() <= 1;
    if (is_inside)
      for (Interval* f : {&left, &one_minus_left, &right, &one_minus_right})
        *f = intersection(*f, Interval::from_bounds(0, 1));
  }
  void apply(Interval* line, std::size_t stride, std::size_t degree) const {
    const auto left_part = is_inside ? keep_left_inside : keep_left_anywhere;
    const auto right_part = is_inside ? keep_right_inside : keep_right_anywhere;
    if (left_first) left_part(line, stride, degree, one_minus_left, left);
    right_part(line, stride, degree, one_minus_right, right);
    if (!left_first) left_part(line, stride, degree, one_minus_left, left);
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
