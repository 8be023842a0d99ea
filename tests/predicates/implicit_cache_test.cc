// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/implicit_cache.h"

#include <gtest/gtest.h>

#include <thread>

#include "predicates/implicit_predicates.h"
#include "robust/base/check.h"
#include "tests/predicates/point_generators.h"

namespace veritope {
namespace {

const Vec3d kO{0, 0, 0}, kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

LinePlanePoint line_plane(const generate::Points& p) { return {p[0], p[1], p[2], p[3], p[4]}; }
ThreePlanePoint three_planes(const generate::Points& p, const generate::Points& q) {
  return ThreePlanePoint({p[0], p[1], p[2], p[3], p[4], q[0], q[1], q[2], q[3]});
}

TEST(CachedPoint, KnowsItsDigitsAfterTheFirstExactQuestion) {
  const CachedPoint point(LinePlanePoint({0.25, 0.25, -1}, {0.25, 0.25, 3}, kO, kX, kY));
  EXPECT_EQ(orient3d(kO, kX, kY, point), Sign::kZero);
  const auto* digits = point.digits();
  ASSERT_NE(digits, nullptr);
  EXPECT_EQ(point.digits(), digits);
  EXPECT_EQ(internal::orientation_of_digits(*digits, kO, kX, kY), Sign3::kZero);
  EXPECT_NE(internal::orientation_of_digits(*digits, kO, kX, {0, 1, 0x1p-40}), Sign3::kZero);
  const CachedPoint copy(point);
  EXPECT_EQ(orient3d(kO, kX, kY, copy), Sign::kZero);
}

TEST(CachedPoint, QueriesBeyondItsLatticeAreAnsweredWithoutTheDigits) {
  const CachedPoint point(ThreePlanePoint({kO, kX, kY, kO, kY, kZ, kO, kZ, kX}));  // the origin
  ASSERT_NE(point.digits(), nullptr);
  for (const double far : {0x1p70, 0x1p-70, 0x1p1000, 0x1p-1074}) {
    EXPECT_EQ(internal::orientation_of_digits(*point.digits(), kX, {0, far, 0}, kO),
              Sign3::kUncertain);
    EXPECT_EQ(orient3d(kX, {0, far, 0}, {-1, far, 0}, point), Sign::kZero);
    EXPECT_EQ(orient3d({1, 0, far}, {0, 1, far}, {-1, -1, far}, point), Sign::kNegative);
  }
}

TEST(CachedPoint, WithoutDigitsItStillAnswers) {
  const CachedPoint wide(
      LinePlanePoint({0.25, 0.25, -1}, {0.25, 0x1p-400, 3}, kO, {0x1p300, 0, 0}, kY));
  EXPECT_EQ(wide.digits(), nullptr);
  EXPECT_EQ(orient3d(kO, kX, kY, wide), Sign::kZero);
  EXPECT_EQ(compare_x(wide, wide), Sign::kZero);
  const CachedPoint none(LinePlanePoint(kO, kX, kO, kX, kY));
  EXPECT_FALSE(none.is_defined());
  EXPECT_THROW(orient3d(kO, kX, kY, none), InternalError);
  EXPECT_THROW(compare_x(none, kO), InternalError);
}

TEST(CachedPoint, HasTheSignsOfThePointForEveryKindOfPoints) {
  const std::uint64_t seed = 20261124;
  Random random(seed);
  int with_digits = 0;
  for (int kind = 0; kind < generate::kNumKinds; ++kind) {
    for (int i = 0; i < 60; ++i) {
      const auto draw = [&] { return generate::points(static_cast<generate::Kind>(kind), random); };
      const generate::Points one = draw(), two = draw(), query = draw();
      SCOPED_TRACE("seed " + std::to_string(seed) + ": " + generate::text(one) +
                   generate::text(two) + generate::text(query));
      const auto compare = [&](const auto& plain) {
        if (!plain.is_defined()) return;
        const CachedPoint cached(plain);
        const auto& v = plain.points();
        const std::size_t n = v.size();
        const std::array<std::array<Vec3d, 3>, 3> planes{{{query[0], query[1], query[2]},
                                                          {v[n - 3], v[n - 2], v[n - 1]},
                                                          {query[0], v[1], v[0]}}};
        for (const auto& q : planes) {
          EXPECT_EQ(orient3d(q[0], q[1], q[2], cached), orient3d(q[0], q[1], q[2], plain));
          if (cached.digits() == nullptr) continue;
          const Sign3 s = internal::orientation_of_digits(*cached.digits(), q[0], q[1], q[2]);
          if (!is_certain(s)) continue;
          ++with_digits;
          EXPECT_EQ(to_sign(s), internal::implicit_exact(plain, q[0], q[1], q[2]));
        }
        EXPECT_TRUE(coincide(cached, plain));
      };
      compare(line_plane(one));
      compare(three_planes(one, two));
    }
  }
  EXPECT_GT(with_digits, 1000);
}

// For TSan, too: all threads ask all points, which nobody has asked before.
TEST(CachedPoint, ThreadsMayAskTheSamePointsAtTheSameTime) {
  Random random(3);
  std::vector<LinePlanePoint> lines;
  std::vector<ThreePlanePoint> planes;
  while (lines.size() < 200) {
    const generate::Points p = generate::points(generate::Kind::kGeneric, random),
                           q = generate::points(generate::Kind::kGeneric, random);
    lines.push_back(line_plane(p)), planes.push_back(three_planes(p, q));
  }
  const std::vector<CachedPoint<LinePlanePoint>> cached_lines(lines.begin(), lines.end());
  const std::vector<CachedPoint<ThreePlanePoint>> cached_planes(planes.begin(), planes.end());
  std::array<int, 4> wrong{};
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < wrong.size(); ++t) {
    threads.emplace_back([&, t] {
      for (int round = 0; round < 3; ++round) {
        for (std::size_t i = 0; i < cached_lines.size(); ++i) {
          const auto& l = lines[i].points();
          const auto& p = planes[i].points();
          wrong[t] += orient3d(l[2], l[3], l[4], cached_lines[i]) != Sign::kZero;
          wrong[t] += orient3d(p[3], p[4], p[5], cached_planes[i]) != Sign::kZero;
          wrong[t] += !coincide(cached_planes[i], cached_planes[i]);
          wrong[t] +=
              compare_x(cached_lines[i], cached_planes[i]) != compare_x(lines[i], planes[i]);
        }
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, (std::array<int, 4>{}));
  for (const auto& point : cached_lines) EXPECT_NE(point.digits(), nullptr);
}

}  // namespace
}  // namespace veritope
