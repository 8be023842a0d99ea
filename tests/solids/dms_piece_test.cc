// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_piece_test.cc: the coefficients that the recurrences over polynomials give are those of the
// polynomial with the map's values at sample points.
#include "solids/dms/dms_piece.h"

#include <gtest/gtest.h>

#include "solids/dms/dms_region.h"
#include "solids/dms/dms_values.h"
#include "tests/support/dms_laws.h"
#include "tests/support/random_dms.h"

namespace veritope {
namespace {

// A tetrahedron of a size of about 2^-20 at a point inside of the domain.
std::array<DmsPoint, 4> small_tetrahedron(Random& random, const DmsModel& model) {
  const DmsKnotTable knots(model);
  const auto corners =
      knots.corners(static_cast<std::uint32_t>(random.below(model.tetrahedra.size())));
  DmsPoint p;
  Rational total;
  for (const DmsPoint& corner : corners) {
    const Rational weight(random.between(1, 40));
    for (std::size_t c = 0; c < 3; ++c) p[c] += weight * corner[c];
    total += weight;
  }
  for (Rational& c : p) c /= total;
  std::array<DmsPoint, 4> out;
  for (std::size_t m = 0; m < 4; ++m)
    for (std::size_t c = 0; c < 3; ++c)
      out[m][c] = p[c] + (corners[m][c] - p[c]) * Rational::power_of_two(-20);
  return out;
}
bool is_cut(const DmsModel& model, const std::array<DmsPoint, 4>& corners) {
  const DmsKnotTable knots(model);
  DmsRegion region(knots, {corners.begin(), corners.end()}, face_planes(corners));
  return region.find_cut(region.supports()).has_value();
}

TEST(DmsPieces, AreThePolynomialsThroughTheMapsValues) {
  std::size_t compared = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const RandomDms drawn = draw_dms(seed, 4, 0);
    const DmsModel model = seed % 4 == 0 ? internal::separated(drawn.model) : drawn.model;
    Random random(seed);
    const auto corners = small_tetrahedron(random, model);
    if (is_cut(model, corners)) continue;
    DmsEvaluator evaluator(model);
    DmsPieces pieces(model, evaluator);
    const SimplexInterpolation interpolation(model.degree, 4);
    const auto values = values_at(evaluator, interpolation.points(corners));
    ASSERT_TRUE(values.has_value()) << drawn.text;
    for (int again = 0; again < 2; ++again) {
      const auto found = pieces.coefficients(corners);
      ASSERT_TRUE(found.has_value()) << drawn.text;
      EXPECT_EQ(*found, interpolation.coefficients(*values)) << drawn.text;
    }
    ++compared;
  }
  EXPECT_GT(compared, 8u);
}

TEST(DmsPieces, HaveNoCoefficientsOutsideOfTheDomain) {
  const DmsModel model = draw_dms(1, 2).model;
  const DmsEvaluator evaluator(model);
  std::array<DmsPoint, 4> far;
  for (std::size_t m = 0; m < 4; ++m) {
    far[m][0] = Rational(100);
    if (m > 0) far[m][m - 1] += Rational(1);
  }
  EXPECT_FALSE(DmsPieces(model, evaluator).coefficients(far).has_value());
}

}  // namespace
}  // namespace veritope
