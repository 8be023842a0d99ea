// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/micro_facts.h: what certify says of a microstructure beside its verdict.
#pragma once
#include <optional>

#include "solids/micro/micro_topology.h"

namespace veritope {

/// What is proved of a microstructure in the interior of a solid.
struct InsideFacts {
  std::uint64_t voids = 0;       ///< of the solid
  std::optional<Rational> skin;  ///< no end of a bridge is farther from its surface
};

struct MicroFacts {
  std::uint64_t volumes = 0;  ///< of the cage
  std::uint64_t kinds = 0;    ///< different tiles
  MicroCounts counts;         ///< of a valid microstructure; of others cells and tiles alone
  std::optional<InsideFacts> inside;  ///< if CertifyOptions::inside was given, and it lies in it
};

}  // namespace veritope
