// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "interval/upward.h"
#include "robust/base/random.h"
#include "solids/micro/mesh/cage_cells_internal.h"
#include "solids/micro/mesh/patch_bend_internal.h"
#include "solids/micro/mesh/quad_gap_internal.h"
#include "solids/micro/micro_grid.h"
#include "splines/de_boor.h"
#include "splines/de_casteljau.h"
#include "tests/support/approx_distance.h"
#include "tests/support/v_cells.h"

namespace veritope {
namespace {

using internal::CageCells;
using internal::CageRow;
using internal::CellMap;
using internal::CellMapBounds;
using internal::PatchBend;
using internal::quad_gap;
using Exact = std::array<Rational, 3>;

double gap(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  const ScopedUpward upward;
  return quad_gap(a, b, c, d, 0);
}

TEST(QuadGap, VanishesInPlanes) {
  EXPECT_EQ(gap({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}), 0);
  EXPECT_LE(gap({0, 0, 0}, {4, 0, 0}, {3, 1, 0}, {1, 1, 0}), 1e-15);
  EXPECT_LE(gap({0, 0, 1}, {8, 0, 1}, {5, 3, 1}, {0, 1, 1}), 1e-14);
}
TEST(QuadGap, IsAQuarterOfTheTwistOverASquare) {
  // The bilinear patch z = x y, and its triangles: 1/4 at the middle of the square.
  EXPECT_EQ(gap({0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}), 0.25);
}
TEST(QuadGap, DoesNotTakeAQuadrilateralThatIsNotConvexForAFlatOne) {
  // The corner c lies inside of the triangle a, b, d; then beyond a.
  EXPECT_GT(gap({0, 0, 0}, {1, 0, 0}, {0.25, 0.25, 0}, {0, 1, 0}), 0.1);
  EXPECT_GT(gap({0, 0, 0}, {1, 0, 0}, {-0.5, -0.5, 0}, {0, 1, 0}), 0.1);
  EXPECT_GT(gap({0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}), 0);  // on a line
}
TEST(QuadGap, BoundsTheDistanceOfRandomPatches) {
  Random random(11);
  double closest = 0;
  for (int round = 0; round < 5000; ++round) {
    std::array<Vec3d, 4> q;
    const double twist = std::ldexp(1.0, -static_cast<int>(random.below(12)));
    for (Vec3d& p : q) p = {2 * random.unit(), 2 * random.unit(), twist * random.unit()};
    q[1].x += 2, q[2].x += 2, q[2].y += 2, q[3].y += 2;
    const double bound = gap(q[0], q[1], q[2], q[3]);
    const auto on_patch = [&](double u, double v, double Vec3d::*c) {
      return (1 - u) * (1 - v) * q[0].*c + u * (1 - v) * q[1].*c + u * v * q[2].*c +
             (1 - u) * v * q[3].*c;
    };
    for (int sample = 0; sample < 20; ++sample) {
      const double u = random.unit(), v = random.unit();
      const Vec3d p = {on_patch(u, v, &Vec3d::x), on_patch(u, v, &Vec3d::y),
                       on_patch(u, v, &Vec3d::z)};
      const double least = std::min(approx::distance_to_triangle(p, q[0], q[1], q[2]),
                                    approx::distance_to_triangle(p, q[0], q[2], q[3]));
      EXPECT_LE(least, bound + 1e-14) << "round " << round;
      closest = std::max(closest, least / bound);
    }
  }
  EXPECT_GT(closest, 0.5);
}

VVolume random_volume(Random& random) {
  const auto number = [&] { return Rational(random.between(-8, 8)) / Rational(24); };
  std::array<int, 3> degrees;
  for (int& p : degrees) p = static_cast<int>(random.between(1, 3));
  const auto point = [&](std::size_t i, std::size_t j, std::size_t k) {
    return v_cells::Point{Rational(i) + number(), Rational(j) + number(), Rational(k) + number()};
  };
  VVolume out = random.below(2) == 0
                    ? v_cells::polynomial(degrees, point)
                    : v_cells::rational(degrees, point, [&](std::size_t, std::size_t, std::size_t) {
                        return Rational(random.between(2, 6)) / Rational(3);
                      });
  for (std::size_t a = 0; a < 3; ++a)
    if (random.below(2) == 0) out = insert_knot(out, a, Rational(1) / Rational(3));
  return out;
}
Exact point_of(const VVolume& volume, const Exact& at) {
  const auto image = evaluate(volume, at).value();
  Exact out;
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = volume.is_rational() ? image[c] / image[3] : image[c];
  return out;
}
double length_of(const Exact& v) {
  return std::sqrt(nearest_double(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
}
Exact combined(const Exact& a, int s, const Exact& b, int t, const Exact& c, int r) {
  Exact out;
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = Rational(s) * a[k] + Rational(t) * b[k] + Rational(r) * c[k];
  return out;
}

TEST(PatchBend, BoundsSecondDifferencesOfMappedPatches) {
  double closest = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const VVolume volume = random_volume(random);
    const MicroGrid grid = make_micro_grid(volume, 0, {3, 3, 3}).value();
    TilePatch patch;
    patch.degrees = {static_cast<int>(random.between(1, 3)),
                     static_cast<int>(random.between(1, 3))};
    patch.points.resize(random.below(3) + 1);
    if (patch.points.size() > 1) patch.wall = 0;
    // In the unit cube for all numbers up to 1/4: coordinates in [1/4, 1/2] + t [0, 1] + t^2 [0, 1].
    for (std::size_t power = 0; power < patch.points.size(); ++power)
      for (std::size_t n = 0; n < patch.num_points(); ++n) {
        const auto number = [&] {
          const Rational x = Rational(random.between(0, 64)) / Rational(64);
          return power == 0 ? (x + Rational(1)) / Rational(4) : x;
        };
        patch.points[power].push_back({number(), number(), number()});
      }
    const auto wall = static_cast<std::int32_t>(random.between(0, kMaxWallNumber / 4));
    BezierSurface<Rational> surface(patch.degrees, 3, false);
    const auto net = points_at(patch, wall);
    for (std::size_t n = 0; n < net.size(); ++n)
      for (std::size_t c = 0; c < 3; ++c) surface.component(static_cast<int>(c))[n] = net[n][c];
    const auto index = grid.shape().index_of(random.below(27));
    const auto image = [&](const std::array<Rational, 2>& uv) {
      const auto local = evaluate<Rational, 2>(surface, uv);
      Exact at;
      for (std::size_t a = 0; a < 3; ++a)
        at[a] = grid.breaks[a][index[a]] +
                local[a] * (grid.breaks[a][index[a] + 1] - grid.breaks[a][index[a]]);
      return point_of(volume, at);
    };
    std::array<double, 2> bound;
    {
      const ScopedUpward upward;
      const CageCells cells(volume, grid);
      CageRow row;
      CellMap map = cells.new_map();
      cells.enter_row(index[0], index[1], row);
      cells.cell(row, index[2], map);
      bound = PatchBend(patch).of(map.bounds(2), Interval(wall * 0x1p-20));
    }
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (int i = 0; i < 8; ++i) {
        std::array<Rational, 2> uv;
        for (Rational& x : uv) x = Rational(random.between(1, 31)) / Rational(32);
        auto before = uv, after = uv;
        before[axis] -= Rational(1) / Rational(32);
        after[axis] += Rational(1) / Rational(32);
        const double second =
            32 * 32 * length_of(combined(image(before), 1, image(uv), -2, image(after), 1));
        EXPECT_LE(second, 8 * bound[axis] * (1 + 1e-12) + 1e-12) << seed;
        if (bound[axis] > 0) closest = std::max(closest, second / (8 * bound[axis]));
      }
  }
  EXPECT_GT(closest, 0.3);
}

TEST(CageCells, EncloseValuesAndBoundDifferenceQuotients) {
  constexpr std::array<std::array<std::size_t, 2>, 6> kPairs = {
      {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const VVolume volume = random_volume(random);
    const MicroGrid grid = make_micro_grid(volume, 0, {3, 4, 5}).value();
    const std::size_t cell = random.below(60);
    const auto index = grid.shape().index_of(cell);
    const auto in_cell = [&](const Exact& x) {
      Exact at;
      for (std::size_t a = 0; a < 3; ++a)
        at[a] = grid.breaks[a][index[a]] +
                x[a] * (grid.breaks[a][index[a] + 1] - grid.breaks[a][index[a]]);
      return point_of(volume, at);
    };
    const Rational h = Rational(1) / Rational(64);
    Exact x;
    for (Rational& t : x) t = Rational(random.between(0, 62)) / Rational(64);
    std::vector<CellMapBounds> bounds;
    Box3 value;
    {
      const ScopedUpward upward;
      const CageCells cells(volume, grid);
      CageRow row;
      CellMap map = cells.new_map();
      cells.enter_row(index[0], index[1], row);
      cells.cell(row, index[2], map);
      value = map.value(Box3(enclose(x[0]), enclose(x[1]), enclose(x[2])));
      for (const int depth : {0, 1, 3}) bounds.push_back(map.bounds(depth));
    }
    const Exact p = in_cell(x);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_TRUE(contains(value[c], p[c])) << seed;
      EXPECT_LE(wid(value[c]), 1e-13) << seed;
    }
    const auto moved = [&](std::size_t a, int n, std::size_t b, int m) {
      Exact y = x;
      y[a] += h * Rational(n);
      y[b] += h * Rational(m);
      return in_cell(y);
    };
    for (std::size_t d = 0; d < bounds.size(); ++d) {
      const CellMapBounds& bound = bounds[d];
      for (std::size_t a = 0; a < 3; ++a)
        EXPECT_LE(64 * length_of(combined(moved(a, 1, a, 0), 1, p, -1, p, 0)),
                  bound.first[a] * (1 + 1e-12))
            << seed;
      for (std::size_t k = 0; k < 6; ++k) {
        const auto [a, b] = kPairs[k];
        const Exact second =
            combined(combined(moved(a, 1, b, 1), 1, moved(a, 1, b, 0), -1, moved(a, 0, b, 1), -1),
                     1, p, 1, p, 0);
        EXPECT_LE(64 * 64 * length_of(second), bound.second[k] * (1 + 1e-12)) << seed;
        EXPECT_LE(bound.second[k], bounds[d > 0 ? d - 1 : 0].second[k]) << seed;
      }
    }
  }
}

}  // namespace
}  // namespace veritope
