// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/lookup_size.h: what a look-up structure takes.
#pragma once
#include <cstdint>

namespace veritope {

struct LookupSize {
  std::uint64_t cells = 0, bytes = 0;
};

}  // namespace veritope
