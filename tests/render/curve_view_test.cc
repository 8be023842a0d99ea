// SPDX-License-Identifier: LGPL-3.0-or-later
// Parts of curves and sheets for pictures.
#include "render/curve_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/micro_view.h"
#include "splines/bspline_pieces.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

// The curve with these control points, each coordinate an integer.
SplineEntity curve_entity(const std::vector<std::array<int, 3>>& points,
                          std::optional<std::size_t> group = std::nullopt, int dimension = 3) {
  BezierCurve<Rational> map({static_cast<int>(points.size()) - 1}, dimension, false);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (int c = 0; c < dimension; ++c)
      map.component(c)[i] = Rational(points[i][static_cast<std::size_t>(c)]);
  return {to_bspline(map), {}, group, {}};
}
SplineEntity sheet_entity(int dimension = 3) {
  BezierSurface<Rational> map({1, 1}, dimension, false);
  for (std::size_t i = 0; i < 4; ++i) {
    map.component(0)[i] = Rational(static_cast<std::int64_t>(i / 2));
    map.component(1)[i] = Rational(static_cast<std::int64_t>(i % 2));
  }
  return {to_bspline(map), {}, std::nullopt, {}};
}
SplineModel curves_and_bridge() {
  SplineModel out;
  out.groups = {{"others", {}, std::nullopt}, {"bridges", {}, std::nullopt}};
  out.entities = {curve_entity({{0, 0, 0}, {4, 0, 0}}),
                  curve_entity({{0, 0, 1}, {2, 2, 1}, {4, 0, 1}}, 0), sheet_entity(),
                  curve_entity({{4, 0, 0}, {5, 0, 0}, {5, 1, 0}}, 1)};
  return out;
}
const ViewPart* curve_part(const std::vector<ViewPart>& parts, const std::string& name) {
  const auto found =
      std::find_if(parts.begin(), parts.end(), [&](const ViewPart& p) { return p.name == name; });
  return found == parts.end() ? nullptr : &*found;
}

TEST(CurveView, KnowsFilesOfCurvesAndCountsThem) {
  const SplineModel model = curves_and_bridge();
  const auto counts = counts_of_curves(model);
  ASSERT_TRUE(counts.has_value());
  EXPECT_EQ((std::array{counts->curves, counts->sheets, counts->bridges}),
            (std::array<std::size_t, 3>{2, 1, 1}));
  SplineModel flat = model, sheets, volumes = model, empty;
  flat.entities.push_back(curve_entity({{0, 0, 0}, {1, 1, 1}}, std::nullopt, 2));
  EXPECT_FALSE(counts_of_curves(flat).has_value());
  flat = model;
  flat.entities.push_back(sheet_entity(2));
  EXPECT_FALSE(counts_of_curves(flat).has_value());
  sheets.entities = {sheet_entity()};
  EXPECT_FALSE(counts_of_curves(sheets).has_value());
  volumes.entities.push_back({to_bspline(BezierVolume<Rational>({1, 1, 1}, 3, false)), {}, {}, {}});
  EXPECT_FALSE(counts_of_curves(volumes).has_value());
  EXPECT_FALSE(counts_of_curves(empty).has_value());
}

TEST(CurveView, PartsHoldTheCurvesWithinTheChord) {
  const SplineModel model = curves_and_bridge();
  std::size_t last = 0;
  for (const double chord : {0.5, 0.01, 0.0001}) {
    CurveViewOptions options;
    options.chord = chord;
    const auto parts = curve_parts(model, options).value();
    ASSERT_EQ(parts.size(), 3u);
    const ViewPart *curves = curve_part(parts, "curves"), *bridges = curve_part(parts, "bridges"),
                   *sheets = curve_part(parts, "sheets");
    EXPECT_EQ(curves->colour, kTileColour);
    EXPECT_EQ(bridges->colour, kBridgeColour);
    EXPECT_EQ(sheets->triangles.size(), 2u);
    EXPECT_TRUE(curves->triangles.empty() && sheets->net_lines.empty());
    EXPECT_GT(curves->net_lines.size(), last);
    last = curves->net_lines.size();
    for (const auto& [a, b] : curves->net_lines) {
      const Point3d &p = curves->net_points[a], &q = curves->net_points[b];
      if (p[2] != 1) continue;
      // The parabola y = x (4 - x) / 4.
      const double x = (p[0] + q[0]) / 2, y = (p[1] + q[1]) / 2;
      EXPECT_NEAR(p[1], p[0] * (4 - p[0]) / 4, 1e-12);
      EXPECT_LE(std::abs(y - x * (4 - x) / 4), chord + 1e-12);  // but for rounding
    }
  }
}

TEST(CurveView, ScenesHaveTubesInTheirColoursAndATransparentModel) {
  const SplineModel model = curves_and_bridge();
  const TriangleMesh mesh = shapes::box({-1, -1, -1}, {6, 6, 6});
  CurveViewOptions options;
  options.model = &mesh;
  const Scene few = curve_scene(curve_parts(model, options).value(), 3);
  EXPECT_TRUE(few.lines.empty());
  ASSERT_EQ(few.surfaces.size(), 4u);
  std::size_t num_transparent = 0;
  for (const SceneSurface& s : few.surfaces) {
    ASSERT_EQ(s.paints.size(), 1u);
    EXPECT_FALSE(s.triangles.empty());
    if (s.paints[0].opacity == 255) continue;
    ++num_transparent;
    EXPECT_EQ(s.triangles.size(), mesh.faces.size());
    EXPECT_EQ(s.paints[0].opacity, kAroundOpacity);
  }
  EXPECT_EQ(num_transparent, 1u);
  // More curves have thinner tubes: here of the line along the first axis.
  const auto thickness = [](const Scene& scene) {
    double out = 0;
    for (const SceneSurface& s : scene.surfaces)
      if (s.paints[0].colour == kTileColour)
        for (const Point3d& p : s.points)
          if (p[2] < 0.5) out = std::max(out, std::abs(p[2]));
    return out;
  };
  const Scene many = curve_scene(curve_parts(model, options).value(), 100'000);
  EXPECT_GT(thickness(many), 0.0);
  EXPECT_GT(thickness(few), 2 * thickness(many));
}

TEST(CurveView, LimitsTheLines) {
  CurveViewOptions options;
  options.chord = 1e-6;
  options.max_lines = 100;
  const auto refused = curve_parts(curves_and_bridge(), options);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, Code::kOverLimit);
  EXPECT_NE(refused.error().message.find("--chord"), std::string::npos);
}

}  // namespace
}  // namespace veritope
