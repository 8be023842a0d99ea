// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/implicit_lattice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "robust/base/random.h"
#include "robust/integer.h"
#include "robust/stack_integer.h"
#include "tests/predicates/point_generators.h"

namespace veritope {
namespace {

TEST(ImplicitLattice, IsTheLatticeOfOneLimb) {
  Random random(19);
  int fit = 0;
  for (int kind = 0; kind < generate::kNumKinds; ++kind) {
    for (int i = 0; i < 200; ++i) {
      const generate::Points p = generate::points(static_cast<generate::Kind>(kind), random);
      std::array<double, 15> c;
      for (std::size_t k = 0; k < 15; ++k) c[k] = p[k / 3][static_cast<int>(k % 3)];
      std::uint64_t biased = 0;
      for (const double v : c)
        biased = std::max(biased, std::bit_cast<std::uint64_t>(v) << 1 >> 53);
      EXPECT_EQ(internal::biased_exponent(c), biased);
      std::array<FixedInt<1>, 15> expected;
      std::array<Digits<1>, 15> found;
      const bool fits = internal::to_lattice<1, 15>(c, expected);
      const auto unit = internal::lattice_of(biased, internal::lattice_bits(1));
      EXPECT_EQ(unit.scale * unit.unit, 1);
      EXPECT_EQ(std::ldexp(1.0, unit.exponent), unit.unit);
      ASSERT_EQ(internal::on_lattice(unit, c, found), fits) << generate::text(p);
      if (!fits) continue;
      ++fit;
      for (std::size_t k = 0; k < 15; ++k) EXPECT_EQ(found[k].d[0], expected[k].low());
    }
  }
  EXPECT_GT(fit, 1000);
}

TEST(ToIntegers, AreTheCoordinatesOverTheLargestPowerOfTwoWithWhichTheyAreIntegers) {
  std::array<Integer, 4> big;
  EXPECT_EQ(internal::to_integers(std::array<double, 4>{0.75, -0x1p60, 0, 6}, big), -2);
  EXPECT_EQ(big[0], Integer(3));
  EXPECT_EQ(big[1], -power_of_two(62));
  EXPECT_EQ(big[2], Integer(0));
  EXPECT_EQ(big[3], Integer(24));
  EXPECT_EQ(internal::to_integers(std::array<double, 4>{0x1p1000, 0, -0.0, 0x3p1001}, big), 1000);
  EXPECT_EQ(big[0], Integer(1));
  EXPECT_EQ(big[3], Integer(6));
  std::array<StackInteger<44>, 2> small;
  EXPECT_EQ(internal::to_integers(std::array<double, 2>{0x1p-1074, -1}, small), -1074);
  EXPECT_EQ((small[1] + (StackInteger<44>(1) << 1074)).sign(), Sign3::kZero);
  EXPECT_EQ(internal::to_integers(std::array<double, 2>{0, -0.0}, small), 0);
}

}  // namespace
}  // namespace veritope
