// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/reverse.h: reverse operations: which x of a given set can f have mapped into c? Source:
// [IEEE1788] 10.5.4 and table 10.1. Results enclose all such x; tightest unless said otherwise.
#pragma once
#include <utility>

#include "interval/decorated.h"
#include "interval/interval.h"

namespace veritope {

/// { x : b x in c for some b }, as at most two intervals in increasing order; what is not needed is
/// empty. Interval Newton divides by derivatives that contain 0 with it.
std::pair<Interval, Interval> mul_rev_to_pair(const Interval& b, const Interval& c);
/// Decoration of c / b on both if 0 is not in b, else kTrv.
std::pair<DecoratedInterval, DecoratedInterval> mul_rev_to_pair(const DecoratedInterval& b,
                                                                const DecoratedInterval& c);
/// The hull of { x in in : b x in c for some b }.
Interval mul_rev(const Interval& b, const Interval& c, const Interval& in = Interval::entire());

}  // namespace veritope
