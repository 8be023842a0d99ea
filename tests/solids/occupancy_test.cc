// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/occupancy_test.cc: each step from points to an occupancy domain, against its definition, and noisy scans
// of solids whose genus is known.
#include "solids/tetrahedra/occupancy.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "predicates/distance.h"
#include "solids/tetrahedra/delaunay.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/noisy_scans.h"
#include "tests/support/point_sets.h"

namespace veritope {
namespace {

std::vector<ExactPoint3> exact(const std::vector<Vec3d>& points) {
  return {points.begin(), points.end()};
}

std::vector<TetrahedronCorners> delaunay(const std::vector<ExactPoint3>& points) {
  return delaunay_tetrahedra(std::span<const ExactPoint3>(points)).value().tetrahedra;
}

Rational squared_distance(const ExactPoint3& p, const ExactPoint3& q) {
  Rational sum;
  for (std::size_t a = 0; a < 3; ++a) sum += (p.at()[a] - q.at()[a]) * (p.at()[a] - q.at()[a]);
  return sum;
}

TEST(Occupancy, NearestNeighboursAreTheNearestOfAllPoints) {
  for (const int kind : {0, 1, 5, 7, 8}) {
    Random random(static_cast<std::uint64_t>(kind));
    const std::vector<ExactPoint3> points = exact(make_point_set(kind, 60, random).points);
    const std::vector<std::uint32_t> nearest = nearest_neighbours(points, delaunay(points));
    for (std::uint32_t v = 0; v < points.size(); ++v) {
      ASSERT_NE(nearest[v], v);
      const Rational least = squared_distance(points[v], points[nearest[v]]);
      for (std::uint32_t w = 0; w < points.size(); ++w) {
        if (w == v) continue;
        EXPECT_LE(least, squared_distance(points[v], points[w])) << kind << " " << v << " " << w;
      }
    }
  }
}

TEST(Occupancy, MiddlesAreInTheUnionIfSomeBallHasThem) {
  for (long round = 0; round < scaled(10); ++round) {
    Random random(static_cast<std::uint64_t>(round));
    // A grid has middles exactly on spheres.
    const std::vector<ExactPoint3> points =
        exact(make_point_set(round % 2 == 0 ? 1 : 0, 30, random).points);
    const std::vector<std::uint32_t> nearest = nearest_neighbours(points, delaunay(points));
    const BallUnion balls(points, nearest);
    for (std::uint32_t a = 0; a < points.size(); ++a)
      for (std::uint32_t b = 0; b < a; ++b) {
        std::array<Rational, 3> middle;
        for (std::size_t c = 0; c < 3; ++c)
          middle[c] = (points[a].at()[c] + points[b].at()[c]) / Rational(2);
        const ExactPoint3 m(middle);
        bool is_in = false;
        for (std::uint32_t v = 0; v < points.size(); ++v)
          is_in = is_in ||
                  squared_distance(m, points[v]) <= squared_distance(points[v], points[nearest[v]]);
        EXPECT_EQ(balls.contains_middle(a, b), is_in) << round << " " << a << " " << b;
      }
  }
}

// The genus of each shell of the boundary.
std::vector<std::int64_t> genera(const std::vector<TetrahedronCorners>& tetrahedra,
                                 std::uint32_t num_vertices) {
  const TetrahedralComplex complex(tetrahedra, num_vertices);
  std::vector<std::uint32_t> root(num_vertices);
  std::iota(root.begin(), root.end(), 0u);
  const auto find = [&](std::uint32_t v) {
    while (root[v] != v) v = root[v];
    return v;
  };
  std::map<std::uint32_t, std::int64_t> euler2;  // twice the characteristic: 2 V - F, by the root
  std::vector<bool> is_seen(num_vertices);
  for (const TetrahedronFace f : complex.boundary()) {
    const auto v = complex.vertices(f);
    for (const std::uint32_t w : v) is_seen[w] = true;
    for (std::size_t i = 1; i < 3; ++i) root[find(v[i])] = find(v[0]);
  }
  for (std::uint32_t v = 0; v < num_vertices; ++v)
    if (is_seen[v]) euler2[find(v)] += 2;
  for (const TetrahedronFace f : complex.boundary()) --euler2[find(complex.vertices(f)[0])];
  std::vector<std::int64_t> out;
  for (const auto& [v, chi2] : euler2) out.push_back((4 - chi2) / 4);
  return out;
}

std::vector<TetrahedronCorners> kept_of(const std::vector<TetrahedronCorners>& all,
                                        const Occupancy& occupancy) {
  std::vector<TetrahedronCorners> out;
  for (const std::uint32_t t : occupancy.kept) out.push_back(all[t]);
  return out;
}

TEST(Occupancy, NoisyScansHaveTheGenusOfTheirSolids) {
  for (const ScannedSolid& solid : scanned_solids())
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(2)); ++seed) {
      Random random(seed);
      const std::vector<ExactPoint3> points = exact(scan(solid, 0.2, 0.1, random));
      const std::vector<TetrahedronCorners> all = delaunay(points);
      const auto occupancy = find_occupancy(points, all);
      ASSERT_TRUE(occupancy);
      EXPECT_EQ(occupancy->kept.size() + occupancy->removed.size(), all.size());
      EXPECT_EQ(genera(kept_of(all, *occupancy), static_cast<std::uint32_t>(points.size())),
                std::vector<std::int64_t>{solid.genus})
          << solid.name << " seed " << seed << ", " << points.size() << " points";
    }
}

TEST(Occupancy, SpheresDecideWhatIsNoiseAndWhatIsFlat) {
  // A grid of unit distance: balls of radius 1, spheres of cubes with the radius sqrt(3) / 2.
  std::vector<Vec3d> grid;
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y)
      for (int z = 0; z < 4; ++z) grid.push_back({double(x), double(y), double(z)});
  const std::vector<ExactPoint3> points = exact(grid);
  const std::vector<TetrahedronCorners> all = delaunay(points);
  const BallUnion balls(points, nearest_neighbours(points, all));
  const Rational above(Integer(867), Integer(1000)), below(Integer(866), Integer(1000));
  std::vector<bool> occupied(all.size());
  EXPECT_TRUE(fill_noise(all, balls, below, occupied).empty());
  EXPECT_EQ(fill_noise(all, balls, above, occupied).size(), all.size());
  EXPECT_EQ(occupied, std::vector<bool>(all.size(), true));
  EXPECT_TRUE(clip_large_spheres(all, balls, above, occupied).empty());
  EXPECT_EQ(clip_large_spheres(all, balls, below, occupied).size(), all.size());
  EXPECT_EQ(occupied, std::vector<bool>(all.size(), false));
}

TEST(Occupancy, TheBoundaryIsA2ManifoldAlsoOfSparsePoints) {
  for (long round = 0; round < scaled(30); ++round) {
    Random random(static_cast<std::uint64_t>(round));
    const std::vector<ExactPoint3> points =
        exact(make_point_set(round % 2 == 0 ? 0 : 7, 150, random).points);
    const std::vector<TetrahedronCorners> all = delaunay(points);
    // Clipped at random: worse than by balls.
    std::vector<bool> kept;
    for (std::size_t t = 0; t < all.size(); ++t) kept.push_back(random.below(4) > 0);
    std::vector<bool> before = kept;
    const auto num_vertices = static_cast<std::uint32_t>(points.size());
    const auto trimmed = trim_to_manifold(TetrahedralComplex(all, num_vertices),
                                          order_by_longest_edge(points, all), kept);
    std::vector<TetrahedronCorners> rest;
    for (std::uint32_t t = 0; t < all.size(); ++t)
      if (kept[t]) rest.push_back(all[t]);
    for (const TrimmedTetrahedron& t : trimmed) {
      EXPECT_TRUE(before[t.tetrahedron]);
      before[t.tetrahedron] = false;
    }
    EXPECT_EQ(before, kept);
    const TetrahedralComplex complex(rest, num_vertices);
    for (std::uint32_t v = 0; v < num_vertices; ++v)
      EXPECT_NE(classify_link(complex.link(v)), LinkKind::kOther) << round << " " << v;
  }
}

TEST(Occupancy, RefusesPointsWithoutAnyTetrahedronInside) {
  // Two pairs of points that are far apart.
  const std::vector<ExactPoint3> points = exact({{0, 0, 0}, {1, 0, 0}, {50, 0, 90}, {50, 1, 90}});
  const auto occupancy = find_occupancy(points, delaunay(points));
  ASSERT_FALSE(occupancy);
  EXPECT_EQ(occupancy.error().code, Code::kBadArgument);
}

// Cubes of a grid of 2 x 2 x 3 that are wanted, as tetrahedra of the whole grid.
class CubesOfAGrid {
 public:
  CubesOfAGrid() {
    for (int x = 0; x < 3; ++x)
      for (int y = 0; y < 3; ++y)
        for (int z = 0; z < 4; ++z) grid_.push_back({double(x), double(y), double(z)});
    points_ = exact(grid_);
    all_ = delaunay(points_);
  }
  // How many tetrahedra are taken away, by the reason.
  template <typename Wanted>
  std::map<TrimReason, int> reasons(Wanted wanted) const {
    std::vector<bool> kept;
    for (const TetrahedronCorners& t : all_) {
      Vec3d sum;
      for (const std::uint32_t v : t)
        sum = {sum.x + grid_[v].x, sum.y + grid_[v].y, sum.z + grid_[v].z};
      kept.push_back(wanted(static_cast<int>(sum.x / 4), static_cast<int>(sum.y / 4),
                            static_cast<int>(sum.z / 4)));
    }
    const TetrahedralComplex complex(all_, 36);
    std::map<TrimReason, int> out;
    for (const TrimmedTetrahedron& t :
         trim_to_manifold(complex, order_by_longest_edge(points_, all_), kept))
      ++out[t.reason];
    return out;
  }

 private:
  std::vector<Vec3d> grid_;
  std::vector<ExactPoint3> points_;
  std::vector<TetrahedronCorners> all_;
};

TEST(TrimToManifold, KeepsWhatIsAManifold) {
  const CubesOfAGrid cubes;
  EXPECT_TRUE(cubes.reasons([](int, int, int) { return true; }).empty());
  EXPECT_TRUE(cubes.reasons([](int, int, int) { return false; }).empty());
  EXPECT_TRUE(cubes.reasons([](int x, int, int) { return x == 1; }).empty());
  EXPECT_TRUE(cubes.reasons([](int x, int y, int z) { return x + y + z != 0; }).empty());
}

TEST(TrimToManifold, SeparatesWhatMeetsInAVertexOnly) {
  const CubesOfAGrid cubes;
  const auto reasons = cubes.reasons([](int x, int y, int z) { return z < 2 && x == y && y == z; });
  ASSERT_EQ(reasons.size(), 1u);
  EXPECT_GT(reasons.at(TrimReason::kVertex), 0);
}

// Two cubes of the middle layer meet in an edge, and the layers below and above connect them at both of its ends.
TEST(TrimToManifold, SeparatesWhatMeetsInAnEdgeOnly) {
  const CubesOfAGrid cubes;
  const auto reasons = cubes.reasons([](int x, int y, int z) { return z != 1 || x == y; });
  EXPECT_GT(reasons.at(TrimReason::kEdge), 0);
}

TEST(Occupancy, SatellitesAreSmallPartsThatWereConnected) {
  // A row of 17 tetrahedra, one that shared a vertex with the row, one that did not.
  std::vector<TetrahedronCorners> all;
  for (std::uint32_t i = 0; i < 17; ++i) all.push_back({i, i + 1, i + 2, i + 3});
  all.push_back({20, 21, 22, 23});
  all.push_back({19, 20, 24, 25});  // connected the row with the one before
  all.push_back({30, 31, 32, 33});
  const TetrahedralComplex complex(all, 34);
  const std::vector<bool> before(all.size(), true);
  std::vector<bool> kept = before;
  kept[18] = false;
  EXPECT_EQ(remove_satellites(complex, before, kept), std::vector<std::uint32_t>{17});
  EXPECT_TRUE(kept[0] && kept[16] && !kept[17] && kept[19]);
  kept[17] = true;
  kept[16] = false;  // no sixteenth any more
  EXPECT_TRUE(remove_satellites(complex, before, kept).empty());
}

// At a vertex of the middle of the grid all is there but two tetrahedra with only this vertex in common, so that the
// tetrahedra around it are like a ring.
TEST(TrimToManifold, OpensRings) {
  const std::vector<Vec3d> corners{{0, 0, 0},  {1, 0, 0}, {-1, 0, 0}, {0, 1, 0},
                                   {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const std::vector<ExactPoint3> points = exact(corners);
  const std::vector<TetrahedronCorners> all = delaunay(points);
  ASSERT_EQ(all.size(), 8u);
  std::vector<bool> kept;
  for (const TetrahedronCorners& t : all) {
    Vec3d sum;
    for (const std::uint32_t v : t)
      sum = {sum.x + corners[v].x, sum.y + corners[v].y, sum.z + corners[v].z};
    kept.push_back(!(sum.x > 0 && sum.y > 0 && sum.z > 0) &&
                   !(sum.x < 0 && sum.y < 0 && sum.z < 0));
  }
  const TetrahedralComplex complex(all, 7);
  const auto trimmed = trim_to_manifold(complex, order_by_longest_edge(points, all), kept);
  ASSERT_FALSE(trimmed.empty());
  EXPECT_EQ(trimmed[0].reason, TrimReason::kRing);
}

TEST(Occupancy, FillsGapsOfNoiseAndKeepsCavities) {
  Random random(5);
  const ScannedSolid hollow{"hollow ball", 0, 1.0, [](const Vec3d& p) {
                              const double r = std::hypot(p.x, p.y, p.z);
                              return r <= 1 && r >= 0.5;
                            }};
  const std::vector<ExactPoint3> points = exact(scan(hollow, 0.17, 0.05, random));
  const std::vector<TetrahedronCorners> all = delaunay(points);
  const auto occupancy = find_occupancy(points, all);
  ASSERT_TRUE(occupancy);
  const auto num_vertices = static_cast<std::uint32_t>(points.size());
  EXPECT_EQ(genera(kept_of(all, *occupancy), num_vertices), (std::vector<std::int64_t>{0, 0}));
  // One tetrahedron inside of a full ball is a gap of noise.
  const std::vector<ExactPoint3> full = exact(scan(scanned_solids()[0], 0.17, 0, random));
  const std::vector<TetrahedronCorners> tetrahedra = delaunay(full);
  const TetrahedralComplex complex(tetrahedra, static_cast<std::uint32_t>(full.size()));
  const BallUnion balls(full, nearest_neighbours(full, tetrahedra));
  std::vector<bool> occupied(tetrahedra.size(), true);
  std::uint32_t inner = 0;
  const auto touches_boundary = [&](std::uint32_t t) {
    for (std::uint32_t m = 0; m < 4; ++m)
      if (!complex.partner(4 * t + m)) return true;
    return false;
  };
  while (touches_boundary(inner)) ++inner;
  occupied[inner] = false;
  EXPECT_EQ(fill_enclosed_gaps(complex, balls, Rational(2), occupied),
            std::vector<std::uint32_t>{inner});
  EXPECT_TRUE(occupied[inner]);
  std::uint32_t outer = 0;
  while (!touches_boundary(outer)) ++outer;
  occupied[outer] = false;
  EXPECT_TRUE(fill_enclosed_gaps(complex, balls, Rational(2), occupied).empty());
  EXPECT_FALSE(occupied[outer]);
}

}  // namespace
}  // namespace veritope
