// SPDX-License-Identifier: LGPL-3.0-or-later
#include "bench/arb_variable.h"
#include "bench/interval_c_loops.h"

namespace veritope::bench {

void add_arb_peer(const IntervalData& data, IntervalPeers& out) {
  out.push_back(std::make_unique<FunctionPeer<Arb>>("arb", data));
}

}  // namespace veritope::bench
