// SPDX-License-Identifier: LGPL-3.0-or-later
// Boost.Interval as a filter; the mode is set once a call. Compiled with -frounding-math.
#include <boost/numeric/interval.hpp>

#include "bench/interval_predicates.h"

namespace veritope::bench {
namespace {

struct BoostTraits {
  using Default = boost::numeric::interval<double>;
  using Type = boost::numeric::interval_lib::unprotect<Default>::type;
  using Scope = Default::traits_type::rounding;
  static Type point(double x) { return Type(x); }
  static signed char sign(const Type& x) {
    if (x.lower() > 0) return 1;
    if (x.upper() < 0) return -1;
    return x.lower() == 0 && x.upper() == 0 ? 0 : 2;
  }
};

}  // namespace

void add_boost_predicates(PredicatePeers& out) {
  out.push_back(std::make_unique<IntervalFilter<BoostTraits>>("boost_filter", 8192));
}

}  // namespace veritope::bench
