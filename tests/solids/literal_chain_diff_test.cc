// SPDX-License-Identifier: LGPL-3.0-or-later
// The f of the literal chain against a slow oracle in doubles: planes from a table of chords, patches as many small
// triangles. It shares nothing with solids/chain, and has no answer near walls.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "solids/chain/literal_chain.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

constexpr std::uint64_t kSeed = 20261127;
constexpr std::size_t kGrid = 32;
constexpr double kMargin = 2e-3;

Point3d sub(const Point3d& a, const Point3d& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot_of(const Point3d& a, const Point3d& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point3d cross_of(const Point3d& a, const Point3d& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Point3d& a) { return std::sqrt(dot_of(a, a)); }
Point3d scaled(double s, const Point3d& a) { return {s * a[0], s * a[1], s * a[2]}; }

using Triangle3 = std::array<Point3d, 3>;
using Plane2 = std::array<double, 2>;

double cross2(const Plane2& a, const Plane2& b, const Plane2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
double distance2(const Plane2& q, const Plane2& a, const Plane2& b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1], l = dx * dx + dy * dy;
  const double t = l == 0 ? 0 : std::clamp(((q[0] - a[0]) * dx + (q[1] - a[1]) * dy) / l, 0.0, 1.0);
  return std::hypot(a[0] + t * dx - q[0], a[1] + t * dy - q[1]);
}

// A base with the patch over it, as triangles between the points of a grid and as the polygon of its sides.
struct OracleCell {
  Triangle3 base{};
  Point3d normal{}, unit{}, u{}, v{};  // u, v, unit: a frame
  std::array<Point3d, 3> walls{};      // unit normals to the base's side
  std::vector<Triangle3> pieces;
  std::vector<Point3d> border;

  Plane2 flat(const Point3d& p) const {
    return {dot_of(u, sub(p, base[0])), dot_of(v, sub(p, base[0]))};
  }
  double height(const Point3d& p) const { return dot_of(unit, sub(p, base[0])); }
};

using ChordKey = std::array<long, 3>;
ChordKey key_of(const Point3d& p) {
  return {std::lround(p[0] * 1e9), std::lround(p[1] * 1e9), std::lround(p[2] * 1e9)};
}
std::pair<ChordKey, ChordKey> chord_of(const OracleCell& c, std::size_t k) {
  return std::minmax(key_of(c.base[k]), key_of(c.base[(k + 1) % 3]));
}

// The triangle with these corners in the parameters of the patch, cut by a grid.
OracleCell cell_over(const Patch& patch, const std::array<std::array<int, 2>, 3>& corners) {
  const auto at = [&](std::size_t i, std::size_t j) {
    std::array<Rational, 2> st;
    for (std::size_t k = 0; k < 2; ++k)
      st[k] = (Rational(kGrid - i - j) * Rational(corners[0][k]) +
               Rational(i) * Rational(corners[1][k]) + Rational(j) * Rational(corners[2][k])) /
              Rational(kGrid);
    if (!patch.is_triangle()) return approx_point(evaluate<Rational, 2>(patch.tensor(), st));
    return approx_point(
        evaluate<Rational>(patch.triangle(), {Rational(1) - st[0] - st[1], st[0], st[1]}));
  };
  std::vector<std::vector<Point3d>> grid(kGrid + 1);
  for (std::size_t i = 0; i <= kGrid; ++i)
    for (std::size_t j = 0; i + j <= kGrid; ++j) grid[i].push_back(at(i, j));
  OracleCell c;
  c.base = {grid[0][0], grid[kGrid][0], grid[0][kGrid]};
  c.normal = cross_of(sub(c.base[1], c.base[0]), sub(c.base[2], c.base[0]));
  c.unit = scaled(1 / length(c.normal), c.normal);
  c.u = sub(c.base[1], c.base[0]);
  c.u = scaled(1 / length(c.u), c.u);
  c.v = cross_of(c.unit, c.u);
  for (std::size_t i = 0; i < kGrid; ++i)
    for (std::size_t j = 0; i + j < kGrid; ++j) {
      c.pieces.push_back({grid[i][j], grid[i + 1][j], grid[i][j + 1]});
      if (i + j + 2 <= kGrid)
        c.pieces.push_back({grid[i + 1][j], grid[i + 1][j + 1], grid[i][j + 1]});
    }
  for (std::size_t i = 0; i < kGrid; ++i) c.border.push_back(grid[i][0]);
  for (std::size_t i = 0; i < kGrid; ++i) c.border.push_back(grid[kGrid - i][i]);
  for (std::size_t i = 0; i < kGrid; ++i) c.border.push_back(grid[0][kGrid - i]);
  return c;
}

std::vector<OracleCell> oracle_of(const Patches& patches) {
  std::vector<OracleCell> out;
  for (const Patch& patch : patches)
    if (patch.is_triangle()) {
      out.push_back(cell_over(patch, {{{0, 0}, {1, 0}, {0, 1}}}));
    } else {
      out.push_back(cell_over(patch, {{{0, 0}, {1, 0}, {1, 1}}}));
      out.push_back(cell_over(patch, {{{0, 0}, {1, 1}, {0, 1}}}));
    }
  std::map<std::pair<ChordKey, ChordKey>, Point3d> sums;
  for (const OracleCell& c : out)
    for (std::size_t k = 0; k < 3; ++k) {
      Point3d& sum = sums[chord_of(c, k)];
      for (std::size_t i = 0; i < 3; ++i) sum[i] += c.normal[i];
    }
  for (OracleCell& c : out)
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3d m = cross_of(sums[chord_of(c, k)], sub(c.base[(k + 1) % 3], c.base[k]));
      const bool is_inward = dot_of(m, sub(c.base[(k + 2) % 3], c.base[k])) > 0;
      c.walls[k] = scaled((is_inward ? 1 : -1) / length(m), m);
    }
  return out;
}

std::optional<int> simplex_value(const OracleCell& c, const Point3d& q, const Point3d& o) {
  const std::array<Point3d, 4> v{o, c.base[0], c.base[1], c.base[2]};
  double least = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point3d &a = v[(i + 1) % 4], &b = v[(i + 2) % 4], &d = v[(i + 3) % 4];
    const Point3d n = cross_of(sub(b, a), sub(d, a));
    least = std::min(least, dot_of(n, sub(q, a)) / dot_of(n, sub(v[i], a)));
  }
  if (std::abs(least) < 1e-6) return std::nullopt;
  return least < 0 ? 0 : c.height(o) < 0 ? 1 : -1;
}

std::optional<int> cell_value(const OracleCell& c, const Point3d& q) {
  double least = 1;
  for (std::size_t k = 0; k < 3; ++k)
    least = std::min(least, dot_of(c.walls[k], sub(q, c.base[k])));
  if (least < -kMargin) return 0;
  const Plane2 at = c.flat(q);
  const double h = c.height(q);
  double beside = 1, reach = 0;
  for (std::size_t i = 0; i < c.border.size(); ++i)
    beside = std::min(
        beside, distance2(at, c.flat(c.border[i]), c.flat(c.border[(i + 1) % c.border.size()])));
  bool is_held = false, is_near = std::abs(h) < kMargin || beside < kMargin || least < kMargin;
  for (const Triangle3& t : c.pieces) {
    const Plane2 a = c.flat(t[0]), b = c.flat(t[1]), d = c.flat(t[2]);
    const double area = cross2(a, b, d);
    const double gap = std::min({distance2(at, a, b), distance2(at, b, d), distance2(at, d, a)});
    const double wa = cross2(at, b, d) / area, wb = cross2(a, at, d) / area,
                 wd = cross2(a, b, at) / area;
    if (gap < kMargin && std::abs(area) < 0.1 * length(cross_of(sub(t[1], t[0]), sub(t[2], t[0]))))
      is_near = true;
    if (!(wa >= 0 && wb >= 0 && wd >= 0)) continue;
    const double z = wa * c.height(t[0]) + wb * c.height(t[1]) + wd * c.height(t[2]);
    reach = std::max(reach, std::abs(z));
    is_near = is_near || std::abs(z - h) < kMargin;
    is_held = is_held || (h > 0 ? z > h : z < h);
  }
  // Far from the patch nothing is held, whatever is near.
  if (beside > kMargin && reach + kMargin < std::abs(h)) return 0;
  if (is_near) return std::nullopt;
  return !is_held ? 0 : h > 0 ? 1 : -1;
}

// f; nothing near a wall.
std::optional<int> oracle_value(const std::vector<OracleCell>& cells, const Point3d& q,
                                const Point3d& origin) {
  int f = 0;
  for (const OracleCell& c : cells) {
    const auto simplex = simplex_value(c, q, origin), cell = cell_value(c, q);
    if (!simplex || !cell) return std::nullopt;
    f += *simplex + *cell;
  }
  return f;
}

TEST(LiteralChainDiff, AgreesWithASlowOracleInDoubles) {
  Random random(kSeed);
  const ExactPoint origin{Rational(1) / Rational(97), Rational(1) / Rational(89),
                          Rational(-1) / Rational(83)};
  const Point3d rounded{1.0 / 97, 1.0 / 89, -1.0 / 83};
  const std::vector<std::pair<Patches, Point3d>> models = {
      {patch_shapes::pn_torus(12, 8), {4.2, 4.2, 1.2}},
      {patch_shapes::sphere(), {1.1, 1.1, 1.1}},
      {patch_shapes::torus(3, 1), {4.2, 4.2, 1.2}}};
  for (const auto& [patches, reach] : models) {
    const PatchComplex complex = complex_of(patches);
    const LiteralChain chain(complex);
    const std::vector<OracleCell> oracle = oracle_of(patches);
    int known = 0, in_cells = 0;
    for (int i = 0; i < 400; ++i) {
      Point3d q;
      ExactPoint exact;
      for (std::size_t k = 0; k < 3; ++k) {
        q[k] = (2 * random.unit() - 1) * reach[k];
        exact[k] = Rational::from_double(q[k]);
      }
      // Half of the points between a base and its patch.
      if (i % 2 == 0) {
        const OracleCell& c = oracle[random.below(oracle.size())];
        const Point3d& p = c.pieces[random.below(c.pieces.size())][0];
        const double t = random.unit() * 1.2 - 0.1;
        for (std::size_t k = 0; k < 3; ++k) {
          q[k] = p[k] - t * c.height(p) * c.unit[k];
          exact[k] = Rational::from_double(q[k]);
        }
      }
      const auto f = oracle_value(oracle, q, rounded);
      if (!f) continue;
      ++known;
      EXPECT_EQ(chain.value(exact, origin).f, f)
          << "seed " << kSeed << " point " << q[0] << " " << q[1] << " " << q[2];
      for (const OracleCell& c : oracle) in_cells += cell_value(c, q).value_or(0) != 0 ? 1 : 0;
    }
    EXPECT_GT(known, 150);
    EXPECT_GT(in_cells, 20);
  }
}

}  // namespace
}  // namespace veritope
