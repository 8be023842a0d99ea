// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/vmodel/v_border_defects.h"

#include <gtest/gtest.h>

#include "tests/support/v_cells.h"

namespace veritope {
namespace {

using v_cells::box;
using v_cells::cube;
using v_cells::Point;

VModel bordered(std::vector<VVolume> cells) {
  return make_v_model(std::move(cells), VOrientation::kAuto).value();
}
std::optional<VCrowdedCurve> curve_in(const VModel& model) {
  const VBorder border = make_border(model).value();
  return find_crowded_curve(model, border.faces, border.complex);
}
std::optional<VPinchedPoint> point_in(const VModel& model) {
  const VBorder border = make_border(model).value();
  return find_pinched_point(model, border.faces, border.complex);
}

TEST(VBorder, CubesThatShareAnEdgeHaveACrowdedCurve) {
  const VModel model = bordered({cube(0, 0, 0), cube(1, 1, 0)});
  const auto curve = curve_in(model);
  ASSERT_TRUE(curve);
  EXPECT_EQ(curve->middle, (Point{Rational(1), Rational(1), Rational(1) / Rational(2)}));
  for (const VArc& arc : curve->arcs) {
    EXPECT_EQ(arc.at[0], Rational(0));
    EXPECT_EQ(arc.at[1], Rational(1));
  }
  EXPECT_FALSE(point_in(model));  // the border is no surface
}

TEST(VBorder, CubesThatShareACornerHaveAPinchedPoint) {
  const VModel model = bordered({cube(0, 0, 0), cube(1, 1, 1)});
  EXPECT_FALSE(curve_in(model));
  const auto point = point_in(model);
  ASSERT_TRUE(point);
  EXPECT_EQ(point->at, (Point{Rational(1), Rational(1), Rational(1)}));
  EXPECT_NE(point->corners[0].cell, point->corners[1].cell);
}

// The cells around the point are connected through faces, but the border has two vertices there.
TEST(VBorder, TwoOppositeGapsPinchTheBorder) {
  std::vector<VVolume> cells;
  for (int i = 1; i < 7; ++i) cells.push_back(cube(i & 1, i >> 1 & 1, i >> 2));
  const VModel model = bordered(cells);
  EXPECT_FALSE(curve_in(model));
  const auto point = point_in(model);
  ASSERT_TRUE(point);
  EXPECT_EQ(point->at, (Point{Rational(1), Rational(1), Rational(1)}));
}

TEST(VBorder, SoundModelsHaveNeither) {
  const std::vector<VModel> models = [] {
    std::vector<VModel> out;
    out.push_back(bordered({cube(0, 0, 0)}));
    out.push_back(bordered(v_cells::grid(2, {1, 2, 1}, [](const Point& p) { return p; })));
    // A saddle: three cubes around a vertex.
    out.push_back(bordered({cube(0, 0, 0), cube(1, 0, 0), cube(0, 1, 1), cube(0, 0, 1)}));
    // A wedge, whose face u = 0 is an edge, on another.
    const auto wedge = [](int z) {
      return v_cells::polynomial({1, 1, 1}, [z](std::size_t i, std::size_t j, std::size_t k) {
        const Rational x(i == 1 && j == 0 ? 1 : 0), y(i == 1 && j == 1 ? 1 : 0);
        return Point{x, y, Rational(z + static_cast<int>(k))};
      });
    };
    out.push_back(bordered({wedge(0), wedge(1)}));
    return out;
  }();
  for (const VModel& model : models) {
    EXPECT_FALSE(curve_in(model));
    EXPECT_FALSE(point_in(model));
  }
}

// Parts of edges that are the same: ends at thirds have no dyadic parameters, but parts of them do.
TEST(VBorder, PartsOfEdgesAreFound) {
  const auto third = Rational(1) / Rational(3);
  const VModel model = bordered({cube(0, 0, 0), box({Rational(1), Rational(1), third},
                                                    {Rational(2), Rational(2), Rational(5)})});
  const auto curve = curve_in(model);
  ASSERT_TRUE(curve);
  EXPECT_TRUE(third < curve->middle[2] && curve->middle[2] < Rational(1));
  const VModel inside = bordered({cube(0, 0, 0), box({Rational(1), Rational(1), third},
                                                     {Rational(2), Rational(2), third + third})});
  ASSERT_TRUE(curve_in(inside));
}

TEST(VBorder, FacesThatEqualOthersAndAreNotGluedAreNotUsed) {
  EXPECT_FALSE(curve_in(bordered({cube(0, 0, 0), cube(0, 0, 0)})));
}

// Shared edges and corners are found however the cells are described.
TEST(VBorder, DescriptionsOfTheCellsDoNotMatter) {
  const std::uint64_t seed = 271;
  Random random(seed);
  for (int round = 0; round < 60; ++round) {
    const bool is_edge = round % 2 == 0;
    std::vector<VVolume> cells = {cube(0, 0, 0), is_edge ? cube(1, 1, 0) : cube(1, 1, 1)};
    for (VVolume& cell : cells)
      cell = v_cells::redescribed(v_cells::turned(cell, static_cast<unsigned>(random.below(48))),
                                  random);
    const std::string what = "seed " + std::to_string(seed) + ", round " + std::to_string(round) +
                             "\n" + v_cells::text_of(cells[0]) + v_cells::text_of(cells[1]);
    const VModel model = bordered(cells);
    // With other knots the sides differ, and the border has two vertices at both ends of the edge.
    EXPECT_TRUE(is_edge || point_in(model)) << what;
    const auto curve = curve_in(model);
    EXPECT_EQ(curve.has_value(), is_edge) << what;
    if (curve) {
      EXPECT_EQ(curve->middle[0], Rational(1)) << what;
    }
  }
}

}  // namespace
}  // namespace veritope
