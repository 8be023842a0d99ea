// SPDX-License-Identifier: LGPL-3.0-or-later
// Step functions: their values are exact; what matters is where they jump.
#include <cmath>

#include "interval/evaluate_internal.h"
#include "interval/relations.h"
#include "robust/base/fp_guard.h"

namespace veritope::internal {

namespace {

// f never falls. If it is constant on x, it can jump only at an end of x: jumps_at says whether it does.
template <typename F, typename JumpsAt>
Evaluated step(const Interval& x, F f, JumpsAt jumps_at) {
  if (x.is_empty()) return no_value();
  const ScopedDefaultFp environment;
  const Interval value = Interval::from_bounds(f(x.lo()), f(x.hi()));
  if (!is_singleton(value)) return {value, Decoration::kDef};
  return {value, jumps_at(x.lo()) || jumps_at(x.hi()) ? Decoration::kDac : Decoration::kCom};
}

bool is_integer(double v) { return std::trunc(v) == v; }
bool is_tie(double v) { return std::fabs(v) < 0x1p52 && !is_integer(v) && is_integer(2 * v); }

double to_even(double v) {
  const double down = std::floor(v), above = v - down;  // exact below 2^53
  if (above < 0.5) return down;
  if (above > 0.5) return down + 1;
  return std::floor(down / 2) * 2 == down ? down : down + 1;
}

}  // namespace

Evaluated eval_sign_function(const Interval& x) {
  return step(
      x, [](double v) { return static_cast<double>((v > 0) - (v < 0)); },
      [](double v) { return v == 0; });
}
Evaluated eval_ceil(const Interval& x) {
  return step(
      x, [](double v) { return std::ceil(v); }, is_integer);
}
Evaluated eval_floor(const Interval& x) {
  return step(
      x, [](double v) { return std::floor(v); }, is_integer);
}
Evaluated eval_trunc(const Interval& x) {
  return step(
      x, [](double v) { return std::trunc(v); }, [](double v) { return v != 0 && is_integer(v); });
}
Evaluated eval_round_ties_to_even(const Interval& x) {
  return step(
      x, [](double v) { return std::fabs(v) < 0x1p52 ? to_even(v) : v; }, is_tie);
}
Evaluated eval_round_ties_to_away(const Interval& x) {
  return step(
      x, [](double v) { return std::round(v); }, is_tie);
}

}  // namespace veritope::internal
