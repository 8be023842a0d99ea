// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/curve_crossings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "models/patch_shapes.h"
#include "models/round_parts.h"
#include "tests/predicates/test_scale.h"
#include "tests/solids/patch_support.h"
#include "tests/support/exact_geometry.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

constexpr std::uint64_t kCrossingSeed = 20261205;

Rational cq(std::int64_t p, std::int64_t d = 1) { return Rational(p) / Rational(d); }

BezierCurve<Rational> curve_of(const std::vector<ExactPoint>& control) {
  const auto degree = static_cast<int>(control.size()) - 1;
  BezierCurve<Rational> out({degree}, 3, false);
  for (std::size_t i = 0; i < control.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) out.component(static_cast<int>(c))[i] = control[i][c];
  return out;
}
CurveCrossings crossings(const Patches& patches, const BezierCurve<Rational>& curve,
                         std::size_t max_pairs = 50000) {
  const PatchComplex complex = complex_of(patches);
  return PatchCrossings(complex).find(curve, max_pairs);
}
bool has(const Interval& a, const Rational& x) {
  return Rational::from_double(a.lo()) <= x && x <= Rational::from_double(a.hi());
}

TEST(MeshCrossings, FindsFacetsEdgesVerticesAndRunsInPlanes) {
  const TriangleMesh box = shapes::parse("box 0,0,0 4,4,4");
  const MeshCrossings of(box);
  const std::vector<ExactPoint> through{{cq(1), cq(2), cq(-4)}, {cq(1), cq(2), cq(12)}};
  const auto two = of.find(through);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0].begin, cq(1, 4));
  EXPECT_EQ(two[0].end, cq(1, 4));
  EXPECT_EQ(two[1].begin, cq(1, 2));
  // At a vertex, once for each of its facets.
  const std::vector<ExactPoint> corner{{cq(-1), cq(-1), cq(-1)}, {cq(1), cq(1), cq(1)}};
  const auto all = of.find(corner);
  std::size_t at_corner = 0;
  for (const auto& f : box.faces)
    for (const std::uint32_t v : f)
      at_corner += box.positions[v].x == 0 && box.positions[v].y == 0 && box.positions[v].z == 0;
  EXPECT_EQ(all.size(), at_corner);
  for (const PolygonCrossing& c : all) EXPECT_EQ(c.begin, cq(1, 2));
  // In the plane of a face, across its two triangles.
  const std::vector<ExactPoint> flat{{cq(-4), cq(1), cq(4)}, {cq(12), cq(1), cq(4)}};
  Rational length;
  for (const PolygonCrossing& c : of.find(flat)) length += c.end - c.begin;
  EXPECT_EQ(length, cq(1, 4));
  // A polygon, a point on the surface, and none.
  const std::vector<ExactPoint> polygon{
      {cq(2), cq(2), cq(2)}, {cq(2), cq(3), cq(9)}, {cq(2), cq(1), cq(2)}, {cq(2), cq(1), cq(1)}};
  const auto out = of.find(polygon);
  ASSERT_EQ(out.size(), 2u);
  EXPECT_EQ(out[0].segment, 0u);
  EXPECT_EQ(out[1].segment, 1u);
  const std::vector<ExactPoint> point{{cq(1), cq(2), cq(4)}, {cq(1), cq(2), cq(4)}};
  ASSERT_EQ(of.find(point).size(), 1u);
  EXPECT_EQ(of.find(point)[0].end, cq(0));
  EXPECT_TRUE(of.find(std::vector<ExactPoint>{{cq(1), cq(1), cq(1)}}).empty());
  EXPECT_TRUE(of.find({}).empty());
}

// Every facet by itself, with the signs of volumes.
TEST(MeshCrossingsLaw, AgreesWithEveryFacet) {
  using oracle::operator-;
  const TriangleMesh mesh = shapes::torus(9, 7, 2, 0.75);
  const MeshCrossings of(mesh);
  for (int n = 0; n < scaled(60); ++n) {
    Random random(kCrossingSeed + static_cast<std::uint64_t>(n));
    std::vector<ExactPoint> ends(2);
    for (ExactPoint& p : ends)
      for (Rational& x : p) x = cq(random.between(-60, 60), 17);
    const auto found = of.find(ends);
    std::size_t next = 0;
    std::vector<std::uint32_t> facets;
    for (const PolygonCrossing& c : found) facets.push_back(c.facet);
    std::sort(facets.begin(), facets.end());
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
      const auto t = oracle::rational_triangle(mesh, f);
      const auto volume = [](const auto& a, const auto& b, const auto& c, const auto& d) {
        return oracle::sgn(oracle::dot(a - d, oracle::cross(b - d, c - d)));
      };
      const int above = volume(t[0], t[1], t[2], ends[0]),
                below = volume(t[0], t[1], t[2], ends[1]);
      const int a = volume(ends[0], ends[1], t[0], t[1]), b = volume(ends[0], ends[1], t[1], t[2]),
                c = volume(ends[0], ends[1], t[2], t[0]);
      if (above == 0 || below == 0 || a == 0 || b == 0 || c == 0) continue;  // not generic
      const bool meets = above != below && a == b && b == c;
      const bool is_found = std::binary_search(facets.begin(), facets.end(), f);
      EXPECT_EQ(meets, is_found) << "seed " << kCrossingSeed << " case " << n << " facet " << f;
      next += meets;
    }
    EXPECT_LE(next, found.size());
    for (const PolygonCrossing& c : found) {
      // The point is in the facet's plane.
      const auto t = oracle::rational_triangle(mesh, c.facet);
      ExactPoint p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = ends[0][k] + c.begin * (ends[1][k] - ends[0][k]);
      EXPECT_EQ(oracle::sgn(oracle::dot(oracle::normal_of(t), p - t[0])), 0);
    }
  }
}

TEST(PatchCrossings, ALineCrossesABallTwice) {
  // z = 1/3, x = 1/7: y = +-sqrt(1 - 1/9 - 1/49) at t = (2 +- y) / 4.
  const auto line = curve_of({{cq(1, 7), cq(-2), cq(1, 3)}, {cq(1, 7), cq(2), cq(1, 3)}});
  for (const Patches& ball : {patch_shapes::sphere(), patch_shapes::octant_sphere()}) {
    const CurveCrossings out = crossings(ball, line);
    EXPECT_TRUE(out.is_complete);
    ASSERT_EQ(out.places.size(), 2u);
    for (const CurveCrossing& c : out.places) {
      EXPECT_TRUE(c.is_proved);
      const Rational lo = Rational::from_double(c.t.lo()) * cq(4) - cq(2),
                     hi = Rational::from_double(c.t.hi()) * cq(4) - cq(2),
                     square = cq(1) - cq(1, 9) - cq(1, 49);
      EXPECT_LE(std::min(lo * lo, hi * hi), square);
      EXPECT_GE(std::max(lo * lo, hi * hi), square);
      EXPECT_LT(c.t.hi() - c.t.lo(), 1e-9);
    }
  }
}

TEST(PatchCrossings, ContactsStayOpenAndAreNotProved) {
  const Patches ball = patch_shapes::sphere();
  // Tangent at (0, 0, 1)'s neighbour on the equator's point (1, 0, 0).
  const CurveCrossings touch =
      crossings(ball, curve_of({{cq(1), cq(-3), cq(-1)}, {cq(1), cq(3), cq(1)}}), 200000);
  bool has_contact = false;
  for (const CurveCrossing& c : touch.places) {
    EXPECT_FALSE(c.is_proved);
    has_contact = has_contact || has(c.t, cq(1, 2));
  }
  EXPECT_TRUE(has_contact);
  EXPECT_TRUE(
      crossings(ball, curve_of({{cq(2), cq(-3), cq(-1)}, {cq(2), cq(3), cq(1)}})).places.empty());
  // Across an edge of a box: once in each face.
  const CurveCrossings edge =
      crossings(unit_box(), curve_of({{cq(-1), cq(1, 3), cq(-1)}, {cq(1, 2), cq(1, 3), cq(1, 2)}}));
  ASSERT_EQ(edge.places.size(), 2u);
  for (const CurveCrossing& c : edge.places) EXPECT_TRUE(has(c.t, cq(2, 3)));
}

TEST(PatchCrossings, TheLimitOfWorkIsReported) {
  // All of the curve lies in a face.
  const CurveCrossings out = crossings(
      unit_box(), curve_of({{cq(1, 4), cq(1, 4), cq(0)}, {cq(3, 4), cq(1, 2), cq(0)}}), 500);
  EXPECT_FALSE(out.is_complete);
  EXPECT_FALSE(out.places.empty());
}

// Where the equation of the solid changes its sign along the curve there is a place; a proved one has a change.
TEST(PatchCrossingsLaw, SignsOfTheEquationAgree) {
  const PatchComplex complex = complex_of(patch_shapes::torus(3, 1));
  const PatchCrossings of(complex);
  // (|p|^2 + 8)^2 - 36 (x^2 + y^2)
  const auto side = [](const BezierCurve<Rational>& curve, const Rational& t) {
    const auto p = evaluate<Rational, 1>(curve, {t});
    const Rational xy = p[0] * p[0] + p[1] * p[1], s = xy + p[2] * p[2] + cq(8);
    return oracle::sgn(s * s - cq(36) * xy);
  };
  for (int n = 0; n < scaled(40); ++n) {
    Random random(kCrossingSeed + static_cast<std::uint64_t>(n));
    std::vector<ExactPoint> control(2 + random.below(3));
    for (ExactPoint& p : control)
      for (std::size_t c = 0; c < 3; ++c) p[c] = cq(random.between(-90, 90), c == 2 ? 37 : 16);
    const auto curve = curve_of(control);
    const CurveCrossings out = of.find(curve, 200000);
    const std::string where =
        "seed " + std::to_string(kCrossingSeed) + " case " + std::to_string(n);
    for (int i = 0; i < 200; ++i) {
      const Rational a = cq(i, 200), b = cq(i + 1, 200);
      if (side(curve, a) * side(curve, b) >= 0) continue;
      const bool is_there =
          std::any_of(out.places.begin(), out.places.end(), [&](const CurveCrossing& c) {
            return Rational::from_double(c.t.lo()) <= b && a <= Rational::from_double(c.t.hi());
          });
      EXPECT_TRUE(is_there) << where << " after " << i;
    }
    for (std::size_t i = 0; i < out.places.size(); ++i) {
      const CurveCrossing& c = out.places[i];
      if (!c.is_proved) continue;
      bool is_alone = true;
      const double gap = 1e-7;
      for (std::size_t k = 0; k < out.places.size(); ++k)
        is_alone = is_alone && (k == i || out.places[k].t.hi() < c.t.lo() - 2 * gap ||
                                out.places[k].t.lo() > c.t.hi() + 2 * gap);
      if (!is_alone || c.t.lo() < gap || c.t.hi() > 1 - gap) continue;
      EXPECT_LT(side(curve, Rational::from_double(c.t.lo() - gap)) *
                    side(curve, Rational::from_double(c.t.hi() + gap)),
                0)
          << where;
    }
  }
}

}  // namespace
}  // namespace veritope
