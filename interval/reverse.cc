// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/reverse.h"

#include "interval/functions.h"
#include "interval/mpfr_internal.h"
#include "robust/base/check.h"
#include "robust/base/fp_guard.h"

namespace veritope {

std::pair<Interval, Interval> mul_rev_to_pair(const Interval& b, const Interval& c) {
  if (b.is_empty() || c.is_empty()) return {Interval::empty(), Interval::empty()};
  const ScopedUpward upward;
  if (!is_member(0, b)) return {c / b, Interval::empty()};
  if (is_member(0, c)) return {Interval::entire(), Interval::empty()};
  // c has one sign: the negative and the positive part of b give one half line each.
  const Interval all = Interval::entire();
  const Interval negative = intersection(b, Interval::from_bounds(all.lo(), 0));
  const Interval positive = intersection(b, Interval::from_bounds(0, all.hi()));
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

namespace {

// |x| lies in `sizes`.
Interval both_signs(const Interval& sizes, const Interval& in) {
  return hull(intersection(sizes, in), intersection(-sizes, in));
}

Interval half_line(double lo) {
  return Interval::from_bits(internal::bits_of(lo), internal::kInfiniteBits);
}

}  // namespace

Interval sqr_rev(const Interval& c, const Interval& in) {
  const ScopedUpward upward;
  return both_signs(sqrt(c), in);
}
Interval abs_rev(const Interval& c, const Interval& in) {
  return both_signs(intersection(c, half_line(0)), in);
}
Interval cosh_rev(const Interval& c, const Interval& in) { return both_signs(acosh(c), in); }

Interval pown_rev(const Interval& c, std::int64_t n, const Interval& in) {
  VT_CHECK(-(std::int64_t{1} << 31) < n && n < std::int64_t{1} << 31, "exponent of pown_rev");
  if (n == 0) return is_member(1, c) ? in : Interval::empty();
  if (n % 2 == 0) return both_signs(rootn(c, n), in);
  return intersection(rootn(c, n), in);
}

}  // namespace veritope
