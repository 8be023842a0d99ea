// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/box_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "solids/polyhedron/box_tree.h"
#include "tests/predicates/point_generators.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

std::vector<std::uint32_t> all_facets(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> out(mesh.faces.size());
  std::iota(out.begin(), out.end(), 0u);
  return out;
}

bool is_permutation_of(std::vector<std::uint32_t> order, std::vector<std::uint32_t> facets) {
  std::sort(order.begin(), order.end());
  std::sort(facets.begin(), facets.end());
  return order == facets;
}

// PROVES MESH-10
void expect_monotone(const std::vector<Vec3d>& positions) {
  const UnitScale scale(bounding_box(positions, 1));
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const Vec3d& p : positions) values.push_back(p[axis]);
    std::sort(values.begin(), values.end());
    float last = 0;
    for (double v : values) {
      const float u = axis == 0 ? scale.x(v) : (axis == 1 ? scale.y(v) : scale.z(v));
      ASSERT_GE(u, last) << "axis " << axis << ", " << v;
      ASSERT_LE(u, 1.0f) << "axis " << axis << ", " << v;
      last = u;
    }
  }
}

TEST(UnitScale, IsMonotoneIntoTheUnitInterval) {
  constexpr double kMax = 0x1.fffffffffffffp1023, kTiny = 5e-324;
  for (const std::vector<Vec3d>& positions : std::vector<std::vector<Vec3d>>{
           {{0, 0, 0}, {1, 2, 3}, {0.5, 0.25, 1e-9}},
           {{1e308, 1e308, 1e308}, {-1e308, 5, 5e-324}},
           {{kMax, -kMax, kMax}, {-kMax, kMax, kMax}, {0, 0, 0}, {kTiny, 1, -1}},
           {{kTiny, 0, -kTiny}, {0, 0, 0}, {2 * kTiny, 3 * kTiny, 0}},
           {{7, 7, 7}, {7, 7, 7}},
           {{kMax, kMax, kMax}},
           {{kTiny, kTiny, kTiny}},
           {{0, 0, 0}},
           {{1, 0, 0}, {1, kTiny, 0}, {1, 2 * kTiny, 0}},
           {{0x1p-900, 0, 0}, {0x1p-901, kTiny, 0}},
           {{0x1p1000, 0, 0}, {0x1.8p1000, kTiny, 1}},
           {{1e300, 1e-300, 0}, {1e300, 2e-300, 0}, {1.0000000001e300, 1e-300, 1e300}}})
    expect_monotone(positions);
}

TEST(UnitScale, IsMonotoneOnPointsOfEveryKind) {
  for (int kind = 0; kind < generate::kNumKinds; ++kind)
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(50)); ++seed) {
      Random random(seed);
      std::vector<Vec3d> positions;
      for (int i = 0; i < 20; ++i)
        for (const Vec3d& p : generate::points(static_cast<generate::Kind>(kind), random)) positions.push_back(p);
      SCOPED_TRACE(std::string(generate::kKindNames[kind]) + ", seed " + std::to_string(seed));
      expect_monotone(positions);
      if (HasFatalFailure()) return;
    }
}

TEST(UnitScale, UsesTheInterval) {
  const UnitScale scale(Box3d{{-3, 0, 10}, {5, 1, 10}});
  EXPECT_EQ(scale.x(-3), 0.0f);
  EXPECT_GE(scale.x(5), 0.5f);
  EXPECT_EQ(scale.y(0), 0.0f);
  EXPECT_EQ(scale.z(10), 0.0f);
}

TEST(BoundingBox, IsTheLeastBoxForEveryNumberOfJobs) {
  Random random(1);
  std::vector<Vec3d> points;
  for (int i = 0; i < 40000; ++i) {
    const double x = random.unit(), y = random.unit(), z = random.unit();
    points.push_back({x, y, z});
  }
  points[20000] = {-1, 2, 0.5};
  points[39999] = {0.5, 0.5, 7};
  for (unsigned jobs : {1u, 2u, 5u}) {
    const Box3d box = bounding_box(points, jobs);
    EXPECT_EQ(box.lo[0], -1);
    EXPECT_EQ(box.hi[1], 2);
    EXPECT_EQ(box.hi[2], 7);
  }
  EXPECT_EQ(bounding_box({}, 1), empty_box());
}

TEST(MortonOrder, IsAPermutationThatDoesNotDependOnJobs) {
  Random random(2);
  for (const TriangleMesh& mesh :
       {shapes::grid_soup(random, 40000, 50), shapes::needle_soup(random, 500), shapes::torus(40, 30, 3, 1),
        shapes::scaled(shapes::torus(10, 10, 3, 1), 1020), shapes::scaled(shapes::torus(10, 10, 3, 1), -1060)}) {
    const UnitScale scale(bounding_box(mesh.positions, 1));
    const auto one = morton_order(mesh, all_facets(mesh), scale, 1);
    EXPECT_TRUE(is_permutation_of(one, all_facets(mesh)));
    for (unsigned jobs : {0u, 2u, 3u, 7u}) EXPECT_EQ(one, morton_order(mesh, all_facets(mesh), scale, jobs));
  }
}

TEST(MortonOrder, OrdersSomeOfTheFacetsOnly) {
  const TriangleMesh mesh = shapes::torus(10, 10, 3, 1);
  const std::vector<std::uint32_t> some{3, 5, 8, 13, 21, 34, 55, 89, 144};
  EXPECT_TRUE(is_permutation_of(morton_order(mesh, some, UnitScale(bounding_box(mesh.positions, 1)), 2), some));
  EXPECT_TRUE(is_permutation_of(median_order(mesh, some, 1), some));
  EXPECT_TRUE(morton_order(mesh, {}, UnitScale(bounding_box(mesh.positions, 1)), 1).empty());
  EXPECT_TRUE(median_order(mesh, {}, 1).empty());
}

TEST(MortonOrder, FollowsALine) {
  for (int axis = 0; axis < 3; ++axis) {
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < 100; ++i) {
      for (int k = 0; k < 3; ++k) {
        std::array<double, 3> p{};
        p[static_cast<std::size_t>(axis)] = 100.0 - i;
        p[static_cast<std::size_t>((axis + 1) % 3)] = 0.01 * k;
        mesh.positions.push_back({p[0], p[1], p[2]});
      }
      mesh.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    auto backwards = all_facets(mesh);
    std::reverse(backwards.begin(), backwards.end());
    EXPECT_EQ(morton_order(mesh, all_facets(mesh), UnitScale(bounding_box(mesh.positions, 1)), 1), backwards) << axis;
    EXPECT_EQ(median_order(mesh, all_facets(mesh), 1), backwards) << axis;
  }
}

TEST(MortonOrder, KeepsEqualFacetsInTheirOrder) {
  TriangleMesh mesh = shapes::parse("tri 0,0,0 1,0,0 0,1,0");
  mesh.faces.resize(1000, mesh.faces[0]);
  EXPECT_EQ(morton_order(mesh, all_facets(mesh), UnitScale(bounding_box(mesh.positions, 1)), 3), all_facets(mesh));
}

// Each node of the certificate's tree is halved at a median along its longest axis.
TEST(MedianOrder, HalvesEveryNodeAlongItsLongestAxis) {
  Random random(4);
  const TriangleMesh mesh = shapes::needle_soup(random, 300);
  const auto order = median_order(mesh, all_facets(mesh), 1);
  ASSERT_TRUE(is_permutation_of(order, all_facets(mesh)));
  const auto centre = [&](std::uint32_t f, int axis) {
    const auto& t = mesh.faces[f];
    return mesh.positions[t[0]][axis] + mesh.positions[t[1]][axis] + mesh.positions[t[2]][axis];
  };
  const auto extent = [&](std::size_t lo, std::size_t hi, int axis) {
    double least = centre(order[lo], axis), most = least;
    for (std::size_t i = lo; i < hi; ++i) {
      least = std::min(least, centre(order[i], axis));
      most = std::max(most, centre(order[i], axis));
    }
    return std::pair{least, most};
  };
  const auto check = [&](auto&& self, std::size_t lo, std::size_t hi) -> void {
    if (hi - lo < 2) return;
    int longest = 0;
    std::array<double, 3> length{};
    for (int k = 0; k < 3; ++k) {
      const auto [least, most] = extent(lo, hi, k);
      length[static_cast<std::size_t>(k)] = most - least;
      if (length[static_cast<std::size_t>(k)] > length[static_cast<std::size_t>(longest)]) longest = k;
    }
    const std::size_t mid = lo + (hi - lo) / 2;
    EXPECT_LE(extent(lo, mid, longest).second, extent(mid, hi, longest).first) << lo << ".." << hi;
    self(self, lo, mid);
    self(self, mid, hi);
  };
  check(check, 0, order.size());
}

// Positions of the facets of a large fan are consecutive in the order, up to the halves of the tree.
TEST(MedianOrder, KeepsLargeFansTogether) {
  const int sides = 300;
  const TriangleMesh mesh = shapes::prism(sides, 1000, 1);  // two fans of sides - 2 facets
  const auto order = median_order(mesh, all_facets(mesh), 1);
  ASSERT_TRUE(is_permutation_of(order, all_facets(mesh)));
  std::map<std::uint32_t, std::pair<std::size_t, std::size_t>> range;  // of the positions, by the height of a cap
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto& t = mesh.faces[order[i]];
    const double z[3] = {mesh.positions[t[0]].z, mesh.positions[t[1]].z, mesh.positions[t[2]].z};
    if (z[0] != z[1] || z[1] != z[2]) continue;
    auto [it, is_new] = range.try_emplace(z[0] > 0, i, i);
    it->second.second = i;
  }
  ASSERT_EQ(range.size(), 2u);
  for (const auto& [side, positions] : range) EXPECT_LE(positions.second - positions.first, static_cast<std::size_t>(sides) + 4) << side;
}

// Parts so far from each other that single precision sees points.
TEST(MedianOrder, KeepsTheOrderInsidePartsThatAreFarFromEachOther) {
  Random random(6);
  const TriangleMesh part = shapes::relabelled(shapes::torus(30, 20, 3, 1), random);
  for (double far : {1e9, 1e12, -1e12}) {
    const TriangleMesh mesh = shapes::joined(part, shapes::box({far, far, far}, {far * 1.5, far * 1.5, far * 1.5}));
    const BoxTree tree(mesh, median_order(mesh, all_facets(mesh), 1), {std::vector<std::uint8_t>(mesh.positions.size()), {}}, 1);
    struct Counter {
      std::uint64_t leaves = 0;
      bool stop() const { return false; }
      bool node_pair(const TreeRange&, const TreeRange&, std::uint64_t) { return false; }
      void leaf_pair(std::uint32_t, std::uint32_t) { ++leaves; }
    } counter;
    EXPECT_LT(tree.walk({tree.root(), tree.root()}, counter), 60 * mesh.faces.size()) << far;
  }
}

TEST(BoundingBox, OfFacesLeavesOutStrayVertices) {
  const TriangleMesh mesh = shapes::parse("v -9,0,0 1,2,3 4,0,0 0,5,0 7,7,7 ; f 1,2,3");
  EXPECT_EQ(bounding_box_of_faces(mesh, 2).lo, (Point3d{0, 0, 0}));
  EXPECT_EQ(bounding_box_of_faces(mesh, 2).hi, (Point3d{4, 5, 3}));
}

}  // namespace
}  // namespace veritope
