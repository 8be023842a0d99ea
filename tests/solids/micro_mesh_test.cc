// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/mesh/micro_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "solids/micro/micro_topology.h"
#include "solids/polyhedron/validity.h"
#include "tests/support/micro_cells.h"
#include "tests/support/random_microstructures.h"

namespace veritope {
namespace {

using micro_cells::box_tile;
using micro_cells::full;
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

TEST(MicroMesh, StraightArmsInAStraightCageAreNotCut) {
  const Microstructure micro = full({cube(0, 0, 0)}, {3, 2, 1}, jack_tile(linear_jack()).value());
  const Subject subject(micro);
  const MicroMesh mesh = subject.mesh(1e-9).value();
  EXPECT_LE(mesh.distance, 1e-15);
  for (const auto& p : mesh.parts.front().of_patch)
    EXPECT_EQ(p, (std::array<std::uint32_t, 2>{1, 1}));
  // 48 triangles of arms, 2 of each cap that is left.
  const std::size_t caps = 6 * 6 - 2 * (2 * 2 * 1 + 3 * 1 * 1);
  EXPECT_EQ(mesh.mesh.faces.size(), 6 * 48 + 2 * caps);
  expect_valid(subject, mesh, "block");
}

TEST(MicroMesh, RandomStructuresHaveValidMeshes) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    const random_micro::Structure s = random_micro::any_structure(random);
    const Subject subject(s.micro);
    if (subject.counts().tiles == 0) continue;
    for (const double part : {1.0 / 500, 1.0 / 2000}) {
      const double chord = random_micro::size_of(s.micro) * part;
      const auto mesh = subject.mesh(chord);
      ASSERT_TRUE(mesh.has_value()) << seed << ": " << mesh.error().message;
      EXPECT_LE(mesh->distance, chord);
      fprintf(stderr, "%d %s tiles %d facets %zu dist %g chord %g\n", (int)seed,
              s.description.c_str(), (int)subject.counts().tiles, mesh->mesh.faces.size(),
              mesh->distance, chord);
      expect_valid(subject, *mesh, "seed " + std::to_string(seed) + ": " + s.description);
    }
  }
}

}  // namespace
}  // namespace veritope
