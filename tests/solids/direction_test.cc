// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/direction.h"

#include <gtest/gtest.h>

#include "robust/base/random.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

constexpr std::uint64_t kSeedOfDirections = 20261131;

using Vector = std::array<Dyadic, 3>;

// Components of very different sizes: zero, small integers, long ones, near multiples of others.
Dyadic random_component(Random& random) {
  switch (random.below(6)) {
    case 0: return {};
    case 1: return Dyadic(static_cast<std::int64_t>(random.below(7)) - 3);
    case 2:
      return Dyadic(static_cast<std::int64_t>(random.next() >> 1) - (std::int64_t{1} << 62),
                    static_cast<std::int64_t>(random.below(200)) - 100);
    case 3: {
      const Integer big = Integer(random.next()) * Integer(random.next()) * Integer(random.next());
      return Dyadic(random.below(2) != 0 ? big : -big,
                    static_cast<std::int64_t>(random.below(300)) - 250);
    }
    case 4: return Dyadic(1, static_cast<std::int64_t>(random.below(90)) - 45);
    default: return Dyadic::from_double(random.unit() - .5);
  }
}
Vector random_vector(Random& random) {
  return {random_component(random), random_component(random), random_component(random)};
}
// One that nearly lies in the plane of a and b.
Vector near_plane(const Vector& a, const Vector& b, Random& random) {
  const Dyadic s(static_cast<std::int64_t>(random.below(5)) - 2),
      t(static_cast<std::int64_t>(random.below(5)) - 2);
  Vector out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = s * a[k] + t * b[k];
  if (random.below(2) != 0)
    out[random.below(3)] +=
        Dyadic(random.below(2) != 0 ? 1 : -1, static_cast<std::int64_t>(random.below(140)) - 120);
  return out;
}

Dyadic product(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector outer(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

TEST(Direction, HasIntegersWithinOneOfItsComponents) {
  Random random(kSeedOfDirections);
  for (int i = 0; i < scaled(5000); ++i) {
    const Vector v = random_vector(random);
    const Direction d(v);
    if (d.is_zero()) continue;
    std::int64_t most = 0;
    for (std::size_t k = 0; k < 3; ++k) most = std::max(most, std::abs(d.approx()[k]));
    ASSERT_LE(most, Direction::kMostApprox);
    ASSERT_GE(most, Direction::kMostApprox / 2);  // so that the filter decides something
    // The scale follows from the largest component.
    std::int64_t top = -100000;
    for (const Dyadic& x : v)
      if (x.sign() != 0)
        top = std::max(top, x.exponent() + static_cast<std::int64_t>(x.mantissa().bit_length()));
    for (std::size_t k = 0; k < 3; ++k) {
      const Dyadic off = v[k] * Dyadic(1, Direction::kApproxBits - top) - Dyadic(d.approx()[k]);
      ASSERT_TRUE(off.sign() >= 0 && off < Dyadic(1))
          << "seed " << kSeedOfDirections << " case " << i;
    }
  }
}

// The bounds are derived in direction.cc; the vectors here nearly cancel, so that each of them is met from both sides.
TEST(Direction, HasExactSigns) {
  Random random(kSeedOfDirections + 1);
  for (int i = 0; i < scaled(20000); ++i) {
    const Vector a = random_vector(random), b = random_vector(random), n = outer(a, b);
    const Vector c = i % 2 == 0 ? random_vector(random) : near_plane(a, b, random);
    const Direction da(a), db(b), dc(c), dn(n);
    SCOPED_TRACE(testing::Message() << "seed " << kSeedOfDirections + 1 << " case " << i);
    ASSERT_EQ(side(da, dc), product(a, c).sign());
    ASSERT_EQ(side(dn, dc), product(n, c).sign());
    ASSERT_EQ(turn(dc, da, db), product(c, n).sign());
    ASSERT_EQ(turn(da, db, dc), product(c, n).sign());
    const Vector ac = outer(a, c);
    ASSERT_EQ(is_parallel(da, dc), ac[0].sign() == 0 && ac[1].sign() == 0 && ac[2].sign() == 0);
    const Vector multiple = {Dyadic(-3) * a[0], Dyadic(-3) * a[1], Dyadic(-3) * a[2]};
    ASSERT_TRUE(is_parallel(da, Direction(multiple)));
  }
}

}  // namespace
}  // namespace veritope
