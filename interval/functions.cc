// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/functions.h"

#include "interval/evaluate_internal.h"

namespace veritope {

#define VT_DEFINE(name) \
  Interval name(const Interval& x) { return internal::eval_##name(x).value; }
VT_INTERVAL_UNARY(VT_DEFINE)
#undef VT_DEFINE
#define VT_DEFINE(name) \
  Interval name(const Interval& a, const Interval& b) { return internal::eval_##name(a, b).value; }
VT_INTERVAL_BINARY(VT_DEFINE)
#undef VT_DEFINE

Interval pown(const Interval& x, std::int64_t n) { return internal::eval_pown(x, n).value; }
Interval rootn(const Interval& x, std::int64_t n) { return internal::eval_rootn(x, n).value; }

}  // namespace veritope
