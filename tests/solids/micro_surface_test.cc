// SPDX-License-Identifier: LGPL-3.0-or-later
// The surface of a solid as microstructures see it: triangles, and nodes of patches.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "interval/upward.h"
#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "solids/micro/surface/close_descent.h"
#include "solids/micro/surface/patch_surface.h"
#include "solids/micro/surface/triangle_surface.h"
#include "tests/solids/patch_support.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

Box3 at(double x, double y, double z) { return Box3(Interval(x), Interval(y), Interval(z)); }
NodePoints node_at(const std::vector<Box3>& points) {
  NodePoints out;
  out.assign(points);
  return out;
}
double unit(Random& random) { return static_cast<double>(random.below(1u << 20)) * 0x1p-20; }

// The unit sphere as patches, and the cube [-1, 1]^3 as triangles and as patches.
PatchSurface sphere_surface() { return PatchSurface(complex_of(patch_shapes::octant_sphere())); }
PatchSurface cube_surface() {
  return PatchSurface(complex_of(patch_shapes::box({-1, -1, -1}, {1, 1, 1})));
}

TEST(NodePoints, HoldThePointsTheyAreMadeOf) {
  const ScopedUpward upward;
  const std::vector<Box3> points = {
      Box3(Interval::from_bounds(0, 1), Interval(2.0), Interval(-3.0)), at(4, 5, 6)};
  const NodePoints node = node_at(points);
  ASSERT_EQ(node.size(), 2u);
  EXPECT_EQ(node.box.lo, (Point3d{0, 2, -3}));
  EXPECT_EQ(node.box.hi, (Point3d{4, 5, 6}));
  EXPECT_GE(node.radius[0], 0.5);
  EXPECT_EQ(node.radius[1], 0);
  EXPECT_EQ(box_around(points), node.box);
}

TEST(NodePoints, WidenedPointsHoldWhatIsSoMuchFartherAway) {
  const ScopedUpward upward;
  NodePoints node = node_at({at(1, 2, 3), at(4, 5, 6)});
  node.widen(0x1p-60);
  EXPECT_EQ(node.box.lo, (Point3d{std::nextafter(1, 0), std::nextafter(2, 0), std::nextafter(3, 0)}));
  EXPECT_EQ(node.box.hi, (Point3d{std::nextafter(4, 9), std::nextafter(5, 9), std::nextafter(6, 9)}));
  EXPECT_EQ(node.radius, (Point3d{0x1p-60, 0x1p-60, 0x1p-60}));
  const Slab slab = slab_around({1, 0, 0}, std::vector<Box3>{at(0, 0, 0)});
  EXPECT_TRUE(is_beside(slab, node));
  node.widen(1);
  EXPECT_FALSE(is_beside(slab, node));
}

TEST(Slab, ASlabIsBesidePointsThatLieOnOneSideOnly) {
  const ScopedUpward upward;
  const Slab slab = slab_around({1, 1, 0}, std::vector<Box3>{at(0, 0, 9), at(1, 0, -9)});
  EXPECT_EQ(slab.lo, 0);
  EXPECT_EQ(slab.hi, 1);
  EXPECT_TRUE(is_beside(slab, node_at({at(1, 0x1p-20, 0), at(5, 5, 5)})));
  EXPECT_TRUE(is_beside(slab, node_at({at(0, -0x1p-20, 0)})));
  EXPECT_FALSE(is_beside(slab, node_at({at(1, 0, 0)})));
  EXPECT_FALSE(is_beside(slab, node_at({at(2, 0, 0), at(-2, 0, 0)})));
  // A gap of half a unit in the last place is not seen.
  EXPECT_FALSE(is_beside(slab, node_at({at(1, 0x1p-53, 0)})));
  const Slab none = slab_around({HUGE_VAL, 0, 0}, std::vector<Box3>{at(0, 0, 0)});
  EXPECT_EQ(none.direction, (Point3d{0, 0, 0}));
  EXPECT_FALSE(is_beside(none, node_at({at(5, 5, 5)})));
}

// A segment that passes the surface is never apart from all of its parts; one that is off is, once it is halved.
template <typename Side>
void expect_right_descents(const SolidSurface& surface, Side is_inside) {
  struct Segment {
    std::array<Point3d, 2> ends;
    int level = 0;
    std::pair<Segment, Segment> halves() const {
      Point3d middle;
      for (std::size_t c = 0; c < 3; ++c) middle[c] = 0.5 * (ends[0][c] + ends[1][c]);
      return {Segment{{ends[0], middle}, level + 1}, Segment{{middle, ends[1]}, level + 1}};
    }
  };
  const ScopedUpward upward;
  Random random(77);
  int num_crossing = 0, num_apart = 0;
  for (int round = 0; round < 200; ++round) {
    Segment s;
    for (Point3d& p : s.ends)
      for (double& x : p) x = 2.5 * unit(random) - 1.25;
    const bool is_crossing = is_inside(s.ends[0]) != is_inside(s.ends[1]);
    const auto view = surface.view();
    DescentBudget budget({4096, 1 << 20});
    const auto close_to = [&](const Segment& part, PartNumbers* parts) {
      const NodePoints node = node_at({at(part.ends[0][0], part.ends[0][1], part.ends[0][2]),
                                       at(part.ends[1][0], part.ends[1][1], part.ends[1][2])});
      budget.add_pairs(view->keep_close({&node, 1}, parts));
    };
    const Box3d all{{-9, -9, -9}, {9, 9, 9}};
    const auto left = descend(s, view->near(all), 30, budget, close_to);
    EXPECT_FALSE(budget.is_spent()) << round;
    EXPECT_GT(budget.counts().nodes, 0u);
    if (is_crossing) {
      EXPECT_TRUE(left.has_value()) << "seed 77, round " << round;
    }
    num_crossing += is_crossing;
    num_apart += !left.has_value();
  }
  EXPECT_GT(num_crossing, 20);
  EXPECT_GT(num_apart, 20);
}

TEST(SurfaceView, ClosePartsAreKept) {
  const auto in_ball = [](const Point3d& p) { return p[0] * p[0] + p[1] * p[1] + p[2] * p[2] < 1; };
  const auto in_cube = [](const Point3d& p) {
    return std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])}) < 1;
  };
  expect_right_descents(sphere_surface(), in_ball);
  expect_right_descents(cube_surface(), in_cube);
  const TriangleMesh cube = shapes::box({-1, -1, -1}, {1, 1, 1});
  expect_right_descents(TriangleSurface(cube), in_cube);
}

TEST(SurfaceView, PartsNearABoxCoverTheSurfaceThere) {
  const ScopedUpward upward;
  const PatchSurface sphere = sphere_surface();
  EXPECT_GE(sphere.nodes().size(), 4096u);
  const auto view = sphere.view();
  EXPECT_TRUE(view->near({{-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}}).empty());
  const PartNumbers near = view->near({{0.9, -0.1, -0.1}, {1.1, 0.1, 0.1}});
  ASSERT_FALSE(near.empty());
  for (const std::uint32_t n : near) EXPECT_LT(view->source(n), 8u);
  EXPECT_LE(sphere.box().hi[0], 1.05);
  EXPECT_GE(sphere.box().hi[0], 1);
  // A far node leaves none.
  PartNumbers far = near;
  const NodePoints node = node_at({at(5, 0, 0)});
  EXPECT_EQ(view->keep_close({&node, 1}, &far), 0u);
  EXPECT_TRUE(far.empty());
}

// Bounds hold, and are not much greater than the distance.
TEST(SurfaceView, ReachIsABoundThatIsNearTheDistance) {
  const ScopedUpward upward;
  const TriangleMesh mesh = shapes::box({-1, -1, -1}, {1, 1, 1});
  const TriangleSurface triangles(mesh);
  const PatchSurface cube = cube_surface(), sphere = sphere_surface();
  Random random(5);
  for (int round = 0; round < 60; ++round) {
    const double x = 1.5 * unit(random) - 0.75, y = 1.5 * unit(random) - 0.75,
                 z = 1.5 * unit(random) - 0.75;
    const std::vector<Box3> point = {at(x, y, z)};
    const double to_cube = 1 - std::max({std::abs(x), std::abs(y), std::abs(z)}),
                 to_sphere = std::abs(1 - std::sqrt(x * x + y * y + z * z));
    for (const auto& [surface, distance] :
         {std::pair<const SolidSurface*, double>{&triangles, to_cube},
          {&cube, to_cube},
          {&sphere, to_sphere}}) {
      const auto view = surface->view();
      const double bound = view->reach(point, HUGE_VAL);
      EXPECT_GE(bound, distance - 1e-12);
      EXPECT_LE(bound, 1.1 * distance + 0.01) << "seed 5, round " << round;
      EXPECT_EQ(view->reach(point, 0.9 * distance), HUGE_VAL);
      const double enough = view->reach(point, HUGE_VAL, 2 * distance + 0.1);
      EXPECT_GE(enough, distance - 1e-12);
      EXPECT_LE(enough, 2 * distance + 0.1);
    }
  }
  // The farthest of several points counts, from one part: two opposite faces are near no common one.
  const std::vector<Box3> both = {at(0.75, 0, 0), at(-0.75, 0, 0)};
  EXPECT_GE(triangles.view()->reach(both, HUGE_VAL), 1);
  EXPECT_GE(cube.view()->reach(both, HUGE_VAL), 1);
}

TEST(SurfaceNode, HalvesAlternateAndContainTheirParts) {
  const ScopedUpward upward;
  const SurfaceNode whole(PatchPiece(patch_shapes::octant_sphere()[0], 0));
  const auto [low, high] = whole.halves();
  EXPECT_EQ(low.level(), 1);
  EXPECT_EQ(low.piece().range(0).hi(), 0.5);
  EXPECT_EQ(low.piece().range(1).hi(), 1);
  const auto second = high.halves().first;
  EXPECT_EQ(second.piece().range(0).lo(), 0.5);
  EXPECT_EQ(second.piece().range(1).hi(), 0.5);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_LE(whole.points().box.lo[c], second.points().box.lo[c] + 1e-15);
    EXPECT_GE(whole.points().box.hi[c], second.points().box.hi[c] - 1e-15);
  }
  EXPECT_FALSE(whole.is_apart(whole.points()));
  EXPECT_TRUE(whole.is_apart(node_at({at(9, 9, 9)})));
  EXPECT_TRUE(second.can_halve());
}

}  // namespace
}  // namespace veritope
