// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/micro_inside.h: asks prove_inside about a microstructure and a mesh that is decided on the
// way, or patches.
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "solids/micro/inside/micro_inside.h"
#include "solids/polyhedron/validity.h"
#include "topology/incidence.h"
#include "topology/surface.h"

namespace veritope::micro_inside {

using Answer = std::variant<InsideProof, InsideDefect>;

/// The mesh must outlive it.
inline InsideModel model_of(const TriangleMesh& mesh) {
  const ValidityReport report = decide_validity(mesh, {});
  EXPECT_TRUE(report.is_valid);
  const SurfaceTopology topology = analyse_surface(
      mesh.faces,
      Incidence::build(mesh.faces, static_cast<std::uint32_t>(mesh.positions.size()), 1), 0, 1);
  InsideModel out;
  out.mesh = &mesh;
  out.shells = {{topology.shell_of_face.data(), topology.shell_of_face.data() + mesh.faces.size()},
                report.nesting.depth};
  return out;
}

/// Bridges are not examined but for what prove_inside says of them. The model is an InsideModel, or a complex of
/// patches that bounds a solid.
template <typename Model>
Answer answer_for(const Microstructure& micro, const Model& model, unsigned jobs,
                  const InsideLimits& limits) {
  std::vector<AnalysedTile> tiles;
  for (const MicroTile& t : micro.tiles) tiles.push_back(std::get<AnalysedTile>(analyse_tile(t)));
  std::vector<CellPatch> first_patches;
  const auto counts = topology_of(micro, make_v_model(micro.cage, VOrientation::kAuto).value(),
                                  tiles, &first_patches);
  if (const auto* const defect = std::get_if<MicroDefect>(&counts)) {
    ADD_FAILURE() << defect->condition << ": " << defect->message;
    return InsideDefect{};
  }
  EXPECT_EQ(first_patches.size(), std::get<MicroCounts>(counts).shells);
  return prove_inside(micro, tiles, first_patches, model, jobs, limits);
}
inline Answer answer(const Microstructure& micro, const TriangleMesh& mesh, unsigned jobs = 1,
                     const InsideLimits& limits = {}) {
  return answer_for(micro, model_of(mesh), jobs, limits);
}
inline Answer answer(const Microstructure& micro, const PatchComplex& complex, unsigned jobs = 1,
                     const InsideLimits& limits = {}) {
  return answer_for(micro, complex, jobs, limits);
}

/// "" if it is inside, else the condition that is not proved.
inline std::string condition_of(const Answer& answer) {
  const auto* const defect = std::get_if<InsideDefect>(&answer);
  return defect == nullptr ? "" : defect->condition;
}

}  // namespace veritope::micro_inside
