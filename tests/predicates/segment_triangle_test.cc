// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/segment_triangle.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/predicates/clip_oracle.h"

namespace veritope {
namespace {

using oracle::HPoint;
using oracle::IPoint;
using oracle::ITriangle;
using Kind = SegmentTriangleKind;

bool same_point(const HPoint& p, const IPoint& q) { return oracle::on_segment(p, q, q); }

SegmentTriangleContact classify(const IPoint& p, const IPoint& q, const ITriangle& t) {
  const std::vector<HPoint> meet = oracle::intersection(std::vector<IPoint>{p, q}, t);
  if (meet.empty()) return {};
  for (const HPoint& m : meet) {
    if (!(m == meet[0])) return {Kind::kOverlap, 0, false};
  }
  const bool at_end = same_point(meet[0], p) || same_point(meet[0], q);
  for (int i = 0; i < 3; ++i) {
    if (same_point(meet[0], t[i])) return {Kind::kVertex, i, at_end};
  }
  for (int i = 0; i < 3; ++i) {
    if (oracle::on_segment(meet[0], t[i], t[(i + 1) % 3])) return {Kind::kEdge, i, at_end};
  }
  return {Kind::kInterior, 0, at_end};
}

Vec3d real(const IPoint& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

void compare_on_grid(int nx, int ny, int nz, std::size_t stride, bool expect_all_kinds) {
  std::vector<IPoint> grid;
  for (int x = 0; x < nx; ++x) {
    for (int y = 0; y < ny; ++y) {
      for (int z = 0; z < nz; ++z) grid.push_back({x, y, z});
    }
  }
  std::array<long, 5> seen{};
  std::size_t turn = 0;
  for (const IPoint& a : grid) {
    for (const IPoint& b : grid) {
      for (const IPoint& c : grid) {
        const ITriangle t{a, b, c};
        if (oracle::degenerate(t) || ++turn % stride != 0) continue;
        for (const IPoint& p : grid) {
          for (const IPoint& q : grid) {
            const SegmentTriangleContact e = classify(p, q, t);
            ++seen[static_cast<int>(e.kind)];
            const SegmentTriangleContact s =
                segment_triangle(real(p), real(q), {real(a), real(b), real(c)});
            ASSERT_EQ(s, e) << "triangle (" << a[0] << a[1] << a[2] << ") (" << b[0] << b[1] << b[2]
                            << ") (" << c[0] << c[1] << c[2] << "), segment (" << p[0] << p[1]
                            << p[2] << ") (" << q[0] << q[1] << q[2] << "): kind "
                            << static_cast<int>(s.kind) << " part " << s.part << " end " << s.at_end
                            << ", expected " << static_cast<int>(e.kind) << ' ' << e.part << ' '
                            << e.at_end;
          }
        }
      }
    }
  }
  if (expect_all_kinds) {
    for (const long n : seen) EXPECT_GT(n, 100);
  }
}

TEST(SegmentTriangle, AgreesWithClippingOnAGridInSpace) { compare_on_grid(3, 3, 3, 13, true); }
TEST(SegmentTriangle, AgreesWithClippingOnEveryPlanarPairOfTheGrid) {
  compare_on_grid(4, 3, 1, 1, true);
}
TEST(SegmentTriangle, AgreesWithClippingOnEveryPairOfTheUnitCube) {
  compare_on_grid(2, 2, 2, 1, false);
}

TEST(SegmentTriangle, IsNotFooledByExtremeExponents) {
  const double tiny = 5e-324, huge = 1.7e308;
  const std::array<Vec3d, 3> t{{{-huge, -huge, 0}, {huge, -huge, 0}, {0, huge, 0}}};
  EXPECT_EQ(segment_triangle({0, 0, tiny}, {0, 0, huge}, t), (SegmentTriangleContact{}));
  EXPECT_EQ(segment_triangle({0, 0, tiny}, {0, 0, -tiny}, t),
            (SegmentTriangleContact{Kind::kInterior, 0, false}));
  EXPECT_EQ(segment_triangle({0, 0, 0}, {0, 0, huge}, t),
            (SegmentTriangleContact{Kind::kInterior, 0, true}));
  EXPECT_EQ(segment_triangle({0, -huge, tiny}, {tiny, -huge, -tiny}, t),
            (SegmentTriangleContact{Kind::kEdge, 0, false}));
}

TEST(SegmentTriangle, TellsContactsApartByKindPartAndEnd) {
  const SegmentTriangleContact a{Kind::kEdge, 1, false};
  EXPECT_EQ(a, (SegmentTriangleContact{Kind::kEdge, 1, false}));
  EXPECT_FALSE(a == (SegmentTriangleContact{Kind::kVertex, 1, false}));
  EXPECT_FALSE(a == (SegmentTriangleContact{Kind::kEdge, 2, false}));
  EXPECT_FALSE(a == (SegmentTriangleContact{Kind::kEdge, 1, true}));
}

TEST(SegmentTriangle, CountsTheTiersOfItsOrientations) {
  TierCounts tally;
  segment_triangle({0.25, 0.25, -1}, {0.25, 0.25, 1}, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, &tally);
  EXPECT_EQ(tally[Tier::kFilter], 5u);
}

TEST(SegmentTriangle, ContactsAreEqualIfAllPartsAre) {
  const SegmentTriangleContact a{Kind::kDisjoint, 1, true};
  EXPECT_TRUE(a == (SegmentTriangleContact{Kind::kDisjoint, 1, true}));
  EXPECT_FALSE(a == (SegmentTriangleContact{Kind::kDisjoint, 2, true}));
  EXPECT_FALSE(a == (SegmentTriangleContact{Kind::kDisjoint, 1, false}));
  EXPECT_FALSE(a == (SegmentTriangleContact{static_cast<Kind>(1), 1, true}));
}

}  // namespace
}  // namespace veritope
