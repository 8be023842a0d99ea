// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/pair_codes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robust/binary64.h"
#include "robust/integer.h"
#include "tests/certify/pair_code_check.h"
#include "tests/predicates/point_generators.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

// Any doubles, as multiples of the least subnormal.
oracle::NamedTriangle<Integer> exact(const TriangleMesh& mesh, std::uint32_t f) {
  oracle::NamedTriangle<Integer> out;
  for (std::size_t i = 0; i < 3; ++i) {
    out.id[i] = mesh.faces[f][i];
    for (std::size_t k = 0; k < 3; ++k) {
      const Binary64 s = split(mesh.positions[out.id[i]][static_cast<int>(k)]);
      out.at[i][k] = Integer(s.mantissa).shift_left(static_cast<std::uint64_t>(s.exponent - kMinExponent));
    }
  }
  return out;
}

// The codes of the facets 0 and 1 are right, both ways round.
void expect_right(const TriangleMesh& mesh) {
  for (const auto& [f, g] : {std::pair{0u, 1u}, std::pair{1u, 0u}}) {
    const auto codes = find_pair_codes(mesh, f, g);
    std::span<const std::uint8_t> left(codes);
    ASSERT_FALSE(codes.empty()) << shapes::to_text(mesh);
    EXPECT_EQ(oracle::judge_codes(exact(mesh, f), exact(mesh, g), left), "") << shapes::to_text(mesh);
    EXPECT_TRUE(left.empty()) << shapes::to_text(mesh);
  }
}

TEST(PairCodes, OfFacetsOnOneSideOfAPlaneNameThatPlane) {
  using Codes = std::vector<std::uint8_t>;
  const auto codes = [](const char* text) { return find_pair_codes(shapes::parse(text), 0, 1); };
  EXPECT_EQ(codes("tri 0,0,0 4,0,0 0,4,0 ; tri 1,1,1 2,1,1 1,2,3"), Codes{0});
  EXPECT_EQ(codes("tri 0,0,0 4,0,0 0,4,0 ; tri 1,1,-1 2,1,-1 1,2,-3"), Codes{32});
  EXPECT_EQ(codes("tri 1,1,1 2,1,-1 9,2,3 ; tri 0,0,0 0,4,0 0,0,4"), Codes{1 | 32});
  EXPECT_EQ(codes("tri 0,0,0 4,0,0 0,4,0 ; tri 0,0,0 4,0,0 0,0,4"), Codes{0}) << "a common edge";
}

TEST(PairCodes, OfCoplanarAndTouchingFacetsAreRight) {
  for (const char* text : {"tri 0,0,0 4,0,0 0,4,0 ; tri 4,0,0 0,0,0 0,-4,0",            // a common edge, flat
                           "tri 0,0,0 4,0,0 0,4,0 ; tri 0,0,0 -4,0,0 0,-4,0",           // a common vertex, flat
                           "tri 0,0,0 4,0,0 0,4,0 ; tri 0,0,0 -4,0,0 -4,-4,0",          // edges on one line through it
                           "tri 0,0,0 4,0,0 0,4,0 ; tri 0,0,0 -4,0,0 4,-4,0",
                           "tri 0,0,0 4,0,0 0,4,0 ; tri 0,0,0 -4,0,4 0,-4,-4",          // passes through the other's plane
                           "tri 0,0,0 4,0,0 0,4,0 ; tri 5,0,0 9,0,0 9,1,0",             // on one line, apart
                           "tri 0,0,0 4,0,0 0,4,0 ; tri 3,3,-1 3,3,1 4,4,0"})           // beside it, through its plane
    expect_right(shapes::parse(text));
}

TEST(PairCodes, OfFacetsApartByTheLeastNumberAreRight) {
  for (const char* text : {"tri 0,0,0 4,0,0 0,4,0 ; tri 1,1,0x1p-1074 2,1,0x1p-1074 1,2,1", "tri 0,0,0 1e308,0,0 0,1e308,0 ; tri 1,1,5e-324 2,1,7 1,2,1e308",
                           "tri 0,0,0 4,0,0 0,4,0 ; tri 2,0x1.0000000000001p1,-1 2,0x1.0000000000001p1,1 9,9,0",
                           "tri -1e308,0,0 1e308,0,0 0,1e308,0 ; tri 0,-1e308,1e-300 1,1,1e308 5,1,1e-300"})
    expect_right(shapes::parse(text));
}

// PROVES MESH-4
TEST(PairCodesLaw, AreThereAndRightForEveryProperPairOfTheUnitCube) {
  const PairCodeTally all = expect_codes_on_grid(2, 2, 2, 1);
  EXPECT_EQ(all.pairs, 56 * 55);
  EXPECT_GT(all.proper, 2000);
}

TEST(PairCodesLaw, AreThereAndRightForEveryProperPairInAPlane) {
  expect_codes_on_grid(3, 3, 1, 1);
  expect_codes_on_grid(1, 4, 4, 0.3);
  expect_codes_on_grid(7, 1, 2, 1);
}

TEST(PairCodesLaw, AreThereAndRightForSamplesOfLargerGrids) {
  expect_codes_on_grid(3, 3, 2, 0.2);
  expect_codes_on_grid(3, 3, 3, 0.01 * static_cast<double>(scaled(1)));
  expect_codes_on_grid(2, 2, 6, 0.05);
}

TEST(PairCodesLaw, AreRightOnPointsOfEveryKind) {
  long proper = 0;
  for (int kind = 0; kind < generate::kNumKinds; ++kind)
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(120)); ++seed) {
      Random random(seed);
      const auto p = generate::points(static_cast<generate::Kind>(kind), random), q = generate::points(static_cast<generate::Kind>(kind), random);
      TriangleMesh mesh;
      for (const auto& points : {p, q})
        for (const Vec3d& x : points) mesh.positions.push_back({x.x + 0.0, x.y + 0.0, x.z + 0.0});
      const auto shared = static_cast<std::uint32_t>(random.below(3));
      mesh.faces = {{0, 1, 2}, {shared > 0 ? 0u : 3u, shared > 1 ? 1u : 4u, 5}};
      const auto t = [&](std::uint32_t f) {
        const auto& ids = mesh.faces[f];
        return IndexedTriangle{{mesh.positions[ids[0]], mesh.positions[ids[1]], mesh.positions[ids[2]]}, ids};
      };
      const auto flat = [&](std::uint32_t f) {
        const auto e = exact(mesh, f);
        return oracle::is_null(oracle::outer(oracle::difference(e.at[1], e.at[0]), oracle::difference(e.at[2], e.at[0])));
      };
      if (flat(0) || flat(1) || !is_proper(triangle_triangle(t(0), t(1)))) continue;
      ++proper;
      expect_right(mesh);
      if (HasFatalFailure()) return;
    }
  EXPECT_GT(proper, scaled(300));
}

// The oracle would notice: no code of the table is right for a pair that is not proper.
TEST(PairCodeOracle, AcceptsNoChainForImproperPairs) {
  GridTriangles grid(3, 3, 1);
  long improper = 0;
  for (std::size_t f = 0; f < grid.mesh.faces.size(); f += 3)
    for (std::size_t g = 0; g < grid.mesh.faces.size(); g += 5) {
      if (f == g || is_proper(triangle_triangle(grid.indexed(f), grid.indexed(g)))) continue;
      ++improper;
      for (int first = 0; first < 64; ++first)
        for (int second = 0; second < 64; ++second) {
          const std::uint8_t codes[2] = {static_cast<std::uint8_t>(first | 64), static_cast<std::uint8_t>(second)};
          std::span<const std::uint8_t> two(codes, 2), one(codes + 1, 1);
          ASSERT_NE(oracle::judge_codes(grid.named(f), grid.named(g), two), "") << grid.text(f) << " ; " << grid.text(g);
          ASSERT_NE(oracle::judge_codes(grid.named(f), grid.named(g), one), "") << grid.text(f) << " ; " << grid.text(g);
        }
    }
  EXPECT_GT(improper, 100);
}

}  // namespace
}  // namespace veritope
