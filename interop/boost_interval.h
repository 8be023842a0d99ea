// SPDX-License-Identifier: LGPL-3.0-or-later
// interop/boost_interval.h: converts our intervals to Boost.Interval and back. Opt-in: nothing of ours includes it.
// Use: docs/how-to/use-with-cgal-boost-eigen.md.
#pragma once
#include <boost/numeric/interval.hpp>

#include "interval/interval.h"

namespace veritope {

/// Boost's interval with policies under which its + - * / need only a live ScopedUpward: they use the mode as it is,
/// upward, and round downward by negation. Nothing is checked, as in our intervals. Compile with -frounding-math:
/// Boost's operations have no fences of their own.
using UpwardBoostInterval =
    boost::numeric::interval<double,
                             boost::numeric::interval_lib::policies<
                                 boost::numeric::interval_lib::save_state_nothing<
                                     boost::numeric::interval_lib::rounded_arith_opp<double>>,
                                 boost::numeric::interval_lib::checking_base<double>>>;

/// Our interval with the same members; Boost's empty interval, if its policies have one, becomes
/// ours.
template <typename Policies>
Interval from_boost(const boost::numeric::interval<double, Policies>& x) {
  return Interval::from_bounds(x.lower(), x.upper());
}

/// Boost's interval with the same members. REQUIRES that the policies allow it: the default ones throw for the empty
/// interval.
template <typename Boost = boost::numeric::interval<double>>
Boost to_boost(const Interval& a) {
  return Boost(a.lo(), a.hi());
}

}  // namespace veritope
