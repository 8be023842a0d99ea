// SPDX-License-Identifier: LGPL-3.0-or-later
// Boost.Interval and CGAL's Interval_nt [CGAL55], compiled with -frounding-math.
#include <CGAL/Interval_nt.h>

#include <boost/numeric/interval.hpp>

#include "bench/interval_loops.h"
#include "bench/interval_peers.h"

namespace veritope::bench {
namespace {

namespace lib = boost::numeric::interval_lib;

template <typename T, typename ScopeType>
struct BoostTraits {
  using Type = T;
  using Scope = ScopeType;
  static T make(double lo, double hi) { return T(lo, hi); }
  static double lower(const T& x) { return x.lower(); }
  static double upper(const T& x) { return x.upper(); }
};
struct NoScope {
  NoScope() {}
};

using Default = boost::numeric::interval<double>;
// The scope sets the mode once, which the library's documents recommend for speed: first with its default arithmetic,
// then with its fastest (no checking).
using Unprotected = lib::unprotect<Default>::type;
using Fast =
    boost::numeric::interval<double, lib::policies<lib::save_state<lib::rounded_arith_opp<double>>,
                                                   lib::checking_base<double>>>;
using UnprotectedFast = lib::unprotect<Fast>::type;

struct CgalTraits {
  using Type = CGAL::Interval_nt<false>;
  using Scope = CGAL::Interval_nt<false>::Protector;
  static Type make(double lo, double hi) { return {lo, hi}; }
  static double lower(const Type& x) { return x.inf(); }
  static double upper(const Type& x) { return x.sup(); }
};

}  // namespace

void add_boost_peers(const IntervalData& data, IntervalPeers& out) {
  out.push_back(std::make_unique<OperatorPeer<BoostTraits<Default, NoScope>>>("boost", data));
  out.push_back(
      std::make_unique<OperatorPeer<BoostTraits<Unprotected, Default::traits_type::rounding>>>(
          "boost_unprotected", data));
  out.push_back(
      std::make_unique<OperatorPeer<BoostTraits<UnprotectedFast, Fast::traits_type::rounding>>>(
          "boost_unprotected_unchecked", data));
}
void add_cgal_peer(const IntervalData& data, IntervalPeers& out) {
  out.push_back(std::make_unique<OperatorPeer<CgalTraits>>("cgal", data));
}

}  // namespace veritope::bench
