// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/compose/composed_surface.h"

#include <gtest/gtest.h>

#include <map>

#include "solids/micro/micro_topology.h"
#include "splines/bezier_calculus.h"
#include "splines/bezier_product.h"
#include "splines/de_boor.h"
#include "tests/support/micro_cells.h"
#include "tests/support/random_microstructures.h"

namespace veritope {
namespace {

using micro_cells::box_tile;
using micro_cells::full;
using v_cells::cube;

struct Composed {
  explicit Composed(const Microstructure& m)
      : micro(m), cage(make_v_model(m.cage, VOrientation::kAuto).value()) {
    for (const MicroTile& t : m.tiles) tiles.push_back(std::get<AnalysedTile>(analyse_tile(t)));
  }
  ComposedSurface surface() const { return ComposedSurface::make(micro, cage, tiles).value(); }

  const Microstructure& micro;
  VModel cage;
  std::vector<AnalysedTile> tiles;
};

using Corner = std::array<Rational, 3>;
Corner point_at(const BezierSurface<Rational>& s, const Rational& u, const Rational& v) {
  const std::vector<Rational> p = point(s, std::array<Rational, 2>{u, v});
  return {p[0], p[1], p[2]};
}

// Each side of a patch that is not a point belongs to two patches; sides are known by their ends and their middles.
void expect_closed(const ComposedSurface& surface, const std::string& what) {
  std::map<std::array<Corner, 3>, int> sides;
  std::uint64_t patches = 0, points = 0;
  const Rational zero, one(1), half = Rational(1) / Rational(2);
  for (const auto& of_cell : surface.compose(0, surface.cells().size()))
    for (const ComposedPatch& p : of_cell) {
      ++patches;
      points += p.surface.grid().count();
      const std::array<std::array<Rational, 2>, 4> corner = {
          {{zero, zero}, {one, zero}, {one, one}, {zero, one}}};
      for (std::size_t s = 0; s < 4; ++s) {
        const auto &from = corner[s], &to = corner[(s + 1) % 4];
        Corner a = point_at(p.surface, from[0], from[1]), b = point_at(p.surface, to[0], to[1]);
        const Corner m = point_at(p.surface, half * (from[0] + to[0]), half * (from[1] + to[1]));
        if (a == b && b == m) continue;
        // Neighbours pass it in opposite directions.
        const bool is_forward = a < b;
        if (!is_forward) std::swap(a, b);
        sides[{a, m, b}] += is_forward ? 1 : 1000;
      }
    }
  EXPECT_EQ(patches, surface.num_patches()) << what;
  EXPECT_EQ(points, surface.num_points()) << what;
  for (const auto& [side, count] : sides)
    EXPECT_TRUE(count == 1001 || side[0] == side[2]) << what << ": " << count;
}

TEST(ComposedSurface, IsClosedAndTurnsOutward) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 60 && compared < 8; ++seed) {
    Random random(seed);
    const random_micro::Structure s = random_micro::any_structure(random);
    std::size_t cells = 0;
    bool is_light = true;
    for (const MicroGrid& g : s.micro.grids) cells += g.tiles.size();
    for (const VVolume& v : s.micro.cage)
      is_light = is_light && v.axis(0).degree + v.axis(1).degree + v.axis(2).degree <= 5;
    if (cells > 24 || !is_light) continue;
    ++compared;
    const Composed composed(s.micro);
    expect_closed(composed.surface(), "seed " + std::to_string(seed) + ": " + s.description);
  }
  EXPECT_GE(compared, 3);
}

TEST(ComposedSurface, PatchesAreTheMapAfterTheTile) {
  JackShape shape;
  shape.degree = 3;
  shape.range = {{kMaxWallNumber / 10, kMaxWallNumber / 5}};
  const VVolume bent = v_cells::mapped(cube(0, 0, 0), [](const v_cells::Point& p) {
    return v_cells::Point{p[0] + p[1] * p[2] / Rational(4), p[1], p[2] - p[0] / Rational(3)};
  });
  for (const VVolume& volume : {bent, v_cells::with_factor(bent, Rational(2)), reversed(bent, 1)}) {
    const Microstructure micro =
        full({volume}, {2, 1, 2}, jack_tile(shape).value(), kMaxWallNumber / 7);
    const Composed composed(micro);
    const ComposedSurface surface = composed.surface();
    const bool is_left = composed.cage.hand(0) == Sign::kNegative;
    ASSERT_EQ(surface.cells().size(), 4u);
    // 30 patches a jack, and 4 pairs of caps.
    EXPECT_EQ(surface.num_patches(), 4u * 30 - 2 * 4);
    const auto patches = surface.compose(1, 2).front();
    for (const ComposedPatch& p : patches)
      for (int n = 0; n < 4; ++n) {
        const Rational u = Rational(n) / Rational(3), v = Rational(5 - n) / Rational(7);
        const TilePatch& patch = micro.tiles[0].patches[p.patch];
        BezierSurface<Rational> inner(patch.degrees, 3, false);
        const auto points = points_at(patch, kMaxWallNumber / 7);
        for (std::size_t i = 0; i < points.size(); ++i)
          for (std::size_t a = 0; a < 3; ++a)
            inner.component(static_cast<int>(a))[i] = points[i][a];
        const Corner x = point_at(inner, is_left ? Rational(1) - u : u, v);
        // Cell (0, 0, 1) of 2 x 1 x 2 cells.
        const std::array<Rational, 3> at = {x[0] / Rational(2), x[1],
                                            (x[2] + Rational(1)) / Rational(2)};
        const auto truth = point(volume, at).value();
        EXPECT_EQ(point_at(p.surface, u, v), (Corner{truth[0], truth[1], truth[2]}));
      }
  }
}

TEST(ComposedSurface, EqualCapsAreLeftOut) {
  Microstructure micro = full({cube(0, 0, 0)}, {1, 1, 2}, box_tile({8, 8, 0}, {56, 56, 64}));
  const Composed composed(micro);
  EXPECT_EQ(composed.surface().num_patches(), 10u);
  expect_closed(composed.surface(), "two boxes");
  for (std::uint8_t& t : micro.grids[0].tiles) t = 0;
  const Composed empty(micro);
  EXPECT_EQ(empty.surface().num_patches(), 0u);
  EXPECT_TRUE(empty.surface().compose(0, 0).empty());
}

TEST(ComposedSurface, DegreesBeyondThoseOfSplinesAreRefused) {
  JackShape shape;
  shape.degree = 3;
  VVolume high = cube(0, 0, 0);
  for (std::size_t a = 0; a < 3; ++a) high = elevate(high, a, 7);  // 24 in all, times 3
  const Microstructure micro = full({high}, {1, 1, 1}, jack_tile(shape).value());
  const Composed composed(micro);
  const auto found = ComposedSurface::make(micro, composed.cage, composed.tiles);
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().code, Code::kOverLimit);
  EXPECT_NE(found.error().message.find("degree 72"), std::string::npos) << found.error().message;
}

}  // namespace
}  // namespace veritope
