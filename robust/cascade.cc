// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/cascade.h"

#include <cstdio>
#include <string>

#include "robust/base/check.h"

namespace veritope::internal {
namespace {

constexpr std::array<const char*, kNumTiers> kTierNames{"filter", "lattice", "interval", "exact"};

std::string said(const char* tier, Sign sign) {
  return std::string(tier) + " says " + std::to_string(to_int(sign));
}

}  // namespace

void audit_failed(Tier tier, Sign says, const TierCounts& other, Sign contradicts) {
  // A predicate made of several cascades counts each of them: all tiers that answered are named.
  std::string others;
  for (std::size_t i = 0; i < kNumTiers; ++i) {
    if (other.decided[i] != 0) others += (others.empty() ? "" : ", ") + std::string(kTierNames[i]);
  }
  const std::string text = "audit: two tiers of a cascade contradict each other, please report: " +
                           said(kTierNames[static_cast<std::size_t>(tier)], says) + ", " +
                           said(others.c_str(), contradicts);
  std::fprintf(stderr, "%s\n", text.c_str());
  throw InternalError(text);
}

}  // namespace veritope::internal
