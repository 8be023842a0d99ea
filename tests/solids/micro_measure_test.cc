// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/measure/micro_volume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "interval/numeric.h"
#include "interval/relations.h"
#include "interval/upward.h"
#include "solids/micro/measure/cage_scale.h"
#include "solids/micro/measure/gauss_rule_internal.h"
#include "solids/micro/measure/tile_moments_internal.h"
#include "solids/micro/mesh/micro_mesh.h"
#include "solids/micro/tile_analysis.h"
#include "solids/polyhedron/validity.h"
#include "solids/volumes/primitives.h"
#include "splines/bezier_calculus.h"
#include "splines/bezier_product.h"
#include "splines/composition_span.h"
#include "splines/de_boor.h"
#include "tests/support/micro_cells.h"
#include "tests/support/random_microstructures.h"

namespace veritope {
namespace {

using micro_cells::box_tile;
using micro_cells::full;
using v_cells::cube;

Rational ratio(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }

Result<MicroVolume> measure(const Microstructure& micro, unsigned jobs = 1) {
  return volume_of(micro, make_v_model(micro.cage, VOrientation::kAuto).value(), jobs);
}

// The truth, slowly: each patch of each tile is composed, and the flux of x / 3 through it integrated, in fractions.
Rational exact_volume(const Microstructure& micro) {
  const VModel cage = make_v_model(micro.cage, VOrientation::kAuto).value();
  Rational sum;
  for (const MicroGrid& grid : micro.grids) {
    const Grid<3> shape = grid.shape();
    for (std::size_t c = 0; c < grid.tiles.size(); ++c) {
      if (grid.tiles[c] == 0) continue;
      const auto cell = shape.index_of(c);
      const WallNumbers numbers = grid.numbers_of(cell);
      for (const TilePatch& patch : micro.tiles[grid.tiles[c] - 1u].patches) {
        BezierSurface<Rational> inner(patch.degrees, 3, false);
        const auto points = points_at(patch, number_of(patch, numbers));
        for (std::size_t n = 0; n < points.size(); ++n)
          for (std::size_t a = 0; a < 3; ++a) {
            const Rational &low = grid.breaks[a][cell[a]], &high = grid.breaks[a][cell[a] + 1];
            inner.component(static_cast<int>(a))[n] = low + points[n][a] * (high - low);
          }
        const auto x = compose_on_span(micro.cage[grid.volume], inner).value();
        const Rational flux = integral(dot(x, cross(derivative(x, 0), derivative(x, 1))))[0];
        sum = cage.hand(grid.volume) == Sign::kNegative ? sum - flux : sum + flux;
      }
    }
  }
  return sum / Rational(3);
}

double relative_width(const Interval& x) { return wid(x) / mag(x); }

void expect_volume(const Interval& x, const Rational& truth, const std::string& what) {
  EXPECT_TRUE(contains(x, truth)) << what << ": " << to_string(x) << " is not "
                                  << nearest_double(truth);
  EXPECT_LE(relative_width(x), 1e-9) << what << ": " << to_string(x);
}

TEST(GaussRule, IntegratesPolynomialsOfTheDegreeThatItPromises) {
  const ScopedUpward upward;
  for (const std::size_t n : {1u, 2u, 3u, 7u, 20u, 41u, 80u}) {
    const internal::GaussRule& rule = internal::gauss_rule(n);
    for (std::size_t d = 0; d < 2 * n; d += n < 10 ? 1 : 3) {
      Interval sum;
      for (std::size_t i = 0; i < n; ++i) {
        Interval power = rule.weights[i];
        for (std::size_t k = 0; k < d; ++k) power *= rule.nodes[i];
        sum += power;
      }
      const Rational truth = d % 2 == 1 ? Rational() : ratio(2, static_cast<std::int64_t>(d) + 1);
      EXPECT_TRUE(contains(sum, truth)) << n << " nodes, degree " << d;
      EXPECT_LE(wid(sum), 1e-13) << n << " nodes, degree " << d;
    }
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_LE(wid(rule.nodes[i]), 0x1p-52);
      EXPECT_LE(relative_width(rule.weights[i]), 0x1p-51);
    }
  }
}

TEST(TileMoments, ThoseOfABoxAreProductsOfIntegrals) {
  const ScopedUpward upward;
  const internal::TileMoments moments(box_tile({16, 8, 0}, {48, 64, 16}), 4);
  std::vector<Interval> found;
  moments.at({}, found);
  const auto indices = internal::moment_indices(4);
  ASSERT_EQ(found.size(), indices.size());
  ASSERT_EQ(internal::num_moments(4), indices.size());
  // Primitives of P_0(2x - 1), P_1, ..., in powers of x.
  const auto primitive = [](std::size_t k, const Rational& x) {
    const Rational x2 = x * x, x3 = x2 * x, x4 = x3 * x, x5 = x4 * x;
    return k == 0   ? x
           : k == 1 ? x2 - x
           : k == 2 ? Rational(2) * x3 - Rational(3) * x2 + x
           : k == 3
               ? Rational(5) * x4 - Rational(10) * x3 + Rational(6) * x2 - x
               : Rational(14) * x5 - Rational(35) * x4 + Rational(30) * x3 - Rational(10) * x2 + x;
  };
  const std::array<std::array<Rational, 2>, 3> box = {
      {{ratio(1, 4), ratio(3, 4)}, {ratio(1, 8), Rational(1)}, {Rational(), ratio(1, 4)}}};
  for (std::size_t m = 0; m < found.size(); ++m) {
    Rational truth(1);
    for (std::size_t a = 0; a < 3; ++a)
      truth *= primitive(indices[m][a], box[a][1]) - primitive(indices[m][a], box[a][0]);
    EXPECT_TRUE(contains(found[m], truth)) << m;
    EXPECT_LE(wid(found[m]), 1e-14) << m;
  }
}

TEST(MicroVolume, AJackInACubeHasTheVolumeOfItsFrusta) {
  JackShape shape;
  shape.degree = 1;
  shape.node = ratio(1, 4);
  shape.cap = ratio(1, 8);
  const Microstructure micro = full({cube(0, 0, 0)}, {3, 2, 1}, jack_tile(shape).value());
  const MicroVolume v = measure(micro).value();
  // A cube of 1/2 and six frusta of length 1/4 from squares of 1/2 to 1/4, in each cell.
  const Rational jack = ratio(1, 8) + Rational(6) * ratio(1, 4) *
                                          (ratio(1, 4) + ratio(1, 8) + ratio(1, 16)) / Rational(3);
  expect_volume(v.tiles, jack, "tiles");
  expect_volume(v.cells, Rational(1), "cells");
  expect_volume(v.density, jack, "density");
}

TEST(MicroVolume, PolynomialCagesAgreeWithCompositionInFractions) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const random_micro::Structure s = random_micro::any_structure(random);
    std::size_t cells = 0;
    bool is_polynomial = true;
    int degree = 0;
    for (const MicroGrid& g : s.micro.grids)
      for (const std::uint8_t t : g.tiles) cells += t != 0;
    for (const VVolume& v : s.micro.cage) {
      is_polynomial = is_polynomial && !v.is_rational();
      for (std::size_t a = 0; a < 3; ++a) degree += v.axis(a).degree;
    }
    if (!is_polynomial || cells == 0 || cells > 24 ||
        degree > 5 * static_cast<int>(s.micro.cage.size()))
      continue;
    ++compared;
    const Rational truth = exact_volume(s.micro);
    const MicroVolume v = measure(s.micro).value();
    expect_volume(v.tiles, truth, "seed " + std::to_string(seed) + ": " + s.description);
  }
  EXPECT_GE(compared, 3);
}

// A cubic cage with a knot inside.
VVolume bent_cage() {
  VVolume out = v_cells::polynomial({3, 2, 3}, [](std::size_t i, std::size_t j, std::size_t k) {
    const auto at = [](std::size_t n, std::size_t degree, std::size_t a, std::size_t b) {
      return ratio(
          10 * static_cast<std::int64_t>(n) + static_cast<std::int64_t>((2 * a + 3 * b) % 3) - 1,
          10 * static_cast<std::int64_t>(degree));
    };
    return v_cells::Point{at(i, 3, j, k), at(j, 2, k, i), at(k, 3, i, j)};
  });
  return insert_knot(out, 0, ratio(2, 5));
}

TEST(MicroVolume, GradedArmsInABentCageAgreeWithCompositionInFractions) {
  for (const int degree : {1}) {
    JackShape shape;
    shape.degree = degree;
    shape.range = {{kMaxWallNumber / 12, kMaxWallNumber / 6}};
    Microstructure micro = full({bent_cage()}, {2, 1, 1}, jack_tile(shape).value());
    std::int32_t number = kMaxWallNumber / 12;
    for (auto& axis : micro.grids[0].walls)
      for (std::int32_t& n : axis) n = number, number += 5003;
    expect_volume(measure(micro).value().tiles, exact_volume(micro),
                  "degree " + std::to_string(degree));
  }
}

TEST(MicroVolume, CellsFillTheCageHoweverTheyAreCut) {
  const Microstructure one = full({bent_cage()}, {2, 1, 1}, box_tile({0, 0, 0}, {64, 64, 64}));
  const Rational truth = exact_volume(one);
  for (const std::array<std::uint64_t, 3>& counts :
       {std::array<std::uint64_t, 3>{2, 1, 1}, {3, 5, 2}, {9, 8, 7}}) {
    const MicroVolume v =
        measure(full({bent_cage()}, counts, box_tile({0, 0, 0}, {64, 64, 64}))).value();
    expect_volume(v.tiles, truth, "tiles");
    expect_volume(v.cells, truth, "cells");
    EXPECT_TRUE(contains(v.density, Rational(1)));
  }
}

TEST(MicroVolume, MirrorsAndScalesOfTheCageScaleTheVolume) {
  JackShape shape;
  const MicroTile jack = jack_tile(shape).value();
  const Rational truth = exact_volume(full({bent_cage()}, {2, 1, 1}, jack));
  for (unsigned s = 0; s < 48; s += 9) {
    VVolume cage = v_cells::turned(bent_cage(), s);
    std::array<std::uint64_t, 3> counts{1, 1, 1};
    for (std::size_t a = 0; a < 3; ++a)
      if (cage.axis(a).knots.size() > 2 * static_cast<std::size_t>(cage.axis(a).degree + 1))
        counts[a] = 2;
    expect_volume(measure(full({cage}, counts, jack)).value().tiles, truth,
                  "symmetry " + std::to_string(s));
  }
  // Far from the origin, and small.
  const Rational small = Rational::power_of_two(-30), far(1'000'003);
  const VVolume moved = v_cells::mapped(bent_cage(), [&](const v_cells::Point& p) {
    return v_cells::Point{far + small * p[0], p[1] * small - far, small * p[2]};
  });
  expect_volume(measure(full({moved}, {2, 1, 1}, jack)).value().tiles,
                truth * small * small * small, "far away");
}

// The primitives are exact: their volumes are multiples of pi.
TEST(MicroVolume, RationalCagesHaveTheVolumesOfCirclesAndTori) {
  const Rational two(2), three(3);
  const double pi = std::numbers::pi;
  const auto box = box_tile({0, 0, 0}, {64, 64, 64});
  // Counts of 4 are one cell for each span of the turns.
  const auto expect = [&](const Result<Cells>& cells, std::uint64_t n, double truth,
                          double tolerance, const std::string& what) {
    const MicroVolume v = measure(full(cells.value(), {n, n, n}, box)).value();
    for (const Interval& x : {v.tiles, v.cells}) {
      EXPECT_LE(relative_width(x), tolerance) << what << ": " << to_string(x);
      EXPECT_LE(x.lo(), truth * (1 + 1e-15)) << what << ": " << to_string(x);
      EXPECT_GE(x.hi(), truth * (1 - 1e-15)) << what << ": " << to_string(x);
    }
  };
  for (const std::uint64_t n : {4u, 5u}) {
    expect(cylinder_cells(two, three), n, 12 * pi, 1e-9, "cylinder");
    expect(cone_cells(two, Rational(), three), n, 4 * pi, 1e-9, "cone");
    expect(one_cell_cylinder(two, three), n, 12 * pi, 1e-9, "one-cell cylinder");
  }
  // Weights that vary along two axes by large factors.
  expect(torus_cells(three, two), 5, 24 * pi * pi, 1e-8, "torus");
  expect(one_cell_sphere(three), 4, 36 * pi, 1e-8, "one-cell sphere");
}

TEST(MicroVolume, MeshesHaveNearlyThisVolume) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Random random(seed);
    const random_micro::Structure s = random_micro::any_structure(random);
    const VModel cage = make_v_model(s.micro.cage, VOrientation::kAuto).value();
    std::vector<AnalysedTile> tiles;
    for (const MicroTile& t : s.micro.tiles)
      tiles.push_back(std::get<AnalysedTile>(analyse_tile(t)));
    MicroMeshOptions options;
    options.chord = random_micro::size_of(s.micro) / 1500;
    const auto mesh = mesh_of(s.micro, cage, tiles, options);
    if (!mesh.has_value()) continue;
    const ValidityReport report = decide_validity(mesh->mesh, {});
    if (!report.is_valid) continue;
    ++compared;
    const double about = nearest_double(*report.volume);
    const MicroVolume v = measure(s.micro).value();
    EXPECT_NEAR(mid(v.tiles) / about, 1, 0.02) << "seed " << seed << ": " << s.description;
    EXPECT_LE(relative_width(v.tiles), 1e-8) << "seed " << seed << ": " << s.description;
    EXPECT_LE(relative_width(v.cells), 1e-8) << "seed " << seed << ": " << s.description;
  }
  EXPECT_GE(compared, 3);
}

TEST(MicroVolume, EmptyStructuresHaveNone) {
  Microstructure micro = full({cube(0, 0, 0)}, {2, 2, 2}, box_tile({0, 0, 0}, {64, 64, 64}));
  for (std::uint8_t& t : micro.grids[0].tiles) t = 0;
  const MicroVolume v = measure(micro).value();
  EXPECT_EQ(v.tiles, Interval());
  EXPECT_TRUE(contains(v.cells, Rational(1)));
}

TEST(MicroVolume, DoesNotDependOnJobs) {
  Random random(5);
  const random_micro::Structure s = random_micro::any_structure(random);
  const MicroVolume one = measure(s.micro, 1).value(), three = measure(s.micro, 3).value();
  EXPECT_EQ(one.tiles, three.tiles);
  EXPECT_EQ(one.cells, three.cells);
}

TEST(MicroVolume, NumbersBeyondBinary64AreRefused) {
  const VVolume huge = v_cells::mapped(cube(0, 0, 0), [](const v_cells::Point& p) {
    return v_cells::Point{p[0] * Rational::power_of_two(1000), p[1],
                          p[2] * Rational::power_of_two(900)};
  });
  const auto found = measure(full({huge}, {1, 1, 1}, box_tile({0, 0, 0}, {64, 64, 64})));
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().code, Code::kNotFinite);
}

// det J in the parameters of the volume brought to [0, 1], by differences.
double determinant_at(const VVolume& volume, const std::array<double, 3>& at) {
  const auto image = [&](std::array<double, 3> p) {
    const auto value = veritope::point(volume, std::array<Rational, 3>{Rational::from_double(p[0]),
                                                                       Rational::from_double(p[1]),
                                                                       Rational::from_double(p[2])})
                           .value();
    std::array<double, 3> out{};
    for (std::size_t c = 0; c < 3; ++c) out[c] = nearest_double(value[c]);
    return out;
  };
  std::array<std::array<double, 3>, 3> d{};
  for (std::size_t a = 0; a < 3; ++a) {
    const double length =
        nearest_double(volume.axis(a).domain_end() - volume.axis(a).domain_begin());
    const double step = length * 1e-6;
    auto low = at, high = at;
    low[a] -= step;
    high[a] += step;
    const auto p = image(low), q = image(high);
    for (std::size_t c = 0; c < 3; ++c) d[a][c] = (q[c] - p[c]) / 2e-6;
  }
  return d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
         d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
         d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
}

CageScale scale(const Microstructure& micro) {
  return scale_of(micro, make_v_model(micro.cage, VOrientation::kAuto).value()).value();
}

TEST(CageScale, IsTheVolumeOfABoxWhateverItsDomain) {
  VVolume box =
      v_cells::box({Rational(), Rational(), Rational()}, {Rational(2), Rational(3), Rational(4)});
  for (std::size_t a = 0; a < 3; ++a) {
    box = with_domain(box, a, Rational(-1), Rational(7)).value();
    box = insert_knot(box, a, Rational(1));
    box = reversed(box, a);
    const CageScale s = scale(full({box}, {3, 3, 3}, box_tile({8, 8, 8}, {56, 56, 56})));
    EXPECT_LE(s.lo, 24);
    EXPECT_GE(s.hi, 24);
    EXPECT_NEAR(s.lo, 24, 1e-12);
    EXPECT_NEAR(s.hi, 24, 1e-12);
  }
}

// Along each axis 3 u / (1 + 2 u): the determinant falls from 27 to 1 / 27. It is known up to a part of the greatest
// value only, so halving boxes does not bound the least one to 1 %.
TEST(CageScale, OfUnevenWeightsIsWithinAPartOfTheGreatestValue) {
  const auto weight = [](std::size_t i, std::size_t j, std::size_t k) {
    return Rational(std::array{1, 3, 9, 27}[i + j + k]);
  };
  const auto corner = [](std::size_t i, std::size_t j, std::size_t k) {
    return v_cells::Point{Rational(i), Rational(j), Rational(k)};
  };
  const VVolume volume = v_cells::rational({1, 1, 1}, corner, weight);
  const CageScale s = scale(full({volume}, {2, 3, 2}, box_tile({8, 8, 8}, {56, 56, 56})));
  EXPECT_GE(s.lo, 0);
  EXPECT_LE(s.lo, 1.0 / 27);
  EXPECT_GE(s.hi, 27);
  EXPECT_LE(s.hi, 27 * (1 + 0x1p-7));
}

TEST(CageScale, BoundsAreNearValuesAtPointsOfCellsWithTiles) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    const random_micro::Structure s = random_micro::any_structure(random);
    std::size_t tiles = 0;
    for (const MicroGrid& g : s.micro.grids) tiles += g.tiles.size();
    if (tiles > 30) continue;
    const CageScale found = scale(s.micro);
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const MicroGrid& grid : s.micro.grids) {
      const VVolume& volume = s.micro.cage[grid.volume];
      const Grid<3> shape = grid.shape();
      for (std::size_t c = 0; c < grid.tiles.size(); ++c) {
        if (grid.tiles[c] == 0) continue;
        const auto cell = shape.index_of(c);
        for (int n = 0; n < 9; ++n) {  // near the corners, and the middle
          std::array<double, 3> at{};
          const std::array<int, 3> part =
              n == 8 ? std::array<int, 3>{2, 2, 2}
                     : std::array<int, 3>{n / 4 * 4, n / 2 % 2 * 4, n % 2 * 4};
          for (std::size_t a = 0; a < 3; ++a) {
            const double low = nearest_double(grid.breaks[a][cell[a]]),
                         high = nearest_double(grid.breaks[a][cell[a] + 1]);
            at[a] = low + (high - low) * (0.001 + 0.998 * part[a] / 4);
          }
          const double d = std::fabs(determinant_at(volume, at));
          least = std::min(least, d);
          most = std::max(most, d);
        }
      }
    }
    if (most == 0) continue;
    ++compared;
    const std::string what = "seed " + std::to_string(seed) + ": " + s.description;
    EXPECT_LE(found.lo, least * (1 + 1e-4) + 1e-4 * most) << what;
    EXPECT_GE(found.hi, most * (1 - 1e-4)) << what;
    // Samples are near the corners of cells, where extremes often are; the bounds are at most this far from them.
    EXPECT_GE(found.lo, 0.9 * least - 0.02 * most) << what;
    EXPECT_LE(found.hi, 1.1 * most) << what;
  }
  EXPECT_GE(compared, 5);
}

TEST(CageScale, LooksAtCellsWithTilesOnly) {
  // The determinant is 2 u + 1/2 along u.
  const VVolume cage =
      v_cells::polynomial({2, 1, 1}, [](std::size_t i, std::size_t j, std::size_t k) {
        const std::array<Rational, 3> x = {Rational(), ratio(1, 4), ratio(3, 2)};
        return v_cells::Point{x[i], Rational(j), Rational(k)};
      });
  Microstructure micro = full({cage}, {4, 2, 2}, box_tile({8, 8, 8}, {56, 56, 56}));
  for (std::size_t c = 0; c < micro.grids[0].tiles.size(); ++c)
    if (c < 4 || c >= 8) micro.grids[0].tiles[c] = 0;  // u from 1/4 to 1/2
  const CageScale s = scale(micro);
  EXPECT_NEAR(s.lo, 1, 0.011);
  EXPECT_NEAR(s.hi, 1.5, 0.016);
  for (std::uint8_t& t : micro.grids[0].tiles) t = 0;
  EXPECT_EQ(scale(micro).hi, 0);
}

TEST(CageScale, AtAnAxisTheLeastDeterminantIsNearZero) {
  const CageScale s = scale(full(one_cell_cylinder(Rational(2), Rational(3)).value(), {4, 4, 4},
                                 box_tile({8, 8, 8}, {56, 56, 56})));
  EXPECT_EQ(s.lo, 0);
  EXPECT_GT(s.hi, 10);
}

}  // namespace
}  // namespace veritope
