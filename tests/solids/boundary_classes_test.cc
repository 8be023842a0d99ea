// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/boundary_classes_test.cc: solid angles, classes of vertices and feature lines of domains whose shape is
// known.
#include "solids/tetrahedra/boundary_classes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "predicates/distance.h"
#include "robust/base/random.h"
#include "solids/tetrahedra/delaunay.h"
#include "solids/tetrahedra/tetrahedron_angles.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

constexpr double kPi = std::numbers::pi;
const Rational kThirtyDegrees(Integer(3), Integer(4));

struct Shape {
  std::vector<Vec3d> grid;
  std::vector<ExactPoint3> points;
  TetrahedralComplex complex;
};

// Tetrahedra of the cubes of an n^3 grid that are wanted.
template <typename Wanted>
Shape cubes(int n, Wanted wanted) {
  std::vector<Vec3d> grid;
  for (int x = 0; x <= n; ++x)
    for (int y = 0; y <= n; ++y)
      for (int z = 0; z <= n; ++z) grid.push_back({double(x), double(y), double(z)});
  const auto all = delaunay_tetrahedra(std::span<const Vec3d>(grid)).value().tetrahedra;
  std::vector<TetrahedronCorners> kept;
  for (const TetrahedronCorners& t : all) {
    Vec3d mean;
    for (const std::uint32_t v : t)
      mean = {mean.x + grid[v].x / 4, mean.y + grid[v].y / 4, mean.z + grid[v].z / 4};
    if (wanted(static_cast<int>(mean.x), static_cast<int>(mean.y), static_cast<int>(mean.z)))
      kept.push_back(t);
  }
  std::vector<ExactPoint3> points(grid.begin(), grid.end());
  const auto count = static_cast<std::uint32_t>(grid.size());
  return {std::move(grid), std::move(points), TetrahedralComplex(std::move(kept), count)};
}

struct Classes {
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<VertexClass> used;
  std::vector<std::vector<std::uint32_t>> lines;
};
Classes classes_of(const Shape& shape) {
  Classes out;
  out.edges = feature_edges(shape.points, shape.complex, kThirtyDegrees);
  out.used = classes_by_features(shape.points, shape.complex, out.edges, kThirtyDegrees);
  out.lines = feature_lines(out.edges, out.used);
  return out;
}

TEST(SolidAngle, IsTakenByAnArctangentWhereTheArcsineIsAmbiguous) {
  const std::vector<ExactPoint3> p{ExactPoint3(Vec3d{0, 0, 0.1}), ExactPoint3(Vec3d{1, 0, 0}),
                                   ExactPoint3(Vec3d{-0.5, 0.8, 0}),
                                   ExactPoint3(Vec3d{-0.5, -0.8, 0})};
  const double angle = approx_solid_angle(shape_of({&p[0], &p[1], &p[2], &p[3]}), 0);
  EXPECT_NEAR(angle, 5.218, 5e-4);
  EXPECT_NEAR(2 * std::asin(std::sin(angle / 2)), 1.065, 5e-4);  // what the paper's formula gives
}

TEST(SolidAngle, OctantsAreAnEighthAndSizesDoNotMatter) {
  for (const double unit : {1.0, 0x1p-900, 0x1p900}) {
    const std::vector<ExactPoint3> p{
        ExactPoint3(Vec3d{0, 0, 0}), ExactPoint3(Vec3d{3 * unit, 0, 0}),
        ExactPoint3(Vec3d{0, 7 * unit, 0}), ExactPoint3(Vec3d{0, 0, 5 * unit})};
    const TetrahedronShape shape = shape_of({&p[0], &p[1], &p[2], &p[3]});
    EXPECT_NEAR(approx_solid_angle(shape, 0), kPi / 2, 1e-14);
    // Between the oblique face, whose normal is (1/3, 1/7, 1/5), and the others.
    EXPECT_NEAR(approx_min_dihedral(shape),
                std::acos((1 / 3.0) / std::sqrt(1 / 9.0 + 1 / 49.0 + 1 / 25.0)), 1e-14);
  }
}

TEST(BoundaryClasses, ACubeHasEightCornersAndTwelveLines) {
  const Shape cube = cubes(3, [](int, int, int) { return true; });
  const Classes classes = classes_of(cube);
  std::map<VertexClass, int> count;
  for (const VertexClass c : classes.used) ++count[c];
  EXPECT_EQ(count[VertexClass::kCorner], 8);
  EXPECT_EQ(count[VertexClass::kCurve], 24);
  EXPECT_EQ(count[VertexClass::kSmooth], 24);
  EXPECT_EQ(count[VertexClass::kInterior], 8);
  EXPECT_EQ(classes.edges.size(), 36u);
  ASSERT_EQ(classes.lines.size(), 12u);
  for (const auto& line : classes.lines) EXPECT_EQ(line.size(), 4u);
  const std::vector<double> angles = approx_solid_angles(cube.points, cube.complex);
  for (std::uint32_t v = 0; v < angles.size(); ++v) {
    if (classes.used[v] == VertexClass::kInterior) {
      EXPECT_EQ(angles[v], 4 * kPi);
      continue;
    }
    const VertexClass paper = class_by_solid_angle(angles[v]);
    EXPECT_EQ(paper, classes.used[v]) << v;  // on a cube both agree
  }
}

TEST(BoundaryClasses, ACornerOfThreeOctantsIsACurveByThePaperAndACornerByItsEdges) {
  // The cubes 000, 100 and 010: at (1, 1, 1) the solid has three octants, each pi / 2.
  const Shape shape = cubes(2, [](int x, int y, int z) { return z == 0 && x + y < 2; });
  const Classes classes = classes_of(shape);
  const std::uint32_t v = 13;
  ASSERT_EQ(shape.grid[v], (Vec3d{1, 1, 1}));
  const double angle = approx_solid_angles(shape.points, shape.complex)[v];
  EXPECT_NEAR(angle, 3 * kPi / 2, 1e-13);
  EXPECT_EQ(class_by_solid_angle(angle), VertexClass::kCurve);
  EXPECT_EQ(classes.used[v], VertexClass::kCorner);
}

// A prism over a regular polygon: its rims turn by less than 30 degrees, so they are closed lines without corners.
TEST(BoundaryClasses, RimsOfACylinderAreClosedLines) {
  std::vector<Vec3d> points;
  constexpr int kSides = 20;
  for (const double z : {0.0, 1.0})
    for (int i = 0; i < kSides; ++i)
      points.push_back({std::cos(2 * kPi * i / kSides), std::sin(2 * kPi * i / kSides), z});
  const auto all = delaunay_tetrahedra(std::span<const Vec3d>(points)).value().tetrahedra;
  const Shape shape{points, {points.begin(), points.end()}, TetrahedralComplex(all, 2 * kSides)};
  const Classes classes = classes_of(shape);
  ASSERT_EQ(classes.lines.size(), 2u);
  for (const auto& line : classes.lines) {
    EXPECT_EQ(line.size(), kSides + 1u);
    EXPECT_EQ(line.front(), line.back());
    EXPECT_EQ(line.front() % kSides, 0u);
  }
  for (const VertexClass c : classes.used) EXPECT_EQ(c, VertexClass::kCurve);
}

TEST(BoundaryClasses, LimitsOfSolidAngles) {
  EXPECT_EQ(class_by_solid_angle(kPi / 2), VertexClass::kCorner);
  EXPECT_EQ(class_by_solid_angle(kPi / 2 + 1e-9), VertexClass::kCurve);
  EXPECT_EQ(class_by_solid_angle(3 * kPi / 2), VertexClass::kCurve);
  EXPECT_EQ(class_by_solid_angle(3 * kPi / 2 + 1e-9), VertexClass::kSmooth);
  EXPECT_EQ(class_by_solid_angle(2 * kPi), VertexClass::kSmooth);
  EXPECT_EQ(class_by_solid_angle(4 * kPi - 1), VertexClass::kCorner);
  EXPECT_EQ(class_by_solid_angle(4 * kPi - 2), VertexClass::kCurve);
}

TEST(Angles, AreComparedExactlyAtTheLimit) {
  // The path turns by 45 degrees: the squared cosine is 1/2.
  const ExactPoint3 a(Vec3d{0, 0, 0}), b(Vec3d{1, 0, 0}), c(Vec3d{2, 1, 0}), back(Vec3d{0, 1, 0});
  const Rational half(Integer(1), Integer(2)), more = half + Rational::power_of_two(-200);
  EXPECT_FALSE(turns_more(a, b, c, half));
  EXPECT_TRUE(turns_more(a, b, c, more));
  EXPECT_TRUE(turns_more(a, b, back, Rational(0)));
  // Two facets that meet at 45 degrees from flat, and the same folded back.
  const ExactPoint3 left(Vec3d{0, 1, 0}), right(Vec3d{0, -1, -1}), over(Vec3d{0, 1, 1});
  EXPECT_FALSE(folds_more(a, b, left, right, half));
  EXPECT_TRUE(folds_more(a, b, left, right, more));
  EXPECT_TRUE(folds_more(a, b, left, over, Rational(0)));
}

TEST(Distances, AreComparedLikeTheirSquares) {
  for (long round = 0; round < scaled(300); ++round) {
    Random random(static_cast<std::uint64_t>(round));
    std::vector<ExactPoint3> p;
    for (int i = 0; i < 4; ++i) {
      std::array<Rational, 3> at;
      for (Rational& x : at)
        x = Rational(Integer(random.between(-3, 3)), Integer(random.between(1, 3)));
      p.emplace_back(std::move(at));
    }
    const auto squared = [](const std::array<Rational, 3>& v) {
      return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    };
    const auto between = [&](std::size_t i, std::size_t j) {
      return squared(
          {p[i].at()[0] - p[j].at()[0], p[i].at()[1] - p[j].at()[1], p[i].at()[2] - p[j].at()[2]});
    };
    EXPECT_EQ(compare_distances(p[0], p[1], p[2]), (between(0, 1) - between(0, 2)).sign()) << round;
    std::array<Rational, 3> middle;
    for (std::size_t a = 0; a < 3; ++a)
      middle[a] = (p[0].at()[a] + p[1].at()[a]) / Rational(2) - p[2].at()[a];
    EXPECT_EQ(compare_middle_to_ball(p[0], p[1], p[2], p[3]),
              (squared(middle) - between(2, 3)).sign())
        << round;
  }
}

TEST(Distances, RadiiOfSpheresAreComparedExactly) {
  // The sphere around (1, 2, 3) / 3 with radius 7/3 contains these points.
  const auto at = [](int x, int y, int z) {
    return ExactPoint3(std::array<Rational, 3>{Rational(Integer(1 + x), Integer(3)),
                                               Rational(Integer(2 + y), Integer(3)),
                                               Rational(Integer(3 + z), Integer(3))});
  };
  const ExactPoint3 a = at(7, 0, 0), b = at(2, 3, 6), c = at(-6, 2, 3), d = at(0, -7, 0),
                    p = at(0, 0, 0);
  const std::array<const ExactPoint3*, 4> corners{&a, &b, &c, &d};
  EXPECT_EQ(compare_circumradius(corners, p, a, Rational(1)), Sign::kZero);
  EXPECT_EQ(compare_circumradius(corners, p, a, Rational(1) + Rational::power_of_two(-200)),
            Sign::kNegative);
  EXPECT_EQ(compare_circumradius(corners, p, a, Rational(1) - Rational::power_of_two(-200)),
            Sign::kPositive);
  EXPECT_EQ(compare_circumradius(corners, p, at(14, 0, 0), Rational(Integer(1), Integer(2))),
            Sign::kZero);
}

}  // namespace
}  // namespace veritope
