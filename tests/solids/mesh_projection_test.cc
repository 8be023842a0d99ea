// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/mesh_projection.h"

#include <gtest/gtest.h>

#include <optional>
#include <set>

#include "tests/predicates/test_scale.h"
#include "tests/support/exact_geometry.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

using oracle::RVec;

constexpr std::uint64_t kProjectionSeed = 20261129;

Rational r(std::int64_t p, std::int64_t q = 1) { return Rational(p) / Rational(q); }

// All nearest points, from every foot on a plane, on a line, and every vertex that is in its facet. By solving for the
// foot with the normal, which is another way than that of the subject.
std::pair<Rational, std::set<RVec>> slow_projection(const TriangleMesh& mesh, const RVec& q) {
  using oracle::operator-, oracle::operator+, oracle::operator*;
  std::optional<Rational> least;
  std::set<RVec> points;
  const auto offer = [&](const RVec& p) {
    const Rational d = oracle::dot(q - p, q - p);
    if (least && *least < d) return;
    if (!least || d < *least) points.clear();
    least = d;
    points.insert(p);
  };
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const auto t = oracle::rational_triangle(mesh, f);
    const RVec n = oracle::normal_of(t);
    const RVec foot = q - (oracle::dot(n, q - t[0]) / oracle::dot(n, n)) * n;
    bool is_in = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const RVec e = t[(i + 1) % 3] - t[i];
      is_in = is_in && oracle::sgn(oracle::dot(n, oracle::cross(e, foot - t[i]))) >= 0;
      const Rational s = oracle::dot(e, q - t[i]) / oracle::dot(e, e);
      if (oracle::sgn(s) >= 0 && s <= r(1)) offer(t[i] + s * e);
      offer(t[i]);
    }
    if (is_in) offer(foot);
  }
  return {*least, points};
}

TEST(MeshProjection, FindsTheFootOnAFacetAnEdgeAndAVertex) {
  const TriangleMesh box = shapes::parse("box 0,0,0 4,4,4");
  const MeshProjection projection(box);
  const auto above = projection.project({r(1), r(2), r(7)});
  EXPECT_EQ(above.squared_distance, r(9));
  ASSERT_EQ(above.nearest.size(), 1u);
  EXPECT_EQ(above.nearest[0].point, (ExactPoint{r(1), r(2), r(4)}));
  EXPECT_EQ(above.nearest[0].feature, MeshFeature::kFacet);
  const auto edge = projection.project({r(5), r(1, 3), r(6)});
  EXPECT_EQ(edge.squared_distance, r(5));
  EXPECT_EQ(edge.nearest[0].point, (ExactPoint{r(4), r(1, 3), r(4)}));
  EXPECT_EQ(edge.nearest[0].feature, MeshFeature::kEdge);
  const auto corner = projection.project({r(-1), r(5), r(-3)});
  EXPECT_EQ(corner.squared_distance, r(11));
  ASSERT_EQ(corner.nearest.size(), 1u);
  EXPECT_EQ(corner.nearest[0].feature, MeshFeature::kVertex);
  const auto& t = box.faces[corner.nearest[0].facet];
  EXPECT_EQ(box.positions[t[corner.nearest[0].corner]], (Vec3d{0, 4, 0}));
}

TEST(MeshProjection, ReportsTiesInLexicographicOrder) {
  const TriangleMesh box = shapes::parse("box 0,0,0 4,4,4");
  const auto all = MeshProjection(box).project({r(2), r(2), r(2)});
  EXPECT_EQ(all.squared_distance, r(4));
  ASSERT_EQ(all.nearest.size(), 6u);
  EXPECT_TRUE(all.is_tie());
  EXPECT_EQ(all.nearest[0].point, (ExactPoint{r(0), r(2), r(2)}));
  EXPECT_EQ(all.nearest[1].point, (ExactPoint{r(2), r(0), r(2)}));
  EXPECT_EQ(all.nearest[5].point, (ExactPoint{r(4), r(2), r(2)}));
  // A coordinate that no double has breaks the tie.
  const auto one = MeshProjection(box).project({r(2) + Rational::power_of_two(-2000), r(2), r(2)});
  ASSERT_EQ(one.nearest.size(), 1u);
  EXPECT_EQ(one.nearest[0].point[0], r(4));
}

TEST(MeshProjection, PointsOfTheMeshAreTheirOwnNearestPoints) {
  const TriangleMesh box = shapes::parse("box 0,0,0 4,4,4");
  const auto on = MeshProjection(box).project({r(1, 3), r(1, 7), r(4)});
  EXPECT_EQ(on.squared_distance, r(0));
  ASSERT_EQ(on.nearest.size(), 1u);
  EXPECT_EQ(on.nearest[0].point, (ExactPoint{r(1, 3), r(1, 7), r(4)}));
}

TEST(MeshProjection, AgreesWithBruteForce) {
  for (int n = 0; n < scaled(60); ++n) {
    Random random(kProjectionSeed + static_cast<std::uint64_t>(n));
    TriangleMesh mesh;
    switch (n % 4) {
      case 0: mesh = shapes::star_polyhedron(random, 2); break;
      case 1: mesh = shapes::random_polycube(random, 3, 9); break;
      case 2: mesh = shapes::box({-2, -2, -2}, {2, 2, 2}, 3); break;
      default: mesh = shapes::needles(random, 12);
    }
    const MeshProjection projection(mesh);
    for (int k = 0; k < 5; ++k) {
      // Coarse coordinates make ties; others do not.
      const std::int64_t denominator = k % 2 == 0 ? 2 : 1009;
      ExactPoint q;
      for (Rational& x : q) x = r(random.between(-4 * denominator, 4 * denominator), denominator);
      const auto ours = projection.project(q);
      const auto slow = slow_projection(mesh, q);
      const std::string where = "seed " + std::to_string(kProjectionSeed) + " case " +
                                std::to_string(n) + " point " + q[0].to_string() + " " +
                                q[1].to_string() + " " + q[2].to_string();
      ASSERT_EQ(ours.squared_distance, slow.first) << where;
      std::vector<RVec> points;
      for (const NearestPoint& p : ours.nearest) points.push_back(p.point);
      ASSERT_EQ(points, std::vector<RVec>(slow.second.begin(), slow.second.end())) << where;
    }
  }
}

TEST(MeshProjection, FarAndHugeCoordinatesAreExact) {
  const TriangleMesh mesh = shapes::parse("box -0x1p900,-0x1p900,-0x1p900 0x1p900,0x1p900,0x1p900");
  const Rational huge = Rational::power_of_two(1100);
  const auto far = MeshProjection(mesh).project({huge, r(0), r(1)});
  EXPECT_EQ(far.nearest[0].point, (ExactPoint{Rational::power_of_two(900), r(0), r(1)}));
  const TriangleMesh tiny = shapes::scaled(shapes::parse("box 0,0,0 4,4,4"), -600);
  const auto near = MeshProjection(tiny).project({r(0), r(0), r(0)});
  EXPECT_EQ(near.squared_distance, r(0));
  EXPECT_EQ(near.nearest.size(), 1u);
}

}  // namespace
}  // namespace veritope
