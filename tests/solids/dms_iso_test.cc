// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_iso_test.cc: level sets of known topology, singular levels, conditions of models, and the mesh.
#include "solids/dms/dms_iso.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_iso_form.h"
#include "solids/dms/dms_make.h"
#include "tests/support/dms_laws.h"
#include "tests/support/dms_level_sets.h"

namespace veritope {
namespace {

DmsIso find(const LevelSet& set, const Rational& within = Rational(8), std::size_t cells = 20'000) {
  DmsIsoOptions options;
  options.level = set.level;
  options.within = within;
  options.max_cells = cells;
  return *find_dms_iso(set.model, options);
}

void expect_topology(const LevelSet& set, const DmsIso& iso) {
  EXPECT_TRUE(iso.certified) << set.text << ", in doubt: " << iso.num_undecided;
  EXPECT_EQ(iso.components, set.components) << set.text;
  EXPECT_EQ(iso.euler, set.euler) << set.text;
}

TEST(DmsIso, QuadricsAndSheetsHaveTheirTopology) {
  for (const LevelSetKind kind :
       {LevelSetKind::kSphere, LevelSetKind::kEllipsoid, LevelSetKind::kSheets,
        LevelSetKind::kPlane, LevelSetKind::kOneSheet, LevelSetKind::kTwoSheets})
    for (const bool is_moved : {false, true}) {
      const LevelSet set = draw_level_set(7, kind, false, is_moved);
      expect_topology(set, find(set));
    }
}

// Spheres with rational numbers in one tetrahedron whose middles and thirds are on them or beside them: cuts touch them
// at rational points.
TEST(DmsIso, SpheresThatCutsTouch) {
  DmsModel model;
  model.degree = 2;
  model.attributes = {"a"};
  model.clouds = {{{-3, -3, -3}}, {{9, -3, -3}}, {{-3, 9, -3}}, {{-3, -3, 9}}};
  model.tetrahedra = {{0, 1, 2, 3}};
  set_control_by_rule(model, DmsControlRule::kGreville, std::vector<Rational>(4));
  const Rational half = Rational(1) / Rational(2), third = Rational(1) / Rational(3);
  for (const DmsPoint& centre : {DmsPoint{0, 0, 0},
                                 {half, half, third},
                                 {half, third, half},
                                 {third, 0, half},
                                 {third, third, third}})
    for (const Rational& level : {Rational(1) / Rational(4), Rational(1)}) {
      const auto blossom = [&](const DmsPoint& p, const DmsPoint& q) {
        Rational sum;
        for (std::size_t c = 0; c < 3; ++c) sum += (p[c] - centre[c]) * (q[c] - centre[c]);
        return sum;
      };
      std::size_t number = 0;
      for (std::uint32_t v = 0; v < 4; ++v)
        for (std::uint32_t w = v; w < 4; ++w)
          model.control.values[4 * number++ + 3] = blossom(model.knot(v, 0), model.knot(w, 0));
      DmsIsoOptions options;
      options.level = level;
      options.max_cells = 3'000;
      const DmsIso iso = *find_dms_iso(model, options);
      const bool is_inside =
          !(level == Rational(1) && centre[0] + centre[1] + centre[2] > Rational(5) / Rational(4));
      EXPECT_TRUE(iso.certified) << centre[0].to_string() << " " << level.to_string();
      EXPECT_EQ(iso.components, 1u);
      EXPECT_EQ(iso.euler, is_inside ? 2 : 1) << centre[0].to_string() << " " << level.to_string();
    }
}

TEST(DmsIso, SingularLevelsAreNotCertified) {
  for (int kind = kFirstSingularKind; kind < kLevelSetKinds; ++kind) {
    const LevelSet set = draw_level_set(3, static_cast<LevelSetKind>(kind), false, true);
    const DmsIso iso = find(set, Rational(8), 3'000);
    EXPECT_FALSE(iso.certified) << set.text;
    EXPECT_GT(iso.num_undecided, 0u) << set.text;
    EXPECT_FALSE(iso.undecided.empty()) << set.text;
  }
}

// A mesh of the unit scale: each directed edge occurs once, vertices are near the sphere, normals point to its inside,
// where the attribute is less.
TEST(DmsIso, MeshIsNearTheSphereAndTurnsToLowerValues) {
  const LevelSet set = draw_level_set(11, LevelSetKind::kSphere, false, false);
  const DmsIso iso = find(set, Rational(1) / Rational(4));
  expect_topology(set, iso);
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::array<double, 3> mean{};
  for (const Vec3d& p : iso.mesh.positions) {
    mean[0] += p.x, mean[1] += p.y, mean[2] += p.z;
  }
  for (double& m : mean) m /= static_cast<double>(iso.mesh.positions.size());
  double volume = 0;
  for (const auto& f : iso.mesh.faces) {
    std::array<std::array<double, 3>, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_TRUE(edges.emplace(f[k], f[(k + 1) % 3]).second);
      const Vec3d& v = iso.mesh.positions[f[k]];
      p[k] = {v.x - mean[0], v.y - mean[1], v.z - mean[2]};
    }
    volume += (p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) -
               p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0]) +
               p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0])) /
              6;
  }
  for (const auto& [a, b] : edges) EXPECT_TRUE(edges.contains({b, a}));
  const double radius = std::sqrt(nearest_double(set.level));
  const double ball = 4.18879 * radius * radius * radius;
  EXPECT_LT(volume, -0.7 * ball);
  EXPECT_GT(volume, -ball);
}

TEST(DmsIso, VerticesHaveTheLevelsValue) {
  const LevelSet set = draw_level_set(5, LevelSetKind::kSphere, false, false);
  const DmsIso iso = find(set);
  expect_topology(set, iso);
  DmsEvaluator evaluator(set.model);
  for (const Vec3d& p : iso.mesh.positions) {
    const auto place = evaluator.locate(
        {Rational::from_double(p.x), Rational::from_double(p.y), Rational::from_double(p.z)});
    ASSERT_TRUE(place.has_value());
    EXPECT_NEAR(nearest_double(evaluator.evaluate(*place).value[3] - set.level), 0, 1e-14);
  }
}

// Triangles of knots reach into all cells: the hulls of the terms prove it.
TEST(DmsIso, CloudsOfSeveralKnots) {
  LevelSet set;
  set.model = kuhn_domain({1, 1, 1});
  set.model.degree = 2;
  internal::draw_clouds(set.model, {Rational(1) / Rational(50), 1});
  set_polynomial_attribute(
      set.model, [](const DmsPoint& p) { return p[2] + p[0] / Rational(7) + p[1] / Rational(9); });
  set.level = Rational(2) / Rational(3);
  set.components = 1;
  set.euler = 1;
  const DmsIso iso = find(set);
  expect_topology(set, iso);
  for (const Vec3d& p : iso.mesh.positions) EXPECT_NEAR(p.z + p.x / 7 + p.y / 9, 2.0 / 3, 1e-14);
}

TEST(DmsIso, CellsThatTheSurfaceCrossesAreSmall) {
  const LevelSet set = draw_level_set(2, LevelSetKind::kPlane, false, false);
  const DmsIso coarse = find(set, Rational(8)), fine = find(set, Rational(1) / Rational(4));
  expect_topology(set, fine);
  EXPECT_GT(fine.mesh.faces.size(), 4 * coarse.mesh.faces.size());
  const DmsIso stopped = find(set, Rational(1) / Rational(1000), 2'000);
  EXPECT_FALSE(stopped.certified);
  ASSERT_FALSE(stopped.undecided.empty());
  EXPECT_EQ(stopped.undecided[0].why, DmsIsoDoubt::kWide);
}

// A polynomial over the cube of side 2 of 48 tetrahedra, whose vertices have integers as coordinates.
template <typename G>
LevelSet over_cube(const G& g, bool has_clouds, int size = 2) {
  LevelSet set;
  set.model = kuhn_domain({size, size, size});
  set.model.degree = 2;
  if (has_clouds) internal::draw_clouds(set.model, {Rational(1) / Rational(10), 5});
  set_polynomial_attribute(set.model, g);
  set.text = has_clouds ? "clouds" : "collapsed";
  return set;
}
DmsPoint from_middle(const DmsPoint& p, int middle) {
  return {p[0] - Rational(middle), p[1] - Rational(middle), p[2] - Rational(middle)};
}

// PROVES DMS-4, DMS-4.V1, DMS-4.V2
TEST(DmsIso, LevelsAtVerticesOfTheDomain) {
  for (const bool has_clouds : {false, true}) {
    // Nine vertices, those in faces and on edges of the cube among them.
    LevelSet plane = over_cube([](const DmsPoint& p) { return p[2]; }, has_clouds);
    plane.components = 1, plane.euler = 1, plane.level = Rational(1);
    expect_topology(plane, find(plane));
    EXPECT_EQ(find(plane).mesh.positions.size(), 9u);
    EXPECT_EQ(find(plane).mesh.faces.size(), 8u);
    // The middle alone, where a saddle is tangent to edges.
    LevelSet saddle = over_cube(
        [](const DmsPoint& p) {
          const DmsPoint x = from_middle(p, 1);
          return x[0] + (x[1] * x[1] - x[2] * x[2]) / Rational(3);
        },
        has_clouds);
    saddle.components = 1, saddle.euler = 1;
    expect_topology(saddle, find(saddle));
    // Six vertices at which it is tangent to edges, from inside and from outside.
    for (const int sign : {1, -1}) {
      LevelSet sphere = over_cube(
          [&](const DmsPoint& p) {
            const DmsPoint x = from_middle(p, 2);
            return Rational(sign) * (dot_product(x, x) - Rational(1));
          },
          has_clouds, 4);
      sphere.components = 1, sphere.euler = 2;
      expect_topology(sphere, find(sphere));
    }
  }
}

// The hulls of note 0098 left it open after 20,000 cells.
TEST(DmsIso, ASphereInTetrahedraWithCloudsNeedsFewCells) {
  LevelSet set = over_cube(
      [](const DmsPoint& p) {
        const DmsPoint x = from_middle(p, 1);
        return dot_product(x, x) + x[0] / Rational(19) - x[1] / Rational(31);
      },
      true);
  set.level = Rational(4) / Rational(9);
  set.components = 1, set.euler = 2;
  expect_topology(set, find(set, Rational(8), 2'000));
}

// Numbers whose squares are beyond binary64.
TEST(DmsIso, LargeAndSmallAttributes) {
  for (const int exponent : {-900, 900}) {
    const Rational scale = Rational::power_of_two(exponent);
    LevelSet set = over_cube([&](const DmsPoint& p) { return scale * (p[0] + p[2] * p[2]); }, true);
    set.level = scale / Rational(3);
    set.components = 1, set.euler = 1;
    expect_topology(set, find(set));
  }
}

// Lengths whose squares are beyond binary64, and differences of coordinates that it does not show.
TEST(DmsIso, DomainsOfAnySizeAndPlaceAreCutAlike) {
  const LevelSet set = draw_level_set(7, LevelSetKind::kSphere, false, false);
  const Rational within = Rational(1) / Rational(3);
  const DmsIso iso = find(set, within);
  expect_topology(set, iso);
  for (const int exponent : {-1500, -600, -60, 600, 900})
    for (const bool is_moved : {false, true}) {
      const Rational scale = Rational::power_of_two(exponent);
      const Rational by = is_moved ? Rational(1) / Rational(3) : Rational(0);
      LevelSet other = set;
      move_dms(other.model, {{{{scale, 0, 0}, {0, scale, 0}, {0, 0, scale}}}, {by, by, by}});
      const DmsIso same = find(other, scale * within);
      expect_topology(other, same);
      EXPECT_EQ(same.cells, iso.cells) << exponent;
      EXPECT_EQ(same.mesh.faces, iso.mesh.faces) << exponent;
    }
}

TEST(DmsIso, PlacesAreTheVerticesBeforeRounding) {
  const LevelSet set = draw_level_set(7, LevelSetKind::kSphere, false, false);
  DmsIsoOptions options;
  options.level = set.level;
  EXPECT_TRUE(find_dms_iso(set.model, options)->places.empty());
  options.keeps_places = true;
  const DmsIso iso = *find_dms_iso(set.model, options);
  ASSERT_EQ(iso.places.size(), iso.mesh.positions.size());
  for (std::size_t i = 0; i < iso.places.size(); ++i) {
    const Vec3d& p = iso.mesh.positions[i];
    EXPECT_EQ((Point3d{p.x, p.y, p.z}),
              (Point3d{nearest_double(iso.places[i][0]), nearest_double(iso.places[i][1]),
                       nearest_double(iso.places[i][2])}));
  }
}

// Where no direction of growth is parallel to the faces of the domain, or where there is not any.
TEST(DmsIso, SingularVerticesAndCornersAreInDoubt) {
  const auto middle = [](const DmsPoint& p) { return from_middle(p, 1); };
  const auto expect_doubt = [](const LevelSet& set) {
    const DmsIso iso = find(set, Rational(8), 4'000);
    EXPECT_FALSE(iso.certified) << set.text;
    ASSERT_FALSE(iso.undecided.empty()) << set.text;
    EXPECT_TRUE(std::any_of(iso.undecided.begin(), iso.undecided.end(), [](const DmsIsoCell& cell) {
      return cell.why == DmsIsoDoubt::kVertex;
    })) << set.text;
  };
  for (const bool has_clouds : {false, true}) {
    expect_doubt(over_cube([&](const DmsPoint& p) { return dot_product(middle(p), middle(p)); },
                           has_clouds));
    expect_doubt(
        over_cube([&](const DmsPoint& p) { return middle(p)[0] * middle(p)[0]; }, has_clouds));
    expect_doubt(
        over_cube([&](const DmsPoint& p) { return middle(p)[0] * middle(p)[1]; }, has_clouds));
    expect_doubt(over_cube(
        [&](const DmsPoint& p) {
          const DmsPoint x = middle(p);
          return x[0] * x[0] + x[1] * x[1] - x[2] * x[2];
        },
        has_clouds));
    // A corner alone; an edge of the cube; a sphere that touches six faces.
    expect_doubt(over_cube([](const DmsPoint& p) { return p[0] + p[1] + p[2]; }, has_clouds));
    expect_doubt(over_cube([](const DmsPoint& p) { return p[0] + p[1]; }, has_clouds));
    expect_doubt(over_cube(
        [&](const DmsPoint& p) { return dot_product(middle(p), middle(p)) - Rational(1); },
        has_clouds));
  }
}

// Control points that no polynomial has: what other tetrahedra add is bounded by what their splines are at corners.
TEST(DmsIso, CloudsAndControlPointsOfNoPolynomial) {
  for (const int seed : {1, 2}) {
    LevelSet set = over_cube(
        [](const DmsPoint& p) {
          const DmsPoint x = from_middle(p, 1);
          return x[2] + x[0] * x[0] / Rational(3);
        },
        false);
    internal::draw_clouds(set.model,
                          {Rational(1) / Rational(20), static_cast<std::uint64_t>(seed)});
    Random random(static_cast<std::uint64_t>(seed));
    for (std::size_t c = 0; c < set.model.num_control(); ++c)
      set.model.control.values[4 * c + 3] += Rational(random.between(-9, 9)) / Rational(500);
    set.level = Rational(1) / Rational(2);
    set.components = 1, set.euler = 1;
    set.text = "seed " + std::to_string(seed);
    expect_topology(set, find(set));
  }
}

// Separate control points of equal values are shared ones; where one differs the attribute may jump.
TEST(DmsIso, NothingIsCertifiedWhereControlPointsDisagree) {
  LevelSet set = draw_level_set(2, LevelSetKind::kPlane, false, false);
  set.model = internal::separated(set.model);
  EXPECT_EQ(find(set).obstacle, std::nullopt);
  EXPECT_TRUE(find(set).certified);
  set.model.control.values[3] += Rational::power_of_two(-40);  // of tetrahedron 0 at its corner 0
  EXPECT_EQ(find(set).obstacle, "control-disagrees");
  EXPECT_FALSE(find(set).certified);
}

// The two parts of a cut have the values of the whole: along random rational points of edges.
TEST(DmsIsoRule, CutsKeepThePolynomial) {
  const int n = 3;
  const DmsIsoRule rule(n);
  Random random(1);
  DmsIsoForm form;
  for (std::size_t i = 0; i < num_tetrahedral_indices(n); ++i)
    form.coefficients.push_back(Interval(static_cast<double>(random.between(-8, 8))));
  for (std::size_t e = 0; e < kDmsEdges.size(); ++e) {
    const auto [first, second] = rule.cut(form, e, Rational(1) / Rational(4));
    const std::vector<Interval> b = rule.along_edge(form, e);
    const auto value = [](const std::vector<Interval>& c, double t) {
      const double s = 1 - t;
      return c[0].lo() * s * s * s + 3 * c[1].lo() * s * s * t + 3 * c[2].lo() * s * t * t +
             c[3].lo() * t * t * t;
    };
    EXPECT_NEAR(value(rule.along_edge(first, e), 0.5), value(b, 0.125), 1e-12);
    EXPECT_NEAR(value(rule.along_edge(second, e), 0.5), value(b, 0.625), 1e-12);
    // Along the other edges at the corner that stays nothing changes.
    const auto [i, j] = kDmsEdges[e];
    for (std::size_t other = 0; other < kDmsEdges.size(); ++other) {
      const auto [k, l] = kDmsEdges[other];
      if (k != j && l != j) {
        EXPECT_EQ(rule.along_edge(first, other)[1], rule.along_edge(form, other)[1]);
      }
      if (k != i && l != i) {
        EXPECT_EQ(rule.along_edge(second, other)[1], rule.along_edge(form, other)[1]);
      }
    }
  }
}

// PROVES DMS-4.R1
TEST(DmsIsoRule, OpenAreSimplicesWithoutSignAndGrowth) {
  const DmsIsoRule rule(1);
  const auto linear = [](double a, double b, double c, double d) {
    return DmsIsoForm{{Interval(a), Interval(b), Interval(c), Interval(d)}, {}, {}, {}};
  };
  EXPECT_EQ(rule.find_open(linear(-1, 2, 3, 4)), std::nullopt);
  EXPECT_EQ(rule.find_open(linear(1, 1, 1, 1)), std::nullopt);
  EXPECT_EQ(rule.find_open(linear(0, 0, 1, 1)), DmsCorners{3});
  EXPECT_EQ(rule.find_open(linear(0, 0, 0, 1)), DmsCorners{7});
  EXPECT_EQ(rule.find_open(linear(0, 0, 0, 0)), kAllCorners);
  EXPECT_EQ(rule.sign_on(linear(1, 0, 2, 3), kAllCorners), 0);
  EXPECT_EQ(rule.sign_on(linear(1, 0, 2, 3), 13), 1);
  // Corners at which g = c count as above the level.
  EXPECT_EQ(rule.find_open(linear(0, 0, 0, 1), 7), std::nullopt);
  EXPECT_EQ(rule.find_open(linear(0, 0, 0, -1), 7), std::nullopt);
  EXPECT_EQ(rule.find_open(linear(0, 1, 1, -1), 1), std::nullopt);
  EXPECT_EQ(rule.sign_on(linear(0, 0, 0, 1), kAllCorners, 7), 1);
  EXPECT_EQ(rule.sign_on(linear(0, 0, 0, -1), kAllCorners, 7), 0);
}

}  // namespace
}  // namespace veritope
