// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/segment_segment2d.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "robust/rational.h"

namespace veritope {
namespace {

using Contact = SegmentContact;

// Oracle: by parameters in rationals, sharing no idea with the subject.
struct IVec {
  long x, y;
  friend bool operator==(const IVec&, const IVec&) = default;
};
Contact oracle(IVec p0, IVec p1, IVec q0, IVec q1) {
  const auto point = [](bool p_end, bool q_end) {
    return p_end && q_end ? Contact::kEnds
                          : (p_end || q_end ? Contact::kEndInside : Contact::kCrossing);
  };
  const long ux = p1.x - p0.x, uy = p1.y - p0.y, vx = q1.x - q0.x, vy = q1.y - q0.y;
  const long wx = q0.x - p0.x, wy = q0.y - p0.y;
  const long d = ux * vy - uy * vx;
  if (d != 0) {
    const Rational s(Integer(wx * vy - wy * vx), Integer(d)),
        t(Integer(wx * uy - wy * ux), Integer(d));
    const Rational zero(0), one(1);
    if (s < zero || s > one || t < zero || t > one) return Contact::kDisjoint;
    return point(s == zero || s == one, t == zero || t == one);
  }
  // Parallel, or a point: place all on the longer one's line.
  const bool p_longer = ux * ux + uy * uy >= vx * vx + vy * vy;
  const IVec base = p_longer ? p0 : q0, dir = p_longer ? IVec{ux, uy} : IVec{vx, vy};
  const auto off = [&](IVec a) { return (a.x - base.x) * dir.y - (a.y - base.y) * dir.x; };
  if (dir == IVec{0, 0}) return p0 == q0 ? Contact::kEnds : Contact::kDisjoint;
  if (off(p0) != 0 || off(q0) != 0) return Contact::kDisjoint;
  const auto along = [&](IVec a) { return (a.x - base.x) * dir.x + (a.y - base.y) * dir.y; };
  const long low = std::max(std::min(along(p0), along(p1)), std::min(along(q0), along(q1)));
  const long high = std::min(std::max(along(p0), along(p1)), std::max(along(q0), along(q1)));
  if (low > high) return Contact::kDisjoint;
  if (low < high) return Contact::kOverlap;
  return point(low == along(p0) || low == along(p1), low == along(q0) || low == along(q1));
}

Vec2d real(IVec v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }

TEST(SegmentSegment2d, AgreesWithRationalsOnEveryPairOfTheGridAndIsSymmetric) {
  std::vector<IVec> grid;
  for (long x = 0; x < 4; ++x) {
    for (long y = 0; y < 3; ++y) grid.push_back({x, y});
  }
  std::array<long, 5> seen{};
  for (const IVec p0 : grid) {
    for (const IVec p1 : grid) {
      for (const IVec q0 : grid) {
        for (const IVec q1 : grid) {
          const Contact c = oracle(p0, p1, q0, q1);
          ++seen[static_cast<int>(c)];
          ASSERT_EQ(segment_segment2d(real(p0), real(p1), real(q0), real(q1)), c)
              << p0.x << ',' << p0.y << ' ' << p1.x << ',' << p1.y << ' ' << q0.x << ',' << q0.y
              << ' ' << q1.x << ',' << q1.y;
          ASSERT_EQ(segment_segment2d(real(q1), real(q0), real(p0), real(p1)), c);
        }
      }
    }
  }
  for (const long n : seen) EXPECT_GT(n, 100);
}

TEST(SegmentSegment2d, IsNotFooledByExtremeExponents) {
  const double tiny = 5e-324, huge = 1.7e308;
  // (0, tiny) is off the diagonal, by the least amount there is.
  EXPECT_EQ(segment_segment2d({-huge, -huge}, {huge, huge}, {0, tiny}, {-huge, huge}),
            Contact::kDisjoint);
  EXPECT_EQ(segment_segment2d({-huge, -huge}, {huge, huge}, {0, 0}, {-huge, huge}),
            Contact::kEndInside);
  EXPECT_EQ(segment_segment2d({-huge, -huge}, {huge, huge}, {tiny, -tiny}, {-huge, huge}),
            Contact::kCrossing);
  EXPECT_EQ(segment_segment2d({0, 0}, {tiny, 0}, {0, 0}, {huge, 0}), Contact::kOverlap);
}

TEST(SegmentSegment2d, CountsTheTiersOfItsOrientations) {
  TierCounts tally;
  EXPECT_EQ(segment_segment2d({0, 0}, {1, 1}, {0, 1}, {1, 0}, &tally), Contact::kCrossing);
  EXPECT_EQ(tally[Tier::kFilter], 4u);
}

}  // namespace
}  // namespace veritope
