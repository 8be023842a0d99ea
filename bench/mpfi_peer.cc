// SPDX-License-Identifier: LGPL-3.0-or-later
#include "bench/interval_c_loops.h"
#include "bench/mpfi_variable.h"

namespace veritope::bench {

void add_mpfi_peer(const IntervalData& data, IntervalPeers& out) {
  out.push_back(std::make_unique<FunctionPeer<Mpfi>>("mpfi", data));
}

}  // namespace veritope::bench
