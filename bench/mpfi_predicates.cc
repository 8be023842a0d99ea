// SPDX-License-Identifier: LGPL-3.0-or-later
#include "bench/interval_predicates.h"
#include "bench/mpfi_variable.h"

namespace veritope::bench {

void add_mpfi_predicates(PredicatePeers& out) {
  out.push_back(std::make_unique<IntervalFilter<PooledTraits<Mpfi>>>("mpfi_filter", 2048));
}

}  // namespace veritope::bench
