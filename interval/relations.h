// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/relations.h: order, inclusion and overlap of intervals, intersection and hull. Exact, in
// any floating-point environment. Names and meanings: IEEE 1788.1 [IEEE1788], 4.5 and tables 9.3, 10.6.
#pragma once
#include "interval/interval.h"

namespace veritope {

/// Every x in a is in b. The empty set is a subset of all.
inline bool is_subset(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return a.is_empty();
  return internal::less_equal(b.lo_bits(), a.lo_bits()) &&
         internal::less_equal(a.hi_bits(), b.hi_bits());
}
/// a lies in the topological interior of b: an infinite end of b is not a boundary.
inline bool is_interior(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return a.is_empty();
  return (internal::less(b.lo_bits(), a.lo_bits()) || internal::is_infinite(b.lo_bits())) &&
         (internal::less(a.hi_bits(), b.hi_bits()) || internal::is_infinite(b.hi_bits()));
}
inline bool is_disjoint(const Interval& a, const Interval& b) {
  return a.is_empty() || b.is_empty() || internal::less(a.hi_bits(), b.lo_bits()) ||
         internal::less(b.hi_bits(), a.lo_bits());
}
/// REQUIRES nothing: infinities and NaN are members of no interval.
inline bool is_member(double x, const Interval& a) {
  const internal::Bits v = internal::bits_of(x);
  return !a.is_empty() && !internal::is_nan(v) && !internal::is_infinite(v) &&
         internal::less_equal(a.lo_bits(), v) && internal::less_equal(v, a.hi_bits());
}
/// Nonempty and bounded.
inline bool is_common(const Interval& a) {
  return !a.is_empty() && !internal::is_infinite(a.lo_bits()) &&
         !internal::is_infinite(a.hi_bits());
}
inline bool is_singleton(const Interval& a) {
  return !a.is_empty() && internal::key_of(a.lo_bits()) == internal::key_of(a.hi_bits());
}

/// For each x in a there is a y in b with x <= y, and for each y in b there is an x in a with x <= y.
inline bool is_less(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return a.is_empty() && b.is_empty();
  return internal::less_equal(a.lo_bits(), b.lo_bits()) &&
         internal::less_equal(a.hi_bits(), b.hi_bits());
}
/// Like is_less, but with x < y.
inline bool is_strictly_less(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return a.is_empty() && b.is_empty();
  return (internal::less(a.lo_bits(), b.lo_bits()) ||
          (internal::is_infinite(a.lo_bits()) && internal::is_infinite(b.lo_bits()))) &&
         (internal::less(a.hi_bits(), b.hi_bits()) ||
          (internal::is_infinite(a.hi_bits()) && internal::is_infinite(b.hi_bits())));
}
/// x <= y for all x in a, y in b.
inline bool precedes(const Interval& a, const Interval& b) {
  return a.is_empty() || b.is_empty() || internal::less_equal(a.hi_bits(), b.lo_bits());
}
/// x < y for all x in a, y in b.
inline bool strictly_precedes(const Interval& a, const Interval& b) {
  return a.is_empty() || b.is_empty() || internal::less(a.hi_bits(), b.lo_bits());
}

/// The sign that x - y has for all x in a, y in b; uncertain if it varies or there is no such pair.
inline Sign3 compare(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return Sign3::kUncertain;
  if (internal::less(a.hi_bits(), b.lo_bits())) return Sign3::kNegative;
  if (internal::less(b.hi_bits(), a.lo_bits())) return Sign3::kPositive;
  return is_singleton(a) && a == b ? Sign3::kZero : Sign3::kUncertain;
}

/// How two intervals lie to each other: exactly one of the states holds. Source: [IEEE1788] 10.6.4.
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
  return Interval::from_bits(internal::larger(a.lo_bits(), b.lo_bits()),
                             internal::smaller(a.hi_bits(), b.hi_bits()));
}
/// The least interval around both.
inline Interval hull(const Interval& a, const Interval& b) {
  if (a.is_empty()) return b;
  if (b.is_empty()) return a;
  return Interval::from_bits(internal::smaller(a.lo_bits(), b.lo_bits()),
                             internal::larger(a.hi_bits(), b.hi_bits()));
}

/// { |x| : x in a }, { min(x, y) }, { max(x, y) }: exact.
inline Interval abs(const Interval& a) {
  if (a.is_empty() || internal::key_of(a.lo_bits()) >= 0) return a;
  if (internal::key_of(a.hi_bits()) <= 0) return -a;
  return Interval::from_bits(0, internal::larger(internal::negated(a.lo_bits()), a.hi_bits()));
}
inline Interval min(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return Interval::empty();
  return Interval::from_bits(internal::smaller(a.lo_bits(), b.lo_bits()),
                             internal::smaller(a.hi_bits(), b.hi_bits()));
}
inline Interval max(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return Interval::empty();
  return Interval::from_bits(internal::larger(a.lo_bits(), b.lo_bits()),
                             internal::larger(a.hi_bits(), b.hi_bits()));
}

}  // namespace veritope
