// SPDX-License-Identifier: LGPL-3.0-or-later
// The constant of verify/certify/walk_bounds_internal.h: its derivation rerun, and inputs that come near it.
#include "verify/certify/walk_bounds_internal.h"

#include "models/patch_shapes.h"
#include "tests/support/directed_bounds.h"
#include "tests/support/piece_bound_search.h"
#include "verify/certify/star_walks.h"

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

// Segments through an edge of a cube: they pass the planes of two faces at one parameter, which doubles may round to
// two.
TEST(WalkBound, SegmentsThatTouchAnEdgeAreNotFree) {
  const PatchComplex complex = make_patch_complex(patch_shapes::box({0, 0, 0}, {1, 1, 1})).value();
  PieceForest forest = PieceForest::make(complex, PieceForest::FrameChoice::kPlain).value();
  const double one = std::ldexp(1.0, forest.scale());
  int different = 0;
  for (int i = 1; i <= 32; ++i) {
    const double from = (0x1p+50 + 2 * i + 1) * 0x1p-44, to = (0x1p+50 + 6 * i + 5) * 0x1p-45;
    const Point3d a{-from * one, 3 * from * one, 0.5 * one}, b{to * one, -3 * to * one, 0.5 * one};
    const double in = internal::segment_parameter(0.0, a[0], b[0]);
    const double out = internal::segment_parameter(0.0, a[1], b[1]);
    different += in > out;
    EXPECT_FALSE(is_free_segment(forest, a, b)) << i;
    EXPECT_TRUE(is_free_segment(forest, {a[0], a[1] - one, a[2]}, {b[0], b[1] - one, b[2]})) << i;
  }
  EXPECT_GT(different, 4);  // else the cases are too easy
}

}  // namespace
}  // namespace veritope
