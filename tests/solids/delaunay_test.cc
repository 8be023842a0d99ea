// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/delaunay_test.cc: Delaunay tetrahedralizations against their definition, of points in general position
// and of degenerate ones.
#include "solids/tetrahedra/delaunay.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "solids/tetrahedra/insertion_order.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/delaunay_laws.h"
#include "tests/support/point_sets.h"

namespace veritope {
namespace {

using Points = std::vector<Vec3d>;

DelaunayTetrahedra tetrahedra_of(const Points& points) {
  auto result = delaunay_tetrahedra(std::span<const Vec3d>(points));
  EXPECT_TRUE(result) << (result ? "" : to_string(result.error())) << "\n" << to_text(points);
  return result ? *std::move(result) : DelaunayTetrahedra{};
}

Points cube_grid(int n) {
  Points out;
  for (int x = 0; x <= n; ++x)
    for (int y = 0; y <= n; ++y)
      for (int z = 0; z <= n; ++z) out.push_back({double(x), double(y), double(z)});
  return out;
}

TEST(Delaunay, OneTetrahedronIsTurnedToBePositive) {
  const Points points{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
  const DelaunayTetrahedra result = tetrahedra_of(points);
  ASSERT_EQ(result.tetrahedra.size(), 1u);
  EXPECT_EQ(check_delaunay<Vec3d>(points, result, true), "");
}

TEST(Delaunay, ObeysItsLawsOnSetsOfAllKinds) {
  for (long round = 0; round < scaled(20); ++round)
    for (int kind = 0; kind < kPointSetKinds; ++kind) {
      Random random(static_cast<std::uint64_t>(1000 * round + kind));
      const PointSet set = make_point_set(kind, 5 + random.below(60), random);
      SCOPED_TRACE(set.kind + " " + to_text(set.points));
      const DelaunayTetrahedra result = tetrahedra_of(set.points);
      ASSERT_EQ(check_delaunay<Vec3d>(set.points, result, true), "");
      EXPECT_TRUE(volumes_add_up(set.points, result));
    }
}

TEST(Delaunay, ObeysItsLawsOnLargerSets) {
  for (int kind = 0; kind < kPointSetKinds; ++kind) {
    Random random(static_cast<std::uint64_t>(kind));
    const PointSet set = make_point_set(kind, 1000, random);
    SCOPED_TRACE(set.kind);
    EXPECT_EQ(check_delaunay<Vec3d>(set.points, tetrahedra_of(set.points), false), "");
  }
}

TEST(Delaunay, AGridIsCoveredByTetrahedraThatAreNotFlat) {
  for (int n = 1; n <= 6; ++n) {
    const Points points = cube_grid(n);
    const DelaunayTetrahedra result = tetrahedra_of(points);
    EXPECT_EQ(check_delaunay<Vec3d>(points, result, n <= 3), "") << n;
    Rational volume;
    for (const TetrahedronCorners& t : result.tetrahedra)
      volume += internal::exact_det({points[t[0]], points[t[1]], points[t[2]], points[t[3]]});
    EXPECT_EQ(volume, Rational(6 * n * n * n)) << n;
  }
}

TEST(Delaunay, DependsOnThePlacesOfPointsOnly) {
  for (long round = 0; round < scaled(40); ++round)
    for (const int kind : {1, 2, 3, 8, 10, 11}) {
      Random random(static_cast<std::uint64_t>(100 * round + kind));
      PointSet set = make_point_set(kind, 5 + random.below(80), random);
      const auto places = [](const Points& points) {
        std::set<std::set<std::array<double, 3>>> out;
        for (const TetrahedronCorners& t : tetrahedra_of(points).tetrahedra) {
          auto& corners = *out.insert(std::set<std::array<double, 3>>{
                                          {points[t[0]].x, points[t[0]].y, points[t[0]].z},
                                          {points[t[1]].x, points[t[1]].y, points[t[1]].z},
                                          {points[t[2]].x, points[t[2]].y, points[t[2]].z},
                                          {points[t[3]].x, points[t[3]].y, points[t[3]].z}})
                               .first;
          EXPECT_EQ(corners.size(), 4u);
        }
        return out;
      };
      const auto before = places(set.points);
      SCOPED_TRACE(set.kind + " " + to_text(set.points));
      std::shuffle(set.points.begin(), set.points.end(), random);
      set.points.push_back(set.points[random.below(set.points.size())]);
      EXPECT_EQ(places(set.points), before);
    }
}

TEST(Delaunay, ReportsDuplicates) {
  const Points points{{0, 0, 0}, {1, 0, 0},    {0, 0, 0}, {0, 1, 0},
                      {0, 0, 1}, {0, 1, -0.0}, {1, 0, 0}, {-0.0, 0, 0}};
  const DelaunayTetrahedra result = tetrahedra_of(points);
  EXPECT_EQ(result.same_as, (std::vector<std::uint32_t>{0, 1, 0, 3, 4, 3, 1, 0}));
  ASSERT_EQ(result.tetrahedra.size(), 1u);
  EXPECT_EQ(sorted_tetrahedra(result.tetrahedra)[0], (TetrahedronCorners{0, 1, 3, 4}));
}

void expect_refused(const Points& points, Code code, const std::string& message) {
  const auto result = delaunay_tetrahedra(std::span<const Vec3d>(points));
  ASSERT_FALSE(result) << to_text(points);
  EXPECT_EQ(result.error().code, code);
  EXPECT_EQ(result.error().message, message);
}

TEST(Delaunay, RefusesWhatSpansNoSpace) {
  expect_refused({}, Code::kBadArgument, "a tetrahedron needs four points, not 0");
  expect_refused({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Code::kBadArgument,
                 "a tetrahedron needs four points, not 3");
  expect_refused(Points(9, {1, 2, 3}), Code::kBadArgument, "all 9 points lie in one plane");
  Points line, plane;
  for (int i = 0; i < 20; ++i) {
    line.push_back({i * 0.25, i * 0.5, i * 0.75});
    plane.push_back({i * 0.25, i * i * 0.5, i * 0.25 + i * i * 0.5});
  }
  expect_refused(line, Code::kBadArgument, "all 20 points lie in one plane");
  expect_refused(plane, Code::kBadArgument, "all 20 points lie in one plane");
  plane[7].z = std::nextafter(plane[7].z, 100);
  EXPECT_EQ(check_delaunay<Vec3d>(plane, tetrahedra_of(plane), true), "");
}

TEST(Delaunay, RefusesPointsThatAreNotFinite) {
  Points points = cube_grid(1);
  points[5].y = std::numeric_limits<double>::infinity();
  expect_refused(points, Code::kNotFinite, "a coordinate of point 5 is not finite");
  points[5].y = std::numeric_limits<double>::quiet_NaN();
  expect_refused(points, Code::kNotFinite, "a coordinate of point 5 is not finite");
}

TEST(Delaunay, StopsAtItsLimit) {
  const Points points = cube_grid(4);
  const auto result = delaunay_tetrahedra(std::span<const Vec3d>(points), {.max_tetrahedra = 50});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, Code::kOverLimit);
  EXPECT_EQ(result.error().message, "more than 50 tetrahedra are needed");
}

// Points divided by 3: no coordinate but 0 is a binary64 number, and all degeneracies remain.
std::vector<ExactPoint3> thirds(const Points& points) {
  std::vector<ExactPoint3> out;
  for (const Vec3d& p : points)
    out.emplace_back(std::array<Rational, 3>{Rational::from_double(p.x) / Rational(3),
                                             Rational::from_double(p.y) / Rational(3),
                                             Rational::from_double(p.z) / Rational(3)});
  return out;
}

TEST(Delaunay, AtRationalPointsIsThatOfTheScaledOnes) {
  for (long round = 0; round < scaled(4); ++round)
    for (int kind = 0; kind < kPointSetKinds; ++kind) {
      Random random(static_cast<std::uint64_t>(1000 * round + kind));
      const PointSet set = make_point_set(kind, 5 + random.below(40), random);
      SCOPED_TRACE(set.kind + " " + to_text(set.points));
      const std::vector<ExactPoint3> points = thirds(set.points);
      const auto result = delaunay_tetrahedra(std::span<const ExactPoint3>(points));
      ASSERT_TRUE(result);
      EXPECT_EQ(check_delaunay<ExactPoint3>(points, *result, false), "");
      const DelaunayTetrahedra scaled_up = tetrahedra_of(set.points);
      EXPECT_EQ(sorted_tetrahedra(result->tetrahedra), sorted_tetrahedra(scaled_up.tetrahedra));
      EXPECT_EQ(result->same_as, scaled_up.same_as);
    }
}

TEST(Delaunay, RationalPointsThatAreOfBinary64GiveTheSame) {
  const Points points = cube_grid(2);
  const std::vector<ExactPoint3> exact(points.begin(), points.end());
  const auto result = delaunay_tetrahedra(std::span<const ExactPoint3>(exact));
  ASSERT_TRUE(result);
  EXPECT_EQ(result->tetrahedra, tetrahedra_of(points).tetrahedra);
}

TEST(InSphereOfRationalPoints, IsThatOfBinary64PointsAndOddInEachPairOfPoints) {
  for (long round = 0; round < scaled(200); ++round) {
    Random random(static_cast<std::uint64_t>(round));
    const PointSet set = make_point_set(static_cast<int>(random.below(kPointSetKinds)), 40, random);
    std::array<Vec3d, 5> p;
    for (Vec3d& q : p) q = set.points[random.below(set.points.size())];
    const std::vector<ExactPoint3> q = thirds({p.begin(), p.end()});
    const Sign expected = in_sphere(p[0], p[1], p[2], p[3], p[4]);
    SCOPED_TRACE(set.kind + " " + to_text(p));
    EXPECT_EQ(in_sphere(q[0], q[1], q[2], q[3], q[4]), expected);
    EXPECT_EQ(in_sphere(q[0], q[1], q[4], q[3], q[2]), -expected);
    EXPECT_EQ(in_sphere(q[1], q[0], q[2], q[3], q[4]), -expected);
    EXPECT_EQ(internal::in_sphere_exact(q[0], q[1], q[2], q[3], q[4]), expected);
  }
}

TEST(HilbertNumber, NeighboursOnTheCurveHaveACommonFace) {
  // On the 8^3 cells of one corner of the grid the numbers are 0 to 511, in some order, and consecutive cells touch.
  std::vector<std::array<int, 3>> cells(512, {-9, -9, -9});
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 8; ++y)
      for (int z = 0; z < 8; ++z) {
        const std::uint64_t number =
            hilbert_number(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                           static_cast<std::uint32_t>(z));
        ASSERT_LT(number, cells.size());
        cells[number] = {x, y, z};
      }
  for (std::size_t i = 1; i < cells.size(); ++i) {
    int distance = 0;
    for (std::size_t a = 0; a < 3; ++a) distance += std::abs(cells[i][a] - cells[i - 1][a]);
    EXPECT_EQ(distance, 1) << i;
  }
}

TEST(InsertionOrder, IsAPermutationAlsoOfEqualAndExtremePoints) {
  constexpr double kMost = std::numeric_limits<double>::max();
  for (const Points& points : {Points{}, Points(100, {1, 1, 1}),
                               Points{{-kMost, kMost, 0}, {kMost, -kMost, 0x1p-1074}, {0, 0, 0}},
                               Points{{0x1p-1074, 0, 0}, {0, 0, 0}, {0, 0x1p-1074, 0}}}) {
    std::vector<std::uint32_t> order = insertion_order(points);
    std::sort(order.begin(), order.end());
    ASSERT_EQ(order.size(), points.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
  }
}

}  // namespace
}  // namespace veritope
