// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/predicates/test_scale.h: VT_TEST_SCALE=10 multiplies the loops of the random tests.
#pragma once
#include <cstdlib>

namespace veritope {

inline long scaled(long loops) {
  const char* text = std::getenv("VT_TEST_SCALE");
  const long factor = text == nullptr ? 1 : std::strtol(text, nullptr, 10);
  return loops * (factor > 0 ? factor : 1);
}

}  // namespace veritope
