// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/bound_pair.h"

#include <gtest/gtest.h>

namespace veritope::internal {
namespace {

TEST(BoundPair, ChoosesByTheSignBitOfEachPlace) {
  const Pair plus = make_pair(1, 2), minus = make_pair(3, 4);
  const Bits positive[] = {0, bits_of(1.0), bits_of(0x1p-1074), kInfiniteBits, kEmptyBound};
  for (const Bits a : positive)
    for (const Bits b : positive)
      for (const bool is_minus_a : {false, true})
        for (const bool is_minus_b : {false, true}) {
          const Pair sign = make_pair(is_minus_a ? negated(a) : a, is_minus_b ? negated(b) : b);
          const Pair out = chosen_by_sign(sign, plus, minus);
          EXPECT_EQ(first(out), is_minus_a ? 3u : 1u) << std::hex << a;
          EXPECT_EQ(second(out), is_minus_b ? 4u : 2u) << std::hex << b;
        }
}

}  // namespace
}  // namespace veritope::internal
