// SPDX-License-Identifier: LGPL-3.0-or-later
// The constant of verify/certify/walk_bounds_internal.h: its derivation rerun, and inputs that come near it.
#include "verify/certify/walk_bounds_internal.h"

#include "tests/support/directed_bounds.h"
#include "tests/support/piece_bound_search.h"

namespace veritope {
namespace {

using bounds::RoundingCount;

TEST(WalkBound, ParameterConstantFollowsFromTheRoundings) {
  constexpr RoundingCount x;
  const RoundingCount t = internal::segment_parameter(x, x, x);
  EXPECT_EQ(t.roundings, 3);
  const int all = ((t - x) - x).roundings;  // as parameter_below does
  const Rational c = Rational::from_double(internal::kParameterRel);
  // |t| is a computed number, the product with the constant rounds.
  const int of_bound = t.roundings + 1;
  bounds::expect_tight_directed(c, all, of_bound);
  EXPECT_LE(Rational(4) * bounds::flush_unit(), Rational::from_double(internal::kParameterTiny));
}

TEST(WalkBound, FoundSegmentsUseMoreThanHalfOfTheBoundAndNoneBreaksIt) {
  using namespace piece_bounds;
  // What the lower end had to pay for, of what it takes away.
  const auto share = [](Rounding mode) {
    return [mode](const Numbers& in) {
      if (in[1] == in[2]) return 0.0;
      const Numbers found = computed(mode, in, [](const Numbers& v) {
        const double t = internal::segment_parameter(v[0], v[1], v[2]);
        return Numbers{internal::parameter_below(t), internal::parameter_above(t),
                       internal::kParameterRel * std::abs(t) + internal::kParameterTiny};
      });
      const auto v = exactly(in);
      const Rational exact = internal::segment_parameter(v[0], v[1], v[2]);
      const Rational taken = Rational::from_double(found[2]);
      const Rational below = Rational::from_double(found[0]) + taken - exact;
      const Rational above = exact - (Rational::from_double(found[1]) - taken);
      return nearest_double(std::max(below, above) / taken);
    };
  };
  double most = 0;
  for (const Rounding mode : {Rounding::kNearest, Rounding::kUpward}) {
    const Found found = climb(
        {share(mode), [](Random& r) { return draw_numbers(r, 3); }, change_numbers}, 8, 1000, 1);
    EXPECT_LE(found.share, 1) << found.in[0] << ' ' << found.in[1] << ' ' << found.in[2];
    most = std::max(most, found.share);
  }
  EXPECT_GT(most, 0.5);
}

}  // namespace
}  // namespace veritope
