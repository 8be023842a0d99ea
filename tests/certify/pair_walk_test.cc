// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/pair_walk.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "robust/base/random.h"

namespace veritope {
namespace {

// Some number, which stays with its pair.
std::uint8_t axis_of(std::uint32_t i, std::uint32_t j) {
  return static_cast<std::uint8_t>((7 * i + j) % 50);
}

// The walk of docs/certificates/mesh.md section 5, word for word, if no box and no star vertex ends a call.
struct WholeWalk {
  std::vector<FacetMeeting> pairs;

  void self(std::uint32_t lo, std::uint32_t hi) {
    if (hi - lo == 1) return;
    const std::uint32_t m = lo + (hi - lo) / 2;
    self(lo, m);
    self(m, hi);
    cross(lo, m, m, hi);
  }
  void cross(std::uint32_t a, std::uint32_t a_end, std::uint32_t b, std::uint32_t b_end) {
    if (a_end - a == 1 && b_end - b == 1) return pairs.push_back({a, b, axis_of(a, b)});
    if (a_end - a >= b_end - b) {
      const std::uint32_t m = a + (a_end - a) / 2;
      cross(a, m, b, b_end);
      cross(m, a_end, b, b_end);
    } else {
      const std::uint32_t m = b + (b_end - b) / 2;
      cross(a, a_end, b, m);
      cross(a, a_end, m, b_end);
    }
  }
};

void shuffle(std::vector<FacetMeeting>& pairs, Random& random) {
  for (std::size_t n = pairs.size(); n > 1; --n) std::swap(pairs[n - 1], pairs[random.below(n)]);
}

TEST(PairWalk, SortsAllPairsAsTheWalkMeetsThem) {
  Random random(7);
  for (std::uint32_t leaves = 1; leaves <= 130; ++leaves) {
    WholeWalk walk;
    walk.self(0, leaves);
    ASSERT_EQ(walk.pairs.size(), std::size_t{leaves} * (leaves - 1) / 2);
    std::vector<FacetMeeting> shuffled = walk.pairs;
    shuffle(shuffled, random);
    EXPECT_TRUE(sorted_as_walked(leaves, shuffled) == walk.pairs) << leaves << " leaves";
  }
}

TEST(PairWalk, KeepsTheOrderWhereCallsEndEarly) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    const auto leaves = static_cast<std::uint32_t>(random.between(2, 200));
    const std::uint64_t part = random.between(1, 100);
    WholeWalk walk;
    walk.self(0, leaves);
    std::erase_if(walk.pairs, [&](const FacetMeeting&) { return random.below(100) >= part; });
    std::vector<FacetMeeting> shuffled = walk.pairs;
    shuffle(shuffled, random);
    EXPECT_TRUE(sorted_as_walked(leaves, shuffled) == walk.pairs)
        << "seed " << seed << ", " << leaves << " leaves";
  }
}

TEST(PairWalk, TakesNoPairs) { EXPECT_TRUE(sorted_as_walked(5, {}).empty()); }

}  // namespace
}  // namespace veritope
