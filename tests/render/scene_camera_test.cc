// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/scene_camera_internal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "robust/base/check.h"
#include "robust/base/random.h"

namespace veritope::internal {
namespace {

constexpr double kHuge = std::numeric_limits<double>::max(),
                 kTiny = std::numeric_limits<double>::denorm_min();

double norm_of(const Point3d& p) { return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]); }

const Box3d kBoxes[] = {{{0, 0, 0}, {1, 1, 1}},
                        {{-kHuge, -kHuge, -kHuge}, {kHuge, kHuge, kHuge}},
                        {{-kHuge, 0, 0}, {kHuge, 0, 1}},
                        {{0, 0, 0}, {kTiny, 0, kTiny}},
                        {{kHuge, 1, -kTiny}, {kHuge, 3, kTiny}},
                        {{1e300, 2, 3}, {1e300, 2, 3}},
                        {{-1e-308, 1, 1}, {1e-308, 1, 1}}};

TEST(SceneCamera, EverythingLiesWellInFrontOfIt) {
  for (const Box3d& box : kBoxes)
    for (const Point3d& view : {Point3d{-5, 8, -5}, Point3d{0, 0, -1}, Point3d{kHuge, -kHuge, 1},
                                Point3d{kTiny, 0, 0}, Point3d{1e-30, 0, 1}}) {
      const SceneCamera camera(box, view);
      for (int corner = 0; corner < 8; ++corner) {
        Point3d p = box.lo;
        for (std::size_t k = 0; k < 3; ++k)
          if ((corner >> k & 1) != 0) p[k] = box.hi[k];
        const Point3d q = camera.in_frame(p);
        EXPECT_LE(norm_of(q), camera.distance() / 4 * (1 + 1e-15));
        EXPECT_GE(camera.distance() - q[2], 0.74 * camera.distance());
        const PicturePoint r = camera.projected(q);
        EXPECT_TRUE(std::isfinite(r.x) && std::isfinite(r.y));
        EXPECT_TRUE(0 <= r.depth && r.depth <= kDeepest);
      }
    }
}

TEST(SceneCamera, TheThirdAxisPointsUpwardAndNearThingsAreLarger) {
  const SceneCamera camera({{-1, -1, -1}, {1, 1, 1}}, {0, 5, 0});
  const auto seen = [&](const Point3d& p) { return camera.projected(camera.in_frame(p)); };
  const PicturePoint origin = seen({0, 0, 0}), up = seen({0, 0, 1}), right = seen({1, 0, 0});
  EXPECT_NEAR(origin.x, 0, 1e-15);
  EXPECT_NEAR(origin.y, 0, 1e-15);
  EXPECT_GT(up.y, 0.1);
  EXPECT_NEAR(up.x, 0, 1e-15);
  EXPECT_GT(right.x, 0.1);
  EXPECT_NEAR(right.x, up.y, 1e-15);  // no axis is stretched
  EXPECT_LT(seen({0, -1, 0}).depth, origin.depth);
  EXPECT_GT(seen({1, -1, 0}).x, right.x);
  EXPECT_LT(seen({1, 1, 0}).x, right.x);
}

TEST(SceneCamera, SeenFromAboveTheSecondAxisPointsUpward) {
  const SceneCamera camera({{-1, -1, -1}, {1, 1, 1}}, {0, 0, -3});
  const auto seen = [&](const Point3d& p) { return camera.projected(camera.in_frame(p)); };
  EXPECT_GT(seen({0, 1, 0}).y, 0.1);
  EXPECT_GT(seen({1, 0, 0}).x, 0.1);
}

TEST(SceneCamera, DepthIsLinearAlongStraightLinesOfThePicture) {
  const SceneCamera camera({{-1, -1, -1}, {1, 1, 1}}, {-5, 8, -5});
  Random random(20251203);
  const auto coordinate = [&] { return static_cast<double>(random.between(-1000, 1000)) / 1000; };
  for (int round = 0; round < 1000; ++round) {
    const Point3d p{coordinate(), coordinate(), coordinate()},
        q{coordinate(), coordinate(), coordinate()};
    const Point3d m{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2};
    const PicturePoint a = camera.projected(camera.in_frame(p)),
                       b = camera.projected(camera.in_frame(q)),
                       c = camera.projected(camera.in_frame(m));
    if (std::abs(a.x - b.x) < 1e-3) continue;
    const double t = (c.x - a.x) / (b.x - a.x);
    EXPECT_NEAR(c.depth / kDeepest, (a.depth + t * (b.depth - a.depth)) / kDeepest, 1e-9);
  }
}

TEST(SceneCamera, RefusesABoxThatIsNotFinite) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(SceneCamera({{0, 0, 0}, {kInfinity, 1, 1}}, {0, 1, 0}), InternalError);
}

TEST(FitInto, FillsTheRoomInOneDirectionAndIsCentred) {
  const PictureBox room{10, 20, 110, 60}, bounds{-0.2, -0.1, 0.2, 0.3};
  const PictureFit fit = fit_into(room, bounds);
  const PicturePoint low = fit({-0.2, -0.1, 7}), high = fit({0.2, 0.3, 7});
  EXPECT_NEAR(low.y, 60, 1e-12);
  EXPECT_NEAR(high.y, 20, 1e-12);
  EXPECT_NEAR(low.x, 40, 1e-12);
  EXPECT_NEAR(high.x, 80, 1e-12);
  EXPECT_EQ(low.depth, 7);
}

TEST(FitInto, DoesNotBlowUpRoundingErrors) {
  const PictureFit fit = fit_into({0, 0, 100, 100}, {-1e-17, 0, 1e-17, 0});
  EXPECT_NEAR(fit({1e-17, 0, 0}).x, 50, 1e-9);
  EXPECT_TRUE(std::isfinite(fit_into({0, 0, 100, 100}, {0, 0, 0, 0}).scale));
}

}  // namespace
}  // namespace veritope::internal
