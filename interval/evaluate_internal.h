// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/evaluate_internal.h: evaluates each function once, with its range and the decoration that its argument
// earns; functions.cc takes the range, decorated.cc both.
#pragma once
#include <cstdint>

#include "interval/decoration.h"
#include "interval/interval.h"

// The functions of one and of two intervals, as functions.cc and decorated.cc list them.
// clang-format off
#define VT_INTERVAL_UNARY(F) \
  F(exp) F(exp2) F(exp10) F(expm1) F(log) F(log2) F(log10) F(logp1) F(cbrt) \
  F(sin) F(cos) F(tan) F(cot) F(sec) F(csc) F(asin) F(acos) F(atan) F(acot) \
  F(sinh) F(cosh) F(tanh) F(coth) F(sech) F(csch) F(asinh) F(acosh) F(atanh) F(acoth) \
  F(sign_function) F(ceil) F(floor) F(trunc) F(round_ties_to_even) F(round_ties_to_away)
#define VT_INTERVAL_BINARY(F) F(atan2) F(pow) F(hypot)
// clang-format on

namespace veritope::internal {

/// An enclosure of f(x), and the strongest decoration that the result may have if x itself has kCom. Where the range
/// is unbounded, kCom stands for kDac (see DecoratedInterval).
struct Evaluated {
  Interval value;
  Decoration local;
};
inline Evaluated no_value() { return {Interval::empty(), Decoration::kTrv}; }

#define VT_DECLARE(name) Evaluated eval_##name(const Interval& x);
VT_INTERVAL_UNARY(VT_DECLARE)
#undef VT_DECLARE
#define VT_DECLARE(name) Evaluated eval_##name(const Interval& a, const Interval& b);
VT_INTERVAL_BINARY(VT_DECLARE)
#undef VT_DECLARE
Evaluated eval_pown(const Interval& x, std::int64_t n);
Evaluated eval_rootn(const Interval& x, std::int64_t n);

}  // namespace veritope::internal
