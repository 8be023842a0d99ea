// SPDX-License-Identifier: LGPL-3.0-or-later
// Three boxes that satisfy C1, C2 and C3 of [SSP01] with the unit sphere, and hold the whole ball: Corollary 2.6 would
// have the empty set homeomorphic to a ball. With six slabs around [-4,4]^3 they refute Theorem 2.5, too. C3* fails, at
// the three boxes together. docs/THEORY.md §1.
#include <cstdio>
#include <string>
#include <vector>

#include "models/patch_shapes.h"
#include "models/plane_shapes.h"
#include "solids/interval_boxes/box_union.h"
#include "solids/interval_boxes/conditions.h"

using namespace veritope;

namespace {

std::vector<Box3d> three_boxes() {
  return {{{-1.5, -1.5, -1.5}, {0.1, 1.5, 1.5}},
          {{-0.1, -0.1, -1.5}, {1.5, 1.5, 1.5}},
          {{-0.1, -1.5, -1.5}, {1.5, 0.1, 1.5}}};
}

void report(const char* title, BoundaryModel model, const std::vector<Box3d>& boxes) {
  std::printf("%s\n", title);
  const PaperConditions all = decide_conditions(model, boxes).value();
  for (std::size_t c = 0; c < kNumPaperConditions; ++c) {
    const ConditionResult& r = all.results[c];
    std::printf("  %-3s %s\n", name_of(static_cast<PaperCondition>(c)), to_string(r.answer));
    for (const BoxOffence& o : r.offences) std::printf("        %s\n", to_string(o).c_str());
  }
  const auto topology = union_topology(boxes, model.dimension()).value();
  std::printf("  |B| has %zu body and %zu boundary surface(s)\n", topology.bodies,
              topology.boundary_euler.size());
}

BoundaryModel model_of(patch_shapes::Patches patches) {
  return BoundaryModel::make(make_patch_complex(std::move(patches)).value()).value();
}

}  // namespace

int main() {
  report("Corollary 2.6: the unit ball and b1, b2, b3", model_of(patch_shapes::octant_sphere()),
         three_boxes());
  std::vector<Box3d> nine = three_boxes();
  for (std::size_t k = 0; k < 3; ++k)
    for (const double at : {-4.0, 4.0}) {
      Box3d slab{{-4.5, -4.5, -4.5}, {4.5, 4.5, 4.5}};
      slab.lo[k] = at - 0.5, slab.hi[k] = at + 0.5;
      nine.push_back(slab);
    }
  report("Theorem 2.5: [-4,4]^3 without the open unit ball, and six slabs",
         model_of(patch_shapes::joined({patch_shapes::box({-4, -4, -4}, {4, 4, 4}),
                                        patch_shapes::reversed(patch_shapes::octant_sphere())})),
         nine);
  report("In the plane: the unit circle and the same rectangles",
         BoundaryModel::make_planar({plane_shapes::circle()}).value(), three_boxes());
}
