// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/relations.h: order, inclusion and overlap of intervals, intersection and hull. Exact, in
// any floating-point environment. Names and meanings: IEEE 1788.1 [IEEE1788], 4.5 and tables 9.3, 10.6.
#pragma once
#include "interval/interval.h"

namespace veritope {

/// Every x in a is in b. The empty set is a subset of all.
inline bool is_subset(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return a.is_empty();
  return internal::less_equal(b.lo(), a.lo()) && internal::less_equal(a.hi(), b.hi());
}
/// a lies in the topological interior of b: an infinite end of b is no boundary.
inline bool is_interior(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return a.is_empty();
  return (internal::less(b.lo(), a.lo()) || internal::is_infinite(b.lo())) &&
         (internal::less(a.hi(), b.hi()) || internal::is_infinite(b.hi()));
}
inline bool is_disjoint(const Interval& a, const Interval& b) {
  return a.is_empty() || b.is_empty() || internal::less(a.hi(), b.lo()) ||
         internal::less(b.hi(), a.lo());
}
/// REQUIRES nothing: infinities and NaN are members of no interval.
inline bool is_member(double x, const Interval& a) {
  return !a.is_empty() && !internal::is_nan(x) && !internal::is_infinite(x) &&
         internal::less_equal(a.lo(), x) && internal::less_equal(x, a.hi());
}
/// Nonempty and bounded.
inline bool is_common(const Interval& a) {
  return !a.is_empty() && !internal::is_infinite(a.lo()) && !internal::is_infinite(a.hi());
}
inline bool is_singleton(const Interval& a) {
  return !a.is_empty() && internal::order_key(a.lo()) == internal::order_key(a.hi());
}

/// For each x in a some y in b with x <= y, and for each y in b some x in a with x <= y.
inline bool is_less(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return a.is_empty() && b.is_empty();
  return internal::less_equal(a.lo(), b.lo()) && internal::less_equal(a.hi(), b.hi());
}
/// The same with x < y.
inline bool is_strictly_less(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return a.is_empty() && b.is_empty();
  return (internal::less(a.lo(), b.lo()) ||
          (internal::is_infinite(a.lo()) && internal::is_infinite(b.lo()))) &&
         (internal::less(a.hi(), b.hi()) ||
          (internal::is_infinite(a.hi()) && internal::is_infinite(b.hi())));
}
/// x <= y for all x in a, y in b.
inline bool precedes(const Interval& a, const Interval& b) {
  return a.is_empty() || b.is_empty() || internal::less_equal(a.hi(), b.lo());
}
/// x < y for all x in a, y in b.
inline bool strictly_precedes(const Interval& a, const Interval& b) {
  return a.is_empty() || b.is_empty() || internal::less(a.hi(), b.lo());
}

/// The sign that x - y has for all x in a, y in b; uncertain if it varies or there is no such pair.
inline Sign3 compare(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return Sign3::kUncertain;
  if (internal::less(a.hi(), b.lo())) return Sign3::kNegative;
  if (internal::less(b.hi(), a.lo())) return Sign3::kPositive;
  return is_singleton(a) && a == b ? Sign3::kZero : Sign3::kUncertain;
}

/// How two intervals lie: exactly one of the states holds. Source: [IEEE1788] 10.6.4.
enum class Overlap {
  kBothEmpty,
  kFirstEmpty,
  kSecondEmpty,
  kBefore,
  kMeets,
  kOverlaps,
  kStarts,
  kContainedBy,
  kFinishes,
  kEquals,
  kFinishedBy,
  kContains,
  kStartedBy,
  kOverlappedBy,
  kMetBy,
  kAfter,
};
Overlap overlap(const Interval& a, const Interval& b);

inline Interval intersection(const Interval& a, const Interval& b) {
  if (is_disjoint(a, b)) return Interval::empty();
  return Interval::from_bounds(internal::larger(a.lo(), b.lo()), internal::smaller(a.hi(), b.hi()));
}
/// The least interval around both.
inline Interval hull(const Interval& a, const Interval& b) {
  if (a.is_empty()) return b;
  if (b.is_empty()) return a;
  return Interval::from_bounds(internal::smaller(a.lo(), b.lo()), internal::larger(a.hi(), b.hi()));
}

/// { |x| : x in a }, { min(x, y) }, { max(x, y) }: exact.
inline Interval abs(const Interval& a) {
  if (a.is_empty() || internal::order_key(a.lo()) >= 0) return a;
  if (internal::order_key(a.hi()) <= 0) return -a;
  return Interval::from_bounds(0, internal::larger(internal::negated(a.lo()), a.hi()));
}
inline Interval min(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return Interval::empty();
  return Interval::from_bounds(internal::smaller(a.lo(), b.lo()),
                               internal::smaller(a.hi(), b.hi()));
}
inline Interval max(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return Interval::empty();
  return Interval::from_bounds(internal::larger(a.lo(), b.lo()), internal::larger(a.hi(), b.hi()));
}

}  // namespace veritope
