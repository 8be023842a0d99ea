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

/// The blend of a cut between 0 and 1, with two products of bounds a factor instead of four.
struct InsideBlend {
  Interval s, t;

  void into_first(Interval& a, const Interval& b) const {
    a = times_nonnegative(s, a) + times_nonnegative(t, b);
  }
  void into_second(const Interval& a, Interval& b) const {
    b = times_nonnegative(s, a) + times_nonnegative(t, b);
  }
};
/// Calls visit(blend) with the blend of the cut at t = 1 - s. REQUIRES s and t in [0, 1] if is_inside.
template <typename Visit>
void with_blend(bool is_inside, const Interval& s, const Interval& t, Visit visit) {
  if (is_inside)
    visit(InsideBlend{s, t});
  else
    visit(AffineBlend<Interval>{s, t});
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
  void apply(Interval* line, std::size_t stride, std::size_t size) const {
    const int degree = static_cast<int>(size) - 1;
    const auto cut_left = [&] {
      with_blend(is_inside, one_minus_left, left,
                 [&](const auto& blend) { keep_left(line, stride, degree, blend); });
    };
    if (left_first) cut_left();
    with_blend(is_inside, one_minus_right, right,
               [&](const auto& blend) { keep_right(line, stride, degree, blend); });
    if (!left_first) cut_left();
  }
};

inline void restrict_net(Interval* net, const NetShape& shape, const Cut& u, const Cut& v) {
  on_u_lines(net, shape, [&](Interval* l, std::size_t s) { u.apply(l, s, shape.rows); });
  on_v_lines(net, shape, [&](Interval* l, std::size_t s) { v.apply(l, s, shape.columns); });
}

/// The least interval around n numbers.
inline Interval hull_of(const Interval* first, std::size_t n) {
  Interval out = first[0];
  for (std::size_t i = 1; i < n; ++i) out = hull(out, first[i]);
  return out;
}

}  // namespace veritope::internal
