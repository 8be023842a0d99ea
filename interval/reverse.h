// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/reverse.h: reverse operations: which x of a given set can f have mapped into c? Source:
// [IEEE1788] 10.5.4 and table 10.1. Laws, for every f_rev(c, in) here:
//   (1) x in `in` with f(x) in c is in the result; (2) the result is a subset of `in`;
//   (3) its bounds are the nearest binary64 numbers outside of the hull of those x.
// They work in any floating-point environment. The best decoration that they could give is kTrv; so, except for
// mul_rev_to_pair, they exist for bare intervals only.
#pragma once
#include <cstdint>
#include <utility>

#include "interval/decorated.h"
#include "interval/interval.h"

namespace veritope {

/// { x : b x in c for some b }, as at most two intervals in increasing order; an interval that is not needed is
/// empty. Interval Newton uses it to divide by derivatives that contain 0.
std::pair<Interval, Interval> mul_rev_to_pair(const Interval& b, const Interval& c);
/// The first has the decoration of c / b if 0 is not in b; otherwise both have kTrv.
std::pair<DecoratedInterval, DecoratedInterval> mul_rev_to_pair(const DecoratedInterval& b,
                                                                const DecoratedInterval& c);
/// The hull of { x in in : b x in c for some b }.
Interval mul_rev(const Interval& b, const Interval& c, const Interval& in = Interval::entire());

Interval sqr_rev(const Interval& c, const Interval& in = Interval::entire());
Interval abs_rev(const Interval& c, const Interval& in = Interval::entire());
Interval cosh_rev(const Interval& c, const Interval& in = Interval::entire());
/// REQUIRES |n| < 2^31.
Interval pown_rev(const Interval& c, std::int64_t n, const Interval& in = Interval::entire());

Interval sin_rev(const Interval& c, const Interval& in = Interval::entire());
Interval cos_rev(const Interval& c, const Interval& in = Interval::entire());
Interval tan_rev(const Interval& c, const Interval& in = Interval::entire());

/// The x in `in` with x^y in c for some y in b.
Interval pow_rev1(const Interval& b, const Interval& c, const Interval& in = Interval::entire());
/// The y in `in` with x^y in c for some x in b.
Interval pow_rev2(const Interval& b, const Interval& c, const Interval& in = Interval::entire());

}  // namespace veritope
