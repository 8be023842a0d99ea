// SPDX-License-Identifier: LGPL-3.0-or-later
// Cells of V-models for viewers. What the files hold is tested by tests/cli/render_cells_test.py, with parsers of its
// own.
#include "render/volume_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace veritope {
namespace {

// A trilinear cell between two corners; the degree along u may be raised by bending it.
ExactVolume box_cell(const std::array<int, 3>& lo, const std::array<int, 3>& hi, int bend = 0) {
  const int degree = bend == 0 ? 1 : 2;
  std::array<ExactVolume::Axis, 3> axes;
  for (std::size_t a = 0; a < 3; ++a) {
    axes[a].degree = a == 0 ? degree : 1;
    for (int end = 0; end < 2; ++end)
      axes[a].knots.insert(axes[a].knots.end(), static_cast<std::size_t>(axes[a].degree) + 1,
                           Rational(end));
  }
  std::vector<Rational> coefficients;
  for (std::size_t c = 0; c < 3; ++c)
    for (int i = 0; i <= degree; ++i)
      for (int j = 0; j < 2; ++j)
        for (int k = 0; k < 2; ++k) {
          const std::array<Rational, 3> share = {Rational(i) / Rational(degree), Rational(j),
                                                 Rational(k)};
          Rational x = Rational(lo[c]) + share[c] * Rational(hi[c] - lo[c]);
          if (c == 2 && i == 1 && degree == 2) x += Rational(bend);
          coefficients.push_back(x);
        }
  return {axes, 3, false, std::move(coefficients)};
}

SplineModel model_of_cells(const std::vector<ExactVolume>& cells) {
  SplineModel out;
  for (const ExactVolume& cell : cells) out.entities.push_back({cell, {}, {}, {}});
  return out;
}

TEST(VolumeLayout, MovesEachCellByTheFactorTimesItsWayFromTheMeanOfTheCentres) {
  // Centres (1, 1, 1), (4, 1, 1) and (1, 4, 1): their mean is (2, 2, 1).
  const SplineModel model =
      model_of_cells({box_cell({0, 0, 0}, {2, 2, 2}), box_cell({2, 0, 0}, {6, 2, 2}),
                      box_cell({0, 2, 0}, {2, 6, 2})});
  const VolumeLayout still = volume_layout(model, 0).value();
  for (const Point3d& offset : still.offsets) EXPECT_EQ(offset, (Point3d{0, 0, 0}));
  EXPECT_EQ(still.box, (Box3d{{0, 0, 0}, {6, 6, 2}}));
  EXPECT_DOUBLE_EQ(still.diagonal, std::sqrt(36.0 + 36 + 4));
  const VolumeLayout apart = volume_layout(model, 0.5).value();
  const std::vector<Point3d> expected = {{-0.5, -0.5, 0}, {1, -0.5, 0}, {-0.5, 1, 0}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(apart.offsets[i][k], expected[i][k], 1e-15);
  EXPECT_NEAR(apart.box.lo[0], -0.5, 1e-15);
  EXPECT_NEAR(apart.box.hi[1], 7, 1e-15);
  EXPECT_EQ(apart.diagonal, still.diagonal);
}

TEST(VolumeLayout, RefusesWhatBinary64CannotHold) {
  ExactVolume far = box_cell({0, 0, 0}, {1, 1, 1});
  for (Rational& x : far.component(0)) x *= Rational::power_of_two(2000);
  const auto refused = volume_layout(model_of_cells({box_cell({0, 0, 0}, {1, 1, 1}), far}), 0);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Code::kNotFinite);
  EXPECT_EQ(refused.error().place.entity, 1u);
}

TEST(VolumeParts, TooManyPointsAreRefusedWithTheCell) {
  const SplineModel model =
      model_of_cells({box_cell({0, 0, 0}, {1, 1, 1}), box_cell({1, 0, 0}, {2, 1, 1}),
                      box_cell({2, 0, 0}, {3, 1, 1})});
  const VolumeLayout layout = volume_layout(model, 0).value();
  VolumeViewOptions options;
  options.max_points = 3 * 24;
  EXPECT_EQ(volume_parts(model, layout, options).value().size(), 3u);
  options.has_nets = true;  // 8 points more for each cell
  const auto refused = volume_parts(model, layout, options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Code::kOverLimit);
  EXPECT_EQ(refused.error().place.entity, 2u);
  EXPECT_NE(refused.error().message.find("more than 72 points"), std::string::npos);
}

TEST(VolumeParts, ChordsAreAShareOfTheModelUnlessTheyAreGiven) {
  const SplineModel model = model_of_cells({box_cell({0, 0, 0}, {4, 1, 1}, 3)});
  const VolumeLayout layout = volume_layout(model, 0).value();
  const auto num_triangles = [&](const VolumeViewOptions& options) {
    return volume_parts(model, layout, options).value()[0].triangles.size();
  };
  VolumeViewOptions fine, given;
  fine.fineness = 1e-5;
  given.chord = 1e-5 * layout.diagonal;
  EXPECT_GT(num_triangles(fine), 5 * num_triangles({}));
  EXPECT_EQ(num_triangles(fine), num_triangles(given));
}

TEST(VolumeParts, NetsHaveALineForEachPairOfNeighbours) {
  const SplineModel model = model_of_cells({box_cell({0, 0, 0}, {4, 1, 1}, 3)});
  VolumeViewOptions options;
  options.has_nets = true;
  const auto parts = volume_parts(model, volume_layout(model, 0).value(), options).value();
  EXPECT_EQ(parts[0].net_points.size(), 12u);
  EXPECT_EQ(parts[0].net_lines.size(), 2 * 4u + 3 * 2u + 3 * 2u);
  for (const auto& [a, b] : parts[0].net_lines) {
    const Point3d &p = parts[0].net_points[a], &q = parts[0].net_points[b];
    EXPECT_EQ(std::abs(p[0] - q[0]) / 2 + std::abs(p[1] - q[1]) +
                  (p[0] == q[0] ? std::abs(p[2] - q[2]) : 0),
              1);
  }
}

TEST(VolumeParts, ModelsWithOtherEntitiesAreNamed) {
  SplineModel model = model_of_cells({box_cell({0, 0, 0}, {1, 1, 1})});
  EXPECT_TRUE(check_is_volumes(model));
  ExactCurve::Axis axis;
  axis.degree = 1;
  axis.knots = {Rational(0), Rational(0), Rational(1), Rational(1)};
  model.entities.push_back({ExactCurve({axis}, 1, false, {Rational(0), Rational(1)}), {}, {}, {}});
  EXPECT_EQ(check_is_volumes(model).error().place.entity, 1u);
  EXPECT_EQ(check_is_volumes(model).error().message, "a curve, not a volume");
  EXPECT_EQ(check_is_volumes(SplineModel()).error().code, Code::kEmpty);
}

TEST(CellColour, OfThirtyCellsAreDifferentAndRepeatThen) {
  std::set<std::array<int, 3>> seen;
  for (std::uint64_t i = 0; i < 30; ++i) {
    const Colour c = cell_colour(i);
    seen.insert({c.red, c.green, c.blue});
    EXPECT_EQ(cell_colour(i + 30), c);
  }
  EXPECT_EQ(seen.size(), 30u);
}

TEST(ViewParts, ScenesHaveTubesForNetsAfterTransparentSurfaces) {
  const SplineModel model =
      model_of_cells({box_cell({0, 0, 0}, {1, 1, 1}), box_cell({1, 0, 0}, {2, 1, 1})});
  VolumeViewOptions options;
  options.has_nets = true;
  const auto parts = volume_parts(model, volume_layout(model, 0).value(), options).value();
  const Scene scene = parts_scene(parts).value();
  EXPECT_TRUE(scene.lines.empty());
  ASSERT_EQ(scene.surfaces.size(), 4u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(scene.surfaces[i].paints[0].colour, cell_colour(i));
    EXPECT_LT(scene.surfaces[i].paints[0].opacity, 255);
    EXPECT_EQ(scene.surfaces[2 + i].paints, (std::vector<Paint>{{net_colour(cell_colour(i))}}));
    EXPECT_EQ(scene.surfaces[2 + i].triangles.size(), 12 * 24u);
  }
}

TEST(ViewParts, ScenesWithoutNetsAreOpaque) {
  const SplineModel model = model_of_cells({box_cell({0, 0, 0}, {1, 1, 1})});
  const auto parts = volume_parts(model, volume_layout(model, 0).value(), {}).value();
  const Scene scene = parts_scene(parts).value();
  ASSERT_EQ(scene.surfaces.size(), 1u);
  EXPECT_EQ(scene.surfaces[0].paints, (std::vector<Paint>{{cell_colour(0), 255}}));
}

TEST(ViewParts, OfNothingAreRefusedAsGltf) {
  EXPECT_EQ(parts_gltf({}).error().code, Code::kEmpty);
  EXPECT_EQ(parts_gltf({{"p", {}, {{0, 0, 0}}, {}, {}, {}}}).error().code, Code::kEmpty);
}

TEST(ViewParts, NamesInObjHaveNoBlanks) {
  const std::string bytes = parts_obj({{"a b\\c", {}, {}, {}, {}, {}}});
  EXPECT_EQ(bytes, "g a_b_c\n");
}

}  // namespace
}  // namespace veritope
