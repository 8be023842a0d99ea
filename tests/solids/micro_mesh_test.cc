// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/mesh/micro_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solids/micro/micro_topology.h"
#include "solids/polyhedron/validity.h"
#include "tests/support/approx_distance.h"
#include "tests/support/micro_cells.h"
#include "tests/support/random_microstructures.h"

namespace veritope {
namespace {

using micro_cells::box_tile;
using micro_cells::full;
using micro_cells::ring_cage;
using v_cells::cube;

struct Subject {
  explicit Subject(const Microstructure& m)
      : micro(m), cage(make_v_model(m.cage, VOrientation::kAuto).value()) {
    for (const MicroTile& t : m.tiles) {
      auto result = analyse_tile(t);
      if (const auto* defect = std::get_if<TileDefect>(&result))
        ADD_FAILURE() << t.name << ": " << defect->condition << ": " << defect->message;
      tiles.push_back(std::get<AnalysedTile>(std::move(result)));
    }
  }
  Result<MicroMesh> mesh(double chord, unsigned jobs = 1) const {
    MicroMeshOptions options;
    options.chord = chord;
    options.jobs = jobs;
    return mesh_of(micro, cage, tiles, options);
  }
  MicroCounts counts() const {
    const auto found = topology_of(micro, cage, tiles);
    if (const auto* defect = std::get_if<MicroDefect>(&found)) {
      ADD_FAILURE() << defect->condition << ": " << defect->message;
      return {};
    }
    return std::get<MicroCounts>(found);
  }

  const Microstructure& micro;
  VModel cage;
  std::vector<AnalysedTile> tiles;
};

// The mesh is VALID and has the counts of the microstructure.
void expect_valid(const Subject& subject, const MicroMesh& mesh, const std::string& what) {
  const MicroCounts counts = subject.counts();
  const ValidityReport report = decide_validity(mesh.mesh, {});
  EXPECT_TRUE(report.is_valid) << what;
  EXPECT_EQ(report.counts.shells, counts.shells) << what;
  EXPECT_EQ(report.counts.bodies, counts.components) << what;
  EXPECT_EQ(report.counts.genus, counts.genus) << what;
  EXPECT_EQ(report.counts.referenced_vertices, mesh.mesh.positions.size()) << what;
}
JackShape linear_jack() {
  JackShape shape;
  shape.degree = 1;
  return shape;
}

Rational ratio(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }

// Whether all meshes of the structure, finer and finer, are valid and have its counts.
void expect_valid_at_all_chords(const Microstructure& micro, const std::string& what,
                                double coarsest = 1.0 / 250, int halvings = 2) {
  const Subject subject(micro);
  double chord = random_micro::size_of(micro) * coarsest;
  for (int round = 0; round <= halvings; ++round, chord /= 2) {
    const auto mesh = subject.mesh(chord);
    ASSERT_TRUE(mesh.has_value()) << what << ": " << mesh.error().message;
    EXPECT_LE(mesh->distance, chord) << what;
    EXPECT_LE(mesh->rounding, chord / 64) << what;
    expect_valid(subject, *mesh, what + ", chord " + std::to_string(chord));
  }
}

TEST(MicroMesh, StraightArmsInAStraightCageAreNotCut) {
  const Microstructure micro = full({cube(0, 0, 0)}, {3, 2, 1}, jack_tile(linear_jack()).value());
  const Subject subject(micro);
  const MicroMesh mesh = subject.mesh(1e-9).value();
  EXPECT_LE(mesh.distance, 1e-14);
  for (const MicroMeshParts& parts : mesh.parts)
    for (const auto& p : parts.of_patch) EXPECT_EQ(p, (std::array<std::uint32_t, 2>{1, 1}));
  // 48 triangles of arms, 2 of each cap that is left.
  const std::size_t caps = 6 * 6 - 2 * (2 * 2 * 1 + 3 * 1 * 1);
  EXPECT_EQ(mesh.mesh.faces.size(), 6 * 48 + 2 * caps);
  expect_valid(subject, mesh, "block");
}

TEST(MicroMesh, RandomStructuresHaveValidMeshes) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Random random(seed);
    const random_micro::Structure s = random_micro::any_structure(random);
    if (std::all_of(s.micro.grids.begin(), s.micro.grids.end(), [](const MicroGrid& g) {
          return std::count(g.tiles.begin(), g.tiles.end(), 0) ==
                 static_cast<std::ptrdiff_t>(g.tiles.size());
        }))
      continue;
    expect_valid_at_all_chords(s.micro, "seed " + std::to_string(seed) + ": " + s.description);
  }
}

TEST(MicroMesh, EverySymmetryOfAGluedFaceIsFollowed) {
  const auto bend = [](const v_cells::Point& p) {
    return v_cells::Point{p[0] + ratio(1, 8) * p[1] * p[2], p[1] + ratio(1, 7) * p[0] * p[0],
                          p[2] - ratio(1, 9) * p[0] * p[1]};
  };
  for (unsigned s = 0; s < 48; ++s) {
    auto cage = v_cells::grid(2, {2, 2, 2}, bend);
    cage.erase(cage.begin() + 2, cage.end());
    cage = {v_cells::turned(cage[0], s), v_cells::turned(cage[1], 47 - s)};
    JackShape shape = linear_jack();
    shape.range = {{kMaxWallNumber / 8, kMaxWallNumber / 4}};
    const Microstructure micro =
        full(cage, {2, 2, 2}, jack_tile(shape).value(), kMaxWallNumber / 7);
    const Subject subject(micro);
    EXPECT_EQ(subject.counts().components, 1u);
    const MicroMesh mesh = subject.mesh(1e-2).value();
    expect_valid(subject, mesh, "symmetry " + std::to_string(s));
    EXPECT_GT(nearest_double(*decide_validity(mesh.mesh, {}).volume), 0) << s;
  }
}

TEST(MicroMesh, CellsThatAreGluedToThemselvesAreClosedRings) {
  for (const std::uint64_t n : {1u, 2u, 3u, 4u}) {
    const Microstructure tube = full({ring_cage()}, {1, n, 1}, box_tile({16, 0, 16}, {48, 64, 48}));
    const MicroCounts counts = Subject(tube).counts();
    EXPECT_EQ(counts.genus, 1);
    EXPECT_EQ(counts.glued_caps, n);
    expect_valid_at_all_chords(tube, "ring of " + std::to_string(n) + " tubes", 1.0 / 30, 4);
    expect_valid_at_all_chords(full({ring_cage()}, {2, n, 1}, jack_tile(linear_jack()).value()),
                               "ring of jacks", 1.0 / 100, 2);
  }
  // No chord is so large that the mesh is not that of a closed surface.
  for (const std::uint64_t n : {1u, 2u}) {
    const Microstructure tube = full({ring_cage()}, {1, n, 1}, box_tile({16, 0, 16}, {48, 64, 48}));
    const Subject subject(tube);
    const MicroMesh mesh = subject.mesh(1e3).value();
    const ValidityReport report = decide_validity(mesh.mesh, {});
    EXPECT_EQ(report.counts.boundary_edges + report.counts.nonmanifold_edges +
                  report.counts.nonmanifold_vertices + report.counts.degenerate_faces +
                  report.counts.duplicate_faces,
              0u)
        << n;
    EXPECT_EQ(report.counts.euler, 0) << n;
  }
}

// Two legs to wall 4, and two to wall 5, from a block in the middle, and a bar to wall 3; each ends in a cap.
MicroTile twin_tile() {
  MicroTile out;
  out.name = "twin";
  const TilePoint centre = micro_cells::at(32, 32, 32);
  const auto add = [&](TilePoint a, TilePoint b, TilePoint c, TilePoint d) {
    std::array<Rational, 3> e, f, w;
    for (std::size_t k = 0; k < 3; ++k)
      e[k] = b[k] - a[k], f[k] = d[k] - a[k], w[k] = a[k] - centre[k];
    const Rational side = (e[1] * f[2] - e[2] * f[1]) * w[0] + (e[2] * f[0] - e[0] * f[2]) * w[1] +
                          (e[0] * f[1] - e[1] * f[0]) * w[2];
    if (side.sign() == Sign::kNegative) std::swap(b, d);
    out.patches.push_back(micro_cells::square(a, b, c, d));
  };
  const std::array<int, 4> strips = {20, 28, 36, 44};
  constexpr int kFront = 24, kBack = 40;
  const auto across = [&](int y, int low, int high) {
    add(micro_cells::at(low, y, 16), micro_cells::at(high, y, 16), micro_cells::at(high, y, 48),
        micro_cells::at(low, y, 48));
  };
  for (std::size_t s = 0; s < 3; ++s) {
    across(kFront, strips[s], strips[s + 1]);
    across(s == 1 ? 64 : kBack, strips[s], strips[s + 1]);
  }
  for (const int x : {28, 36})
    add(micro_cells::at(x, kBack, 16), micro_cells::at(x, kBack, 48), micro_cells::at(x, 64, 48),
        micro_cells::at(x, 64, 16));
  for (const int z : {16, 48})
    add(micro_cells::at(28, kBack, z), micro_cells::at(36, kBack, z), micro_cells::at(36, 64, z),
        micro_cells::at(28, 64, z));
  for (const int x : {20, 44})
    add(micro_cells::at(x, kFront, 16), micro_cells::at(x, kBack, 16),
        micro_cells::at(x, kBack, 48), micro_cells::at(x, kFront, 48));
  for (const bool is_top : {false, true}) {
    const int root = is_top ? 48 : 16, end = is_top ? 64 : 0;
    add(micro_cells::at(28, kFront, root), micro_cells::at(36, kFront, root),
        micro_cells::at(36, kBack, root), micro_cells::at(28, kBack, root));
    for (const auto& [low, high, low_end, high_end] :
         {std::array<int, 4>{20, 28, 10, 22}, std::array<int, 4>{36, 44, 42, 54}}) {
      for (const int y : {kFront, kBack})
        add(micro_cells::at(low, y, root), micro_cells::at(high, y, root),
            micro_cells::at(high_end, y, end), micro_cells::at(low_end, y, end));
      for (const auto& [x, x_end] : {std::pair(low, low_end), std::pair(high, high_end)})
        add(micro_cells::at(x, kFront, root), micro_cells::at(x, kBack, root),
            micro_cells::at(x_end, kBack, end), micro_cells::at(x_end, kFront, end));
      add(micro_cells::at(low_end, kFront, end), micro_cells::at(high_end, kFront, end),
          micro_cells::at(high_end, kBack, end), micro_cells::at(low_end, kBack, end));
    }
  }
  return out;
}

// The ring, closed along w.
VVolume upright_ring() { return permuted(ring_cage(), {0, 2, 1}); }

TEST(MicroMesh, CellsMayShareSeveralCaps) {
  const auto bent = [](v_cells::Point p) {
    p[0] += p[2] * p[2] * ratio(1, 3);
    return p;
  };
  const VVolume column = v_cells::mapped(elevate(elevate(cube(0, 0, 0), 2, 1), 1, 1), bent);
  for (const std::uint64_t n : {1u, 2u, 3u}) {
    const Microstructure open = full({column}, {1, 1, n}, twin_tile());
    EXPECT_EQ(Subject(open).counts().genus, static_cast<std::int64_t>(n) - 1);
    expect_valid_at_all_chords(open, "column of " + std::to_string(n));
    const Microstructure ring = full({upright_ring()}, {1, 1, n}, twin_tile());
    EXPECT_EQ(Subject(ring).counts().genus, static_cast<std::int64_t>(n) + 1);
    expect_valid_at_all_chords(ring, "ring of " + std::to_string(n), 1.0 / 60, 3);
    const Subject subject(ring);
    const MicroMesh coarse = subject.mesh(1e3).value();
    EXPECT_EQ(decide_validity(coarse.mesh, {}).counts.euler, -2 * static_cast<std::int64_t>(n));
  }
}

TEST(MicroMesh, FineGridsMeetCoarseOnes) {
  Microstructure micro = full({cube(0, 0, 0)}, {1, 1, 1}, box_tile({8, 8, 0}, {24, 24, 64}));
  micro.cage[0] = v_cells::mapped(elevate(micro.cage[0], 1, 1), [](v_cells::Point p) {
    p[2] += p[1] * p[1] * ratio(1, 2);
    return p;
  });
  const Rational half = ratio(1, 2);
  micro.grids[0].breaks[2] = {Rational(0), half};
  MicroGrid fine = micro.grids[0];
  fine.breaks = {
      {{Rational(0), half, Rational(1)}, {Rational(0), half, Rational(1)}, {half, Rational(1)}}};
  fine.tiles = {2, 0, 0, 2};
  micro.grids.push_back(fine);
  micro.tiles.push_back(box_tile({16, 16, 0}, {48, 48, 64}));
  const MicroCounts counts = Subject(micro).counts();
  EXPECT_EQ(counts.components, 2u);
  EXPECT_EQ(counts.glued_caps, 1u);
  expect_valid_at_all_chords(micro, "coarse and fine");
}

TEST(MicroMesh, NoPointOfTheSurfaceIsFartherThanTheProvedDistance) {
  double closest = 0;  // the greatest part of a bound that a point attains
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    Random random(seed * 7919);
    const random_micro::Structure s = random_micro::any_structure(random);
    const Subject subject(s.micro);
    if (subject.counts().tiles == 0 || subject.counts().tiles > 30) continue;
    const double size = random_micro::size_of(s.micro);
    const MicroMesh mesh = subject.mesh(size / 100).value();
    if (mesh.mesh.faces.size() > 20000) continue;
    for (int sample = 0; sample < 60; ++sample) {
      const MicroGrid& grid = s.micro.grids[random.below(s.micro.grids.size())];
      const std::size_t cell = random.below(grid.tiles.size());
      if (grid.tiles[cell] == 0) continue;
      const AnalysedTile& tile = subject.tiles[grid.tiles[cell] - 1u];
      const std::size_t p = random.below(tile.tile.patches.size());
      if (tile.cap_of_patch[p] != AnalysedTile::kNoCap) continue;
      const Rational u = ratio(random.between(0, 64), 64), v = ratio(random.between(0, 64), 64);
      const Vec3d at = random_micro::nearest_point(
          random_micro::exact_point(s.micro, grid, cell, tile.tile.patches[p], u, v));
      const double least = approx::distance_to_mesh(at, mesh.mesh);
      EXPECT_LE(least, mesh.distance + 1e-13 * size)
          << "seed " << seed << ", cell " << cell << ", patch " << p << ", u " << u.to_string()
          << ", v " << v.to_string() << ": " << s.description;
      closest = std::max(closest, least / mesh.distance);
    }
  }
  EXPECT_GT(closest, 0.1);  // the bounds are not much too large
}

TEST(MicroMesh, VerticesAreRoundedPointsOfTheSurface) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Random random(seed * 104729);
    const random_micro::Structure s = random_micro::any_structure(random);
    const Subject subject(s.micro);
    if (subject.counts().tiles == 0 || subject.counts().tiles > 12) continue;
    const double size = random_micro::size_of(s.micro);
    const MicroMesh mesh = subject.mesh(size / 60).value();
    if (mesh.mesh.positions.size() > 3000) continue;
    std::vector<Vec3d> points;
    for (const MicroMeshParts& parts : mesh.parts) {
      const MicroGrid& grid = s.micro.grids[parts.grid];
      for (std::size_t cell = 0; cell < grid.tiles.size(); ++cell) {
        const auto at = grid.shape().index_of(cell);
        bool is_in_block = grid.tiles[cell] == parts.tile + 1;
        for (std::size_t a = 0; a < 3; ++a)
          is_in_block = is_in_block && parts.block[a][0] <= at[a] && at[a] < parts.block[a][1];
        if (!is_in_block) continue;
        const auto& patches = s.micro.tiles[parts.tile].patches;
        for (std::size_t p = 0; p < patches.size(); ++p) {
          const auto [m, n] = parts.of_patch[p];
          for (std::uint32_t i = 0; i <= m; ++i)
            for (std::uint32_t j = 0; j <= n; ++j)
              points.push_back(random_micro::nearest_point(random_micro::exact_point(
                  s.micro, grid, cell, patches[p], ratio(i, m), ratio(j, n))));
        }
      }
    }
    for (const Vec3d& vertex : mesh.mesh.positions) {
      double least = 1e300;
      for (const Vec3d& p : points)
        least = std::min(least, approx::length(approx::minus(p, vertex)));
      EXPECT_LE(least, mesh.rounding + 1e-15 * size) << "seed " << seed;
    }
    EXPECT_LE(mesh.rounding, 1e-13 * size);
  }
}

TEST(MicroMesh, IsTheSameForEveryNumberOfJobs) {
  Random random(5);
  JackShape shape;
  shape.range = {{kMaxWallNumber / 10, kMaxWallNumber / 5}};
  Microstructure micro =
      full(v_cells::grid(2, {2, 3, 2},
                         [](const v_cells::Point& p) {
                           return v_cells::Point{p[0] + p[1] * p[1] * ratio(1, 9), p[1],
                                                 p[2] + p[0] * ratio(1, 5)};
                         }),
           {3, 3, 3}, jack_tile(shape).value(), kMaxWallNumber / 8);
  for (MicroGrid& g : micro.grids)
    for (std::uint8_t& t : g.tiles) t = random.below(4) != 0;
  const Subject subject(micro);
  const MicroMesh one = subject.mesh(1e-2).value();
  for (const unsigned jobs : {2u, 5u}) {
    const MicroMesh more = subject.mesh(1e-2, jobs).value();
    EXPECT_EQ(one.mesh.faces, more.mesh.faces);
    ASSERT_EQ(one.mesh.positions.size(), more.mesh.positions.size());
    for (std::size_t v = 0; v < one.mesh.positions.size(); ++v) {
      EXPECT_EQ(one.mesh.positions[v].x, more.mesh.positions[v].x);
      EXPECT_EQ(one.mesh.positions[v].y, more.mesh.positions[v].y);
      EXPECT_EQ(one.mesh.positions[v].z, more.mesh.positions[v].z);
    }
    EXPECT_EQ(one.distance, more.distance);
    EXPECT_EQ(one.rounding, more.rounding);
  }
}

TEST(MicroMesh, RefusesWhatHasNoMesh) {
  Microstructure micro = full({cube(0, 0, 0)}, {2, 1, 1}, jack_tile(linear_jack()).value());
  const auto code = [](const Result<MicroMesh>& r) { return r ? "" : code_name(r.error().code); };
  {
    const Subject subject(micro);
    for (const double chord : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity(), 1e-15, 1e-300})
      EXPECT_STREQ(code(subject.mesh(chord)), "bad-argument") << chord;
    MicroMeshOptions options;
    options.chord = 1;
    options.max_facets = 2 * 48 + 2 * 10;
    EXPECT_TRUE(mesh_of(micro, subject.cage, subject.tiles, options).has_value());
    --options.max_facets;
    EXPECT_STREQ(code(mesh_of(micro, subject.cage, subject.tiles, options)), "over-limit");
  }
  micro.tiles.push_back(box_tile({0, 10, 10}, {40, 30, 30}));  // its cap overlaps that of the jack
  micro.grids[0].tiles[1] = 2;
  EXPECT_STREQ(code(Subject(micro).mesh(1)), "bad-argument");
  micro.grids[0].tiles = {0, 0};
  EXPECT_STREQ(code(Subject(micro).mesh(1)), "empty");
  // A structure that binary64 cannot hold.
  Microstructure huge =
      full({v_cells::box({Rational(0), Rational(0), Rational(0)},
                         {Rational::power_of_two(1025), Rational(1), Rational(1)})},
           {1, 1, 1}, jack_tile(linear_jack()).value());
  EXPECT_STREQ(code(Subject(huge).mesh(1)), "not-finite");
  // A bent cage with a tiny chord.
  const Microstructure ring = full({ring_cage()}, {1, 2, 1}, jack_tile(linear_jack()).value());
  MicroMeshOptions few;
  few.chord = 1e-7;
  few.max_facets = 1000000;
  const Subject subject(ring);
  EXPECT_STREQ(code(mesh_of(ring, subject.cage, subject.tiles, few)), "over-limit");
}

}  // namespace
}  // namespace veritope
