// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/mesh/mesh_lanes_internal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "interval/upward.h"
#include "robust/base/fp_guard.h"
#include "robust/base/random.h"
#include "solids/micro/mesh/quad_gap_internal.h"
#include "solids/micro/micro_grid.h"
#include "splines/de_boor.h"
#include "tests/support/v_cells.h"

namespace veritope {
namespace {

using internal::CellMapBounds;
using internal::PointColumns;
using internal::PointTable;
using internal::quad_gap;
using internal::quad_gaps;
using internal::RoundedCage;
using internal::RoundedCell;
using Exact = std::array<Rational, 3>;

struct OnlyBaseline {
  OnlyBaseline() { internal::use_baseline_lanes(true); }
  ~OnlyBaseline() { internal::use_baseline_lanes(false); }
};

VVolume random_polynomial(Random& random) {
  std::array<int, 3> degrees;
  const int common = static_cast<int>(random.between(0, 3));  // 0: each axis has its own
  for (int& p : degrees) p = common > 0 ? common : static_cast<int>(random.between(1, 5));
  const Rational scale = Rational(random.between(1, 1000)) / Rational(7);
  VVolume out = v_cells::polynomial(degrees, [&](std::size_t i, std::size_t j, std::size_t k) {
    const auto at = [&](std::size_t n) {
      return scale * (Rational(n) + Rational(random.between(-8, 8)) / Rational(24));
    };
    return v_cells::Point{at(i), at(j), at(k)};
  });
  for (std::size_t a = 0; a < 3; ++a)
    if (random.below(2) == 0) out = insert_knot(out, a, Rational(1) / Rational(3));
  return out;
}

// A cell of a random grid of the volume, exact and rounded.
struct Cell {
  VVolume volume;
  MicroGrid grid;
  std::array<std::size_t, 3> index;
  RoundedCage cage;
  RoundedCell rounded;

  explicit Cell(Random& random)
      : volume(random_polynomial(random)),
        grid(make_micro_grid(volume, 0, {3, 4, 5}).value()),
        index(grid.shape().index_of(random.below(60))),
        cage(volume, grid) {
    std::vector<double> row;
    cage.enter_row(index[0], index[1], row);
    cage.cell(row, index[2], rounded);
  }
  Exact image(const Exact& x) const {
    Exact at;
    for (std::size_t a = 0; a < 3; ++a)
      at[a] = grid.breaks[a][index[a]] +
              x[a] * (grid.breaks[a][index[a] + 1] - grid.breaks[a][index[a]]);
    const auto p = evaluate(volume, at).value();
    return {p[0], p[1], p[2]};
  }
};

TEST(MeshLanes, MapPointsWithinTheBound) {
  const ScopedDefaultFp fp;
  double closest = 0;
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    Random random(seed);
    const Cell cell(random);
    const std::size_t n = 1 + random.below(9);
    PointColumns points;
    points.resize(n);
    for (auto& x : points.at)
      for (std::size_t i = 0; i < n; ++i) x[i] = i == 0 ? 1 : random.unit();
    PointColumns same = points;
    const PointColumns at = points;
    map_points(cell.rounded, n, points);
    {
      const OnlyBaseline baseline;
      map_points(cell.rounded, n, same);
    }
    for (std::size_t i = 0; i < n; ++i) {
      const auto exact =
          cell.image({Rational::from_double(at.at[0][i]), Rational::from_double(at.at[1][i]),
                      Rational::from_double(at.at[2][i])});
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(points.at[c][i], same.at[c][i]) << "seed " << seed;
        const Rational error = abs(Rational::from_double(points.at[c][i]) - exact[c]);
        EXPECT_LE(error, Rational::from_double(cell.cage.value_error())) << "seed " << seed;
        closest = std::max(closest, nearest_double(error) / cell.cage.value_error());
      }
    }
  }
  EXPECT_GT(closest, 0.01);
}

TEST(MeshLanes, BoundsOfRoundedCellsAreThoseOfTheMap) {
  constexpr std::array<std::array<std::size_t, 2>, 6> kPairs = {
      {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
  const ScopedDefaultFp fp;
  const auto length = [](const Exact& v) {
    return std::sqrt(nearest_double(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
  };
  const auto minus = [](const Exact& a, const Exact& b) {
    return Exact{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  };
  double closest = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const Cell cell(random);
    bool is_loose = false;
    const CellMapBounds bounds = cell.cage.bounds(cell.rounded, is_loose);
    const Rational h = Rational(1) / Rational(64);
    Exact x;
    for (Rational& t : x) t = Rational(random.between(0, 62)) / Rational(64);
    const auto moved = [&](std::size_t a, int n, std::size_t b, int m) {
      Exact y = x;
      y[a] += h * Rational(n);
      y[b] += h * Rational(m);
      return cell.image(y);
    };
    const Exact p = cell.image(x);
    for (std::size_t a = 0; a < 3; ++a) {
      const double first = 64 * length(minus(moved(a, 1, a, 0), p));
      EXPECT_LE(first, bounds.first[a] * (1 + 1e-12)) << "seed " << seed;
      closest = std::max(closest, first / bounds.first[a]);
    }
    for (std::size_t k = 0; k < 6; ++k) {
      const auto [a, b] = kPairs[k];
      const Exact second =
          minus(minus(moved(a, 1, b, 1), moved(a, 1, b, 0)), minus(moved(a, 0, b, 1), p));
      EXPECT_LE(64 * 64 * length(second), bounds.second[k] * (1 + 1e-12)) << "seed " << seed;
    }
  }
  EXPECT_GT(closest, 0.5);
}

TEST(MeshLanes, PlacePointsOfPolynomialsOfWallNumbers) {
  const ScopedDefaultFp fp;
  Random random(3);
  constexpr std::size_t kPoints = 11;
  PointTable table;
  table.of_power.resize(3);
  table.wall.assign(kPoints + internal::kSpareLanes, PointTable::kNoWall);
  for (PointColumns& list : table.of_power) {
    list.resize(kPoints);
    for (auto& x : list.at)
      for (std::size_t n = 0; n < kPoints; ++n) x[n] = 0.6 * random.unit();
  }
  for (std::size_t n = 0; n < kPoints; ++n) table.wall[n] = static_cast<std::uint8_t>(n % 7);
  internal::WallParameters t = {0, 0.25, 0.5, 0.75, 1, 0.125, 0};
  PointColumns out, same;
  place_points(table, 2, kPoints, t, out);
  {
    const OnlyBaseline baseline;
    place_points(table, 2, kPoints, t, same);
  }
  for (std::size_t n = 2; n < kPoints; ++n)
    for (std::size_t c = 0; c < 3; ++c) {
      const double x = t[n % 7], one = table.of_power[0].at[c][n], two = table.of_power[1].at[c][n],
                   three = table.of_power[2].at[c][n];
      EXPECT_NEAR(out.at[c][n - 2], std::clamp(one + x * (two + x * three), 0.0, 1.0), 1e-15);
      EXPECT_EQ(out.at[c][n - 2], same.at[c][n - 2]);
    }
}

// One quadrilateral after the other.
std::vector<double> gaps_of(const std::vector<std::array<Vec3d, 4>>& quads) {
  PointColumns points;
  points.resize(4 * quads.size());
  std::vector<std::array<std::uint32_t, 4>> corners;
  for (std::uint32_t q = 0; q < quads.size(); ++q) {
    corners.push_back({4 * q, 4 * q + 1, 4 * q + 2, 4 * q + 3});
    for (std::size_t k = 0; k < 4; ++k)
      for (int c = 0; c < 3; ++c)
        points.at[static_cast<std::size_t>(c)][4 * q + k] = quads[q][k][c];
  }
  const ScopedDefaultFp fp;
  std::vector<double> out(quads.size()), same(quads.size());
  quad_gaps(points, corners.data(), corners.size(), out.data());
  const OnlyBaseline baseline;
  quad_gaps(points, corners.data(), corners.size(), same.data());
  for (std::size_t q = 0; q < quads.size(); ++q)
    EXPECT_EQ(std::memcmp(&out[q], &same[q], sizeof(double)), 0) << q;
  return out;
}

TEST(MeshLanes, GapsAreThoseOfSingleQuadrilaterals) {
  Random random(9);
  std::vector<std::array<Vec3d, 4>> quads;
  for (int n = 0; n < 2003; ++n) {
    std::array<Vec3d, 4> q;
    const double twist = std::ldexp(1.0, -static_cast<int>(random.below(12)));
    for (Vec3d& p : q) p = {3 * random.unit(), 3 * random.unit(), twist * random.unit()};
    q[1].x += 2, q[2].x += 2, q[2].y += 2, q[3].y += 2;
    quads.push_back(q);
  }
  const std::vector<double> gaps = gaps_of(quads);
  const ScopedUpward upward;
  for (std::size_t n = 0; n < quads.size(); ++n) {
    const auto& q = quads[n];
    const double one = quad_gap(q[0], q[1], q[2], q[3], 0);
    EXPECT_NEAR(gaps[n], one, 1e-11 + 1e-9 * one) << n;
  }
}

TEST(MeshLanes, GapsOfPlanesAreRoundingOnly) {
  const std::vector<double> gaps = gaps_of({{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}},
                                            {{{0, 0, 0}, {4, 0, 0}, {3, 1, 0}, {1, 1, 0}}},
                                            {{{0, 0, 1}, {8, 0, 1}, {5, 3, 1}, {0, 1, 1}}},
                                            {{{0, 0, 0}, {1, 0, 0}, {0.25, 0.25, 0}, {0, 1, 0}}},
                                            {{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}}}});
  EXPECT_LE(gaps[0], 1e-14);
  EXPECT_LE(gaps[1], 1e-14);
  EXPECT_LE(gaps[2], 1e-13);
  EXPECT_GT(gaps[3], 0.1) << "not convex";
  EXPECT_GE(gaps[4], 0.25);
  EXPECT_LE(gaps[4], 0.25 + 1e-12);
}

// The middle of the bilinear patch is no nearer to the triangles than to their planes, exactly.
TEST(MeshLanesLaw, GapsOfAlmostFlatQuadrilateralsAreNeverTooSmall) {
  const auto exact = [](const Vec3d& p) {
    return Exact{Rational::from_double(p.x), Rational::from_double(p.y),
                 Rational::from_double(p.z)};
  };
  const auto minus = [](const Exact& a, const Exact& b) {
    return Exact{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  };
  const auto dot = [](const Exact& a, const Exact& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const auto cross = [](const Exact& a, const Exact& b) {
    return Exact{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  Random random(10);
  std::vector<std::array<Vec3d, 4>> quads;
  for (int n = 0; n < 400; ++n) {
    double m[3][2];
    for (auto& row : m)
      for (double& x : row) x = 2 * random.unit() - 1;
    const double s = 0.2 + random.unit(), t = 0.2 + random.unit();
    std::array<Vec3d, 4> q;  // two sides are parallel
    const double at[4][2] = {{0, 0}, {1, 0}, {s, t}, {0, t}};
    for (std::size_t k = 0; k < 4; ++k)
      q[k] = {100 + m[0][0] * at[k][0] + m[0][1] * at[k][1],
              m[1][0] * at[k][0] + m[1][1] * at[k][1], m[2][0] * at[k][0] + m[2][1] * at[k][1]};
    quads.push_back(q);
  }
  const std::vector<double> gaps = gaps_of(quads);
  int flat = 0;
  for (std::size_t n = 0; n < quads.size(); ++n) {
    std::array<Exact, 4> p;
    for (std::size_t k = 0; k < 4; ++k) p[k] = exact(quads[n][k]);
    Exact middle;
    for (std::size_t c = 0; c < 3; ++c)
      middle[c] = (p[0][c] + p[1][c] + p[2][c] + p[3][c]) / Rational(4);
    const Rational bound = Rational::from_double(gaps[n]);
    bool is_near = false;
    for (const std::size_t k : {std::size_t{1}, std::size_t{3}}) {
      const Exact normal = cross(minus(p[k], p[0]), minus(p[2], p[0]));
      const Rational d = dot(normal, minus(middle, p[0]));
      is_near = is_near || d * d <= bound * bound * dot(normal, normal);
    }
    EXPECT_TRUE(is_near) << n << ": " << gaps[n];
    flat += gaps[n] < 1e-12 ? 1 : 0;
  }
  EXPECT_GT(flat, 300);
}

}  // namespace
}  // namespace veritope
