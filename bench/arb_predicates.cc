// SPDX-License-Identifier: LGPL-3.0-or-later
#include "bench/arb_variable.h"
#include "bench/interval_predicates.h"

namespace veritope::bench {

void add_arb_predicates(PredicatePeers& out) {
  out.push_back(std::make_unique<IntervalFilter<PooledTraits<Arb>>>("arb_filter", 2048));
}

}  // namespace veritope::bench
