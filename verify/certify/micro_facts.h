// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/micro_facts.h: what certify says of a microstructure beside its verdict.
#pragma once
#include "solids/micro/micro_topology.h"

namespace veritope {

struct MicroFacts {
  std::uint64_t volumes = 0;  ///< of the cage
  std::uint64_t kinds = 0;    ///< different tiles
  MicroCounts counts;         ///< of a valid microstructure; of others cells and tiles alone
};

}  // namespace veritope
