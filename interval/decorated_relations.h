// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/decorated_relations.h: the functions of relations.h and numeric.h for decorated intervals. They apply to
// the interval parts; with NaI they return false or NaN. Source: [IEEE1788] 12.12.
#pragma once
#include <limits>

#include "interval/decorated.h"
#include "robust/base/check.h"

namespace veritope {

namespace internal {
template <typename Relation>
bool related(Relation relation, const DecoratedInterval& a, const DecoratedInterval& b) {
  return !a.is_nai() && !b.is_nai() && relation(a.interval(), b.interval());
}
template <typename Number>
double number_of(Number number, const DecoratedInterval& a) {
  return a.is_nai() ? std::numeric_limits<double>::quiet_NaN() : number(a.interval());
}
}  // namespace internal

/// Equal as sets; decorations do not count; NaI equals nothing.
inline bool operator==(const DecoratedInterval& a, const DecoratedInterval& b) {
  return !a.is_nai() && !b.is_nai() && a.interval() == b.interval();
}
inline bool is_subset(const DecoratedInterval& a, const DecoratedInterval& b) {
  return internal::related([](auto& x, auto& y) { return is_subset(x, y); }, a, b);
}
inline bool is_interior(const DecoratedInterval& a, const DecoratedInterval& b) {
  return internal::related([](auto& x, auto& y) { return is_interior(x, y); }, a, b);
}
inline bool is_disjoint(const DecoratedInterval& a, const DecoratedInterval& b) {
  return internal::related([](auto& x, auto& y) { return is_disjoint(x, y); }, a, b);
}
inline bool is_less(const DecoratedInterval& a, const DecoratedInterval& b) {
  return internal::related([](auto& x, auto& y) { return is_less(x, y); }, a, b);
}
inline bool is_strictly_less(const DecoratedInterval& a, const DecoratedInterval& b) {
  return internal::related([](auto& x, auto& y) { return is_strictly_less(x, y); }, a, b);
}
inline bool precedes(const DecoratedInterval& a, const DecoratedInterval& b) {
  return internal::related([](auto& x, auto& y) { return precedes(x, y); }, a, b);
}
inline bool strictly_precedes(const DecoratedInterval& a, const DecoratedInterval& b) {
  return internal::related([](auto& x, auto& y) { return strictly_precedes(x, y); }, a, b);
}
inline bool is_empty(const DecoratedInterval& a) { return !a.is_nai() && a.interval().is_empty(); }
inline bool is_entire(const DecoratedInterval& a) {
  return !a.is_nai() && a.interval().is_entire();
}
inline bool is_common(const DecoratedInterval& a) { return !a.is_nai() && is_common(a.interval()); }
inline bool is_singleton(const DecoratedInterval& a) {
  return !a.is_nai() && is_singleton(a.interval());
}
inline bool is_member(double x, const DecoratedInterval& a) {
  return !a.is_nai() && is_member(x, a.interval());
}

inline double inf(const DecoratedInterval& a) {
  return internal::number_of([](auto& x) { return inf(x); }, a);
}
inline double sup(const DecoratedInterval& a) {
  return internal::number_of([](auto& x) { return sup(x); }, a);
}
inline double mid(const DecoratedInterval& a) {
  return internal::number_of([](auto& x) { return mid(x); }, a);
}
inline double rad(const DecoratedInterval& a) {
  return internal::number_of([](auto& x) { return rad(x); }, a);
}
inline double wid(const DecoratedInterval& a) {
  return internal::number_of([](auto& x) { return wid(x); }, a);
}
inline double mag(const DecoratedInterval& a) {
  return internal::number_of([](auto& x) { return mag(x); }, a);
}
inline double mig(const DecoratedInterval& a) {
  return internal::number_of([](auto& x) { return mig(x); }, a);
}
inline MidRad mid_rad(const DecoratedInterval& a) { return {mid(a), rad(a)}; }

/// REQUIRES no NaI.
inline Overlap overlap(const DecoratedInterval& a, const DecoratedInterval& b) {
  VT_CHECK(!a.is_nai() && !b.is_nai(), "overlap of NaI");
  return overlap(a.interval(), b.interval());
}

}  // namespace veritope
