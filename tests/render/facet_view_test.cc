// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "render/flat_scene_internal.h"
#include "robust/base/random.h"

namespace veritope::internal {
namespace {

TEST(FacetView, IsTheSameFromBothSidesAndForEverySize) {
  Random random(20251210);
  const auto coordinate = [&] { return static_cast<double>(random.between(-400, 400)) / 1024; };
  for (int round = 0; round < 500; ++round) {
    const Point3d a{coordinate(), coordinate(), coordinate()},
        b{coordinate(), coordinate(), coordinate()}, c{coordinate(), coordinate(), coordinate()};
    const FacetView view = facet_view({a, b, c}, 3), turned = facet_view({a, c, b}, 3);
    EXPECT_EQ(view.light, turned.light);
    EXPECT_EQ(view.normal, turned.normal);
    EXPECT_GE(view.light, 0.3);
    EXPECT_LE(view.light, 1);
    const auto& n = view.normal;
    EXPECT_NEAR(std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]), 127, 1);
    EXPECT_GE(n[2], -50) << "toward the camera, up to perspective";
  }
}

TEST(FacetView, ASurfaceAcrossTheLightIsBrightestAndEdgeOnFacesAreDarker) {
  const auto light = [](const Point3d& u, const Point3d& v) {
    return facet_view({Point3d{0, 0, 0}, u, v}, 4).light;
  };
  EXPECT_NEAR(light({3, 2, 0}, {-6, 0, -2}), 1, 1e-12);  // both are orthogonal to (-2, 3, 6)
  EXPECT_LT(light({1, 0, 0}, {0, 1, 0}), 0.97);
  EXPECT_GT(light({1, 0, 0}, {0, 1, 0}), 0.8);
  const double on_the_right = light({0, 1, 0}, {1, 0, -9}),
               on_the_left = light({0, 1, 0}, {-1, 0, -9});
  EXPECT_LT(on_the_right, on_the_left) << "the light comes from the left";
}

TEST(FacetView, DegenerateTrianglesHaveOne) {
  for (const double size : {0.0, 1e-300, 1e-160, 1e-100}) {
    const FacetView view = facet_view({Point3d{0, 0, 0}, {size, 0, 0}, {0, size, 0}}, 4);
    EXPECT_TRUE(0.3 <= view.light && view.light <= 1);
    EXPECT_EQ(view.normal, (std::array<std::int8_t, 3>{0, 0, 127}));
  }
}

}  // namespace
}  // namespace veritope::internal
