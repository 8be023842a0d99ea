// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_parts_test.cc: the parts of a tetrahedron fill it, on each of them the map is the polynomial that
// its coefficients there have, and a restriction to another tetrahedron has the same ones, rounded.
#include "solids/dms/dms_parts.h"

#include <gtest/gtest.h>

#include "solids/dms/dms_piece.h"
#include "solids/dms/dms_restriction.h"
#include "solids/dms/dms_values.h"
#include "tests/support/random_dms.h"

namespace veritope {
namespace {

using Corners = std::array<DmsPoint, 4>;

Rational six_volumes(const Corners& c) {
  return dot_product(difference(c[1], c[0]),
                     cross_product(difference(c[2], c[0]), difference(c[3], c[0])));
}
DmsPoint point_in(const Corners& corners, const std::array<int, 4>& weights) {
  const Rational total(weights[0] + weights[1] + weights[2] + weights[3]);
  DmsPoint out;
  for (std::size_t m = 0; m < 4; ++m)
    for (std::size_t c = 0; c < 3; ++c) out[c] += Rational(weights[m]) / total * corners[m][c];
  return out;
}
// The point of Bernstein coefficients, by de Casteljau's algorithm.
DmsPoint bernstein_value(int degree, std::vector<DmsPoint> net, const std::array<int, 4>& weights) {
  const Rational total(weights[0] + weights[1] + weights[2] + weights[3]);
  for (int sum = degree - 1; sum >= 0; --sum) {
    std::vector<DmsPoint> lower;
    for_each_tetrahedral_index(sum, [&](const TetrahedralIndex& index) {
      DmsPoint p;
      for (std::size_t m = 0; m < 4; ++m)
        for (std::size_t c = 0; c < 3; ++c)
          p[c] += Rational(weights[m]) / total * net[tetrahedral_index(raised(index, m))][c];
      lower.push_back(p);
    });
    net = std::move(lower);
  }
  return net[0];
}

TEST(DmsParts, FillTheTetrahedronAndHaveOnePolynomialEach) {
  std::size_t with_many = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const RandomDms drawn = draw_dms(seed, 3, 0);
    const DmsModel& model = drawn.model;
    const DmsKnotTable knots(model);
    DmsEvaluator evaluator(model);
    DmsPieces pieces(model, evaluator);
    Random random(seed);
    const auto t = static_cast<std::uint32_t>(random.below(model.tetrahedra.size()));
    const auto cells = polynomial_parts(knots, t, 100'000);
    ASSERT_TRUE(cells.has_value()) << drawn.text;
    with_many += cells->size() > 1 ? 1 : 0;
    Rational sum;
    for (const DmsCell& cell : *cells) {
      for (const DmsPlane& plane : cell.planes) EXPECT_EQ(side_of_plane(cell.corners, plane), 1);
      for (const Corners& part : cell.tetrahedra) {
        EXPECT_GT(six_volumes(part), Rational()) << drawn.text;
        sum += six_volumes(part);
      }
    }
    EXPECT_EQ(sum, six_volumes(knots.corners(t))) << drawn.text;
    for (int tries = 0; tries < 6; ++tries) {
      const DmsCell& cell = (*cells)[random.below(cells->size())];
      const Corners& part = cell.tetrahedra[random.below(cell.tetrahedra.size())];
      const auto coefficients = pieces.coefficients(part);
      ASSERT_TRUE(coefficients.has_value()) << drawn.text;
      const auto first = pieces.components(cell.tetrahedra[0], 3);
      ASSERT_TRUE(first.has_value()) << drawn.text;
      const auto restricted = DmsRestriction(model.degree, cell.tetrahedra[0], *first).on(part);
      for (std::size_t k = 0; k < coefficients->size(); ++k)
        for (std::size_t c = 0; c < 3; ++c)
          EXPECT_EQ(restricted[c][k], nearest_double((*coefficients)[k][c])) << drawn.text;
      std::array<int, 4> weights{};  // 0 puts the point on a face of the part
      while (weights[0] + weights[1] + weights[2] + weights[3] == 0)
        for (int& w : weights) w = static_cast<int>(random.between(0, 5));
      const auto value = values_at(evaluator, std::vector<DmsPoint>{point_in(part, weights)});
      ASSERT_TRUE(value.has_value()) << drawn.text;
      EXPECT_EQ(bernstein_value(model.degree, *coefficients, weights), (*value)[0])
          << drawn.text << ", tetrahedron " << t;
    }
  }
  EXPECT_GT(with_many, 10u);
}

TEST(DmsParts, AreTheTetrahedronWhereCloudsAreCollapsed) {
  DmsModel model = draw_dms(5, 3, 0).model;
  for (DmsCloud& cloud : model.clouds) cloud.resize(1);
  const DmsKnotTable knots(model);
  const auto parts = polynomial_parts(knots, 0, 1);
  ASSERT_TRUE(parts.has_value());
  ASSERT_EQ(parts->size(), 1u);
  ASSERT_EQ(parts->front().tetrahedra.size(), 1u);
  EXPECT_EQ(six_volumes(parts->front().tetrahedra[0]), six_volumes(knots.corners(0)));
}

TEST(DmsParts, EndAtTheLimitOfCells) {
  std::size_t cut = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const DmsModel model = draw_dms(seed, 3, 0).model;
    const DmsKnotTable knots(model);
    const bool is_whole = polynomial_parts(knots, 0, 1).has_value();
    EXPECT_EQ(is_whole, polynomial_parts(knots, 0, 100'000)->size() == 1) << "seed " << seed;
    cut += is_whole ? 0 : 1;
  }
  EXPECT_GT(cut, 5u);
}

}  // namespace
}  // namespace veritope
