// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/separator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "tests/predicates/point_generators.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/exact_geometry.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

using Group = std::vector<std::uint32_t>;

Group range(std::size_t begin, std::size_t end) {
  Group out(end - begin);
  std::iota(out.begin(), out.end(), static_cast<std::uint32_t>(begin));
  return out;
}

// d.p < d.q for all vertices p of a, q of b but at most one that both have, for which d.p < d.v < d.q.
bool separates(const TriangleMesh& mesh, const IntVec3& d, const Group& a, const Group& b) {
  const oracle::RVec v{Rational(d[0]), Rational(d[1]), Rational(d[2])};
  const auto heights = [&](const Group& facets) {
    std::map<std::uint32_t, Rational> out;
    for (std::uint32_t f : facets)
      for (std::uint32_t i : mesh.faces[f]) out.try_emplace(i, oracle::dot(v, oracle::rational(mesh.positions[i])));
    return out;
  };
  auto of_a = heights(a), of_b = heights(b);
  std::optional<Rational> between;
  for (auto it = of_a.begin(); it != of_a.end();) {
    if (of_b.count(it->first) != 0) {
      if (between) return false;
      between = it->second;
      of_b.erase(it->first);
      it = of_a.erase(it);
    } else {
      ++it;
    }
  }
  std::optional<Rational> most, least;
  for (const auto& [id, h] : of_a)
    if (!most || *most < h) most = h;
  for (const auto& [id, h] : of_b)
    if (!least || h < *least) least = h;
  return between ? (!most || *most < *between) && (!least || *between < *least) : *most < *least;
}

std::string text(const TriangleMesh& mesh, const IntVec3& d) {
  return shapes::to_text(mesh) + " along " + std::to_string(d[0]) + "," + std::to_string(d[1]) + "," + std::to_string(d[2]);
}

std::optional<IntVec3> find(const TriangleMesh& mesh, const Group& a, const Group& b) {
  SeparatorFinder finder(mesh, largest_coordinate(mesh));
  const auto d = finder.find(a, b);
  for (std::int32_t c : d.value_or(IntVec3{})) EXPECT_LT(std::abs(static_cast<std::int64_t>(c)), std::int64_t{1} << 31);
  return d;
}

TEST(Separator, SplitsTwoBoxesThatAreApart) {
  for (const char* far : {"2,0,0 3,1,1", "-2,0,0 -1,1,1", "0,1.001,0 1,2,1", "1.25,1.25,1.25 2,2,2", "0,0,-900 1,1,-0.001"}) {
    const TriangleMesh mesh = shapes::parse(std::string("box 0,0,0 1,1,1 ; box ") + far);
    const auto d = find(mesh, range(0, 12), range(12, 24));
    ASSERT_TRUE(d) << far;
    EXPECT_TRUE(separates(mesh, *d, range(0, 12), range(12, 24))) << text(mesh, *d);
  }
}

TEST(Separator, SplitsHullsThatInterlockInTheirBoxes) {
  // Two long thin bodies side by side along the diagonal: no coordinate axis separates them.
  const TriangleMesh mesh = shapes::joined(shapes::tilted_cylinder(50, shapes::Cap::kCentreFan),
                                           shapes::moved(shapes::tilted_cylinder(50, shapes::Cap::kCentreFan), {-2, 3, 0}));
  const std::size_t half = mesh.faces.size() / 2;
  const auto d = find(mesh, range(0, half), range(half, 2 * half));
  ASSERT_TRUE(d);
  EXPECT_TRUE(separates(mesh, *d, range(0, half), range(half, 2 * half)));
}

TEST(Separator, IsNotFoundWhereThereIsNone) {
  for (const char* text : {"box 0,0,0 2,2,2 ; box 1,1,1 3,3,3",               // overlap
                           "box 0,0,0 9,9,9 ; box 1,1,1 2,2,2",               // inside
                           "v 0,0,0 1,0,0 0,1,0 0,0,0 -1,0,0 0,-1,0 ; f 0,1,2 3,4,5",  // equal corners, two vertices
                           "tri 0,0,0 1,0,0 0,1,0 ; tri 0,0,0 -1,0,0 0,1,0",      // a common edge
                           "tri 0,0,0 1,0,0 0,1,0 ; tri 0,0,0 1,0,0 0,1,1",
                           "tri 0,0,0 1,0,0 0,1,0 ; tri 0,0,0 2,2,0 1,2,0"}) {    // a common vertex, but they overlap
    const TriangleMesh mesh = shapes::parse(text);
    const std::size_t half = mesh.faces.size() / 2;
    EXPECT_FALSE(find(mesh, range(0, half), range(half, 2 * half))) << text;
  }
}

TEST(Separator, MayPassThroughOneCommonVertex) {
  for (const char* text : {"tri 0,0,0 1,0,0 0,1,0 ; tri 0,0,0 -1,0,0 0,-1,0", "tri 0,0,0 1,0,0 0,1,0 ; tri 0,0,0 1,1,1 1,1,2",
                           "tri 1,2,3 5,2,1 0,9,0 ; tri -7,2,3 1,2,3 -3,1,3"}) {
    const TriangleMesh mesh = shapes::parse(text);
    const auto d = find(mesh, {0}, {1});
    ASSERT_TRUE(d) << text;
    EXPECT_TRUE(separates(mesh, *d, {0}, {1})) << text;
  }
  // Two halves of a fan around one vertex that no direction sees turn once, but a plane splits.
  const TriangleMesh mesh = shapes::parse("v 0,0,0 4,1,0 4,0,1 4,-1,0 4,0,-1 -4,1,0 -4,0,1 -4,-1,0 -4,0,-1 ; "
                                          "f 0,1,2 0,2,3 0,3,4 0,4,1 0,5,6 0,6,7 0,7,8 0,8,5");
  const auto d = find(mesh, range(0, 4), range(4, 8));
  ASSERT_TRUE(d);
  EXPECT_TRUE(separates(mesh, *d, range(0, 4), range(4, 8)));
}

TEST(SeparatorLaw, ThroughACommonVertexIsAlwaysExactlyRight) {
  long found = 0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(2000)); ++seed) {
    Random random(seed);
    const std::array<int, 3> plane{static_cast<int>(random.between(-5, 5)), static_cast<int>(random.between(-5, 5)), 7};
    const double unit = std::ldexp(1.0, static_cast<int>(random.between(-30, 30)));
    const auto c = [&] { return 2 * random.unit() - 1; };
    const double x = c(), y = c(), z = c();
    TriangleMesh mesh;
    mesh.positions = {{x, y, z}};
    const auto beside = [&](double side) {  // next to the plane through the common vertex, sometimes by ulps
      const double u = unit * c(), v = unit * c();
      const double w = -(plane[0] * u + plane[1] * v) / plane[2] + side * std::ldexp(unit, -static_cast<int>(random.below(60)));
      mesh.positions.push_back({x + u, y + v, z + w});
    };
    const auto n = static_cast<std::uint32_t>(1 + random.below(6));
    for (std::uint32_t i = 0; i < 4 * n; ++i) beside(i < 2 * n ? -1 : 1);
    for (std::uint32_t i = 0; i < 2 * n; ++i) mesh.faces.push_back({0, 1 + 2 * i, 2 + 2 * i});
    const auto d = find(mesh, range(0, n), range(n, 2 * n));
    found += d.has_value();
    ASSERT_TRUE(!d || separates(mesh, *d, range(0, n), range(n, 2 * n))) << "seed " << seed << ": " << text(mesh, d.value_or(IntVec3{}));
  }
  EXPECT_GT(found, scaled(200));
  EXPECT_LT(found, scaled(1900));
}

TEST(SeparatorLaw, IsAlwaysExactlyRightAndFoundOnWellSeparatedHulls) {
  long apart = 0, found = 0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(300)); ++seed) {
    Random random(seed);
    const auto soup = [&](int n, Vec3d at, double size) {
      TriangleMesh m;
      for (int i = 0; i < 3 * n; ++i) {
        const auto c = [&] { return size * (2 * random.unit() - 1); };
        const double x = c(), y = c(), z = c();
        m.positions.push_back({at.x + x, at.y + y, at.z + z});
      }
      for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(n); ++i) m.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
      return m;
    };
    const int n = static_cast<int>(4 + random.below(40));
    const Vec3d to{4 * random.unit() - 2, 4 * random.unit() - 2, 4 * random.unit() - 2};
    const TriangleMesh mesh = shapes::joined(soup(n, {0, 0, 0}, 1), soup(n, to, std::ldexp(1.0, -static_cast<int>(random.below(12)))));
    const Group a = range(0, static_cast<std::size_t>(n)), b = range(static_cast<std::size_t>(n), mesh.faces.size());
    const auto d = find(mesh, a, b);
    ASSERT_TRUE(!d || separates(mesh, *d, a, b)) << "seed " << seed << ": " << text(mesh, d.value_or(IntVec3{}));
    const bool well_apart = std::max({std::abs(to.x), std::abs(to.y), std::abs(to.z)}) >= 2.05;
    apart += well_apart;
    found += well_apart && d;
    const auto back = find(mesh, b, a);
    ASSERT_TRUE(!back || separates(mesh, *back, b, a)) << "seed " << seed;
  }
  EXPECT_EQ(found, apart);
}

TEST(SeparatorLaw, IsExactlyRightOnPointsOfEveryKind) {
  long found = 0;
  for (int kind = 0; kind < generate::kNumKinds; ++kind)
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(300)); ++seed) {
      Random random(seed * generate::kNumKinds + static_cast<std::uint64_t>(kind));
      TriangleMesh mesh;
      for (int i = 0; i < 2; ++i)
        for (const Vec3d& p : generate::points(static_cast<generate::Kind>(kind), random)) mesh.positions.push_back(p);
      mesh.faces = {{0, 1, 2}, {2, 3, 4}, {5, 6, 7}, {7, 8, 9}};
      if (const auto d = find(mesh, {0, 1}, {2, 3})) {
        ++found;
        ASSERT_TRUE(separates(mesh, *d, {0, 1}, {2, 3})) << generate::kKindNames[kind] << ", seed " << seed << ": " << text(mesh, *d);
      }
    }
  EXPECT_GT(found, scaled(100));
}

// Points that differ by few ulps, and a direction that proves something or does not: never something false.
TEST(SeparatorLaw, ProvesNothingFalseByAFewUlps) {
  long proved = 0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(20000)); ++seed) {
    Random random(seed);
    const auto component = [&] { return static_cast<std::int32_t>(random.between(-(1 << 30), 1 << 30)); };
    const std::int32_t x = component(), y = component(), z = component();
    const IntVec3 d{x, y, z};
    TriangleMesh mesh;
    const double px = 2 * random.unit() - 1, py = 2 * random.unit() - 1;
    for (int i = 0; i < 6; ++i) {  // near one plane across d
      const double qx = px + random.unit(), qy = py + random.unit();
      mesh.positions.push_back({qx, qy, -(x * qx + y * qy) / z + (i < 3 ? -1 : 1) * static_cast<double>(random.below(20)) * 0x1p-53});
    }
    mesh.faces = {{0, 1, 2}, {3, 4, 5}};
    SeparatorFinder finder(mesh, largest_coordinate(mesh));
    if (!finder.proves_apart(d, Group{0}, Group{1})) continue;
    ++proved;
    ASSERT_TRUE(separates(mesh, d, {0}, {1})) << "seed " << seed << ": " << text(mesh, d);
  }
  EXPECT_GT(proved, 0);
}

// A rounded sum that became infinite "proved" d.p < d.q for d.p > d.q.
TEST(SeparatorRegression, SumsThatOverflowByRoundingProveNothing) {
  const IntVec3 d{1073741824, 58948748, 1050318607};
  const TriangleMesh mesh = shapes::parse(
      "v -0x1.f7aafadc782a9p+992,-0x1.f7aafadc782aap+992,-0x1.f7aafadc782aap+992"
      " -0x1.f7aafadc782aap+992,-0x1.f7aafadc782aap+992,-0x1.f7aafadc782a9p+992 ; f 0,0,0 1,1,1");
  ASSERT_FALSE(separates(mesh, d, {0}, {1}));
  SeparatorFinder finder(mesh, largest_coordinate(mesh));
  EXPECT_FALSE(finder.proves_apart(d, Group{0}, Group{1}));
}

TEST(Separator, LargestCoordinateIsTheGreatestAbsoluteValue) {
  EXPECT_EQ(largest_coordinate(shapes::parse("v 1,-7,3 0,5,-6.5 100,100,-100 ; f 0,1,1")), 7);
}

}  // namespace
}  // namespace veritope
