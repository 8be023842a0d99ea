// SPDX-License-Identifier: LGPL-3.0-or-later
// The values of boxes and the facets at points of solids/classify.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "solids/classify/facet_box_internal.h"
#include "solids/classify/mesh_classifier.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/exact_geometry.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

constexpr std::uint64_t kSeedOfBoxes = 20261129;

using oracle::RVec;

// Cuts the triangle by the six half-spaces of the box, in rationals.
bool meets_by_cuts(const std::array<Vec3d, 3>& t, const Box3d& box) {
  std::vector<RVec> polygon;
  for (const Vec3d& p : t) polygon.push_back(oracle::rational(p));
  for (std::size_t k = 0; k < 3; ++k)
    for (const int sign : {1, -1}) {
      RVec n, through;
      n[k] = Rational(sign);
      through[k] = Rational::from_double(sign == 1 ? box.lo[k] : box.hi[k]);
      polygon = oracle::cut(polygon, n, through);
    }
  return !polygon.empty();
}

std::string text(const Box3d& b) {
  char out[200];
  std::snprintf(out, sizeof out, "%a,%a,%a %a,%a,%a", b.lo[0], b.lo[1], b.lo[2], b.hi[0], b.hi[1],
                b.hi[2]);
  return out;
}

TEST(FacetMeets, TouchesCountAndNearMissesDoNot) {
  const std::array<Vec3d, 3> t = {Vec3d{0, 0, 0}, Vec3d{4, 0, 0}, Vec3d{0, 4, 0}};
  const double above = std::nextafter(0, 1);
  EXPECT_TRUE(internal::facet_meets(t, {{1, 1, 0}, {9, 9, 9}}));
  EXPECT_FALSE(internal::facet_meets(t, {{1, 1, above}, {9, 9, 9}}));
  EXPECT_TRUE(internal::facet_meets(t, {{2, 2, -1}, {9, 9, 9}}));  // in a point of an edge
  EXPECT_FALSE(internal::facet_meets(t, {{2, std::nextafter(2, 3), -1}, {9, 9, 9}}));
  EXPECT_TRUE(internal::facet_meets(t, {{-1, -1, -1}, {0, 0, 0}}));
  EXPECT_TRUE(internal::facet_meets(t, {{.5, .5, 0}, {.5, .5, 0}}));  // a point
  EXPECT_FALSE(internal::facet_meets(t, {{2.5, 2.5, 0}, {2.5, 2.5, 0}}));
  EXPECT_TRUE(internal::facet_meets(t, {{-9, -9, -9}, {9, 9, 9}}));
  // The edges of both are askew and close: no facet plane separates them.
  const std::array<Vec3d, 3> askew = {Vec3d{1, -1, 2}, Vec3d{3, 3, -1}, Vec3d{9, -9, 9}};
  for (const double x : {.5, 1.0, 1.4, 1.5, 1.6})
    EXPECT_EQ(internal::facet_meets(askew, {{-5, -5, -5}, {x, .5, .5}}),
              meets_by_cuts(askew, {{-5, -5, -5}, {x, .5, .5}}));
}

TEST(FacetMeets, AgreesWithCutsInRationals) {
  Random random(kSeedOfBoxes);
  for (int i = 0; i < scaled(20000); ++i) {
    const std::uint64_t grid = i % 3 == 0 ? 4 : 9;
    const auto at = [&] { return static_cast<double>(random.below(grid)) - (i % 5 == 0 ? .5 : 0); };
    std::array<Vec3d, 3> t{};
    for (Vec3d& p : t) p = {at(), at(), at()};
    Box3d box = empty_box();
    add({at() * .75, at() * .75, at() * .75}, &box);
    add({at() * .75, at() * .75, at() * .75}, &box);
    ASSERT_EQ(internal::facet_meets(t, box), meets_by_cuts(t, box))
        << "seed " << kSeedOfBoxes << " case " << i << " box " << text(box);
  }
}

MeshClassifier classifier_of(const TriangleMesh& mesh,
                             LookupDetail detail = LookupDetail::kForPoints) {
  return std::move(MeshClassifier::make(mesh, nullptr, detail).value());
}

// REQUIRES a box of the classifier's model, or one in reach of it.
void expect_near(const MeshClassifier& c, const TriangleMesh& mesh, const Box3d& box) {
  const std::vector<std::uint32_t> near = c.facets_near(box);
  ASSERT_TRUE(std::adjacent_find(near.begin(), near.end(), std::greater_equal<>()) == near.end())
      << text(box);
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& t = mesh.faces[f];
    const std::array<Vec3d, 3> corners = {mesh.positions[t[0]], mesh.positions[t[1]],
                                          mesh.positions[t[2]]};
    Box3d around = empty_box();
    for (const Vec3d& p : corners) add(to_point(p), &around);
    const bool is_near = std::binary_search(near.begin(), near.end(), f);
    if (is_near) {
      ASSERT_TRUE(meets(around, box)) << text(box) << " facet " << f;
    } else {
      ASSERT_FALSE(meets_by_cuts(corners, box)) << text(box) << " facet " << f;
    }
  }
}

void expect_values(const TriangleMesh& mesh, std::uint64_t seed, int num, double scale) {
  Random random(seed);
  const MeshClassifier c = classifier_of(mesh), d = classifier_of(mesh, LookupDetail::kForBoxes);
  int counts[3] = {0, 0, 0};
  for (int i = 0; i < num; ++i) {
    Box3d box = empty_box();
    Vec3d p = mesh.positions[random.below(mesh.positions.size())];
    if (i % 2 != 0)
      p = {c.box().lo[0] + random.unit() * (c.box().hi[0] - c.box().lo[0]),
           c.box().lo[1] + random.unit() * (c.box().hi[1] - c.box().lo[1]),
           c.box().lo[2] + random.unit() * (c.box().hi[2] - c.box().lo[2])};
    const double size = scale * random.unit() * random.unit();
    const auto away = [&] { return (random.unit() - .5) * size; };
    add({p.x, p.y, p.z}, &box);
    add({p.x + away(), p.y + away(), p.z + away()}, &box);
    if (i % 4 == 0)  // beside the vertex
      for (std::size_t k = 0; k < 3; ++k) box.lo[k] += size / 3, box.hi[k] += size / 3;
    bool meets_any = false;
    for (const auto& t : mesh.faces)
      meets_any |=
          meets_by_cuts({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]}, box);
    const Value3 value = c.value(box);
    ++counts[static_cast<std::size_t>(value)];
    ASSERT_EQ(value, d.value(box)) << "seed " << seed << " box " << text(box);
    ASSERT_EQ(c.classify(p), d.classify(p)) << "seed " << seed << " box " << text(box);
    expect_near(c, mesh, box);
    expect_near(d, mesh, box);
    ASSERT_EQ(is_constant(value), !meets_any) << "seed " << seed << " box " << text(box);
    if (meets_any) continue;
    ASSERT_EQ(value, to_value(c.classify(Vec3d{box.hi[0], box.hi[1], box.hi[2]}).winding != 0))
        << text(box);
  }
  for (const int n : counts) EXPECT_GT(n, 0);
}

TEST(MeshClassifierValue, IsConstantExactlyIfNoFacetMeetsTheBox) {
  Random random(kSeedOfBoxes + 1);
  expect_values(shapes::torus(12, 8, 3, 1), 1, static_cast<int>(scaled(150)), 3);
  expect_values(shapes::star_polyhedron(random, 2), 2, static_cast<int>(scaled(150)), 4);
  expect_values(shapes::random_polycube(random, 3, 9), 3, static_cast<int>(scaled(200)), 3);
}

TEST(MeshClassifierValue, KnowsBoxesOutsideAndAroundTheMesh) {
  const TriangleMesh mesh = shapes::box({0, 0, 0}, {1, 1, 1}, 4);
  const MeshClassifier c = std::move(MeshClassifier::make(mesh).value());
  EXPECT_EQ(c.value(Box3d{{2, 0, 0}, {3, 1, 1}}), Value3::kZero);
  EXPECT_EQ(c.value(Box3d{{-1e300, -1e300, -1e300}, {1e300, 1e300, 1e300}}), Value3::kMixed);
  EXPECT_EQ(c.value(Box3d{{1, 1, 1}, {1, 1, 1}}), Value3::kMixed);  // a corner, as a box
  EXPECT_EQ(c.value(Box3d{{.25, .25, .25}, {.75, .75, .75}}), Value3::kOne);
  EXPECT_EQ(c.value(Box3d{{.25, .25, 0}, {.75, .75, .5}}), Value3::kMixed);  // touches a side
  // Too far away for an octree: all facets are tested.
  const TriangleMesh far = shapes::moved(shapes::box({0, 0, 0}, {8, 8, 8}), {0x1p52, 0, 0});
  const MeshClassifier d = std::move(MeshClassifier::make(far).value());
  EXPECT_EQ(d.value(Box3d{{0x1p52 + 2, 2, 2}, {0x1p52 + 3, 3, 3}}), Value3::kOne);
  EXPECT_EQ(d.value(Box3d{{0x1p52 + 2, 2, 2}, {0x1p52 + 9, 3, 3}}), Value3::kMixed);
  EXPECT_EQ(d.facets_at(Vec3d{0x1p52, 1, 2}).size(), 1u);
}

TEST(MeshClassifierFacets, NearABoxAreFoundWithoutAnOctreeToo) {
  const TriangleMesh far = shapes::moved(shapes::box({0, 0, 0}, {8, 8, 8}), {0x1p52, 0, 0});
  for (const LookupDetail detail : {LookupDetail::kForPoints, LookupDetail::kForBoxes}) {
    const MeshClassifier c = classifier_of(far, detail);
    expect_near(c, far, {{0x1p52 + 2, 2, 2}, {0x1p52 + 9, 3, 3}});
    EXPECT_TRUE(c.facets_near({{0, 0, 0}, {1, 1, 1}}).empty());
  }
}

TEST(MeshClassifierFacets, AreAllThatContainThePoint) {
  const TriangleMesh mesh = shapes::bipyramid(7);
  const MeshClassifier c = std::move(MeshClassifier::make(mesh).value());
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    std::vector<std::uint32_t> want;
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
      if (mesh.faces[f][0] == v || mesh.faces[f][1] == v || mesh.faces[f][2] == v)
        want.push_back(f);
    const Vec3d& p = mesh.positions[v];
    EXPECT_EQ(c.facets_at(p), want);
    EXPECT_EQ(c.facets_at(ExactPoint{Rational::from_double(p.x), Rational::from_double(p.y),
                                     Rational::from_double(p.z)}),
              want);
  }
  // The centre of a facet, which binary64 does not have.
  const auto& t = mesh.faces[3];
  ExactPoint middle;
  for (const std::uint32_t v : t)
    for (std::size_t k = 0; k < 3; ++k)
      middle[k] += Rational::from_double(mesh.positions[v][static_cast<int>(k)]) / Rational(3);
  EXPECT_EQ(c.facets_at(middle), std::vector<std::uint32_t>{3});
  EXPECT_TRUE(c.facets_at(Vec3d{0, 0, 0}).empty());
  EXPECT_TRUE(c.facets_at(Vec3d{99, 0, 0}).empty());
}

}  // namespace
}  // namespace veritope
