// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_region_test.cc: which knots planes part from a tetrahedron or a triangle, and the proofs that are
// made of it: hulls, leaves and tiles.
#include "solids/dms/dms_region.h"

#include <gtest/gtest.h>

#include "solids/dms/dms_hulls.h"
#include "solids/dms/dms_jacobian.h"
#include "solids/dms/dms_monotone.h"
#include "solids/dms/dms_tiles.h"
#include "tests/support/dms_laws.h"
#include "tests/support/random_dms.h"

namespace veritope {
namespace {

Rational part(long p, long q) { return Rational(p) / Rational(q); }

// One tetrahedron; the cloud of its first corner has these knots, too.
DmsModel one_tetrahedron(std::vector<DmsPoint> more) {
  DmsModel model;
  model.degree = static_cast<int>(more.size()) + 1;
  model.clouds = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
  for (DmsPoint& p : more) model.clouds[0].push_back(std::move(p));
  model.tetrahedra = {{0, 1, 2, 3}};
  set_control_by_rule(model, DmsControlRule::kGreville, {});
  return model;
}
TetrahedralComplex complex_of(const DmsModel& model) {
  return {model.tetrahedra, static_cast<std::uint32_t>(model.clouds.size())};
}
DmsModel warped(DmsModel model, const Rational& by) {
  for (std::size_t i = 0; i < model.num_control(); ++i) {
    const std::size_t at = i * model.num_components();
    const Rational y = model.control.values[at + 1];
    model.control.values[at] += by * y * y;
  }
  return model;
}
DmsModel block(int degree, std::array<int, 3> size, std::optional<Rational> radius) {
  DmsModel domain = kuhn_domain(size);
  set_control_by_rule(domain, DmsControlRule::kGreville, {});
  DmsMakeOptions options;
  options.degree = degree;
  if (radius) options.clouds = DmsCloudDraw{*radius, 7};
  return *make_dms(domain, options);
}

TEST(DmsRegion, IsPartedFromWhatLiesBehindAPlane) {
  const DmsModel model = one_tetrahedron({{-1, -1, -1}});
  const DmsKnotTable knots(model);
  const std::array<DmsPoint, 4> corners = knots.corners(0);
  const std::uint32_t outside = knots.number(0, 1), corner = knots.number(1, 0);
  DmsRegion region(knots, {corners.begin(), corners.end()}, face_planes(corners));
  EXPECT_TRUE(region.misses(std::array{outside}));
  EXPECT_TRUE(region.misses(std::array{corner})) << "a corner is in a face's plane";
  EXPECT_FALSE(region.misses(std::array{outside, corner, knots.number(2, 0), knots.number(3, 0)}));
  // Beyond the face of the other three corners, whose plane is across no axis.
  const std::vector<DmsPoint> far{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  DmsRegion other(knots, far, {});
  const std::array three{corner, knots.number(2, 0), knots.number(3, 0)};
  EXPECT_FALSE(other.misses(three));
  DmsRegion with_plane(knots, far, {{{1, 1, 1}, 1}});
  EXPECT_TRUE(with_plane.misses(three));
  DmsRegion with_reversed(knots, far, {{{-1, -1, -1}, -1}});
  EXPECT_TRUE(with_reversed.misses(three));
  DmsRegion with_cutting(knots, far, {{{1, 1, 1}, 2}});
  EXPECT_FALSE(with_cutting.misses(three)) << "the plane cuts the region";
}

TEST(DmsRegion, IsNeverPartedFromAKnotInside) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed);
    std::array<Rational, 4> shares;
    Rational sum;
    for (Rational& s : shares) sum += s = Rational(random.between(1, 9));
    const DmsPoint inside{shares[1] / sum, shares[2] / sum, shares[3] / sum};
    const DmsModel model = one_tetrahedron({inside});
    const DmsKnotTable knots(model);
    const std::array<DmsPoint, 4> corners = knots.corners(0);
    std::vector<DmsPlane> planes = face_planes(corners);
    for (int i = 0; i < 40; ++i) {
      DmsPlane plane;
      for (Rational& x : plane.vector) x = Rational(random.between(-3, 3));
      plane.number =
          random.below(2) == 0 ? dot_product(plane.vector, inside) : part(random.between(-9, 9), 4);
      planes.push_back(std::move(plane));
    }
    DmsRegion region(knots, {corners.begin(), corners.end()}, planes);
    EXPECT_FALSE(region.misses(std::array{knots.number(0, 1)})) << seed;
    EXPECT_TRUE(region.find_cut(region.supports())) << seed;
  }
}

TEST(DmsRegion, CountsOnlyKnotsInItsPlaneForATriangle) {
  // All knots are on one side of the face z = 0, and those in its plane are its corners.
  const DmsModel model = one_tetrahedron({{0, 0, part(1, 2)}});
  const DmsKnotTable knots(model);
  const std::vector<DmsPoint> face{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}};
  DmsRegion region(knots, face, upright_planes(face));
  EXPECT_FALSE(region.find_cut(region.supports()));
  EXPECT_TRUE(region.misses(std::array{knots.number(0, 1)})) << "no knot is in the plane";
  EXPECT_FALSE(
      region.misses(std::array{knots.number(0, 0), knots.number(1, 0), knots.number(2, 0)}));
  // A knot below the face's plane, above its inside, cuts it.
  const DmsModel outward = one_tetrahedron({{part(-1, 4), part(-1, 8), part(-1, 4)}});
  const DmsKnotTable others(outward);
  DmsRegion crossed(others, face, upright_planes(face));
  EXPECT_EQ(crossed.find_cut(crossed.supports()).has_value(),
            !crossed.find_cuts(crossed.supports()).empty());
}

TEST(DmsPlanes, HaveTheCornersOnOneSide) {
  const std::array<DmsPoint, 4> corners{DmsPoint{0, 0, 0}, DmsPoint{1, 0, 0}, DmsPoint{0, 1, 0},
                                        DmsPoint{0, 0, 1}};
  for (const DmsPlane& plane : face_planes(corners)) EXPECT_NE(side_of_plane(corners, plane), 0);
  for (const DmsPlane& plane : upright_planes(std::span(corners).first(3)))
    EXPECT_NE(side_of_plane(std::span(corners).first(3), plane), 0);
  EXPECT_EQ(side_of_plane(corners, {{1, 0, 0}, 0}), 1);
  EXPECT_EQ(side_of_plane(corners, {{1, 0, 0}, 1}), -1);
  EXPECT_EQ(side_of_plane(corners, {{1, 0, 0}, part(1, 2)}), 0);
  EXPECT_EQ(side_of_plane(std::span(corners).first(3), {{0, 0, 1}, 0}), 0)
      << "all are in the plane";
}

// ---------------------------------------------------------------- hulls

// PROVES DMS-1.E3
TEST(DmsHulls, ArePartedUnlessAKnotOfTheBoundaryIsInside) {
  for (const DmsModel& model : {block(2, {2, 1, 1}, part(1, 10)), block(3, {1, 1, 1}, part(1, 10)),
                                block(2, {2, 2, 1}, {})}) {
    const TetrahedralComplex complex = complex_of(model);
    const auto parted = part_hulls(model, complex);
    ASSERT_EQ(parted.index(), 0u);
    EXPECT_EQ(std::get<0>(parted).size(), complex.boundary().size());
  }
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Random random(seed);
    DmsModel model = block(2, {2, 1, 1}, {});
    const TetrahedralComplex complex = complex_of(model);
    const std::uint32_t t = static_cast<std::uint32_t>(random.below(model.tetrahedra.size()));
    const std::uint32_t v = model.tetrahedra[t][random.below(4)];
    const Rational size = part(1, random.between(5, 1000));
    DmsPoint knot;  // all vertices are on the boundary
    for (const std::uint32_t w : model.tetrahedra[t])
      for (std::size_t c = 0; c < 3; ++c)
        knot[c] += (w == v ? Rational(1) - Rational(3) * size : size) * model.clouds[w][0][c];
    model.clouds[v].push_back(knot);
    EXPECT_EQ(part_hulls(model, complex).index(), 1u) << "seed " << seed;
  }
}

TEST(DmsHulls, NeedPlanesBesideThoseOfTheFaces) {
  // A corner of an L: the hull of a face's knots there passes beside a tetrahedron of the other leg.
  DmsModel domain = kuhn_domain({2, 2, 1}, [](int x, int y, int) { return x + y < 2; });
  set_control_by_rule(domain, DmsControlRule::kGreville, {});
  const Result<DmsModel> model =
      make_dms(domain, {2, DmsCloudDraw{part(1, 20), 3}, DmsControlRule::kGreville});
  ASSERT_TRUE(model.has_value());
  EXPECT_EQ(part_hulls(*model, complex_of(*model)).index(), 0u);
}

TEST(DmsHulls, SeparateControlPointsAgreeOrAreNamed) {
  DmsModel model = internal::separated(block(2, {1, 1, 1}, {}));
  EXPECT_FALSE(find_disagreeing_control(model));
  for (const std::uint32_t t : {1u, 3u, 5u}) {
    DmsModel other = model;
    // (2, 0, 0, 0) is at a vertex that all tetrahedra of the cube have: its diagonal's first end.
    other.control.values[control_of(model, t, {2, 0, 0, 0}) * model.num_components() + 2] +=
        part(1, 9);
    EXPECT_EQ(find_disagreeing_control(other), t);
  }
}

// ---------------------------------------------------------------- leaves

// PROVES DMS-1
TEST(DmsJacobian, IsProvedByOneMatrixForEachTetrahedron) {
  for (const DmsModel& model : {warped(block(2, {2, 2, 2}, part(1, 8)), part(1, 16)),
                                warped(block(3, {1, 1, 1}, {}), part(1, 16))}) {
    const auto proof = prove_jacobian(model);
    ASSERT_EQ(proof.index(), 0u);
    const auto& trees = std::get<0>(proof);
    ASSERT_EQ(trees.size(), model.tetrahedra.size());
    const DmsKnotTable knots(model);
    for (std::uint32_t t = 0; t < trees.size(); ++t) {
      ASSERT_EQ(trees[t].size(), 1u);
      const EnclosedMatrix r(std::get<DmsLeaf>(trees[t][0]).matrix);
      for (const TetrahedralIndex& gamma : knots.gammas())
        EXPECT_TRUE(is_monotone(r, EnclosedMatrix(knots.derivative({t, gamma})))) << t;
    }
  }
}

TEST(DmsJacobian, NamesAPointWhereAFoldedMapIsReversed) {
  DmsModel model = block(2, {1, 1, 1}, {});
  for (std::size_t i = 0; i < model.num_control(); ++i) {
    Rational& x = model.control.values[3 * i];
    x = x * (part(3, 4) - x);  // at first it goes on, then back
  }
  const auto proof = prove_jacobian(model);
  ASSERT_EQ(proof.index(), 1u);
  const DmsOpenLeaf& open = std::get<1>(proof);
  ASSERT_TRUE(open.negative_at);
  DmsEvaluator evaluator(model);
  const auto place = evaluator.locate(*open.negative_at);
  ASSERT_TRUE(place);
  const DmsValue value = evaluator.evaluate(*place);
  EXPECT_EQ(
      dot_product(value.gradient[0], cross_product(value.gradient[1], value.gradient[2])).sign(),
      Sign::kNegative);
}

TEST(DmsJacobian, StopsAtItsLimits) {
  // The map is flat: no determinant is above 0, and none below.
  DmsModel model = block(2, {1, 1, 1}, {});
  for (std::size_t i = 0; i < model.num_control(); ++i) model.control.values[3 * i] = Rational(0);
  JacobianSearchOptions options;
  options.max_levels = 3;
  const auto proof = prove_jacobian(model, options);
  ASSERT_EQ(proof.index(), 1u);
  EXPECT_FALSE(std::get<1>(proof).negative_at);
  EXPECT_EQ(std::get<1>(proof).tetrahedron, 0u);
}

// ---------------------------------------------------------------- tiles

Rational doubled_area(std::span<const DmsPoint> tile, const DmsPoint& normal) {
  return dot_product(normal,
                     cross_product(difference(tile[1], tile[0]), difference(tile[2], tile[0])));
}

// PROVES DMS-1.T1, DMS-1.T2
TEST(DmsTiles, TileEachFaceAndNoTriangleOfKnotsMeetsThem) {
  std::size_t most = 0;
  for (const DmsModel& model : {block(2, {1, 1, 1}, part(1, 10)), block(2, {2, 1, 1}, {}),
                                one_tetrahedron({{part(-1, 4), part(-1, 8), part(-1, 3)}})}) {
    const TetrahedralComplex complex = complex_of(model);
    const auto tiled = tile_boundary(model, complex);
    ASSERT_EQ(tiled.index(), 0u);
    const auto& all = std::get<0>(tiled);
    ASSERT_EQ(all.size(), complex.boundary().size());
    const DmsKnotTable knots(model);
    for (std::size_t f = 0; f < all.size(); ++f) {
      std::array<DmsPoint, 3> face;
      const auto v = complex.vertices(complex.boundary()[f]);
      for (std::size_t i = 0; i < 3; ++i) face[i] = model.clouds[v[i]][0];
      const DmsPoint normal =
          cross_product(difference(face[1], face[0]), difference(face[2], face[0]));
      most = std::max(most, all[f].size());
      Rational area;
      for (const DmsTile& tile : all[f]) {
        const Rational own = doubled_area(tile.corners, normal);
        EXPECT_EQ(own.sign(), Sign::kPositive);
        area += own;
        for (const DmsPoint& p : tile.corners)
          EXPECT_EQ(dot_product(normal, difference(p, face[0])), Rational(0));
        std::vector<DmsPlane> planes = upright_planes(tile.corners);
        planes.insert(planes.end(), tile.planes.begin(), tile.planes.end());
        DmsRegion region(knots, {tile.corners.begin(), tile.corners.end()}, planes);
        EXPECT_FALSE(region.find_cut(region.supports()));
      }
      EXPECT_EQ(area, doubled_area(face, normal));
    }
  }
  EXPECT_GT(most, 3u);
}

TEST(DmsTiles, StopAtTheirLimit) {
  const DmsModel model = block(2, {1, 1, 1}, part(1, 10));
  EXPECT_EQ(tile_boundary(model, complex_of(model), {1, nullptr, 2}).index(), 1u);
}

}  // namespace
}  // namespace veritope
