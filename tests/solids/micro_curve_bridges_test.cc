// SPDX-License-Identifier: LGPL-3.0-or-later
// Free ends of curves, and their bridges to the surface of a solid.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "robust/base/random.h"
#include "solids/classify/mesh_classifier.h"
#include "solids/micro/bridge/curve_bridges.h"
#include "solids/micro/compose/composed_surface.h"
#include "solids/micro/open_tile.h"
#include "solids/micro/synthesis/filter_tiles.h"
#include "splines/de_casteljau.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/micro_cells.h"
#include "tests/support/round_truth.h"
#include "tests/support/shapes.h"

namespace veritope {
namespace {

constexpr std::uint64_t kSeedOfCurveBridges = 20261128;

using SpacePoint = std::array<Rational, 3>;

Rational part(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }

// The box [lo, lo + 1]^3 times the size, bent by `bend` eighths in the middle.
VVolume bent_box(const std::array<std::int64_t, 3>& lo, std::int64_t size, std::int64_t bend = 0) {
  return v_cells::polynomial({2, 2, 2}, [&](std::size_t i, std::size_t j, std::size_t k) {
    const auto at = [&](std::size_t n, std::size_t axis) {
      return Rational(size) * (Rational(lo[axis]) + part(static_cast<std::int64_t>(n), 2));
    };
    const Rational off = j == 1 ? part(bend * size, 8) : Rational(0);
    return v_cells::Point{at(i, 0) + off, at(j, 1), at(k, 2) + off};
  });
}
MicroTile lines_tile(const std::vector<std::vector<TilePoint>>& lines) {
  MicroTile out;
  out.is_open = true;
  out.name = "lines";
  for (const auto& line : lines) {
    TilePatch patch;
    patch.degrees = {static_cast<int>(line.size()) - 1, 0};
    patch.points = {line};
    out.patches.push_back(patch);
  }
  return out;
}
std::size_t num_free(std::vector<VVolume> cage, const std::array<std::uint64_t, 3>& counts,
                     const MicroTile& tile) {
  return free_curve_ends(micro_cells::full(std::move(cage), counts, tile)).size();
}

// ---- ends

TEST(FreeCurveEnds, AreThoseThatNoOtherCurveContinues) {
  const MicroTile coils = curves3_tile({}).value();
  const std::vector<VVolume> one = {bent_box({0, 0, 0}, 1, 1)};
  EXPECT_EQ(num_free(one, {1, 1, 1}, coils), 6u);
  EXPECT_EQ(num_free(one, {2, 1, 1}, coils), 10u);
  EXPECT_EQ(num_free(one, {3, 4, 5}, coils), 2u * (12 + 15 + 20));
  Microstructure micro = micro_cells::full(one, {3, 1, 1}, coils);
  micro.grids[0].tiles[1] = 0;
  const std::vector<CurveEnd> ends = free_curve_ends(micro);
  EXPECT_EQ(ends.size(), 12u);
  EXPECT_TRUE(std::is_sorted(ends.begin(), ends.end()));
  EXPECT_EQ(std::count_if(ends.begin(), ends.end(), [](const CurveEnd& e) { return e.cell == 1; }),
            0);
  micro.grids[0].tiles.assign(3, 0);
  EXPECT_TRUE(free_curve_ends(micro).empty());
}

TEST(FreeCurveEnds, MeetAcrossVolumes) {
  const MicroTile coils = curves3_tile({}).value();
  const std::vector<VVolume> two = {bent_box({0, 0, 0}, 1), bent_box({1, 0, 0}, 1)};
  EXPECT_EQ(num_free(two, {1, 1, 1}, coils), 10u);
  EXPECT_EQ(num_free(two, {2, 2, 1}, coils), 2u * (2 + 4 + 8));
  // Volumes that do not meet.
  const std::vector<VVolume> apart = {bent_box({0, 0, 0}, 1), bent_box({2, 0, 0}, 1)};
  EXPECT_EQ(num_free(apart, {1, 1, 1}, coils), 12u);
}

TEST(FreeCurveEnds, LieInWallsAndAreTheEndOfOneCurve) {
  using micro_cells::at;
  const std::vector<VVolume> box = {bent_box({0, 0, 0}, 1)};
  // Diagonals: cells that share a corner only continue each other.
  EXPECT_EQ(num_free(box, {2, 2, 2}, lines_tile({{at(0, 0, 0), at(64, 64, 64)}})), 14u);
  // Ends inside of the cell do not count, nor do joints in a wall.
  EXPECT_EQ(num_free(box, {1, 1, 1}, lines_tile({{at(0, 32, 32), at(8, 32, 32)}})), 1u);
  EXPECT_EQ(num_free(box, {1, 1, 1},
                     lines_tile({{at(16, 16, 16), at(64, 32, 32)}, {at(64, 32, 32), at(8, 8, 8)}})),
            0u);
  // Curves of neighbours whose ends lie in one wall, apart.
  EXPECT_EQ(num_free(box, {2, 1, 1}, lines_tile({{at(0, 32, 32), at(64, 32, 33)}})), 4u);
  // Sheets have no ends.
  const MicroTile sheets = sheets_of(jack_tile({}).value());
  Microstructure micro = micro_cells::full(box, {2, 1, 1}, sheets);
  EXPECT_TRUE(free_curve_ends(micro).empty());
}

// The end and the first difference of the composed curve, homogeneous coordinates included.
void expect_place_as_composed(const Microstructure& micro) {
  const VModel cage = make_v_model(micro.cage, VOrientation::kAuto).value();
  const std::vector<AnalysedTile> tiles = {analysis_of_open(micro.tiles[0])};
  const ComposedSurface surface = ComposedSurface::make(micro, cage, tiles).value();
  CellPiece piece(micro);
  const std::vector<CurveEnd> ends = free_curve_ends(micro);
  ASSERT_FALSE(ends.empty());
  for (const CurveEnd& end : ends) {
    const CurveEndPlace place = place_of(micro, end, piece);
    const auto& cells = surface.cells();
    const auto cell = std::find_if(cells.begin(), cells.end(), [&](const ComposedCell& c) {
      return c.grid == end.grid && c.cell == end.cell;
    });
    const auto number = static_cast<std::size_t>(cell - cells.begin());
    const auto curve = surface.compose(number, number + 1)[0][end.patch].surface;
    const auto n = static_cast<std::size_t>(curve.degree(0));
    const std::size_t last = end.is_last ? n : 0, before = end.is_last ? n - 1 : 1;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto x = curve.component(static_cast<int>(c));
      Rational w(1), dw(0);
      if (curve.is_rational()) {
        w = curve.component(3)[last];
        dw = w - curve.component(3)[before];
      }
      const Rational value = x[last] / w, slope = (x[last] - x[before] - value * dw) / w;
      EXPECT_EQ(place.at[c], value);
      EXPECT_EQ(place.tangent[c], Rational(curve.degree(0)) * slope);
    }
  }
}

TEST(FreeCurveEnds, HaveTheImageAndTheTangentOfTheComposedCurve) {
  Microstructure micro =
      micro_cells::full({bent_box({0, 0, 0}, 3, 1)}, {2, 3, 1}, curves3_tile({}).value());
  micro.grids[0].tiles[2] = 0;
  expect_place_as_composed(micro);
  VVolume rational =
      v_cells::polynomial({1, 2, 1}, [](std::size_t i, std::size_t j, std::size_t k) {
        return v_cells::Point{part(static_cast<std::int64_t>(i), 1),
                              part(static_cast<std::int64_t>(j), 2),
                              part(static_cast<std::int64_t>(k), 1)};
      });
  std::vector<Rational> net;
  for (int c = 0; c < 4; ++c)
    for (std::size_t n = 0; n < rational.grid().count(); ++n) {
      const Rational weight = part(4 + static_cast<std::int64_t>(n % 3), 4);
      net.push_back(c == 3 ? weight : weight * rational.component(c)[n]);
    }
  rational = VVolume(rational.axes(), 4, true, std::move(net));
  expect_place_as_composed(micro_cells::full({rational}, {2, 1, 2}, curves3_tile({}).value()));
}

// ---- bridges

struct BridgedCurves {
  Microstructure micro;
  CurveBridges found;
};
BridgeOptions bridging(double skin, double alpha = 0.5, unsigned jobs = 1) {
  BridgeOptions out;
  out.skin = skin;
  out.alpha = alpha;
  out.jobs = jobs;
  return out;
}
BridgedCurves bridged(const TileFilter& filter, const SkinFeet& feet, Microstructure micro,
                      const BridgeOptions& options) {
  BridgedCurves out;
  EXPECT_TRUE(filter_tiles_to(filter, 1, micro).has_value());
  out.found = build_curve_bridges(filter, feet, micro, options).value();
  out.micro = std::move(micro);
  return out;
}

SpacePoint bridge_point(const CurveBridge& b, const Rational& t) {
  BezierCurve<Rational> curve({2}, 3, false);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t c = 0; c < 3; ++c) curve.component(static_cast<int>(c))[i] = b.points[i][c];
  const auto x = evaluate<Rational, 1>(curve, {t});
  return {x[0], x[1], x[2]};
}

// The bridge begins at the end and goes on along its tangent, exactly.
void expect_smooth(const Microstructure& micro, const CurveBridge& b, CellPiece& piece) {
  const CurveEndPlace place = place_of(micro, b.end, piece);
  EXPECT_EQ(b.points[0], place.at);
  SpacePoint way;
  Rational along;
  for (std::size_t c = 0; c < 3; ++c) {
    way[c] = b.points[1][c] - b.points[0][c];
    along += way[c] * place.tangent[c];
  }
  EXPECT_EQ(along.sign(), Sign::kPositive);
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_EQ(way[c] * place.tangent[(c + 1) % 3], way[(c + 1) % 3] * place.tangent[c]);
}

void expect_counts(const BridgedCurves& all) {
  const BridgeReport& r = all.found.report;
  EXPECT_EQ(r.caps, free_curve_ends(all.micro).size());
  EXPECT_EQ(r.built, all.found.bridges.size());
  std::uint64_t sum = r.built;
  for (const std::uint64_t n : r.dropped) sum += n;
  EXPECT_EQ(sum, r.caps);
  EXPECT_TRUE(std::is_sorted(all.found.bridges.begin(), all.found.bridges.end(),
                             [](const auto& a, const auto& b) { return a.end < b.end; }));
}

// Each bridge lies in the interior, at exact points of it, and ends within the skin.
void expect_sound_in_mesh(const TriangleMesh& mesh, const BridgedCurves& all, double skin) {
  const MeshClassifier classifier = std::move(MeshClassifier::make(mesh).value());
  const MeshProjection projection(mesh);
  CellPiece piece(all.micro);
  Rational least, most;
  for (const CurveBridge& b : all.found.bridges) {
    expect_smooth(all.micro, b, piece);
    for (int i = 0; i <= 12; ++i)
      EXPECT_EQ(classifier.classify(bridge_point(b, part(i, 12))).winding, 1);
    const Rational d = projection.project(b.points[2]).squared_distance;
    EXPECT_LE(d, Rational::from_double(skin) * Rational::from_double(skin));
    least = &b == all.found.bridges.data() ? d : std::min(least, d);
    most = std::max(most, d);
  }
  const BridgeRange& reach = all.found.report.reach;
  EXPECT_LE(Rational::from_double(reach.lo) * Rational::from_double(reach.lo), least);
  EXPECT_LE(most, Rational::from_double(reach.hi) * Rational::from_double(reach.hi));
  expect_counts(all);
}

TEST(CurveBridges, LieInMeshesAndEndWithinTheSkin) {
  std::uint64_t caps = 0, built = 0;
  for (int n = 0; n < scaled(12); ++n) {
    SCOPED_TRACE("seed " + std::to_string(kSeedOfCurveBridges) + " case " + std::to_string(n));
    Random random(kSeedOfCurveBridges + static_cast<std::uint64_t>(n));
    const TriangleMesh mesh = n % 3 == 0   ? shapes::box({-3, -2, -3}, {3, 3, 2})
                              : n % 3 == 1 ? shapes::star_polyhedron(random, 1)
                                           : shapes::torus(12, 8, 3, 1.25);
    const TileFilter filter = std::move(TileFilter::make(mesh).value());
    const MeshProjection projection(mesh);
    const std::uint64_t k = 4 + random.below(6);
    const MicroTile tile =
        n % 2 == 0 ? curves3_tile({}).value() : curves3_tile({part(1, 8), 5}).value();
    const double skin = n % 4 == 0 ? 1e-3 : 0.25, alpha = n % 5 == 0 ? 1 : 0.5;
    const BridgedCurves all =
        bridged(filter, feet_on(projection),
                micro_cells::full({bent_box({-1, -1, -1}, 10, n % 3 - 1)}, {2 * k, k, k}, tile),
                bridging(skin, alpha));
    expect_sound_in_mesh(mesh, all, skin);
    caps += all.found.report.caps;
    built += all.found.report.built;
  }
  EXPECT_GT(caps, 100u);
  EXPECT_GE(20 * built, 19 * caps) << built << " of " << caps;
}

TEST(CurveBridges, LieInBallsOfPatches) {
  const round_truth::Solid ball{round_truth::Solid::Kind::kPolarBall, Rational(1), {}};
  const PatchComplex complex = make_patch_complex(ball.patches()).value();
  const TileFilter filter = TileFilter::make(complex);
  const PatchProjection projection(complex);
  const double skin = default_skin(complex);
  EXPECT_GE(skin, std::sqrt(12.0) / 100);  // control points of rational patches may leave the box
  EXPECT_LE(skin, 2 * std::sqrt(12.0) / 100);
  const VVolume cube = v_cells::box({Rational(-2), Rational(-2), Rational(-2)},
                                    {Rational(2), Rational(2), Rational(2)});
  const BridgedCurves all =
      bridged(filter, feet_on(projection),
              micro_cells::full({cube}, {9, 8, 10}, curves3_tile({}).value()), bridging(skin));
  EXPECT_GT(all.found.report.built, 20u);
  expect_counts(all);
  CellPiece piece(all.micro);
  const Rational inner = Rational(1) - Rational::from_double(skin);
  for (const CurveBridge& b : all.found.bridges) {
    expect_smooth(all.micro, b, piece);
    for (int i = 0; i <= 12; ++i) EXPECT_EQ(ball.side(bridge_point(b, part(i, 12))), 1);
    Rational square;
    for (const Rational& x : b.points[2]) square += x * x;
    EXPECT_GE(square, inner * inner);
  }
}

TEST(CurveBridges, DoNotDependOnJobsAndDependOnAlpha) {
  const TriangleMesh mesh = shapes::box({-3, -2, -3}, {3, 3, 2});
  const TileFilter filter = std::move(TileFilter::make(mesh).value());
  const MeshProjection projection(mesh);
  const auto run = [&](double alpha, unsigned jobs) {
    return bridged(
        filter, feet_on(projection),
        micro_cells::full({bent_box({-1, -1, -1}, 10, 1)}, {9, 8, 7}, curves3_tile({}).value()),
        bridging(0.1, alpha, jobs));
  };
  const BridgedCurves one = run(0.5, 1), two = run(0.5, 3), other = run(0.25, 1);
  ASSERT_EQ(one.found.bridges.size(), two.found.bridges.size());
  ASSERT_GT(one.found.bridges.size(), 0u);
  for (std::size_t i = 0; i < one.found.bridges.size(); ++i) {
    EXPECT_EQ(one.found.bridges[i].end, two.found.bridges[i].end);
    EXPECT_EQ(one.found.bridges[i].points, two.found.bridges[i].points);
    EXPECT_NE(one.found.bridges[i].points, other.found.bridges[i].points);
  }
}

TEST(CurveBridges, AreDroppedWithAReason) {
  using micro_cells::at;
  const TriangleMesh mesh = shapes::box({0, 0, 0}, {3, 3, 3});
  const TileFilter filter = std::move(TileFilter::make(mesh).value());
  const MeshProjection projection(mesh);
  const auto report = [&](const MicroTile& tile, double skin) {
    return bridged(filter, feet_on(projection),
                   micro_cells::full({bent_box({1, 1, 1}, 1)}, {1, 1, 1}, tile), bridging(skin))
        .found.report;
  };
  const auto dropped = [](const BridgeReport& r, BridgeDrop why) {
    return r.dropped[static_cast<std::size_t>(why)];
  };
  const MicroTile line = lines_tile({{at(32, 32, 32), at(64, 40, 32)}});
  EXPECT_EQ(report(line, 0.01).built, 1u);
  const BridgeReport thin = report(line, 1e-18);  // nothing is that near in binary64
  EXPECT_EQ((std::array{thin.caps, thin.built, dropped(thin, BridgeDrop::kSkin)}),
            (std::array<std::uint64_t, 3>{1, 0, 1}));
  EXPECT_EQ((std::array{thin.reach.lo, thin.reach.hi}), (std::array{0.0, 0.0}));
  const MicroTile stopped = lines_tile({{at(32, 32, 32), at(64, 40, 32), at(64, 40, 32)}});
  const BridgeReport folded = report(stopped, 0.01);
  EXPECT_EQ((std::array{folded.caps, folded.built, dropped(folded, BridgeDrop::kFolded)}),
            (std::array<std::uint64_t, 3>{1, 0, 1}));
}

TEST(IsCurveInside, IsTrueOfCurvesInTheInteriorOnly) {
  const TriangleMesh mesh = shapes::box({0, 0, 0}, {4, 4, 4});
  const TileFilter filter = std::move(TileFilter::make(mesh).value());
  const auto p = [](int x, int y, int z) {
    return SpacePoint{Rational(x), Rational(y), Rational(z)};
  };
  EXPECT_TRUE(is_curve_inside(filter, {p(1, 1, 1), p(3, 2, 1), p(1, 3, 3)}));
  EXPECT_TRUE(is_curve_inside(filter, {p(1, 1, 1), p(3, 1, 1)}));
  EXPECT_TRUE(is_curve_inside(filter, {p(2, 2, 2), p(2, 2, 2)}));
  EXPECT_TRUE(is_curve_inside(filter, {p(1, 1, 1), p(5, 2, 2), p(1, 3, 3)}));   // its hull crosses
  EXPECT_FALSE(is_curve_inside(filter, {p(1, 1, 1), p(7, 2, 2), p(1, 3, 3)}));  // touches at 4
  EXPECT_FALSE(is_curve_inside(filter, {p(1, 1, 1), p(8, 2, 2), p(1, 3, 3)}));
  EXPECT_FALSE(is_curve_inside(filter, {p(1, 1, 1), p(4, 1, 1)}));
  EXPECT_FALSE(is_curve_inside(filter, {p(5, 5, 5), p(6, 5, 6)}));
  EXPECT_FALSE(is_curve_inside(filter, {p(4, 4, 4), p(4, 4, 4)}));
  const Rational huge = Rational::power_of_two(2000);
  EXPECT_FALSE(is_curve_inside(filter, {p(1, 1, 1), SpacePoint{huge, huge, huge}}));
}

}  // namespace
}  // namespace veritope
