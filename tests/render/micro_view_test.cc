// SPDX-License-Identifier: LGPL-3.0-or-later
// Parts of microstructures for pictures.
#include "render/micro_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "splines/de_boor.h"
#include "tests/support/micro_cells.h"

namespace veritope {
namespace {

using micro_cells::box_tile;
using micro_cells::full;

const ViewPart* part_named(const std::vector<ViewPart>& parts, const std::string& name) {
  const auto found =
      std::find_if(parts.begin(), parts.end(), [&](const ViewPart& p) { return p.name == name; });
  return found == parts.end() ? nullptr : &*found;
}
/// A row of cells along x, each with a bar from wall to wall.
Microstructure bars(std::uint64_t cells) {
  return full({v_cells::cube(0, 0, 0)}, {cells, 1, 1}, box_tile({0, 16, 16}, {64, 48, 48}));
}
MicroBridge bridge_from(std::uint64_t cell, double from, double to) {
  MicroBridge b;
  b.cap = {0, cell, 1};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 3; ++k)
        b.points.push_back({Rational::from_double(from + (to - from) * k / 2),
                            Rational(1 + 2 * i) / Rational(4), Rational(1 + 2 * j) / Rational(4)});
  return b;
}

TEST(MicroView, PatchesBetweenTilesAreLeftOut) {
  MicroViewOptions options;
  options.parts = 2;  // one part a side for patches of degree 1
  for (const std::uint64_t n : {1, 2, 5}) {
    const auto parts = micro_parts(bars(n), options).value();
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0].name, "tiles");
    EXPECT_EQ(parts[0].triangles.size(), 2 * (4 * n + 2));
  }
}

TEST(MicroView, PointsAreThoseOfTheSurface) {
  Microstructure micro = bars(4);
  const auto parts = micro_parts(micro, {}).value();
  for (const Point3d& p : parts[0].points) {
    EXPECT_GE(p[0], 0.0);
    EXPECT_LE(p[0], 1.0);
    const bool is_on_bar = (p[1] == 0.25 || p[1] == 0.75 || p[2] == 0.25 || p[2] == 0.75 ||
                            p[0] == 0.0 || p[0] == 1.0) &&
                           p[1] >= 0.25 && p[1] <= 0.75 && p[2] >= 0.25 && p[2] <= 0.75;
    EXPECT_TRUE(is_on_bar) << p[0] << ' ' << p[1] << ' ' << p[2];
  }
}

TEST(MicroView, BridgesHaveFiveFacesAndHideTheirCaps) {
  Microstructure micro = bars(4);
  micro.grids[0].tiles = {1, 1, 0, 0};
  micro.bridges = {bridge_from(1, 0.5, 0.875)};
  MicroViewOptions options;
  options.parts = 2;
  const auto parts = micro_parts(micro, options).value();
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(part_named(parts, "tiles")->triangles.size(), 2u * 5);
  EXPECT_EQ(part_named(parts, "bridged_tiles")->triangles.size(), 2u * 4);
  const ViewPart* const bridge = part_named(parts, "bridges");
  EXPECT_EQ(bridge->triangles.size(), 5u * 2 * 4);
  double lo = 1, hi = 0;
  for (const Point3d& p : bridge->points) lo = std::min(lo, p[0]), hi = std::max(hi, p[0]);
  EXPECT_EQ(lo, 0.5);
  EXPECT_EQ(hi, 0.875);
  // Outward: with the cap that is left out, the triangles would enclose 3/8 * 1/4.
  double volume = 0;
  for (const auto& t : bridge->triangles) {
    const Point3d &a = bridge->points[t[0]], &b = bridge->points[t[1]], &c = bridge->points[t[2]];
    const double x = a[0] - 0.5;
    volume += x * ((b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])) / 2 +
              ((b[0] - a[0]) + (c[0] - a[0])) / 3 *
                  ((b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])) / 2;
  }
  EXPECT_NEAR(volume, 0.375 * 0.25, 1e-12);
}

TEST(MicroView, TheCageAndTheSolidAreAroundIt) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  MicroViewOptions options;
  options.has_cage = true;
  options.model = &mesh;
  const auto parts = micro_parts(bars(1), options).value();
  ASSERT_EQ(parts.size(), 3u);
  const ViewPart* const cage = part_named(parts, "cage");
  EXPECT_TRUE(cage->triangles.empty());
  std::set<std::vector<double>> corners;
  for (const Point3d& p : cage->net_points)
    if (std::all_of(p.begin(), p.end(), [](double x) { return x == 0 || x == 1; }))
      corners.insert({p[0], p[1], p[2]});
  EXPECT_EQ(corners.size(), 8u);
  const Scene scene = micro_scene(parts);
  EXPECT_EQ(scene.lines.size(), 12u);
  ASSERT_EQ(scene.surfaces.size(), 2u);
  EXPECT_LT(scene.surfaces[1].paints[0].opacity, 255);
  EXPECT_EQ(scene.surfaces[0].paints[0].opacity, 255);
}

TEST(MicroView, FewerPartsWhereThereAreManyTilesAndNoneBeyondTheLimit) {
  MicroViewOptions options;
  options.max_triangles = 4 * 6 * 2 * 4;  // as for two parts a side
  const auto parts = micro_parts(bars(4), options).value();
  EXPECT_LE(parts[0].triangles.size(), options.max_triangles);
  options.max_triangles = 4 * 6 * 2 - 1;
  const auto refused = micro_parts(bars(4), options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Code::kOverLimit);
}

TEST(MicroView, NothingKeptIsNoPart) {
  Microstructure micro = bars(2);
  micro.grids[0].tiles = {0, 0};
  EXPECT_TRUE(micro_parts(micro, {}).value().empty());
}

}  // namespace
}  // namespace veritope
