// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/reverse.h"

namespace veritope {

std::pair<Interval, Interval> mul_rev_to_pair(const Interval& b, const Interval& c) {
  const std::pair<Interval, Interval> none(Interval::empty(), Interval::empty());
  if (b.is_empty() || c.is_empty()) return none;
  const ScopedUpward upward;
  if (!is_member(0, b)) return {c / b, Interval::empty()};
  if (is_member(0, c)) return {Interval::entire(), Interval::empty()};
  // c has one sign: b's negative and positive part give one half line each.
  const Interval negative = intersection(b, Interval::from_bounds(Interval::entire().lo(), 0));
  const Interval positive = intersection(b, Interval::from_bounds(0, Interval::entire().hi()));
  Interval first = c / negative, second = c / positive;
  if (first.is_empty() || (!second.is_empty() && precedes(second, first))) std::swap(first, second);
  return {first, second};
}

std::pair<DecoratedInterval, DecoratedInterval> mul_rev_to_pair(const DecoratedInterval& b,
                                                                const DecoratedInterval& c) {
  if (b.is_nai() || c.is_nai()) return {DecoratedInterval::nai(), DecoratedInterval::nai()};
  const auto [first, second] = mul_rev_to_pair(b.interval(), c.interval());
  const Decoration d = is_member(0, b.interval()) || b.interval().is_empty()
                           ? Decoration::kTrv
                           : weakest(b.decoration(), c.decoration());
  return {DecoratedInterval(first, d), DecoratedInterval(second, Decoration::kTrv)};
}

Interval mul_rev(const Interval& b, const Interval& c, const Interval& in) {
  const auto [first, second] = mul_rev_to_pair(b, c);
  return hull(intersection(first, in), intersection(second, in));
}

}  // namespace veritope
