// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/flat_cone.h"

#include <gtest/gtest.h>

#include "robust/base/random.h"
#include "solids/expression/directions.h"
#include "solids/expression/operand.h"
#include "solids/polyhedron/validity.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

constexpr std::uint64_t kSeedOfCones = 20261130;

Direction direction(int x, int y, int z) { return Direction({Dyadic(x), Dyadic(y), Dyadic(z)}); }
ExactPoint point(int x, int y, int z) { return {Rational(x), Rational(y), Rational(z)}; }
ExactPoint exact_place(const Vec3d& p) {
  return {Rational::from_double(p.x), Rational::from_double(p.y), Rational::from_double(p.z)};
}

FlatCone cone_at(const TriangleMesh& mesh, const ExactPoint& p) {
  const MeshClassifier c = std::move(MeshClassifier::make(mesh).value());
  return flat_cone(mesh, c.facets_at(p), p);
}

// Sectors in the order of their rims and the signs of their normals.
std::vector<std::size_t> rims(const FlatCone& cone) {
  std::vector<std::size_t> out;
  for (const Sector& s : cone) out.push_back(s.inward.size());
  return out;
}

TEST(FlatCone, HasAPlaneInAFacetAHalfPlaneOnAnEdgeAndASectorAtAVertex) {
  const TriangleMesh tet = shapes::parse("tet 0,0,0 1,0,0 0,1,0 0,0,1");
  EXPECT_EQ(rims(cone_at(tet, {Rational(Integer(1), Integer(3)), Rational(Integer(1), Integer(3)),
                               Rational(0)})),
            (std::vector<std::size_t>{0}));
  EXPECT_EQ(rims(cone_at(tet, {Rational(Integer(1), Integer(3)), Rational(0), Rational(0)})),
            (std::vector<std::size_t>{1, 1}));
  EXPECT_EQ(rims(cone_at(tet, point(0, 0, 0))), (std::vector<std::size_t>{2, 2, 2}));
  const FlatCone corner = cone_at(tet, point(0, 0, 0));
  EXPECT_TRUE(is_inside(corner, direction(1, 2, 3)));
  EXPECT_FALSE(is_inside(corner, direction(-1, 2, 3)));
  EXPECT_FALSE(
      is_inside(corner, direction(-1, -2, 0)));  // in the plane of a sector, and beyond its rims
  EXPECT_FALSE(is_inside(corner, direction(-1, -1, -1)));
}

// Every sector: rims and normals fit each other, and rays are the rims, in order.
void expect_consistent(const FlatCone& cone) {
  for (const Sector& s : cone) {
    ASSERT_GE(s.rays.size(), 2u);
    for (std::size_t k = 0; k + 1 < s.rays.size(); ++k) {
      EXPECT_TRUE(side(s.normal, s.rays[k]) == 0);
      EXPECT_TRUE(turn(s.normal, s.rays[k], s.rays[k + 1]) > 0);
      EXPECT_TRUE(s.holds(s.rays[k] + s.rays[k + 1]));
      EXPECT_TRUE(s.contains(s.rays[k]) && s.contains(s.rays[k + 1]));
    }
    for (const Direction& ray : {s.rays.front(), s.rays.back()})
      EXPECT_EQ(s.holds(ray), s.inward.empty());
  }
}

TEST(FlatCone, OfABoxIsThatOfItsMesh) {
  const ExactBox<3> box = {{ExactInterval{0, 2}, ExactInterval{0, 2}, ExactInterval{0, 2}}};
  const TriangleMesh mesh = shapes::box({0, 0, 0}, {2, 2, 2});
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 3; ++z) {
        if (x == 1 && y == 1 && z == 1) continue;
        const FlatCone of_box = flat_cone(box, point(x, y, z)),
                       of_mesh = cone_at(mesh, point(x, y, z));
        expect_consistent(of_box);
        expect_consistent(of_mesh);
        for (int i = -3; i <= 3; i += 2)
          for (int j = -3; j <= 3; j += 2)
            for (int k = -3; k <= 3; k += 2) {
              const auto inward = [](int at, int d) { return at == 1 || (at == 0) == (d > 0); };
              EXPECT_EQ(is_inside(of_box, direction(i, j, k)),
                        inward(x, i) && inward(y, j) && inward(z, k));
              EXPECT_EQ(is_inside(of_mesh, direction(i, j, k)),
                        is_inside(of_box, direction(i, j, k)));
            }
        // The symmetric difference of both is empty.
        const std::vector<TangentCone> both = {flat_tangent_cone(of_box),
                                               flat_tangent_cone(of_mesh)};
        EXPECT_EQ(common_value(both, [](const NearbyBits& b) { return b[0] != b[1]; }),
                  std::optional(false));
        EXPECT_EQ(common_value(both, [](const NearbyBits& b) { return b[0] || b[1]; }),
                  std::nullopt);
      }
}

// A point so near to p in this direction that no facet without p is between them: coordinates are small integers.
ExactPoint beside(const ExactPoint& p, const std::array<int, 3>& d) {
  ExactPoint out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = p[k] + Rational(d[k]) * Rational::power_of_two(-40);
  return out;
}

// Directions of a small lattice lie in planes of sectors and on lines through rims more often than not.
void expect_bits(const TriangleMesh& mesh, const ExactPoint& p, int size) {
  const MeshClassifier c = std::move(MeshClassifier::make(mesh).value());
  const FlatCone cone = flat_cone(mesh, c.facets_at(p), p);
  ASSERT_FALSE(cone.empty());
  expect_consistent(cone);
  for (int x = -size; x <= size; ++x)
    for (int y = -size; y <= size; ++y)
      for (int z = -size; z <= size; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        const Direction d = direction(x, y, z);
        const PointAnswer near = c.classify(beside(p, {x, y, z}));
        const bool is_along = std::any_of(cone.begin(), cone.end(), [&](const Sector& s) {
          return side(s.normal, d) == 0 && s.contains(d);
        });
        ASSERT_EQ(near.is_on(), is_along) << x << "," << y << "," << z << "\n"
                                          << shapes::to_text(mesh);
        if (is_along) continue;
        ASSERT_EQ(is_inside(cone, d), near.winding == 1) << x << "," << y << "," << z << "\n"
                                                         << shapes::to_text(mesh);
      }
}

TEST(FlatCone, KnowsTheSideOfDirectionsInPlanesOfItsSectors) {
  const TriangleMesh saddle = shapes::saddle();
  for (const Vec3d& p : saddle.positions) expect_bits(saddle, exact_place(p), 3);
  const TriangleMesh wave =
      shapes::polycube({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}});
  for (const Vec3d& p : wave.positions) expect_bits(wave, exact_place(p), 2);
}

// Valid vertices that are not convex, found among random tetrahedra around a common point.
TEST(FlatCone, AgreesWithTheClassifierNearRandomVertices) {
  Random random(kSeedOfCones);
  int num_found = 0;
  for (int i = 0; num_found < scaled(40); ++i) {
    TriangleMesh mesh = shapes::star_polyhedron(random, 0);
    for (Vec3d& p : mesh.positions) p = {std::round(p.x), std::round(p.y), std::round(p.z)};
    // Dents: one vertex is moved through the middle.
    Vec3d& dent = mesh.positions[random.below(mesh.positions.size())];
    dent = {-std::round(dent.x / 3), -std::round(dent.y / 3),
            static_cast<double>(random.below(3)) - 1};
    if (!decide_validity(mesh, {}).is_valid) continue;
    ++num_found;
    SCOPED_TRACE(testing::Message() << "seed " << kSeedOfCones << " mesh " << i);
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
      if (std::any_of(mesh.faces.begin(), mesh.faces.end(),
                      [v](const auto& f) { return f[0] == v || f[1] == v || f[2] == v; }))
        expect_bits(mesh, exact_place(mesh.positions[v]), 2);
  }
}

TEST(BoxOperand, HasExactValuesOfPointsAndBoxes) {
  const Rational third(Integer(1), Integer(3));
  const auto box =
      box_operand({{ExactInterval{third, 2}, ExactInterval{0, 1}, ExactInterval{0, 1}}});
  const double below = round_down(third), above = round_up(third);
  EXPECT_EQ(box->value(Vec3d{below, .5, .5}), Value3::kZero);
  EXPECT_EQ(box->value(Vec3d{above, .5, .5}), Value3::kOne);
  EXPECT_EQ(box->value(Vec3d{2, .5, .5}), Value3::kMixed);
  EXPECT_EQ(box->value(Vec3d{1, .5, 0}), Value3::kMixed);
  EXPECT_EQ(box->value(ExactPoint{third, Rational(0), Rational(0)}), Value3::kMixed);
  EXPECT_EQ(box->value(ExactPoint{third, Rational(-1), Rational(0)}), Value3::kZero);
  const auto of = [&](double x0, double x1) {
    return box->value(Box3d{{x0, .25, .25}, {x1, .5, .5}});
  };
  EXPECT_EQ(of(below, 1), Value3::kMixed);
  EXPECT_EQ(of(above, 1), Value3::kOne);
  EXPECT_EQ(of(1, 2), Value3::kMixed);  // touches from inside
  EXPECT_EQ(of(2, 3), Value3::kMixed);  // touches from outside
  EXPECT_EQ(of(2.5, 3), Value3::kZero);
  EXPECT_EQ(of(0, below), Value3::kZero);
  EXPECT_EQ(of(0, 9), Value3::kMixed);
  EXPECT_EQ(box->value(Box3d{{1, 0, .25}, {1.5, .5, .5}}), Value3::kMixed);
}

}  // namespace
}  // namespace veritope
