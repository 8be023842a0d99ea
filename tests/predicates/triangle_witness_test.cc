// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/triangle_witness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "robust/base/check.h"
#include "tests/predicates/triangle_triangle_oracle.h"

namespace veritope {
namespace {

using oracle::HPoint;
using oracle::IPoint;
using oracle::ITriangle;

Rational coordinate(const HPoint& p, int axis) {
  return Rational(Integer(axis == 0 ? p.x : (axis == 1 ? p.y : p.z)), Integer(p.w));
}

// The claims of the header, checked from the definition alone.
void expect_valid(const TriangleWitness& w, const IndexedTriangle& t, const IndexedTriangle& u) {
  const auto expect_point = [&](const std::array<Integer, 3>& weight, const IndexedTriangle& tri) {
    Integer sum;
    for (const Integer& x : weight) {
      EXPECT_NE(x.sign(), Sign::kNegative);
      sum += x;
    }
    ASSERT_EQ(sum.sign(), Sign::kPositive);
    EXPECT_EQ(gcd(gcd(weight[0], weight[1]), weight[2]), Integer(1));
    for (int axis = 0; axis < 3; ++axis) {
      Rational c;
      for (int i = 0; i < 3; ++i)
        c += Rational(weight[i]) * Rational::from_double(tri.point[i][axis]);
      EXPECT_EQ(c / Rational(sum), w.point[axis]);
    }
  };
  expect_point(w.t_weight, t);
  expect_point(w.u_weight, u);
  // Outside the common simplex: some corner of t that u lacks has a positive weight.
  bool outside = false;
  for (int i = 0; i < 3; ++i) {
    bool shared = false;
    for (int j = 0; j < 3; ++j) shared = shared || t.id[i] == u.id[j];
    outside = outside || (!shared && w.t_weight[i].sign() == Sign::kPositive);
  }
  EXPECT_TRUE(outside);
}

// PROVES MESH-9.M7
TEST(TriangleWitness, IsACommonPointOutsideTheCommonSimplexForEveryImproperPairOfTheGrid) {
  std::vector<IPoint> points;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      for (int z = 0; z < 2; ++z) points.push_back({x, y, z});
    }
  }
  std::vector<ITriangle> triangles;
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = a + 1; b < points.size(); ++b) {
      for (std::size_t c = b + 1; c < points.size(); ++c) {
        const ITriangle t = (a + b + c) % 2 == 0 ? ITriangle{points[a], points[b], points[c]}
                                                 : ITriangle{points[b], points[a], points[c]};
        if (!oracle::degenerate(t)) triangles.push_back(t);
      }
    }
  }
  long checked = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t j = i % 97; j < triangles.size(); j += 97) {
      const ITriangle &t = triangles[i], &u = triangles[j];
      const oracle::Ids t_ids{0, 1, 2};
      oracle::for_all_names(t, u, [&](const oracle::Ids& ids) {
        const TriangleContact c = oracle::classify(t, t_ids, u, ids);
        if (c != TriangleContact::kImproper && c != TriangleContact::kCoplanarOverlap) return;
        const IndexedTriangle a = oracle::indexed(t, t_ids), b = oracle::indexed(u, ids);
        const TriangleWitness w = triangle_witness(a, b);
        expect_valid(w, a, b);
        Rational longest;
        const std::vector<HPoint> meet = oracle::intersection(t, u);
        for (const HPoint& p : meet) {
          for (const HPoint& q : meet) {
            Rational squared;
            for (int axis = 0; axis < 3; ++axis) {
              const Rational d = coordinate(p, axis) - coordinate(q, axis);
              squared += d * d;
            }
            if (squared > longest) longest = squared;
          }
        }
        EXPECT_EQ(w.squared_extent, longest);
        ++checked;
      });
      if (HasFailure()) FAIL() << "triangles " << i << " and " << j;
    }
  }
  EXPECT_GT(checked, 2000);
}

TEST(TriangleWitness, TakesTheMiddleOfACrossing) {
  const IndexedTriangle t{{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {0, 1, 2}};
  const IndexedTriangle u{{{{1, 1, -1}, {1, 1, 1}, {-3, 1, 0}}}, {3, 4, 5}};
  const TriangleWitness w = triangle_witness(t, u);
  EXPECT_EQ(w.point[0].to_string(), "1/2");
  EXPECT_EQ(w.point[1].to_string(), "1");
  EXPECT_EQ(w.point[2].to_string(), "0");
  EXPECT_EQ(w.squared_extent.to_string(), "1");
}

TEST(TriangleWitness, TakesTheMiddleOfTwoEdgesThatTouch) {
  // In one plane, on either side of the x-axis: they share [1, 3], in every order of their corners.
  std::array<Vec3d, 3> p{{{0, 0, 7}, {4, 0, 7}, {0, -4, 7}}}, q{{{1, 0, 7}, {3, 0, 7}, {2, 2, 7}}};
  for (int i = 0; i < 6; ++i, i % 3 == 0 ? std::swap(p[0], p[1])
                                         : void(std::rotate(p.begin(), p.begin() + 1, p.end()))) {
    for (int j = 0; j < 6; ++j, j % 3 == 0 ? std::swap(q[0], q[1])
                                           : void(std::rotate(q.begin(), q.begin() + 1, q.end()))) {
      const IndexedTriangle t{p, {0, 1, 2}}, u{q, {3, 4, 5}};
      for (const TriangleWitness& w : {triangle_witness(t, u), triangle_witness(u, t)}) {
        EXPECT_EQ(
            w.point[0].to_string() + " " + w.point[1].to_string() + " " + w.point[2].to_string(),
            "2 0 7");
        EXPECT_EQ(w.squared_extent.to_string(), "4");
      }
    }
  }
}

TEST(TriangleWitness, StaysExactWhenExponentsSpanTheWholeRange) {
  const double tiny = 5e-324, huge = 1.7e308;
  const IndexedTriangle t{{{{-huge, 0, 0}, {huge, tiny, 0}, {0, huge, 0}}}, {0, 1, 2}};
  const IndexedTriangle u{{{{0, 0, -tiny}, {0, 0, huge}, {1, huge, 0}}}, {3, 4, 5}};
  ASSERT_EQ(triangle_triangle(t, u), TriangleContact::kImproper);
  expect_valid(triangle_witness(t, u), t, u);
}

TEST(TriangleWitness, RefusesAPairThatMeetsProperly) {
  const IndexedTriangle t{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {0, 1, 2}};
  const IndexedTriangle u{{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}}, {0, 1, 3}};
  EXPECT_THROW(triangle_witness(t, u), InternalError);
}

}  // namespace
}  // namespace veritope
