// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/approx_overlap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/report_text.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

using Corners = std::array<Vec3d, 3>;

TEST(ApproxOverlap, OfKnownTriangles) {
  const Corners floor = {Vec3d{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const std::vector<std::pair<Corners, double>> cases = {
      {{Vec3d{1, 1, -1}, {1, 1, 1}, {2, 1, 1}}, 0.5},                 // crosses
      {{Vec3d{1, 1, 0}, {1, 1, 1}, {2, 1, 1}}, 0},                    // touches with a corner
      {{Vec3d{1, 1, 0}, {2, 1, 0}, {1, 1, 1}}, 1},                    // stands on it
      {{Vec3d{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}, std::sqrt(2.0)},       // lies in it
      {{Vec3d{0, 0, 0}, {4, 0, 0}, {1, 1, 0}}, 4},                    // folded over a common edge
      {{Vec3d{-1, -1, 0}, {9, -1, 0}, {-1, 9, 0}}, std::sqrt(32.0)},  // covers it
      {{Vec3d{0, 0, 0}, {3, 3, 1}, {3, 3, -1}}, std::sqrt(8.0)}};     // a common corner and more
  for (const auto& [u, want] : cases) {
    EXPECT_NEAR(approx_common_extent(floor, u), want, 1e-12);
    EXPECT_NEAR(approx_common_extent(u, floor), want, 1e-12);
  }
}

// Relative error at most 1e-9 where planes cross, on grids and on random triangles; the same after scaling.
TEST(ApproxOverlapLaw, IsNearTheExactExtentAndScalesWithTheModel) {
  int num_tested = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    for (const TriangleMesh& mesh :
         {shapes::grid_soup(random, 12, 5), shapes::needle_soup(random, 10)}) {
      const auto corners = [&](std::uint32_t f) {
        const auto& t = mesh.faces[f];
        return Corners{mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
      };
      for (const Finding& d : decide_and_list(mesh, {1, 1000}).defects) {
        if (rule_of(d) != MeshRule::kM7) continue;
        const Corners t = corners(d.place.faces[0]), u = corners(d.place.faces[1]);
        const double got = approx_common_extent(t, u);
        EXPECT_NEAR(got, d.place.size, 1e-9 * (1 + d.place.size)) << "seed " << seed;
        for (const int exponent : {-900, -300, 300, 900}) {
          const auto moved = [&](Corners c) {
            for (Vec3d& p : c)
              p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
            return c;
          };
          EXPECT_EQ(approx_common_extent(moved(t), moved(u)), std::ldexp(got, exponent))
              << "seed " << seed;
        }
        ++num_tested;
      }
    }
  }
  EXPECT_GT(num_tested, 1000);
}

TEST(ApproxOverlap, SegmentsAreThoseOfCrossingTriangles) {
  const Corners floor = {Vec3d{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const auto crossing = approx_common_segment(floor, {Vec3d{1, 1, -1}, {1, 1, 1}, {2, 1, 1}});
  ASSERT_TRUE(crossing.has_value());
  const auto [a, b] = *crossing;
  EXPECT_NEAR(std::min(a.x, b.x), 1, 1e-12);
  EXPECT_NEAR(std::max(a.x, b.x), 1.5, 1e-12);
  for (const Vec3d& p : *crossing) EXPECT_NEAR(std::hypot(p.y - 1, p.z), 0, 1e-12);
  EXPECT_FALSE(approx_common_segment(floor, {Vec3d{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}));   // one plane
  EXPECT_FALSE(approx_common_segment(floor, {Vec3d{1, 1, 1}, {1, 1, 2}, {2, 1, 1}}));   // above
  EXPECT_FALSE(approx_common_segment(floor, {Vec3d{9, 9, -1}, {9, 9, 1}, {8, 9, 1}}));  // beside
  EXPECT_FALSE(
      approx_common_segment(floor, {Vec3d{1, 1, 0}, {1, 1, 1}, {2, 1, 1}}));  // touches in a point
}

TEST(ApproxOverlap, IsANumberForEverything) {
  constexpr double kMost = 1.7976931348623157e308, kLeast = 5e-324;
  const std::vector<double> values = {0, kLeast, -kLeast, 1, 1 + 0x1p-52, kMost, -kMost};
  Random random(7);
  for (int i = 0; i < 20000; ++i) {
    Corners t, u;
    for (Corners* const c : {&t, &u})
      for (Vec3d& p : *c) {
        const auto any = [&] { return values[random.below(values.size())]; };
        p = {any(), any(), any()};
      }
    EXPECT_GE(approx_common_extent(t, u), 0) << "case " << i << " of seed 7";
  }
}

// The largest come first; the list for fewer is the beginning of the list for more, and so the certificate's witness, which is the first,
// does not depend on the number.
TEST(ApproxOverlap, OrdersTheListOfIntersections) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    TriangleMesh mesh = shapes::grid_soup(random, 25, 4);
    mesh.faces.push_back(mesh.faces.front());  // a copy: listed last
    const auto pairs = [&](std::size_t most) {
      std::vector<std::pair<std::vector<std::uint32_t>, double>> out;
      for (const Finding& d : decide_and_list(mesh, {1, most}).defects)
        if (rule_of(d) == MeshRule::kM7) out.push_back({d.place.faces, d.place.size});
      return out;
    };
    const auto all = pairs(100000);
    for (const std::size_t most : {1u, 2u, 7u, 20u}) {
      const auto some = pairs(most);
      ASSERT_EQ(some.size(), std::min(most, all.size())) << "seed " << seed;
      EXPECT_TRUE(std::equal(some.begin(), some.end(), all.begin())) << "seed " << seed;
    }
    const auto is_of_copies = [&](const auto& p) {
      auto f = mesh.faces[p.first[0]], g = mesh.faces[p.first[1]];
      std::sort(f.begin(), f.end()), std::sort(g.begin(), g.end());
      return f == g;
    };
    const auto copies = std::find_if(all.begin(), all.end(), is_of_copies);
    EXPECT_NE(copies, all.end()) << "seed " << seed;
    EXPECT_TRUE(std::all_of(copies, all.end(), is_of_copies)) << "seed " << seed;
    EXPECT_TRUE(std::is_sorted(
        all.begin(), copies,
        [](const auto& a, const auto& b) { return a.second > b.second * (1 + 1e-9); }))
        << "seed " << seed;
  }
}

}  // namespace
}  // namespace veritope
