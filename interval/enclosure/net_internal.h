// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/enclosure/net_internal.h: control nets of one piece, in work space that is reused.
#pragma once
#include <cstddef>

#include "interval/relations.h"
#include "interval/ring_numbers.h"
#include "splines/de_casteljau.h"
#include "splines/restriction.h"

namespace veritope::internal {

/// t a for t >= 0 and finite operands: two of the four products of bounds are enough.
inline Interval times_nonnegative(const Interval& t, const Interval& a) {
  return Interval::nonnegative_multiple(a, t);
}

/// The blend of a cut between 0 and 1, with two products of bounds per factor instead of four.
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

/// A line of control points restricted to [t0, t1], any two numbers.
struct Cut {
  PartCuts<InsideBlend> cuts;
  bool is_inside;

  // At exactly 1/2 both orders are good; the begin comes first here, which keeps the last bits of published
  // intersections.
  Cut(const Interval& t0, const Interval& t1)
      : cuts{{cuts_end_first(t1.hi()) && t1.hi() != 0.5, true, true}, {}, {}},
        is_inside(t0.lo() >= 0 && t1.hi() <= 1) {
    const Interval one(1.0);
    const CutPlaces<Interval> places(t0, t1, one, cuts.order.end_first);
    cuts.begin = {one - places.begin, places.begin};
    cuts.end = {one - places.end, places.end};
    // Rounding may move a factor below 0, where no factor of the exact cut lies.
    if (is_inside)
      for (InsideBlend* blend : {&cuts.begin, &cuts.end})
        for (Interval* f : {&blend->s, &blend->t})
          *f = intersection(*f, Interval::from_bounds(0, 1));
  }
  void apply(Interval* line, std::size_t stride, std::size_t size) const {
    const int degree = static_cast<int>(size) - 1;
    if (is_inside) return cuts.apply(line, stride, degree);
    const PartCuts<AffineBlend<Interval>> outside{
        cuts.order, {cuts.begin.s, cuts.begin.t}, {cuts.end.s, cuts.end.t}};
    outside.apply(line, stride, degree);
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
