// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/separating_axis.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robust/base/random.h"
#include "robust/binary64.h"
#include "robust/integer.h"
#include "robust/rational.h"
#include "tests/certify/pair_code_oracle.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

oracle::NamedTriangle<Integer> named(const TriangleMesh& mesh, std::uint32_t f) {
  oracle::NamedTriangle<Integer> out;
  for (std::size_t i = 0; i < 3; ++i) {
    out.id[i] = mesh.faces[f][i];
    for (std::size_t k = 0; k < 3; ++k) {
      const Binary64 s = split(mesh.positions[out.id[i]][static_cast<int>(k)]);
      out.at[i][k] =
          Integer(s.mantissa).shift_left(static_cast<std::uint64_t>(s.exponent - kMinExponent));
    }
  }
  return out;
}

// Whether there is a code; if so, that it holds.
bool has_right_code(const TriangleMesh& mesh) {
  const auto code = separating_axis(mesh, 0, 1);
  if (!code.has_value()) return false;
  std::span<const std::uint8_t> left(&*code, 1);
  EXPECT_EQ(oracle::judge_codes(named(mesh, 0), named(mesh, 1), left), "")
      << static_cast<int>(*code) << ": " << shapes::to_text(mesh);
  return true;
}

TriangleMesh two_facets(Random& random, double distance) {
  TriangleMesh out;
  for (std::size_t n = 0; n < 6; ++n)
    out.positions.push_back({2 * random.unit() - 1, 2 * random.unit() - 1,
                             distance * random.unit() + (n < 3 ? 0 : distance)});
  out.faces = {{0, 1, 2}, {3, 4, 5}};
  return out;
}
// The mesh turned by a random map with rounded entries; nearly parallel planes stay so.
TriangleMesh turned(TriangleMesh mesh, Random& random, int exponent) {
  double m[3][3];
  for (auto& row : m)
    for (double& x : row) x = 2 * random.unit() - 1;
  for (Vec3d& p : mesh.positions) {
    const double x = m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z,
                 y = m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z,
                 z = m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z;
    p = {std::ldexp(x, exponent), std::ldexp(y, exponent), std::ldexp(z, exponent)};
  }
  return mesh;
}

TEST(SeparatingAxis, NameTheFirstAxisThatSeparates) {
  const auto code = [](const char* text) { return separating_axis(shapes::parse(text), 0, 1); };
  EXPECT_EQ(code("tri 0,0,0 4,0,0 0,4,0 ; tri 1,1,1 2,1,1 1,2,3"), 0);
  EXPECT_EQ(code("tri 0,0,0 4,0,0 0,4,0 ; tri 1,1,-1 2,1,-1 1,2,-3"), 32);
  EXPECT_EQ(code("tri 1,1,1 2,1,-1 9,2,3 ; tri 0,0,0 0,4,0 0,0,4"), 1 | 32);
}
TEST(SeparatingAxis, AreMissingWhereFacetsTouchOrHaveACommonVertex) {
  const auto code = [](const char* text) { return separating_axis(shapes::parse(text), 0, 1); };
  EXPECT_EQ(code("tri 0,0,0 4,0,0 0,4,0 ; tri 0,0,0 4,0,0 0,0,4"), std::nullopt);
  EXPECT_EQ(code("tri 0,0,0 4,0,0 0,4,0 ; tri 1,1,0 9,9,4 9,9,-4"), std::nullopt) << "they cross";
  EXPECT_EQ(code("tri 0,0,0 4,0,0 0,4,0 ; tri 1,1,5e-324 2,1,7 1,2,8"), std::nullopt);
}
TEST(SeparatingAxis, AreMissingBeyondTheRangeOfTheirBound) {
  const TriangleMesh mesh = shapes::parse("tri 0,0,0 4,0,0 0,4,0 ; tri 1,1,1 2,1,1 1,2,3");
  for (const int exponent : {-160, 160, 1000}) {
    TriangleMesh far = mesh;
    for (Vec3d& p : far.positions)
      p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
    EXPECT_EQ(separating_axis(far, 0, 1), std::nullopt) << exponent;
  }
}

TEST(SeparatingAxisLaw, HoldForRandomFacets) {
  Random random(5);
  int found = 0;
  for (long n = 0; n < scaled(20000); ++n) {
    TriangleMesh mesh;
    for (int v = 0; v < 6; ++v)
      mesh.positions.push_back({random.unit() + (v < 3 ? 0 : 0.4), random.unit(), random.unit()});
    mesh.faces = {{0, 1, 2}, {3, 4, 5}};
    found += has_right_code(mesh) ? 1 : 0;
  }
  EXPECT_GT(found, scaled(20000) / 4);
}
TEST(SeparatingAxisLaw, HoldForFacetsThatAlmostTouch) {
  Random random(6);
  int found = 0, missing = 0;
  for (long n = 0; n < scaled(20000); ++n) {
    const double distance = std::ldexp(1.0, -static_cast<int>(random.between(35, 60)));
    const TriangleMesh mesh =
        turned(two_facets(random, distance), random, static_cast<int>(random.between(-140, 140)));
    ++(has_right_code(mesh) ? found : missing);
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(missing, 100);
}

// The derivation of docs/bounds/separating_axis.md with u = 2^-53 and size 1: the magnitude of a number, and its error.
struct Rounded {
  Rational size, error;
};
const Rational kRoundingUnit = Rational(1) / Rational(std::int64_t{1} << 53);
Rounded sum(const Rounded& a, const Rounded& b) {
  const Rational size = a.size + b.size, error = a.error + b.error;
  return {size, error + kRoundingUnit * (size + error)};
}
Rounded product(const Rounded& a, const Rounded& b) {
  const Rational size = a.size * b.size,
                 error = a.error * b.size + a.size * b.error + a.error * b.error;
  return {size, error + kRoundingUnit * (size + error)};
}
Rounded cross_of(const Rounded& a, const Rounded& b) { return sum(product(a, b), product(a, b)); }
Rational gap_error(const Rounded& axis, const Rounded& point) {
  const Rounded p = product(axis, point), dot = sum(sum(p, p), p), gap = sum(dot, dot);
  return gap.error;
}

TEST(SeparatingAxisBound, ConstantsFollowFromTheirDerivation) {
  const Rounded point{Rational(1), kRoundingUnit}, edge = sum(point, point),
                                                   normal = cross_of(edge, edge);
  const Rational square = gap_error(normal, point),
                 cubic = gap_error(cross_of(normal, edge), point);
  // The computed size and its powers: less than 12 roundings.
  const Rational slack = Rational(1) + Rational(12) * kRoundingUnit;
  EXPECT_LE(square * slack, Rational::from_double(internal::kAxisRel));
  EXPECT_LE(Rational::from_double(internal::kAxisRel), square * Rational(9) / Rational(8));
  EXPECT_LE(cubic * slack, Rational::from_double(internal::kAxisCubicRel));
  EXPECT_LE(Rational::from_double(internal::kAxisCubicRel), cubic * Rational(9) / Rational(8));
}

}  // namespace
}  // namespace veritope
