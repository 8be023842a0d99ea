// SPDX-License-Identifier: LGPL-3.0-or-later
// Composition over intervals encloses composition of all maps in them.
#include "splines/composition.h"

#include <gtest/gtest.h>

#include "interval/ring_numbers.h"
#include "interval/upward.h"
#include "tests/splines/composition_draw.h"

namespace veritope {
namespace {

template <std::size_t N>
Bezier<Interval, N> enclosed(const Bezier<Rational, N>& map) {
  std::vector<Interval> c;
  for (const Rational& v : map.coefficients()) c.push_back(enclose(v));
  return Bezier<Interval, N>(map.degrees(), map.num_components(), map.is_rational(), std::move(c));
}

TEST(IntervalComposition, EnclosesTheExactCoefficientsTightly) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto outer = draw_map<3>(random, draw_degrees<3>(random, 2), 2, seed % 2 == 0);
    const auto inner = draw_map<2>(random, draw_degrees<2>(random, 2), 3, seed % 3 == 0);
    const auto exact = compose(outer, inner);
    ASSERT_TRUE(exact);
    const ScopedUpward upward;
    const auto composed = compose(enclosed(outer), enclosed(inner));
    ASSERT_TRUE(composed);
    for (std::size_t i = 0; i < exact->coefficients().size(); ++i) {
      const Interval& box = composed->coefficients()[i];
      const Rational lo = Rational::from_double(box.lo()), hi = Rational::from_double(box.hi());
      ASSERT_TRUE(lo <= exact->coefficients()[i] && exact->coefficients()[i] <= hi)
          << "coefficient " << i << ", outer " << text_of(outer) << ", inner " << text_of(inner);
      EXPECT_TRUE(hi - lo <= Rational::power_of_two(-10)) << (hi - lo).to_string();
    }
  }
}

}  // namespace
}  // namespace veritope
