// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/base/memory_budget.h"

#include <unistd.h>

#include <string>

namespace veritope {

Error memory_error(const MemoryBudget& budget) {
  constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;
  const std::uint64_t limit = budget.limit();
  const std::string text = limit % kMiB == 0 ? std::to_string(limit / kMiB) + " MiB"
                                             : std::to_string(limit) + " bytes";
  return {Code::kOverLimit, {}, "the memory allowed, " + text + ", does not suffice"};
}

std::uint64_t memory_allowed(std::optional<std::uint64_t> asked) {
  if (asked) return *asked;
  constexpr std::uint64_t kUnknown = std::uint64_t{1} << 31;  // half of what the least machines have
  const long pages = ::sysconf(_SC_PHYS_PAGES), bytes = ::sysconf(_SC_PAGESIZE);
  if (pages <= 0 || bytes <= 0) return kUnknown;
  return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(bytes) / 2;
}

}  // namespace veritope
